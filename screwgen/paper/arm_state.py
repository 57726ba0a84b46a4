"""The paper's quantities of a robot in a given state, so that the printed formulas can be evaluated on a real arm."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.linalg import inv, pinv
from numpy.polynomial.legendre import leggauss
from scipy.spatial.transform import Rotation

from ..arguments import Numbers
from ..model import Model
from .jets import skew, turn
from .moving_link import adjoint, blocks, body_jacobian, exponential_coordinates, small_adjoint, stack

if TYPE_CHECKING:
    from ..bases import Shapes
    from ..spec.link_class import LinkClass

Z3, O3 = np.zeros((3, 1)), np.zeros((3, 3))
POINTS = 40
AXES = {"axial": 0, "bending_y": 1, "bending_z": 2}


@dataclass(frozen=True)
class EquationValues:
    """Values and weights under the indices of an equation, as :func:`.evaluate.evaluate` takes them."""

    values: dict[str, np.ndarray]
    weights: dict[str, np.ndarray]


@cache
def tabulated(shapes: Shapes, s: tuple[float, ...], order: int) -> np.ndarray:
    """A basis or its derivative at places in [0, 1], (modes, points)."""
    return np.array(shapes.evaluate(s, order))


class LinkState:
    """One link: ``values`` by quantity, and the quadrature ``weights``, of a motion without accelerations."""

    def __init__(self, key: LinkClass, line: dict[str, float], frame_at: float, length: float):
        nodes, weights = leggauss(POINTS)
        self.key, self.length, self.a = key, length, -frame_at
        self.s, self.weights = (1 + nodes) / 2, weights * length / 2
        self.xi = self.a + self.s * length
        self.values: dict[str, np.ndarray] = {name: np.array([[value]]) for name, value in line.items()}
        self._shapes()
        self._section()

    def at(self, s: Numbers, order: int = 0) -> np.ndarray:
        """Mode shapes or their derivatives along the link at abscissas in [0, 1], (points, 3, r); torsion is zero."""
        out = np.zeros((len(s), 3, self.key.modes))
        for k, (direction, i) in enumerate(self.key.directions):
            if direction in AXES:
                table = tabulated(self.key.shapes(direction), tuple(s), order)
                out[:, AXES[direction], k] = table[i] / self.length**order
        return out

    def _shapes(self) -> None:
        """Shapes with their derivatives, in the fields and at the ends; the paper's are orthonormal in xi."""
        v, scale = self.values, self.length**0.5
        for order, name in enumerate(("phi", "phi1", "phi2", "phi3", "phi4")):
            v[name] = self.at(self.s, order) / scale
            base, tip = self.at([0.0, 1.0], order) / scale
            v |= {f"{name}_a": base, f"{name}_c": tip}

    def _section(self) -> None:
        v = self.values
        r_b = np.zeros((len(self.xi), 3, 1))
        r_b[:, 0, 0] = self.xi
        ends = {"r_b_a": self.a, "r_b_c": self.a + self.length}
        v |= {"r_b": r_b, "xi": self.xi.reshape(-1, 1, 1), "m": v["rhoA"] * self.length}
        v |= {name: np.array([[x], [0.0], [0.0]]) for name, x in ends.items()}
        stiff = lambda name: v.get(name, np.zeros((1, 1))).item()  # noqa: E731
        v["I_v1"] = np.diag([stiff("EA"), 0, 0])
        v["I_v2"] = np.diag([0, stiff("EIz"), stiff("EIy")])
        v["H"] = np.array([[0, 0, 0], [0, 0, 1], [0, -1, 0]])
        N = np.concatenate([-skew(r_b), np.broadcast_to(np.eye(3), (POINTS, 3, 3))], -1)
        v["M_star"] = v["rhoA"] * np.tensordot(self.weights, np.swapaxes(N, -1, -2) @ N, 1)
        v["I_b"] = v["M_star"][:3, :3]

    def move(self, R: np.ndarray, p: np.ndarray, V: Numbers, eta: Numbers, etadot: Numbers, gravity: Numbers) -> None:
        """Place the link: rotation (3, 3), position (3,) in the inertial frame, twist (6,), modal state in metres."""
        v, scale = self.values, self.length**0.5
        v |= {"R": R, "r_o": p.reshape(3, 1), "g": np.reshape(gravity, (3, 1)), "V": np.reshape(V, (6, 1))}
        v |= {"omega": v["V"][:3], "v": v["V"][3:], "r": R.T @ v["r_o"]}
        v["rdot"] = v["v"] - skew(v["omega"]) @ v["r"]
        v |= {"Z": stack(v["omega"], v["rdot"]), "gamma": v["V"] - stack(v["omega"], v["rdot"])}
        v |= {
            "gamma_star": stack(Z3, skew(v["omega"]) @ v["rdot"]),
            "T_gamma": np.block([[O3, O3], [-skew(v["r"]), O3]]),
        }
        v |= {"Ad": adjoint(R, v["r_o"]), "ad": small_adjoint(v["V"])}
        v |= {"Ad_back": inv(v["Ad"]), "Ad_R": blocks(R, R)}
        v["theta"] = exponential_coordinates(R) if np.trace(R) < 3 - 1e-12 else Z3
        v["J_theta"] = body_jacobian(v["theta"])
        v |= {"eta": scale * np.reshape(eta, (-1, 1)), "etadot": scale * np.reshape(etadot, (-1, 1))}
        self._field()
        self._ends()

    def _field(self) -> None:
        v = self.values
        hat = skew(v["omega"])
        v |= {"r_xi": v["phi"] @ v["eta"], "rdot_xi": v["phi"] @ v["etadot"]}
        v |= {f"r_xi{n}": v[f"phi{n}"] @ v["eta"] for n in (1, 2, 4)}
        v |= {"r_ib": v["r_b"] + v["r_xi"], "rdot_ib": v["rdot_xi"]}
        v |= {"r_ob": v["r"] + v["r_ib"], "rdot_ob": v["rdot"] + v["rdot_xi"]}
        v |= {"v_b": hat @ v["r_b"], "v_xi": v["rdot_xi"] + hat @ v["r_xi"]}
        v["v_ib"] = v["v_b"] + v["v_xi"]
        v["v_ob"] = v["v"] + v["v_ib"]

    def _ends(self) -> None:
        v = self.values
        hat = skew(v["omega"])
        for end in "ac":
            phi = v[f"phi_{end}"]
            v |= {f"r_xi_{end}": phi @ v["eta"], f"rdot_xi_{end}": phi @ v["etadot"]}
            v[f"V_xi_{end}"] = stack(Z3, v[f"rdot_xi_{end}"] + hat @ v[f"r_xi_{end}"])
            v[f"V_b_{end}"] = stack(Z3, hat @ v[f"r_b_{end}"])
            v |= {f"r_xi{n}_{end}": v[f"phi{n}_{end}"] @ v["eta"] for n in (1, 2, 3)}


