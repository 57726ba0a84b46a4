"""The derived blocks against textbook inertia and laws of mechanics."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

from screwgen.bodies.link import LinkBlock
from screwgen.ir.block import Block
from screwgen.joints.product import product
from screwgen.joints.screw import Screw
from screwgen.spec.link_class import BodyClass, LinkClass


def link_class(basis="polynomial", counts=(1, 2, 1, 1), **given) -> LinkClass:
    """A class of one revolute link that has `given` besides its modes."""
    flags = ("mount_xyz", "mount_rpy", "armature", "joint_damping", "stiffness", "frame_at")
    absent = dict.fromkeys(flags, False)
    structure = {
        "joint": product([Screw((0.0, 0.0, 1.0))]),
        "spin": True,
        "section_rotation": True,
        "bodies": (),
        "damping": (),
    }
    return LinkClass(bases=(basis,) * 4, counts=counts, **(absent | structure | given))


CLASSES = {
    "polynomial": link_class(),
    "clamped_free": link_class("clamped_free", (2, 2, 2, 1)),
    "frame moved": link_class(counts=(1, 1, 2, 0), frame_at=True),
    "base body": link_class(counts=(1, 1, 1, 1), bodies=(BodyClass("base", True, True),), frame_at=True),
    "no spin": link_class(counts=(1, 1, 1, 0), spin=False),
}
every_class = pytest.mark.parametrize("name", CLASSES)


@cache
def block_of(name: str) -> LinkBlock:
    return LinkBlock(CLASSES[name])


@cache
def parameters(name: str) -> dict[str, np.ndarray]:
    """A value of every parameter of a block."""
    rng = np.random.default_rng(len(name))
    block = block_of(name)
    values = {n: rng.uniform(0.5, 2.0, s.shape) for n, s in block.inputs.items() if s.binding == 1}
    if "frame_at" in values:
        values["frame_at"] = np.array([[0.3]])
    if "body0_inertia" in values:
        values["body0_inertia"] = np.array([[0.5, 0.6, 0.7, 0.05, -0.1, 0.02]]).T
    return values


def state(block: Block, seed=0, **fixed) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(seed)
    values = {n: rng.normal(size=s.shape) for n, s in block.inputs.items() if s.binding == 2}
    return values | fixed


def numbers(block: Block, given: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Every signal of a block at given inputs, step by step as they are written."""
    known = {}
    for name, signal in block.inputs.items():
        array = np.asarray(given[name], float).reshape(signal.shape)
        known |= dict(zip(block.values[name].flat, map(sp.Float, array.flat), strict=True))
    for step in block.steps.values():
        known |= {symbol: sp.Float(expression.xreplace(known)) for symbol, expression in step.assignments}
    plain = lambda entry: float(sp.sympify(entry).xreplace(known))  # noqa: E731
    return {n: np.vectorize(plain, otypes=[float])(block.values[n]) for n in (*block.inputs, *block.steps)}


def hat(a) -> np.ndarray:
    return np.cross(np.eye(3), np.ravel(a))


def nu(given) -> np.ndarray:
    return np.concatenate([given[n].ravel() for n in ("omega", "v", "etadot")])


# -------- mechanics of one block


def inertia(found: dict) -> np.ndarray:
    """The differential-modal block: [M_V M_D; M_Dphi M_Wphi]."""
    return np.block([[found["M_V"], found["M_D"]], [found["M_Dphi"], found["M_Wphi"]]])


@every_class
def test_inertia_of_a_link_is_symmetric_and_semidefinite(name):
    block = block_of(name)
    for seed in range(5):
        found = numbers(block, parameters(name) | state(block, seed))
        M = inertia(found)
        assert np.array_equal(found["M_Dphi"], found["M_D"].T)
        assert np.allclose(M, M.T, rtol=0, atol=1e-14 * np.abs(M).max())
        values = np.linalg.eigvalsh(M)
        assert values[0] >= -1e-12 * values[-1]
        assert not CLASSES[name].spin or values[0] > 0


