"""Shear and rotary inertia in robot files: what is refused, in one line, and what profiles know."""

import pytest
import random_robots as rr
from helpers import arm

from screwgen import Robot, RobotFileError, load
from screwgen.spec import Section, Stations

NU = 0.3

WRONG = [  # of a link: section, modes, key path and fragment of the message
    ({}, {"bending_y": 2, "shear_y": 1}, "section.GAy", "is missing, but modes.shear_y needs it; it must be > 0 ("),
    ({"GAz": 0.0}, {"shear_z": 1}, "section.GAz", "is zero, but modes.shear_z needs it"),
    ({"GAy": 1.0}, {"bending_y": 3, "shear_y": 3}, "section.rhoIz", "is missing, but modes.shear_y needs it"),
    ({"GAy": -1.0}, {}, "section.GAy", "is -1.0; it must be >= 0"),
    ({"rhoIy": float("nan")}, {}, "section.rhoIy", "is nan; it must be a finite number"),
    ({"GAx": 1.0}, {}, "section.GAx", "is an unknown key; did you mean GA"),
    ({}, {"shear_y": 33}, "modes.shear_y", "is 33; it must be from 0 to 32"),
    ({"GAy": 1.0}, {"bending_z": 1, "shear_y": 1, "basis": "clamped_free", "frequencies": {"bending_z": [3.0]}},
     "modes.frequencies.bending_z", "is stated beside modes.shear_y; measured frequencies are those of a rod without"),
    ({"rhoIz": 1.0}, {"axial": 1, "frequencies": {"axial": [3.0]}},
     "modes.frequencies.axial", "is stated beside section.rhoIz; measured"),
]  # fmt: skip


@pytest.mark.parametrize("section, modes, where, message", WRONG)
def test_what_makes_no_rod_is_refused_in_one_line(tmp_path, section, modes, where, message):
    path = tmp_path / "bot.toml"
    base = {"rhoA": 1.0} | ({} if "frequencies" in modes else {"EIy": 1.0, "EIz": 1.0})
    table = {"name": "rod", "length": 1.0, "section": base | section, "modes": modes, "joint": {"axes": ["z"]}}
    path.write_text(rr.to_toml({"name": "bot", "gravity": [0.0, 0.0, -9.81], "links": [table]}), encoding="utf-8")
    with pytest.raises(RobotFileError) as error:
        load(path)
    said = str(error.value)
    assert said.startswith(f"{path}: links[0].{where} (link rod): ") and message in said and "\n" not in said


def profiled(shape: dict, **modes) -> Section | Stations:
    matter = {"E": 7e10, "nu": NU, "density": 2700.0}
    table = {"name": "rod", "length": 1.0, "profile": shape | matter, "modes": modes, "joint": {"axes": ["z"]}}
    return Robot.model_validate(arm(table)).links[0].section


@pytest.mark.parametrize("shape, kappa", [  # Cowper, J. Appl. Mech. 33, 1966
    ({"rod": {"diameter": 0.1}}, 6 * (1 + NU) / (7 + 6 * NU)),
    ({"box": {"height": 0.1, "breadth": 0.05}}, 10 * (1 + NU) / (12 + 11 * NU)),
    ({"tube": {"outer": 0.1, "wall": 1e-6}}, 2 * (1 + NU) / (4 + 3 * NU)),
    ({"box": {"height": 0.1, "breadth": 0.1, "wall": 0.001}}, 20 * (1 + NU) / (48 + 39 * NU)),
])  # fmt: skip
def test_profiles_know_cowpers_coefficients(shape, kappa):
    section, plain = profiled(shape, bending_y=2, shear_y=1), profiled(shape, bending_y=2)
    assert section.GAy == section.GAz and abs(section.GAy / (section.EA / (2 * (1 + NU))) / kappa - 1) < 1e-4
    assert section.rhoIy == pytest.approx(section.EIy * 2700.0 / 7e10)
    assert section.rhoIy + section.rhoIz == pytest.approx(section.rhoIp)
    assert plain.GAy is None and plain.rhoIy is None and plain.EIy == section.EIy


def test_a_high_box_shears_less_along_its_height():
    tall = profiled({"box": {"height": 0.2, "breadth": 0.1, "wall": 0.004}}, shear_z=1)
    area = 2 * 0.004 * (0.2 - 0.004)
    assert tall.GAz > tall.GAy and abs(tall.GAz / (7e10 / (2 * (1 + NU)) * area) - 1) < 0.15
    taper = profiled({"box": {"height": [0.2, 0.1], "breadth": 0.1, "wall": 0.004}}, shear_z=1)
    assert taper.values("GAz")[0] == tall.GAz and taper.values("rhoIy")[0] == tall.rhoIy
