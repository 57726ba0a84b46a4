"""Closed loops: against the constrained equations of the oracle, closed forms of linkages, and conservation laws."""

from pathlib import Path

import numpy as np
import pytest
from conformance import numbers
from conftest import swept
from helpers import arm, example, link, model_of
from mixed_arms import case_of
from mixed_loops import JOINTS, looped
from random_robots import joint_count

from screwgen import OpenLoopError, SingularError, UsageError, analyse, assemble, dump, simulate
from screwgen.backends.numpy.closing import moving
from screwgen.cli.main import main
from screwgen.studies.assemble import redundant
from screwgen.studies.modes import mode_shapes

DRAWS = (901, 902, 903, 903, 901, 903, 902)
"""Draws of trees that can follow all that their loops forbid, most of them with drives."""


@pytest.mark.parametrize("seed", swept(range(len(JOINTS)), 3))
def test_random_trees_with_a_loop(seed):
    """Closed or open: where a loop is open both have the same stabilisation."""
    rng, opened = np.random.default_rng([DRAWS[seed], seed]), 0.02 * (seed % 2)
    robot, state = looped(rng, JOINTS[seed], 3 + seed % 3)
    q, v = np.array(state["q"]), np.array(state["v"])
    assert np.max(np.abs(model_of(robot).numpy().gaps(q, None)[0])) < 1e-12
    case = case_of(
        robot, state | {"q": q + opened * rng.normal(size=len(q)) * (np.arange(len(q)) < joint_count(robot))}
    )
    if opened:
        case.judge.state["v"] = v
    numbers.judge(case)
    numbers.casadi(case)
    found = [case.model.numpy().dae_forward_dynamics(*case.given)]
    if seed % 3 == 0:
        found += [
            case.c(("fused", "modular")[seed % 2]).forward_dynamics(*case.given, form=x) for x in ("joint", "dae")
        ]
    assert max(max(case.judge.errors(*x).values()) for x in found) <= case.tolerance


# ------------------------------------------------------------------------------ linkages in closed form

CRANK, COUPLER, ROCKER, GROUND = 0.3, 0.9, 0.6, 0.8


@pytest.fixture(scope="module")
def four_bar():
    """Rigid bars in the x-z plane; angles about y turn x towards -z."""
    bars = [link(name, length, "y", rhoA) for name, length, rhoA in (("crank", CRANK, 2.0), ("coupler", COUPLER, 1.5))]
    rocker = link("rocker", ROCKER, "y", 1.8) | {"parent": "world"}
    rocker["joint"]["mount"] = {"xyz": [GROUND, 0.0, 0.0]}
    hinge = {"between": ["coupler.tip", "rocker.tip"], "joint": {"axes": ["y"]}}
    return model_of(arm(*bars, rocker) | {"loops": [hinge]})


def angles(crank: float) -> np.ndarray:
    """Joint coordinates of the four-bar linkage by the cosine rule (the open branch)."""
    a = np.array([np.cos(crank), np.sin(crank)]) * CRANK
    d = np.array([GROUND, 0.0]) - a
    reach, to_ground = np.hypot(*d), np.arctan2(d[1], d[0])
    coupler = to_ground + np.arccos((reach**2 + COUPLER**2 - ROCKER**2) / (2 * reach * COUPLER))
    tip = a + COUPLER * np.array([np.cos(coupler), np.sin(coupler)])
    rocker = np.arctan2(tip[1], tip[0] - GROUND)
    return -np.array([crank, coupler - crank, rocker])


@pytest.mark.parametrize("loaded", [False, True])
def test_rigid_bars_with_locked_joints_do_not_vibrate(four_bar, loaded):
    found = mode_shapes(four_bar, angles(0.4), loaded=loaded)
    assert found.frequencies.shape == (0,) and found.shapes.shape == (3, 0)


