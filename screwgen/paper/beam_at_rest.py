"""A clamped beam at rest under end loads and its own weight: a judge of stiffness and boundary rows, from textbooks.

Deflections are the elementary elastic lines (tip force, tip moment, uniform load, axial pull), reactions follow from
statics, stiffness from the strain energy of a rectangular section.  Nothing here comes from the paper's formulas.
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import leggauss

from ..arguments import Numbers
from .jets import turn

POINTS = 12
Z3 = np.zeros((3, 1))


class BeamAtRest:
    """``values`` and ``weights`` as of a motion, of the link "i".

    Body components: ``force`` (N) and ``torque`` (N·m) are applied to the tip by what it carries, bending and pull;
    ``gravity`` (m/s²) is of free fall.  ``F_T``, ``tau_T`` are what the link exerts at its tip, as (30) takes them
    away; ``F_B``, ``tau_B`` what the clamp exerts on the link.  Loads and sizes that are not given are random.
    """

    def __init__(
        self, seed: int, force: Numbers | None = None, torque: Numbers | None = None, gravity: Numbers | None = None
    ):
        random = np.random.default_rng(seed)
        self.values: dict[str, np.ndarray] = {}
        self.l, self.a, self.rhoA = random.uniform(0.6, 1.4), -random.uniform(0.1, 0.4), random.uniform(0.5, 2.0)
        self._section(random)
        draw = lambda given, size: size * random.normal(size=3) if given is None else np.array(given, float)  # noqa: E731
        self.force, self.torque, self.fall = draw(force, 0.1), draw(torque, 0.1), draw(gravity, 0.1)
        self._bend()
        self._react()
        self._stand(random)
        self.values = {f"{name}:i": value for name, value in self.values.items()}

    def _section(self, random: np.random.Generator) -> None:
        """Stiffness of a rectangle: strain ``u_x' - y u_y'' - z u_z''``, energy ``1/2 E ∫ strain² dA``."""
        E, width, height = random.uniform(1.0, 2.0), *random.uniform(0.6, 1.2, 2)
        nodes, weights = leggauss(4)
        y, z = np.meshgrid(nodes * width / 2, nodes * height / 2, indexing="ij")
        dA = np.outer(weights, weights) * width * height / 4
        row = np.stack([np.ones_like(y), -y, -z])
        K = E * np.einsum("aij,bij,ij->ab", row, row, dA)
        axial, bent = K.copy(), K.copy()
        axial[1:, 1:], bent[0, 0] = 0, 0
        self.values |= {"I_v1": axial, "I_v2": bent}
        moments = {"EA": np.ones_like(y), "EIz": y**2, "EIy": z**2}
        self.EA, self.EIz, self.EIy = (E * (f * dA).sum() for f in moments.values())
        self.values |= {name: np.array([[getattr(self, name)]]) for name in moments}

    def _bend(self) -> None:
        """Elastic lines from the clamp, and their derivatives along the beam and at its ends."""
        x, l, q = Polynomial([0.0, 1.0]), self.l, self.rhoA * self.fall
        cantilever = lambda F, w: F * x**2 * (3 * l - x) / 6 + w * x**2 * (6 * l**2 - 4 * l * x + x**2) / 24  # noqa: E731
        F, M = self.force, self.torque
        lines = (
            (F[0] * x + q[0] * x * (2 * l - x) / 2) / self.EA,
            (cantilever(F[1], q[1]) + M[2] * x**2 / 2) / self.EIz,
            (cantilever(F[2], q[2]) - M[1] * x**2 / 2) / self.EIy,
        )
        nodes, weights = leggauss(POINTS)
        inside = (1 + nodes) * l / 2
        self.weights = {"i": weights * l / 2}
        at = lambda place, n: np.stack([u.deriv(n)(place) if n else u(place) for u in lines], -1)[..., None]  # noqa: E731
        v = self.values
        v["r_b"] = np.stack([inside + self.a, 0 * inside, 0 * inside], -1)[..., None]
        v |= {"r_xi": at(inside, 0), **{f"r_xi{n}": at(inside, n) for n in (1, 2, 4)}}
        v["r_ib"] = v["r_b"] + v["r_xi"]
        for end, place in (("a", np.array(0.0)), ("c", np.array(l))):
            v |= {f"r_xi_{end}": at(place, 0), **{f"r_xi{n}_{end}": at(place, n) for n in (1, 2, 3)}}

    def _react(self) -> None:
        """The clamp holds force and torque of the undeformed beam in balance."""
        arm, weight = np.array([self.l, 0, 0]), self.rhoA * self.l * self.fall
        torque = self.torque + np.cross(arm, self.force) + np.cross(arm / 2, weight)
        loads = {"F_B": -self.force - weight, "tau_B": -torque, "F_T": -self.force, "tau_T": -self.torque}
        self.values |= {name: load.reshape(3, 1) for name, load in loads.items()}

    def _stand(self, random: np.random.Generator) -> None:
        """Somewhere, turned somehow, without motion."""
        axis = random.normal(size=3)
        R = turn(axis / np.linalg.norm(axis), 0.7, 0, 0).value
        self.values |= {"R": R, "g": R @ self.fall.reshape(3, 1), "rhoA": np.array([[self.rhoA]])}
        self.values |= dict.fromkeys(("v", "vdot", "omega", "omegadot", "load"), Z3)
        self.values |= dict.fromkeys(("rdot_xi", "v_xi", "v_b", "v_ib", "vdot_xi"), np.zeros_like(self.values["r_b"]))


def moments_to_bending(seed: int) -> np.ndarray:
    """(3, 3): the bending ``-I_v2 r''`` at the tip for a unit torque there about each axis, exerted by the link."""
    columns = []
    for axis in np.eye(3):
        beam = BeamAtRest(seed, force=(0, 0, 0), torque=-axis, gravity=(0, 0, 0)).values
        columns.append(-beam["I_v2:i"] @ beam["r_xi2_c:i"])
    return np.hstack(columns)
