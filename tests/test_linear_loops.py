"""Equilibria, vibrations and linear models of robots with loops: linkages in closed form, published beams."""

from pathlib import Path

import numpy as np
import pytest
from helpers import arm, link, model_of
from test_loops import COUPLER, CRANK, GROUND, ROCKER, SIXTH, angles, lagrangian

from screwgen import SingularError, UsageError, dump, equilibrium, natural_frequencies
from screwgen.backends.numpy.closing import jacobian, moving
from screwgen.cli.linear import record, text
from screwgen.cli.main import main
from screwgen.simulation.controllers import Holding
from screwgen.simulation.mobility import mobility, stated_joints
from screwgen.studies.convergence import convergence, enriched
from screwgen.studies.modes import mode_shapes

HINGE = {"between": ["coupler.tip", "rocker.tip"], "joint": {"axes": ["y"]}}
BALL = HINGE | {"joint": {"axes": ["x", "y", "z"]}}


def linkage(loop=HINGE, crank=None, coupler=None, rocker=None):
    """The four-bar linkage of test_loops with more stated for its links."""
    bars = [
        link("crank", CRANK, "y", 2.0) | (crank or {}),
        link("coupler", COUPLER, "y", 1.5) | (coupler or {}),
        link("rocker", ROCKER, "y", 1.8) | {"parent": "world"} | (rocker or {}),
    ]
    for bar, more in zip(bars, (crank, coupler, rocker), strict=True):
        bar["joint"] = {"axes": ["y"]} | (more or {}).get("joint", {})
    bars[2]["joint"]["mount"] = {"xyz": [GROUND, 0.0, 0.0]}
    return model_of(arm(*bars) | {"loops": [loop]})


@pytest.fixture(scope="module")
def rigid():
    return linkage()


GEAR = {"ratio": 50.0, "rotor_inertia": 1e-4, "stiffness": 4e3}


@pytest.fixture(scope="module")
def bent():
    """An elastic gear at the crank, a coupler that bends in both planes, a spring at the rocker."""
    bending = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"rhoA": 1.5, "EIy": 300.0, "EIz": 300.0}}
    crank = {"joint": {"drives": [GEAR]}}
    return linkage(BALL, crank, bending, {"joint": {"stiffness": [20.0]}})


def slope(f, x: float, step: float = 5e-3) -> float:
    return sum(c * (f(x + k * step) - f(x - k * step)) for k, c in SIXTH) / step


def inertia(crank: float) -> float:
    return 2 * (lagrangian(crank, 1.0) - lagrangian(crank, 0.0))


def potential(crank: float) -> float:
    return -lagrangian(crank, 0.0)


# ------------------------------------------------------------------------------ a four-bar linkage in closed form


@pytest.mark.parametrize("crank", [0.4, 2.2])
def test_the_torque_that_holds_a_linkage_is_the_slope_of_its_weight(rigid, crank):
    """The joint of the crank is held, the others follow: start away from the closed posture."""
    found = equilibrium(rigid, angles(crank) + np.array([0.0, 0.1, 0.05]), hold=True)
    assert np.allclose(found.q, angles(crank), rtol=0, atol=1e-10)
    assert found.tau[0] == pytest.approx(-slope(potential, crank), rel=1e-9) and not found.tau[1:].any()
    assert found.following == ("coupler.joint[0]", "rocker.joint[0]") and found.passive == ()
    assert Holding(rigid)(angles(crank)) == pytest.approx(found.tau, rel=1e-9)
    vdot, wrench = rigid.numpy().forward_dynamics(found.q, np.zeros(3), found.tau, None)
    assert np.max(np.abs(vdot)) < 1e-9 and np.allclose(found.wrench, wrench, atol=1e-9)
    on_tips = rigid.numpy().loop_wrenches(found.q, np.zeros(3), found.tau, None)
    assert np.allclose(found.loop_wrench, on_tips, atol=1e-9)


def test_a_free_linkage_hangs_where_its_weight_is_lowest(rigid):
    found = equilibrium(rigid, angles(0.4))
    crank = -found.q[0]
    assert found.stability == "stable" and slope(potential, crank) == pytest.approx(0.0, abs=1e-7)
    assert slope(lambda x: slope(potential, x), crank) > 0


