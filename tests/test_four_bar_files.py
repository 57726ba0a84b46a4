"""Four-bar linkages in robot files: wrong tables, names, units and documents, and what else users see of them."""

import numpy as np
import pytest
from bad_robot_files import GOOD, refusal, refused
from four_bar_robots import LINKAGE, START, boom, digger
from helpers import model_of

from screwgen import FourBar, RobotFileError
from screwgen.backends.c.project import CProject
from screwgen.backends.latex import document as latex
from screwgen.elements import FourBarLinkage
from screwgen.plugins import plugins
from screwgen.spec.inputs import input_units
from screwgen.spec.parameters import coordinate_units, parameters

FINE = 'four_bar = { ground = 0.4, crank = 0.22, coupler = 0.47, rocker = 0.25, angle = 1.3, branch = "open" }'
UPPER = "links[0].joint.drives"
KEY = f"{UPPER}[0].transmission"


def changed(**keys: str) -> str:
    """The table of `FINE` with other words for some keys; none: the key is left out."""
    given = {"ground": "0.4", "crank": "0.22", "coupler": "0.47", "rocker": "0.25", "angle": "1.3", "branch": '"open"'}
    text = ", ".join(f"{k} = {x}" for k, x in (given | keys).items() if x)
    return f"transmission = {{ four_bar = {{ {text} }} }}"


WRONG = [
    (changed(ground=""), f"{KEY}.four_bar.ground", "is missing"),
    (changed(branch=""), f"{KEY}.four_bar.branch", "is missing"),
    (changed(coupler="0.0"), f"{KEY}.four_bar.coupler", "is 0.0; it must be > 0"),
    (changed(rocker="1e9"), f"{KEY}.four_bar.rocker", "it must be from 1e-06 to 1e+06 m"),
    (changed(crank='"long"'), f"{KEY}.four_bar.crank", 'is "long"'),
    (changed(angle="inf"), f"{KEY}.four_bar.angle", "is inf"),
    (changed(branch='"left"'), f"{KEY}.four_bar.branch", 'it must be "open" or "crossed"'),
    (changed(branch="true"), f"{KEY}.four_bar.branch", 'is true; it must be "open" or "crossed"'),
    (changed(angel="1.0"), f"{KEY}.four_bar.angel", "did you mean angle?"),
    (changed(angle="0.0"), f"{KEY}.four_bar.angle", "the rocker lies along the ground line"),
    (changed(coupler="0.05"), f"{KEY}.four_bar", "cannot be assembled at q = 0: coupler and crank join points 0.17 m"),
    ("transmission = { four_bar = 0.4 }", f"{KEY}.four_bar", "must be a table of ground, crank, coupler, rocker"),
    (f"transmission = {{ base = 0.4, {FINE} }}", f"{KEY}.base", "is stated beside four_bar"),
    (f"transmission = {{ {FINE} }}, ratio = 3.0", f"{UPPER}[0].ratio", "is stated without rotor_inertia"),
    (
        f"transmission = {{ {FINE} }}, rotor_inertia = 1.0, damping = 9.0",
        f"{UPPER}[0].damping",
        "is stated without stiffness",
    ),
]


@pytest.mark.parametrize(("table", "where", "fragment"), WRONG)
def test_wrong_linkages_are_refused_in_one_line(tmp_path, table, where, fragment):
    refused(tmp_path, GOOD.replace("armature = [0.1, 0.2]", f"drives = [ {{ {table} }}, {{}} ]"), where, fragment)


@pytest.mark.parametrize(("limits", "name"), [("lower = -1.0, upper = 0.5", "lower"), ("upper = 4.5", "upper")])
def test_limits_that_a_linkage_does_not_reach_are_refused(tmp_path, limits, name):
    text = f"drives = [ {{ transmission = {{ {FINE} }} }}, {{}} ]\nlimits = [ {{ {limits} }}, {{}} ]"
    where, fragment = (
        f"links[0].joint.limits[0].{name}",
        "which the linkage of drives[0] does not reach; it must be between",
    )
    refused(tmp_path, GOOD.replace("armature = [0.1, 0.2]", text), where, fragment)


@pytest.mark.parametrize("axis", ['{ slide = "y" }', '{ screw = "y", pitch = 0.1 }'])
def test_linkages_of_axes_that_slide_are_refused(tmp_path, axis):
    path = tmp_path / "bot.toml"
    drive = f"drives = {{ transmission = {{ {FINE} }} }} }}"
    path.write_text(GOOD.replace('axes = ["z"] }', f"axes = [{axis}], {drive}"), "utf-8")
    assert "and a linkage turns a link; leave it out" in refusal(path)


def test_parts_made_in_python_are_refused_alike():
    with pytest.raises(RobotFileError, match=r"^FourBar: cannot be assembled at q = 0"):
        FourBar(**(LINKAGE | {"coupler": 2.0}))


def test_names_units_and_parameters():
    model = boom()
    assert model.tau_names == ["boom.force[0]", "bucket.torque[0]"] and input_units(model.robot) == ["N", "N·m"]
    assert coordinate_units(model.robot)[:2] == ["rad", "rad"]
    of, drive = {x.name: x for x in parameters(model.robot)}, "bucket.joint.drives[0]"
    assert [of[f"{drive}.transmission.four_bar.{x}"].unit for x in FourBarLinkage.KEYS] == ["m", "m", "m", "m", "rad"]
    assert of[f"{drive}.ratio"].unit == "1" and of[f"{drive}.friction.viscous"].unit == "N·m·s/rad"
    moved = {f"{drive}.transmission.four_bar.angle": 1.1, f"{drive}.transmission.four_bar.crank": 0.3}
    other = model_of(digger(LINKAGE | {"angle": 1.1, "crank": 0.3}, modes={"bending_z": 1}))
    given = START, START, [500.0, 20.0], None
    assert np.allclose(model.numpy(moved).forward_dynamics(*given)[0], other.numpy().forward_dynamics(*given)[0])
    linear = model.linearise(START)
    assert linear.input_names[:2] == ("boom.force[0]", "bucket.torque[0]") and linear.input_units[:2] == ("N", "N·m")


def test_documents_and_headers_say_what_a_torque_does():
    text = latex.tex(latex.content(boom().robot, plugins()))
    assert r"J_r\,N^2\,\psi'\,\psi''\,\dot{q}^2" in text and "torque at the crank" in text
    header = CProject(boom().chain, "1").files()["arm.h"]
    assert "; at the crank where a linkage" in header and "arm_status arm_levers(" in header
