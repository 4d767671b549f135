"""Models: problems that are given by equations."""

from pathlib import Path

import numpy as np
import pytest

import pointline

SOURCE = Path(__file__).parents[2]
P3P = SOURCE / "models/p3p.model"


def test_a_model_says_how_many_solutions_it_has():
    for source in [P3P, str(P3P), P3P.read_text(encoding="utf-8")]:
        model = pointline.Model(source)
        assert (model.name, model.claimed, model.sizes) == ("p3p", 8, (12, 3, 3))
    assert (model.degree(), model.at_least, model.at_most) == (8, 8, 8)
    assert repr(model) == "Model(p3p: 12 data, 3 unknowns, 3 equations)"


def test_its_certificate_is_the_committed_one():
    committed = SOURCE / "certs/models/p3p.plc"
    assert pointline.Model(P3P).certificate() == committed.read_text(encoding="utf-8")


def test_its_template_solves():
    solver = {}
    exec(pointline.Model(P3P).template(), solver)
    x, s = np.random.default_rng(1).normal(size=(3, 3)), np.array([1.0, 2, 3])
    X = s[:, None] * x
    d = [np.sum((X[i] - X[j]) ** 2) for i, j in [(0, 1), (0, 2), (1, 2)]]
    solutions = solver["solve"](x=x, d=d)
    assert solutions.shape == (8, 3)
    assert np.isclose(solutions, s).all(axis=1).any()


def test_its_solver_solves():
    solver = pointline.Model(P3P).solver()
    assert solver.found == 8
    x, s = np.random.default_rng(1).normal(size=(3, 3)), np.array([1.0, 2, 3])
    X = s[:, None] * x
    d = [np.sum((X[i] - X[j]) ** 2) for i, j in [(0, 1), (0, 2), (1, 2)]]
    answer = solver.solve(x=x, d=d)
    assert len(answer) == 8 and answer.lost == 0 and answer.unknowns["s"].shape == (8, 3)
    assert np.isclose(answer.real_values("s"), s).all(axis=1).any()
    assert answer.residuals.max() < 1e-10
    for data, complaint in [({"x": x}, "d is missing: give an array of shape \\(3,\\)"),
                            ({"x": x, "d": d, "e": 1}, "the model has no data e: it has x, d"),
                            ({"x": x[0], "d": d}, "x has shape \\(3,\\): give shape \\(3, 3\\)"),
                            ({"x": x * np.nan, "d": d}, "is not finite")]:
        with pytest.raises(ValueError, match=complaint):
            solver.solve(**data)


def test_a_model_that_is_not_minimal_has_no_solution():
    model = pointline.Model("model m\ndata a\nunknown x\nequation x = a\nequation x = 1\n")
    assert model.degree() == 0
    assert "basis\n" in model.certificate()


def test_what_is_not_known_is_none_and_what_is_wrong_raises():
    model = pointline.Model("model m\ndata a\nunknown x, y\nequation x = a\nequation x^2 = a^2\n")
    assert model.claimed is None and model.degree() is None
    with pytest.raises(ValueError, match="the model m has no template: "):
        model.template()
    with pytest.raises(ValueError, match="nothing was found to certify"):
        model.certificate()
    with pytest.raises(ValueError, match="line 3, column 10: found 'y', .* did you mean 'x'"):
        pointline.Model("model m\nunknown x\nequation y = 1\n")
    with pytest.raises(OSError):
        pointline.Model("no_such_file.model")
