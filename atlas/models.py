"""Writes the models as JSON, for the page of models:
python3 atlas/models.py build/bin/plcheck FOLDER_OF_MODELS CERTIFICATE...

Of each model it has its text, and what plcheck certifies in this run.
"""

import json
import pathlib
import subprocess
import sys


def comment_of(text):
    """The comments before the first statement: the title, and the rest with its line breaks gone."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        lines.append(line[1:].strip())
    return lines[0], " ".join(lines[1:])


def model_of(file, folder):
    text = (folder / f"{file['model']}.model").read_text()
    title, source = comment_of(text)
    return {
        "name": file["model"],
        "title": title,
        "source": source,
        "text": text,
        "claimed": file["claimed"],
        "at_least": file["certified_at_least"],
        "at_most": file["certified_at_most"],
    }


def main(plcheck, folder, *certificates):
    report = subprocess.run([plcheck, "--json", *certificates], check=True, capture_output=True)
    files = json.loads(report.stdout)["files"]
    models = [model_of(file, pathlib.Path(folder)) for file in files]
    json.dump(sorted(models, key=lambda model: model["name"]), sys.stdout)


main(*sys.argv[1:])
