"""Natural frequencies against finite beam elements; and the elements against what is known in closed form."""

import copy
from pathlib import Path

import mode_table
import numpy as np
import pytest
import scipy.optimize
from beam_arms import random_arm, welded_corner, with_modes
from beam_elements import LOWEST, frequencies
from helpers import example, example_dict, model_of
from oracle_robots import beam
from scipy.spatial.transform import Rotation

from screwgen.studies.modes import natural_frequencies

ARMS, COUNTS = (2, 3, 5), (1, 2, 3, 4, 6)


@pytest.fixture(scope="module", params=ARMS)
def arm(request):
    return random_arm(request.param)


def error(robot: dict, q, count: int = LOWEST) -> float:
    """The largest relative error of the lowest frequencies of screwgen's model, joints locked and free."""
    model, worst = model_of(robot), 0.0
    for joints in ("locked", "free"):
        found = natural_frequencies(model, q, joints)
        found = found[found > 0][:count]
        worst = max(worst, float(np.max(np.abs(found / frequencies(robot, q, joints)[:count] - 1))))
    return worst


# -------- the judge is judged


@pytest.mark.parametrize("plane", ["bending_y", "bending_z"])
@pytest.mark.parametrize(
    "mass, inertia, omega",
    [(0, 0, (3.516015, 22.034492)), (1, 0, (1.557298, 16.250085)), (0.1, 0, (2.967838, 19.355801)),
     (1, 1, (0.867900, 3.390572))],
)  # fmt: skip
def test_clamped_beam_with_tip_body(plane, mass, inertia, omega):
    tip = {"mass": mass, "inertia": [inertia] * 3 + [0, 0, 0]}
    assert 2 * np.pi * frequencies(beam(modes={plane: 1}, tip=tip), [], "locked")[:2] == pytest.approx(omega, rel=4e-7)


@pytest.mark.parametrize("direction", ["axial", "torsion"])
def test_rod_with_tip_body(direction):
    """x tan x = 1 / r where the body has r times the rod's mass, or moment of inertia about it."""
    ratio, section = 0.7, {"rhoA": 1.3, "EA": 900.0, "GJ": 60.0, "rhoIp": 0.02}
    size, (stiffness, density) = 0.8, (("EA", "rhoA") if direction == "axial" else ("GJ", "rhoIp"))
    own = ratio * section[density] * size
    tip = {"mass": own, "inertia": [own, 0, 0, 0, 0, 0]}
    root = scipy.optimize.brentq(lambda x: x * np.tan(x) - 1 / ratio, 0.1, 1.5, xtol=1e-14)
    expected = root / size * np.sqrt(section[stiffness] / section[density]) / (2 * np.pi)
    found = frequencies(beam(modes={direction: 1}, section=section, length=size, tip=tip), [], "locked")
    assert found[0] == pytest.approx(expected, rel=1e-11)


def test_pinned_beam_and_joint_spring():
    """Free at the joint: tan x = tanh x, besides the turning; on a spring alone: sqrt(3 k / (m l^2)) / 2 pi."""
    hinge = beam(["z"], modes={"bending_y": 1})
    root = scipy.optimize.brentq(lambda x: np.tan(x) - np.tanh(x), 3.5, 4.2, xtol=1e-14)
    assert 2 * np.pi * frequencies(hinge, [0.3], "free")[0] == pytest.approx(root**2, rel=1e-10)
    stiff = beam(["z"]) | {"links": [beam(["z"])["links"][0] | {"joint": {"axes": ["z"], "stiffness": [5.0]}}]}
    assert 2 * np.pi * frequencies(stiff, [0.3], "free") == pytest.approx([np.sqrt(15.0)], rel=1e-10)
    turning = copy.deepcopy(stiff)
    turning["links"][0]["joint"]["armature"] = [0.5]
    assert 2 * np.pi * frequencies(turning, [0.3], "free") == pytest.approx([np.sqrt(5 / (0.5 + 1 / 3))], rel=1e-10)