@pytest.mark.parametrize("crank", [0.4, 1.3])
def test_loaded_frequencies_have_the_stiffness_of_the_loops_forces(rigid, crank):
    """`I ẍ + U'' x = 0` under a constant torque: at 1.3 rad it gives way."""
    squared = slope(lambda x: slope(potential, x), crank) / inertia(crank)
    found = mode_shapes(rigid, angles(crank), "free", loaded=True)
    assert found.rigid == 0
    assert (2 * np.pi * found.frequencies[0]) ** 2 - found.growth[0] ** 2 == pytest.approx(squared, rel=1e-6)
    assert found.growth.any() == (squared < 0)


def test_a_spring_and_a_gear_swing_a_linkage_at_their_frequency():
    crank, k = 0.4, 20.0
    sprung = linkage(rocker={"joint": {"stiffness": [k]}})
    ratio = slope(lambda x: angles(x)[2], crank)
    expected = np.sqrt(k * ratio**2 / inertia(crank)) / (2 * np.pi)
    assert natural_frequencies(sprung, angles(crank), "free") == pytest.approx([expected], rel=1e-8)
    assert len(natural_frequencies(sprung, angles(crank))) == 0  # the crank is locked, which holds the rocker
    geared = linkage(crank={"joint": {"drives": [GEAR]}})
    rotor, I = GEAR["ratio"] ** 2 * GEAR["rotor_inertia"], inertia(crank)
    q = geared.chain.with_inner(angles(crank), geared.parameter_values)
    stiffness = np.array([GEAR["stiffness"]])
    assert natural_frequencies(geared, q) == pytest.approx(np.sqrt(stiffness / I) / (2 * np.pi), rel=1e-8)
    free = np.sqrt(stiffness * (1 / I + 1 / rotor)) / (2 * np.pi)
    assert natural_frequencies(geared, q, "free") == pytest.approx([0.0, *free], rel=1e-8)


@pytest.mark.parametrize("crank", [0.4, 2.2])
def test_the_linear_model_of_a_moving_linkage_is_that_of_its_lagrangian(rigid, crank):
    """`I ẍ + I' ẋ²/2 + U' = T` of the crank's angle x = −q, T = −τ, differentiated."""
    q, rate, torque = angles(crank), 3.0, 2.0
    v = moving(rigid.numpy(), q, [-rate, 0.0, 0.0])
    v *= -rate / v[0]

    def acceleration(x: float, xdot: float) -> float:
        return (torque - slope(inertia, x) * xdot**2 / 2 - slope(potential, x)) / inertia(x)

    linear = rigid.linearise(q, v, [-torque, 0.0, 0.0], outputs=["joint_angles", "joint_rates"])
    expected = [
        [0.0, 1.0],
        [slope(lambda x: acceleration(x, rate), crank), -slope(inertia, crank) * rate / inertia(crank)],
    ]
    assert linear.state_names == ("crank.joint[0]", "crank.joint_rate[0]")
    assert np.allclose(linear.A, expected, rtol=1e-6, atol=1e-12)
    assert linear.B[1, 0] == pytest.approx(1 / inertia(crank), rel=1e-7)
    follow = np.array([-slope(lambda x, k=k: angles(x)[k], crank) for k in range(3)])
    assert np.allclose(linear.C[:3, 0], follow, rtol=1e-8) and np.allclose(linear.C[3:, 1], follow, rtol=1e-8)
    turned = [-slope(lambda x, k=k: slope(lambda y: angles(y)[k], x), crank) * rate for k in range(3)]
    assert np.allclose(linear.C[3:, 0], turned, rtol=1e-6, atol=1e-7)


# ------------------------------------------------------------------------------ beams

BEAMS = {"clamped": ([], (22.3733, 61.6728, 120.9034)), "hinged": (["y"], (15.4182, 49.9649, 104.2477))}
"""(βl)² of a beam whose one end is clamped, by its other end: in every handbook."""


