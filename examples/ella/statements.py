"""The numbers that the paper's text states, each beside what is computed and how it stands."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from screwgen.simulation.motion import displacements, screws

from .arm import PRINTED_BOUND, SET_POINTS, STEP
from .document import Document
from .frequencies import CHOSEN, Loop
from .growth import Growth
from .task import Results

MS, MM = 1e3, 1e3
NO_AXIAL = ", no axial modes"


def statements(out: Document, r: Results) -> None:
    out.heading("What the paper states, and what comes out")
    rows = [*of_bending(r), *of_the_step(r), *of_the_run(r)]
    out.table(("the paper", "computed", "standing"), rows)


def of_bending(r: Results) -> list[tuple[str, str, str]]:
    n, chosen = r.numbers, loop(r, CHOSEN).frequencies
    one, converged = r.frequencies[0].frequencies[0], r.frequencies[0].frequencies[-1]
    return [
        (
            "second bending frequency ≈ 6.27 × the first",
            f"bare clamped-free beam: {n.ratio_roots:.4f} from the roots; {n.ratio_model:.4f} from the model of "
            f"link 2, clamped, without payload, two modes ({n.bare[0]:.2f} and {n.bare[1]:.2f} Hz)",
            f"**holds for the bare beam only**: with the payload at its tip the ratio is {n.ratio_payload:.2f}",
        ),
        (
            "a secondary component near 13 Hz is that second mode",
            "the arm has one mode per plane, so it has no second one (E33). Joints locked, its next frequencies are "
            f"{pair(one[2:])} Hz, converged {pair(converged[2:])} Hz: {converged[2] / converged[0]:.1f} and "
            f"{converged[3] / converged[0]:.1f} × the first",
            f"**the explanation fails**. Under our PD law the arm has a motion at {chosen[3]:.2f} Hz: the first "
            "bending of the links, against joints that give way",
        ),
        (
            f"first frequency near 2 Hz (13 / 6.27 = {13 / 6.27:.2f})",
            f"joints locked {pair(one)} Hz with the paper's modes, {pair(converged, 4)} Hz converged; under our PD law "
            f"{', '.join(f'{f:.2f}' for f in chosen[:3])} Hz",
            "**not with locked joints, possible with joints that give way**. The paper states no gains, so this "
            "confirms nothing",
        ),
    ]


def of_the_step(r: Results) -> list[tuple[str, str, str]]:
    n, (kept, dropped) = r.numbers, (by_name(r, f"forward Euler, 1 ms{x}") for x in ("", NO_AXIAL))
    factor = lambda g: np.exp(g.predicted * STEP)  # noqa: E731
    return [
        (
            f"step bound {PRINTED_BOUND * MS:.2f} ms",
            f"(stability) with the numbers given: {n.bound * MS:.2f} ms; with the axial mode, which the paper keeps: "
            f"{n.axial_bound * MS:.2f} ms ({n.axial_frequency:.0f} Hz)",
            "**fails** (E19): the value, the mode that counts, and the method; 2/ω is the bound of symplectic Euler",
        ),
        (
            "forward Euler at 1 ms is stable, with a margin of 10",
            f"largest factor per step {factor(kept):.2f} with axial modes ({rate(kept.predicted)} /s), "
            f"{factor(dropped):.3f} without ({rate(dropped.predicted)} /s)",
            "**fails**; see the next tables",
        ),
    ]


def of_the_run(r: Results) -> list[tuple[str, str, str]]:
    (deflection, share), (force, weight) = largest_deflection(r), weights(r)
    errors = ", ".join(f"{1e3 * x:.0f}" for x in r.run.q[-1, :3] - SET_POINTS)
    return [
        (
            "deformations stay small",
            f"largest deflection of a link {deflection * MM:.1f} mm, {100 * share:.1f} % of its length",
            "**holds** in this run",
        ),
        (
            "wrenches consistent with the weight",
            f"mean vertical base force over the last second {force:.2f} N, weight of the arm {weight:.2f} N",
            "**holds**, to what the remaining vibration leaves of the mean",
        ),
        (
            "joint angles converge to the references",
            f"at the end off by {errors} mrad",
            "**holds to within the weight over kp**: a PD law alone cannot hold an arm against gravity without "
            "an error",
        ),
    ]


def pair(found, digits: int = 2) -> str:
    return " and ".join(f"{f:.{digits}f}" for f in found[:2])


def rate(x: float) -> str:
    """A growth rate with its sign and five digits."""
    shown = f"{x:+.1f}" if abs(x) >= 100 else f"{x:+.3f}" if abs(x) >= 10 else f"{x:+.5f}"
    return shown.replace("-", "−")


# ------------------------------------------------------------------------------ what is looked up


def by_name(r: Results, name: str) -> Growth:
    """The growth of the held arm stepped in the way of that name, under the chosen gains."""
    return next(g for g in r.growth if g.name == name and g.joints == "PD")


def loop(r: Results, name: str) -> Loop:
    return next(x for x in r.loops if x.name == name)


def largest_deflection(r: Results) -> tuple[float, float]:
    """Of the links' tips in their own frames: m, and as a share of the link's length."""
    found = []
    for i, link in enumerate(r.arm.robot.links):
        size = float(np.linalg.norm(displacements(r.arm.axial, r.run.q, i, [1.0])[:, 0], axis=1).max())
        found.append((size, size / link.length))
    return max(found)


def weights(r: Results) -> tuple[float, float]:
    """N: mean of the vertical force on link 1 by the base over the last second, and the weight."""
    rows = r.run.t > r.run.t[-1] - 1.0
    turn = Rotation.from_rotvec(screws(r.arm.axial, r.run.q[rows], r.run.v[rows]).theta[:, 0])
    force = turn.apply(r.run.wrench[rows, 0, 3:])[:, 2].mean()
    robot = r.arm.robot
    mass = sum(x.section.rhoA * x.length + sum(b.mass for b in x.bodies) for x in robot.links)
    return float(force), float(-mass * robot.gravity[2])
