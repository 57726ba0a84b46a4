"""Feedforward of joint motions: judged by forward dynamics, by plans, and by its own C."""

import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from conftest import require_tool
from helpers import arm, example, link, loaded_boom, model_of
from robot_toml import to_toml
from test_planning import ella

import screwgen
from screwgen import FeedforwardPD, UsageError
from screwgen.cli.main import main
from screwgen.simulation.integrate import JointStepper
from screwgen.simulation.played import Played

STRICT = "-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror -O1".split()
DRIVER = Path(__file__).parent / "c" / "feedforward_run.c"
GOAL, TIME = np.array([0.8, -0.6]), 0.8


RATIO = 60.0
GEAR = {
    "ratio": RATIO,
    "rotor_inertia": 0.2 / RATIO**2,
    "stiffness": 1500.0,
    "damping": 2.0,
    "friction": {"viscous": 1e-4},
}


def boom(elastic=False, **damping):
    """Two links in a vertical plane, with rotors, of which the first may be behind a gear that twists."""
    section, joint = {"rhoA": 0.6, "EIy": 90.0, "EIz": 90.0}, {"armature": [0.2], **damping}
    rods = [
        link(name, axes="y", length=0.9, section=section, modes={"bending_z": 1}, joint=joint, **tip)
        for name, tip in (("upper", {}), ("fore", {"bodies": [{"at": "tip", "mass": 0.5}]}))
    ]
    if elastic:
        rods[0]["joint"] = {"axes": ["y"], **{k: x for k, x in damping.items() if k != "damping"}, "drives": GEAR}
    return model_of(arm(*rods, name="boom", order=2))


def smooth(step):
    """Joints along a path of least jerk, at samples."""
    s = np.linspace(0.0, 1.0, round(TIME / step) + 1)[:, None]
    return GOAL * s**3 * (10 - 15 * s + 6 * s**2), GOAL * 30 * (s * (1 - s)) ** 2 / TIME


@pytest.mark.parametrize("elastic", [False, True])
def test_forward_dynamics_makes_the_reference_of_the_efforts(elastic):
    """Efforts held over steps lead the free arm along the reference, four times as closely in half the step."""
    model, off = boom(elastic, damping=[0.3]), []
    ratios = np.array([RATIO if elastic else 1.0, 1.0])
    places = model.chain.held_places
    for step in (8e-3, 4e-3, 2e-3):
        q, v = smooth(step)
        found = screwgen.feedforward(model, q, v, step)
        stepper = JointStepper(model, "rk4", model.parameter_values)
        state, there = stepper.initial(found.q[0], found.v[0]), []
        for tau in found.tau / ratios:
            for _ in range(8):
                state = stepper.step(state, tau, np.zeros((2, 6)), step / 8)
            there.append(state.q[places] / ratios)
        assert np.abs(found.q[:, places] / ratios - q).max() < 1e-12
        off.append(np.abs(there - q[1:]).max())
    assert off[-1] < 1e-5
    assert off[0] / off[1] == pytest.approx(4, rel=0.25) and off[1] / off[2] == pytest.approx(4, rel=0.25)


def test_work_of_the_efforts_is_the_energy_of_the_arm():
    model, step = boom(), 1e-3
    q, v = smooth(step)
    found = screwgen.feedforward(model, q, v, step)
    work = np.append(0.0, np.cumsum((found.tau * np.diff(q, axis=0)).sum(axis=1)))
    energy = np.array([sum(model.numpy().energy(x, y)) for x, y in zip(found.q, found.v, strict=True)])
    assert np.abs(work - (energy - energy[0])).max() < 1e-4 * np.ptp(energy)


