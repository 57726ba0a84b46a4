"""Linkages that move, among them those whose rows of loops depend on each other wherever they are closed."""

import json
from functools import cache

import mechanisms
import numpy as np
import pytest
from helpers import QUICK, model_of, quick, relative
from linkage_energy import drift, start
from linkage_starts import CLOSED, found, openings

import screwgen
from screwgen import UsageError, assemble, equilibrium, simulate
from screwgen.backends.numpy.closing import moving
from screwgen.cli.main import main
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.controllers import Holding
from screwgen.simulation.estimator import Estimator
from screwgen.simulation.mobility import jacobian
from screwgen.studies.analysis.text import report

OVERCONSTRAINED = ("bennett", "locomotive", "bricard", "sarrus", "double_hooke")


@cache
def linkage(name):
    return model_of(mechanisms.MECHANISMS[name]())


def state(model, seed=0):
    """Closed coordinates, rates that keep them closed, and torques."""
    rng = np.random.default_rng(seed)
    q = assemble(model, 0.1 * rng.normal(size=model.nq))
    return q, moving(model.numpy(), q, rng.normal(size=model.nv)), rng.normal(size=model.n_tau)


def motions(model, q):
    """Orthonormal rates (nv, d) that keep the loops closed."""
    U, sizes, _ = np.linalg.svd(jacobian(model, q, model.parameter_values).T)
    return U[:, int(np.sum(sizes > 1e-7 * sizes[0])) :]


def slope(at, values):
    """At the first of three places, of the parabola through the values there."""
    first, second = (at[k] * (np.array(values[k]) - values[0]) / at[k] ** 2 for k in (1, 2))
    return (at[2] * first - at[1] * second) / (at[2] - at[1])


# ------------------------------------------------------------------------------ closed postures


@pytest.mark.parametrize("starts", [3, pytest.param(30, marks=pytest.mark.long)])
@pytest.mark.parametrize("name", mechanisms.MECHANISMS)
def test_random_starts_end_closed_or_say_that_they_do_not(name, starts):
    model, rng = linkage(name), np.random.default_rng(1)
    ends = [q for q in (found(model, rng) for _ in range(starts)) if q is not None]
    assert len(ends) > starts / 2 and max(openings(model, q) for q in ends) < CLOSED


@pytest.mark.parametrize("name", ["hooke", "bennett", "spherical", "other_bennett"])
def test_the_mismatch_of_an_open_loop_is_that_of_its_frames(name):
    """Every loop is a hinge: it is open by the distance of its points and by the chord of its axes' angle."""
    model, rng = linkage(name), np.random.default_rng(2)
    q = rng.uniform(-1.0, 1.0, model.nq)
    ((metres, turns),) = model.numpy().mismatch(q)
    assert abs(max(metres, turns) - openings(model, q)) < 1e-12 and max(metres, turns) > 0.01


# ------------------------------------------------------------------------------ rows that depend on each other


@pytest.mark.parametrize("name", OVERCONSTRAINED)
def test_derivatives_along_motions_are_those_of_closed_postures(name):
    """The slope of the parabola through the accelerations at three postures, two of which `assemble` closes."""
    model = linkage(name)
    (q, v, tau), numeric = state(model), model.numpy()
    by_q, by_v, by_tau = numeric.derivatives(q, v, tau, None)
    acceleration = lambda x: numeric.forward_dynamics(x, moving(numeric, x, v), tau, None)[0]  # noqa: E731
    for N in motions(model, q).T:
        places = [q, *(assemble(model, q + step * N) for step in (1e-3, -1e-3))]
        at = np.array([N @ (x - q) for x in places])
        expected, turned = (slope(at, [f(x) for x in places]) for f in (acceleration, lambda x: moving(numeric, x, v)))
        assert relative(by_q @ N + by_v @ turned, expected) < 1e-4
    more = numeric.forward_dynamics(q, v, tau + np.eye(model.n_tau)[0], None)[0]
    less = numeric.forward_dynamics(q, v, tau - np.eye(model.n_tau)[0], None)[0]
    assert relative(by_tau[:, 0], (more - less) / 2) < 1e-8


@pytest.mark.parametrize("name", ["bennett", "locomotive"])
def test_compiled_derivatives_are_those_of_numpy(name):
    model = linkage(name)
    q, v, tau = state(model)
    _, *own = quick(model, derivatives=True).linearise(q, v, tau)
    for a, b in zip(own, model.numpy().derivatives(q, v, tau, None), strict=True):
        assert relative(a, b) < 1e-8


