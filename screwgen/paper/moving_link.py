"""One link of the judge's arm: random size, shapes, joint and motion, and what follows from their definitions."""

from __future__ import annotations

import numpy as np
from numpy.linalg import inv, pinv
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import Legendre, leggauss

from .jets import Jet, constant, skew, turn, unskew

POINTS = 24
DEGREES = (3, 4, 5, 4, 5, 6)
"""Degrees of the shapes: x, y, z of the first mode, then of the second.

A part of degree 0 or 1 is added: the polynomials alone would carry neither momentum nor moment of momentum.
"""
SOFT = np.array([0.1, 0.01, 0.01])
"""Stiffness in N and N·m² by which stress is about as large as inertia, so that neither hides the other."""
Z1, Z3, O3 = np.zeros((1, 1)), np.zeros((3, 1)), np.zeros((3, 3))


class MovingLink:
    """A link; ``values`` holds its quantities by the names of :data:`.quantities.QUANTITIES`."""

    def __init__(self, random: np.random.Generator, gravity: np.ndarray):
        self.values: dict[str, np.ndarray] = {}
        self.tabulated: dict[tuple, np.ndarray] = {}
        self.gravity = gravity
        self._size(random)
        self._joint_axes(random)
        draw = lambda size: 0.03 * size * random.normal(size=(6, 1))  # noqa: E731
        self.eta = Jet(draw(1), draw(4), draw(20))

    def _size(self, random: np.random.Generator) -> None:
        l, inside = random.uniform(0.6, 1.4), random.uniform(0.1, 0.4)
        self._line(l, inside, random.uniform(0.5, 2.0), *random.uniform(0.2, 0.9, 3) * SOFT)

    def _line(self, l: float, inside: float, rhoA: float, EA: float, EIy: float, EIz: float) -> None:
        """A centreline of length ``l`` whose frame sits ``inside`` from its base, with its shapes and section."""
        self.l, self.a, self.c = l, -inside, l - inside
        self.rhoA, self.EA, self.EIy, self.EIz = rhoA, EA, EIy, EIz
        nodes, weights = leggauss(POINTS)
        self.xi, self.weights = (self.a + self.c) / 2 + self.l / 2 * nodes, weights * self.l / 2
        scale = Polynomial([-(self.a + self.c) / self.l, 2 / self.l])
        shape = lambda n: np.sqrt((2 * n + 1) / self.l) * Legendre.basis(n).convert(kind=Polynomial)(scale)  # noqa: E731
        self.psi = [0.8 * shape(n) + 0.6 * shape(k // 3) for k, n in enumerate(DEGREES)]

    def _joint_axes(self, random: np.random.Generator) -> None:
        """Two axes, neither perpendicular nor those of a frame, with their angles, rates and accelerations."""
        axes = random.normal(size=(2, 3, 1))
        self.axes = axes / np.linalg.norm(axes, axis=1, keepdims=True)
        self.joint = random.uniform(-1, 1, (2, 3)) * [1.0, 1.5, 4.0]

    def shapes(self, xi: float | np.ndarray, order: int = 0) -> np.ndarray:
        """Mode shapes or their derivatives at places of the centreline, (..., 3, 6)."""
        key = (order, np.shape(xi), np.asarray(xi).tobytes())
        if key not in self.tabulated:
            out = np.zeros((*np.shape(xi), 3, len(DEGREES)))
            for k, psi in enumerate(self.psi):
                out[..., k % 3, k] = (psi.deriv(order) if order else psi)(np.asarray(xi))
            self.tabulated[key] = out
        return self.tabulated[key]

    def elastic(self, xi: float | np.ndarray, order: int = 0) -> np.ndarray:
        """The displacement or a derivative of it along the link, (..., 3, 1)."""
        return self.shapes(xi, order) @ self.eta.value

    def displaced(self, xi: float | np.ndarray) -> tuple[Jet, Jet]:
        """``r_b`` and ``r_xi`` at places of the centreline, body components."""
        r_b = np.zeros((*np.shape(xi), 3, 1))
        r_b[..., 0, 0] = xi
        phi = self.shapes(xi)
        return constant(r_b), Jet(phi @ self.eta.value, phi @ self.eta.rate, phi @ self.eta.second)

    # motion ------------------------------------------------------------------------------------------

    def move(self, R_parent: Jet, p_parent: Jet) -> tuple[Jet, Jet]:
        """Turn about the joint and hang on at the parent's tip; returns this link's rotation and tip."""
        first, second = (turn(axis, *q) for axis, q in zip(self.axes, self.joint, strict=True))
        R = R_parent @ first @ second
        r_b, r_xi = self.displaced(self.a)
        p = p_parent - R @ (r_b + r_xi)
        r_b, r_xi = self.displaced(self.c)
        tip = p + R @ (r_b + r_xi)
        self.R, self.p = R, p
        self._joint_values(R_parent, first)
        self._frame()
        self._field()
        self._ends(tip, p_parent)
        self._section()
        return R, tip

    def _joint_values(self, R_parent: Jet, first: Jet) -> None:
        """The axes, and the projector on what the joint blocks, in inertial components."""
        a1, a2 = map(constant, self.axes)
        columns = [R_parent @ a1, R_parent @ first @ a2]
        A, A_rate = (np.hstack([getattr(c, part) for c in columns]) for part in ("value", "rate"))
        blocked = np.eye(3) - A @ pinv(A)
        half = blocked @ A_rate @ pinv(A)
        R = self.R.value
        self.values |= {"A": A, "A_plus": pinv(A), "A_body": R.T @ A, "A_zero": np.hstack(list(self.axes))}
        self.values |= {"P": blocks(blocked, np.eye(3)), "Pdot": blocks(-half - half.T, O3)}
        second = turn(self.axes[1], *self.joint[1])
        self.values |= {"a_one": self.axes[0], "a_two": self.axes[1], "R_two": second.value}

    def _frame(self) -> None:
        """Twist and accelerations of the link's frame."""
        R, p, v = self.R, self.p, self.values
        r = R.T @ p
        omega = unskew(R.value.T @ R.rate)
        omegadot = unskew(R.value.T @ R.second + R.rate.T @ R.rate)
        velocity = R.T @ p.dot
        v |= {"R": R.value, "r_o": p.value, "r": r.value, "rdot": r.rate, "rddot": r.second}
        v |= {"omega": omega, "omegadot": omegadot, "v": velocity.value, "vdot": velocity.rate}
        v |= {"V": stack(omega, velocity.value), "Vdot": stack(omegadot, velocity.rate)}
        v |= {"dV": stack(omegadot, R.value.T @ p.second), "d_r": velocity.value, "dd_r": R.value.T @ p.second}
        v |= {"Z": stack(omega, r.rate), "Zdot": stack(omegadot, r.second)}
        v |= {"gamma": v["V"] - v["Z"], "gamma_star": stack(Z3, skew(omega) @ r.rate)}
        v["T_gamma"] = np.block([[O3, O3], [-skew(r.value), O3]])
        v["Ad"], v["ad"] = adjoint(R.value, p.value), small_adjoint(v["V"])
        v["Ad_back"], v["Ad_R"] = inv(v["Ad"]), blocks(R.value, R.value)
        v["u"] = np.arange(1.0, 7.0).reshape(6, 1)
        v["bracket"] = bracket(v["V"], v["u"])
        v["theta"] = exponential_coordinates(R.value)
        v["J_theta"] = body_jacobian(v["theta"])
        v["thetadot"] = logarithm_rate(R.value, R.rate)
        v |= {"q": stack(v["theta"], r.value), "qdot": stack(v["thetadot"], r.rate)}

    def _field(self) -> None:
        """Places, velocities and accelerations of the elements."""
        R, p, v = self.R, self.p, self.values
        r_b, r_xi = self.displaced(self.xi)
        local, whole = r_b + r_xi, R.T @ p + r_b + r_xi
        v |= {"r_b": r_b.value, "r_xi": r_xi.value, "rdot_xi": r_xi.rate, "rddot_xi": r_xi.second}
        v |= {"r_ib": local.value, "rdot_ib": local.rate, "r_ob": whole.value, "rdot_ob": whole.rate}
        for name, jet in {"b": R @ r_b, "xi": R @ r_xi, "ib": R @ local, "ob": p + R @ local}.items():
            velocity = R.T @ jet.dot
            v |= {f"v_{name}": velocity.value, f"vdot_{name}": velocity.rate, f"d_r_{name}": velocity.value}
            v[f"dd_r_{name}"] = R.value.T @ jet.second
        for name in ("b", "xi"):
            v |= {f"V_{name}": stack(Z3, v[f"v_{name}"]), f"Vdot_{name}": stack(Z3, v[f"vdot_{name}"])}
            v[f"dV_{name}"] = stack(Z3, v[f"dd_r_{name}"])
        v |= {"q_b": stack(Z3, v["r_b"]), "qdot_b": stack(Z3, 0 * v["r_b"])}
        v |= {"q_xi": stack(Z3, v["r_xi"]), "qdot_xi": stack(Z3, v["rdot_xi"])}
        v["xi"] = self.xi.reshape(-1, 1, 1)
        v |= {f"r_xi{n}": self.elastic(self.xi, n) for n in (1, 2, 4)}
        self._modes()

    def _modes(self) -> None:
        v, eta = self.values, self.eta
        v |= {"eta": eta.value, "etadot": eta.rate, "etaddot": eta.second, "phi": self.shapes(self.xi)}
        v |= {f"phi{n}": self.shapes(self.xi, n) for n in (1, 2, 4)}
        for end, place in (("a", self.a), ("c", self.c)):
            v |= {f"phi_{end}": self.shapes(place), f"phi1_{end}": self.shapes(place, 1)}
        for k, name in enumerate(("one", "two")):
            v |= {f"phi_{name}": v["phi"][..., 3 * k : 3 * k + 3], f"eta_{name}": eta.value[3 * k : 3 * k + 3]}
        for k, name in enumerate("xyz"):
            v |= {f"phi_{name}": v["phi"][:, k : k + 1, k : k + 1], f"eta_{name}": eta.value[k : k + 1]}

    def _ends(self, tip: Jet, base: Jet) -> None:
        """Twists of the end sections, which turn with the frame, and the deformation there."""
        R, v = self.R, self.values
        for end, place, point in (("a", self.a, base), ("c", self.c, tip)):
            r_b, r_xi = self.displaced(place)
            v |= {f"r_b_{end}": r_b.value, f"r_xi_{end}": r_xi.value}
            v[f"J_b_{end}"] = np.block([[np.eye(3), O3], [-skew(r_b.value), np.eye(3)]])
            v |= {f"r_xi{n}_{end}": self.elastic(place, n) for n in (1, 2, 3)}
            for name, jet in {"b": R @ r_b, "xi": R @ r_xi}.items():
                velocity = R.T @ jet.dot
                v[f"V_{name}_{end}"] = stack(Z3, velocity.value)
                v[f"Vdot_{name}_{end}"] = stack(Z3, velocity.rate)
            letter = {"a": "B", "c": "T"}[end]
            v[f"V_{letter}"] = stack(v["omega"], R.value.T @ point.rate)
            v[f"dV_{letter}"] = stack(v["omegadot"], R.value.T @ point.second)

    def _section(self) -> None:
        """Inertia and stiffness of the undeformed beam."""
        v, xi = self.values, self.values["r_b"]
        for name in ("rhoA", "EA", "EIy", "EIz"):
            v[name] = np.array([[getattr(self, name)]])
        v["l"] = np.array([[self.c - self.a]])
        v["m"] = np.array([[self.rhoA * self.sum(np.ones_like(self.xi))]])
        N = np.concatenate([-skew(xi), np.broadcast_to(np.eye(3), (len(xi), 3, 3))], -1)
        v["M_star"] = self.rhoA * self.sum(np.swapaxes(N, -1, -2) @ N)
        v["I_b"] = v["M_star"][:3, :3]
        v["I_v1"], v["I_v2"] = np.diag([self.EA, 0, 0]), np.diag([0, self.EIz, self.EIy])
        v["H"] = np.array([[0, 0, 0], [0, 0, 1], [0, -1, 0]])

    def sum(self, field: np.ndarray) -> np.ndarray:
        """The integral of a field along the link."""
        return np.tensordot(self.weights, field, 1)

    # loads -------------------------------------------------------------------------------------------

    def load(self, random: np.random.Generator, isolated: bool) -> None:
        """External wrenches at both ends; of an isolated link such that they alone move it."""
        v = self.values
        fall = v["R"].T @ self.gravity
        force = self.rhoA * (v["dd_r_ob"] - fall)
        v["total"] = stack(self.sum(skew(v["r_ib"]) @ force), self.sum(force))
        v["load"] = force / self.rhoA + (v["I_v2"] @ v["r_xi4"] - v["I_v1"] @ v["r_xi2"]) / self.rhoA
        draw = lambda: random.normal(size=(3, 1))  # noqa: E731
        v |= {"tau_T": draw(), "F_T": draw(), "tau_B": draw(), "F_B": draw()}
        base, tip = v["r_b_a"] + v["r_xi_a"], v["r_b_c"] + v["r_xi_c"]
        if isolated:
            v["F_B"] = v["total"][3:] + v["F_T"]
            v["tau_B"] = v["total"][:3] + v["tau_T"] - skew(base) @ v["F_B"] + skew(tip) @ v["F_T"]
        moment = v["tau_B"] - v["tau_T"] + skew(base) @ v["F_B"] - skew(tip) @ v["F_T"]
        v["W_star"] = stack(moment, v["F_B"] - v["F_T"])
        self._split()

    def _split(self) -> None:
        """D*: the part of the inertia that the deformation adds; H*: the rest that is no acceleration."""
        v = self.values
        pulled = v["vdot"] - skew(v["r_b"]) @ v["omegadot"]
        all_of_it = pulled + v["vdot_xi"]
        inertia = self.rhoA * stack(self.sum(skew(v["r_ib"]) @ all_of_it), self.sum(all_of_it))
        v["D_star"] = inertia - v["M_star"] @ v["Vdot"]
        v["H_star"] = v["total"] - inertia


def stack(*parts: np.ndarray) -> np.ndarray:
    """Columns one above the other; fields and plain columns may be mixed."""
    lead = max((p.shape[:-2] for p in parts), key=len)
    return np.concatenate([np.broadcast_to(p, (*lead, *p.shape[-2:])) for p in parts], -2)


def blocks(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.block([[a, O3], [O3, b]])


def adjoint(R: np.ndarray, p: np.ndarray) -> np.ndarray:
    """The Adjoint of a frame at ``p`` with axes ``R``."""
    return np.block([[R, O3], [skew(p) @ R, R]])


def small_adjoint(V: np.ndarray) -> np.ndarray:
    """The matrix of the Lie bracket, column by column from the 4 x 4 matrices of twists."""
    return np.hstack([bracket(V, e.reshape(6, 1)) for e in np.eye(6)])


def bracket(V: np.ndarray, U: np.ndarray) -> np.ndarray:
    """``[V, U]`` of two screws by the commutator of their 4 x 4 matrices."""
    A, B = (np.block([[skew(x[:3]), x[3:]], [np.zeros((1, 4))]]) for x in (V, U))
    C = A @ B - B @ A
    return stack(unskew(C[:3, :3]), C[:3, 3:])


def exponential_coordinates(R: np.ndarray) -> np.ndarray:
    """The rotation vector of a rotation by less than pi."""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    return unskew(R - R.T) * (angle / (2 * np.sin(angle)) if angle else 0.5)


def logarithm_rate(R: np.ndarray, R_rate: np.ndarray) -> np.ndarray:
    """The rate of the rotation vector: the derivative of :func:`exponential_coordinates` along ``R_rate``."""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    sin, cos = np.sin(angle), np.cos(angle)
    rate = -np.trace(R_rate) / (2 * sin)
    return (unskew(R_rate - R_rate.T) * angle + unskew(R - R.T) * rate * (1 - angle * cos / sin)) / (2 * sin)


def body_jacobian(theta: np.ndarray) -> np.ndarray:
    """``J(theta)`` with ``omega = J thetadot`` in body components: its power series."""
    K, term, out = skew(theta), np.eye(3), np.eye(3)
    for k in range(1, 40):
        term = -term @ K / (k + 1)
        out = out + term
    return out