def lagrangian(crank: float, rate: float) -> float:
    """T − U of the linkage from the motion of its bars alone."""
    h = 1e-5
    here, (before, after) = angles(crank), (angles(crank - h), angles(crank + h))
    turn = -rate * (after - before) / (2 * h)
    psi, omega = -np.cumsum(here)[[0, 1]], np.cumsum(turn)[[0, 1]]
    a = CRANK * np.array([np.cos(psi[0]), np.sin(psi[0])])
    v_a = CRANK * omega[0] * np.array([-np.sin(psi[0]), np.cos(psi[0])])
    centre = a + COUPLER / 2 * np.array([np.cos(psi[1]), np.sin(psi[1])])
    v = v_a + COUPLER / 2 * omega[1] * np.array([-np.sin(psi[1]), np.cos(psi[1])])
    m = np.array([2.0 * CRANK, 1.5 * COUPLER, 1.8 * ROCKER])
    kinetic = m[0] * CRANK**2 * omega[0] ** 2 / 6 + m[2] * ROCKER**2 * turn[2] ** 2 / 6
    kinetic += m[1] * (v @ v) / 2 + m[1] * COUPLER**2 * omega[1] ** 2 / 24
    height = m[0] * CRANK * np.sin(psi[0]) / 2 + m[1] * centre[1] - m[2] * ROCKER * np.sin(here[2]) / 2
    return kinetic - 9.81 * height


def test_a_hinge_in_a_planar_linkage_has_two_rows_that_matter(four_bar):
    assert [row.text for row in four_bar.chain.closing.rows] == [f"loop[0], distance along {axis}" for axis in "xz"]
    assert redundant(four_bar) == [
        "loop[0], distance along y",
        "loop[0], angle between x and y",
        "loop[0], angle between z and y",
    ]


def test_a_four_bar_linkage_is_assembled_as_by_the_cosine_rule(four_bar):
    for crank in (0.3, 1.1, 2.0):
        q = assemble(four_bar, angles(crank) + np.array([0.0, 0.1, -0.1]), hold=["crank.joint[0]"])
        assert np.allclose(q, angles(crank), rtol=0, atol=1e-10)


@pytest.mark.parametrize("crank", [0.4, 1.3, 2.2])
def test_a_four_bar_linkage_moves_by_its_own_lagrangian(four_bar, crank):
    """The equation of one coordinate, d/dt ∂L/∂ω − ∂L/∂φ = torque, by differences of sixth order."""
    q, rate, torque, judge = angles(crank), 3.0, 2.0, four_bar.numpy()
    v = moving(judge, q, [-rate, 0.0, 0.0])
    v *= -rate / v[0]
    found = judge.forward_dynamics(q, v, [-torque, 0.0, 0.0], None)[0][0]
    inertia = lambda x: 2 * (lagrangian(x, 1.0) - lagrangian(x, 0.0))  # noqa: E731
    slope = lambda f: sum(c * (f(crank + k * 5e-3) - f(crank - k * 5e-3)) for k, c in SIXTH) / 5e-3  # noqa: E731
    force = torque - slope(inertia) * rate**2 / 2 + slope(lambda x: lagrangian(x, 0.0))
    assert -found == pytest.approx(force / inertia(crank), rel=1e-7)


SIXTH = ((1, 3 / 4), (2, -3 / 20), (3, 1 / 60))


def test_forces_of_the_loop_do_no_work_and_energy_stays(four_bar):
    q = angles(0.4)
    for form, method, drift in (("joint", "rk4", 1e-8), ("dae", "rk4", 1e-8)):
        run = simulate(four_bar, 0.5, 1e-3, q0=q, form=form, integrator=method)
        gaps = [np.max(np.abs(four_bar.numpy().gaps(*x)[0])) for x in zip(run.q[::50], run.v[::50], strict=True)]
        assert max(gaps) < {"joint": 1e-9, "dae": 1e-10}[form]
        total = run.energy.sum(axis=1)
        assert np.ptp(total) < drift * np.ptp(run.energy[:, 0])


