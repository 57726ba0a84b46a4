"""The numbers of the paper's system for an arm, and what each printed formula changes in them.

A correction adds *printed minus derived*, both from the register of equations, evaluated in the state of the arm.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..algebra.expression import BlockMatrix, Expression, Negative, hat
from ..algebra.screw import shift, twice
from ..topology.chain import Chain
from . import appendix_b, link, projection
from .arm_state import ArmState, EquationValues, LinkState
from .equation import relation
from .evaluate import evaluate
from .quantities import LinkLetters
from .synthesis import joint_bias, section_bias

L, BEFORE, ONE = LinkLetters("i"), LinkLetters("i-1"), LinkLetters("1")
O3 = np.zeros((3, 3))
FORCE, MOMENT = 2, 3
"""Rows of link 1 in (B1)-(B3) as printed; the derived ones are in the other order."""


class System:
    """``M``, ``H``, ``W`` in the unknowns Zdot, and where the rows and columns of a link are."""

    def __init__(self, chain: Chain, state: ArmState, M: np.ndarray, H: np.ndarray, W: np.ndarray):
        self.chain, self.state, self.M, self.H, self.W = chain, state, M.copy(), H.copy(), W.copy()
        self.views = [state.view(i=k, _1=k) for k in range(chain.n)]
        self.h_s = [self._gyroscopic(k) for k in range(chain.n)]
        self.H_p = [evaluate(joint_bias(L, BEFORE if k else None), view) for k, view in enumerate(self.views)]
        for k in range(chain.n):
            columns = M[:, self.accelerations(k)]
            self.M[:, self.accelerations(k)] = columns @ (np.eye(6) + self.values(k)["T_gamma"])
            self.H += (columns @ self.values(k)["gamma_star"]).ravel()

    def _gyroscopic(self, k: int) -> np.ndarray:
        """H* of a link with its bodies: the bias of its rows without the Coriolis wrench of the deformation."""
        coriolis = hat(L.omega) @ L.rdot_xi
        h_MD = [evaluate(L.integral(x, L.rhoA), self.views[k]) for x in (hat(L.r_ib) @ coriolis, coriolis)]
        return self.H[self.accelerations(k)].reshape(6, 1) - np.vstack(h_MD)

    def values(self, k: int) -> dict[str, np.ndarray]:
        return self.state.links[k].values

    def joint(self, k: int) -> slice:
        """Rows of joint k, and columns of its wrench."""
        return slice(12 * k, 12 * k + 6)

    def accelerations(self, k: int) -> slice:
        """Rows of link k, and columns of its ``Zdot``."""
        return slice(12 * k + 6, 12 * k + 12)

    def modes(self, k: int) -> slice:
        start = 12 * self.chain.n
        return slice(start + self.chain.eta_offset[k], start + self.chain.eta_offset[k + 1])

    def scale(self, k: int) -> float:
        """Modal coordinates of the paper over ours: its shapes are orthonormal in ξ, ours in (ξ - a)/l."""
        return self.state.links[k].length ** 0.5

    # additions: the rows of joints are in F_i and have the other sign -----------------------------------

    def add_to_joint(self, k: int, columns: slice, value: np.ndarray) -> None:
        """Add to the rows of joint k a matrix in inertial components."""
        self.M[self.joint(k), columns] -= np.kron(np.eye(2), self.values(k)["R"].T) @ value

    def add_joint_bias(self, k: int, value: np.ndarray) -> None:
        self.H[self.joint(k)] -= (np.kron(np.eye(2), self.values(k)["R"].T) @ value).ravel()

    def add_twist_columns(self, k: int, j: int, value: np.ndarray) -> None:
        """Add to joint k the matrix that multiplies ``Vdot_j``."""
        self.add_to_joint(k, self.accelerations(j), value @ (np.eye(6) + self.values(j)["T_gamma"]))
        self.add_joint_bias(k, value @ self.values(j)["gamma_star"])

    def drop_h_s(self) -> None:
        """(97): of the bias only h_Ms and h_MD are left."""
        for k in range(self.chain.n):
            self.H[self.accelerations(k)] -= self.h_s[k].ravel()
            self.add_joint_bias(k, -self.values(k)["P"] @ self.H_p[k])


def gap(a: Expression, b: Expression, view: EquationValues) -> np.ndarray:
    """``a - b`` in numbers."""
    return evaluate(a, view) - evaluate(b, view)


def at_point(side: LinkLetters, r: Expression) -> Expression:
    """From a link's twist to that of its section at r, inertial components."""
    return twice(side.R) @ shift(r)