def test_a_link_without_spin_inertia_is_singular_at_every_deflection():
    """y and z bend in the same shapes: the centreline stays in a plane and nothing resists a turn about its chord."""
    key = link_class(counts=(0, 1, 1, 0), spin=False)
    block = LinkBlock(key)
    given = {"length": np.array([[1.2]]), "rhoA": np.array([[2.0]]), "EIz": np.ones((1, 1)), "EIy": np.ones((1, 1))}
    for eta in ([0.0, 0.0], [0.3, -0.2]):
        values = np.linalg.eigvalsh(inertia(numbers(block, given | state(block, eta=np.array([eta]).T))))
        assert abs(values[0]) < 1e-14 * values[-1]


def change(block, given: dict) -> tuple[np.ndarray, np.ndarray]:
    """dM/dt along etadot, and dM/deta_k: exact, for M is quadratic in eta."""
    at = lambda d: inertia(numbers(block, given | {"eta": given["eta"] + d}))  # noqa: E731
    slopes = [(at(e[:, None]) - at(-e[:, None])) / 2 for e in np.eye(given["eta"].size)]
    return np.tensordot(given["etadot"].ravel(), slopes, 1), np.array(slopes)


@every_class
def test_a_free_link_keeps_its_momentum(name):
    """Without weight the six rows are the rate of momentum: h_V = Mdot nu + [omega x L + v x P; omega x P]."""
    block = block_of(name)
    given = parameters(name) | state(block, 1, g=np.zeros((3, 1)))
    found, (M_dot, _) = numbers(block, given), change(block, given)
    omega, v = given["omega"].ravel(), given["v"].ravel()
    momentum = inertia(found)[:6] @ nu(given)
    turned = [*np.cross(omega, momentum[:3]) + np.cross(v, momentum[3:]), *np.cross(omega, momentum[3:])]
    expected = M_dot[:6] @ nu(given) + turned
    assert np.allclose(found["h_V"].ravel(), expected, rtol=1e-12, atol=1e-12 * np.abs(expected).max())


@every_class
def test_modal_rows_are_lagranges(name):
    """h_eta = d/dt dT/detadot - dT/deta without accelerations and weight."""
    block = block_of(name)
    given = parameters(name) | state(block, 2, g=np.zeros((3, 1)))
    found, (M_dot, slopes) = numbers(block, given), change(block, given)
    expected = M_dot[6:] @ nu(given) - 0.5 * np.einsum("i,kij,j->k", nu(given), slopes, nu(given))
    assert np.allclose(found["h_eta"].ravel(), expected, rtol=1e-12, atol=1e-12 * np.abs(expected).max())


def test_straight_beam_is_the_textbooks():
    """M* (27): m = rho A l, S = m l / 2, I = m l^2 / 3 diag(0, 1, 1) and the spin inertia about x."""
    found = numbers(block_of("polynomial"), (p := parameters("polynomial")) | state(block_of("polynomial")))
    length, m = p["length"].item(), p["rhoA"].item() * p["length"].item()
    I = np.diag([p["rhoIp"].item() * length, m * length**2 / 3, m * length**2 / 3])
    S = hat([m * length / 2, 0, 0])
    assert np.allclose(found["M_star"], np.block([[I, S], [-S, m * np.eye(3)]]), rtol=1e-14)
    assert np.allclose(found["M_V"], found["M_star"] + found["M_DPsi"], rtol=1e-13)


def test_modal_inertia_and_stiffness_are_diagonal():
    """rho A l for displacements, rho I_p l for torsion; EI lambda^4 / l^3 for clamped-free bending (88)."""
    p = parameters("clamped_free")
    found = numbers(block_of("clamped_free"), p | state(block_of("clamped_free")))
    length = p["length"].item()
    assert np.array_equal(found["M_Wphi"], np.diag(found["M_eta"].ravel()))
    assert np.array_equal(found["K_full"], np.diag(found["K"].ravel()))
    assert np.allclose(
        found["M_eta"].ravel(), [p["rhoA"].item() * length] * 6 + [p["rhoIp"].item() * length], rtol=1e-14
    )
    assert np.isclose(found["K"][2, 0], p["EIz"].item() * 1.8751040687119611**4 / length**3, rtol=1e-13)
