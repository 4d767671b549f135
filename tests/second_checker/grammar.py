"""Section 5: bytes, lines and words; and the grammar of FORMAT.md, read from the page and applied.

A failure is of the file (Fault: nothing in it counts) or of a record (Refused: the others stand).
"""

import pathlib
import re

PAGE = pathlib.Path(__file__).resolve().parents[2] / "certs" / "FORMAT.md"
Q = 2**61 - 1
END = "\n"  # among the words of a file: the end of a line
INTEGER = re.compile(r"0|-?[1-9][0-9]*")
COUNTED = (0, 999999)
NUMBERED = (1, 999999)
LIMITS = {"INT": (-999999, 999999), "ENTRY": (1 - 10**1000, 10**1000 - 1), "MINOR": (1, Q - 1),
          "NUMBER": COUNTED, "POOL": COUNTED, "RANK": COUNTED, "EXCESS": COUNTED, "STAR": COUNTED,
          "ROW": NUMBERED, "COLUMN": (1, 11), "OWN": NUMBERED, "POSITION": (1, 1000), "K": NUMBERED,
          "DEGREE": (1, 6), "EQUATION": NUMBERED, "MONOMIAL": NUMBERED, "CONDITIONS": NUMBERED,
          "RESIDUE": (0, Q - 1), "COUNT": NUMBERED, "CONSTANT": COUNTED, "SIZE": (1, 100),
          "POWER": (1, 20), "LONG": (1 - 10**18, 10**18 - 1), "IMAGE": (1 - 10**9, 10**9 - 1),
          "BITS": (0, 200), "EDGES": (0, 99), "EXPONENT": (-99, -1),
          "POINT": NUMBERED, "JOINED": NUMBERED, "LINE": NUMBERED, "VIEW": NUMBERED}
ASCENDING = ("ROW", "COLUMN", "OWN", "MONOMIAL", "POINT", "LINE", "VIEW")
NAME = re.compile("[A-Za-z][A-Za-z0-9_]{0,39}")
CLOSING = {"{": "}", "[": "]", "(": ")"}


class Fault(Exception):
    """The file does not conform."""


class Refused(Exception):
    """The record proves nothing."""


def require(condition, what):
    if not condition:
        raise Refused(what)


def words_of(data):
    """The words of a file, and END after each line: continued lines joined, comments left out."""
    if len(data) > 64 * 2**20 or not data.endswith(b"\n"):
        raise Fault("more than 64 MiB, or no LF at the end")
    found, goes_on = [], False
    for number, raw in enumerate(data[:-1].split(b"\n"), 1):
        if len(raw) > 16384 or any(byte < 32 or byte > 126 for byte in raw):
            raise Fault(f"line {number}: its length, or a byte")
        comment, words = raw.startswith(b"#") and number > 1, raw.decode().split(" ")
        if comment and not goes_on:
            continue
        if comment or "" in words or words == ["\\"]:
            raise Fault(f"line {number}: spaces, an empty line, a comment or a backslash alone")
        goes_on = words[-1] == "\\"
        found += words[:-1] if goes_on else [*words, END]
    if goes_on:
        raise Fault("the last line goes on")
    return found


def choices_of(tokens):
    """The alternatives of an expression up to a closing bracket, each a list of items: a bracket and
    its alternatives; `word` and words to the letter; or a name, and how many of it, None for all in the
    line."""
    found = [[]]
    while tokens and tokens[0] not in CLOSING.values():
        token = tokens.pop(0)
        if token == "|":
            found.append([])
        elif token == ";":
            found[-1].append(("word", [END]))
        elif token.startswith('"'):
            found[-1].append(("word", token.strip('"').split()))
        elif token in CLOSING:
            found[-1].append((token, choices_of(tokens)))
            tokens.pop(0)
        else:
            count, _, name = token.rpartition("*")
            found[-1].append((name, int(count) if count.isdigit() else None if count else 1))
    return found