class ArmState:
    """The links of a model in a state ``x`` of its DAE form, or at joint form ``q``, ``v``."""

    def __init__(self, model: Model, x: Numbers):
        self.model, chain = model, model.chain
        states = model.numpy().dae_functions.unpack(list(map(float, x)))
        self.links = [self._link(i) for i in range(chain.n)]
        for i, (link, s) in enumerate(zip(self.links, states, strict=True)):
            w, *xyz = s["quaternion"]
            R = Rotation.from_quat([*xyz, w]).as_matrix()
            link.move(R, np.array(s["position"]), s["twist"], s["eta"], s["etadot"], model.robot.gravity)
            self._join(i, np.array(s["q"]))

    @classmethod
    def at(cls, model: Model, q: Numbers, v: Numbers) -> ArmState:
        """The state at joint coordinates and modes ``q`` with rates ``v``."""
        return cls(model, model.numpy().dae_state(q, v))

    @cached_property
    def _parameters(self) -> dict[str, float]:
        return dict(zip(self.model.parameter_names, self.model.parameter_values, strict=True))

    def _link(self, i: int) -> LinkState:
        segment, p = self.model.chain.segments[i], self._parameters
        get = lambda name: p.get(f"{segment.owner}.{name}", 0.0)  # noqa: E731
        line = {name: get(name) for name in ("rhoA", "EA", "EIy", "EIz")}
        return LinkState(self.model.chain.keys[i], line, get("frame_at"), get("length") / segment.count)

    def _join(self, i: int, q: np.ndarray) -> None:
        """The joint's axes, their projector and its rate, inertial components; and the axes in F_i at q = 0."""
        link = self.links[i]
        v, axes = link.values, [np.asarray(s.axis, float).reshape(3, 1) for s in self.model.chain.keys[i].screws]
        turned = []
        for k, axis in enumerate(axes):
            for later, angle in zip(axes[k + 1 :], q[k + 1 :], strict=True):
                axis = turn(later, angle, 0, 0).value.T @ axis
            turned.append(v["R"] @ axis)
        A = np.hstack(turned) if axes else np.zeros((3, 0))
        A_plus = pinv(A) if axes else np.zeros((0, 3))
        blocked = np.eye(3) - A @ A_plus
        v |= {"A": A, "A_plus": A_plus, "A_zero": np.hstack(axes) if axes else A, "A_body": v["R"].T @ A}
        half = blocked @ self._axes_rate(i, A, A_plus) @ A_plus
        v |= {"P": blocks(blocked, np.eye(3)), "Pdot": blocks(-half - half.T, O3)}
        for end, place in (("B", "a"), ("T", "c")):
            v[f"V_{end}"] = v["V"] + v[f"V_xi_{place}"] + v[f"V_b_{place}"]

    def _axes_rate(self, i: int, A: np.ndarray, A_plus: np.ndarray) -> np.ndarray:
        """The rate of the axes, inertial components: each turns with the rotations before it."""
        own, before = self.links[i].values, self.links[i - 1].values if i else None
        turning = before["R"] @ before["omega"] if before else Z3
        qdot = A_plus @ (own["R"] @ own["omega"] - turning)
        rates = [np.cross(turning + A[:, :k] @ qdot[:k], A[:, k : k + 1], axis=0) for k in range(A.shape[1])]
        return np.hstack(rates) if rates else A

    def view(self, **indices: int) -> EquationValues:
        """The values under an equation's indices: ``view(i=1)``; ``i=k`` brings ``i-1`` with it."""
        places = {name.lstrip("_"): k for name, k in indices.items()}
        if places.get("i", 0) > 0:
            places["i-1"] = places["i"] - 1
        values = {f"{n}:{index}": x for index, k in places.items() for n, x in self.links[k].values.items()}
        return EquationValues(values, {index: self.links[k].weights for index, k in places.items()})
