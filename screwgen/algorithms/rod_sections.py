"""The motion along a rod whose kinematics are kept whole, and the sums over its points: MODEL's exact rod.

The blocks of :mod:`..bodies.exact` have the equations of one section and of one mass. Here they are run along the rod,
from the base to the tip. What the equations of the link and of its tip need of that are inputs of their blocks, so the
phases ask an exact rod what they ask any other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Protocol

import numpy as np

from ..bodies.collocation import Collocation, Turn, collocation
from ..bodies.exact import SUMS
from ..ir.program import Array, Tracer
from ..spec.link_class import LinkClass
from . import matrices as mx

SECTION = ("R_k", "W_k", "w_k", "b_k", "t_k", "t_eta", "tdot", "t_bend")
LINKS = ("link", "turning_link", "energy")
TIPS = ("tip", "tip_motion", "tip_pose")


class Recorder(Protocol):
    """What of a scope is needed here."""

    key: LinkClass
    tracer: Tracer
    swept: dict[tuple, RodMotion]

    @property
    def rod(self) -> Recorder: ...

    def lower(self, block: str, inputs: Mapping[str, Array], *outputs: str) -> list[Array]: ...

    def constant(self, label: str) -> object: ...


@dataclass
class Section:
    """A section: rotation, turn by each mode, angular velocity and its rate at constant rates; the tangent's likewise."""

    R: Array
    W: Array
    w: Array
    bend: Array
    t: Array
    t_eta: Array
    tdot: Array
    t_bend: Array


@dataclass
class RodMotion:
    """The sections of a rod in a state; modal coordinates are those of unit length, in axes of F_i."""

    s: Recorder
    eta: Array
    etadot: Array
    scale: Array
    """(r,): coordinates of unit length per modal coordinate."""
    at: list[Section] = field(default_factory=list)

    @property
    def points(self) -> Collocation:
        return collocation(self.s.key)

    def run(self) -> RodMotion:
        """Find all sections."""
        before, place = _base(len(self.eta)), 0.0
        for k, s in enumerate(self.points.places):
            before = self.next(before, self.points.turn(place, float(s)), self.points.stretch(k))
            self.at.append(before)
            place = float(s)
        return self

    def end(self, s: float) -> Section:
        """The section at the place s, with its rotation alone; its point is that of :meth:`place`."""
        before, start = self._last_before(s)
        known = self.at[before - 1] if before else _base(len(self.eta))
        return self.next(known, self.points.turn(start, s), np.zeros((3, len(self.eta))))

    def _last_before(self, s: float) -> tuple[int, float]:
        """How many points lie before the place s, and where the last of them is."""
        before = int(sum(x <= s for x in self.points.places))
        return before, float(self.points.places[before - 1]) if before else 0.0

    def turns(self, s: float) -> list[Array]:
        """The turns from section to section as far as the place s."""
        before, start = self._last_before(s)
        places = [0.0, *self.points.places.tolist()]
        pieces = [self.points.turn(a, b) for a, b in pairwise(places[: before + 1])] + [self.points.turn(start, s)]
        return [self._turned(piece)[0] for piece in pieces]

    def _turned(self, turn: Turn) -> tuple[Array, Array]:
        """A turn and its derivative with the modes."""
        linear, once = _numbers(turn.linear), _bent(turn, self.eta)
        return mx.multiply(linear + once, self.eta), linear + 2.0 * once

    def next(self, before: Section, turn: Turn, stretch: np.ndarray) -> Section:
        theta, by_modes = self._turned(turn)
        length = _length(self.s)
        along = length * _numbers(stretch)
        given = {
            "R_0": before.R,
            "W_0": before.W,
            "w_0": before.w,
            "b_0": before.bend,
            "theta": theta,
            "theta_eta": by_modes,
            "thetadot": mx.multiply(by_modes, self.etadot),
            "theta_bend": mx.multiply(2.0 * _bent(turn, self.etadot), self.etadot),
            "tangent": mx.array([length, 0.0, 0.0]) + mx.multiply(along, self.eta),
            "stretch": along,
            "stretchdot": mx.multiply(along, self.etadot),
        }
        return Section(*self.s.lower("section", given, *SECTION))

    def place(self, s: float) -> tuple[Array, Array, Array, Array]:
        """Position, displacement by each mode, velocity and acceleration at constant rates of the point at s."""
        start = self.s.lower("link", {}, "start")[0] if self.s.key.frame_at else mx.zeros(1)
        weights = self.points.reach(s)
        sums = [_weighted(weights, [getattr(x, n) for x in self.at]) for n in ("t", "t_eta", "tdot", "t_bend")]
        sums[0] = sums[0] + mx.array([start[0], 0.0, 0.0])
        return sums[0], sums[1], sums[2], sums[3]


