"""Section 5: bytes, lines and words; a reader that takes a file apart line by line.

A failure is of the file (Fault: nothing in it counts) or of a record (Refused: the others stand).
"""

import re

Q = 2**61 - 1
INTEGER = re.compile(r"0|-?[1-9][0-9]*")


class Fault(Exception):
    """The file does not conform."""


class Refused(Exception):
    """The record proves nothing."""


def require(condition, what):
    if not condition:
        raise Refused(what)


def logical_lines(data):
    """The lines of a file, continued ones joined, comments left out: [(line number, [word])]."""
    if len(data) > 64 * 2**20 or not data.endswith(b"\n"):
        raise Fault("more than 64 MiB, or no LF at the end")
    found, pending = [], None
    for number, raw in enumerate(data[:-1].split(b"\n"), 1):
        if len(raw) > 16384 or any(byte < 32 or byte > 126 for byte in raw):
            raise Fault(f"line {number}: its length, or a byte")
        comment, words = raw.startswith(b"#") and number > 1, raw.decode().split(" ")
        if comment and not pending:
            continue
        if comment or "" in words or words == ["\\"]:
            raise Fault(f"line {number}: spaces, an empty line, a comment or a backslash alone")
        pending = (pending[0], pending[1] + words) if pending else (number, words)
        if words[-1] == "\\":
            pending[1].pop()
        else:
            found.append(pending)
            pending = None
    if pending:
        raise Fault("the last line goes on")
    return found


class Reader:
    """A cursor in the words of a file."""

    def __init__(self, data, kind):
        self.lines, self.at, self.word_at = logical_lines(data), 0, 0
        self.line(f"plcert 2 {kind}")

    def ended(self):
        return self.at >= len(self.lines)

    def next_is(self, *choices):
        """Whether the next word, of this line or the first of the next, is one of these."""
        return not self.ended() and self.more() and self.lines[self.at][1][self.word_at] in choices

    def more(self):
        return self.word_at < len(self.lines[self.at][1])

    def word(self, *choices):
        """The next word; one of the choices, if there are any."""
        if self.ended() or not self.more() or choices and not self.next_is(*choices):
            raise Fault(f"logical line {self.at + 1}: expected {choices or 'another word'}")
        self.word_at += 1
        return self.lines[self.at][1][self.word_at - 1]

    def integer(self, low, high):
        word = self.word()
        if not INTEGER.fullmatch(word) or len(word) > 1001 or not low <= int(word) <= high:
            raise Fault(f"logical line {self.at + 1}: {word} is not from {low} to {high}")
        return int(word)

    def take(self, *pattern):
        """Words to the letter, numbers of coordinates, and (from, to) of one integer."""
        found = []
        for item in pattern:
            if isinstance(item, str):
                for word in item.split():
                    self.word(word)
            elif isinstance(item, int):
                found.append([self.integer(-999999, 999999) for _ in range(item)])
            else:
                found.append(self.integer(*item))
        return found

    def line(self, *pattern):
        """What `take` takes, and then the line ends."""
        found = self.take(*pattern)
        if self.ended() or self.more():
            raise Fault(f"logical line {self.at + 1}: expected its end")
        self.at, self.word_at = self.at + 1, 0
        return found

    def ascending(self, high=999999, least=1, most=None):
        """Integers from 1 to high that ascend strictly, as long as numbers follow."""
        found = []
        while self.more() and INTEGER.fullmatch(self.lines[self.at][1][self.word_at]):
            found.append(self.integer(found[-1] + 1 if found else 1, high))
        if len(found) < least or most and len(found) > most:
            raise Fault(f"logical line {self.at + 1}: how many numbers")
        return found

    def rest(self):
        """What is left of the line, as text."""
        words = [self.word()]
        while self.more():
            words.append(self.word())
        self.line()
        return " ".join(words)


MODULUS, MINOR = f"modulus {Q}", (1, Q - 1)
