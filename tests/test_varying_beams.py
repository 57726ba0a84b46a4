"""Tapered, stepped and conical beams: published frequencies, finite beam elements, profiles."""

import math

import numpy as np
import pytest
import scipy.integrate
from beam_arms import random_arm, with_modes
from beam_elements import frequencies
from helpers import model_of
from oracle_sections import property_at
from varying_robots import tapered_arm

from screwgen.spec.profile import Profile
from screwgen.studies.modes import natural_frequencies

E, DENSITY, LENGTH, HEIGHT, BREADTH = 2e11, 7850.0, 1.3, 0.02, 0.03
TAPERS = {(0.4, 0.4): (4.31878, 20.04998, 51.33463), (0.0, 0.8): (5.39759, 25.65583, 65.74696)}
"""Clamped-free: (1 - tip/base) of height and breadth, and omega sqrt(rho A0 L^4 / (E I0))."""


def wedge(taper, plane: str = "bending_z", modes: int = 10) -> dict:
    """A solid box that bends over its height (in z), or turned about its axis (in y)."""
    size = [[x, x * (1 - c)] for x, c in zip((HEIGHT, BREADTH), taper, strict=True)]
    height, breadth = size if plane == "bending_z" else size[::-1]
    profile = {"box": {"height": height, "breadth": breadth}, "E": E, "density": DENSITY}
    link = {"name": "wedge", "length": LENGTH, "profile": profile, "modes": {plane: modes}, "joint": {"axes": []}}
    return {"name": "beam", "gravity": [0.0, 0.0, 0.0], "links": [link]}


def dimensionless(hertz) -> np.ndarray:
    area, inertia = HEIGHT * BREADTH, BREADTH * HEIGHT**3 / 12
    return 2 * np.pi * np.asarray(hertz) * math.sqrt(DENSITY * area * LENGTH**4 / (E * inertia))


@pytest.mark.parametrize("plane", ["bending_y", "bending_z"])
@pytest.mark.parametrize("taper", TAPERS)
def test_published_tapers(taper, plane):
    found = dimensionless(natural_frequencies(model_of(wedge(taper, plane))))
    assert found[:3] == pytest.approx(TAPERS[taper], rel=1e-6)


@pytest.mark.parametrize("taper", TAPERS)
def test_published_tapers_by_the_judge(taper):
    robot = wedge(taper)
    sections = [{"at": s, **Profile.model_validate(robot["links"][0].pop("profile")).line(s)} for s in [0.0]]
    assert sections[0]["rhoA"] == pytest.approx(DENSITY * HEIGHT * BREADTH)
    robot["links"][0]["section"] = {"stations": stations(taper), "between": "polynomial"}
    assert dimensionless(frequencies(robot, [], "locked"))[:3] == pytest.approx(TAPERS[taper], rel=1e-6)


def stations(taper) -> list[dict]:
    """By hand: the line properties of the wedge at five places."""
    out = []
    for s in np.linspace(0, 1, 5):
        h, b = HEIGHT * (1 - taper[0] * s), BREADTH * (1 - taper[1] * s)
        inertia = (b * h**3 / 12, h * b**3 / 12)
        line = {"rhoA": DENSITY * b * h, "EIy": E * inertia[0], "EIz": E * inertia[1], "rhoIp": DENSITY * sum(inertia)}
        out.append({"at": float(s), **line})
    return out


def test_linear_stations_converge_to_the_taper():
    """Linear interpolation of the quartic stiffness errs by the square of the stations' distance."""
    errors = []
    for count in (2, 4, 8):
        robot = wedge((0.4, 0.4), modes=7)
        profile = Profile.model_validate(robot["links"][0].pop("profile"))
        robot["links"][0]["section"] = [{"at": float(s), **profile.line(s)} for s in np.linspace(0, 1, count + 1)]
        found = dimensionless(natural_frequencies(model_of(robot)))[0]
        errors.append(found / TAPERS[0.4, 0.4][0] - 1)
    assert errors[0] > 1e-3 and np.allclose(np.divide(errors[:2], errors[1:]), 4, rtol=0.05)


def shrunk(section: dict, tip: float) -> dict:
    """The section of a part whose dimensions are `tip` times as large."""
    return {key: x * tip ** (4 if key in ("EIy", "EIz", "GJ", "rhoIp") else 2) for key, x in section.items()}


@pytest.mark.parametrize("joints", ["locked", "free"])
def test_tapered_arm_in_space_equals_finite_elements(joints):
    """Offset centres of mass, mounts, skew axes, torsion: the eight lowest frequencies."""
    arm, q = random_arm(2)
    for link in arm["links"]:
        link["section"] = [{"at": 0.0, **link["section"]}, {"at": 1.0, **shrunk(link["section"], 0.75)}]
    found = natural_frequencies(model_of(with_modes(arm, 6, 5)), q, joints)
    judge = frequencies(with_modes(arm, 2, 1), q, joints)
    assert np.max(np.abs(found[found > 0][:8] / judge[:8] - 1)) < 1e-4


