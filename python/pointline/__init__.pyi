from os import PathLike
from typing import Optional, Union

from numpy import ndarray
from numpy.typing import ArrayLike

class Answer:
    R: ndarray
    t: ndarray
    points: ndarray
    line_points: ndarray
    line_directions: ndarray
    in_front: ndarray
    residuals: ndarray
    conditions: ndarray
    degree: int
    found: int
    complete: str
    moved: float
    def __len__(self) -> int: ...

class Problem:
    def __init__(self, text: Union[str, int]) -> None: ...
    @property
    def notation(self) -> str: ...
    @property
    def views(self) -> int: ...
    @property
    def verdict(self) -> str: ...
    @property
    def reasons(self) -> list[str]: ...
    @property
    def degree(self) -> Optional[int]: ...
    @property
    def picture(self) -> str: ...
    def solver(self, start: Union[str, PathLike[str], None] = ...) -> Solver: ...

class Solver:
    problem: Problem
    def __init__(
        self, problem: Problem, start: Union[str, PathLike[str], None] = ...
    ) -> None: ...
    @property
    def degree(self) -> int: ...
    def solve(
        self,
        points: Optional[ArrayLike] = ...,
        lines: Optional[ArrayLike] = ...,
        K: Optional[ArrayLike] = ...,
        quick: bool = ...,
        conditions: bool = ...,
        threads: int = ...,
    ) -> Answer: ...

def problem(text: Union[str, int]) -> Problem: ...
