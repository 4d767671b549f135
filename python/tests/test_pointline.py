"""The module against scenes whose cameras are known."""

import threading
import warnings
from pathlib import Path

import numpy as np
import pytest

import pointline

K = np.array([[800.0, 0, 320], [0, 780, 240], [0, 0, 1]])


def rotation(vector):
    """The rotation about the vector by its length (Rodrigues)."""
    angle = np.linalg.norm(vector)
    if angle == 0:
        return np.eye(3)
    x, y, z = vector / angle
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * skew + (1 - np.cos(angle)) * skew @ skew


def scene_cameras(views, seed):
    """R and t; the distance from camera 1 to camera 2 is 1."""
    random = np.random.default_rng(seed)
    R = [np.eye(3)] + [rotation(0.2 * random.standard_normal(3)) for _ in range(views - 1)]
    centres = [np.zeros(3)] + [random.standard_normal(3) for _ in range(views - 1)]
    centres = [c / np.linalg.norm(centres[1]) for c in centres]
    return np.array(R), np.array([-r @ c for r, c in zip(R, centres)])


def project(points, R, t):
    """(N, V, 2) pixels of (N, 3) points."""
    x = np.einsum("vij,nj->nvi", R, points) + t
    x = x @ K.T
    return x[..., :2] / x[..., 2:]


def nearest(answer, R, t):
    errors = np.abs(answer.R - R).max((1, 2, 3)) + np.abs(answer.t - t).max((1, 2))
    return int(errors.argmin()), errors.min()


def random_points(count, seed):
    return np.random.default_rng(seed).uniform(-1.5, 1.5, (count, 3)) + [0, 0, 6]


def test_five_points():
    solver = pointline.problem("5*P/P").solver()
    assert solver.degree == 20
    for seed in range(10):
        R, t = scene_cameras(2, seed)
        X = random_points(5, seed)
        answer = solver.solve(points=project(X, R, t), K=K, conditions=True)
        index, error = nearest(answer, R, t)
        assert error < 1e-7
        assert answer.found == 20 and answer.complete == "certified"
        assert answer.in_front[index] == 5
        np.testing.assert_allclose(answer.points[index], X, atol=1e-5)
        assert np.all(answer.conditions > 0) and np.all(answer.residuals < 1e-4)


def test_chicago_with_two_points_a_line():
    chicago = pointline.problem("2*Pa/Pa/Pa + P/P/P")
    assert (chicago.verdict, chicago.degree, chicago.views) == ("minimal", 312, 3)
    assert chicago.picture.startswith("<?xml") or "<svg" in chicago.picture
    solver = chicago.solver()
    R, t = scene_cameras(3, 3)
    X, Y = random_points(3, 4), random_points(2, 5)
    points = project(X, R, t)
    lines = np.stack([points[:2], project(Y, R, t)], axis=2)
    answer = solver.solve(points=points, lines=lines, K=K)
    index, error = nearest(answer, R, t)
    assert error < 1e-8
    np.testing.assert_allclose(answer.line_points[index], X[:2], atol=1e-6)
    directions = (Y - X[:2]) / np.linalg.norm(Y - X[:2], axis=1, keepdims=True)
    assert np.abs(np.cross(answer.line_directions[index], directions)).max() < 1e-6
    quick = solver.solve(points=points, lines=lines, K=K, quick=True)
    assert nearest(quick, R, t)[1] < 1e-8
    shared = solver.solve(points=points, lines=lines, K=K, threads=2)
    assert np.array_equal(shared.R, answer.R) and np.array_equal(shared.t, answer.t)
    # The same lines by coefficients.
    homogeneous = np.concatenate([lines, np.ones(lines.shape[:3] + (1,))], axis=3)
    coefficients = np.cross(homogeneous[..., 0, :], homogeneous[..., 1, :])
    again = solver.solve(points=points, lines=coefficients, K=K)
    assert nearest(again, R, t)[1] < 1e-8


