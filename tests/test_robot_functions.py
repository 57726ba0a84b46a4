"""The functions that every back end offers: alike in NumPy, CasADi, JAX and C, and what of them a run reports."""

import dataclasses

import numpy as np
import pytest
from conftest import package, swept
from helpers import Case, drawn, example, quick, relative

from docs.tools import functions_page
from screwgen import rollout, simulate
from screwgen.algorithms.entry_names import entry_names, entry_units
from screwgen.algorithms.robot_functions import BY_NAME, FUNCTIONS, OUTPUTS, is_matrix, offered, reported, shape
from screwgen.algorithms.signals import Signal

EXAMPLES = ("ella", "bucket", "crane_loop", "elastic_joint", "space_arm", "gantry")
SEEDS = range(8600, 8616)


def arguments(model, row) -> list:
    """A state that is no special one, and what acts in it."""
    chain, rng = model.chain, np.random.default_rng(4)
    q = model.chain.complete(chain.home[chain.base_q :][: chain.n_joints], model.parameter_values)
    sizes = {"v": chain.nv, "vdot": chain.nv, "tau": chain.n_tau}
    given = {name: rng.normal(size=size) for name, size in sizes.items()}
    given |= {"q": np.array(q, float), "w_ext": rng.normal(size=(chain.n, 6))}
    return [given[name] for name in row.names]


def parts(found) -> list[np.ndarray]:
    return [np.asarray(x, float) for x in (found if isinstance(found, tuple | list) else [found])]


@pytest.mark.parametrize("row", FUNCTIONS, ids=lambda row: row.name)
@pytest.mark.parametrize("name", EXAMPLES)
def test_numpy_casadi_jax_and_c_give_the_same(name, row):
    """CasADi has a column where the others have a row."""
    model = example(name)
    if row not in offered(model.chain):
        assert row.name not in model.casadi()
        return
    jax, given, p = package("jax"), arguments(model, row), model.parameter_values
    expected = parts(getattr(model.numpy(), row.name)(*given))
    assert [x.shape for x in expected] == [shape(of, model.chain) for of in row.results.values()]
    columns = [x.T if x.ndim == 2 else x for x in given]
    for of, found, y in zip(row.results.values(), model.casadi()[row.name].call([*columns, p]), expected, strict=True):
        matrix = found.full()
        across = np.hstack(list(y)) if y.ndim == 3 else y if is_matrix(of) else y.T if y.ndim == 2 else y
        assert relative(matrix.reshape(np.shape(across)), across) < 1e-9
    with jax.enable_x64(True):
        for found, y in zip(parts(model.jax()[row.name](*given, np.array(p))), expected, strict=True):
            assert found.shape == y.shape and relative(found, y) < 1e-9
    if row.c_file:
        named = dict(zip(row.names, given, strict=True))
        for found, y in zip(parts(getattr(quick(model), row.name)(**named)), expected, strict=True):
            assert found.shape == y.shape and relative(found, y) < 1e-11


@pytest.fixture(params=swept(SEEDS, 8601, 8603))
def case(request) -> Case:
    more = {"drives": 0.6, "cylinders": 0.5, "linkages": 0.4, "sliding": 0.2, "branching": 0.3}
    return drawn(request.param, 1 + request.param % 4, **more)


def test_the_drives_give_the_power_by_which_they_change_the_motion(case):
    """``vᵀ M (vdot - vdot without torques) = Σ P``, which knows nothing of drives but their accelerations."""
    (q, v, tau, w_ext), numeric = case.inputs, case.model.numpy()
    power = numeric.drive_power(q, v, tau)
    moved = numeric.forward_dynamics(q, v, tau, w_ext)[0] - numeric.forward_dynamics(q, v, 0 * tau, w_ext)[0]
    scale = np.abs(v) @ np.abs(numeric.mass_matrix(q)) @ np.abs(moved) + np.abs(power).sum()
    assert abs(v @ numeric.mass_matrix(q) @ moved - power.sum()) < case.tolerance * scale
    assert (
        relative(case.model.casadi()["drive_power"](q, v, tau, case.model.parameter_values).full().ravel(), power)
        < 1e-12
    )


@pytest.mark.parametrize("backend", ["c", "numpy"])
@pytest.mark.parametrize("name", ["bucket", "elastic_joint"])
def test_a_run_has_what_is_reported_at_its_samples(name, backend):
    model = example(name)
    torque = np.linspace(1.0, 2.0, model.n_tau)
    run = simulate(model, 0.02, 1e-3, controller=torque, backend=backend)
    for row in reported(model.chain):
        expected = [np.hstack(parts(getattr(model.numpy(), row.name)(*(x[name][k] for name in row.names))))
                    for x in [run.arrays] for k in range(len(run.t))]  # fmt: skip
        assert relative(getattr(run, row.name), np.array(expected)) < 1e-9
        own = [run.columns.index(name) for name in entry_names(row, run.tau_names)]
        assert np.array_equal(run.table[:, own], getattr(run, row.name))


def test_a_rollout_reports_what_runs_do():
    model = example("bucket")
    torque = np.ones(model.n_tau)
    run = simulate(model, 0.01, 1e-3, controller=torque, integrator="rk4")
    many = rollout(model, np.r_[run.q[0], run.v[0]], torque, step=1e-3, steps=10, integrator="rk4")
    for row in reported(model.chain):
        assert relative(getattr(many, row.name)[0], getattr(run, row.name)) < 1e-9


def test_the_page_lists_every_function():
    """`python docs/tools/functions_page.py` writes them."""
    page = functions_page.PAGE.read_text(encoding="utf-8")
    assert functions_page.table(page) == page
    assert all(f"\n| `{row.name}` | " in page for row in FUNCTIONS)


def test_entries_of_vectors_have_names_and_units():
    signals = {"linear": Signal((3,), "kg*m/s", "-", ""), "turn": Signal((), "kg*m^2/s", "-", "")}
    row = dataclasses.replace(BY_NAME["energy"], name="momentum", results=signals)
    names = ["momentum.linear.x", "momentum.linear.y", "momentum.linear.z", "momentum.turn"]
    assert list(entry_names(row, ())) == names
    assert entry_units(row, example("bucket").chain) == ["kg·m/s"] * 3 + ["kg·m²/s"]


def test_what_nothing_reports_is_no_attribute():
    model = example("ella")
    run = simulate(model, 1e-3, 1e-3)
    for x in (model.numpy(), run, rollout(model, np.zeros(2 * model.nq), step=1e-3, steps=1), quick(model)):
        with pytest.raises(AttributeError, match="has no attribute 'powers'"):
            _ = x.powers


def test_results_that_are_reported_have_names_of_their_own():
    """`evaluate` prints them side by side, by their names alone."""
    names = [name for row in FUNCTIONS if row.c_file == OUTPUTS for name in row.results]
    assert len(set(names)) == len(names) > 2
