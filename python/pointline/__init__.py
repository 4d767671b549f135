"""Cameras from images of points and lines: all solutions of minimal problems.

    import pointline

    chicago = pointline.problem("Chicago")  # 2*Pa/Pa/Pa + P/P/P
    solver = chicago.solver()
    answer = solver.solve(points=points, lines=lines, K=K)
    for R, t in zip(answer.R, answer.t):
        ...

Many matches, some of them wrong: `pointline.estimate_poses`.

A view sees the point X of space at K (R X + t). Images are in pixels, or in normalised coordinates
where no K is given. The distance from camera 1 to camera 2 is the unit of length in space.
docs/python.md of the project says more.
"""

import operator
import os
import warnings
from dataclasses import dataclass
from typing import Optional

import numpy as np

from . import _pointline

__all__ = ["Answer", "Estimate", "Model", "ModelAnswer", "ModelSolver", "Offer", "Problem", "Solver", "estimate_poses", "offers", "problem"]


@dataclass(frozen=True)
class Answer:
    """The real solutions, those with most points in front of the cameras first.

    With n solutions, V views, F features and L lines:
    """

    #: (n, V, 3, 3); camera 1 is the identity. Uncalibrated cameras are the matrices [R | t], up to a
    #: factor, and R is any matrix: they take points to pixels
    R: np.ndarray
    t: np.ndarray  #: (n, V, 3); the distance from camera 1 to camera 2 is 1
    points: np.ndarray  #: (n, F, 3); nan where the images leave the point open
    line_points: np.ndarray  #: (n, L, 3): a point of each line
    line_directions: np.ndarray  #: (n, L, 3)
    in_front: np.ndarray  #: (n,): how many points are in front of all cameras that see them
    residuals: np.ndarray  #: (n,): pixels; about 0 for each, so no way to choose among them
    conditions: np.ndarray  #: (n,): 0 unless asked for
    degree: int  #: how many complex solutions generic images have, as far as is known
    found: int  #: how many were found
    #: why these are all: their number is the degree, which is "certified" or known by "evidence"; or
    #: "unknown"
    complete: str
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
        """How many."""
        return self._content.views

    @property
    def calibrated(self):
        """Whether the cameras are calibrated."""
        return self._content.calibrated

    @property
    def verdict(self):
        """"minimal", "camera-minimal", or why it is neither. With lines through several points, more than
        three views or uncalibrated cameras "minimal", "not minimal", "unbalanced", or "open" where that
        is not known."""
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

        In three views the first solver of a problem makes its start, which may take a while. With
        lines through several points, more than three views or uncalibrated cameras each solver makes
        one: seconds for 1,000 solutions. Raises ValueError where the problem is neither minimal nor
        camera-minimal, or its degree is not known.
        """
        return Solver(self, start)


def problem(text):
    """Reads and decides a problem: notation, a name, or the authors' number. Raises ValueError."""
    return Problem(text)


