"""The rows of the judge's arm as functions of its unknowns: what the discretised system must be.

Rows of the joints, of the links and of the modes are affine in the wrenches and in the accelerations, ``[W_0; Zdot_1;
W_1; Zdot_2; etaddot_1; etaddot_2]``.  Every link is accelerated by one unknown at a time and its rows are measured: by
the balance of momentum, by the acceleration of its end sections, and for the modes by virtual work.  The columns of
M_sys are the differences; no formula of the derivation is used.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy

import numpy as np
from numpy.linalg import inv
from scipy.linalg import block_diag

from .jets import Jet, skew
from .moving_link import MovingLink, blocks, logarithm_rate, stack

UNIT = 1.0
"""By how much an unknown is varied; rows are affine in it."""


class Accelerated:
    """A link with its motion, but other accelerations: ``Zdot`` (6, 1) and ``etaddot`` (modes, 1)."""

    def __init__(self, link: MovingLink, Zdot: np.ndarray, etaddot: np.ndarray):
        v = link.values
        self.link, moved = link, copy(link)
        hat = skew(v["omega"])
        moved.values = dict(v)
        moved.R = Jet(link.R.value, link.R.rate, link.R.value @ (skew(Zdot[:3]) + hat @ hat))
        moved.p = moved.R @ Jet(v["r"], v["rdot"], Zdot[3:])
        moved.eta = Jet(link.eta.value, link.eta.rate, etaddot)
        moved._frame()
        moved._field()
        moved._ends(*(moved.p + moved.R @ sum_of(moved.displaced(place)) for place in (link.c, link.a)))
        self.values = v = moved.values
        self.force = link.rhoA * (v["dd_r_ob"] - v["R"].T @ link.gravity)
        v["total"] = stack(link.sum(skew(v["r_ib"]) @ self.force), link.sum(self.force))
        moved._split()

    def end(self, which: str) -> np.ndarray:
        """Angular acceleration and acceleration of an end section, ``B`` or ``T``, inertial components, (6, 1)."""
        return twice(self.values["R"]) @ self.values[f"dV_{which}"]

    def elastic_end(self, which: str) -> np.ndarray:
        """``R Vdot_xi`` of an end, ``a`` or ``c``, (6, 1)."""
        return twice(self.values["R"]) @ self.values[f"Vdot_xi_{which}"]

    @property
    def modal(self) -> np.ndarray:
        """Virtual work of inertia and weight on the modes, (modes, 1)."""
        phi = self.link.shapes(self.link.xi)
        return self.link.sum(np.swapaxes(phi, -1, -2) @ self.force)


def sum_of(jets: tuple[Jet, Jet]) -> Jet:
    return jets[0] + jets[1]


def twice(R: np.ndarray) -> np.ndarray:
    return blocks(R, R)


def potential(link: MovingLink, eta: np.ndarray) -> float:
    """The elastic energy of the link."""
    stretched, bent = link.shapes(link.xi, 1) @ eta, link.shapes(link.xi, 2) @ eta
    density = link.EA * stretched[:, 0] ** 2 + link.EIz * bent[:, 1] ** 2 + link.EIy * bent[:, 2] ** 2
    return float(link.weights @ density[:, 0] / 2)


def stress(link: MovingLink) -> np.ndarray:
    """The gradient of the potential: of a quadratic, central differences are exact."""
    at = lambda step: potential(link, link.eta.value + step.reshape(-1, 1))  # noqa: E731
    return np.array([[(at(e) - at(-e)) / 2] for e in np.eye(len(link.eta.value))])


def section_twist(link: MovingLink, place: float) -> np.ndarray:
    """The twist about the frame's origin that unit modal rates give a section normal to the centreline, (6, modes)."""
    turn = skew(np.array([[1.0], [0], [0]])) @ link.shapes(place, 1)
    r_b, r_xi = link.displaced(place)
    return np.vstack([turn, link.shapes(place) + skew(r_b.value + r_xi.value) @ turn])