def test_rigid_link_is_a_body():
    """A rigid link at a joint that is locked weighs as a body of its inertia, turned as it is; so does a body on it."""
    section = {"rhoA": 1.1, "rhoIp": 0.03}
    mount = {"xyz": [0.05, -0.1, 0.2], "rpy": [0.3, -0.8, 1.9]}
    bent = {"axial": 1, "bending_y": 1, "bending_z": 1, "torsion": 1}
    arm = beam(modes=bent)
    rod = {"length": 0.4, "section": section, "joint": {"axes": [[1.0, 2.0, -1.0]], "mount": mount}}
    arm["links"].append(rod | {"bodies": [{"at": "base", "mass": 0.6, "com": [0.1, 0.0, -0.2]}]})
    turn = Rotation.from_rotvec(0.7 * np.array([1, 2, -1]) / np.sqrt(6))
    R = (Rotation.from_euler("xyz", mount["rpy"]) * turn).as_matrix()
    about = R @ np.diag([0.03 * 0.4] + [1.1 * 0.4**3 / 12] * 2) @ R.T
    tensor = [about[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    equal = beam(modes=bent)
    equal["links"][0]["bodies"] = [
        {"at": "tip", "mass": 0.44, "com": mount["xyz"] + R @ [0.2, 0, 0], "inertia": tensor},
        {"at": "tip", "mass": 0.6, "com": mount["xyz"] + R @ [0.1, 0.0, -0.2]},
    ]
    assert frequencies(arm, [0.7], "locked") == pytest.approx(frequencies(equal, [], "locked"), rel=1e-9)


@pytest.mark.parametrize("joints", ["locked", "free"])
def test_elements_have_converged(arm, joints):
    robot, q = arm
    coarse, fine = (frequencies(robot, q, joints, *mesh) for mesh in ((4, 3), (6, 4)))
    assert fine == pytest.approx(coarse, rel=1e-8)


# -------- screwgen's modes


@pytest.mark.parametrize(
    "links, bending, bound",
    [
        (2, 2, 1e-4),
        (3, 2, 2e-2),
        (3, 3, 1e-4),
        pytest.param(5, 2, 2e-2, marks=pytest.mark.long),
        pytest.param(5, 3, 1e-4, marks=pytest.mark.long),
    ],
)
def test_polynomials_converge(links, bending, bound):
    """With so many bending modes per plane, one in stretching and one in torsion."""
    robot, q = random_arm(links)
    assert error(with_modes(robot, bending, 1), q) < bound


def test_corner_of_two_welded_links():
    assert error(with_modes(welded_corner(), 6, 4), []) < 1e-4


@pytest.mark.parametrize("joints, count", [("locked", 7), ("free", 5)])
def test_ella_is_converged(joints, count):
    """What examples/ella.toml says of itself, at the paper's set points; stretching is flexible in the elements."""
    model, robot, q = example("converged"), example_dict("converged"), [-0.4928, 0.6922, 0.4270]
    values = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    for link in robot["links"]:
        link["section"] = {key: values[f"{link['name']}.{key}"] for key in ("rhoA", "EIy", "EIz", "GJ", "rhoIp")}
        link["section"]["EA"] = 4.38e7
        link["modes"]["axial"] = 1
    found = natural_frequencies(model, q, joints)
    assert found[found > 0][:count] == pytest.approx(frequencies(robot, q, joints)[:count], rel=3e-3)


def test_the_guide_shows_the_table():
    """All rows, in order; the cells of the smallest arm are computed again."""
    guide = (Path(__file__).resolve().parents[1] / "docs" / "modes.md").read_text(encoding="utf-8")
    assert mode_table.HEAD in guide
    shown = [[cell.strip() for cell in line.split("|")[1:-1]] for line in guide.splitlines() if line.startswith("| `")]
    assert [row[:2] for row in shown] == [[f"`{basis}`", str(n)] for basis in mode_table.BASES for n in COUNTS]
    robot, q = random_arm(ARMS[0])
    robot = with_modes(robot, 2, 1)
    row = shown[len(COUNTS) + COUNTS.index(2)]
    assert row[2] == " / ".join(map(mode_table.percent, mode_table.errors(robot, q)))
    assert row[6] == mode_table.grouped(mode_table.operations(robot))
