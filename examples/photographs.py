"""From photographs to the poses of three cameras: a chessboard, as Debian's package opencv-doc has it.

OpenCV finds the corners of the board and calibrates the camera. pointline gets the corners of three
photographs, the edges through them, and the lens, and finds the poses without knowing the board.
The calibration, which knows it, says how far they are off.

Usage: photographs.py [--folder FOLDER] [--photos A B C] [--plot FILE.svg]
"""

import argparse
from pathlib import Path

import cv2
import numpy as np

import pointline

BOARD = (9, 6)  # inner corners
FOLDER = "/usr/share/doc/opencv-doc/examples/data"


def corners(path):
    """(54, 2) pixels, row by row; None where the board is not found."""
    photo = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
    found, points = cv2.findChessboardCorners(photo, BOARD)
    if not found:
        return None
    stop = (cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_MAX_ITER, 50, 1e-4)
    return cv2.cornerSubPix(photo, points, (5, 5), (-1, -1), stop)[:, 0]


def calibration(seen, size):
    """K, the lens, and R, t of each photograph, from the board that all show."""
    board = np.zeros((BOARD[0] * BOARD[1], 3), np.float32)
    board[:, :2] = np.indices(BOARD).T.reshape(-1, 2)
    _, K, lens, turns, moves = cv2.calibrateCamera(
        [board] * len(seen), [x[:, None] for x in seen], size, None, None)
    return K, lens.ravel(), [cv2.Rodrigues(r)[0] for r in turns], [t.ravel() for t in moves]


def edges(points):
    """Edges of the board, (48, views, 2, 2), and which corner each passes through."""
    starts = [i for i in range(len(points)) if (i + 1) % BOARD[0]]
    lines = np.stack([points[starts], points[[i + 1 for i in starts]]], axis=2)
    return lines, [(i, number) for number, i in enumerate(starts)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--folder", type=Path, default=FOLDER)
    parser.add_argument("--photos", type=int, nargs=3, default=[1, 2, 3])
    parser.add_argument("--plot")
    arguments = parser.parse_args()
    paths = sorted(arguments.folder.glob("left[0-9]*.jpg"))
    boards = {int(path.stem[4:]): corners(path) for path in paths}
    boards = {number: points for number, points in boards.items() if points is not None}
    missing = [number for number in arguments.photos if number not in boards]
    if missing:
        parser.error(f"no board in photo {missing[0]} of {arguments.folder}: give others of "
                     f"{sorted(boards)}, or install opencv-doc")
    size = cv2.imread(str(paths[0])).shape[1::-1]
    K, lens, turns, moves = calibration(list(boards.values()), size)
    points = np.stack([boards[number] for number in arguments.photos], axis=1).astype(float)
    lines, incidences = edges(points)
    found = pointline.estimate_poses(
        points, lines, K, incidences, distortion=lens, threshold=1)
    print(found)
    pose = {number: i for i, number in enumerate(boards)}
    first = pose[arguments.photos[0]]
    for camera, number in enumerate(arguments.photos[1:], 1):
        R = turns[pose[number]] @ turns[first].T
        t = moves[pose[number]] - R @ moves[first]
        trace = np.trace(found.R[camera].T @ R)
        cosine = found.t[camera] @ t / np.linalg.norm(found.t[camera]) / np.linalg.norm(t)
        turn, move = np.degrees(np.arccos(np.clip([(trace - 1) / 2, cosine], -1, 1)))
        print(f"camera {camera + 1}: rotation off by {turn:.2f} degrees, translation by {move:.2f}")
    if arguments.plot:
        import plots

        plots.draw(arguments.plot, found.points[found.point_inliers],
                   [(f"camera {v + 1}", found.R[v:v + 1], found.t[v:v + 1]) for v in range(3)])


if __name__ == "__main__":
    main()