def test_the_efforts_of_a_plan_s_references_are_its_torques():
    """The closer the more points a plan has, and then they leave the arm as still."""
    model = model_of(loaded_boom({"rhoA": 0.6}, modes=1))
    off = []
    for intervals in (12, 24, 48):
        plan = screwgen.plan(model, [0.0], [1.0], 0.9, intervals=intervals)
        samples = plan.sampled(1e-3)
        found = screwgen.feedforward(model, samples.q, samples.v, 1e-3)
        off.append(np.sqrt(np.mean((found.tau - samples.tau[:-1]) ** 2)) / plan.effort[0])
    assert off[0] > 2 * off[1] > 4 * off[2] and off[2] < 5e-3
    law = screwgen.PD((60.0,), (12.0,), (0.0,))
    planned = Played.of(replace(plan, kp=np.array(law.kp), kd=np.array(law.kd)))
    run = screwgen.simulate(model, 1.9, 1e-3, controller=FeedforwardPD.of(planned, model))
    jerk = screwgen.simulate(model, 1.9, 1e-3, controller=replace(law, q_des=(1.0,), duration=0.9))
    left, swing = (np.ptp(x.tip_position[x.t >= 0.9], axis=0).max() for x in (run, jerk))
    assert left < 0.01 * swing


@pytest.mark.parametrize(
    ("layout", "elastic", "binding"),
    [("fused", False, "runtime"), ("modular", False, "runtime"), ("auto", True, "runtime"), ("auto", True, "baked")],
)
def test_c_gives_what_python_gives(tmp_path, layout, elastic, binding):
    """In double to 1e-12; what no clock should ask has a status, and changes nothing."""
    model, step = boom(elastic, damping=[0.3]), 2e-3
    q, v = smooth(step)
    wanted = screwgen.feedforward(model, q, v, step)
    model.write(tmp_path, targets=["feedforward"], layout=layout, parameters=binding)
    if elastic:
        assert wanted.q[100, 2] == pytest.approx(RATIO * q[100, 0]) and abs(wanted.q[100, 0] - q[100, 0]) > 1e-3
    flags = ["-DELASTIC"] * elastic
    rows = np.loadtxt(run(tmp_path / "feedforward", step, q, v, *flags), skiprows=1)
    assert np.abs(rows[:, :2] - wanted.tau).max() < 1e-12 * np.abs(wanted.tau).max()
    assert np.abs(rows[:, 2:] - wanted.q[1:]).max() < 1e-12
    flags += ["-DBOOM_FEEDFORWARD_REAL_FLOAT"]
    single = np.loadtxt(run(tmp_path / "feedforward", step, q, v, *flags), skiprows=1)
    assert 1e-8 < np.abs(single[:, :2] - wanted.tau).max() / np.abs(wanted.tau).max() < 1e-2


