"""The state of the judge's whole arm, the solution of its system, and one step of Table 1 against its exact motion."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy

import numpy as np
from numpy.linalg import inv, lstsq, solve
from scipy.spatial.transform import Rotation

from .jets import Jet, constant, skew
from .modal_rows import ModalRows
from .moving_link import MovingLink, adjoint, blocks, logarithm_rate, stack

N, MODES = 2, 6
"""Links of the judge's arm, and modes of each."""
POSES, ETAS = slice(0, 6 * N), slice(6 * N, 6 * N + MODES * N)
RATES, ETADOTS = slice(ETAS.stop, ETAS.stop + 6 * N), slice(ETAS.stop + 6 * N, 2 * ETAS.stop)
"""Places in the state x_c, (109)."""
I3 = np.eye(3)
Values = dict[str, np.ndarray]
Links = Sequence[MovingLink]


def add_cauchy(known: Values, links: Links) -> None:
    """Add the Cauchy form to the values of a motion, after its system: of the paper's solution, marked with an
    asterisk, the accelerations are solved for; all else is as it is in the motion."""
    each = lambda name: np.vstack([link.values[name] for link in links])  # noqa: E731
    x = {name: each(name) for name in ("q", "eta", "Z", "etadot")}
    found = completed_solution(known, links)
    x |= {"Zdot_star": found[: 12 * N].reshape(N, 12)[:, 6:].reshape(-1, 1), "etaddot_star": found[12 * N :]}
    x["x_c"] = np.vstack([x[name] for name in ("q", "eta", "Z", "etadot")])
    x["xdot_c"] = np.vstack([each(name) for name in ("qdot", "etadot", "Zdot", "etaddot")])
    x["g_c"] = np.vstack([0 * x["q"], 0 * x["eta"], each("Zdot"), each("etaddot")])
    x["A_c"] = coordinate_map(links)
    x["J_q"] = np.zeros((6 * N, 6 * N))
    for k, link in enumerate(links):
        x["J_q"][6 * k : 6 * k + 6, 6 * k : 6 * k + 6] = blocks(link.values["J_theta"], I3)
    known |= {f"{name}:all": value for name, value in x.items()}


def coordinate_map(links: Links) -> np.ndarray:
    """From Z and etadot to the rates of the coordinates, column by column: turn a link and take the logarithm."""
    A = np.zeros((2 * ETAS.stop,) * 2)
    for k, link in enumerate(links):
        R, at = link.R.value, 6 * k
        columns = [logarithm_rate(R, R @ skew(e.reshape(3, 1))) for e in I3]
        A[at : at + 6, RATES.start + at : RATES.start + at + 6] = blocks(np.hstack(columns), I3)
    A[ETAS, ETADOTS] = np.eye(MODES * N)
    return A


# ------------------------------------------------------------------------------------------ solution


def completed_solution(known: Values, links: Links) -> np.ndarray:
    """``M_sys^-1 (W_sys - H_sys)``, after the rows of the joints have been told the torques of their motors.

    What the rows lack of the loads is measured anew after a first solution: their matrix is one of differences, whose
    rounding goes with it.  Elastic forces, which rows and loads share, are left out: they cost digits.
    """
    rows, truth = ModalRows(links), known["q_sys:all"]
    rows.stress = [0 * force for force in rows.stress]
    torques = motor_rows(links)
    M, loads = known["M_sys:all"] + torques, rows(truth)[0] + torques @ truth
    x = np.zeros_like(truth)
    for _ in range(2):
        x = x + solve(M, loads - rows(x)[0] - torques @ x)
    return x


def motor_rows(links: Links) -> np.ndarray:
    """From the unknowns to the joints' moments along their axes, inertial components, in the rows of the joints."""
    out = np.zeros((12 * N + MODES * N,) * 2)
    for k, link in enumerate(links):
        v = link.values
        joint = v["R"] @ (v["r"] + v["r_b_a"] + v["r_xi_a"])
        to_inertial = inv(links[k - 1].values["Ad"]).T if k else np.eye(6)
        moment = np.hstack([I3, -skew(joint)]) @ to_inertial
        out[12 * k : 12 * k + 3, 12 * k : 12 * k + 6] = v["A"] @ v["A_plus"] @ moment
    return out


