"""What this checker finds of a file."""

import classification
import degree_file
import general_file
import model_file
import problem_file
import solutions_file
from grammar import Fault, Parser, Refused, parse

KINDS = {"classification": classification, "problem": problem_file, "problems": general_file,
         "degrees": degree_file, "model": model_file, "solutions": solutions_file}


class OtherKind(Exception):
    """A kind of file that this checker does not read, or of record: one with approximate solutions."""


def verdict(data, every=1):
    """(the file, its records that hold, why each other one is refused), of one of each `every`
    records. None for the file if it does not conform: then nothing holds, and one reason says why."""
    try:
        parser = Parser(data)
        if parser.words[:3] == ["plcert", "2", "at-most"]:
            raise OtherKind("at-most")
        node = parse(parser)
        if any(record["solution"] for record in node["degree"]) or \
                any(record["general-solution"] for record in node["solutions-record"]):
            raise OtherKind(node["words"][2])
        file = KINDS[node["words"][2]].File(node)
    except Fault as fault:
        return None, [], [str(fault)]
    held, refused = [], []
    for number, record in enumerate(file.records[::every]):
        try:
            file.check(record)
            held.append(record)
        except Refused as why:
            refused.append(f"record {number * every + 1}: {why}")
    return file, held, refused
