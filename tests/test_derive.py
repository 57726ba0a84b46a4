"""The derived blocks against numeric quadrature of the kinematic field, textbook inertia, and laws of mechanics."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

from screwgen.bodies.energy import energy_block
from screwgen.bodies.link import LinkBlock
from screwgen.ir.block import Block
from screwgen.joints.product import product
from screwgen.joints.screw import Screw
from screwgen.spec.link_class import BodyClass, LinkClass

DIRECTIONS = ("axial", "bending_y", "bending_z", "torsion")


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


# -------- quadrature


class Field:
    """The kinematic field of a link at Gauss points, from the bases' own functions."""

    def __init__(self, key: LinkClass, given: dict[str, np.ndarray], points=40):
        nodes, weights = np.polynomial.legendre.leggauss(points)
        self.s, self.length = (nodes + 1) / 2, given["length"].item()
        start = -given["frame_at"].item() if key.frame_at else 0.0
        self.xi, self.weights = start + self.length * self.s, weights / 2 * self.length
        counts = dict(zip(DIRECTIONS, key.counts, strict=True))
        self.shapes = {d: key.shapes(d) for d in counts}
        self.order = [(d, k) for d, n in counts.items() for k in range(n)]
        self.rhoA = given["rhoA"].item()
        self.rhoIp = given["rhoIp"].item() if key.spin else 0.0

    def table(self, derivative=0) -> np.ndarray:
        """(r, N): the shape of every mode, derivatives by xi."""
        values = {d: np.array(f.evaluate(self.s, derivative)) for d, f in self.shapes.items() if f.count}
        return np.array([values[d][k] for d, k in self.order]) / self.length**derivative

    def Phi(self) -> np.ndarray:
        """(N, 3, r)."""
        out, rows = np.zeros((len(self.s), 3, len(self.order))), {"axial": 0, "bending_y": 1, "bending_z": 2}
        for k, ((d, _), shape) in enumerate(zip(self.order, self.table(), strict=True)):
            if d in rows:
                out[:, rows[d], k] = shape
        return out

    def spin_row(self) -> np.ndarray:
        """(N, 6 + r): omega_x and the torsion's rate of every section."""
        torsion = [
            shape if d == "torsion" else 0 * shape for (d, _), shape in zip(self.order, self.table(), strict=True)
        ]
        return np.column_stack([np.tile([1.0, 0, 0, 0, 0, 0], (len(self.s), 1)), *torsion])

    def integral(self, values: np.ndarray, weight: float) -> np.ndarray:
        return weight * np.tensordot(self.weights, values, 1)


def hat(a) -> np.ndarray:
    return np.cross(np.eye(3), np.ravel(a))