# ---------------------------------------------------------------------------------------------- joints


def projector(system: System) -> None:
    """(43) with axes that stay in the link's frame: another projection of the same rows."""
    for k, view in enumerate(system.views):
        v = system.values(k)
        A, change = v["R"] @ v["A_zero"], np.zeros((6, 6))
        change[:3, :3] = np.eye(3) - A @ A.T - v["P"][:3, :3]
        for side, j, end, sign in [*([(BEFORE, k - 1, "c", 1.0)] if k else []), (L, k, "a", -1.0)]:
            r = getattr(side, f"r_b_{end}") + getattr(side, f"r_xi_{end}")
            system.add_twist_columns(k, j, sign * change @ evaluate(at_point(side, r), view))
            system.add_joint_bias(k, sign * change @ evaluate(side.Ad @ section_bias(side, end), view))


def adjoint(system: System) -> None:
    """(45): ``Ad`` in place of ``blkdiag(R, R)`` at the joint's point."""
    for k, view in enumerate(system.views):
        P = system.values(k)["P"]
        if k:
            system.add_twist_columns(k, k - 1, P @ gap(BEFORE.Ad, at_point(BEFORE, BEFORE.r_b_c), view))
        system.add_twist_columns(k, k, -P @ gap(L.Ad, at_point(L, L.r_b_a), view))


def bias_of_joints(system: System) -> None:
    """(accconst5), projected."""
    for k, view in enumerate(system.views):
        own = -(L.Ad @ (L.ad @ L.V_xi_a))
        printed = evaluate(BEFORE.Ad @ (BEFORE.ad @ BEFORE.V_xi_c) + own if k else own, view)
        system.add_joint_bias(k, system.values(k)["P"] @ (printed - system.H_p[k]))
        system.H_p[k] = printed


# ----------------------------------------------------------------------------------------------- links


def gyroscopic(system: System) -> None:
    """(29), with g read as the opposite of free fall; the bodies keep their share."""
    for k, view in enumerate(system.views):
        printed = link.Equality(L.H_star, link.PRINTED_H_STAR).read(link.FREE_FALL)
        change = gap(printed.right, link.DERIVED_H_STAR, view)
        system.H[system.accelerations(k)] += change.ravel()
        system.h_s[k] = system.h_s[k] + change


def rows(printed: BlockMatrix, derived: BlockMatrix, column: int, view: EquationValues) -> np.ndarray:
    """A column of the rows of link 1, printed minus derived, the moment first."""
    both = [(printed.rows[p][column], derived.rows[d][column]) for p, d in ((MOMENT, FORCE), (FORCE, MOMENT))]
    return np.vstack([gap(p, d, view) for p, d in both])


def modal_columns(system: System) -> None:
    """(B1) in the rows of the links; those of the joints hold."""
    for k, view in enumerate(system.views):
        if system.state.links[k].key.modes:
            change = rows(appendix_b.PRINTED_M_D, appendix_b.DERIVED_M_D, 0, view)
            system.M[system.accelerations(k), system.modes(k)] += change * system.scale(k)


