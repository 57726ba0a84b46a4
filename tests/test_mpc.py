"""The predictive controller of the generated C: its quadratic program, its fixed point, its loop, its faults."""

import subprocess
from functools import cache

import numpy as np
import pytest
from conformance.c_warnings import WARNINGS
from conftest import require_tool
from helpers import QUICK, arm, link, model_of
from mpc_judge import Problem, off_the_dense_program

import screwgen
from screwgen.errors import UsageError
from screwgen.studies.predictive import project

SOFT = {"EIy": 300.0, "EIz": 500.0}
TIP = [{"at": "tip", "mass": 1.0}]
ARM = arm(
    link(
        "a",
        axes=["y", "z"],
        modes={"bending_y": 1, "bending_z": 1},
        section=SOFT,
        bodies=TIP,
        joint={"armature": [0.5, 0.5]},
    ),
    link("b", axes=["z"], modes={"bending_y": 1}, section=SOFT, bodies=TIP, joint={"armature": [0.2]}),
)


def rubbing(coulomb: float, **more) -> dict:
    """A drive whose friction remembers: bristles that slip from half a milliradian on."""
    return {"friction": {"coulomb": coulomb, "memory": {"stiffness": 2e3 * coulomb, "damping": 20 * coulomb}, **more}}


FALLING = rubbing(2.0, viscous=0.1, stribeck={"static": 3.0, "velocity": 0.02})
WALL = {"name": "wall", "parent": "world", "joint": {"axes": [], "mount": {"xyz": [1.0, 0.02, 0.0]}}}
WALL["bodies"] = [{"at": "base", "mass": 0.0}]
PIVOT = {"between": ["wall.tip", "a.tip"], "joint": {"axes": ["x", "y", "z"], "stiffness": 400.0, "damping": 8.0}}
DRIVES = ([FALLING, FALLING], [rubbing(0.7)])
ROBOTS = {
    "arm": ARM,
    "held": ARM | {"links": [WALL, ARM["links"][0] | {"parent": "world"}, ARM["links"][1]], "loops": [PIVOT]},
    "bristles": ARM
    | {"links": [x | {"joint": x["joint"] | {"drives": y}} for x, y in zip(ARM["links"], DRIVES, strict=True)]},
}
WHOLE = """
[horizon]
intervals = 5
step = 0.02
substeps = 2
blocks = [1, 1, 3]
[goal]
joints = [0.3, 0.2, -0.2]
[cost]
tip_position = [300.0, 200.0, 100.0]
tip_orientation = 2.0
tip_velocity = 0.5
joints = [1.0, 2.0, 3.0]
modes = 1.0
joint_rates = 0.02
mode_rates = 0.2
torques = 1e-4
torque_rates = 1e-8
terminal = { riccati = true, factor = 0.5 }
[bounds]
torques = { lower = [-50.0, -30.0, -20.0], upper = [60.0, 30.0, 20.0] }
torque_rates = 3000.0
joints = { lower = -2.0, upper = [2.0, 0.02, 2.0] }
joint_rates = 0.5
strains = { limit = 2e-4, fibre = 0.02 }
wrenches = [ { component = "b.tau_y", limit = 8.0 }, { component = "a.F_z", limit = 30.0 } ]
penalty = 10.0
[solver]
delay = 0
"""
PLAIN = """
[horizon]
intervals = 6
step = 0.02
substeps = 2
[goal]
joints = [0.3, 0.2, -0.2]
[cost]
joints = 10.0
joint_rates = 1.0
mode_rates = 1.0
torques = 1e-4
terminal = { riccati = true }
[bounds]
torques = [60.0, 12.0, 4.0]
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("mpc")


@cache
def model(robot="arm"):
    return model_of(ROBOTS[robot])


@pytest.fixture(scope="module")
def controllers(folder):
    @cache
    def made(text, single=False, robot="arm"):
        file = folder / f"mpc{abs(hash(text))}.toml"
        file.write_text(text)
        return model(robot).mpc(file, single=single, flags=QUICK)

    return made


def sizes_of(robot):
    """Changes of a state, of bristles a tenth of what they bend before they slip."""
    return np.r_[np.full(12, 0.01), np.full(model(robot).chain.n_internal, 5e-5)]


@cache
def start():
    return screwgen.equilibrium(model(), [0.0, 0.0, 0.0], hold=True).q


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_program_is_the_dense_one(controllers, robot):
    """Hessian, gradient and constraints about a plan that is none of the motion, from another state."""
    c = controllers(WHOLE, robot=robot)
    assert off_the_dense_program(c, model(robot), start(), sizes_of(robot)) <= 1e-9


@pytest.mark.parametrize(("text", "robot"), [(WHOLE, "arm"), (PLAIN, "arm"), (PLAIN, "bristles")])
def test_the_fixed_point_is_the_minimum(controllers, text, robot):
    """Of IPOPT on the same problem with exact derivatives; some bounds are active, some soft ones violated."""
    c = controllers(text, robot=robot)
    judge = Problem(model(robot), c.said, c.options, c.reference)
    c.initialise(start(), np.zeros(6))
    assert c.converged
    torques, cost = judge.solve(c.states[0], c.inner["acting"], c.inner["tau"])
    reach = c.options["torque_upper"] - c.options["torque_lower"]
    assert np.abs((c.inner["tau"] - torques) / reach).max() <= 1e-6
    assert c.inner["cost"][0] == pytest.approx(cost, rel=1e-8)
    assert np.abs(c.inner["z"]).max() < 1e-6
    at_bounds = (torques > c.options["torque_upper"] - 1e-4) | (torques < c.options["torque_lower"] + 1e-4)
    assert at_bounds.any() == (text is PLAIN)
    assert text is PLAIN or c.inner["violation"][0] > 1e-3


def test_the_loop_reaches_the_goal(controllers):
    c = controllers(PLAIN)
    run = screwgen.simulate(model(), 2.0, 1e-3, q0=start(), controller=c)
    away = np.linalg.norm(run.tip_position - c.reference[0]["tip_position"], axis=1)
    assert away[0] > 0.6 and away[-1] < 2e-3
    assert np.all(np.abs(run.tau) <= [60.0, 12.0, 4.0])
    assert len(np.unique(run.tau[:, 0])) <= 101, "torques are held over a sample"


def test_wrenches_may_be_the_only_soft_bounds(controllers):
    c = controllers(PLAIN.replace("[bounds]", '[bounds]\nwrenches = [ { component = "b.tau_y", limit = 30.0 } ]'))
    c.initialise(start(), np.zeros(6))
    assert c.converged and c.inner["row"].shape == (6, 18)


def test_a_heavier_payload(controllers):
    """The plan follows new parameters from the next preparation on."""
    c = controllers(PLAIN)
    c.initialise(start(), np.zeros(6))
    c.feedback(start(), np.zeros(6))
    c.prepare()
    before = c.inner["A"].copy()
    c.feedback(start(), np.zeros(6))
    c.set_parameters({"b.bodies[0].mass": 2.0})
    c.prepare()
    assert np.abs(c.inner["A"] - before).max() > 1e-3
    c.set_parameters(None)


def test_late_and_limited(controllers):
    """Without a preparation, and at the limit of iterations, the plan goes on."""
    c = controllers(PLAIN)
    c.initialise(start(), np.zeros(6))
    c.feedback(start(), np.zeros(6))
    planned = c.torques
    with pytest.raises(screwgen.ScrewgenError, match="bad argument"):
        c.feedback(start(), np.zeros(6))
    assert np.array_equal(c._at["tau"], planned[1])
    c.options["qp_iterations"][:] = 2
    c.prepare()
    shifted = c.torques
    patience, c.options["patience"][:] = c.options["patience"].copy(), 0
    tau = c.feedback(start() + np.repeat([0.5, 0.0], 3), np.repeat([3.0, 0.0], 3))
    c.options["patience"][:] = patience
    assert c.outcome == "limited" and np.array_equal(tau, shifted[0])
    c.options["qp_iterations"][:] = 100
    c.prepare()
    with pytest.raises(screwgen.ScrewgenError, match="non-finite"):
        c.feedback(np.full(6, np.nan), np.zeros(6))


@pytest.mark.parametrize("outside", [0.0, 3.0])
def test_without_a_plan_torques_are_within_the_bounds(tmp_path, outside):
    """Memory that nobody has set to zero, and a start that is refused."""
    (tmp_path / "mpc.toml").write_text(PLAIN)
    c = model().mpc(tmp_path / "mpc.toml", flags=QUICK)
    for view in (c.inner[name] for name in ("x", "tau", "acting", "prepared")):
        view[...] = 7.0 if view.dtype.kind == "i" else -3.7e279
    lower, upper = (c.options[name] for name in ("torque_lower", "torque_upper"))
    lower[0] = outside
    qp_iterations, c.options["qp_iterations"][:] = c.options["qp_iterations"].copy(), -1
    for call in (lambda: c.initialise(start(), np.zeros(6)), lambda: c.feedback(start(), np.zeros(6))):
        with pytest.raises(screwgen.ScrewgenError, match="bad argument"):
            call()
    assert c._at["tau"][0] == outside and (c._at["tau"][1:] == 0).all()
    c.options["qp_iterations"][:] = qp_iterations
    c.initialise(start(), np.zeros(6))
    c.prepare()
    upper[0] = lower[0] = 1.5
    with pytest.raises(screwgen.ScrewgenError, match="non-finite"):
        c.feedback(np.full(6, np.nan), np.zeros(6))
    assert c._at["tau"][0] == 1.5


@pytest.mark.long
@pytest.mark.parametrize("robot", ROBOTS)
def test_in_float(controllers, robot):
    double, single = controllers(PLAIN, robot=robot), controllers(PLAIN, True, robot)
    for c in (double, single):
        c.initialise(start(), np.zeros(6))
    assert np.abs(single.torques - double.torques).max() < 0.02 * 60.0
    tau = single.feedback(start(), np.zeros(model(robot).chain.nvz))
    assert single.outcome == "solved" and np.all(np.abs(tau) <= [60.0, 12.0, 4.0])


@pytest.mark.parametrize("robot", ROBOTS)
def test_folder_compiles_without_a_warning(tmp_path, robot):
    """Also for a Cortex-M7; no source asks for heap."""
    (tmp_path / "whole.toml").write_text(WHOLE)
    files = model(robot).c_files(mpc=tmp_path / "whole.toml")
    for name, data in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(data)
    sources = ["arm_mpc.c", "arm_qp.c", "mpc_main.c"]
    board = ["-mcpu=cortex-m7", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv5-d16"]
    for compiler in (["gcc"], ["arm-none-eabi-gcc", *board]):
        for define in ([], ["-DARM_REAL_FLOAT"]):
            command = [require_tool(compiler[0]), *compiler[1:], *WARNINGS, *define, "-fsyntax-only", *sources]
            done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
            assert done.returncode == 0 and not done.stderr, done.stderr[:2000]
    assert not any(b"alloc(" in files[name] for name in files if name.startswith(("daqp/", "arm_mpc", "arm_qp")))
    assert files["daqp/LICENSE"].startswith(b"MIT License")
    assert b"arm_mpc check" in files["Makefile"] and b"arm_mpc" in files["CMakeLists.txt"]


FAULTS = {
    "intervals = 6": ("intervals = 0", "horizon.intervals: is 0; it must be a whole number from 1 to 1000"),
    "step = 0.02": (
        "step = 0.02\nblocks = [1, 2]",
        "horizon.blocks: add up to 3 intervals; they must add up to intervals = 6",
    ),
    "joints = 10.0": ("joint = 10.0", "cost.joint: is an unknown key; did you mean joints?"),
    "torques = 1e-4": ("torques = 0.0", "cost.torques: and torque_rates are 0 for joint 0; one of them must be > 0"),
    "torques = [60.0, 12.0, 4.0]": (
        "torques = [60.0, 30.0]",
        "bounds.torques: has length 2; it must be a number or an array of 3",
    ),
    "[bounds]": (
        '[bounds]\nwrenches = [ { component = "c.tau_x", limit = 1.0 } ]',
        "bounds.wrenches[0].component: is no joint wrench; the first are a.tau_x",
    ),
    "joints = [0.3, 0.2, -0.2]": ("joints = [0.3]", "goal.joints: has length 1; it must be a number or an array of 3"),
}


@pytest.mark.parametrize("good", FAULTS)
def test_faults_are_one_line(tmp_path, good):
    bad, said = FAULTS[good]
    file = tmp_path / "mpc.toml"
    file.write_text(PLAIN.replace(good, bad, 1))
    with pytest.raises(screwgen.ScrewgenError) as raised:
        model().c_files(mpc=file)
    assert said in str(raised.value) and str(raised.value).startswith(str(file)) and "\n" not in str(raised.value)


def test_the_header_states_units_of_slides(tmp_path):
    cart = model_of(arm(link("cart", axes=[{"slide": "x"}])))
    (tmp_path / "mpc.toml").write_text(PLAIN.replace("[0.3, 0.2, -0.2]", "[0.3]").replace("[60.0, 12.0, 4.0]", "60.0"))
    header = " ".join(project(cart, tmp_path / "mpc.toml").files()["arm_mpc.h"].split())
    for line in (
        "torque_upper[ARM_LENGTH(ARM_NTAU)]; /* N*m, of slides N */",
        "torque_rate[ARM_LENGTH(ARM_NTAU)]; /* N*m/s, of slides N/s, either sign",
        "/* rad, of slides m; not read: the file bounds none */",
        "/* rad/s, of slides m/s, either sign; not read: the file bounds none */",
        "/* torques of the blocks, N*m, of slides N */",
    ):
        assert line in header, line


def test_robots_that_it_is_not_made_for(tmp_path):
    file = tmp_path / "mpc.toml"
    file.write_text(PLAIN)
    floating = screwgen.load("examples/space_arm.toml")
    with pytest.raises(UsageError, match="has a floating base; predictive control in C is not made for them"):
        screwgen.derive(floating).c_files(mpc=file)
