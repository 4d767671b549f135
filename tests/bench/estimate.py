"""estimate_poses beside what OpenCV offers for three views, on the same scenes: success, errors, time.

Usage: estimate.py [--scenes N] [--noise PIXELS ...] [--outliers SHARE ...] [--setting NAME ...]

OpenCV has no estimator for three views, and none with lines. So its peer is a pipeline: RANSAC with
the five-point solver for cameras 1 and 2, triangulation, RANSAC with P3P for camera 3; then
Levenberg and Marquardt's method for camera 3. Times are of processor time, medians. A scene counts as a success
where both rotations are off by less than 2 degrees, and both directions of translation by less
than 5. Nothing is asserted.
"""

import argparse
import time

import cv2
import numpy as np

import pointline

K = np.array([[800.0, 0, 480], [0, 800, 360], [0, 0, 1]])  # 62 degrees from left to right


def looking_at(centre, target, random):
    forward = (target - centre) / np.linalg.norm(target - centre)
    right = np.cross([0.2 * random.uniform(-1, 1), 1, 0], forward)
    right /= np.linalg.norm(right)
    R = np.array([right, np.cross(forward, right), forward])
    return R, -R @ centre


def scene(random, count, noise, outliers, all_three):
    """Points and segments (through them) in three views, and the true R, t.

    all_three: how many of the points view 3 sees.
    """
    target = np.array([0, 0, 5.0])
    centres = [np.zeros(3)]
    direction = random.standard_normal(3)
    centres.append(direction / np.linalg.norm(direction))
    across = np.cross(random.standard_normal(3), direction)
    centres.append(0.7 * centres[1] + across / np.linalg.norm(across))
    poses = [(np.eye(3), np.zeros(3))]
    poses += [looking_at(c, target + 0.3 * random.uniform(-1, 1, 3), random) for c in centres[1:]]
    R, t = (np.array(a) for a in zip(*poses))
    X = target + 1.5 * random.uniform(-1, 1, (count, 3))
    d = random.standard_normal((count, 3))
    d *= 0.4 / np.linalg.norm(d, axis=1, keepdims=True)

    def seen(Y):
        x = (np.einsum("vij,nj->nvi", R, Y) + t) @ K.T
        return x[..., :2] / x[..., 2:] + random.normal(0, noise, (len(Y), 3, 2))

    points, lines = seen(X), np.stack([seen(X - d), seen(X + d)], axis=2)
    for matches in [points, lines]:
        wrong = np.flatnonzero(random.random(count) < outliers)
        view = random.integers(3, size=len(wrong))
        move = random.uniform([0, 0], [960, 720], (len(wrong), 2))
        if matches is lines:
            move = move[:, None] + random.uniform(-60, 60, (len(wrong), 2, 2))
        matches[wrong, view] = move
    points[all_three:, 2] = np.nan
    return points, lines, R, t / np.linalg.norm(t[1])


def by_opencv(points):
    """R, t of three views by points alone; None where it fails."""
    a, b = points[:, 0], points[:, 1]
    E, mask = cv2.findEssentialMat(a, b, K, cv2.RANSAC, 0.999, 1.0)
    if E is None or E.shape != (3, 3):
        return None
    count, R, t, mask = cv2.recoverPose(E, a, b, K, mask=mask)
    good = mask.ravel() > 0
    if count < 5:
        return None
    P = [K @ np.eye(3, 4), K @ np.hstack([R, t])]
    X = cv2.triangulatePoints(P[0], P[1], a[good].T, b[good].T)
    X = (X[:3] / X[3]).T
    third = points[good, 2]
    both = ~np.isnan(third[:, 0]) & np.isfinite(X).all(axis=1)
    if both.sum() < 4:
        return None
    done, r3, t3, inliers = cv2.solvePnPRansac(
        X[both], third[both], K, None, reprojectionError=2.0, confidence=0.999,
        iterationsCount=1000, flags=cv2.SOLVEPNP_P3P)
    if not done:
        return None
    chosen = inliers.ravel()
    r3, t3 = cv2.solvePnPRefineLM(X[both][chosen], third[both][chosen], K, None, r3, t3)
    return (np.array([np.eye(3), R, cv2.Rodrigues(r3)[0]]),
            np.array([np.zeros(3), t.ravel(), t3.ravel()]))


def by_pointline(points, lines=None, problem="auto"):
    pairs = () if lines is None else [(i, i) for i in range(len(points))]
    try:
        found = pointline.estimate_poses(points, lines, K, pairs, problem=problem)
    except ValueError:
        return None
    return found.R, found.t


def angles(found, R, t):
    """The larger error of the rotations, and of the directions of the translations, in degrees."""
    if found is None:
        return 180.0, 180.0
    def angle(cosines):
        return np.degrees(np.arccos(np.clip(cosines, -1, 1))).max()
    turns = (np.einsum("vij,vij->v", found[0][1:], R[1:]) - 1) / 2
    sizes = np.linalg.norm(found[1][1:], axis=1) * np.linalg.norm(t[1:], axis=1)
    return angle(turns), angle(np.einsum("vi,vi->v", found[1][1:], t[1:]) / sizes)


SETTINGS = {
    # name: points, of these in all three views
    "60 points, all in three views": (60, 60),
    "60 points, 10 of them in view 3": (60, 10),
    "12 points, all in three views": (12, 12),
    "8 points, 2 of them in view 3": (8, 2),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=100)
    parser.add_argument("--noise", type=float, nargs="+", default=[0, 0.5, 1])
    parser.add_argument("--outliers", type=float, nargs="+", default=[0, 0.3, 0.6])
    parser.add_argument("--setting", nargs="+", default=list(SETTINGS))
    arguments = parser.parse_args()
    cv2.setNumThreads(1)
    methods = {
        "OpenCV, points": lambda points, lines: by_opencv(points),
        "pointline, points": lambda points, lines: by_pointline(points),
        "pointline, points and lines": by_pointline,
    }
    for setting in arguments.setting:
        count, all_three = SETTINGS[setting]
        for noise in arguments.noise:
            for outliers in arguments.outliers:
                rows = {name: [] for name in methods}
                for seed in range(arguments.scenes):
                    points, lines, R, t = scene(
                        np.random.default_rng(seed), count, noise, outliers, all_three)
                    for name, method in methods.items():
                        cv2.setRNGSeed(seed)
                        begin = time.process_time()
                        found = method(points, lines)
                        rows[name].append((*angles(found, R, t), time.process_time() - begin))
                for name, row in rows.items():
                    turn, move, seconds = np.array(row).T
                    success = (turn < 2) & (move < 5)
                    print(f"{setting:32} noise {noise:3} wrong {outliers:3.0%}  {name:28}"
                          f" success {success.mean():4.0%}"
                          f"  rotation {np.median(turn):6.3f}  translation {np.median(move):6.3f}"
                          f"  {1e3 * np.median(seconds):6.1f} ms", flush=True)


if __name__ == "__main__":
    main()
