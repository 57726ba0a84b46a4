"""Quantities of a size that no arm has are refused, in files, states and gains; one axis takes one number."""

import re

import pytest
from bad_robot_files import FREE, GOOD, MATERIAL, SCREW, refusal

from screwgen import UsageError, derive
from screwgen.errors import RobotFileError
from screwgen.simulation.controller_files import read_pd
from screwgen.simulation.state import state_of
from screwgen.spec import Joint, load
from screwgen.spec.ranges import RANGES

GIVEN = {"q", "v", "tau", "w_ext", "kp", "kd", "ki", "tau_max", "duration", "force_input", "brake"}
"""Not in a robot file."""

KEYS = {
    "friction by load": r"\bload = ",
    "dimension": "outer = ",
    "frequency": r"frequencies = \{ bending_y = \[",
    "damping ratio": "ratio = ",
    "damping time": "time = ",
    "armature": r"armature = \[",
    "coupling ratio": r"\bratio = ",
    "coupling offset": r"\boffset = ",
    "damping": r"\ndamping = \[",
    "stiffness": r"stiffness = \[",
    "inertia": r"inertia = \[",
    "stiffness of a row": r"\bstiffness = (?=3e4)",
    "damping of a row": r"\bdamping = (?=7\.0)",
    "ratio": r"\{ ratio = (?=9)",
    "rotor inertia": "rotor_inertia = ",
    "gear stiffness": r"\bstiffness = (?=1e4)",
    "static friction": "static = ",
    "bristle stiffness": r"memory = \{ stiffness = ",
    "limit": "upper = (?=2)",
    "stop stiffness": r"\bstiffness = (?=2e4)",
    "position": r"xyz = \[",
    "turn": r"rpy = \[",
    "gravity": r"gravity = \[",
    "brake inertia": r"brake = \{ inertia = ",
    "brake time": r"time = (?=0\.02)",
    "rest curvature": r"rest = \{ bending_y = ",
    "rest twist": r"torsion = (?=0)",
}
"""What stands before the number, where that is not the name of the quantity."""

MEASURED = GOOD.replace("EIz = 1e3, GJ", "GJ").replace(
    'clamped_free", axial = 1', 'clamped_free", frequencies = { bending_y = [20.0, 1e8] }, axial = 1'
)
TUBE = "profile = { tube = { outer = 0.1, wall = 0.004 }, E = 2e11, density = 7800.0, nu = 0.3 }"
TEXTS = {"frequency": MEASURED} | dict.fromkeys(("dimension", "nu"), GOOD.replace(f"section = {MATERIAL}", TUBE))
SHEARED = GOOD.replace("EIz = 1e3, GJ", "EIz = 1e3, GAy = 1e5, GAz = 1e5, rhoIy = 1e-3, rhoIz = 1e-3, GJ")
TEXTS |= dict.fromkeys(("GAy", "GAz", "rhoIy", "rhoIz"), SHEARED)
DRIVE = "ratio = 9.0, rotor_inertia = 1e-4, stiffness = 1e4, friction = { coulomb = 1.0, velocity = 1.0 }"
DRIVEN = GOOD.replace(FREE, f"{FREE}, drives = {{ {DRIVE} }}")
BRISTLES = "coulomb = 1.0, memory = { stiffness = 9.0 }, stribeck = { static = 2.0, velocity = 0.1 }"
BRUSHED = GOOD.replace(FREE, f"{FREE}, drives = {{ friction = {{ {BRISTLES} }} }}")
TEXTS["friction by load"] = DRIVEN.replace("velocity = 1.0 }", "velocity = 1.0, load = 0.1 }")
TEXTS |= dict.fromkeys(("static friction", "bristle stiffness"), BRUSHED)
TEXTS |= dict.fromkeys(("ratio", "rotor inertia", "gear stiffness", "coulomb", "velocity"), DRIVEN)
TEXTS |= dict.fromkeys(
    ("limit", "stop stiffness"), GOOD.replace(FREE, f"{FREE}, limits = {{ upper = 2, stiffness = 2e4 }}")
)
TEXTS["stabilisation"] = (
    f'{GOOD}\n[[loops]]\nbetween = ["upper.tip", "fore.tip"]\njoint = {{ axes = [] }}\nstabilisation = 9.0\n'
)
SOFT = TEXTS["stabilisation"].replace("axes = []", "axes = [], stiffness = 3e4, damping = 7.0")
TEXTS |= dict.fromkeys(("stiffness of a row", "damping of a row"), SOFT.replace("stabilisation = 9.0\n", ""))
COUPLED = f'couplings = [{{ axis = "fore.joint[0]", of = "upper.joint[0]", ratio = 2.0, offset = 0.5 }}]\n{GOOD}'
TEXTS |= dict.fromkeys(("coupling ratio", "coupling offset"), COUPLED)
TEXTS["effort"] = GOOD.replace(FREE, f"{FREE}, limits = {{ effort = 50.0 }}")
TEXTS |= dict.fromkeys(
    ("brake inertia", "brake time"), GOOD.replace(FREE, f"{FREE}, brake = {{ inertia = 1.0, time = 0.02 }}")
)
TEXTS["damping time"] = GOOD.replace("{ ratio = 0.01 }", "{ time = 0.01 }")
CURVED = GOOD.replace(
    "damping = { ratio", 'order = "exact"\nrest = { bending_y = 0.5, torsion = 0.3 }\ndamping = { ratio'
)
TEXTS |= dict.fromkeys(("rest curvature", "rest twist"), CURVED)
TEXTS["pitch"] = GOOD.replace(FREE, SCREW)
"""The files of quantities that the good file lacks."""


