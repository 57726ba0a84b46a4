"""Every URDF of the package example-robot-data against Pinocchio, and a Panda with a flexible link.

The package is an extra of its own, `robots`, since it has 400 MB of meshes: `make robots` installs it and runs this.
"""

from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

import numpy as np
import pinocchio as pin
import pytest
from conftest import lacking
from helpers import relative
from urdf_judge import Pair

import screwgen
from screwgen.cli.main import main
from screwgen.errors import RobotFileError
from screwgen.interchange.load import import_urdf
from screwgen.model import derive

pytestmark = pytest.mark.examples

PACKAGE = "example-robot-data"
SHARE = "cmeel.prefix/share/example-robot-data/robots"
NOT_BY_ITSELF = {
    "hector_description/robots/quadrotor_base",
    "iris_description/robots/iris",
    "iris_description/robots/iris_simple",
}
"""Robots that fly: on a fixed base nothing of them moves, or their rotors alone."""
NO_ROBOT = "ur_description/urdf/ur3"
"""A URDF without a name and without links."""
OF_NO_BODY = {f"romeo_description/urdf/romeo_{kind}" for kind in ("small", "laas_small")}
"""Robots of which some link has an inertia that no body has."""
FLOATING = NOT_BY_ITSELF | {
    "a1_description/urdf/a1",
    "bolt_description/robots/bolt",
    "g1_description/urdf/g1_29dof_rev_1_0",
    "hyq_description/robots/hyq_no_sensors",
    "icub_description/robots/icub",
    "simple_humanoid_description/urdf/simple_humanoid",
    "solo_description/robots/solo12",
    "talos_data/robots/talos_reduced",
}
SLOW = ("tiago_dual", "_box", "_corrected", "icub_reduced", "laas", "with_hand", "classical", "joint_limited", "hands")
"""Variants of others, and the largest: `make test-long` has them."""


def folder() -> Path | None:
    try:
        return Path(str(distribution(PACKAGE).locate_file(SHARE)))
    except PackageNotFoundError:
        return None


def robots() -> list:
    """The robots, or the name of the package where it is missing."""
    found = (
        sorted(str(path.relative_to(root).with_suffix("")) for path in root.rglob("*.urdf"))
        if (root := folder())
        else []
    )
    marks = {name: (pytest.mark.long,) if any(part in name for part in SLOW) else () for name in found}
    return [pytest.param(name, marks=marks[name]) for name in found] or [PACKAGE]


def path_of(name: str) -> Path:
    """The URDF of a robot. Where the package is missing the test is skipped, or fails if REQUIRE_TOOLS=1."""
    root = folder()
    if root is None:
        lacking(PACKAGE)
    return root / f"{name}.urdf"


@pytest.mark.parametrize("name", robots())
def test_every_robot_equals_pinocchios(name):
    path = path_of(name)
    if name == NO_ROBOT:
        with pytest.raises(RobotFileError, match=r"<robot>: name: is missing"):
            import_urdf(path)
        return
    if name in OF_NO_BODY:
        with pytest.raises(RobotFileError, match="that no body has"):
            Pair(path, mimic="free", floating=name in NOT_BY_ITSELF)
    pair = Pair(path, mimic="free", nearest_inertia=name in OF_NO_BODY, floating=name in NOT_BY_ITSELF)
    assert pair.misfit() < 1e-12


@pytest.mark.parametrize("name", sorted(FLOATING - NOT_BY_ITSELF))
def test_robots_with_a_floating_root_equal_pinocchios(name):
    assert Pair(path_of(name), floating=True).misfit() < 1e-12


def test_a_panda_whose_finger_mimics_the_other_equals_pinocchios():
    path = path_of("panda_description/urdf/panda")
    robot = import_urdf(path).robot
    model, theirs = derive(robot), pin.buildModelFromUrdf(str(path), mimic=True)
    assert (model.nv, theirs.nv, len(robot.couplings)) == (9, 8, 1)
    data, rng = theirs.createData(), np.random.default_rng(5)
    q, tau, still = rng.uniform(-1, 1, 8), rng.normal(size=8), np.zeros(8)
    both = lambda x: np.append(x, x[-1])  # noqa: E731
    vdot, _ = model.numpy().forward_dynamics(both(q), both(still), [*tau, 0.0], None)
    M = np.triu(pin.crba(theirs, data, q))
    M = M + np.triu(M, 1).T
    expected = np.linalg.solve(M, tau - pin.nonLinearEffects(theirs, data, q, still))
    assert relative(vdot, both(expected)) < 1e-12


SIDE = """\
[[links]]
name = "panda_link2"
profile = { tube = { outer = 0.09, wall = 0.004 }, E = 7e10, density = 2700.0, nu = 0.33 }
modes = { bending_y = 2, bending_z = 2, torsion = 1 }
damping = { ratio = 0.01 }
"""


def test_a_panda_with_a_flexible_link_vibrates_and_moves(tmp_path, monkeypatch, capsys):
    urdf = path_of("panda_description/urdf/panda")
    monkeypatch.chdir(tmp_path)
    Path("links.toml").write_text(SIDE)
    assert main(["import", str(urdf), "-o", "panda.toml", "--flexible", "links.toml", "--mimic", "weld"]) == 0
    assert "8 joint coordinates, flexible: panda_link2" in capsys.readouterr().out
    assert main(["modes", "panda.toml"]) == 0
    Path("start.json").write_text('{"q": [0.0, 1.2, 0.0, -1.5, 0.0, 1.6, 0.0, 0.02]}')
    run = "simulate panda.toml --duration 0.05 --step 1e-3 --state start.json -o run.npz --quiet"
    assert main(run.split()) == 0
    capsys.readouterr()
    assert main(["view", "run.npz", "--meshes", str(urdf), "-o", "run.html"]) == 0
    assert "triangles of 11 visuals" in (said := capsys.readouterr().err) and said.count("\n") == 2
    flexible = screwgen.derive(screwgen.load("panda.toml"))
    assert 40.0 < screwgen.natural_frequencies(flexible, np.zeros(flexible.nq))[0] < 80.0
    with np.load("run.npz") as run:
        assert np.isfinite(run["q"]).all() and run["q"][-1, 8:].all()
    held = screwgen.equilibrium(flexible, [0.0, 1.2, 0.0, -1.5, 0.0, 1.6, 0.0, 0.02], hold=True)
    assert 1e-5 < np.linalg.norm(held.q[8:12]) < 1e-3
