"""Arms at rest: against the independent Lagrangian's forces, energies and wrenches, and against closed forms."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
import random_robots as rr
from helpers import ROOT, G, arm, example, link, model_of
from oracle import Oracle
from scipy.optimize import brentq

from screwgen import NoEquilibriumError, Robot, SingularError, UsageError, dump, equilibrium
from screwgen.cli.main import main
from screwgen.simulation.state import read_state

ELLA = str(ROOT / "examples" / "ella_paper.toml")
STIFF = {"soft": 0.0, "max_modes": 1, "max_axes": 2}
"""Robots that bend as small deflections do."""


def drawn(seed: int, kind=rr.random_robot, **limits):
    """A robot, its model and its judge; joint angles; wrenches on the tips."""
    rng = np.random.default_rng(seed)
    robot = kind(rng, 1 + seed % 3, **limits)
    state = rr.random_state(rng, robot)
    oracle = Oracle(robot)
    return robot, model_of(robot), oracle, np.array(state["q"][: oracle.n_joint]), np.array(state["w_ext"])


def heavy(rng, n: int, **limits) -> dict:
    """Payloads of ten times a link's mass, on links that bear them."""
    robot = rr.random_robot(rng, n, bodies=0.0, **limits)
    for table in robot["links"]:
        table["section"] |= {k: 20 * v for k, v in table["section"].items() if k in ("EIy", "EIz")}
        table["bodies"] = [rr.random_body(rng, "tip", mass=float(rng.uniform(5.0, 12.0)))]
    return robot


def unbalanced(oracle: Oracle, e, w_ext=None) -> float:
    """The largest generalised force that is left over, over the largest there is."""
    force = oracle.bias(e.q, np.zeros(oracle.nv), w_ext)
    load = np.append(e.tau, np.zeros(oracle.nv - oracle.n_joint))
    size = max(np.max(np.abs(x), initial=0.0) for x in (load, oracle.K @ e.q, force))
    return float(np.max(np.abs(force - load), initial=0.0) / (size or 1.0))


def potential(oracle: Oracle, q, tau) -> float:
    """Potential energy less the work of the torques."""
    return oracle.energy(q, np.zeros(oracle.nv))[1] - tau @ q[: oracle.n_joint]


def lowest(oracle: Oracle, e, moving: slice, seed: int) -> bool:
    """Whether the oracle's energy is larger everywhere near."""
    rng, here, steps = np.random.default_rng(seed), potential(oracle, e.q, e.tau), []
    for _ in range(40):
        step = np.zeros(oracle.nv)
        step[moving] = 1e-3 * rng.normal(size=len(step[moving]))
        steps.append(potential(oracle, e.q + step, e.tau) - here)
    return min(steps) > 0


# -------- random robots


@pytest.mark.parametrize("kind", [rr.random_robot, heavy])
@pytest.mark.parametrize("seed", range(2))
def test_held_joints(seed, kind):
    _, model, oracle, q, w_ext = drawn(seed, kind, **STIFF)
    e = equilibrium(model, q, hold=True)
    assert e.residual <= 1e-10 and unbalanced(oracle, e) < 1e-10
    assert np.array_equal(e.q[: oracle.n_joint], q) and e.held and e.stability == "stable"
    assert oracle.nv == oracle.n_joint or lowest(oracle, e, slice(oracle.n_joint, None), seed)
    rest = np.zeros(oracle.nv)
    expected = oracle.wrenches(e.q, rest, rest)
    assert np.allclose(e.wrench, expected, rtol=0, atol=1e-10 * max(np.abs(expected).max(), 1.0))
    straight = np.append(q, rest[oracle.n_joint :])
    assert np.allclose(e.tip_position, oracle.tip_pose(e.q)[1], atol=1e-12)
    assert np.allclose(e.tip_deflection, oracle.tip_pose(e.q)[1] - oracle.tip_pose(straight)[1], atol=1e-12)
    loaded = equilibrium(model, q, w_ext=w_ext, hold=True)
    assert loaded.residual <= 1e-10 and unbalanced(oracle, loaded, w_ext) < 1e-10