@pytest.mark.parametrize("name", ["bennett", "locomotive", "sarrus"])
def test_derivatives_of_wrenches_follow_how_rows_share_forces(name):
    """By differences along every coordinate, which opens loops too, and along motions, where slopes are far smaller."""
    model = linkage(name)
    (q, v, tau), c = state(model), quick(model, derivatives=True)
    wrench, *found = c.linearise_wrenches(q, v, tau)
    assert relative(wrench.ravel(), c.forward_dynamics(q, v, tau)[1].ravel()) < 1e-10
    for by, (exact, h) in enumerate(zip(found, (1e-5, 1e-3, 1.0), strict=True)):
        exact = exact.reshape(wrench.size, -1)
        ways = [np.eye(exact.shape[1]), *([motions(model, q)] if by == 0 else [])]
        for way in ways:

            def at(t, way=way, by=by):
                x = [q, v, tau]
                return np.ravel(c.forward_dynamics(*(y + t if k == by else y for k, y in enumerate(x)))[1])

            ends = [[at(s * h * e) for e in way.T] for s in (-2, -1, 1, 2)]
            a, b, d, e = (np.array(end).T for end in ends)
            assert relative(exact @ way, (a - 8 * b + 8 * d - e) / (12 * h)) < 1e-5, "qvt"[by]