def test_stepped_beam_nears_finite_elements():
    """The curvature jumps at a step, which smooth shapes follow slowly."""
    thick = {"rhoA": 2.0, "EIy": 300.0}
    thin, errors = shrunk(thick, 0.75), []
    section = [{"at": s, **line} for s, line in ((0.0, thick), (0.45, thick), (0.45, thin), (1.0, thin))]
    for modes in (2, 4, 8):
        robot = wedge((0.0, 0.0), modes=modes)
        robot["links"][0] |= {"section": section, "profile": None}
        judge, found = frequencies(robot, [], "locked")[:2], natural_frequencies(model_of(robot))[:2]
        errors.append(found / judge - 1)
    assert (errors[0] > errors[1]).all() and (errors[1] > errors[2]).all() and 1e-3 < errors[2].max() < 0.02


def test_rigid_varying_link_on_a_spring():
    """The judge's rigid direction of varying mass, and ours."""
    robot = tapered_arm()
    cone = robot["links"][1] | {"modes": {}, "joint": {"axes": ["y", "z"], "stiffness": [3.0, 5.0]}, "bodies": []}
    robot["links"] = [{key: value for key, value in cone.items() if value != {}}]
    model = model_of(robot)
    assert frequencies(robot, [0.0, 0.0], "free") == pytest.approx(
        natural_frequencies(model, [0.0, 0.0], "free"), rel=1e-9
    )


SHAPES = {
    "tube": {"tube": {"outer": [0.1, 0.06], "wall": 0.004}},
    "thinning tube": {"tube": {"outer": 0.1, "wall": [0.01, 0.002]}},
    "rod": {"rod": {"diameter": [0.03, 0.01]}},
    "box": {"box": {"height": [0.1, 0.06], "breadth": 0.05, "wall": 0.004}},
}


@pytest.mark.parametrize("name", SHAPES)
def test_tapered_profiles_are_exact_between_their_stations(name):
    profile = Profile.model_validate({**SHAPES[name], "E": 7e10, "nu": 0.33, "density": 2700.0})
    section = profile.section()
    assert section.between == "polynomial" and len(section.stations) == 5
    for s in (0.1, 0.4, 0.6, 0.9):
        line = profile.line(s)
        stated = {"stations": [station.model_dump() for station in section.stations], "between": "polynomial"}
        for key in ("rhoA", "EA", "EIy", "EIz", "rhoIp") + (("GJ",) if name != "box" else ()):
            assert property_at(stated, key, np.array([s]))[0] == pytest.approx(line[key], rel=1e-13)
        assert property_at(stated, "GJ", np.array([s]))[0] == pytest.approx(line["GJ"], rel=1e-5)


def test_profiles_have_the_moments_of_their_shapes():
    line = Profile.model_validate({"tube": {"outer": 0.1, "wall": 0.01}, "E": 3.0, "G": 2.0, "density": 5.0}).line(0.0)
    ring = scipy.integrate.quad(lambda r: 2 * math.pi * r, 0.04, 0.05)[0]
    polar = scipy.integrate.quad(lambda r: 2 * math.pi * r**3, 0.04, 0.05)[0]
    expected = {
        "rhoA": 5 * ring,
        "EA": 3 * ring,
        "EIy": 1.5 * polar,
        "EIz": 1.5 * polar,
        "GJ": 2 * polar,
        "rhoIp": 5 * polar,
    }
    assert line == pytest.approx(expected)
    box = Profile.model_validate({"box": {"height": 0.2, "breadth": 0.1}, "E": 1.0, "G": 1.0, "density": 1.0}).line(0.0)
    assert box["EIy"] == pytest.approx(0.1 * 0.2**3 / 12) and box["EIz"] == pytest.approx(0.2 * 0.1**3 / 12)
    assert box["GJ"] == pytest.approx(0.2286819 * 0.2 * 0.1**3, rel=1e-6)
    square = Profile.model_validate({"box": {"height": 0.1, "breadth": 0.1}, "E": 1.0, "G": 1.0, "density": 1.0})
    assert square.line(0.0)["GJ"] == pytest.approx(0.1405770 * 0.1**4, rel=1e-6)
    thin = {"box": {"height": 0.1, "breadth": 0.1, "wall": 1e-4}, "E": 1.0, "nu": 0.25, "density": 1.0}
    assert Profile.model_validate(thin).line(0.0)["GJ"] == pytest.approx(0.4 * 1e-4 * (0.1 - 1e-4) ** 3)


def test_a_uniform_profile_is_a_uniform_section():
    robot = wedge((0.0, 0.0))
    model = model_of(robot)
    assert not model.chain.coupled and "wedge.rhoA" in model.parameter_names
    assert dimensionless(natural_frequencies(model))[0] == pytest.approx(1.8751040687**2, rel=1e-9)