def _base(modes: int) -> Section:
    none, shapes = mx.zeros(3), mx.zeros(3, modes)
    return Section(mx.identity(3), shapes, none, none, none, shapes, none, none)


def _weighted(weights: np.ndarray, values: Sequence[Array]) -> Array:
    total = float(weights[0]) * values[0]
    for w, x in zip(weights[1:], values[1:], strict=True):
        total = total + float(w) * x
    return total


def _numbers(x: np.ndarray) -> Array:
    return mx.array(x.tolist(), x.shape)


def _bent(turn: Turn, x: Array) -> Array:
    """(3, r): the rows ``x^T B_c``."""
    return mx.array([mx.multiply(_numbers(B), x) for B in turn.bilinear], turn.linear.shape)


def _length(s: Recorder) -> object:
    return s.constant("length" if s.key.segments == 1 else "segment")


def motion_along(s: Recorder, inputs: Mapping[str, Array]) -> RodMotion:
    """The motion along the rod in the state of some inputs, found once in a scope."""
    rod = s.rod
    eta = np.asarray(inputs["eta"], dtype=object)
    etadot = np.asarray(inputs.get("etadot", mx.zeros(len(eta))), dtype=object)
    asked = (*eta, *etadot)
    if asked not in rod.swept:
        one = rod.lower("link", {}, "per_length")[0].item()
        scale = mx.array([1.0 if d == "torsion" else one for d, _ in rod.key.directions])
        rod.swept[asked] = RodMotion(rod, scale * eta, scale * etadot, scale).run()
    return rod.swept[asked]


def turns_to(s: Recorder, inputs: Mapping[str, Array]) -> list[Array]:
    """The turns from section to section, rotation vectors, as far as the section of the tip."""
    return motion_along(s, inputs).turns(s.key.section_at)


def along_rod(s: Recorder, block: str, inputs: Mapping[str, Array]) -> Mapping[str, Array]:
    """The inputs of a block, with those that are sums along the rod, or its end."""
    if "eta" not in inputs or block not in (*LINKS, *TIPS):
        return inputs
    motion = motion_along(s, inputs)
    found = sums(motion, inputs) if block in LINKS else tip(motion, s.key.section_at)
    return {**inputs, **found}


def tip(motion: RodMotion, at: float) -> dict[str, Array]:
    """Pose, shapes and motion of the section at s, as the blocks of the tip ask for them."""
    end, (r, P, rdot, bend) = motion.end(at), motion.place(at)
    shapes = {"Phi_c": P * motion.scale, "Psi_c": end.W * motion.scale, "J_l": mx.identity(3)}
    rates = {"udot_T": rdot, "bend_T": bend, "omega_s": end.w, "alpha_s": end.bend}
    return {"R_T": end.R, "r_T": r, **shapes, **rates}


def sums(motion: RodMotion, inputs: Mapping[str, Array]) -> dict[str, Array]:
    """The sums over masses and sections in the equations of the link."""
    s, key = motion.s, motion.s.key
    omega, alpha = inputs["omega"], inputs.get("alpha", mx.zeros(3))
    square = mx.multiply(mx.hat(omega), mx.hat(omega))
    (Omega,) = s.lower("turning_link", {"omega": omega, "alpha": alpha}, "Omega") if "alpha" in inputs else [square]
    total: dict[str, Array] = {}
    for dm, (place, _) in zip(s.lower("link", {}, "dm")[0], motion.points.masses, strict=True):
        r, P, rdot, bend = motion.place(place)
        given = {"dm": mx.array([dm]), "r_k": r, "P_k": P, "rdot_k": rdot, "r_bend": bend}
        _add(s, total, "element", given | {"omega": omega, "Omega": Omega})
    if key.turned:
        pieces = [s.lower("link", {}, f"dI_{axis}")[0] for axis in key.turned]
        for k, x in enumerate(motion.at):
            given = {f"dI_{axis}": mx.array([dI[k]]) for axis, dI in zip(key.turned, pieces, strict=True)}
            given |= {"R_k": x.R, "W_k": x.W, "w_k": x.w, "b_k": x.bend, "omega": omega, "alpha": alpha}
            _add(s, total, "section_spin", given)
    z = motion.scale
    total["C_rod"] = total["C_rod"] * z
    total["M_rod"] = mx.symmetric(len(z), lambda i, j: total["M_rod"][i, j] * (z[i] * z[j]))
    total["h_rod_eta"] = total["h_rod_eta"] * z
    return total


def _add(s: Recorder, total: dict[str, Array], block: str, given: Mapping[str, Array]) -> None:
    names = SUMS[block]
    for own, value in zip(names.values(), s.lower(block, given, *names), strict=True):
        total[own] = total[own] + value if own in total else value
