"""Predictive control where some inputs are given: brakes, lines of winches, motions of axes and of a base."""

import subprocess
from functools import cache

import numpy as np
import pytest
from conformance.c_warnings import WARNINGS
from conftest import require_tool
from helpers import QUICK, arm, link, model_of, unfolded
from mpc_judge import Problem, off_the_dense_program
from test_mpc import PLAIN, TIP, WHOLE

import screwgen

SOFT = {"EIy": 300.0, "EIz": 500.0}
BENDS = {"bending_y": 1, "bending_z": 1}
BOOM = {"axes": ["y", "z"], "modes": BENDS, "section": SOFT, "bodies": TIP}
FORE = {"axes": ["z"], "modes": {"bending_y": 1}, "section": SOFT, "bodies": TIP}
HULL = link(
    "hull", length=0.3, axes=[], bodies=[{"at": "base", "mass": 50.0, "inertia": [3.0, 3.0, 3.0, 0.0, 0.0, 0.0]}]
)
RELAXING = {"stiffness": 5.0, "rest": 1.4, "relaxation": 10.0, "relaxation_time": 0.1}
LINE = {"stiffness": 20.0, "rest": 1.5, "damping": 1.0, "winch": True}
ROPE = {"name": "hoist", "between": ["b.tip", {"world": [0.5, 0.0, 1.5]}]}


def two(boom=None, fore=None, **more) -> dict:
    links = (
        link("a", **BOOM, joint={"armature": [0.5, 0.5], **(boom or {})}),
        link("b", **FORE, joint={"armature": [0.2], **(fore or {})}),
    )
    first = more.pop("first", ())
    return arm(*first, *links, **more)


ROBOTS = {
    "brakes": two({"brake": [False, True]}, {"brake": [{"time": 0.05}]}),
    "winch": two(forces=[ROPE | {"line": LINE}]),
    "relaxing line": two(forces=[ROPE | {"line": LINE}, ROPE | {"name": "band", "line": RELAXING}]),
    "given axis": two({"actuation": ["motion", "torque"]}),
    "moving base": two(first=[HULL], base="moving"),
}
"""Each with the inputs that are given."""
NUMBERS = {"brakes": [0.3, 0.5], "winch": [0.2, 0.0], "relaxing line": [0.2, 0.0], "given axis": [0.7]}
NUMBERS["moving base"] = [0.4, -0.3, 0.2, 0.5, -1.0, 0.8]


@cache
def model(robot):
    return model_of(ROBOTS[robot])


def of(robot: str, text: str) -> str:
    """A file's numbers for the torques that are left to choose, of a given axis one fewer."""
    if robot != "given axis":
        return text
    text = text.replace("torques = [60.0, 12.0, 4.0]", "torques = [12.0, 4.0]")
    return text.replace("{ lower = [-50.0, -30.0, -20.0], upper = [60.0, 30.0, 20.0] }", "30.0")


@pytest.fixture(scope="module")
def controllers(tmp_path_factory):
    folder = tmp_path_factory.mktemp("mpc")

    @cache
    def made(robot, text):
        file = folder / f"mpc{abs(hash((robot, text)))}.toml"
        file.write_text(of(robot, text))
        return model(robot).mpc(file, flags=QUICK)

    return made


@cache
def start(robot):
    return screwgen.equilibrium(model(robot), [0.0, 0.0, 0.0], hold="all").q


def give(c, robot, rng):
    """Given inputs that differ from stage to stage."""
    for stage in c.reference:
        stage["tau"][c.fitted.given] = NUMBERS[robot] * rng.uniform(0.5, 1.5, len(c.fitted.given))


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_program_is_the_dense_one(controllers, robot):
    """Also about given inputs that differ from stage to stage, and from a base that is where nobody expected it."""
    c, m = controllers(robot, WHOLE), model(robot)
    give(c, robot, np.random.default_rng(1))
    sizes = np.full(m.chain.n_changes, 0.01)
    sizes[: m.chain.base_v] = 1e-4
    assert off_the_dense_program(c, m, start(robot), sizes) <= 1e-9


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_fixed_point_is_the_minimum(controllers, robot):
    c, m = controllers(robot, PLAIN), model(robot)
    judge = Problem(m, c.said, c.options, c.reference)
    give(c, robot, np.random.default_rng(2))
    c.initialise(start(robot), np.zeros(m.nv))
    assert c.converged
    torques, cost = judge.solve(c.states[0], c.inner["acting"], c.inner["tau"])
    reach = c.options["torque_upper"] - c.options["torque_lower"]
    assert np.abs((c.inner["tau"] - torques) / reach).max() <= 1e-6
    assert c.inner["cost"][0] == pytest.approx(cost, rel=1e-8)


HOLDS = """
[horizon]
intervals = 12
step = 0.02
substeps = 2
[goal]
joints = [0.3, 0.2, -0.9]
[cost]
tip_position = 3000.0
joints = 0.01
joint_rates = 0.01
mode_rates = 0.01
torques = 1e-5
[bounds]
torques = [150.0, 60.0, 30.0]
"""
WAVES = 0.1, 2.1, 0.05, 2.7
"""rad and rad/s of the roll, m and rad/s of the heave."""