@pytest.mark.parametrize(("name", "tolerance"), [("watt", 1e-12), ("sarrus", 1e-5)])
def test_outputs_of_a_linear_model_follow_the_derivatives_of_wrenches(name, tolerance):
    """At rest, where dependent coordinates follow by the motions alone; those in C share nothing with the linear model.

    Where rows share forces, rounding in the motions meets slopes a million times as large."""
    model = linkage(name)
    q, _, tau = state(model)
    linear = model.linearise(q, np.zeros(model.nv), tau, outputs=("wrenches",))
    _, by_q, by_v, by_tau = quick(model, derivatives=True).linearise_wrenches(q, np.zeros(model.nv), tau)
    own = [model.v_names.index(name) for name in linear.state_names[len(linear.A) // 2 :]]
    N = motions(model, q)
    N = N @ np.linalg.inv(N[own])
    expected = np.hstack([by_q.reshape(-1, model.nv) @ N, by_v.reshape(-1, model.nv) @ N])
    assert relative(linear.C, expected) < tolerance
    assert relative(linear.D, by_tau.reshape(len(expected), -1)) < tolerance


@pytest.mark.parametrize("name", OVERCONSTRAINED)
def test_rest_is_the_same_in_statics_and_in_dynamics(name):
    """Torques that hold a posture leave no acceleration, and rows share their forces alike."""
    model = linkage(name)
    rest = equilibrium(model, state(model)[0][: model.n_joints], hold=True)
    still, numeric = np.zeros(model.nv), model.numpy()
    vdot, wrench = numeric.forward_dynamics(rest.q, still, rest.tau, None)
    assert np.max(np.abs(vdot)) < 1e-8
    assert relative(numeric.loop_wrenches(rest.q, still, rest.tau, None), rest.loop_wrench) < 1e-6
    assert relative(wrench, rest.wrench) < 1e-6
    assert len(rest.following) == model.n_joints - motions(model, rest.q).shape[1]


@pytest.mark.parametrize("name", ["bennett", "three_rockers", "watt"])
def test_gravity_compensation_holds_a_linkage_where_it_is(name):
    """With the torque of the joints that may be stated alone; nothing accelerates."""
    model = model_of(mechanisms.MECHANISMS[name]())
    q, rest = np.zeros(model.nq), np.zeros(model.nv)
    falling = model.numpy().forward_dynamics(q, rest, None, None)[0]
    held = model.numpy().forward_dynamics(q, rest, Holding(model)(q), None)[0]
    assert np.max(np.abs(held)) < 1e-9 * np.max(np.abs(falling))


def test_a_linear_model_of_an_overconstrained_linkage_has_the_frequency_of_its_fall():
    """Of the Bennett linkage at rest under its weight, by the second difference of its energy along its motion."""
    model = linkage("bennett")
    rest = equilibrium(model)
    linear, numeric, step = model.linearise(rest.q), model.numpy(), 1e-3
    assert linear.A.shape == (2, 2)
    (N,) = motions(model, rest.q).T
    ends = [assemble(model, rest.q + s * step * N) for s in (1, -1)]
    heights = [numeric.energy(x, np.zeros(model.nv))[1] for x in (ends[0], rest.q, ends[1])]
    along = (ends[0] - ends[1]) / 2
    stiffness, inertia = heights[0] - 2 * heights[1] + heights[2], along @ numeric.mass_matrix(rest.q) @ along
    assert abs(-linear.A[1, 0] / (stiffness / inertia) - 1) < 1e-4


@pytest.mark.parametrize("name", ["bennett", "locomotive"])
def test_the_filter_keeps_an_overconstrained_linkage_closed(name):
    """In NumPy and in C, which are the same."""
    model = linkage(name)
    q, v, tau = state(model)
    noise, rng, still = Noise(0.02, encoder=1e-3), np.random.default_rng(3), np.zeros((model.n_links, 6))
    filters = Estimator(model), CompiledEstimator(model, flags=QUICK)
    for e in filters:
        e.start(q, v, 1e-2, 1e-2, noise)
    for _ in range(5):
        measured = q + 1e-3 * rng.normal(size=model.n_joints)
        for e in filters:
            e.predict(tau, still, 1e-3)
            e.update(tau, still, encoder=measured)
    (here, there), P = (e.state for e in filters), filters[0].covariance
    assert openings(model, here[0]) < 1e-9 and openings(model, there[0]) < 1e-9
    assert max(relative(a, b) for a, b in zip(there, here, strict=True)) < 1e-6
    J = jacobian(model, here[0], model.parameter_values)
    assert np.max(np.abs(J @ P[: model.nv, : model.nv] @ J.T)) < 1e-12 and np.trace(P) > 1e-9
    assert relative(filters[1].covariance, P) < 1e-6


def test_acados_is_refused_where_forces_of_rows_are_not_unique():
    with pytest.raises(UsageError, match=r"'bennett' is overconstrained.*no export to acados.*compiled C"):
        linkage("bennett").acados()
    linkage("hooke").acados()


def test_an_analysis_counts_the_rows_that_are_shared_and_the_coordinates_that_move():
    model = linkage("bennett")
    analysis = screwgen.analyse(model, [{"q": [0.0] * model.nq}])
    (found,), said = analysis.states, " ".join(report(analysis).split())
    assert found.well_posed and (found.loops.rank, found.loops.size) == (2, 5)
    assert "their 5 rows have rank 2 and share what they bear. 1 coordinate of 3 moves" in said


# ------------------------------------------------------------------------------ energy


@pytest.mark.parametrize(("method", "bound"), [("rk4", 1e-4), ("modal_midpoint", 1e-3)])
@pytest.mark.parametrize("form", ["joint", "dae"])
@pytest.mark.parametrize("name", ["bennett", "bricard"])
def test_energy_stays_over_a_second_of_steps_of_a_millisecond(name, form, method, bound):
    """In compiled C, over the largest kinetic energy; the DAE form closes the loops after every step."""
    energy, apart = drift(name, method, form, 1.0, 1e-3)
    assert energy < bound and apart < (1e-5 if form == "joint" else 1e-12)


def test_a_run_in_c_is_that_in_numpy():
    model = linkage("bennett")
    runs = [simulate(model, 0.02, 1e-3, v0=start(model)[1], backend=backend) for backend in ("c", "numpy")]
    assert np.max(np.abs(runs[0].q - runs[1].q)) < 1e-10


# ------------------------------------------------------------------------------ links that must bend

BENT = """
name = "bent"
gravity = [0.0, 0.0, -9.81]
[[links]]
name = "post"
length = 0.3
section = { rhoA = 2.0 }
joint = { axes = [], mount = { rpy = [0.0, -1.3, 0.0] } }
[[links]]
name = "coupler"
length = 1.6
section = { rhoA = 1.5, EIy = 200.0 }
modes = { bending_z = 1 }
markers = [{ name = "middle", at = 0.5 }]
joint = { axes = ["y"], mount = { rpy = [0.0, 1.3, 0.0] } }
[[links]]
name = "second"
parent = "world"
length = 0.3
section = { rhoA = 1.8 }
joint = { axes = ["y"], mount = { xyz = [0.8, 0.0, -0.0096], rpy = [0.0, -1.3, 0.0] } }
[[links]]
name = "third"
parent = "world"
length = 0.3
section = { rhoA = 1.8 }
joint = { axes = ["y"], mount = { xyz = [1.6, 0.0, 0.0], rpy = [0.0, -1.3, 0.0] } }
[[loops]]
between = ["coupler.middle", "second.tip"]
joint = { axes = ["y"] }
[[loops]]
between = ["coupler.tip", "third.tip"]
joint = { axes = ["y"] }
"""


def test_loops_that_bent_links_alone_close_are_assembled_and_come_to_rest(tmp_path, capsys):
    """Three supports, the middle one 10 mm too low: straight links leave the loop open."""
    file = tmp_path / "bent.toml"
    file.write_text(BENT)
    assert main(["assemble", str(file)]) == 0
    said = capsys.readouterr()
    model, q = screwgen.derive(screwgen.load(file)), json.loads(said.out)["q"]
    assert openings(model, np.array(q)) < CLOSED and max(np.abs(q[3:])) > 1e-4
    assert "note: loop[0], distance along y: follows from the other rows and is left out" in said.err
    assert "loops close with bent links alone: coupler.eta.bending_z[0]" in said.err
    with pytest.warns(screwgen.ModelValidityWarning):
        assert equilibrium(model).stability == "stable"
    (tmp_path / "state.json").write_text(json.dumps({"q": q}))
    assert main(["assemble", str(file), "--state", str(tmp_path / "state.json")]) == 0
    said = capsys.readouterr()
    assert np.allclose(json.loads(said.out)["q"], q, atol=1e-12) and "alone" not in said.err
