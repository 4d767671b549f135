"""The published schemas hold for what `plprove solve` reads and writes, and refuse what is wrong.

Usage: solve_schema.py PLPROVE FOLDER_OF_SCHEMAS
"""

import copy
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import jsonschema


def validator(path):
    schema = json.loads(path.read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    return jsonschema.Draft7Validator(schema)


def require(condition, message):
    if not condition:
        sys.exit(message)


def solve(plprove, problem, images, folder):
    file = folder / "images.json"
    file.write_text(json.dumps(images))
    return subprocess.run(
        [plprove, "solve", problem, str(file), "--json"], capture_output=True, text=True
    )


def wrong_images(images):
    """Edits of good images that the schema and the program refuse alike."""

    def edited(edit):
        result = copy.deepcopy(images)
        edit(result)
        return result

    def first(result):
        return result["features"][0]["views"][0]

    yield edited(lambda r: r.update(more=1))
    yield edited(lambda r: r.pop("features"))
    yield edited(lambda r: r["cameras"][0].pop("fx"))
    yield edited(lambda r: first(r).update(point=[1]))
    yield edited(lambda r: first(r).update(point=["x", 1]))
    yield edited(lambda r: first(r).update(point=["1/2/3", 1]))
    yield edited(lambda r: first(r)["lines"].update(A=[1, 2, 3]))
    yield edited(lambda r: first(r)["lines"].update(a=[1, 2, 3, 4]))
    yield edited(lambda r: r["features"][0].update(name=[]))
    yield edited(lambda r: r["features"][0]["views"].extend([None] * 10))


def main():
    plprove, schemas = sys.argv[1], pathlib.Path(sys.argv[2])
    images_schema = validator(schemas / "images.json")
    answer_schema = validator(schemas / "answer.json")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        os.environ["XDG_CACHE_HOME"] = name
        for problem in [
            "Chicago",
            "five-point",
            "Pabcde/Pabcde/Pabcde + P/P/P + a/a/- + P/-/-",
            "3*PL/PL/PL/PL + a/a/a/a",
            "projective: 7*P/P",
        ]:
            example = subprocess.run(
                [plprove, "solve", "--example", problem], capture_output=True, check=True
            )
            images = json.loads(example.stdout)
            images_schema.validate(images)
            outcome = solve(plprove, images["problem"], images, folder)
            require(outcome.returncode == 0, outcome.stderr)
            answer = json.loads(outcome.stdout)
            answer_schema.validate(answer)
            require(answer["found"] == len(answer["solutions"]) > 0, "no solutions")
            for edit in [{"found": -1}, {"complete": "yes"}, {"solutions": [{}]}]:
                require(not answer_schema.is_valid({**answer, **edit}), f"valid with {edit}")
        chicago = json.loads(
            subprocess.run([plprove, "solve", "--example", "Chicago"], capture_output=True).stdout
        )
        count = 0
        for wrong in wrong_images(chicago):
            count += 1
            require(not images_schema.is_valid(wrong), f"valid: {wrong}")
            outcome = solve(plprove, "2394", wrong, folder)
            require(outcome.returncode == 2 and not outcome.stdout, f"solved: {wrong}")
        require(count == 10, "too few edits")


main()