def outside(quantity: str) -> list[float]:
    """Numbers just outside a range."""
    allowed = RANGES[quantity]
    return [2 * allowed.high, *([allowed.low / 2, 1e-308] if allowed.low else [])]


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    path = tmp_path_factory.mktemp("robot") / "good.toml"
    path.write_text(GOOD)
    return derive(load(path))


@pytest.mark.parametrize("quantity", sorted(RANGES.keys() - GIVEN))
def test_a_robot_file_states_sizes_that_arms_have(tmp_path, quantity):
    path = tmp_path / "bot.toml"
    before = KEYS.get(quantity, rf"\b{quantity} = ")
    for number in outside(quantity):
        text, count = re.subn(rf"({before})[-+.e\d]+", rf"\g<1>{number}", TEXTS.get(quantity, GOOD), count=1)
        assert count == 1
        path.write_text(text)
        assert f"is {number}; it must be {RANGES[quantity].text}" in refusal(path)


def test_a_product_of_material_and_geometry_is_in_its_range_too(tmp_path):
    path = tmp_path / "bot.toml"
    path.write_text(GOOD.replace("density = 7800.0, area = 1e-4", "density = 1e-6, area = 1e-14"))
    assert refusal(path).startswith("links[1].section.rhoA (link fore): is 1e-20; it must be from 1e-09 to")


@pytest.mark.parametrize(("key", "size"), [("q", 9), ("v", 9), ("tau", 2), ("w_ext", 2)])
def test_a_state_states_sizes_that_motions_have(model, key, size):
    for number in (2 * RANGES[key].high, 1e155, -1e308):
        value = [[number] * 6] * size if key == "w_ext" else [number] * (model.n_joints if key == "tau" else model.nq)
        with pytest.raises(UsageError, match=rf"^state: {key}\[0\].*: is .*; it must be from -1e\+[0-9]+ to 1e\+"):
            state_of({key: value}, model)


@pytest.mark.parametrize("key", ["kp", "kd", "ki", "tau_max", "duration"])
def test_gains_have_sizes_too(model, tmp_path, key):
    given = dict.fromkeys(("kp", "kd", "ki", "q_des", "tau_max"), "[1, 1, 1]") | {"duration": "1.0"}
    for number in outside(key):
        value = given[key].replace("1.0" if key == "duration" else "1", str(number), 1)
        (tmp_path / "gains.toml").write_text("\n".join(f"{k} = {v}" for k, v in (given | {key: value}).items()))
        with pytest.raises(UsageError, match=rf"gains.toml: {key}.*: is .*; it must be "):
            read_pd(tmp_path / "gains.toml", model)


@pytest.mark.parametrize("name", ["armature", "damping", "stiffness"])
def test_one_axis_takes_one_number(name):
    assert Joint(axes=["z"], **{name: 2}) == Joint(axes=["z"], **{name: [2.0]})
    for wrong in (True, "2", -2.0):
        with pytest.raises(RobotFileError, match=rf"^Joint: {name}(\[0\])?: is "):
            Joint(axes=["z"], **{name: wrong})
    for axes in ([], ["y", "z"]):
        with pytest.raises(RobotFileError, match=rf"^Joint: {name}: is 2; it must be an array of numbers"):
            Joint(axes=axes, **{name: 2})