def propped(axes: list, modes: int):
    """A clamped beam with EI = ρA = l = 1, whose tip a loop joins with that of a stub on the other side."""
    beam = link("beam", 1.0, [], 1.0, {"bending_z": modes}, section={"EIy": 1.0})
    stub = link("stub", 0.1, [], 1.0, joint={"mount": {"xyz": [0.9, 0.0, 0.0]}}) | {"parent": "world"}
    return model_of(arm(beam, stub) | {"loops": [{"between": ["beam.tip", "stub.tip"], "joint": {"axes": axes}}]})


@pytest.mark.parametrize("end", BEAMS)
def test_a_propped_beam_has_the_published_frequencies(end):
    axes, roots = BEAMS[end]
    model = propped(axes, 8)
    found = 2 * np.pi * natural_frequencies(model)
    left = np.linalg.matrix_rank(model.numpy().gap_slopes(model.chain.home))  # the row along a straight beam is idle
    assert len(found) == model.nv - left
    assert found[:2] == pytest.approx(roots[:2], rel=1e-5)


def test_a_loop_that_welds_two_links_makes_one_arm_of_them():
    """The outer half is on a light frame that slides and turns freely; the loop welds the frame to the inner half."""
    soft = {"EIy": 40.0}
    inner, outer = (link(name, 0.6, [], 1.0, {"bending_z": 2}, section=soft) for name in ("inner", "outer"))
    frame = link("frame", 0.1, [{"slide": "x"}, {"slide": "z"}, "y"], 1e-7) | {"parent": "world"}
    weld = {"between": ["inner.tip", "frame.tip"], "joint": {"axes": []}}
    shut, chain = model_of(arm(inner, frame, outer) | {"loops": [weld]}), model_of(arm(inner, outer))
    assert natural_frequencies(shut) == pytest.approx(natural_frequencies(chain), rel=1e-6)
    found, expected = (equilibrium(model, hold=True) for model in (shut, chain))
    assert found.tip_position == pytest.approx(expected.tip_position, abs=1e-8)
    assert found.tip_deflection == pytest.approx(expected.tip_deflection, abs=1e-8) and found.tip_deflection[2] < -0.05
    assert found.wrench[[0, 2]] == pytest.approx(expected.wrench, abs=1e-5)
    loaded = [natural_frequencies(model, loaded=True) for model in (shut, chain)]
    assert loaded[0] == pytest.approx(loaded[1], rel=1e-6)


def test_one_more_mode_is_what_a_model_with_one_more_mode_has():
    model = propped(["y"], 3)
    for options in ({}, {"loaded": True}):
        now = natural_frequencies(model, **options)
        then = natural_frequencies(type(model)(enriched(model.robot)), **options)[: len(now)]
        assert convergence(model, **options).total == pytest.approx(then / now - 1, abs=1e-9)


# ------------------------------------------------------------------------------ flexible linkages


@pytest.fixture(scope="module")
def rest(bent):
    return equilibrium(bent, angles(0.4), hold=True)


def test_a_bent_linkage_rests_in_balance(bent, rest):
    vdot, wrench = bent.numpy().forward_dynamics(rest.q, np.zeros(bent.nv), rest.tau, None)
    assert rest.q[0] == pytest.approx(-0.4, abs=1e-15) and rest.residual < 1e-10 and rest.stability == "stable"
    assert np.max(np.abs(vdot)) < 1e-7 and np.allclose(rest.wrench, wrench, atol=1e-8)
    assert np.max(np.abs(bent.numpy().gaps(rest.q, None)[0])) < 1e-12
    assert rest.passive == ("rocker.joint[0]",) or "rocker.joint[0]" in rest.following
    assert Holding(bent)(rest.q[:3]) == pytest.approx(rest.tau, rel=1e-8)
    assert abs(rest.loop_wrench).max() > 1.0


def test_wrenches_on_tips_are_balanced_too(bent):
    push = np.zeros((3, 6))
    push[1, 3:] = 3.0, 2.0, -4.0
    found = equilibrium(bent, angles(0.4), w_ext=push, hold=True)
    vdot, _ = bent.numpy().forward_dynamics(found.q, np.zeros(bent.nv), found.tau, push)
    assert found.residual < 1e-10 and np.max(np.abs(vdot)) < 1e-6


