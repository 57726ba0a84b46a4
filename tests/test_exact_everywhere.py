"""Rods of order "exact" in what is built on the dynamics, in robots of a link or two."""

from functools import cache

import judges
import numpy as np
import pytest
from conftest import package
from fmi_units import Unit, written
from fmpy import simulate_fmu
from fmpy.validation import validate_fmu
from helpers import QUICK, Case, arm, case_of, link, model_of, quick, relative
from test_estimator import as_the_dense_filter
from test_mpc import PLAIN

from screwgen import simulate
from screwgen.integrators import METHODS
from screwgen.runtime.estimator import CompiledEstimator
from screwgen.simulation.motion import centrelines

SOFT = {"EIy": 2.0, "EIz": 1.5, "GJ": 1.0, "rhoIp": 1e-2}
TIP = {"at": "tip", "mass": 0.4, "com": [0.05, 0.0, 0.02], "inertia": [0.01, 0.02, 0.02, 0.0, 0.0, 0.0]}
FREE = np.zeros((1, 6))


def boom(**more) -> dict:
    """A soft rod of two modes on two axes, with a body at its tip."""
    given = {"modes": {"bending_y": 1, "bending_z": 1}, "section": SOFT, "bodies": [TIP]} | more
    return link("boom", 0.8, "yz", joint={"damping": [0.1, 0.1]}, damping={"time": 0.01}, **given)


def robot() -> dict:
    return arm(boom(), order="exact")


@cache
def model():
    return model_of(robot())


def bent(seed: int = 0, size: float = 0.2) -> tuple[np.ndarray, ...]:
    """q, v, tau, w_ext: modal coordinates up to a quarter of the length, slopes of half a radian and more."""
    rng = np.random.default_rng(seed)
    q, v = rng.uniform(-1, 1, 4), rng.uniform(-1, 1, 4)
    q[2:] = size * np.sign(q[2:])
    return q, v, rng.uniform(-1, 1, 2), rng.uniform(-1, 1, (1, 6))


# -------- back ends


def test_jax_has_numpys_values_and_gradients():
    jax = package("jax")
    q, v, tau, w_ext = bent()
    numeric, p = model().numpy(), np.array(model().parameter_values)
    with jax.enable_x64(True):
        f = model().jax()

        def everything(q, v, tau):
            vdot, wrench = f["forward_dynamics"](q, v, tau, w_ext, p)
            slopes = jax.jacrev(lambda *x: f["forward_dynamics"](*x, w_ext, p)[0], argnums=(0, 1, 2))(q, v, tau)
            return vdot, wrench, f["mass_matrix"](q, p), f["inverse_dynamics"](q, v, v, w_ext, p), *slopes

        found = jax.jit(everything)(q, v, tau)
    expected = *numeric.forward_dynamics(q, v, tau, w_ext), numeric.mass_matrix(q)
    expected += numeric.inverse_dynamics(q, v, v, w_ext), *numeric.derivatives(q, v, tau, w_ext)
    for one, other in zip(found, expected, strict=True):
        assert relative(np.reshape(one, np.shape(other)), other) < 1e-11


@pytest.mark.parametrize("target", ["fmu2", "fmu3"])
def test_mock_up_units_run_as_simulations_do(target):
    assert validate_fmu(str(written(target, robot)[1])) == []
    unit = Unit(target, "cs", robot)
    q, v, *_ = bent(1, 0.1)
    start = dict(zip(unit.states, (*q, *v), strict=True))
    names, step = unit.model.q_names, 1e-3
    found = simulate_fmu(
        *(str(written(target, robot)[1]),),
        stop_time=0.02,
        step_size=step,
        output_interval=step,
        start_values=start | {"solver.step": step, "solver.method": 1 + list(METHODS).index("modal_midpoint")},
        output=names,
    )
    run = simulate(model(), 0.02, step, q0=q, v0=v, integrator="modal_midpoint")
    assert relative(np.array([found[name] for name in names]).T, run.q) < 1e-12


def test_the_estimator_is_a_dense_filter():
    stiff = arm(boom(section={"EIy": 30.0, "EIz": 50.0}) | {"damping": {"ratio": 0.01}}, order="exact")
    one = model_of(stiff)
    as_the_dense_filter(one, CompiledEstimator(one, flags=QUICK), 25)


