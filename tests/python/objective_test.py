"""What a fit minimises, for optimisers and samplers of one's own."""
import numpy as np
import pytest

import fourpost as fp
from conftest import SOURCE, STARTER


@pytest.fixture(scope="module")
def objective():
    return fp.Study(STARTER / "study.yaml").objective()


def test_its_cost_is_that_of_the_fit(objective, run):
    x = run.parameters["value"].to_numpy()
    assert list(objective.parameters.index) == list(run.parameters.index)
    assert objective.cost(x) == run.cost
    assert objective.count == run.residuals == len(objective.residuals(x))


def test_many_points_in_one_pass_are_those_one_by_one(objective):
    bounds = objective.parameters[["lower", "upper"]].to_numpy()
    x = np.random.default_rng(1).uniform(*bounds.T, size=(5, len(bounds)))
    all_at_once = objective.residuals(x, threads=2)
    assert np.array_equal(all_at_once, [objective.residuals(row) for row in x])
    assert np.array_equal(objective.cost(x), [objective.cost(row) for row in x])


def test_the_jacobian_is_that_of_differences(objective):
    x = objective.parameters["value"].to_numpy()
    jacobian = objective.jacobian(x)
    assert jacobian.shape == (objective.count, len(x))
    step = 1e-4 * x
    points = np.vstack([x + np.diag(step), x - np.diag(step)])
    residuals = objective.residuals(points)
    differences = ((residuals[:len(x)] - residuals[len(x):]) / (2 * step[:, None])).T
    # Residuals are solved to 2e-4, the balance's error, and the model's derivatives are good for steps.
    scale = np.abs(differences).max(axis=0)
    assert np.all(np.abs(jacobian - differences).max(axis=0) < 0.05 * scale)


def test_arrays_in_memory_have_residuals(car):
    frequency = [1, 2, 4]
    response = car.response(frequency=frequency, amplitude=0.01)
    study = fp.Study(car, [fp.SteppedSine(frequency, 0.01, {"a_body": response["a_body"]})], free=["k"])
    objective = study.objective()
    assert objective.count == 6
    # Arrays pass through text that reads back to the same doubles, but as gain and degrees.
    assert np.abs(objective.residuals([car["k"]])).max() < 1e-9
    assert objective.cost([1.1 * car["k"]]) > 1


@pytest.mark.parametrize("call, x, id", [
    ("residuals", [1.0], "table-shape"), ("residuals", [[1.0]], "table-shape"), ("cost", [1.0], "table-shape"),
    ("residuals", [np.nan] * 6, "number-not-finite"), ("jacobian", [1e9] * 6, "value-out-of-range")])
def test_wrong_points_are_refused_by_id(objective, call, x, id):
    with pytest.raises(fp.InputError) as raised:
        getattr(objective, call)(x)
    assert raised.value.ids == [id]


def test_points_without_an_answer_are_nan_among_others(objective):
    x = objective.parameters["value"].to_numpy()
    impossible = x.copy()
    impossible[0] = -x[0]  # a mass
    with pytest.raises(fp.SimulationError) as raised:
        objective.residuals(impossible)
    assert raised.value.ids == ["evaluation-failed"]
    costs = objective.cost(np.array([x, impossible]))
    assert np.isfinite(costs[0]) and np.isnan(costs[1])


def test_residuals_of_ones_own_are_minimised():
    minimum = fp.minimise({"a": (-5, 5, 0.01), "b": fp.Axis(1, 20, 1, discrete=True)},
                          lambda x: [x[0] - 1.23, x[1] - 7], evaluations=2000, target=1e-6)
    assert minimum.values["a"] == pytest.approx(1.23, abs=1e-3) and minimum.values["b"] == 7
    with pytest.raises(fp.SimulationError) as raised:
        fp.minimise({"a": (0, 1, 0.1)}, lambda x: 1 / 0, evaluations=20)
    assert isinstance(raised.value.__cause__, ZeroDivisionError)
    with pytest.raises(fp.InputError) as raised:
        fp.minimise({"a": (1, 0, 0.1)}, lambda x: x)
    assert raised.value.ids == ["search-axes"]