class Solver:
    """Solves one problem for any number of images, in several threads if you like.

    problem: a Problem, or its notation, name or number; start: see Problem.solver.
    """

    def __init__(self, problem, start=None):
        self.problem = problem if isinstance(problem, Problem) else Problem(problem)
        path = None if start is None else os.fspath(start)
        if path is not None and "\0" in path:
            raise ValueError("start has a zero character: give the path of a file")
        self._content = _pointline.make(self.problem.notation, path)

    @property
    def degree(self):
        """How many complex solutions there are."""
        return self._content.degree

    def solve(self, points=None, lines=None, K=None, quick=False, conditions=False, threads=1):
        """The real solutions for these images, as an Answer.

        points: (F, V, 2), pixels: what the V views see of the F features, in the order of the
            notation; nan where a view sees no point. May be left out where the problem has no points.
        lines: (L, V, 2, 2), two points each, in pixels; or (L, V, 3), the coefficients a, b, c of
            a x + b y + c = 0. L counts the lines of all features, in the order of the notation,
            without those through several points, which these show; nan where a view does not see
            the line. May be left out where the problem has no such lines.
        K: (3, 3) or (V, 3, 3), in pixels, without skew; or None, and points and lines are in
            normalised coordinates: K^-1 times pixels. Warns where these look like pixels. None for
            uncalibrated cameras: then all is in pixels.
        quick: let lost paths go, which is faster; hardly a real solution is lost.
        conditions: also estimate the conditions: radians of the cameras a radian of the images.
            Both are for two or three calibrated views and lines with at most one point.
        threads: how many threads share the work, 1 to 1024; the answer does not depend on it.

        Raises ValueError where the images are not what the problem says that the views see.
        """
        threads = _threads(threads)
        content, views = self.problem._content, self.problem.views
        features, count = len(content.points), sum(map(len, content.lines))
        if points is None:
            points = np.full((features, views, 2), np.nan)
        if lines is None:
            lines = np.full((count, views, 3), np.nan)
        points, lines = _reals(points, "points"), _reals(lines, "lines")
        if self.problem.calibrated and K is None and _look_like_pixels(points, lines):
            warnings.warn(
                "points or lines look like pixels, and without K they count as normalised "
                "coordinates: give K",
                stacklevel=2,
            )
        found = self._content.solve(
            points, lines, _intrinsics(K, views), bool(quick), bool(conditions), threads
        )
        return Answer(**found)


class Model:
    """A problem that is given by equations: how many solutions it has, and a solver."""

    def __init__(self, source):
        """`source` is the text of a model, or the path of a file with one. Raises ValueError."""
        if isinstance(source, os.PathLike) or "\n" not in source:
            with open(source, encoding="utf-8") as file:
                source = file.read()
        self._content = _pointline.Model(source)

    def __repr__(self):
        data, unknowns, equations = self.sizes
        return f"Model({self.name}: {data} data, {unknowns} unknowns, {equations} equations)"

    @property
    def name(self):
        return self._content.name

    @property
    def claimed(self):
        """How many solutions the source claims, or None."""
        return self._content.claimed

    @property
    def sizes(self):
        """How many scalars of data and of unknowns, and scalar equations."""
        return self._content.data, self._content.unknowns, self._content.equations

    @property
    def at_least(self):
        """How many complex solutions there are at least for generic data, or None if not known."""
        return self._content.solutions()[0]

    @property
    def at_most(self):
        """How many there are at most, or None if not known."""
        return self._content.solutions()[1]

    def degree(self):
        """How many complex solutions there are for generic data, or None if that is not known.

        The first time it looks for them, which takes some time.
        """
        return self.at_least if self.at_least == self.at_most else None

    def certificate(self):
        """The text of a file that `plcheck` replays. Raises ValueError if nothing was found."""
        return self._content.certificate()

    def template(self):
        """The text of a Python module that solves the problem, as `plprove template` writes it.

        Raises ValueError where there is no template.
        """
        return self._content.template()

    def solver(self):
        """A solver for any data. It finds the solutions for random data first, in seconds or less.

        Raises ValueError where equations and unknowns are not equally many, or there are no data.
        """
        return ModelSolver(self._content.solver())


@dataclass(frozen=True)
class ModelAnswer:
    """The complex solutions of a model for some data, real ones first. They are approximate.

    With n solutions:
    """

    unknowns: dict  #: by name: (n, ...) complex, with the shape of the name
    real: np.ndarray  #: (n,): which are real
    residuals: np.ndarray  #: (n,): the largest value of an equation, relative to its terms
    lost: int  #: how many fewer these are than for random data

    def __len__(self):
        return len(self.real)

    def real_values(self, name):
        """The values of an unknown in the real solutions: (m, ...)."""
        return self.unknowns[name][self.real].real