def test_predictive_control_reaches_its_goal(tmp_path):
    (tmp_path / "mpc.toml").write_text(PLAIN.replace("[0.3, 0.2, -0.2]", "[0.2, 0.1]").replace(", 4.0]", "]"))
    table = boom(section={"EIy": 300.0, "EIz": 500.0})
    table["joint"] |= {"armature": [0.5, 0.5]}
    arm_of_it = model_of(arm(table, order="exact", gravity=(0, 0, 0)))
    c = arm_of_it.mpc(tmp_path / "mpc.toml", flags=QUICK)
    q, v = np.zeros(4), np.zeros(4)
    c.initialise(q, v)
    stepper = quick(arm_of_it)
    for _ in range(60):
        c.prepare()
        tau = c.feedback(q, v)
        q, v = stepper.step(q, v, tau, FREE, 0.002, "modal_midpoint", 10)
    assert np.abs(q[:2] - [0.2, 0.1]).max() < 0.02


# -------- derivatives


def test_the_place_of_the_tip_in_linear_models_equals_differences():
    """About a bent posture."""
    q, *_ = bent(4)
    linear, e = model().linearise(q, outputs=("tip_position",)), 1e-6
    place = lambda s: model().numpy().tip_pose(q + s)[1]  # noqa: E731
    expected = np.array([(place(s) - place(-s)) / (2 * e) for s in e * np.eye(4)]).T
    assert relative(linear.C[:, :4], expected) < 1e-8


# -------- trees, loops, floating bases


@cache
def branched() -> Case:
    """A link on a marker in the middle of an exact rod, and one at a place along it."""
    more = {"modes": {"bending_y": 1, "torsion": 1}, "section": SOFT}
    rod = link("rod", 0.8, "z", markers=[{"name": "hook", "at": 0.5}], **more)
    twig = link("twig", 0.4, "y", parent="rod", at="hook", section=SOFT, modes={"bending_z": 1})
    leaf = link("leaf", 0.3, "x", parent="rod", at={"s": 0.8})
    rng = np.random.default_rng(6)
    q, v = rng.uniform(-0.5, 0.5, 6), rng.uniform(-0.5, 0.5, 6)
    q[3:] = 0.15, 0.4, -0.08
    state = {"q": q, "v": v, "tau": rng.normal(size=3), "w_ext": rng.normal(size=(3, 6))}
    return case_of(arm(rod, twig, leaf, order="exact"), {name: x.tolist() for name, x in state.items()})


def test_links_on_markers_in_the_middle_equal_the_oracle():
    judges.numpy_and_casadi(branched())
    judges.c_forms(branched(), "modular")


def test_sensors_at_a_marker_measure_the_motion_of_its_section():
    """Place by the drawn line, velocity and acceleration by differences, strain by the curvature."""
    case = branched()
    (q, v, tau, w_ext), numeric, names = case.inputs, case.model.numpy(), case.model.marker_names
    k, e = names.index("rod.hook"), 1e-5
    R, place = (x[k] for x in numeric.marker_pose(q))
    line = centrelines(case.model, q, [0.0, 0.5, 1.0])[0]
    assert np.allclose(place, line[1], atol=1e-13)
    vdot = numeric.forward_dynamics(q, v, tau, w_ext)[0]
    at = lambda t: numeric.marker_pose(q + v * t + vdot * t * t / 2)[1][k]  # noqa: E731
    twist = numeric.marker_velocity(q, v)[k]
    assert np.allclose(R @ twist[3:], (at(e) - at(-e)) / (2 * e), atol=1e-8)
    felt = (at(1e-4) - 2 * at(0) + at(-1e-4)) / 1e-8 - np.array(case.robot["gravity"])
    assert relative(R @ numeric.accelerometer(q, v, tau, w_ext)[k], felt) < 1e-6
    curvature = case.model.chain.keys[0].shapes("bending_y").evaluate([0.5], 2)[0][0] * q[3] / 0.8**2
    strain = dict(zip(case.model.strain_names, numeric.strain(q), strict=True))
    assert abs(strain["rod.hook.strain.bending_y"] / curvature - 1) < 1e-12


# -------- commands