def test_loaded_frequencies_are_the_eigenvalues_of_the_linear_model(bent, rest):
    """Two ways to the same: the projected stiffness with the loops' forces, and the differentiated motion."""
    linear = bent.linearise(rest.q, tau=rest.tau, outputs=["joint_angles"])
    poles = linear.eigenvalues()
    assert np.max(np.abs(poles.real)) < 1e-6
    poles = poles.imag[poles.imag > 1e-3] / (2 * np.pi)
    found = mode_shapes(bent, rest.q, "free", loaded=True)
    assert found.frequencies == pytest.approx(poles, rel=1e-7)
    J = jacobian(bent.numpy(), rest.q)
    assert np.max(np.abs(J @ found.shapes)) < 1e-8 * np.max(np.abs(found.shapes))
    M = bent.numpy().mass_matrix(rest.q)
    assert np.allclose(found.shapes.T @ M @ found.shapes, np.eye(len(poles)), atol=1e-8)


def test_the_joints_that_are_stated_are_those_with_drives_then_the_first():
    driven = linkage(rocker={"joint": {"armature": [0.1]}})
    stated = lambda crank: stated_joints(driven, angles(crank), driven.parameter_values).tolist()  # noqa: E731
    assert stated(1.3) == [False, False, True]
    assert stated(0.4) == [True, False, False]  # crank and coupler are almost in line, so the rocker cannot state them
    found = mobility(np.array([[1.0, 2.0, 0.0], [2.0, 4.0, 0.0]]), [[[0, 1], [2]]])
    assert found.independent.tolist() == [1, 2] and found.follow.tolist() == [[-2.0, 0.0], [1.0, 0.0], [0.0, 1.0]]


# ------------------------------------------------------------------------------ what users see


def test_the_commands_name_what_is_held_and_what_follows(rigid, tmp_path, capsys):
    robot = str(tmp_path / "arm.toml")
    Path(robot).write_text(dump(rigid.robot))
    assert main(["modes", robot]) == 0  # the closed posture next to zero
    assert "locks crank.joint[0]; coupler.joint[0], rocker.joint[0] follow" in capsys.readouterr().err
    found = equilibrium(rigid, angles(1.3), hold=True)
    assert "rad, follows the loops" in text(rigid, found) and "force on the tip, N" in text(rigid, found)
    told = record(found)
    assert told["following"] == ["coupler.joint[0]", "rocker.joint[0]"] and np.shape(told["loop_wrench"]) == (3, 6)


def test_a_linkage_in_line_is_singular():
    """Crank and rocker of one length, side by side on the ground line: each could turn without the other."""
    crank, coupler, rocker = (link(name, length, "y") for name, length in (("a", 0.3), ("b", 0.5), ("c", 0.3)))
    rocker |= {"parent": "world", "joint": {"axes": ["y"], "mount": {"xyz": [0.5, 0.0, 0.0]}}}
    loop = {"between": ["b.tip", "c.tip"], "joint": {"axes": ["y"]}}
    model = model_of(arm(crank, coupler, rocker) | {"loops": [loop]})
    for study in (natural_frequencies, type(model).linearise, lambda *given: equilibrium(*given, hold=True)):
        with pytest.raises(SingularError, match=r"^the loops of 'arm' are singular in this posture; "):
            study(model, np.zeros(3))


def test_what_loops_cannot_have_is_refused(rigid):
    q, closed_q = [0.0, 0.1, 0.0], angles(0.4)
    for call, said in (
        (lambda: natural_frequencies(rigid, q), r"^q: loop\[0\] is open by 0\.\d+ m; start from"),
        (lambda: rigid.linearise(q), r"^q: loop\[0\] is open by"),
        (lambda: rigid.linearise(closed_q, [1.0, 0.0, 0.0]), r"^v: loop\[0\] opens by 1.2; start at rest"),
        (
            lambda: natural_frequencies(rigid, closed_q, rates=[1.0, 0.0, 0.0]),
            "^robot 'arm' has loops, .* at rates; leave",
        ),
    ):
        with pytest.raises(UsageError, match=said):
            call()
