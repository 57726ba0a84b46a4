"""Measured frequencies as runtime parameters, as structure, and what they amount to."""

from __future__ import annotations

import copy
import re
import tomllib

import numpy as np
import pytest
from helpers import ROOT, arm, example, example_dict, link, model_of, quick
from measured_robots import BARE, FOUND, by_frequencies, clamped, counted, flat, rod
from oracle_link import STIFFNESS_OF, line_properties

from screwgen import Robot, ScrewgenError, derive, natural_frequencies
from screwgen.backends.latex import document as latex
from screwgen.runtime.memory import pointer
from screwgen.spec import Link, equivalent_stiffness, parameters
from screwgen.topology.chain import Chain

# -------- frequencies are runtime parameters


def test_frequencies_are_parameters_after_the_section():
    found = [p for p in parameters(Robot.model_validate(rod())) if p.unit == "Hz"]
    assert [p.name for p in found] == [f"rod.frequencies.{d}[{k}]" for d in FOUND for k in range(len(FOUND[d]))]
    assert [p.value for p in found] == [f for values in FOUND.values() for f in values]
    assert (found[3].field, found[3].index, found[3].link) == ("frequencies.bending_y", (1,), 0)
    assert all("bare link" in p.description for p in found)


def changed(model, **values) -> list[float]:
    """The parameters with some frequencies of the rod changed: `bending_y_1=25.0`."""
    p = list(model.parameter_values)
    for name, value in values.items():
        direction, _, k = name.rpartition("_")
        p[model.parameter_names.index(f"rod.frequencies.{direction}[{k}]")] = value
    return p


def test_a_parameter_moves_its_frequency():
    model = model_of(rod())
    expected = copy.deepcopy(FOUND)
    expected["bending_y"][0], expected["torsion"][0] = 24.0, 333.0
    found = natural_frequencies(model, parameters=changed(model, bending_y_0=24.0, torsion_0=333.0))
    assert np.allclose(found, flat(expected), rtol=1e-12, atol=0)


@pytest.mark.parametrize(
    ("value", "message"),
    [(0.0, "bad argument"), (-20.0, "bad argument"), (float("nan"), "non-finite"), (1e300, "non-finite")],
)
def test_c_refuses_frequencies_that_are_none(value, message):
    model = model_of(rod())
    compiled = quick(model)
    for name in ("axial_1", "bending_y_0", "bending_z_0", "torsion_0"):
        with pytest.raises(ScrewgenError, match=message):
            given = np.array(changed(model, **{name: value}))
            compiled.check(compiled.library.shim_prepare(compiled.memory, pointer(given)))
    compiled.prepare(None)


# -------- structure


def test_which_directions_are_measured_is_structure_and_their_values_are_not():
    tables = [
        link("a", section=BARE, modes=None) | {"modes": counted({"bending_y": [20.0]})},
        link("b", section=BARE, modes=None) | {"modes": counted({"bending_y": [31.0]})},
        link("c", section=BARE | {"EIz": 30.0}, modes=None) | {"modes": {"bending_y": 1}},
    ]
    first, second, third = Chain(Robot.model_validate(arm(*tables))).keys
    assert first == second != third and first.measured == ("bending_y",) and third.measured == ()


def test_a_section_without_any_stiffness_is_enough():
    """Mass alone: by line property, or by density and area."""
    frequencies = {"axial": [900.0], "bending_y": [20.0], "bending_z": [27.0]}
    for section in ({"rhoA": 0.78}, {"density": 7800.0, "area": 1e-4}):
        found = natural_frequencies(model_of(rod(frequencies, section=section)))
        assert np.allclose(found, flat(frequencies), rtol=1e-12, atol=0)


def test_the_header_of_the_c_states_them(tmp_path):
    model_of(rod()).write(tmp_path / "out", targets=("c",))
    header = (tmp_path / "out" / "c" / "arm.h").read_text()
    assert "frequencies_torsion[1]; /* Hz: " in header and "a negative mass or frequency" in header


def test_the_document_shows_the_wavenumber_identification():
    (second,) = rod({"bending_y": [5.0, 40.0]})["links"]
    second |= {"name": "second", "section": BARE | {"EIy": 100.0}}
    second["modes"]["bending_z"] = 2
    text = latex.document(Robot.model_validate(arm(*rod()["links"], second))).replace(" & = ", " = ")
    assert r"\boldsymbol{\omega}_n = 2 \pi\,\mathbf{f}_n" in text
    assert r"\mathbf{K}_i\,\mathbf{1} + \operatorname{diag}\left(\boldsymbol{\omega}_n\right)^{2}" in text
    assert text.count("{(wavenumber)}") == 2
    assert r"$\mathbf{f}_{y,i}$" in text and "measured frequencies" in text
    assert "wavenumber" not in latex.document(example("ella").robot)


# -------- what the frequencies amount to, and what they are not


@pytest.mark.parametrize("name", ["ella", "six_link"])
def test_equivalent_stiffness_gives_the_stiffness_back(name):
    robot = example_dict(name)
    for table in robot["links"]:
        table.get("modes", {}).pop("basis", None)
    measured = Robot.model_validate(by_frequencies(robot))
    for table, part in zip(robot["links"], measured.links, strict=True):
        line = line_properties(table["section"])
        for d, values in equivalent_stiffness(part).items():
            assert np.allclose(values, line[STIFFNESS_OF[d]], rtol=1e-13)
    assert any(map(equivalent_stiffness, measured.links))


def test_equivalent_stiffness_of_a_link_that_is_no_uniform_beam():
    """Mode by mode: by the square of the frequency's ratio to the uniform beam's."""
    table = rod({"bending_z": [10.0, 10.0 * (4.694091132974175 / 1.8751040687119611) ** 2 * 1.1]})["links"][0]
    first, second = equivalent_stiffness(Link(**table))["bending_z"]
    assert np.isclose(second / first, 1.21, rtol=1e-12)
    assert equivalent_stiffness(example("ella").robot.links[0]) == {}


def test_the_equivalent_stiffness_of_the_readmes_link():
    text = (ROOT / "docs" / "frequencies.md").read_text(encoding="utf-8")
    table = tomllib.loads(re.search(r"```toml\n(section = .*?frequencies.*?)```", text, re.DOTALL)[1])
    found = equivalent_stiffness(Link(name="upper_arm", length=0.95, joint={"axes": ["y", "z"]}, **table))
    first, second = found["bending_y"]
    assert f"gives the EI that each mode amounts to, above {first:.0f} and\n  {second:.0f} N·m² in y" in text


def test_the_frequency_of_an_arm_is_not_the_frequency_of_its_links():
    """ELLA: its bare upper arm has 22.4 and 29.4 Hz, the whole arm 3.0 Hz at q = 0. From 2 Hz, EI is 17 N·m²."""
    upper = example_dict("ella")["links"][0]
    assert np.allclose([*clamped(upper)["bending_z"], *clamped(upper)["bending_y"]], [22.360, 29.420], atol=5e-4)
    robot = by_frequencies(example_dict("ella"))
    assert np.isclose(natural_frequencies(model_of(robot))[0], 2.997, atol=5e-4)
    for table in robot["links"]:
        table["modes"]["frequencies"] |= {"bending_y": [2.0], "bending_z": [2.0]}
    wrong = derive(Robot.model_validate(robot))
    assert np.isclose(equivalent_stiffness(wrong.robot.links[0])["bending_z"][0], 16.96, atol=5e-3)
    assert natural_frequencies(wrong)[0] < 0.27
