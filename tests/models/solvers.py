"""The solvers that `plprove template` writes find what data were made from, and all else.

Usage: solvers.py PLPROVE FOLDER_OF_MODELS docs/models.md

Data are made from a known solution, by the geometry of each problem. Then the solver finds it; finds
as many solutions as are certified, different and closed under complex conjugation; and each of them
satisfies the equations but for rounding. Seven points are solved by a second method, too. The
example of docs/models.md runs, and finds what it says.
"""

import contextlib
import importlib.util
import io
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

random = np.random.default_rng(1)


def normal(*shape):
    return random.normal(size=shape)


def skew(v):
    return np.cross(np.eye(3), v)


def rotation(q):
    q = q / np.linalg.norm(q)
    return (2 * q[0] ** 2 - 1) * np.eye(3) + 2 * np.outer(q[1:], q[1:]) + 2 * q[0] * skew(q[1:])


def seen_through(F, count):
    """Pairs x, y of rays with x . F y = 0."""
    y = normal(count, 3)
    return {"x": np.cross(y @ F.T, normal(count, 3)), "y": y}


def p3p():
    x, s = normal(3, 3), np.abs(normal(3))
    X = s[:, None] * x
    d = [np.sum((X[i] - X[j]) ** 2) for i, j in [(0, 1), (0, 2), (1, 2)]]
    return {"x": x, "d": d}, {"s": s}, 8


def five_points():
    E = skew(normal(3)) @ rotation(normal(4))
    return seen_through(E, 5), {"E": E / E[2, 2]}, 10


def three_points_upright():
    c, s = np.cos(0.7), np.sin(0.7)
    E = skew(normal(3)) @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return seen_through(E, 3), {"E": E / E[0, 1]}, 4


def seven_points():
    F = skew(normal(3)) @ normal(3, 3)
    return seen_through(F, 7), {"f": (F / F[2, 2]).ravel()[:8]}, 3


def six_points_focal():
    K = np.diag([1, 1, 1.3])
    F = K @ skew(normal(3)) @ rotation(normal(4)) @ K
    return seen_through(F, 6), {"e": (F / F[2, 2]).ravel()[:8], "w": 1.69}, 15


def gps():
    s, x, b = normal(4, 3), normal(3), 0.3
    p = np.linalg.norm(s - x, axis=1) + b
    return {"s": s, "p": p}, {"n": x @ x - b**2, "x": x, "b": b}, 2


def rolling_shutter():
    X, k, v, w, c, t = normal(6, 3), normal(6), normal(3), normal(3), normal(3), normal(3)
    turned = X + np.cross(v, X)
    x = turned + k[:, None] * np.cross(w, turned) + c + k[:, None] * t
    return {"X": X, "x": x, "k": k}, {"v": v, "w": w, "c": c, "t": t}, 20


def upright_p2p():
    X, t, c, s = normal(2, 3), normal(3), np.cos(0.7), np.sin(0.7)
    x = X @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T + t
    return {"X": X, "x": x}, {"c": c, "s": s, "t": t}, 2


def module(plprove, models, name, folder):
    path = pathlib.Path(folder) / f"{name}.py"
    subprocess.run([plprove, "template", f"{models}/{name}.model", "-o", path], check=True)
    spec = importlib.util.spec_from_file_location(name, path)
    solver = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(solver)
    return solver


def contains(solutions, wanted):
    return np.abs(solutions - wanted).max(axis=1).min() < 1e-5 * (1 + np.abs(wanted).max())


def check_laws(solver, data, truth, count):
    solutions = solver.solve(**data)
    assert solutions.shape[0] == count
    assert solver.residuals(solutions, **data).max() < 1e-6
    wanted = np.concatenate([np.ravel(truth[name]) for name in solver.VARIABLES])
    assert contains(solutions, wanted) and contains(solver.real(solutions), wanted)
    assert all(contains(solutions, solution.conj()) for solution in solutions)
    apart = np.abs(solutions[:, None] - solutions[None]).max(axis=2) + np.eye(count)
    assert apart.min() > 1e-6
    for name, part in solver.named(solutions).items():
        assert part.shape == (count, *np.shape(truth[name]))


def check_shapes_are_refused(solver):
    try:
        solver.solve(x=np.zeros((2, 3)), d=np.zeros(3))
    except ValueError as error:
        assert str(error) == "x has the shape (2, 3): give the shape (3, 3)", error
    else:
        raise AssertionError("a wrong shape is taken")


def fundamental_matrices(x, y):
    """The second method: a pencil of matrices, and the zeros of its determinant."""
    rows = np.einsum("ni,nj->nij", x, y).reshape(7, 9)
    A, B = np.linalg.svd(rows)[2][7:].reshape(2, 3, 3)
    points = np.array([-1.0, 0, 1, 2])
    cubic = np.linalg.solve(np.vander(points), [np.linalg.det(A + z * B) for z in points])
    matrices = [A + z * B for z in np.roots(cubic)]
    return np.array([(F / F[2, 2]).ravel()[:8] for F in matrices])


def check_example(page, solver):
    sys.modules["p3p"] = solver
    block = pathlib.Path(page).read_text().split("```python\n")[1].split("```")[0]
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(block, {})
    assert printed.getvalue().startswith("the depths 4, 5, 6 are found: True\n")


def main():
    plprove, models, page = sys.argv[1:]
    problems = [p3p, five_points, three_points_upright, seven_points, six_points_focal, gps,
                rolling_shutter, upright_p2p]
    with tempfile.TemporaryDirectory() as folder:
        for problem in problems:
            data, truth, count = problem()
            solver = module(plprove, models, problem.__name__, folder)
            check_laws(solver, data, truth, count)
            if problem is p3p:
                check_shapes_are_refused(solver)
                check_example(page, solver)
            if problem is seven_points:
                again = fundamental_matrices(**data)
                assert all(contains(solver.solve(**data), F) for F in again)
            print(f"{problem.__name__}: {count} solutions")


if __name__ == "__main__":
    main()