@pytest.mark.parametrize("kind", [rr.random_robot, heavy])
@pytest.mark.parametrize("seed", range(10, 13))
def test_free_joints_come_to_rest_at_the_bottom(seed, kind):
    robot, model, oracle, q, _ = drawn(seed, kind, **STIFF)
    e = equilibrium(model, q)
    assert e.residual <= 1e-10 and unbalanced(oracle, e) < 1e-10 and not e.tau.any()
    if any(robot["gravity"]):
        assert e.stability in ("stable", "neutral")
    if e.stability == "stable":
        assert lowest(oracle, e, slice(None), seed)


@pytest.mark.parametrize("seed", range(2))
def test_the_torques_that_hold_a_posture_keep_it(seed):
    """Given back as torques, from the same posture: the same equilibrium, and no acceleration by NumPy's dynamics."""
    _, model, _, q, w_ext = drawn(seed, **STIFF, rhoIp=1.0, welded=0.0)
    for load in (None, w_ext):
        held = equilibrium(model, q, w_ext=load, hold=True)
        again = equilibrium(model, held.q, held.tau, load)
        assert np.allclose(again.q, held.q, atol=1e-9)
        rest, wrenches = np.zeros(model.nq), np.zeros((model.n_links, 6)) if load is None else load
        vdot, wrench = model.numpy().forward_dynamics(held.q, rest, held.tau, wrenches)
        assert np.allclose(wrench, held.wrench, atol=1e-7 * np.abs(wrench).max())
        linear = model.linearise(held.q, tau=held.tau, w_ext=wrenches)
        assert np.abs(linear.vdot).max(initial=0.0) < 1e-6 and np.allclose(linear.vdot, vdot, atol=1e-6)


@pytest.mark.parametrize("seed", (20, 21, 23))
def test_stability_is_what_the_poles_say(seed):
    """Without damping: a pole in the right half plane if and only if the verdict is so, wrenches that turn included."""
    robot, *_ = drawn(seed, **STIFF, rhoIp=1.0)
    for table in robot["links"]:
        table.pop("damping", None)
        table["joint"].pop("damping", None)
    model, rng = model_of(robot), np.random.default_rng(seed)
    q, w_ext = rng.uniform(-2, 2, model.n_joints), rng.uniform(-5, 5, (model.n_links, 6))
    for load in (None, w_ext):
        e = equilibrium(model, q, w_ext=load, hold=True)
        free = equilibrium(model, e.q, e.tau, load)
        poles = model.linearise(free.q, tau=free.tau, w_ext=w_ext if load is not None else None).eigenvalues()
        squares = poles**2
        grows = max(np.max(squares.real), np.max(np.abs(squares.imag))) > 1e-5 * max(1.0, np.abs(squares).min())
        assert grows == (free.stability in ("unstable", "flutter")), (free.stability, free.stiffness, poles)


# -------- passive joints

SPRUNG = arm(link("base", axes="y", joint={"stiffness": [0.0]}), link("flap", axes="y", joint={"stiffness": [30.0]}))
"""A driven joint and one on a spring; level, the flap weighs 1 kg at 0.5 m."""


def test_an_axis_with_a_spring_is_passive_and_settles():
    """The spring's moment 30 q is the weight's, G/2 cos q; the drive at the base carries both links."""
    e = equilibrium(model_of(SPRUNG), hold=True)
    sag = brentq(lambda q: 30.0 * q - G / 2 * np.cos(q), 0.0, 1.0)
    assert e.held and e.passive == ("flap.joint[0]",) and e.tau[1] == 0.0
    assert np.allclose(e.q, [0.0, sag], rtol=1e-10, atol=0)
    assert np.isclose(e.tau[0], -G * (0.5 + 1.0 + np.cos(sag) / 2), rtol=1e-10)
    assert equilibrium(model_of(SPRUNG), hold=True, parameters={"flap.joint.stiffness[0]": 0.0}).passive == ()


def test_all_joints_can_be_held():
    e = equilibrium(model_of(SPRUNG), hold="all")
    assert e.held and e.passive == () and not e.q.any()
    assert np.allclose(e.tau, [-2 * G, -G / 2], rtol=1e-12)
    with pytest.raises(UsageError, match="there is no 'alll'; choose all; did you mean 'all'"):
        equilibrium(model_of(SPRUNG), hold="alll")


