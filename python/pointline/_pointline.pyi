from typing import Any, Optional

from numpy import ndarray

class Problem:
    notation: str
    views: int
    verdict: str
    reasons: list[str]
    degree: Optional[int]
    picture: str
    points: list[bool]
    lines: list[str]

class Solver:
    degree: int
    def solve(
        self,
        points: ndarray,
        lines: ndarray,
        K: ndarray,
        quick: bool,
        conditions: bool,
        threads: int,
    ) -> dict[str, Any]: ...

def problem(text: str) -> Problem: ...
def make(problem: str, start: Optional[str]) -> Solver: ...
