"""The motion along a rod whose kinematics are kept whole, and the sums over its points.

The blocks of :mod:`..bodies.exact` have the equations of one section and of one mass. Here they are run along the rod,
from the base to the tip. What the equations of the link and of its tip need of that are inputs of their blocks, so the
phases ask an exact rod what they ask any other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Protocol

import numpy as np

from ..bodies.collocation import Collocation, RodTurn, collocation
from ..bodies.exact import SUMS
from ..ir.program import Array, Node, Value, Vector
from ..spec.link_class import LinkClass
from . import matrices as mx

SECTION = ("R_k", "W_k", "w_k", "b_k", "t_k", "t_eta", "tdot", "t_bend", "G_k")
STORED = ("theta_eta", "R", "W", "w", "bend", "t", "t_eta", "tdot", "t_bend", "G")
"""What of the sections later phases of a link find in its store."""
LINKS = ("link", "turning_link", "energy")
RECALLING = "turning_link"
"""The block of phases that find the sections in the store: none of them differentiates it at constant modal rates."""
TIPS = ("tip", "tip_motion", "tip_pose")


class RodScope(Protocol):
    """What of a scope is needed here."""

    key: LinkClass
    swept: dict[tuple, RodMotion]

    @property
    def layouts(self) -> Mapping[str, object]: ...

    @property
    def rod(self) -> RodScope: ...

    def lower(self, block: str, inputs: Mapping[str, Array], *outputs: str) -> list[Array]: ...

    def constant(self, label: str) -> Value: ...

    def routine(self, name: str) -> AbstractContextManager[None]: ...

    def keep(self, name: str, values: Array) -> None: ...

    def kept(self, name: str) -> Array: ...


@dataclass
class RodSection:
    """A section: rotation, turn by each mode, angular velocity and its rate at constant rates; and its tangent's."""

    theta_eta: Array
    """The derivative of the turn from the section before with each mode."""
    stretch: Array
    """That of the tangent in axes of the section."""
    R: Array
    W: Array
    w: Array
    bend: Array
    t: Array
    t_eta: Array
    tdot: Array
    t_bend: Array
    G: Array


