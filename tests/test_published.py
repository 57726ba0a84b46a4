"""Frequencies from textbooks and papers, by the package and by the oracle."""

import numpy as np
import pytest
from helpers import arm, link, model_of
from oracle import Oracle

from screwgen import natural_frequencies

ROOTS = [1.8751040687119611, 4.694091132974175, 7.854757438237613]
"""The first roots of cos x cosh x = -1."""


def frequencies(robot: dict, joints=None, how="locked") -> np.ndarray:
    """Natural frequencies in Hz at these joint coordinates, which the oracle has too."""
    model = model_of(robot)
    q = np.zeros(model.nq) if joints is None else np.append(joints, np.zeros(model.nq - model.n_joints))
    found, judged = natural_frequencies(model, q, how), Oracle(robot).frequencies(q, how)
    assert np.allclose(found**2, judged**2, rtol=1e-7, atol=1e-9 * max(judged) ** 2)
    return found


def clamped(bodies=None, **modes) -> np.ndarray:
    """Angular frequencies of a welded beam with all properties 1: then omega = (beta L)^2."""
    table = link(axes=[], modes={"basis": "polynomial", **modes}, bodies=bodies, section={"rhoIp": 1.0})
    return 2 * np.pi * frequencies(arm(table, gravity=[0, 0, 0]))


# -------- one beam


@pytest.mark.parametrize("direction", ["bending_y", "bending_z"])
def test_clamped_free_beam(direction):
    """beta L to 1e-9 by its own modes; by eight polynomials the first three to 1e-6, from above."""
    exact = clamped(basis="clamped_free", **{direction: 3})
    assert np.allclose(np.sqrt(exact), ROOTS, rtol=1e-9)
    ritz = np.sqrt(clamped(**{direction: 8})[:3])
    assert np.allclose(ritz, ROOTS, rtol=1e-6) and np.all(ritz > np.array(ROOTS) * (1 - 1e-12))


@pytest.mark.parametrize("direction", ["bending_y", "bending_z"])
@pytest.mark.parametrize(
    ("mu", "j", "omega"),
    [(1, 0, (1.557298, 16.250085)), (0.1, 0, (2.967838, 19.355801)), (1, 1, (0.867900, 3.390572))],
)
def test_clamped_beam_with_a_tip_body(direction, mu, j, omega):
    """Mass ratio mu and inertia ratio j: the first frequency from four polynomials on, the second from six."""
    tip = [{"at": "tip", "mass": mu, "inertia": [j, j, j, 0, 0, 0]}]
    assert np.isclose(clamped(tip, **{direction: 4})[0], omega[0], rtol=1e-5)
    assert np.allclose(clamped(tip, **{direction: 6})[:2], omega, rtol=1e-5)


def test_axial_and_torsional_rods():
    """A fixed-free rod: (2k - 1) pi / 2 times the wave's speed over the length."""
    section = {"rhoA": 1.3, "EA": 4e3, "GJ": 7.0, "rhoIp": 2e-3}
    table = link(length=0.8, axes=[], modes={"basis": "clamped_free", "axial": 2, "torsion": 2}, section=section)
    speeds = np.sqrt([4e3 / 1.3, 4e3 / 1.3, 7 / 2e-3, 7 / 2e-3])
    expected = speeds * np.array([1, 3, 1, 3]) / (4 * 0.8)
    assert np.allclose(frequencies(arm(table)), np.sort(expected), rtol=1e-12)


# -------- De Luca and Siciliano's two-link arm


def de_luca_siciliano(modes: int) -> dict:
    """rho A = 0.2 kg/m, l = 0.5 m, EI = 1 N m^2; hubs 0.1 kg m^2, elbow 1 kg, payload 0.1 kg and 0.0005 kg m^2."""
    bending, section = {"basis": "polynomial", "bending_y": modes}, {"rhoA": 0.2, "EIz": 1.0}
    elbow = {"at": "base", "mass": 1.0, "inertia": [0, 0.1, 0.1, 0, 0, 0]}
    payload = {"at": "tip", "mass": 0.1, "inertia": [0, 0.0005, 0.0005, 0, 0, 0]}
    return arm(
        link("first", 0.5, "z", modes=bending, section=section, joint={"armature": [0.1]}),
        link("second", 0.5, "z", modes=bending, section=section, bodies=[elbow, payload]),
    )


