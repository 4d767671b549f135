"""Writes the problems of a family as JSON, for the page of families:
python3 atlas/families.py build/bin/plprove FAMILY

Of each problem it has what `plprove list --family` says.
"""

import csv
import io
import json
import subprocess
import sys


def degree_of(row):
    """The degree in a line of the list; None if none is on file."""
    if not row["degree"]:
        return None
    *least, status = row["degree_status"].split(": ")
    bound = "at-least" if least else "exact"
    return {"value": int(row["degree"]), "bound": bound, "status": status}


def group_of(row):
    """The group in a line of the list; None if none is on file."""
    if not row["group"]:
        return None
    return {"name": row["group"], "status": row["group_status"]}


def member_of(row):
    return {
        "name": row["name"],
        "notation": row["notation"],
        "views": int(row["views"]),
        "minimal": row["minimal"] == "1",
        "reason": row["reason"],
        "degree": degree_of(row),
        "group": group_of(row),
    }


def main(plprove, family):
    command = [plprove, "list", "--family", family, "--format", "csv"]
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    json.dump([member_of(row) for row in csv.DictReader(io.StringIO(lines))], sys.stdout)


main(*sys.argv[1:])
