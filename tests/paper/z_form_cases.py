"""What the tests of the Z-form share: random robots in its coordinates by the oracle, and the series of exp."""

from __future__ import annotations

from functools import cache

import casadi as ca
import mpmath
import numpy as np
from helpers import Case, drawn, flat
from oracle import part_error
from oracle_link import hat


class Placed:
    """A random robot in a random state, and what the oracle says of its links in the coordinates of the Z-form."""

    def __init__(self, case: Case):
        self.case, self.model, self.n = case, case.model, case.model.n_links
        self.m = self.model.n_joints
        self.q, self.v, self.tau, self.w_ext = case.inputs
        self.vdot, self.wrench = case.oracle.forward_dynamics(**case.state)
        poses, V = case.oracle.poses(self.q), case.oracle.link_twists(self.q, self.v)
        V_dot = case.oracle.link_twist_rates(self.q, self.v, self.vdot)
        self.R = poses["R"]
        self.r = np.einsum("nji,nj->ni", self.R, poses["origin"])
        self.omega, self.rdot = V[:, :3], V[:, 3:] - np.cross(V[:, :3], self.r)
        self.alpha = V_dot[:, :3]
        self.rddot = V_dot[:, 3:] - np.cross(self.alpha, self.r) - np.cross(self.omega, self.rdot)
        self.V_dot = V_dot

    def call(self, name: str) -> list[np.ndarray]:
        """The outputs of a function in this state."""
        function = self.model.casadi()[name]
        given = {"q": self.q, "v": self.v, "tau": self.tau, "w_ext": self.w_ext.T, "p": self.model.parameter_values}
        if "x_c" in function.name_in():
            given |= {"x_c": self.x_c, "q": self.q[: self.m]}
        if "x" in function.name_in():
            given["x"] = self.model.casadi()["dae_state"](self.q, self.v, self.model.parameter_values)
        return [y.full() for y in function.call([ca.DM(given[x]) for x in function.name_in()])]

    @property
    def x_c(self) -> np.ndarray:
        return flat(self.model.casadi()["cauchy_state"](self.q, self.v, self.model.parameter_values))

    @property
    def change(self) -> tuple[np.ndarray, np.ndarray]:
        """``I + T_gamma`` and ``Gamma*`` of all unknowns, (MsPsi) and (HMs), from the oracle's motion."""
        size = 12 * self.n + len(self.q) - self.m
        T, star = np.eye(size), np.zeros(size)
        for i in range(self.n):
            T[12 * i + 9 : 12 * i + 12, 12 * i + 6 : 12 * i + 9] = -hat(self.r[i])
            star[12 * i + 9 : 12 * i + 12] = np.cross(self.omega[i], self.rdot[i])
        return T, star

    def errors(self, z: np.ndarray) -> dict[str, float]:
        """Errors of unknowns of the Z-form against the oracle."""
        links, modal = z[: 12 * self.n].reshape(self.n, 12), self.vdot[self.m :]
        expected = {"tau": self.wrench[:, :3], "F": self.wrench[:, 3:], "alpha": self.alpha, "rddot": self.rddot}
        found = {k: links[:, 3 * j : 3 * j + 3] for j, k in enumerate(expected)} | {"eta": z[12 * self.n :]}
        expected["eta"] = modal
        other = {"tau": "F", "F": "tau", "alpha": "rddot", "rddot": "alpha", "eta": "alpha"}
        return {k: part_error(expected[k], found[k], expected[other[k]]) for k in expected}


@cache
def placed(seed: int) -> Placed:
    """Up to three links; welded joints, skew axes, mounts, frames off the joint, torsion and rigid links all occur."""
    return Placed(drawn(seed, 1 + seed % 3, frame_at=0.4, torsion=0.5, rigid=0.2))


def series(theta: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """exp, its right Jacobian and the inverse of that, from the power series at fifty digits."""
    with mpmath.workdps(50):
        x, y, z = (mpmath.mpf(float(t)) for t in theta)
        skew = mpmath.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        R, J, power = mpmath.eye(3), mpmath.eye(3), mpmath.eye(3)
        for k in range(1, 80):
            power = power * skew / k
            R, J = R + power, J + power * (-1) ** k / (k + 1)
        inverse = J**-1
        return tuple(np.array(A.tolist(), dtype=float) for A in (R, J, inverse))