def test_commands_say_what_springs_do(capsys, tmp_path):
    path = tmp_path / "sprung.toml"
    path.write_text(dump(Robot.model_validate(SPRUNG)))
    assert main(["equilibrium", str(path), "--hold"]) == 0
    assert re.search(r"flap.joint\[0\] +0.16\d+ rad, on its spring", capsys.readouterr().out)
    assert main(["equilibrium", str(path), "--hold-all", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["q"] == [0.0, 0.0]
    assert main(["modes", str(path)]) == 0
    said = capsys.readouterr()
    assert said.out == "no modes: every link is rigid, and --joints locked locks every joint\n"
    springs = "the springs of flap.joint[0]"
    assert said.err == f"screwgen: note: --joints locked also locks {springs}; --joints free lets them act\n"


# -------- closed forms


@pytest.mark.parametrize("count", [3, 5])
def test_a_cantilever_sags_as_textbooks_say(count):
    """`m g l³ / 3 EI + ρA g l⁴ / 8 EI`: three polynomials hold it exactly; and its joint bears the weight."""
    modes = {"basis": "polynomial", "bending_z": count}
    beam = link("beam", 1.3, "y", rhoA=0.4, modes=modes, section={"EIy": 900.0}, bodies=[{"at": "tip", "mass": 0.7}])
    e = equilibrium(model_of(arm(beam)), hold=True)
    sag = 0.7 * G * 1.3**3 / (3 * 900) + 0.4 * G * 1.3**4 / (8 * 900)
    assert np.allclose(e.tip_deflection, [0, 0, -sag], rtol=1e-9, atol=1e-12)
    assert np.allclose(e.deflections, [[0, 0, -sag]], rtol=1e-9, atol=1e-12)
    moment = -(0.7 * 1.3 + 0.4 * 1.3**2 / 2) * G
    assert np.allclose(e.tau, [moment], rtol=1e-12)
    assert np.allclose(e.wrench, [[0, moment, 0, 0, 0, (0.7 + 0.4 * 1.3) * G]], rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("order", [1, 2, "exact"])
@pytest.mark.parametrize("force", [(5.0, 5.0), (5.0, 3.0), (1.0, 7.0), (3.0, -4.0)])
def test_a_round_beam_bends_towards_any_force_across_it(order, force):
    """`F l³ / 3 EI` in both planes, whose moments about the beam's axis cancel but for rounding."""
    modes = {"bending_y": 2, "bending_z": 2, "torsion": 1}
    section = {"EIy": 3.0e3, "EIz": 3.0e3, "GJ": 2.2e3, "rhoIp": 2e-4}
    tube = link("tube", 1.0, [], 0.6, modes=modes, section=section)
    e = equilibrium(model_of(arm(tube, gravity=(0, 0, 0)) | {"order": order}), w_ext=[[0, 0, 0, 0, *force]])
    assert e.residual <= 1e-13 and e.stability == "stable"
    assert np.allclose(e.tip_deflection[1:], np.array(force) / (3 * 3.0e3), rtol=1e-5, atol=0)


@pytest.mark.parametrize("tip", [0.0, 0.9])
def test_a_balanced_joint_is_neutral_where_weights_cancel(tip):
    """A beam on a skew axis with its like behind it, and equal masses at both ends or none: no turn matters."""
    axis = np.array([0.1, 0.3, 0.9]) / np.linalg.norm([0.1, 0.3, 0.9])
    ends = {"section": {"rhoIp": 1e-3}, "bodies": [{"at": "tip", "mass": tip}] if tip else []}
    beam = link("beam", 0.7, [axis.tolist()], 0.3, joint={"mount": {"rpy": [0.3, 0.2, -0.4]}}, **ends)
    behind = link("behind", 0.7, [], 0.3, joint={"mount": {"rpy": [0.0, 0.0, np.pi]}}, at="base", **ends)
    model = model_of(arm(beam, behind, gravity=(0.3, -5.0, -9.81)))
    for q in (0.0, 0.3, 1.1):
        e = equilibrium(model, [q])
        assert e.residual <= 1e-13 and abs(e.q[0] - q) < 1e-9
        assert e.loose == ("beam.joint[0]",) and e.stability == "neutral"


PENDULUM = {"name": "rod", "length": 2.0, "axes": "y", "rhoA": 0.5}
"""m g l / 2 = 9.81 N·m."""


def test_a_pendulum_hangs_stands_and_bears_torques():
    model = model_of(arm(link(**PENDULUM)))
    hanging = equilibrium(model)
    assert np.allclose(hanging.q, [np.pi / 2]) and hanging.stability == "stable" and not hanging.loose
    standing = equilibrium(model, [-np.pi / 2])
    assert np.allclose(standing.q, [-np.pi / 2]) and standing.stability == "unstable"
    assert standing.loose == ("rod.joint[0]",) and standing.stiffness[0] < 0 < hanging.stiffness[0]
    pushed = equilibrium(model, tau=[-9.0])
    assert np.allclose(pushed.q, [np.arccos(9.0 / G)], rtol=1e-9) and pushed.tau.tolist() == [-9.0]


def test_a_spring_counts():
    stiff = 6.0
    model = model_of(arm(link(**PENDULUM, joint={"stiffness": [stiff]})))
    angle = brentq(lambda q: stiff * q - G * np.cos(q), 0, np.pi / 2, xtol=1e-14)
    e = equilibrium(model)
    assert np.allclose(e.q, [angle], rtol=1e-10) and e.stability == "stable"
    held = equilibrium(model, [1.0], hold="all")
    assert np.allclose(held.tau, [stiff - G * np.cos(1.0)], rtol=1e-12)
    weak = model_of(arm(link(**PENDULUM, joint={"stiffness": [0.3]}), gravity=(0, 0, 0)))
    assert np.allclose(equilibrium(weak, tau=[2000.0]).q, [2000 / 0.3])


@pytest.mark.parametrize("tau", [9.9, -9.9, 1e3])
def test_a_torque_beyond_the_weight_is_refused(tau):
    with pytest.raises(NoEquilibriumError, match=r"^rod.joint\[0\]: no posture found balances its torque of"):
        equilibrium(model_of(arm(link(**PENDULUM))), tau=[tau])


def test_the_joint_that_turns_for_ever_is_named():
    robot = arm(link("mast", 0.5, "z"), link("boom", 1.0, "y"))
    neutral = equilibrium(model_of(robot))
    assert neutral.stability == "neutral" and neutral.loose == ("mast.joint[0]",)
    with pytest.raises(NoEquilibriumError, match=r"^mast.joint\[0\]: .*0.01 N·m"):
        equilibrium(model_of(robot), tau=[0.01, 0.0])
    robot["links"][0]["joint"]["stiffness"] = [2.0]
    sprung = equilibrium(model_of(robot), tau=[0.01, 0.0])
    assert np.allclose(sprung.q, [0.005, np.pi / 2], atol=1e-9) and sprung.stability == "stable"


def test_zero_gravity_leaves_the_arm_as_it_is():
    robot = example("ella").robot.model_copy(update={"gravity": (0.0, 0.0, 0.0)})
    from screwgen import derive

    model = derive(robot)
    e = equilibrium(model, [0.3, 0.2, 0.1])
    assert np.array_equal(e.q, [0.3, 0.2, 0.1, *[0.0] * 6]) and e.residual == 0.0 and e.stability == "neutral"
    assert set(e.loose) == set(model.q_names[:3]) and not e.wrench.any()
    assert equilibrium(model, [0.3, 0.2, 0.1], hold=True).stability == "stable"


def test_without_modes_and_with_welds():
    rigid = model_of(arm(link("a", axes=[]), link("b", axes=["y"])))
    assert np.allclose(equilibrium(rigid, [0.2], hold=True).tau, [-0.5 * G * np.cos(0.2)])
    welded = model_of(arm(link("a", axes=[], modes={"bending_z": 1}, section={"EIy": 500.0}), link("b", axes=[])))
    e = equilibrium(welded)
    assert e.tau.size == 0 and e.residual <= 1e-10 and e.tip_deflection[2] < 0 and e.stability == "stable"
    nothing = equilibrium(model_of(arm(link("a", axes=[]))))
    assert nothing.q.size == 0 and np.allclose(nothing.wrench, [[0, -G / 2, 0, 0, 0, G]])


def test_a_link_without_spin_inertia_rests_all_the_same():
    """Its mass matrix is singular, which statics does not mind."""
    model = model_of(arm(link("spit", axes="xy", section={"rhoIp": 0.0})))
    with pytest.raises(SingularError):
        model.numpy().forward_dynamics([0, 0], [0, 0], [0, 0], np.zeros((1, 6)))
    assert np.allclose(equilibrium(model, hold=True).tau, [0, -G / 2])


def test_an_overloaded_link_is_refused_by_name():
    soft = link("reed", 1.0, "y", modes={"bending_z": 1}, section={"EIy": 1.0}, bodies=[{"at": "tip", "mass": 5.0}])
    with pytest.raises(NoEquilibriumError, match=r"^reed.eta.bending_z\[0\]: .*small deflections"):
        equilibrium(model_of(arm(soft)), hold=True)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"q": [0.0] * 4}, "q: has 4 numbers; it must have 9"),
        ({"tau": [0.0]}, "tau: has 1 numbers; it must have 3"),
        ({"tau": [0.0, np.inf, 0.0]}, "tau: holds a number that is not finite"),
        ({"tau": [0.0, 0.2, 0.0], "hold": True}, r"tau: upper_arm.torque\[1\] is found, as its joint is held"),
        ({"hold": ["wrist"]}, "hold: there is no joint 'wrist'; choose upper_arm or forearm or upper_arm.joint"),
        ({"hold": ["forearm"], "free": ["upper_arm"]}, "hold and free both name joints"),
        ({"parameters": [1.0]}, "parameters: has 1 numbers"),
    ],
)
def test_bad_requests_are_one_line(options, message):
    with pytest.raises(UsageError, match=message):
        equilibrium(example("ella"), **options)


