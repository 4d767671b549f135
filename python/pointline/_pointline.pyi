from typing import Any, Optional

from numpy import ndarray

class Problem:
    notation: str
    views: int
    calibrated: bool
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

class Model:
    name: str
    claimed: Optional[int]
    data: int
    unknowns: int
    equations: int
    def __init__(self, text: str) -> None: ...
    def solutions(self) -> tuple[Optional[int], Optional[int]]: ...
    def certificate(self) -> str: ...
    def template(self) -> str: ...
    def solver(self) -> ModelSolver: ...

class ModelSolver:
    data: list[tuple[str, list[int]]]
    unknowns: list[tuple[str, list[int]]]
    found: int
    def solve(self, data: ndarray) -> tuple[ndarray, ndarray, ndarray, int]: ...

class Estimator:
    def __init__(self) -> None: ...
    def estimate(
        self,
        points: ndarray,
        lines: ndarray,
        incidences: ndarray,
        K: ndarray,
        distortions: ndarray,
        problem: str,
        threshold: float,
        confidence: float,
        least_samples: int,
        most_samples: int,
        seed: int,
        threads: int,
        covariance: bool,
    ) -> dict[str, Any]: ...

def offers(
    points: ndarray, lines: ndarray, incidences: ndarray, K: ndarray, distortions: ndarray
) -> list[tuple[str, int, float, float]]: ...
def problem(text: str) -> Problem: ...
def make(problem: str, start: Optional[str]) -> Solver: ...