class ModalRows:
    """The rows of the two links by their unknowns."""

    def __init__(self, links: Sequence[MovingLink]):
        self.first, self.second = links
        self.stress = [stress(link) for link in links]
        self.known: dict[tuple[int, bytes], Accelerated] = {}

    def accelerated(self, k: int, Zdot: np.ndarray, etaddot: np.ndarray) -> Accelerated:
        key = (k, np.vstack([Zdot, etaddot]).tobytes())
        if key not in self.known:
            self.known[key] = Accelerated((self.first, self.second)[k], Zdot, etaddot)
        return self.known[key]

    def __call__(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """All rows (24 + 2 modes, 1), and what of the first 24 is ``D_s``, at unknowns ``x`` of that size."""
        W, Z, eta = [x[:6], x[12:18]], [x[6:12], x[18:24]], np.split(x[24:], 2)
        one, two = (self.accelerated(k, Z[k], eta[k]) for k in range(2))
        below = [self.in_frame(0, W[0]), self.in_frame(1, inv(self.first.values["Ad"]).T @ W[1])]
        P, Pdot = zip(*((link.values["P"], link.values["Pdot"]) for link in (self.first, self.second)), strict=True)
        gap = end_twist(self.first, "T") - end_twist(self.second, "B")
        rows = [
            -P[0] @ one.end("B") - Pdot[0] @ end_twist(self.first, "B"),
            one.values["total"] + below[0] - W[1],
            P[1] @ (one.end("T") - two.end("B")) + Pdot[1] @ gap,
            two.values["total"] + below[1],
            one.modal + self.stress[0] + self.work(0, "a", below[0]) - self.work(0, "c", W[1]),
            two.modal + self.stress[1] + self.work(1, "a", below[1]),
        ]
        deformed = [
            -P[0] @ one.elastic_end("a"),
            one.values["D_star"],
            P[1] @ (one.elastic_end("c") - two.elastic_end("a")),
            two.values["D_star"],
        ]
        return np.vstack(rows), np.vstack(deformed)

    def in_frame(self, link: int, inertial: np.ndarray) -> np.ndarray:
        """A wrench about the inertial origin in the link's frame."""
        return (self.first, self.second)[link].values["Ad"].T @ inertial

    def work(self, link: int, end: str, wrench: np.ndarray) -> np.ndarray:
        """The force on the modes of a wrench on an end section."""
        body = (self.first, self.second)[link]
        return section_twist(body, getattr(body, end)).T @ wrench


def add_system(values: dict[str, np.ndarray], links: Sequence[MovingLink]) -> None:
    """Add the discretised system of the two links to the values of a motion, and what of it belongs to a link.

    Called before the links' values get their indices; the wrench on the ground, ``W:0``, is there already.
    """
    rows = ModalRows(links)
    of = lambda name: [link.values[name] for link in links]  # noqa: E731
    W = [values["W:0"], links[0].values["W"]]
    by_turns = lambda first, second: np.vstack([x for pair in zip(first, second, strict=True) for x in pair])  # noqa: E731
    now = np.vstack([by_turns(W, of("Zdot")), *of("etaddot")])
    (bias, h_MD), (balance, D_s) = rows(0 * now), rows(now)
    moved = [rows(UNIT * e.reshape(-1, 1)) for e in np.eye(len(now))]
    M = np.hstack([(whole - bias) / UNIT for whole, _ in moved])
    D = np.hstack([(part - h_MD) / UNIT for _, part in moved])
    no, O6 = [np.zeros((6, 1))] * 2, np.zeros((6, 6))
    loads = np.vstack([by_turns(no, of("W_star")), balance[24:]])
    T_gamma = block_diag(O6, links[0].values["T_gamma"], O6, links[1].values["T_gamma"])
    M_s = (M[:24, :24] - D[:, :24]) @ inv(np.eye(24) + T_gamma)
    still = [Accelerated(link, np.zeros((6, 1)), 0 * link.eta.second).values["Vdot"] for link in links]
    system = {
        "Psi": by_turns(W, of("Vdot")),
        "Psi_Z_s": now[:24],
        "eta_s": now[24:],
        "M_s": M_s,
        "D_s": D_s,
        "h_s": by_turns(joint_bias(*links), of("H_star")),
        "W_s": loads[:24],
        "T_gamma_s": T_gamma,
        "Gamma_star": by_turns(no, of("gamma_star")),
        "h_Ms": M_s @ by_turns(no, still),
        "M_D": M[:24, 24:],
        "M_DPsi": D[:, :24],
        "h_MD": h_MD,
        "M_dyn": M[:24, :24],
        "h_dyn": bias[:24],
        "M_Dphi_s": M[24:, :24],
        "M_Wphi_s": M[24:, 24:],
        "h_phi_s": bias[24:],
        "f_phi_s": loads[24:],
        "M_sys": M,
        "q_sys": now,
        "H_sys": bias,
        "W_sys": loads,
    }
    values |= {f"{name}:all": value for name, value in system.items()}
    for k, link in enumerate(links):
        link.values |= _of_link(link, k, system)


def joint_bias(first: MovingLink, second: MovingLink) -> list[np.ndarray]:
    """What the rows of the joints hold beside the rates of twists: ``h_s``, from the motion as it is."""
    P, Pdot = zip(*((link.values["P"], link.values["Pdot"]) for link in (first, second)), strict=True)
    base, tip = ("B", "a"), ("T", "c")
    return [
        -P[0] @ bias_of(first, *base) - Pdot[0] @ end_twist(first, "B"),
        P[1] @ (bias_of(first, *tip) - bias_of(second, *base))
        + Pdot[1] @ (end_twist(first, "T") - end_twist(second, "B")),
    ]


def end_twist(link: MovingLink, which: str) -> np.ndarray:
    """Angular velocity and velocity of an end section, inertial components, (6, 1)."""
    return twice(link.values["R"]) @ link.values[f"V_{which}"]


def bias_of(link: MovingLink, which: str, end: str) -> np.ndarray:
    """The acceleration of an end section less the rates of the components of the twists, inertial components."""
    v = link.values
    rate = v["vdot"] - skew(v[f"r_b_{end}"]) @ v["omegadot"] + v[f"Vdot_xi_{end}"][3:]
    return twice(v["R"]) @ (v[f"dV_{which}"] - stack(v["omegadot"], rate))


def _of_link(link: MovingLink, k: int, system: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """A link's rows and columns of the system."""
    r = len(link.eta.value)
    modal, own, motion = slice(24 + k * r, 24 + (k + 1) * r), slice(12 * k, 12 * k + 12), slice(12 * k + 6, 12 * k + 12)
    M, half = system["M_sys"], r // 2
    J_a = section_twist(link, link.a)
    speed = link.values["v_ob"]
    return {
        "M_Dphi": M[modal, own],
        "M_Dphi_diff": M[modal, motion],
        "M_Wphi": M[modal, modal],
        "M_D_link": M[motion, modal],
        "M_dyn_diff": M[motion, motion],
        "h_phi": system["H_sys"][modal],
        "h_phi_one": system["H_sys"][modal][:half],
        "f_phi": system["W_sys"][modal],
        "Psi_Z": system["q_sys"][own],
        "J_a": J_a,
        "J_c": section_twist(link, link.c),
        "J_a_one": J_a[:, :half],
        "J_a_two": J_a[:, half:],
        "load_one": link.sum(np.swapaxes(link.shapes(link.xi)[..., :half], -1, -2) @ link.values["load"]),
        "J_q_link": coordinate_rates(link.R.value),
        "T": link.rhoA / 2 * link.sum(np.swapaxes(speed, -1, -2) @ speed),
        **_first_mode(link, half),
    }


def coordinate_rates(R: np.ndarray) -> np.ndarray:
    """From Z to the rates of ``[theta; r]``, (6, 6): turn the link about one axis after the other."""
    turned = [logarithm_rate(R, R @ skew(e.reshape(3, 1))) for e in np.eye(3)]
    return blocks(np.hstack(turned), np.eye(3))


def _first_mode(link: MovingLink, half: int) -> dict[str, np.ndarray]:
    """Shapes and acceleration of the first mode of each direction."""
    of = lambda place, order: link.shapes(place, order)[..., :half]  # noqa: E731
    fields = {f"phi{order}_one": of(link.xi, order) for order in (1, 2, 4)}
    ends = {f"phi{order or ''}_one_{end}": of(getattr(link, end), order) for order in (0, 1) for end in "ac"}
    return fields | ends | {"etaddot_one": link.eta.second[:half]}
