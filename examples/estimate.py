"""The poses of three cameras from noisy matches of points and lines; some of these are wrong.

Usage: estimate.py [--problem PROBLEM] [--seed N] [--plot FILE.svg]
"""

import argparse

import cube
import numpy as np

import pointline


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
    parser.add_argument("--problem", default="auto")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--plot")
    arguments = parser.parse_args()
    points, ends, true_R, true_t = cube.scene(seed=arguments.seed)
    found = pointline.estimate_poses(
        points=points,
        lines=np.stack([points, ends], axis=2),
        incidences=[(i, i) for i in range(len(points))],
        K=cube.K,
        problem=arguments.problem,
    )
    angles = [np.degrees(np.arccos(np.clip((np.trace(a.T @ b) - 1) / 2, -1, 1)))
              for a, b in zip(found.R[1:], true_R[1:])]
    print(found)
    print(f"samples of {found.problem}")
    print(f"rotations off by {angles[0]:.2f} and {angles[1]:.2f} degrees")
    if arguments.plot:
        plot(arguments.plot, found.points[found.point_inliers], found.R, found.t, true_R, true_t)


if __name__ == "__main__":
    main()