@dataclass
class RodMotion:
    """The sections of a rod in a state; modal coordinates are those of unit length, in axes of F_i."""

    s: RodScope
    eta: Array
    etadot: Array
    etaddot: Array
    scale: Array
    """(r,): coordinates of unit length per modal coordinate."""
    rest: Array
    """(p,): the numbers of the curvature at rest, times the length."""
    at: list[RodSection] = field(default_factory=list)

    @property
    def points(self) -> Collocation:
        return collocation(self.s.key)

    def run(self) -> None:
        """Find all sections."""
        before, place = _base(len(self.eta)), 0.0
        for s in self.points.places:
            before = self.next(before, self.points.turn(place, float(s)), self.points.stretch(s))
            self.at.append(before)
            place = float(s)

    def keep(self) -> None:
        """Store all sections for later phases of the link."""
        for name in STORED:
            self.s.keep(f"rod_{name}", np.array([getattr(x, name) for x in self.at], dtype=object))

    def recall(self) -> None:
        """Take the sections that an earlier phase of the link has stored."""
        length, found = length_of(self.s), {name: self.s.kept(f"rod_{name}") for name in STORED}
        for k, s in enumerate(self.points.places):
            section = {name: values[k] for name, values in found.items()}
            self.at.append(RodSection(stretch=length * constants(self.points.stretch(s)), **section))

    def end(self, s: float) -> RodSection:
        """The section at the place s, of which the rotation alone is of use: points are sums of tangents."""
        before, start = self._last_before(s)
        known = self.at[before - 1] if before else _base(len(self.eta))
        return self.next(known, self.points.turn(start, s), np.zeros((3, len(self.eta))))

    def points_before(self, s: float) -> int:
        """How many points lie before the place s."""
        return int(sum(x <= s for x in self.points.places))

    def _last_before(self, s: float) -> tuple[int, float]:
        """How many points lie before the place s, and where the last of them is."""
        before = self.points_before(s)
        return before, float(self.points.places[before - 1]) if before else 0.0

    def turns(self, s: float) -> list[Array]:
        """The turns from section to section as far as the place s."""
        before, start = self._last_before(s)
        places = [0.0, *self.points.places.tolist()]
        pieces = [self.points.turn(a, b) for a, b in pairwise(places[: before + 1])] + [self.points.turn(start, s)]
        return [self._turned(piece)[0] for piece in pieces]

    def _turned(self, turn: RodTurn) -> tuple[Array, Array, Array, Array]:
        """A turn, its derivative with the modes, its rate, and its second rate."""
        r, still = len(self.eta), mx.zeros(len(self.rest))
        motion = [np.append(self.eta, self.rest), np.append(self.etadot, still), np.append(self.etaddot, still)]
        by_modes, (theta, rate, bend) = constants(turn.linear[:, :r]), (_along(turn.linear, x) for x in motion)
        for A, B in turn.crossed:
            (a, b), (adot, bdot), (addot, bddot) = ((_along(A, x), _along(B, x)) for x in motion)
            theta, rate = theta + mx.cross(a, b), rate + mx.cross(adot, b) + mx.cross(a, bdot)
            bend = bend + 2.0 * mx.cross(adot, bdot) + mx.cross(addot, b) + mx.cross(a, bddot)
            by_modes = by_modes + _crossed(a, B[:, :r]) - _crossed(b, A[:, :r])
        return theta, by_modes, rate, bend

    def next(self, before: RodSection, turn: RodTurn, stretch: np.ndarray) -> RodSection:
        """The section that follows another by a turn, with the stretch (3, r) there by each mode."""
        with self.s.routine("rod_turn"):
            theta, by_modes, rate, bend = self._turned(turn)
            given = {"theta": theta, "theta_eta": by_modes, "thetadot": rate, "theta_bend": bend}
            for name, values in given.items():
                mx.name(name, values)
        length = length_of(self.s)
        along = length * constants(stretch)
        given |= {
            "R_0": before.R,
            "W_0": before.W,
            "w_0": before.w,
            "b_0": before.bend,
            "tangent": mx.array([length, 0.0, 0.0]) + mx.multiply(along, self.eta),
            "stretch": along,
            "stretchdot": mx.multiply(along, self.etadot),
            "stretchddot": mx.multiply(along, self.etaddot),
        }
        with self.s.routine("rod_section"):
            return RodSection(by_modes, along, *self.s.lower("section", given, *SECTION))

    def sum_of(self, weights: Vector, *names: str) -> list[Array]:
        """The weighted sums over the sections of some of their quantities."""
        return [_weighted(weights, [getattr(x, name) for x in self.at]) for name in names]


def _base(modes: int) -> RodSection:
    none, shapes = mx.zeros(3), mx.zeros(3, modes)
    return RodSection(shapes, shapes, mx.identity(3), shapes, none, none, none, shapes, none, none, mx.identity(3))


def _weighted(weights: Vector, values: Sequence[Array]) -> Array:
    total = mx.zeros(*values[0].shape)
    for w, x in zip(weights, values, strict=True):
        total = total + w * x
    return total


def constants(x: np.ndarray) -> Array:
    """An array of numbers as one of a program."""
    return mx.array(x.tolist(), x.shape)


def _along(C: np.ndarray, x: Array) -> Array:
    return mx.multiply(constants(C), x)


def _crossed(a: Array, C: np.ndarray) -> Array:
    """(3, r): ``a x`` each column."""
    return mx.array([mx.cross(a, column) for column in C.T.tolist()]).T


def length_of(s: RodScope) -> Value:
    """The length of the link, or of its segment."""
    return s.constant("length" if s.key.segments == 1 else "segment")


def modal_scale(s: RodScope) -> Array:
    """(r,): coordinates of unit length per modal coordinate: one over the length, 1 for torsion."""
    per_length = s.lower("link", {}, "per_length")[0].item()
    return mx.array([1.0 if d == "torsion" else per_length for d, _ in s.key.directions])


def rest_turns(s: RodScope) -> Array:
    """(p,): the numbers of the curvature at rest, times the length: coordinates of unit length that stay."""
    return s.lower("link", {}, "kappa_0")[0] if s.key.rest else mx.zeros(0)