def deformation_columns(system: System) -> None:
    """(B2): in the rows of the links, and ``R`` for ``R hat(phi eta)`` in those of the joints."""
    printed, derived = appendix_b.PRINTED_M_DPSI, appendix_b.DERIVED_M_DPSI
    for k, view in enumerate(system.views):
        for column, offset in ((2, 0), (3, 3)):
            at = system.accelerations(k).start + offset
            system.M[system.accelerations(k), at : at + 3] += rows(printed, derived, column, view)
        pair = system.state.view(_1=k - 1, _2=k) if k else system.state.view(_1=k)
        turned = [(2, 0, 1, k)] if not k else [(2, 4, 5, k - 1), (6, 4, 5, k)]
        for column, p, d, j in turned:
            at = system.accelerations(j).start
            change = gap(printed.rows[p][column], derived.rows[d][column], pair)
            system.add_to_joint(k, slice(at, at + 3), np.vstack([O3, change]))


def deformation_bias(system: System) -> None:
    """(B3) in the rows of the links; those of the joints hold."""
    for k, view in enumerate(system.views):
        printed, derived = appendix_b.printed_momentum(ONE), appendix_b.derived_momentum(ONE)
        change = [gap(printed[1][0], derived[0][0], view), gap(printed[0][0], derived[1][0], view)]
        system.H[system.accelerations(k)] += np.vstack(change).ravel()


# ----------------------------------------------------------------------------------------------- modes


def modal_rows(system: System) -> None:
    """(85): no wrenches, neither of joints nor external ones, and places from the link's frame."""
    for k, view in enumerate(system.views):
        modes, at = system.modes(k), system.accelerations(k)
        if not system.state.links[k].key.modes:
            continue
        turning = gap(Negative(L.phi.T @ hat(L.r_ib)), Negative(L.phi.T @ hat(L.r_ob)), view)
        change = view.values["rhoA:i"] * np.tensordot(system.state.links[k].weights, turning, 1)
        for j in range(system.chain.n):
            system.M[modes, system.joint(j)] = 0.0
        system.M[modes, at.start : at.start + 3] += change * system.scale(k)
        system.W[modes] = 0.0


def modal_bias(system: System) -> None:
    """(88), the modes of one number after the other."""
    equation = next(e for e in projection.EQUATIONS if e.label == "88")
    for k, view in enumerate(system.views):
        state = system.state.links[k]
        for triple in triples(state):
            (printed,), (derived,) = equation.printed, equation.derived
            own = of_mode(view, state, triple)
            per_mass = evaluate(relation(printed).read(equation.reading).right, own) * view.values["rhoA:i"]
            change = (per_mass - evaluate(relation(derived).right, own)).ravel() * system.scale(k)
            for axis, mode in triple.items():
                system.H[system.modes(k).start + mode] += change[axis]


def triples(state: LinkState) -> list[dict[int, int]]:
    """The p-th modes of all directions: axis of displacement to the mode's number."""
    axes = {"axial": 0, "bending_y": 1, "bending_z": 2}
    found: dict[int, dict[int, int]] = {}
    for mode, (direction, p) in enumerate(state.key.directions):
        found.setdefault(p, {})[axes[direction]] = mode
    return list(found.values())


def of_mode(view: EquationValues, state: LinkState, triple: dict[int, int]) -> EquationValues:
    """The view with the shapes and coordinates of one mode per direction; zero where a direction has none."""
    values, v = dict(view.values), state.values
    for name in ("phi", "phi1", "phi2", "phi4"):
        values[f"{name}_one:i"] = chosen(v[name], triple)
    values["eta_one:i"] = chosen(v["eta"].T, triple).T
    return replace(view, values=values)


def chosen(columns: np.ndarray, triple: dict[int, int]) -> np.ndarray:
    """The columns of x, y, z among those of all modes."""
    out = np.zeros((*columns.shape[:-1], 3))
    for axis, mode in triple.items():
        out[..., axis] = columns[..., mode]
    return out


CORRECTIONS = {
    "29": gyroscopic,
    "43": projector,
    "45": adjoint,
    "accconst5": bias_of_joints,
    "85": modal_rows,
    "88": modal_bias,
    "B1": modal_columns,
    "B2": deformation_columns,
    "B3": deformation_bias,
}