def test_a_flexible_parallelogram_keeps_its_platform_level():
    model = example("parallelogram")
    q = assemble(model, [-0.5, 0.5, -0.5], hold=["arm.joint[0]"])
    assert np.allclose(q[:3], [-0.5, 0.5, -0.5], atol=1e-9) and not q[3:].any()


# ------------------------------------------------------------------------------ what users see


def test_the_command_prints_a_state_that_simulate_reads(four_bar, tmp_path, capsys):
    robot, state = str(tmp_path / "arm.toml"), tmp_path / "state.json"
    Path(robot).write_text(dump(four_bar.robot))
    start = ",".join(map(str, angles(0.4) + np.array([0.0, 0.05, 0.0])))
    assert main(["assemble", robot, f"--q={start}", "--hold", "crank.joint[0]"]) == 0
    state.write_text(capsys.readouterr().out)
    run = ["simulate", robot, "--duration", "0.002", "--step", "0.001", "-o", str(tmp_path / "run.npz"), "-q"]
    assert main([*run, "--state", str(state)]) == 0
    state.write_text('{"q": [0.1, 0.0, 0.0]}')
    assert main([*run, "--state", str(state)]) == 2
    assert "loop[0] is open by" in capsys.readouterr().err


def test_loops_that_cannot_be_closed_say_how_far_they_stay_open(four_bar):
    short = model_of(arm(link("a", 0.2, "y", 1.0), link("b", 0.2, "y", 1.0) | FAR) | {"loops": [BALL]})
    with pytest.raises(OpenLoopError, match=r"^loop\[0\] stays open by 0\.1\d* m; start from"):
        assemble(short)
    with pytest.raises(SingularError, match="the loops of 'arm' are singular"):
        short.numpy().forward_dynamics([0.0, np.pi], None, None, None)


def test_loops_of_which_nothing_can_move(four_bar):
    """All axes held in a closed posture and in an open one; a robot without any coordinate."""
    held = [f"{name}.joint[0]" for name in ("crank", "coupler", "rocker")]
    assert np.array_equal(assemble(four_bar, angles(0.4), hold=held), angles(0.4))
    with pytest.raises(OpenLoopError, match=r"^loop\[0\] stays open by"):
        assemble(four_bar, [0.1, 0.2, 0.3], hold=held)
    welded = link("a", 0.3, []), link("b", 0.3, [], parent="world")
    model = model_of(arm(*welded) | {"loops": [{"between": ["a.tip", "b.tip"], "joint": {"axes": []}}]})
    assert model.chain.closing.rows == () and not model.numpy().forward_dynamics([], [], [], None)[0].size


def test_what_closes_to_first_order_alone_is_refused():
    """Two bars in line between hinges; a beam between hinges that does not stretch, which its modes shorten."""
    hinge = {"between": ["b.tip", "wall.base"], "joint": {"axes": ["y"]}}
    two = arm(link("a", 0.5, "y"), link("b", 0.5, "y"), wall(1.0)) | {"loops": [hinge]}
    beam = link("b", 2.0, "y", modes={"bending_z": 2}, section={"EIy": 56.0, "EA": 4e7}, order=2)
    bent = arm(beam, wall(2.0)) | {"loops": [hinge]}
    for robot in (two, bent):
        with pytest.raises(UsageError, match=r"distance along x: opens by .* m in a motion"):
            model_of(robot)
    beam["modes"]["axial"] = 1
    model = model_of(bent)
    assert len(model.chain.closing.rows) == 2
    said = analyse(model, [{}]).text()
    assert "wall: has no mass" in said and "nan" not in said


def wall(x: float) -> dict:
    """A frame of the world at x, for hinges."""
    joint = {"axes": [], "mount": {"xyz": [x, 0.0, 0.0]}}
    return {"name": "wall", "parent": "world", "joint": joint, "bodies": [{"at": "base", "mass": 0.0}]}


FAR = {"parent": "world", "joint": {"axes": ["y"], "mount": {"xyz": [0.5, 0.0, 0.0]}}}
BALL = {"between": ["a.tip", "b.tip"], "joint": {"axes": ["x", "y", "z"]}}