def run(folder, step, q, v, *flags):
    """Lines that the driver prints."""
    sources = [str(x) for x in sorted(folder.glob("boom_feedforward_*.c"))]
    command = [require_tool("gcc"), *STRICT, *flags, "-I", str(folder), "-o", "run", str(DRIVER), *sources, "-lm"]
    done = subprocess.run(command, cwd=folder.parent, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    given = f"{step!r}\n" + "\n".join(" ".join(map(repr, row)) for row in np.hstack([q, v]).tolist())
    done = subprocess.run([str(folder.parent / "run")], input=given, capture_output=True, text=True)
    assert done.returncode == 0
    nonfinite, bad, lines = 1, 3, done.stdout.splitlines()
    assert lines[0].split() == [str(x) for x in (nonfinite, nonfinite, bad, bad, bad, 1)]
    return lines


def test_a_run_follows_its_path_with_the_efforts_ahead(tmp_path, capsys):
    """Joints follow a fast path within what a step costs; without the efforts they lag."""
    section = {"rhoA": 0.1, "EIy": 40.0, "EIz": 40.0}
    rod = link("rod", axes=["y"], length=1.0, section=section, modes={"bending_z": 1}, joint={"armature": [0.4]})
    (tmp_path / "boom.toml").write_text(to_toml({**arm(rod), "name": "boom"}))
    gains = "kp = [60.0]\nkd = [12.0]\nq_des = [1.0]\nduration = 0.8\n"
    (tmp_path / "gains.toml").write_text(gains)
    (tmp_path / "held.toml").write_text(gains + "gravity = true\n")
    command = ["simulate", str(tmp_path / "boom.toml"), "--duration", "1", "--step", "1e-3", "--quiet"]
    off = {}
    for kind in ("pd", "feedforward"):
        assert (
            main([*command, "--controller", f"{kind}:{tmp_path / 'gains.toml'}", "-o", f"{tmp_path / kind}.npz"]) == 0
        )
        with np.load(tmp_path / f"{kind}.npz") as stored:
            s = np.clip(stored["t"] / 0.8, 0, 1)
            off[kind] = np.abs(stored["q"][:, 0] - s**3 * (10 - 15 * s + 6 * s**2)).max()
    assert off["feedforward"] < 1e-3 < 3e-2 < off["pd"]
    capsys.readouterr()
    assert main([*command, "--controller", f"feedforward:{tmp_path / 'held.toml'}", "-o", str(tmp_path / "x.npz")]) == 2
    assert "held.toml: gravity: the efforts ahead hold the arm too" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("q", "v", "said"),
    [
        ([[0.0, 0.0], [1.0, 0.0]], [[0.0, 0.0]] * 2, "joint 0 goes 1 from sample 0 to the next, with rates 0, 0"),
        ([[0.0, 0.0], [0.01, 0.0]], [[1.0, 0.0]] * 2, "joint 0 begins with the rate 1; begin at rest"),
        (
            [[0.0, 0.0], [7.8e-6, 0.0]],
            [[0.0, 0.0]] * 2,
            "joint 0 goes 7.8e-06 from sample 0 to the next, with rates 0, 0",
        ),
        ([[0.0, 0.0], [np.nan, 0.0]], [[0.0, 0.0]] * 2, "not finite"),
        ([[0.0, 0.0]], [[0.0, 0.0]], "has 1 sample; a motion has two"),
        ([[0.0], [0.0]], [[0.0], [0.0]], "q: of joints at samples: has 2 numbers; it must have 4"),
    ],
)
def test_references_that_are_no_motion_are_one_line(q, v, said):
    with pytest.raises(UsageError) as caught:
        screwgen.feedforward(boom(), q, v, 1e-2)
    assert said in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("limit", "said"),
    [({"effort": 2.0}, "whose limit is 2"), ({"lower": -0.1, "upper": 0.4}, "its limits are -0.1 and 0.4")],
)
def test_a_motion_beyond_what_joints_can_is_one_line(limit, said):
    with pytest.raises(UsageError, match=said):
        screwgen.feedforward(boom(limits=[limit]), *smooth(8e-3), 8e-3)


@pytest.mark.parametrize(("name", "what"), [("parallelogram", "loops"), ("space_arm", "floating base")])
def test_robots_whose_joints_alone_do_not_say_the_efforts_are_refused(tmp_path, name, what):
    model = example(name)
    for call in (
        lambda: screwgen.feedforward(model, [[0.0] * model.n_joints] * 2, [[0.0] * model.n_joints] * 2, 1e-3),
        lambda: model.write(tmp_path / "out", targets=["feedforward"]),
    ):
        with pytest.raises(UsageError, match=what):
            call()


@pytest.mark.long
def test_the_efforts_of_a_fine_plan_s_references_leave_an_exact_ella_at_rest():
    """Of a plan of 48 intervals; those of a rigid arm leave a hundred times as much."""
    goal, time = (-0.5, 0.7, 0.45), 1.2
    law = screwgen.PD((711.0, 5500.0, 179.0), (153.0, 204.0, 33.7), goal, duration=time)
    design, plant = ella(1, 2), ella("exact", 4)
    planned = Played.of(screwgen.plan(design, [0.0] * 3, goal, time, gains=law, intervals=48))
    at_rest = planned.rest(plant, np.array(plant.parameter_values))
    left = []
    for model in (design, ella(1, 0)):
        run = screwgen.simulate(plant, time + 1, 1e-3, at_rest, controller=FeedforwardPD.of(planned, model))
        left.append(np.linalg.norm(np.ptp(run.tip_position[run.t >= time], axis=0)))
    assert left[0] <= 2e-4 < 1e-2 < left[1]