def test_de_luca_siciliano_second_link():
    """Clamped with its payload: 2.178334 and 15.914513 Hz."""
    payload = [{"at": "tip", "mass": 0.1, "inertia": [0, 0.0005, 0.0005, 0, 0, 0]}]
    modes = {"basis": "polynomial", "bending_y": 8}
    table = link(length=0.5, axes=[], modes=modes, section={"rhoA": 0.2, "EIz": 1.0}, bodies=payload)
    assert np.allclose(frequencies(arm(table))[:2], [2.178334, 15.914513], atol=6e-7)


def test_de_luca_siciliano_arm_locked():
    """A converged beam finite-element model, straight: 0.4381, 1.9728, 2.6689, 16.118 Hz."""
    found = frequencies(de_luca_siciliano(6))[:4]
    assert np.allclose(found, [0.4381, 1.9728, 2.6689, 16.118], rtol=0, atol=[5e-5, 5e-5, 5e-5, 5e-4])


def test_de_luca_siciliano_arm_free():
    """Both joints free: two rigid motions, then 1.4199, 2.6473, 16.117, 22.126 Hz."""
    found = frequencies(de_luca_siciliano(6), how="free")
    assert found[:2].tolist() == [0.0, 0.0]
    assert np.allclose(found[2:6], [1.4199, 2.6473, 16.117, 22.126], rtol=0, atol=[5e-5, 5e-5, 5e-4, 5e-4])


# -------- the paper's arm


SETPOINTS = (-0.4928, 0.6922, 0.4270)


def ella(count=2, basis="polynomial", section_rotation=True) -> dict:
    section = {"rhoA": 1.6302, "EA": 4.38e7, "EIy": 2.12e3, "EIz": 3.67e3, "rhoIp": 2.15e-4}
    modes = {"basis": basis, "axial": 1, "bending_y": count, "bending_z": count}
    upper = link("upper", 0.95, "yz", modes=modes, section=section, bodies=[{"at": "tip", "mass": 3.3}])
    fore = link("fore", 0.93, "z", modes=modes, section=section, bodies=[{"at": "tip", "mass": 2.1}])
    return arm(upper, fore, section_rotation=section_rotation)


@pytest.mark.parametrize(
    ("arguments", "expected", "atol"),
    [
        ((4,), [2.8807, 3.6956], 6e-5),
        ((2,), [2.8808, 3.6957], 6e-5),
        ((5, "clamped_free"), [2.911, 3.739], 6e-4),
        ((5, "polynomial", False), [4.7341, 6.2905], 6e-5),
    ],
    ids=["converged", "two polynomials", "five clamped-free modes", "without section rotation"],
)
def test_ella_locked(arguments, expected, atol):
    """The paper's arm at its set points, joints locked: the section's rotation matters."""
    assert np.allclose(frequencies(ella(*arguments), SETPOINTS)[:2], expected, rtol=0, atol=atol)


def test_ellas_axial_modes_are_far_beyond_a_control_loop():
    """About 1.4 kHz with one axial mode each and what the links carry."""
    assert 1000 < frequencies(ella(1, "clamped_free"))[-1] < 1600


# -------- loads that turn with the beam


TAPERED = {0: (3.82379, 18.3173), 4: (5.87876, 20.6852), 12: (13.4711, 34.0877)}
"""Flapwise frequencies of a rotating beam whose height falls linearly to half, over √(EI₀ / ρA₀ L⁴), by the rate."""


def test_a_tapered_beam_that_rotates():
    height = {"box": {"height": [1.0, 0.5], "breadth": 1.0}, "E": 12.0, "density": 1.0, "nu": 0.3}
    blade = {"name": "blade", "length": 1.0, "profile": height, "modes": {"bending_z": 6}, "joint": {"axes": ["z"]}}
    model = model_of(arm(blade, gravity=[0, 0, 0], order=2))
    for rate, expected in TAPERED.items():
        found = 2 * np.pi * natural_frequencies(model, joints="locked", rates=[float(rate)])
        assert np.allclose(found[:2], expected, rtol=[1e-5, 2e-4], atol=0)


def test_a_column_under_a_load_that_follows_its_tip():
    """Beck's column flutters at P L² / EI = 20.0509; it never buckles."""
    model = model_of(arm(link(axes=[], modes={"bending_z": 5}), gravity=[0, 0, 0], order=2))
    growth = lambda load: np.max(model.linearise([0] * 5, w_ext=[[0, 0, 0, -load, 0, 0]]).eigenvalues().real)  # noqa: E731
    assert growth(20.045) < 1e-6 and growth(20.06) > 0.1
