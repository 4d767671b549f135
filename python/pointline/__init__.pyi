from os import PathLike
from typing import Any, Optional, Union

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

class Model:
    def __init__(self, source: Union[str, PathLike[str]]) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def claimed(self) -> Optional[int]: ...
    @property
    def sizes(self) -> tuple[int, int, int]: ...
    @property
    def at_least(self) -> Optional[int]: ...
    @property
    def at_most(self) -> Optional[int]: ...
    def degree(self) -> Optional[int]: ...
    def certificate(self) -> str: ...
    def template(self) -> str: ...
    def solver(self) -> ModelSolver: ...

class ModelAnswer:
    unknowns: dict[str, ndarray]
    real: ndarray
    residuals: ndarray
    lost: int
    def __len__(self) -> int: ...
    def real_values(self, name: str) -> ndarray: ...

class ModelSolver:
    @property
    def found(self) -> int: ...
    def solve(self, **data: Any) -> ModelAnswer: ...

class Estimate:
    R: ndarray
    t: ndarray
    points: ndarray
    line_points: ndarray
    line_directions: ndarray
    problem: str
    samples: int
    rms: float
    covariance: Optional[ndarray]
    @property
    def point_inliers(self) -> ndarray: ...
    @property
    def line_inliers(self) -> ndarray: ...

class Offer:
    problem: str
    degree: int
    milliseconds: float
    expected: float

class Problem:
    def __init__(self, text: Union[str, int]) -> None: ...
    @property
    def notation(self) -> str: ...
    @property
    def views(self) -> int: ...
    @property
    def calibrated(self) -> bool: ...
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
        self, problem: Union[Problem, str], start: Union[str, PathLike[str], None] = ...
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
def estimate_poses(
    points: Optional[ArrayLike] = ...,
    lines: Optional[ArrayLike] = ...,
    K: Optional[ArrayLike] = ...,
    incidences: ArrayLike = ...,
    distortion: Optional[ArrayLike] = ...,
    problem: Union[str, int] = ...,
    threshold: float = ...,
    confidence: float = ...,
    least_samples: int = ...,
    most_samples: int = ...,
    seed: int = ...,
    threads: int = ...,
    covariance: bool = ...,
) -> Estimate: ...
def offers(
    points: Optional[ArrayLike] = ...,
    lines: Optional[ArrayLike] = ...,
    K: Optional[ArrayLike] = ...,
    incidences: ArrayLike = ...,
    distortion: Optional[ArrayLike] = ...,
) -> list[Offer]: ...