class ModelSolver:
    """Solves one model for any data, in several threads if you like."""

    def __init__(self, content):
        self._content = content

    @property
    def found(self):
        """How many solutions there are for random data."""
        return self._content.found

    def solve(self, **data):
        """The solutions for these data, as a ModelAnswer: an array for each name of data.

        Raises ValueError where a name is missing or unknown, or an array has another shape.
        """
        names = [name for name, _ in self._content.data]
        for name in data:
            if name not in names:
                raise ValueError(f"the model has no data {name}: it has {', '.join(names)}")
        parts = []
        for name, shape in self._content.data:
            if name not in data:
                raise ValueError(f"{name} is missing: give an array of shape {tuple(shape)}")
            array = np.asarray(data[name], dtype=float)
            if array.shape != tuple(shape):
                raise ValueError(f"{name} has shape {array.shape}: give shape {tuple(shape)}")
            parts.append(array.ravel())
        numbers, real, residuals, lost = self._content.solve(np.concatenate(parts))
        unknowns, first = {}, 0
        for name, shape in self._content.unknowns:
            size = int(np.prod(shape))
            unknowns[name] = numbers[:, first:first + size].reshape(len(real), *shape)
            first += size
        return ModelAnswer(unknowns, real, residuals, lost)


@dataclass(frozen=True)
class Estimate:
    """The poses of V cameras that explain most of N points and L lines."""

    R: np.ndarray  #: (V, 3, 3); camera 1 is the identity
    t: np.ndarray  #: (V, 3); the distance from camera 1 to camera 2 is 1
    points: np.ndarray  #: (N, 3) in space; nan where the match is wrong, or tests no cameras
    line_points: np.ndarray  #: (L, 3): a point of each line; nan alike
    line_directions: np.ndarray  #: (L, 3): of length 1; nan alike
    problem: str  #: the minimal problem that was sampled
    samples: int  #: how many were drawn
    rms: float  #: pixels: of the distances of all that is explained
    #: (6 (V - 1), 6 (V - 1)), or None: of the cameras after the first, the rotation vector w of
    #: exp(w) R in radians, and t
    covariance: Optional[np.ndarray]

    @property
    def point_inliers(self):
        """(N,): which points the cameras explain."""
        return ~np.isnan(self.points[:, 0])

    @property
    def line_inliers(self):
        """(L,): which lines the cameras explain."""
        return ~np.isnan(self.line_points[:, 0])

    def __repr__(self):
        explained = [
            f"{inliers.sum()} of {len(inliers)} {kind}"
            for kind, inliers in [("points", self.point_inliers), ("lines", self.line_inliers)]
            if len(inliers)
        ]
        return f"Estimate({', '.join(explained)}, {self.rms:.2f} pixels, {self.samples} samples)"


@dataclass(frozen=True)
class Offer:
    """A minimal problem of which matches have samples."""

    problem: str  #: in notation
    degree: int  #: how many complex solutions it has
    milliseconds: float  #: that a sample takes on one core, about
    #: milliseconds until a sample may be expected to lead to rotations within 5 degrees of the
    #: truth, where 30 % of the matches are wrong, with half a pixel of noise
    expected: float


_estimator = _pointline.Estimator()