def solution_misfits(v: Values, links: Links) -> tuple[float, float]:
    """How far the solution is from the motion: the smallest that fits the printed system, and the completed one's."""
    truth = v["q_sys:all"]
    printed = lstsq(v["M_sys:all"], v["W_sys:all"] - v["H_sys:all"], rcond=1e-10)[0]
    gap = lambda x: float(np.abs(x - truth).max() / np.abs(truth).max())  # noqa: E731
    return gap(printed), gap(completed_solution(v, links))


# --------------------------------------------------------------------------------------------- steps


def inertial_states(x_c: np.ndarray, links: Links) -> np.ndarray:
    """Steps ix and x of Table 1 from the state alone: of each link rotation, place and twist, then displacement of the
    tip and its velocity, in inertial components. Of the links only the shapes are used."""
    out = []
    for k, link in enumerate(links):
        q, Z = x_c[POSES][6 * k : 6 * k + 6], x_c[RATES][6 * k : 6 * k + 6]
        R, r, turning = Rotation.from_rotvec(q[:3, 0]).as_matrix(), q[3:], skew(Z[:3])
        V = Z + stack(np.zeros((3, 1)), turning @ r)
        r_xi, rate = (link.shapes(link.c) @ x_c[part][MODES * k : MODES * (k + 1)] for part in (ETAS, ETADOTS))
        out += [R.reshape(-1, 1), R @ r, adjoint(R, R @ r) @ V, R @ r_xi, R @ (rate + turning @ r_xi)]
    return np.vstack(out)


def measured_states(links: Links) -> np.ndarray:
    """The same as they are in the motion."""
    out = []
    for link in links:
        v, R = link.values, link.values["R"]
        out += [R.reshape(-1, 1), v["r_o"], v["Ad"] @ v["V"], R @ v["r_xi_c"], R @ v["V_xi_c"][3:]]
    return np.vstack(out)


def later(links: Links, t: float) -> list[MovingLink]:
    """The links at the time t: joint and modal coordinates go on with the second derivatives that they have."""
    moved = [copy(link) for link in links]
    R, tip = constant(I3), constant(np.zeros((3, 1)))
    for link in moved:
        angle, rate, second = link.joint.T
        link.joint = np.stack([angle + t * rate + t**2 / 2 * second, rate + t * second, second], 1)
        eta = link.eta
        link.eta = Jet(eta.value + t * eta.rate + t**2 / 2 * eta.second, eta.rate + t * eta.second, eta.second)
        link.values = {}
        R, tip = link.move(R, tip)
    return moved


def step_defects(v: Values, links: Links) -> tuple[float, float]:
    """The error of one step of Table 1 per length, extrapolated to a step of zero: 0 where the steps are consistent.

    Steps vii and viii: solve the system, integrate by forward Euler with ``qdot = J Z`` as printed, then ``J^-1 Z``;
    ix and x after them.  Taken forwards and backwards, against the motion, relative to the rate of the states.
    """
    x_c, slopes = v["x_c:all"], [v[f"{name}:all"] for name in ("etadot", "Zdot_star", "etaddot_star")]
    exact = rate(lambda h: measured_states(later(links, h)))

    def defect(J: np.ndarray) -> float:
        xdot = np.vstack([J @ v["Z:all"], *slopes])
        stepped = rate(lambda h: inertial_states(x_c + h * xdot, links))
        return float(np.abs(stepped - exact).max() / np.abs(exact).max())

    return defect(v["J_q:all"]), defect(inv(v["J_q:all"]))


def rate(state: Callable[[float], np.ndarray], first: float = 0.02, levels: int = 5) -> np.ndarray:
    """The derivative at 0 by central differences, extrapolated by Richardson's table."""
    row: list[np.ndarray] = []
    for k in range(levels):
        h = first / 2**k
        new = [(state(h) - state(-h)) / (2 * h)]
        for j, old in enumerate(row, 1):
            new.append(new[-1] + (new[-1] - old) / (4**j - 1))
        row = new
    return row[-1]