def quadrature(name: str, given: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """M and h of the link by quadrature of ``rho A N^T N`` and ``rho A N^T (...)``; base bodies apart."""
    key, f = CLASSES[name], Field(CLASSES[name], given)
    r, omega, v, g = key.modes, *(given[n].ravel() for n in ("omega", "v", "g"))
    eta, etadot, Phi = given["eta"].ravel(), given["etadot"].ravel(), f.Phi()
    rho, udot = np.column_stack([f.xi, 0 * f.xi, 0 * f.xi]) + Phi @ eta, Phi @ etadot
    N = np.concatenate([-np.array([hat(x) for x in rho]), np.tile(np.eye(3), (len(f.s), 1, 1)), Phi], axis=2)
    M = f.integral(np.einsum("nik,nil->nkl", N, N), f.rhoA)
    a = np.cross(omega, v) - g + np.cross(omega, np.cross(omega, rho)) + 2 * np.cross(omega, udot)
    h = f.integral(np.einsum("nik,ni->nk", N, a), f.rhoA)
    row = f.spin_row()
    M += f.integral(np.einsum("nk,nl->nkl", row, row), f.rhoIp)
    spin = f.integral(row @ np.concatenate([omega, v, etadot]), f.rhoIp)
    h[:3] += spin * np.cross(omega, [1.0, 0, 0])
    second = f.integral(np.einsum("ni,nj->nij", rho, rho), f.rhoA)
    strain = strains(f)
    stiffness = [given[n].item() if n in given else 0.0 for n in ("EA", "EIz", "EIy", "GJ")]
    return {
        "M_V": M[:6, :6],
        "M_D": M[:6, 6:],
        "M_Dphi": M[6:, :6],
        "M_Wphi": M[6:, 6:],
        "h_V": h[:6],
        "h_eta": h[6:],
        "S": f.integral(rho, f.rhoA),
        "Sdot": f.integral(udot, f.rhoA),
        "J": second,
        "B": f.integral(np.einsum("ni,nj->nij", udot, rho), f.rhoA),
        "K_full": np.einsum("n,nak,a,nal->kl", f.weights, strain, stiffness, strain),
        "kinetic": 0.5 * nu(given) @ M @ nu(given),
        "r": r,
    }


def nu(given) -> np.ndarray:
    return np.concatenate([given[n].ravel() for n in ("omega", "v", "etadot")])


def strains(f: Field) -> np.ndarray:
    """(N, 4, r): u_x', u_y'', u_z'', theta_x'."""
    first, second = f.table(1), f.table(2)
    out = np.zeros((len(f.s), 4, len(f.order)))
    for k, (d, _) in enumerate(f.order):
        out[:, DIRECTIONS.index(d), k] = second[k] if d.startswith("bending") else first[k]
    return out


def base_body(name: str, given: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """What a rigid body at the base section adds: Newton and Euler about the origin of F_i."""
    m, a = given["body0_mass"].item(), -given["frame_at"].item()
    r = given["body0_com"].ravel() + np.array([a, 0, 0])
    xx, yy, zz, xy, xz, yz = given["body0_inertia"].ravel()
    I_c = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    omega, v, g = (given[n].ravel() for n in ("omega", "v", "g"))
    M = np.block([[I_c - m * hat(r) @ hat(r), m * hat(r)], [-m * hat(r), m * np.eye(3)]])
    force = m * (np.cross(omega, v) - g + np.cross(omega, np.cross(omega, r)))
    h = np.concatenate([np.cross(r, force) + np.cross(omega, I_c @ omega), force])
    J = m * np.outer(r, r) + np.trace(I_c) / 2 * np.eye(3) - I_c
    V = nu(given)[:6]
    return {"M_V": M, "h_V": h, "S": m * r, "J": J, "kinetic": 0.5 * V @ M @ V}


@every_class
def test_blocks_equal_quadrature(name):
    """Inertia, gyroscopic terms, weight, moments and stiffness of a deformed, moving link: every integral."""
    block = block_of(name)
    given = parameters(name) | state(block)
    found, expected = numbers(block, given), quadrature(name, given)
    if name == "base body":
        for step, extra in base_body(name, given).items():
            expected[step] = expected[step] + extra
    for step in ("M_V", "M_D", "M_Dphi", "M_Wphi", "h_V", "h_eta", "S", "Sdot", "J", "B", "K_full"):
        reference = expected[step].reshape(found[step].shape)
        assert np.allclose(found[step], reference, rtol=1e-12, atol=1e-12 * max(1, np.abs(reference).max())), step


@every_class
def test_energy_block_equals_quadrature(name):
    block = energy_block(CLASSES[name])
    given = parameters(name) | state(block)
    found, expected = numbers(block, given), quadrature(name, given)["kinetic"]
    expected += base_body(name, given)["kinetic"] if name == "base body" else 0
    assert np.isclose(found["kinetic"].item(), expected, rtol=1e-12)
    K, eta = found["K"].ravel(), given["eta"].ravel()
    assert np.isclose(found["stress"].item(), 0.5 * eta @ (K * eta), rtol=1e-13)


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