def motion_along(s: RodScope, inputs: Mapping[str, Array], recall: bool = False) -> RodMotion:
    """The motion along the rod in the state of some inputs, found once in a scope.

    That of a link's own state at constant rates is stored; with ``recall`` a later phase takes it from there. Phases
    that differentiate by the modes must find it anew.
    """
    rod = s.rod
    eta = np.asarray(inputs["eta"], dtype=object)
    still = mx.zeros(len(eta))
    etadot, etaddot = (np.asarray(inputs.get(name, still), dtype=object) for name in ("etadot", "etaddot"))
    asked = (*eta, *etadot, *etaddot)
    if asked not in rod.swept:
        scale = modal_scale(rod)
        coordinates, rates, accelerations = (scale * x for x in (eta, etadot, etaddot))
        for name, values in (("unit_eta", coordinates), ("unit_etadot", rates), ("unit_etaddot", accelerations)):
            mx.name(name, values)
        motion = RodMotion(rod, coordinates, rates, accelerations, scale, rest_turns(rod))
        own = _all_of("eta", eta) and _all_of("etadot", etadot)
        if recall and own and "rod_R" in rod.layouts:
            motion.recall()
        else:
            motion.run()
            if own and "etaddot" not in inputs:
                motion.keep()
        rod.swept[asked] = motion
    return rod.swept[asked]


def _all_of(name: str, values: Array) -> bool:
    """Whether values are the entries of an input of that name."""
    return all(isinstance(x, Node) and x.op == "input" and x.args[0] == name for x in values)


def turns_to(s: RodScope, inputs: Mapping[str, Array]) -> list[Array]:
    """The turns from section to section, rotation vectors, as far as the section of the tip."""
    return motion_along(s, inputs).turns(s.key.section_at)


def along_rod(s: RodScope, block: str, inputs: Mapping[str, Array]) -> Mapping[str, Array]:
    """The inputs of a block, with those that are sums along the rod, or its end."""
    if "eta" not in inputs or block not in (*LINKS, *TIPS):
        return inputs
    motion = motion_along(s, inputs, recall=block == RECALLING and "etaddot" not in inputs)
    found = sums(motion, block, inputs) if block in LINKS else tip(motion, s.key.section_at)
    return {**inputs, **found}


def tip(motion: RodMotion, at: float) -> dict[str, Array]:
    """Pose, shapes and motion of the section at s, as the blocks of the tip ask for them."""
    key, s, end = motion.s.key, motion.s, motion.end(at)
    r, P, rdot, bend = motion.sum_of(motion.points.reach(at).tolist(), "t", "t_eta", "tdot", "t_bend")
    if key.frame_at:
        r = r + mx.array([s.lower("link", {}, "start")[0][0], 0.0, 0.0])
    shapes = {"Phi_c": P * motion.scale, "Psi_c": end.W * motion.scale, "J_l": mx.identity(3)}
    rates = {"udot_T": rdot, "bend_T": bend, "omega_s": end.w, "alpha_s": end.bend}
    return {"R_T": end.R, "r_T": r, **shapes, **rates}


def held(s: RodScope, inputs: Mapping[str, Array], moment: Array, force: Array) -> Array:
    """(r,): the modal forces of a moment and a force at the section of the tip, in axes of F_i."""
    motion, none, at = motion_along(s, inputs), mx.zeros(3), s.key.section_at
    last = motion.points_before(at) - 1
    total: dict[str, Array] = {}
    _load(motion.s, total, motion.end(at), none, moment, none)  # its turn begins at the last point before it
    behind = none
    for k, w in reversed(list(enumerate(motion.points.reach(at)))):
        behind = _load(motion.s, total, motion.at[k], behind, moment if k == last else none, w * force)
    return total["h_rod"] * motion.scale


def _load(s: RodScope, total: dict[str, Array], x: RodSection, behind: Array, tau: Array, f: Array) -> Array:
    """Add what a moment on a section and a force on its tangent do to the modes; returns the moment with all behind."""
    given = {"R_k": x.R, "G_k": x.G, "t_k": x.t, "theta_eta": x.theta_eta, "stretch": x.stretch}
    with s.routine("rod_load"):
        return _add(s, total, "section_load", given | {"m_1": behind, "tau_s_k": tau, "f_k": f}, "m_k")[0]


