"""Sections that vary, and profiles, in robot files: what is refused, in one line, and what survives a file."""

import numpy as np
import pytest
from bad_robot_files import GOOD, MATERIAL, refusal
from helpers import model_of
from spec_parts import reloaded
from varying_robots import tapered_arm

from screwgen import Robot, UsageError
from screwgen.spec import Section, dump, load

STATION = "rhoA = 1.0, EIy = 1e3"
FIRST, LAST = f"{{ at = 0.0, {STATION} }}", f"{{ at = 1.0, {STATION} }}"
WAVY = ", ".join(f"{{ at = {s}, rhoA = {x} }}" for s, x in ((0.0, 1.0), (0.25, 0.01), (0.75, 0.01), (1.0, 1.0)))
MATTER = "E = 7e10, density = 2700.0"

WRONG = [  # the section, the key path below the link, a fragment of the message
    ("[]", "", "has 0 stations; it must have from 2 to 64"),
    (f"[ {FIRST} ]", "", "has 1 stations; it must have from 2"),
    (f"[ {FIRST}, {{ at = 0.9, {STATION} }} ]", "[1].at", "is 0.9; the last station must be at 1.0"),
    (f"[ {{ at = 0.1, {STATION} }}, {LAST} ]", "[0].at", "is 0.1; the first station must be at 0.0"),
    (f"[ {FIRST}, {{ at = 1.5, {STATION} }} ]", "[1].at", "is 1.5; it must be from 0 at the base to 1 at the tip"),
    (f"[ {FIRST}, {{ at = -0.5, {STATION} }}, {LAST} ]", "[1].at", "is -0.5; it must be from 0"),
    (f"[ {FIRST}, {{ at = 0.6, {STATION} }}, {{ at = 0.5, {STATION} }}, {LAST} ]", "[2].at", "is 0.5; it must not be"),
    (f"[ {FIRST}, {3 * f'{{ at = 0.5, {STATION} }}, '}{LAST} ]", "[2].at", "is 0.5 again; a step has two stations"),
    (f"[ {FIRST}, {FIRST}, {LAST} ]", "[1].at", "is 0.0 again; a step has two stations, between base and tip"),
    (f"[ {FIRST}, {LAST}, {LAST} ]", "[2].at", "is 1.0 again; a step has two stations, between base and tip"),
    (f"[ {FIRST}, {{ {STATION} }} ]", "[1].at", "is missing; state the place"),
    (f"[ {FIRST}, {{ at = 1.0, rhoA = 1.0 }} ]", "[1].EIy", "is missing; station 0 states it, so all stations must"),
    (f"[ {FIRST}, {{ at = 1.0, EIy = 1.0 }} ]", "[1].rhoA", "is missing; state mass per length"),
    (f"[ {FIRST}, {{ at = 1.0, rhoA = -1.0, EIy = 1.0 }} ]", "[1].rhoA", "is -1.0; it must be > 0"),
    (f"[ {FIRST}, {{ at = 1.0, rhoA = 1.0, EIy = -2.0 }} ]", "[1].EIy", "is -2.0; it must be >= 0"),
    (f"[ {FIRST}, {{ at = 1.0, rhoA = 1.0, EIy = nan }} ]", "[1].EIy", "is nan; it must be a finite number"),
    (
        f"[ {FIRST}, {{ at = 1.0, rhoA = 1.0, EIy = 0.0 }} ]",
        ".EIy",
        "is zero at a station, but modes.bending_z needs it",
    ),
    (f"[ {FIRST}, {{ at = 1.0, {STATION}, EI = 3.0 }} ]", "[1].EI", "is an unknown key; did you mean EI"),
    ("[ 1.0, 2.0 ]", "[0]", "is 1.0; it must be a table of rhoA"),
    (f"{{ stations = [ {FIRST}, {LAST} ], between = 'cubic' }}", ".between", 'is "cubic"; it must be "linear" or'),
    (f"{{ stations = [ {FIRST}, {LAST} ], betwen = 'linear' }}", ".betwen", "is an unknown key; did you mean between?"),
    ("{ stations = 3 }", ".stations", "is 3; it must be an array of tables"),
    (f"{{ stations = [ {WAVY} ], between = 'polynomial' }}", ".between", "the polynomial through rhoA is -"),
]
WRONG_PROFILES = [
    (f"{{ {MATTER} }}", "", "states no shape; state one of tube, rod and box"),
    (f"{{ rod = {{ diameter = 0.1 }}, tube = {{ outer = 0.1, wall = 0.01 }}, {MATTER} }}", "", "states tube and rod;"),
    (f"{{ tube = {{ outer = 0.1 }}, {MATTER} }}", ".tube.wall", "is missing; state the thickness of the wall"),
    (f"{{ tube = {{ outer = [0.1, 0.05], wall = 0.03 }}, {MATTER} }}", ".tube.wall", "is 0.03 at the tip; it must be"),
    (
        f"{{ box = {{ height = 0.1, breadth = 0.02, wall = 0.01 }}, {MATTER} }}",
        ".box.wall",
        "half of the breadth, 0.01",
    ),
    (
        f"{{ box = {{ height = [0.1, 0.1, 0.1], breadth = 0.02 }}, {MATTER} }}",
        ".box.height",
        "is an array of 3; it must",
    ),
    (f"{{ rod = {{ diameter = [0.1, -1.0] }}, {MATTER} }}", ".rod.diameter[1]", "is -1.0; it must be > 0"),
    (f"{{ rod = {{ diamter = 0.1 }}, {MATTER} }}", ".rod.diamter", "is an unknown key; did you mean diameter?"),
    (f"{{ rod = {{ diameter = 1e-5 }}, {MATTER}, nu = 0.3 }}", "", "gives rhoIp = "),
    (f"{{ rod = {{ diameter = [0.01, 1e-5] }}, {MATTER}, nu = 0.3 }}", "", "gives rhoIp = "),
    (f"{{ rod = {{ diameter = 1e4 }}, {MATTER}, nu = 0.3 }}", "", "check the dimensions, or state the section by"),
    ("{ rod = { diameter = 0.1 }, E = 7e10 }", ".density", "is missing; state density"),
    (f"{{ rod = {{ diameter = 0.1 }}, {MATTER}, nu = 0.3, G = 2e10 }}", ".G", "is stated beside nu; either gives"),
    (f"{{ rod = {{ diameter = 0.1 }}, {MATTER}, nu = 0.6 }}", ".nu", "is 0.6; it must be"),
    ("3", "", "is 3; it must be a table of tube, rod, box"),
]