# -------- command line


def printed(capsys, *arguments: str) -> str:
    assert main(["equilibrium", ELLA, *arguments]) == 0
    out = capsys.readouterr()
    assert out.err == ""
    return out.out


def test_command_prints_json(capsys, tmp_path):
    found = json.loads(printed(capsys, "--q", "-0.4928, 0.6922, 0.4270", "--hold", "--json"))
    e = equilibrium(example("ella"), [-0.4928, 0.6922, 0.4270], hold=True)
    for name in ("q", "tau", "stiffness", "wrench", "tip_position", "tip_deflection", "deflections"):
        assert np.allclose(found[name], getattr(e, name), rtol=1e-12)
    assert (found["held"], found["stability"], found["loose"]) == (True, "stable", []) and found["residual"] <= 1e-10
    state = {"q": [0.1, 0.2, 0.3], "tau": [-3.0, 0.0, 0.0], "w_ext": [[0.0] * 6, [0, 0, 0, 1, 2, 3]]}
    (tmp_path / "state.json").write_text(json.dumps(state))
    loaded = json.loads(printed(capsys, "--state", str(tmp_path / "state.json"), "--json"))
    assert loaded["tau"] == [-3.0, 0.0, 0.0] and loaded["residual"] <= 1e-10
    again = equilibrium(example("ella"), state["q"], state["tau"], state["w_ext"])
    assert np.allclose(loaded["q"], again.q, rtol=1e-9, atol=1e-12)
    (tmp_path / "rest.json").write_text(json.dumps(loaded))  # a state file too
    q, v, tau, w_ext = read_state(tmp_path / "rest.json", example("ella"))
    assert [q.tolist(), tau.tolist(), w_ext.tolist()] == [loaded["q"], state["tau"], state["w_ext"]]
    assert np.abs(example("ella").numpy().forward_dynamics(q, v, tau, w_ext)[0]).max() < 1e-8


def test_command_prints_a_report(capsys):
    text = printed(capsys, "--q", "-.4928,.6922,.427", "--hold")
    assert text.startswith("ella at rest: stable; residual ") and "torques that hold them" in text
    assert "-59.084 N·m" in text and "-29.979" in text and "note" not in text
    assert re.search(r"upper_arm.torque\[0\] +-20 N·m", printed(capsys, "--tau", "-20 0 0"))


def test_more_coordinates_than_memory_bears_are_refused_at_once():
    chain = model_of(arm(*(link(f"link{i}", 0.3, "y") for i in range(1000))))
    with pytest.raises(UsageError, match="has 1000 coordinates; an equilibrium is sought for at most 500"):
        equilibrium(chain)