def sums(motion: RodMotion, block: str, inputs: Mapping[str, Array]) -> dict[str, Array]:
    """The sums over masses and sections in the equations of the link."""
    s, key = motion.s, motion.s.key
    omega, alpha = inputs["omega"], inputs.get("alpha", mx.zeros(3))
    base = {name: inputs[name] for name in ("omega", "alpha", "v", "g") if name in inputs}
    Omega, a_0 = s.lower(block, base, "Omega", "a_start" if key.frame_at else "a_0")
    # acceleration and velocity of every tangent's end relative to its start, in space
    with s.routine("rod_motion"):
        a = [mx.multiply(Omega, x.t) + 2.0 * mx.cross(omega, x.tdot) + x.t_bend for x in motion.at]
        u = [mx.cross(omega, x.t) + x.tdot for x in motion.at]
    rows, shares, centre = _masses(motion)
    with s.routine("rod_centre"):
        r_mean, P_mean = motion.sum_of(centre, "t", "t_eta")
    total = {"r_rod": r_mean, "P_rod": P_mean, "a_rod": _weighted(centre, a), "u_rod": _weighted(centre, u)}
    forces = [w * a_0 for w in centre]
    for row, share in zip(rows, shares, strict=True):
        with s.routine("rod_mass"):
            (r, P), a_k = motion.sum_of(row, "t", "t_eta"), _weighted(row, a)
            given = {"share": mx.array([share]), "r_k": r, "P_k": P, "a_k": a_k, "u_k": _weighted(row, u)}
            _add(s, total, "element", given)
            forces = [f + (w * share) * a_k for f, w in zip(forces, row, strict=True)]
    torques = [mx.zeros(3) for _ in motion.at]
    if key.turned:
        pieces = [s.lower("link", {}, f"dI_{axis}")[0] for axis in key.turned]
        for k, x in enumerate(motion.at):
            given = {f"dI_{axis}": mx.array([dI[k]]) for axis, dI in zip(key.turned, pieces, strict=True)}
            given |= {"R_k": x.R, "W_k": x.W, "w_k": x.w, "b_k": x.bend, "omega": omega, "alpha": alpha}
            with s.routine("rod_spin"):
                (torques[k],) = _add(s, total, "section_spin", given, "tau_s_k")
    mu, moment = s.lower("link", {}, "mu")[0], mx.zeros(3)
    for x, f, tau in zip(motion.at[::-1], forces[::-1], torques[::-1], strict=True):
        moment = _load(s, total, x, moment, tau, mu[0] * f)
    return {name: _scaled(value, name, motion.scale) for name, value in total.items()}


def _masses(motion: RodMotion) -> tuple[Sequence[Vector], Vector, Vector]:
    """Of each mass the weights of the tangents in its position, and its share of the rod's; the weights of the mean."""
    points = motion.points
    if points.masses is None:
        return points.uniform.tolist(), [1.0] * len(points.places), points.centre.tolist()
    shares, centre = (motion.s.lower("link", {}, name)[0] for name in ("shares", "centre"))
    return [points.reach(place).tolist() for place, _ in points.masses], shares, centre


def _scaled(value: Array, name: str, z: Array) -> Array:
    """A sum whose columns are of modal coordinates of unit length, for those of the link."""
    if name in ("M_rod", "M_spin"):
        return mx.symmetric(len(z), lambda i, j: value[i, j] * (z[i] * z[j]))
    return value * z if name in ("P_rod", "C_rod", "C_spin", "h_rod") else value


def _add(s: RodScope, total: dict[str, Array], block: str, given: Mapping[str, Array], *more: str) -> list[Array]:
    """Add what a block contributes to the sums; returns further results."""
    names = SUMS[block]
    values = s.lower(block, given, *names, *more)
    for own, value in zip(names.values(), values, strict=False):
        total[own] = mx.name(own, total[own] + value) if own in total else value
    return values[len(names) :]
