"""Poses from many matches, some of them wrong, against cameras that are known."""

from pathlib import Path

import numpy as np
import pytest

import pointline

K = np.array([[800.0, 0, 320], [0, 800, 240], [0, 0, 1]])


def scene(count=40, noise=0.5, seed=1):
    """points (N, 3, 2), lines (N, 3, 2, 2) through them, and R, t of the cameras."""
    random = np.random.default_rng(seed)
    c, s = np.cos([0, -0.2, 0.25]), np.sin([0, -0.2, 0.25])
    R = np.array([[[c[v], 0, s[v]], [0, 1, 0], [-s[v], 0, c[v]]] for v in range(3)])
    centres = np.array([[0, 0, 0], [0.8, 0.6, 0], [-1.1, 0.2, 0.4]])
    t = -np.einsum("vij,vj->vi", R, centres)
    X = random.uniform(-1.5, 1.5, (count, 3)) + [0, 0, 5]
    directions = 0.4 * random.standard_normal((count, 3))

    def seen(Y):
        x = (np.einsum("vij,nj->nvi", R, Y) + t) @ K.T
        return x[..., :2] / x[..., 2:] + random.normal(0, noise, (count, 3, 2))

    return seen(X), np.stack([seen(X - directions), seen(X + directions)], axis=2), R, t


def angles(R, true_R):
    traces = np.einsum("vij,vij->v", R, true_R)
    return np.degrees(np.arccos(np.clip((traces - 1) / 2, -1, 1)))


PAIRS = [(i, i) for i in range(40)]


def test_three_views_of_points_and_lines():
    points, lines, R, t = scene()
    points[::4, 2] += 30
    lines[1::4, 1] = lines[2::4, 1]
    points[5, 0] = lines[5, 2] = np.nan
    found = pointline.estimate_poses(points, lines, K, PAIRS, covariance=True)
    assert angles(found.R, R).max() < 0.5
    assert np.abs(found.t - t).max() < 0.02
    assert not found.point_inliers[::4].any() and found.point_inliers.sum() >= 25
    assert not found.line_inliers[1::4].any() and found.line_inliers.sum() >= 25
    assert np.isfinite(found.points[found.point_inliers]).all()
    assert found.point_inliers[5] and not found.line_inliers[5]
    assert found.covariance.shape == (12, 12)
    assert repr(found).startswith("Estimate(")
    # Threads change nothing. Another seed draws other samples.
    again = pointline.estimate_poses(points, lines, K, PAIRS, threads=2)
    assert np.array_equal(again.R, found.R) and again.covariance is None
    other = pointline.estimate_poses(points, lines, K, PAIRS, seed=5)
    assert angles(other.R, R).max() < 0.5


@pytest.mark.parametrize("problem", ["Cleveland", "P/P/P + 2*Pa/Pa/Pa"])
def test_a_problem_of_ones_own(problem):
    points, lines, R, t = scene(12)
    points[5:] = np.nan  # five points, and lines
    found = pointline.estimate_poses(
        points, lines, K, PAIRS[:12], problem=problem, most_samples=16
    )
    assert found.problem == pointline.problem(problem).notation
    assert found.samples == 16
    assert angles(found.R, R).max() < 3


def test_two_views():
    points, _, R, t = scene()
    found = pointline.estimate_poses(points[:, :2], K=K)
    assert found.problem == "5*P/P"
    assert angles(found.R, R[:2]).max() < 0.5
    assert found.line_points.shape == (0, 3)


def test_offers():
    points, lines, _, _ = scene()
    names = [offer.problem for offer in pointline.offers(points, lines, K, PAIRS)]
    assert names[0] == "3*P/P/P + 2*P/P/-" and "P/P/P + 2*Pa/Pa/Pa" in names
    (only,) = pointline.offers(points[:, :2], K=K)
    assert (only.problem, only.degree) == ("5*P/P", 20)
    assert pointline.offers(points[:2], K=K) == []


def test_a_lens():
    points, lines, R, t = scene(noise=0)
    lens = np.array([-0.2, 0.05, 0.001, -0.001, 0.0])

    def distorted(x):
        u = (x - K[:2, 2]) / K[0, 0]
        r2 = (u**2).sum(-1, keepdims=True)
        uv = u[..., :1] * u[..., 1:]
        tangential = 2 * uv * lens[2:4] + lens[3:1:-1] * (r2 + 2 * u**2)
        return (u * (1 + lens[0] * r2 + lens[1] * r2**2) + tangential) * K[0, 0] + K[:2, 2]

    found = pointline.estimate_poses(distorted(points), None, K, distortion=lens)
    assert angles(found.R, R).max() < 1e-3
    assert found.point_inliers.all()


def test_messages_say_what_to_give():
    points, lines, _, _ = scene()
    for arguments, message in [
        (dict(K=K), "there are no matches"),
        (dict(points=points), "there is no K"),
        (dict(points=points[:, :1], K=K), "V is 2 or 3"),
        (dict(points=points, lines=lines[:, :2], K=K), r"lines has the shape \(40, 2, 2, 2\)"),
        (dict(points=points, K=K, incidences=[(0.5, 1)]), "give integers"),
        (dict(points=points, lines=lines, K=K, incidences=[(0, 40)]), "incidence 1: there is no such point, or no such line"),
        (dict(points=points, lines=lines, K=K, incidences=[(0, 0), (-1, 0)]), "incidence 2"),
        (dict(points=points, K=K, distortion=[0.1]), "distortion has the shape"),
        (dict(points=points, K=K, threshold=0), "give a threshold"),
        (dict(points=points, K=K, confidence=1), "give a confidence"),
        (dict(points=points, K=K, threads=0), "give 1 to 1024"),
        (dict(points=points, K=K, seed=-1), "seed is -1: give 0"),
        (dict(points=points, K=K, problem="Chicago"), "no sample of 2"),
        (dict(points=points, K=K, problem="5*P/P"), "has 2 views, and the matches have 3"),
        (dict(points=points[:4], K=K), "too few"),
    ]:
        with pytest.raises(ValueError, match=message):
            pointline.estimate_poses(**arguments)


def test_the_lines_that_the_page_starts_with(capsys):
    page = Path(__file__).parents[2] / "docs/python.md"
    exec(page.read_text().split("```python\n")[1].split("```")[0], {})
    shown = capsys.readouterr().out
    assert shown.startswith("Estimate(") and shown.endswith("off by less than 0.5 degrees: True\n")