def refused(tmp_path, text: str, where: str, fragment: str) -> None:
    path = tmp_path / "bot.toml"
    path.write_text(text, encoding="utf-8")
    message = refusal(path)
    assert message.startswith(f"links[1].{where} (link fore): ") and fragment in message and "\n" not in message


@pytest.mark.parametrize(("section", "where", "fragment"), WRONG)
def test_wrong_stations_are_refused_in_one_line(tmp_path, section, where, fragment):
    text = GOOD.replace(f"section = {MATERIAL}", f"section = {section}\nmodes = {{ bending_z = 1 }}")
    refused(tmp_path, text, f"section{where}", fragment)


@pytest.mark.parametrize(("profile", "where", "fragment"), WRONG_PROFILES)
def test_wrong_profiles_are_refused_in_one_line(tmp_path, profile, where, fragment):
    refused(tmp_path, GOOD.replace(f"section = {MATERIAL}", f"profile = {profile}"), f"profile{where}", fragment)


def test_profile_and_section_are_one_too_many(tmp_path):
    text = GOOD.replace(
        f"section = {MATERIAL}", f"section = {MATERIAL}\nprofile = {{ rod = {{ diameter = 0.1 }}, {MATTER} }}"
    )
    refused(tmp_path, text, "profile", "is stated beside section")


def test_measured_frequencies_beside_stations_are_refused(tmp_path):
    modes = 'modes = { basis = "clamped_free", bending_z = 1, frequencies = { bending_z = [9.0] } }'
    text = GOOD.replace(f"section = {MATERIAL}", f"section = [ {FIRST}, {LAST} ]\n{modes}")
    refused(
        tmp_path, text, "modes.frequencies.bending_z", "is stated beside stations; measured frequencies are those of a"
    )


@pytest.mark.parametrize("between", ["linear", "polynomial"])
def test_stations_survive_a_file(tmp_path, between):
    robot = tapered_arm()
    for link in robot["links"][:2]:
        places = np.linspace(0, 1, len(link["section"]))
        spread = [x | {"at": float(s)} for x, s in zip(link["section"], places, strict=True)]
        link["section"] = {"stations": spread, "between": between} if between == "polynomial" else link["section"]
    stated = Robot.model_validate(robot)
    assert reloaded(stated, tmp_path) == stated and (between in dump(stated)) == (between == "polynomial")


def test_profiles_survive_a_file_as_line_properties(tmp_path):
    profile = {"tube": {"outer": [0.1, 0.06], "wall": 0.004}, "E": 7e10, "nu": 0.33, "density": 2700.0}
    table = {"name": "boom", "length": 2.0, "profile": profile, "joint": {"axes": ["z"]}}
    robot = Robot.model_validate({"name": "crane", "gravity": [0.0, 0.0, -9.81], "links": [table]})
    assert reloaded(robot, tmp_path) == robot and "profile" not in dump(robot)
    table["profile"] = {"tube": {"outer": 0.1, "wall": 0.004}, "E": 7e10, "density": 2700.0}
    uniform = Robot.model_validate({"name": "crane", "gravity": [0.0, 0.0, -9.81], "links": [table]})
    assert isinstance(uniform.links[0].section, Section) and uniform.links[0].section.GJ is None


def test_material_spelling_at_stations(tmp_path):
    path = tmp_path / "bot.toml"
    thin = MATERIAL.replace("area = 1e-4", "area = 5e-5")
    stations = f"[ {{ at = 0.0, {MATERIAL[1:]}, {{ at = 1.0, {thin[1:]} ]"
    path.write_text(GOOD.replace(f"section = {MATERIAL}", f"section = {stations}"), encoding="utf-8")
    section = load(path).links[1].section
    assert section.values("rhoA") == (0.78, 0.39) and section.values("rhoIp") == (7800.0 * 2e-8,) * 2


def test_parameters_outside_the_rules_are_refused():
    model = model_of(tapered_arm())
    for name, value, allowed in (("boom.section[2].rhoA", 0.0, "> 0"), ("cone.section[0].EIz", 0.0, "> 0"),
                                 ("cone.section[1].EA", -1.0, ">= 0")):  # fmt: skip
        with pytest.raises(UsageError, match="must be " + allowed):
            model.chain.parameters.vector({name: value})