def test_threads_share_a_solver():
    solver = pointline.problem("5*P/P").solver()
    scenes = [(*scene_cameras(2, seed), random_points(5, seed)) for seed in range(8)]
    errors = [None] * len(scenes)

    def work(i):
        R, t, X = scenes[i]
        errors[i] = nearest(solver.solve(points=project(X, R, t), K=K), R, t)[1]

    threads = [threading.Thread(target=work, args=(i,)) for i in range(len(scenes))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert max(errors) < 1e-7


def test_what_is_wrong_is_a_value_error():
    with pytest.raises(ValueError, match="did you mean Chicago"):
        pointline.problem("Chicago?")
    with pytest.raises(ValueError, match="minimal"):
        pointline.problem("4*P/P").solver()
    solver = pointline.problem("5*P/P").solver()
    points = project(random_points(5, 0), *scene_cameras(2, 0))
    with pytest.raises(ValueError, match="shape"):
        solver.solve(points=points[:4])
    with pytest.raises(ValueError, match="feature 3, view 2: give the point"):
        unseen = points.copy()
        unseen[2, 1] = np.nan
        solver.solve(points=unseen)
    with pytest.raises(ValueError, match="finite"):
        infinite = points.copy()
        infinite[2, 1] = np.inf
        solver.solve(points=infinite)
    with pytest.raises(ValueError, match="shape"):
        solver.solve(points=points, lines=np.zeros((1, 2, 3)))
    with pytest.raises(ValueError, match="K must be"):
        solver.solve(points=points, K=np.ones((3, 3)))
    for threads in [0, 1025]:
        with pytest.raises(ValueError, match="give 1 to 1024"):
            solver.solve(points=points, threads=threads)


def test_the_problem_and_its_representation():
    cleveland = pointline.problem("3*P/P/P + a/a/a")
    assert repr(cleveland) == "pointline.problem('3*P/P/P + a/a/a')"
    assert cleveland._repr_svg_() == cleveland.picture
    assert pointline.problem(2394).notation == "2*Pa/Pa/Pa + P/P/P"
    assert pointline.problem("P/P/P").degree is None
    assert len(pointline.problem("P/P/P").reasons) > 0


def test_a_solver_takes_the_notation():
    assert pointline.Solver("5*P/P").degree == 20
    with pytest.raises(ValueError, match="is no feature"):
        pointline.Solver("P/P/P + foo")


def test_messages_say_what_to_give(tmp_path):
    problem = pointline.problem("5*P/P")
    solver = problem.solver()
    points = project(random_points(5, 0), *scene_cameras(2, 0))
    with pytest.raises(ValueError, match=r"K has the shape \(2, 2\): give \(3, 3\) or \(2, 3, 3\)"):
        solver.solve(points=points, K=np.ones((2, 2)))
    with pytest.raises(ValueError, match=r"lines has the shape \(\): give the shape \(0, 2, 3\)"):
        solver.solve(points=points, lines=3.0, K=K)
    with pytest.raises(ValueError, match="points has complex numbers"):
        solver.solve(points=points * 1j, K=K)
    with pytest.raises(TypeError):
        solver.solve(points=points, K=K, threads=1.5)
    chicago = pointline.problem("Chicago")
    with pytest.raises(ValueError, match="zero character"):
        chicago.solver("a\0b")
    with pytest.raises(OSError, match="does it exist"):
        chicago.solver(tmp_path / "none")
    for path in [tmp_path, "/dev/zero"]:
        with pytest.raises(OSError, match="this is no file"):
            chicago.solver(path)


def test_lines_through_several_points():
    problem = pointline.problem("3*PL/PL/PL + P/P/P")
    assert (problem.verdict, problem.views, problem.degree, problem.calibrated) == ("minimal", 3, 64, True)
    solver = problem.solver()
    for seed in range(3):
        R, t = scene_cameras(3, seed)
        X = random_points(4, seed)
        X[2] = 0.3 * X[0] + 0.7 * X[1]  # on the line L
        answer = solver.solve(points=project(X, R, t), K=K)
        index, error = nearest(answer, R, t)
        assert error < 1e-6
        assert (answer.found, answer.complete, answer.in_front[index]) == (64, "certified", 4)
        assert np.allclose(answer.points[index], X, atol=1e-5)
        assert answer.line_points.shape == (len(answer), 0, 3)


def test_uncalibrated_cameras():
    problem = pointline.problem("projective: 6*P/P/P")
    assert (problem.verdict, problem.degree, problem.calibrated) == ("minimal", 3, False)
    solver = problem.solver()
    R, t = scene_cameras(3, 1)
    pixels = project(random_points(6, 1), R, t)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        answer = solver.solve(points=pixels)
    assert (answer.found, answer.complete) == (3, "certified")
    for R, t, X in zip(answer.R, answer.t, answer.points):
        images = np.einsum("vij,nj->nvi", R, X) + t
        assert np.abs(images[..., :2] / images[..., 2:] - pixels).max() < 1e-5
    with pytest.raises(ValueError, match="the cameras are uncalibrated: give no intrinsics"):
        solver.solve(points=pixels, K=K)


def test_four_views_and_problems_that_are_not_solved():
    assert pointline.problem("3*PL/PL/PL/PL + a/a/a/a").degree == 32
    assert pointline.problem("7*P/P/P/P").verdict == "unbalanced"
    with pytest.raises(ValueError, match="is none of these"):
        pointline.problem("7*P/P/P/P").solver()
    with pytest.raises(ValueError, match="leave the start out"):
        pointline.problem("3*PL/PL/PL + P/P/P").solver(start="any.start")


def test_pixels_without_a_camera_are_warned_of():
    solver = pointline.problem("5*P/P").solver()
    points = project(random_points(5, 0), *scene_cameras(2, 0))
    with pytest.warns(UserWarning, match="look like pixels"):
        solver.solve(points=points)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        solver.solve(points=points, K=K)
        answer = solver.solve(points=(points - K[:2, 2]) / [K[0, 0], K[1, 1]])
    assert repr(answer) == f"Answer({len(answer)} real of 20 found of 20, certified)"
    chicago = pointline.problem("Chicago").solver()
    R, t = scene_cameras(3, 3)
    points, ends = project(random_points(3, 4), R, t), project(random_points(2, 5), R, t)
    normalised = (points - K[:2, 2]) / [K[0, 0], K[1, 1]]
    lines = np.stack([points[:2], ends], axis=2)
    homogeneous = np.concatenate([lines, np.ones(lines.shape[:3] + (1,))], axis=3)
    for pixels in [lines, np.cross(homogeneous[..., 0, :], homogeneous[..., 1, :])]:
        with pytest.warns(UserWarning, match="look like pixels"):
            chicago.solve(points=normalised, lines=pixels)


def test_the_five_points_of_the_page(capsys):
    page = Path(__file__).parents[2] / "docs/python.md"
    (block,) = [b for b in page.read_text().split("```") if '"five-point"' in b]
    exec(block.removeprefix("python\n"), {})
    assert capsys.readouterr().out == (
        "Answer(8 real of 20 found of 20, certified) - the true cameras are among them: True\n"
    )
