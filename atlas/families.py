"""Writes the problems of a family as JSON, for the page of two more papers:
python3 atlas/families.py build/bin/plprove plmp|projective

Of each problem it has what `plprove list --family` says. The degree of a problem of calibrated
cameras is the one on its page: what `plprove problem` says.
"""

import csv
import io
import json
import subprocess
import sys


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def degree_on_file(row):
    """The degree in a line of the list; None if none is on file."""
    if not row["degree"]:
        return None
    *least, status = row["degree_status"].split(": ")
    bound = "at-least" if least else "exact"
    return {"value": int(row["degree"]), "bound": bound, "status": status}


def degree_on_page(plprove, row):
    """The degree that the page of a problem shows; None if it shows none."""
    report = json.loads(output_of(plprove, "problem", row["notation"], "--json"))
    degree = report.get("degree")
    return degree and {key: degree[key] for key in ("value", "bound", "status")}


def member_of(plprove, row, family):
    return {
        "name": row["name"],
        "notation": row["notation"],
        "views": int(row["views"]),
        "minimal": row["minimal"] == "1",
        "reason": row["reason"],
        "degree": degree_on_page(plprove, row) if family == "plmp" else degree_on_file(row),
    }


def main(plprove, family):
    lines = output_of(plprove, "list", "--family", family, "--format", "csv")
    members = [member_of(plprove, row, family) for row in csv.DictReader(io.StringIO(lines))]
    json.dump(members, sys.stdout)


main(*sys.argv[1:])
