"""The poses of three cameras from noisy matches of points and lines; some of these are wrong.

Usage: estimate.py [--problem PROBLEM] [--seed N] [--plot FILE.svg]
"""

import argparse

import cube
import numpy as np

import pointline


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
        import plots

        plots.draw(arguments.plot, found.points[found.point_inliers],
                   [("true", true_R, true_t), ("found", found.R, found.t)])


if __name__ == "__main__":
    main()