def estimate_poses(
    points=None,
    lines=None,
    K=None,
    incidences=(),
    distortion=None,
    problem="auto",
    threshold=2.0,
    confidence=0.99,
    least_samples=8,
    most_samples=1000,
    seed=0,
    threads=1,
    covariance=False,
):
    """The poses of two or three cameras from many matches, some of them wrong, as an Estimate.

    RANSAC with local optimisation: samples of a minimal problem give cameras, and those that
    explain most matches are refined by all that they explain.

    points: (N, V, 2), pixels; nan where a view does not see the point, or nobody found it there.
    lines: (L, V, 2, 2), two points each, in pixels; nan alike. Views may show different points of
        a line.
    K: (3, 3) or (V, 3, 3), without skew.
    incidences: (M, 2) integers: a point, and a line through it in space.
    distortion: (5,) or (V, 5): k1, k2, p1, p2, k3 of the lens, as OpenCV has them.
    problem: the minimal problem to sample: notation, a name, or the authors' number; "auto" takes
        the first of `offers`.
    threshold: pixels; a match that is farther off is wrong.
    confidence: that among the samples there is one without wrong matches.
    seed: the same estimate for the same seed.
    threads: how many threads share the work; the estimate does not depend on it.

    Raises ValueError where the matches have no sample, or no sample leads to cameras that explain
    more matches than the sample.
    """
    seed = operator.index(seed)
    if not 0 <= seed < 2**64:
        raise ValueError(f"seed is {seed}: give 0 to 2^64 - 1")
    found = _estimator.estimate(
        *_matches(points, lines, K, incidences, distortion),
        str(problem),
        float(threshold),
        float(confidence),
        operator.index(least_samples),
        operator.index(most_samples),
        seed,
        _threads(threads),
        bool(covariance),
    )
    size = 6 * (len(found["R"]) - 1)
    entries = found.pop("covariance")
    return Estimate(**found, covariance=np.reshape(entries, (size, size)) if entries else None)


def offers(points=None, lines=None, K=None, incidences=(), distortion=None):
    """The minimal problems of which these matches have samples, as a list of Offer.

    The one that is expected to take least time comes first. Arguments are those of
    `estimate_poses`.
    """
    matches = _matches(points, lines, K, incidences, distortion)
    return [Offer(*offer) for offer in _pointline.offers(*matches)]


def _matches(points, lines, K, incidences, distortion):
    """Arrays of the shapes that the compiled module takes."""
    if points is None and lines is None:
        raise ValueError("there are no matches: give points, lines, or both")
    if K is None:
        raise ValueError("there is no K: give the intrinsics of the cameras")
    views = np.shape(lines if points is None else points)[1:2]
    if views not in [(2,), (3,)]:
        raise ValueError("give points of the shape (N, V, 2), lines of (L, V, 2, 2), and V is 2 or 3")
    (views,) = views
    points = _reals(np.empty((0, views, 2)) if points is None else points, "points")
    lines = _reals(np.empty((0, views, 2, 2)) if lines is None else lines, "lines")
    incidences = np.reshape(np.asarray(incidences), (-1, 2)) if len(incidences) else np.empty((0, 2), int)
    distortion = np.zeros(5) if distortion is None else _reals(distortion, "distortion")
    for name, array, wanted in [("points", points, (views, 2)), ("lines", lines, (views, 2, 2))]:
        if array.shape[1:] != wanted:
            raise ValueError(f"{name} has the shape {array.shape}: give (number, {str(wanted)[1:]}")
    if not np.issubdtype(incidences.dtype, np.integer):
        raise ValueError("incidences are pairs of indices: give integers")
    if distortion.shape not in [(5,), (views, 5)]:
        raise ValueError(f"distortion has the shape {distortion.shape}: give (5,) or ({views}, 5)")
    return points, lines, incidences, _intrinsics(K, views), np.broadcast_to(distortion, (views, 5))


def _threads(threads):
    threads = operator.index(threads)
    if not 1 <= threads <= 1024:
        raise ValueError(f"threads is {threads}: give 1 to 1024")
    return threads


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
    """fx, fy, cx, cy of each view; none where there is no K."""
    if K is None:
        return np.empty((0, 4))
    K = _reals(K, "K")
    if K.shape not in [(3, 3), (views, 3, 3)]:
        raise ValueError(f"K has the shape {K.shape}: give (3, 3) or ({views}, 3, 3)")
    K = np.broadcast_to(K, (views, 3, 3))
    lower = [K[:, 1, 0], K[:, 2, 0], K[:, 2, 1], K[:, 0, 1], K[:, 2, 2] - 1]
    if np.any(lower):
        raise ValueError("K must be [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]")
    return np.stack([K[:, 0, 0], K[:, 1, 1], K[:, 0, 2], K[:, 1, 2]], axis=1)
