"""Cameras from images of points and lines: all solutions of minimal problems.

    import pointline

    chicago = pointline.problem("Chicago")  # 2*Pa/Pa/Pa + P/P/P
    solver = chicago.solver()
    answer = solver.solve(points=points, lines=lines, K=K)
    for R, t in zip(answer.R, answer.t):
        ...

A view sees the point X of space at K (R X + t). Images are in pixels, or in normalised coordinates
where no K is given. The distance from camera 1 to camera 2 is the unit of length in space.
docs/python.md of the project says more.
"""

import operator
import os
import warnings
from dataclasses import dataclass

import numpy as np

from . import _pointline

__all__ = ["Answer", "Problem", "Solver", "problem"]


@dataclass(frozen=True)
class Answer:
    """The real solutions, those with most points in front of the cameras first.

    With n solutions, V views, F features and L lines:
    """

    R: np.ndarray  #: (n, V, 3, 3); camera 1 is the identity
    t: np.ndarray  #: (n, V, 3); the distance from camera 1 to camera 2 is 1
    points: np.ndarray  #: (n, F, 3); nan where the images leave the point open
    line_points: np.ndarray  #: (n, L, 3): a point of each line
    line_directions: np.ndarray  #: (n, L, 3)
    in_front: np.ndarray  #: (n,): how many points are in front of all cameras that see them
    residuals: np.ndarray  #: (n,): pixels; about 0 for each, so no way to choose among them
    conditions: np.ndarray  #: (n,): 0 unless asked for
    degree: int  #: how many complex solutions generic images have, as far as is known
    found: int  #: how many were found
    complete: str  #: why these are all: "certified" or "unknown"
    moved: float  #: pixels that something was moved at most to make lines meet their points

    def __len__(self):
        return len(self.R)

    def __repr__(self):
        return f"Answer({len(self)} real of {self.found} found of {self.degree}, {self.complete})"


class Problem:
    """A problem, as `problem` decides it."""

    def __init__(self, text):
        self._content = _pointline.problem(str(text))

    @property
    def notation(self):
        """The problem as a sum of features."""
        return self._content.notation

    @property
    def views(self):
        """Two or three."""
        return self._content.views

    @property
    def verdict(self):
        """"minimal", "camera-minimal", or why it is neither."""
        return self._content.verdict

    @property
    def reasons(self):
        """Sentences that give the reason for the verdict."""
        return list(self._content.reasons)

    @property
    def degree(self):
        """How many complex solutions it has, or None where that is not known."""
        return self._content.degree

    @property
    def picture(self):
        """A drawing of what the views see, as SVG. Notebooks show it."""
        return self._content.picture

    def _repr_svg_(self):
        return self.picture

    def __repr__(self):
        return f"pointline.problem({self.notation!r})"

    def solver(self, start=None):
        """A solver; `start` is a file that `plprove start` wrote, or None for the cache.

        In three views the first solver of a problem makes its start, which may take a while.
        Raises ValueError where the problem is neither minimal nor camera-minimal.
        """
        return Solver(self, start)


def problem(text):
    """Reads and decides a problem: notation, a name, or the authors' number. Raises ValueError."""
    return Problem(text)


class Solver:
    """Solves one problem for any number of images, in several threads if you like."""

    def __init__(self, problem, start=None):
        self.problem = problem
        path = None if start is None else os.fspath(start)
        if path is not None and "\0" in path:
            raise ValueError("start has a zero character: give the path of a file")
        self._content = _pointline.make(problem.notation, path)

    @property
    def degree(self):
        """How many complex solutions there are."""
        return self._content.degree

    def solve(self, points=None, lines=None, K=None, quick=False, conditions=False, threads=1):
        """The real solutions for these images, as an Answer.

        points: (F, V, 2), pixels: what the V views see of the F features, in the order of the
            notation; nan where a view sees no point. May be left out where the problem has no points.
        lines: (L, V, 2, 2), two points each, in pixels; or (L, V, 3), the coefficients a, b, c of
            a x + b y + c = 0. L counts the lines of all features, in the order of the notation;
            nan where a view does not see the line. May be left out where the problem has no lines.
        K: (3, 3) or (V, 3, 3), in pixels, without skew; or None, and points and lines are in
            normalised coordinates: K^-1 times pixels. Warns where these look like pixels.
        quick: let lost paths go, which is faster; hardly a real solution is lost.
        conditions: also estimate the conditions: radians of the cameras a radian of the images.
        threads: how many threads share the work, 1 to 1024; the answer does not depend on it.

        Raises ValueError where the images are not what the problem says that the views see.
        """
        threads = operator.index(threads)
        if not 1 <= threads <= 1024:
            raise ValueError(f"threads is {threads}: give 1 to 1024")
        content, views = self.problem._content, self.problem.views
        features, count = len(content.points), sum(map(len, content.lines))
        if points is None:
            points = np.full((features, views, 2), np.nan)
        if lines is None:
            lines = np.full((count, views, 3), np.nan)
        points, lines = _reals(points, "points"), _reals(lines, "lines")
        if K is None and _look_like_pixels(points, lines):
            warnings.warn(
                "points or lines look like pixels, and without K they count as normalised "
                "coordinates: give K",
                stacklevel=2,
            )
        found = self._content.solve(
            points, lines, _intrinsics(K, views), bool(quick), bool(conditions), threads
        )
        return Answer(**found)


def _reals(values, name):
    values = np.asarray(values)
    if np.iscomplexobj(values):
        raise ValueError(f"{name} has complex numbers: give real ones")
    return values.astype(float)


def _look_like_pixels(points, lines):
    """Whether something is seen so far from the centre as no camera sees it."""
    sizes = [np.abs(points)]
    if lines.ndim == 3 and lines.shape[2] == 3:
        with np.errstate(divide="ignore", invalid="ignore"):
            sizes.append(np.abs(lines[..., 2]) / np.hypot(lines[..., 0], lines[..., 1]))
    else:
        sizes.append(np.abs(lines))
    return any(np.any(size[np.isfinite(size)] > 10) for size in sizes)


def _intrinsics(K, views):
    """fx, fy, cx, cy of each view."""
    K = np.eye(3) if K is None else _reals(K, "K")
    if K.shape not in [(3, 3), (views, 3, 3)]:
        raise ValueError(f"K has the shape {K.shape}: give (3, 3) or ({views}, 3, 3)")
    K = np.broadcast_to(K, (views, 3, 3))
    lower = [K[:, 1, 0], K[:, 2, 0], K[:, 2, 1], K[:, 0, 1], K[:, 2, 2] - 1]
    if np.any(lower):
        raise ValueError("K must be [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]")
    return np.stack([K[:, 0, 0], K[:, 1, 1], K[:, 0, 2], K[:, 1, 2]], axis=1)