def rules_of_page():
    """{name: alternatives} of the code blocks of the page that begin with `name = `."""
    texts, name = {}, None
    for block in re.findall(r"^```\n([a-z-]+ += .*?)^```", PAGE.read_text(), re.M | re.S):
        for line in block.splitlines():
            if head := re.match(r"([a-z-]+) += (.*)", line):
                name, line = head.groups()
                assert name not in texts, f"two rules for {name}"
            remark = re.search(r"(?<=\S)\s{3,}.*", line)
            texts[name] = texts.get(name, "") + " " + line.removesuffix(remark[0] if remark else "")
    return {name: choices_of(re.findall(r'"[^"]*"|[\w*-]+|[^\s"\w]', text))
            for name, text in texts.items()}


RULES = rules_of_page()


class Node(dict):
    """What a rule took: for each name in it a list, of integers, words or nodes; and the words to the
    letter, as `words`."""

    def __missing__(self, name):
        return self.setdefault(name, [])


class Parser:
    """A place in the words of a file. The first word tells the alternatives of a rule apart, or the
    first two."""

    def __init__(self, data):
        self.words, self.at = words_of(data), 0

    def starts(self, kind, content):
        """Whether this item comes next."""
        if kind == "word":
            return self.words[self.at:self.at + len(content)] == content
        if kind in CLOSING or kind in RULES:
            return any(self.begins(choice) for choice in RULES.get(kind, content))
        if self.at == len(self.words) or self.words[self.at] == END:
            return False
        if kind == "NAME":
            return bool(NAME.fullmatch(self.words[self.at]))
        return kind not in LIMITS or bool(INTEGER.fullmatch(self.words[self.at])) or \
            kind == "NUMBER" and self.words[self.at] == "-"

    def begins(self, choice):
        """Whether this alternative comes next."""
        for (kind, content), after in zip(choice, [*choice[1:], ("", None)]):
            if self.starts(kind, content):
                due = after[1] if kind == "NAME" and after[0] == "word" else []
                return self.words[self.at + 1:self.at + 1 + len(due)] == due
            if kind not in "[{":
                return False
        return False

    def choose(self, choices, node):
        for choice in choices:
            if len(choices) == 1 or self.begins(choice):
                for item in choice:
                    self.take(node, *item)
                return node
        raise Fault(f"word {self.at + 1} is {self.words[self.at:self.at + 1]}, not {choices}")

    def take(self, node, kind, content):
        if kind == "{":
            while self.starts(kind, content):
                self.choose(content, node)
        elif kind == "(" or kind == "[" and self.starts(kind, content):
            self.choose(content, node)
        elif kind in RULES:
            node[kind].append(self.choose(RULES[kind], Node()))
        elif kind == "word":
            if not self.starts(kind, content):
                raise Fault(f"word {self.at + 1} is {self.words[self.at:self.at + 1]}, not {content}")
            node["words"] += [word for word in content if word != END]
            self.at += len(content)
        elif kind != "[":
            for _ in range(self.words.index(END, self.at) - self.at if content is None else content):
                node[kind].append(self.value(kind, node[kind]))

    def value(self, name, before):
        """The next word, or what is left of the line, or an integer."""
        if not self.starts(name, 1):
            raise Fault(f"word {self.at + 1} is {self.words[self.at:self.at + 1]}, no {name}")
        start, self.at = self.at, self.at + 1
        if name in ("NOTATION", "GENERAL"):
            self.at = self.words.index(END, start)
            return " ".join(self.words[start:self.at])
        word = self.words[start]
        if name not in LIMITS or word == "-":
            return word
        low, high = LIMITS[name]
        if len(word) > 1001 or not low <= int(word) <= high or \
                name in ASCENDING and before and before[-1] >= int(word):
            raise Fault(f"word {start + 1} is {word}: {name} is from {low} to {high}, or ascends")
        return int(word)


def parse(parser):
    """The Node of a file, from its first word to its last."""
    node = parser.choose(RULES["file"], Node())
    if parser.at < len(parser.words):
        raise Fault(f"word {parser.at + 1} is {parser.words[parser.at]}: more than the kind of file has")
    return node


def chunks(numbers, size):
    """The numbers in lists of this size."""
    return [numbers[i:i + size] for i in range(0, len(numbers), size)]
