"""Rods of order "exact" in every back end and in all that is built on the dynamics, in robots of a link or two."""

import json
from functools import cache
from pathlib import Path

import judges
import numpy as np
import pytest
from batch_c import batch, one_by_one, scalar, scenarios, stepped
from conftest import package
from fmi_units import Unit, written
from fmpy import simulate_fmu
from fmpy.validation import validate_fmu
from helpers import QUICK, Case, arm, casadi_forward, case_of, link, model_of, quick, quick_batch, relative
from oracle import Oracle
from oracle_floating import draw
from robot_toml import to_toml
from step_judges import by_differences
from step_judges import worst as worst_block
from test_estimator import as_the_dense_filter
from test_loops import constrained, looped, moving
from test_mpc import PLAIN

from screwgen import rollout, simulate
from screwgen.cli.main import main
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


def test_lanes_of_a_batch_step_bit_for_bit_as_the_scalar_code():
    given = scenarios("exact", 5)
    for method in ("rk4", "modal_midpoint"):
        path, status, *_ = stepped(batch("exact"), *given, method)
        assert not status.any() and np.array_equal(path[:, -1], one_by_one(scalar("exact"), *given, method)), method


def test_rollouts_move_as_simulations_do():
    quick_batch(model())
    states = [np.concatenate(bent(seed)[:2]) for seed in range(3)]
    run = rollout(model(), np.array(states), step=1e-3, steps=10)
    for k, x in enumerate(states):
        other = simulate(model(), 0.01, 1e-3, q0=x[:4], v0=x[4:])
        assert relative(run.q[k], other.q) < 1e-11 and relative(run.energy[k], other.energy) < 1e-9


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


@pytest.mark.parametrize("method", ["modal_midpoint", pytest.param("rk4", marks=pytest.mark.long)])
def test_derivatives_of_a_step_equal_differences(method):
    x = (*bent(2),)
    compiled = quick(model(), derivatives=True)
    _, _, *AB = compiled.step_derivatives(*x, 0.005, method)
    assert worst_block(AB, by_differences(model(), method, *x, 0.005), 4) < 1e-9


def test_slopes_of_wrenches_equal_differences():
    q, v, tau, w_ext = bent(3)
    numeric, e = model().numpy(), 1e-6
    wrench, *slopes = quick(model(), derivatives=True).linearise_wrenches(q, v, tau, w_ext)
    at = lambda *x: numeric.forward_dynamics(*x, w_ext)[1]  # noqa: E731
    assert relative(wrench, at(q, v, tau)) < 1e-12
    for slope, change in zip(slopes[:2], (lambda s: (q + s, v, tau), lambda s: (q, v + s, tau)), strict=True):
        expected = [(at(*change(s)) - at(*change(-s))) / (2 * e) for s in e * np.eye(4)]
        assert relative(np.moveaxis(slope, 2, 0), np.array(expected)) < 1e-7


def test_linear_models_equal_differences():
    """About a bent posture: the rows of the rates, and of the place of the tip."""
    judges.differences(model(), *bent(4))
    q, *_ = bent(4)
    linear, e = model().linearise(q, outputs=("tip_position",)), 1e-6
    place = lambda s: model().numpy().tip_pose(q + s)[1]  # noqa: E731
    expected = np.array([(place(s) - place(-s)) / (2 * e) for s in e * np.eye(4)]).T
    assert relative(linear.C[:, :4], expected) < 1e-8


# -------- trees, loops, floating bases


def test_closed_loops_equal_the_oracle():
    rng = np.random.default_rng(7)
    made, state = looped(rng, ["y"], 2, exact=1.0)
    assert any(x.get("order") == "exact" and "modes" in x for x in made["links"])
    closed, oracle = model_of(made), Oracle(made)
    numeric = closed.numpy()
    q = np.array(state["q"])
    state["v"] = moving(numeric, q, state["v"])
    given = q, state["v"], state["tau"], state["w_ext"]
    expected = constrained(oracle, made, state)
    compiled = quick(closed)
    found = {
        "NumPy": numeric.forward_dynamics(*given)[0],
        "NumPy, DAE": numeric.dae_forward_dynamics(*given)[0],
        "CasADi": casadi_forward(closed, *given)[0],
        "C": compiled.forward_dynamics(*given)[0],
    }
    assert {name: x for name, x in found.items() if relative(x, expected) > 1e-9} == {}


@pytest.mark.parametrize("seed", [0, 1])
def test_a_floating_base_equals_the_oracle(seed):
    """The base itself is an exact rod, or carries one."""
    case = draw(7100 + seed, 1 + seed, exact=1.0, max_modes=1, rigid=0.0, branching=0.5)
    assert case.model.chain.floating and any(key.order == "exact" for key in case.model.chain.keys)
    numeric = case.model.numpy()
    found = [numeric.forward_dynamics(*case.given), numeric.dae_forward_dynamics(*case.given)]
    found += [casadi_forward(case.model, *case.given), quick(case.model).forward_dynamics(*case.given)]
    assert max(x for one in found for x in case.errors(*one).values()) < case.tolerance


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


@pytest.mark.parametrize("basis", ["clamped_free", "polynomial"])
def test_both_bases_are_compiled(basis):
    modes = {"basis": basis, "bending_y": 2, "bending_z": 1}
    made = arm(boom(modes=modes, frame_at=0.3), order="exact")
    q, v, tau, w_ext = bent(5)
    state = {"q": [*q, 0.1], "v": [*v, 0.3], "tau": tau.tolist(), "w_ext": w_ext.tolist()}
    judges.numpy_and_casadi(case_of(made, state))
    judges.c_forms(case_of(made, state), "fused")


# -------- commands

COMMANDS = {
    "modes robot.toml": "Hz",
    "equilibrium robot.toml --hold": "tip",
    "analyse robot.toml --samples 0": "Spectrum",
    "evaluate robot.toml --state state.json --form dae": "boom",
    "simulate robot.toml --duration 0.01 --step 0.001 -o run.npz": "",
    "latex robot.toml -o equations.html": "",
    "generate robot.toml -o out --target casadi": "",
    "view run.npz -o run.html": "",
}


def test_commands_take_exact_rods(capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    Path("robot.toml").write_text(to_toml(robot()))
    Path("state.json").write_text(json.dumps({"q": bent(6)[0].tolist()}))
    for line, said in COMMANDS.items():
        assert main(line.split()) == 0, line
        out, err = capsys.readouterr()
        assert said in out, line
        assert "screwgen: warning" not in err, (line, err)
    page = Path("equations.html").read_text(encoding="utf-8")
    assert "Section of the rod" in page and "Load of a section on the modes" in page
