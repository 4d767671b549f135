"""Three views of a cube with texture: a synthetic scene whose cameras are known.

Each feature is a point of the cube with a line through it (a direction of the texture). Noise moves
what is seen by half a pixel; a fifth of the matches are wrong.
"""

import numpy as np

K = np.array([[800.0, 0, 320], [0, 800, 240], [0, 0, 1]])


def looking_at(centre, target=(0, 0, 0)):
    """R and t of an upright camera at `centre`."""
    forward = np.subtract(target, centre) / np.linalg.norm(np.subtract(target, centre))
    right = np.cross([0, 1, 0], forward)
    right /= np.linalg.norm(right)
    R = np.array([right, np.cross(forward, right), forward])
    return R, -R @ centre


def project(X, R, t):
    """Pixels of points X (N, 3) in the views with R (V, 3, 3) and t (V, 3): (N, V, 2)."""
    x = (np.einsum("vij,nj->nvi", R, X) + t) @ K.T
    return x[..., :2] / x[..., 2:]


def cameras():
    """R and t of three cameras, in the frame of the first; the first two are 1 apart."""
    centres = np.array([[-1.2, -1.5, -5.0], [0.4, -2.2, -5.2], [1.8, -1.0, -4.6]])
    poses = [looking_at(c) for c in centres]
    R1, t1 = poses[0]
    R = np.array([R @ R1.T for R, t in poses])
    t = np.array([t - R @ R1.T @ t1 for R, t in poses])
    return R, t / np.linalg.norm(t[1])


def cube(count, random):
    """Points on three faces of the cube [-1, 1]^3, and second points of lines in these faces."""
    X, Y = random.uniform(-1, 1, (count, 3)), random.uniform(-1, 1, (count, 3))
    face = random.integers(3, size=count)
    rows = np.arange(count)
    X[rows, face] = Y[rows, face] = np.array([1, -1, -1])[face]
    direction = (Y - X) / np.linalg.norm(Y - X, axis=1, keepdims=True)
    return X, X + 0.3 * direction


def scene(count=80, noise=0.5, outliers=0.2, seed=0):
    """points (N, 3, 2), second points of the lines (N, 3, 2), and the true R and t."""
    random = np.random.default_rng(seed)
    R, t = cameras()
    R1, t1 = looking_at([-1.2, -1.5, -5.0])
    scale = np.linalg.norm(np.subtract([0.4, -2.2, -5.2], [-1.2, -1.5, -5.0]))
    X, Y = ((Z @ R1.T + t1) / scale for Z in cube(count, random))
    points, ends = project(X, R, t), project(Y, R, t)
    wrong = random.random(count) < outliers
    points[wrong, 1:] += random.normal(0, 60, (wrong.sum(), 2, 2))
    points += random.normal(0, noise, points.shape)
    ends += random.normal(0, noise, ends.shape)
    return points, ends, R, t
