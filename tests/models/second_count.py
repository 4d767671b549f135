"""Macaulay2 counts the zeros of all models: a second method for how many solutions they have.

Usage: second_count.py PLPROVE FOLDER_OF_MODELS docs/models.md

For each row of the table in docs/models.md, compares what Macaulay2 finds over a finite field, for
random data, with the column "at least". Prints each model, and the ones that differ at the end; the
status is 1 if some do. Models with too many solutions for Macaulay2 are left out.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

# How many zeros are one solution, by the `count` statement of the model.
ZEROS_OF_ONE_SOLUTION = {
    "bitangents": 2,
    "five_points": 2,
    "p35pf": 2,
    "p4p_focal_distortion": 4,
    "planar_p4p_focal_distortion": 8,
    "seven_points_focal_distortion": 4,
    "six_points_distortion": 2,
    "six_points_focal": 4,
    "six_points_one_distortion": 2,
    "six_points_one_focal": 4,
}

# These take too long.
TOO_MANY = {"rig_four_points", "three_generalised_views"}


def solutions_in_table(page):
    """The column "at least", by model."""
    rows = re.findall(r"^\| \[(\w+)\]\(\S+\) \|[^|]*\|[^|]*\| (\d+) \|", page.read_text(), re.M)
    return {name: int(number) for name, number in rows}


def zeros(plprove, model, folder):
    script = folder / "model.m2"
    subprocess.run([plprove, "model", str(model), "--macaulay2", "-o", str(script)], check=True)
    answer = subprocess.run(["M2", "--script", str(script)], capture_output=True, text=True)
    found = re.search(r"^dimension  0\nsolutions  (\d+)\n\Z", answer.stdout, re.M)
    return int(found[1]) if found else None


def main():
    plprove, models, page = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    expected = solutions_in_table(page)
    files = sorted(model for model in models.glob("*.model") if model.stem not in TOO_MANY)
    wrong = [model.stem for model in files if model.stem not in expected]
    with tempfile.TemporaryDirectory() as folder:
        for model in files:
            found = zeros(plprove, model, pathlib.Path(folder))
            factor = ZEROS_OF_ONE_SOLUTION.get(model.stem, 1)
            wanted = expected.get(model.stem, 0)
            print(f"{model.stem}: {found} zeros, {wanted} solutions of {factor} zeros", flush=True)
            if found != factor * wanted:
                wrong.append(model.stem)
    print(f"{len(files)} models, {len(wrong)} of them differ: {', '.join(wrong) or 'none'}")
    sys.exit(1 if wrong or not files else 0)


main()
