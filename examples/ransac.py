"""RANSAC around the Chicago solver: cameras from noisy matches; some of these are wrong.

Usage: ransac.py [--samples N] [--seed N] [--plot FILE.svg]
"""

import argparse

import cube
import numpy as np

import pointline


def triangulate(x, R, t):
    """The points (N, 3) whose images are nearest to x (N, V, 2), to first order."""
    P = cube.K @ np.concatenate([R, t[..., None]], axis=2)
    rows = x[..., None] * P[None, :, 2:3] - P[None, :, :2]  # (N, V, 2, 4)
    X = np.linalg.svd(rows.reshape(len(x), -1, 4))[2][:, -1]
    return X[:, :3] / X[:, 3:]


def errors(x, R, t):
    """The largest reprojection error of each match, in pixels."""
    X = triangulate(x, R, t)
    return np.linalg.norm(cube.project(X, R, t) - x, axis=2).max(axis=1)


def ransac(points, ends, samples, threshold=3.0, seed=0):
    """The cameras that explain most matches, and which."""
    random = np.random.default_rng(seed)
    solver = pointline.problem("2*Pa/Pa/Pa + P/P/P").solver()
    best = np.zeros(len(points), bool), None, None
    for _ in range(samples):
        three = random.choice(len(points), 3, replace=False)
        lines = np.stack([points[three[:2]], ends[three[:2]]], axis=2)
        answer = solver.solve(points[three], lines, cube.K, quick=True)
        for R, t, front in zip(answer.R, answer.t, answer.in_front):
            if front < 3:
                break  # those with most points in front come first
            inliers = errors(points, R, t) < threshold
            if inliers.sum() > best[0].sum():
                best = inliers, R, t
    return best


def plot(path, X, R, t, true_R, true_t):
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "pointline"
    from matplotlib import pyplot

    axes = pyplot.figure(figsize=(6, 4.5)).add_subplot(projection="3d")
    axes.scatter(X[:, 0], X[:, 2], -X[:, 1], s=4, color="grey", label="points")
    for name, color, Rs, ts in [("true", "black", true_R, true_t), ("found", "red", R, t)]:
        centres = -np.einsum("vji,vj->vi", Rs, ts)
        axes.scatter(centres[:, 0], centres[:, 2], -centres[:, 1], color=color, label=name)
        for c, axis in zip(centres, Rs[:, 2]):
            axes.quiver(c[0], c[2], -c[1], axis[0], axis[2], -axis[1], color=color)
    axes.legend()
    pyplot.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--samples", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--plot")
    arguments = parser.parse_args()
    points, ends, true_R, true_t = cube.scene(seed=arguments.seed)
    inliers, R, t = ransac(points, ends, arguments.samples, seed=arguments.seed)
    angles = [np.degrees(np.arccos(np.clip((np.trace(a.T @ b) - 1) / 2, -1, 1)))
              for a, b in zip(R[1:], true_R[1:])]
    print(f"{inliers.sum()} of {len(points)} matches explained")
    print(f"rotations off by {angles[0]:.1f} and {angles[1]:.1f} degrees")
    if arguments.plot:
        plot(arguments.plot, triangulate(points[inliers], R, t), R, t, true_R, true_t)


if __name__ == "__main__":
    main()