def waves(t: float) -> np.ndarray:
    """The rates of the twist of a hull that rolls and heaves, in its axes; both begin with a rate."""
    a, w, b, u = WAVES
    roll, turning, up, lift = a * np.sin(w * t), a * w * np.cos(w * t), b * u * np.cos(u * t), -b * u**2 * np.sin(u * t)
    s, c = np.sin(roll), np.cos(roll)
    return np.array(
        [-a * w**2 * np.sin(w * t), 0.0, 0.0, 0.0, c * turning * up + s * lift, c * lift - s * turning * up]
    )


@pytest.mark.parametrize(("knows", "most"), [(True, 2e-5), (False, 2e-3)])
def test_an_arm_on_a_hull_in_waves_holds_its_tip(controllers, knows, most):
    """Within 20 µm where it knows the waves ahead; without them it is off by tenths of a millimetre."""
    c, m = controllers("moving base", HOLDS), model("moving base")
    c.given = waves if knows else lambda t: np.zeros(6)

    def law(t, q, v):
        tau = c(t, q, v).copy()
        tau[c.fitted.given] = waves(t)
        return tau

    v0 = np.zeros(m.nv)
    v0[[0, 5]] = WAVES[0] * WAVES[1], WAVES[2] * WAVES[3]
    run = screwgen.simulate(m, 3.0, 1e-3, q0=c.fitted.rest.q, v0=v0, controller=law)
    off = np.linalg.norm(run.tip_position - c.fitted.rest.position, axis=1)[run.t > 1.0]
    assert off.max() < most and (knows or off.max() > 1e-4) and c.refused == 0
    assert np.abs(run.q[:, 2]).max() > 0.04, "the hull heaves"


def test_a_brake_that_will_close_is_known_ahead(controllers):
    """From 0.2 s on the axis of the fore comes to rest, its torque does nothing: the plan made before knows."""
    c, m = controllers("brakes", PLAIN), model("brakes")
    c.given = lambda t: np.array([0.0, float(t > 0.2)])
    run = screwgen.simulate(m, 1.6, 1e-3, controller=c)
    later = run.t > 1.5
    assert np.ptp(run.q[later, 2]) < 1e-6 and np.abs(run.q[later, :2] - [0.3, 0.2]).max() < 0.03
    c.foresee(0.15)
    c.initialise(start("brakes"), np.zeros(m.nv))
    closed = np.abs(c.inner["B"][:, :, 2]).max(axis=1)
    assert (closed[:2] > 1e-4).all() and (closed[2:] < 1e-15).all()


def test_tendons_are_chosen_and_pull(tmp_path):
    """A thread along a rod bends it to its goal; its tension is never negative."""
    thread = {"name": "thread", "at": [[0.0, 0.02, 0.0], [0.0, 0.02, 0.0]]}
    rod = link("rod", axes=[], modes={"bending_y": 2}, section={"EIy": 5.0, "EIz": 5.0}, tendons=[thread])
    m = model_of(arm(rod, gravity=(0.0, 0.0, 0.0)))
    (tmp_path / "mpc.toml").write_text(TENDON)
    c = m.mpc(tmp_path / "mpc.toml", flags=QUICK)
    assert c.options["torque_lower"] == 0.0 and c.options["torque_upper"] == 40.0
    for stage in c.reference:
        stage["tip_position"][1] = 0.05
    run = screwgen.simulate(m, 2.0, 1e-3, controller=c)
    assert run.tau.min() >= 0.0 and abs(run.tip_position[-1, 1] - 0.05) < 2e-3


TENDON = """
[horizon]
intervals = 8
step = 0.02
substeps = 4
[goal]
joints = []
[cost]
tip_position = 1e4
mode_rates = 1.0
torques = 1e-6
[bounds]
torques = 40.0
"""

FAULTS = {
    "given axis": ("given = [1.0]", "goal.given[0]: is 1, of a.acceleration[0]; it must be 0, as what rests does not"),
    "brakes": ("given = [1.0]", "goal.given: has length 1; it must be a number or an array of 2"),
}


@pytest.mark.parametrize("robot", FAULTS)
def test_faults_are_one_line(tmp_path, robot):
    stated, said = FAULTS[robot]
    file = tmp_path / "mpc.toml"
    file.write_text(of(robot, PLAIN.replace("[cost]", f"{stated}\n[cost]")))
    with pytest.raises(screwgen.UsageError) as raised:
        model(robot).c_files(mpc=file)
    assert str(raised.value).startswith(f"{file}: {said}")


def test_nothing_is_left_to_choose(tmp_path):
    (tmp_path / "mpc.toml").write_text(PLAIN)
    moved = model_of(arm(link("a", axes=["z"], joint={"actuation": "motion"})))
    with pytest.raises(screwgen.UsageError, match="has no efforts; predictive control needs torques to choose"):
        moved.c_files(mpc=tmp_path / "mpc.toml")


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_folder_checks_itself(tmp_path, robot):
    """No compiler warns, and the example's first plan is a minimum."""
    (tmp_path / "mpc.toml").write_text(of(robot, PLAIN))
    unfolded(tmp_path, model(robot).c_files(mpc=tmp_path / "mpc.toml"))
    for compiler in ("gcc", "clang"):
        require_tool(compiler)
        command = [compiler, *WARNINGS, "-fsyntax-only", "arm_mpc.c", "mpc_main.c"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 0 and not done.stderr, done.stderr[:2000]
    built = ["make", "-s", "build/arm_mpc", "CFLAGS=-std=c99 -O0"]
    subprocess.run(built, cwd=tmp_path, check=True, capture_output=True)
    done = subprocess.run(["build/arm_mpc", "check"], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0 and "0 programs unsolved" in done.stdout, done.stdout + done.stderr
