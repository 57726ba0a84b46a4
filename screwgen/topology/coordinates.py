"""The coordinates of a robot: of a floating base, joints, rotors and modes, their places, and states made complete."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import accumulate
from typing import Any

import numpy as np

from ..elements import TRAVELS, Law, Travel
from ..spec.link_class import LinkClass
from .law_coordinates import LawCoordinates

SLACK = 1e-3
"""How far the length of a stated quaternion may be from one."""

INTERNAL = {"qdot": "z", "qddot": "zdot"}
"""The signal of a link's internal states, or of their rates, by that of what stands before them."""

ADDED = {"q": "theta", "qdot": "thetadot", "qddot": "thetaddot", "force": "force_theta"}
"""The signal of what elements add to a link's coordinates by that of its joint."""


class Coordinates(LawCoordinates):
    """The coordinates of links of given classes, `q` (nq) and `v` (nv), and their offsets by link.

    Both hold the joints link by link, then rotors, then modes. What moves coordinates by rates asks the joints.

    ``parameter_labels``: for every link, the label of each of its parameters and its place in the parameter vector.
    """

    def __init__(self, keys: Sequence[LinkClass], parameter_labels: Sequence[Mapping[str, int]]):
        super().__init__(keys)
        self.parameter_labels = list(parameter_labels)
        offsets = lambda size: list(accumulate(map(size, self.keys), initial=0))  # noqa: E731
        self.eta_offset = offsets(lambda k: k.modes)
        self.below_offset = offsets(lambda k: len(k.coupled))

    @property
    def n(self) -> int:
        return len(self.keys)

    @property
    def n_joints(self) -> int:
        """The number of joint rates with a torque, the first of `v`, or those behind the twist of a floating base."""
        return self.tau_offset[-1]

    @property
    def floating(self) -> bool:
        """Whether the first link moves freely: its pose precedes the joint coordinates, its twist their rates."""
        return self.keys[0].floats

    @property
    def moving(self) -> bool:
        """Whether it moves as is given: the rates of its twist are inputs."""
        return self.keys[0].joint.given

    @property
    def base_q(self) -> int:
        """The number of coordinates of a floating base, which is the index of the first other one in `q`."""
        return self.q_offset[1] if self.floating else 0

    @property
    def base_v(self) -> int:
        """The number of their rates, which is the index of the first rate in `v` with a torque."""
        return self.v_offset[-1] - self.n_joints

    @property
    def n_redundant(self) -> int:
        """The number of joint coordinates beside poses in the DAE form: of all joints but a floating base."""
        return self.q_offset[-1] - self.base_q

    @property
    def n_modes(self) -> int:
        return self.eta_offset[-1]

    @property
    def n_added(self) -> int:
        """The number of coordinates that elastic gears add."""
        return self.theta_offset[-1]

    @property
    def n_inner(self) -> int:
        """The number of coordinates behind those of the joints: rotors and modes."""
        return self.n_added + self.n_modes

    @property
    def eta_q(self) -> int:
        """The index of the first modal coordinate in `q`."""
        return self.nq - self.n_modes

    @property
    def eta_v(self) -> int:
        """The index of its rate in `v`."""
        return self.nv - self.n_modes

    def complete(self, given: np.ndarray, p: Any, rates: bool = False) -> np.ndarray | str:
        """All coordinates (nq,), or `rates` (nvz,), from all of them, those of the joints alone, or none.

        A floating base is at home and at rest where it is not stated; its quaternion is scaled to length one. Of the
        joints alone gears are without load, with the ratios in the parameters `p`. Returns what is wrong with them as
        a text, "<what is wrong>; <what is allowed>".
        """
        out = np.zeros(self.nvz) if rates else np.array(self.home)
        if len(given) == len(out):
            out[:] = given
        elif rates and len(given) == self.nv:
            out[: self.nv] = given
        elif len(given) in (0, count := self.n_joints if rates else self.n_redundant):
            first = self.base_v if rates else self.base_q
            joints = self.with_added(given, p) if len(given) and self.n_added else given
            out[first : first + len(joints)] = joints
        else:
            allowed = f"{len(out)} numbers, or the {count} of the joints alone"
            return f"has length {len(given)}; it must have {allowed}"
        return out if rates else self._checked(out)

    def _checked(self, q: np.ndarray) -> np.ndarray | str:
        """The coordinates with quaternions of length one; those of another length are refused as a text."""
        for part in self.curved:
            first = part.q.start + (part.joint.turn_at or 0)
            size = float(np.linalg.norm(q[first : first + 4]))
            if not abs(size - 1) <= SLACK:
                where = f"entries {first} to {first + 3} (w, x, y, z)"
                return f"has a quaternion of length {size:.6g}, {where}; it must have length 1"
        return self.unit(q)

    @cached_property
    def has_axis_forces(self) -> bool:
        """Whether springs, dampers, friction, stops or other elements act in any joint."""
        return any(key.has_axis_forces for key in self.keys)

    @cached_property
    def added_joints(self) -> list[int]:
        """The joint coordinate, as its number among those, of the axis of each added coordinate."""
        return [self.tau_offset[i] + axis for i, key in enumerate(self.keys) for axis in key.added_axes]

    @cached_property
    def effort_places(self) -> list[int]:
        """The coordinate, as an index in `v`, on which each torque acts: the joint's, or that of its rotor.

        The effort of a transmission acts on the joint, times its lever, and besides on an elastic gear.
        """
        return [self.base_v + k if k in self.elastic_travels else place for k, place in enumerate(self.held_places)]

    @cached_property
    def held_places(self) -> list[int]:
        """The coordinate, as an index in `v`, that each drive holds if its joint is to move on its gear alone.

        That which its gear adds, of its rotor or along a transmission; else the joint's.
        """
        out, first = [self.base_v + k for k in range(self.n_joints)], self.eta_v - self.n_added
        for k, joint in enumerate(self.added_joints):
            out[joint] = first + k
        return out

    @cached_property
    def prescribed(self) -> list[int]:
        """The joint coordinates, as their numbers, whose drives move as is given: their input is an acceleration.

        Of an elastic drive it is that of its rotor; :attr:`held_places` says where in `v`.
        """
        return [self.tau_offset[i] + axis for i, key in enumerate(self.keys) for axis in key.prescribed]

    @cached_property
    def braked(self) -> list[int]:
        """The joint coordinates, as their numbers, that have a brake; it acts at :attr:`held_places`."""
        return [self.tau_offset[i] + axis for i, key in enumerate(self.keys) for axis in key.brakes]

    @property
    def has_reactions(self) -> bool:
        """Whether some efforts follow from the motion: of axes or a base whose motion is given, and of brakes."""
        return bool(self.prescribed or self.braked or self.moving)

    @cached_property
    def elastic_travels(self) -> dict[int, int]:
        """The joint coordinates, as their numbers, that elastic gears of transmissions drive: the place of each gear's
        coordinate in `v`."""
        there = {self.tau_offset[i] + axis for i, key in enumerate(self.keys) for axis in key.elastic_travels}
        return {joint: place for joint, place in enumerate(self.held_places) if joint in there}

    def ratios(self, p: Any) -> list:
        """The ratio of each rotor's gear out of the parameters `p`, numbers or symbols; of transmissions 0."""
        axes = [(i, axis) for i, key in enumerate(self.keys) for axis in key.added_axes]
        places = [self.parameter_labels[i].get(f"drive_ratio_{axis + 1}") for i, axis in axes]
        stated = [1.0 if place is None else p[place] for place in places]
        return [0.0 if axis in self.keys[i].elastic_travels else x for (i, axis), x in zip(axes, stated, strict=True)]

    def with_added(self, q: Any, p: Any) -> np.ndarray:
        """Joint coordinates (n_redundant, ...) or rates (n_joints, ...), and the added ones that leave their gears
        without load."""
        q = np.asarray(q, float)
        shape = (self.n_added, *(1 for _ in q.shape[1:]))
        first = range(self.n_joints) if len(q) == self.n_joints else [k - self.base_q for k in self.axis_places]
        return np.concatenate([q, np.reshape(self.ratios(p), shape) * q[[first[k] for k in self.added_joints]]])

    def with_inner(self, joints: Any, p: Any) -> np.ndarray:
        """All coordinates or rates (nq,) out of those of the joints: gears without load, modes zero."""
        return np.append(self.with_added(joints, p), np.zeros(self.n_modes))

    def of_joints(self, x: Any, rates: bool = False) -> Any:
        """The entries (n_joints,) of the joint axes of all coordinates (nq,), or of all rates (nv,)."""
        first = self.base_v if rates else self.base_q
        if rates or self.n_redundant == self.n_joints:
            return x[first : first + self.n_joints]
        return [x[place] for place in self.axis_places]

    def place_in_q(self, rate: int) -> int:
        """Where in `q` the coordinate stands whose rate is entry ``rate`` of `v`, behind the twist of a floating base.

        Of a ball joint's rates those of its quaternion's vector, see :attr:`axis_places`.
        """
        axis = rate - self.base_v
        return self.axis_places[axis] if axis < self.n_joints else rate + self.nq - self.nv

    @cached_property
    def given_places(self) -> list[int]:
        """Where in `q` the coordinates stand whose inertia and force an integrator gives (n_given)."""
        return [self.place_in_q(rate) for rate in range(self.nv - self.n_given, self.nv)]

    def at_efforts(self, tau: Any, p: Any) -> np.ndarray:
        """Torques (n_tau,) where they act, of those at the joints: on rotors they are less by the ratio."""
        out = np.array(tau, float)
        out[self.added_joints] /= np.array([ratio or 1.0 for ratio in self.ratios(p)])
        return out

    @cached_property
    def travels(self) -> dict[int, Travel]:
        """The joint coordinates, as their numbers, whose drives have a transmission, and what it is."""
        pairs = enumerate(self.keys)
        return {self.tau_offset[i] + axis: travel for i, key in pairs for axis, travel in key.travels.items()}

    @cached_property
    def cylinders(self) -> list[int]:
        """The joint coordinates, as their numbers, that cylinders drive."""
        return [joint for joint, travel in self.travels.items() if travel.IS_LENGTH]

    def travel_numbers(self, p: Any) -> Iterator[tuple[int, int, Travel, list[Any]]]:
        """Of every transmission its link, its joint coordinate, what it is, and its numbers out of the parameters.

        They are numbers or symbols, as the parameters are.
        """
        for i, key in enumerate(self.keys):
            for axis, travel in key.travels.items():
                places = (self.parameter_labels[i][f"drive_{name}_{axis + 1}"] for name in travel.KEYS)
                yield i, self.tau_offset[i] + axis, travel, [p[place] for place in places]

    @property
    def travel_kinds(self) -> list[Travel]:
        """One transmission of each kind that there is."""
        there = {type(one) for one in self.travels.values()}
        return [one for one in {type(one): one for one in TRAVELS}.values() if type(one) in there]

    @property
    def slides(self) -> bool:
        """Whether any joint moves its link along an axis."""
        return any(key.slides for key in self.keys)

    @cached_property
    def n_given(self) -> int:
        """The number of coordinates, the last of q, whose inertia and force an integrator gives."""
        return self.nv - self.base_v if self.has_axis_forces else self.n_modes

    def coordinate_spans(self, i: int) -> dict[str | Law, slice]:
        """The slices of these coordinates that hold ``eta`` and, where axes have forces, ``q`` and ``theta`` of a link.

        ``below``: the slice of the entries below the diagonal of their inertia, if modes are coupled; ``between``: of
        those, behind them, that couple added coordinates and joints. By each law: the link's part of where it acts.
        """
        before, key = self.n_given - self.n_modes, self.keys[i]
        part = lambda first, offsets: slice(*(first + e for e in offsets[i : i + 2]))  # noqa: E731
        parts: dict[str | Law, slice] = {"eta": part(before, self.eta_offset)}
        if key.coupled:
            parts["below"] = part(self.n_given, self.below_offset)
        if key.has_axis_forces:
            parts["q"] = part(0, self.tau_offset)
        if key.added_axes:
            parts["theta"] = part(before - self.n_added, self.theta_offset)
            parts["between"] = part(self.n_given + self.below_offset[-1], self.theta_offset)
        for law in dict.fromkeys(one.law for one in key.laws):
            links = [acted.link for acted in self.laws[law]]
            parts[law] = slice(links.index(i), links.index(i) + links.count(i))
        return parts

    @cached_property
    def coupled(self) -> list[tuple[int, int]]:
        """Row and column, among these coordinates, of the entries of their inertia below the diagonal."""
        first = [self.coordinate_spans(i)["eta"].start for i in range(self.n)]
        modes = [(f + i, f + j) for f, key in zip(first, self.keys, strict=True) for i, j in key.coupled]
        first_added = self.n_given - self.n_inner
        return modes + [(first_added + k, joint) for k, joint in enumerate(self.added_joints)]

    @cached_property
    def springs(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Every spring and damper of these coordinates: on which it acts, whose motion it feels, its entry among
        ``n_inertia``. One between two coordinates is there twice."""
        pairs = [
            (row, column, k) for k, (i, j) in enumerate(self.coupled, self.n_given) for row, column in ((i, j), (j, i))
        ]
        table = np.array([*((k, k, k) for k in range(self.n_given)), *pairs], int).reshape(-1, 3)
        return table[:, 0], table[:, 1], table[:, 2]

    @property
    def n_inertia(self) -> int:
        """The number of entries of their inertia, stiffness or damping: the diagonal, then those below it."""
        return self.n_given + self.below_offset[-1] + self.n_added

    def modal_product(self, A: Any, x: Any) -> Any:
        """A symmetric matrix of these coordinates, by its entries (n_inertia, ...), times ``x`` (n_given, ...)."""
        out = A[: self.n_given] * x
        for k, (i, j) in enumerate(self.coupled, self.n_given):
            out[i] += A[k] * x[j]
            out[j] += A[k] * x[i]
        return out

    def split(self, q: Sequence, joint: str, modal: str) -> list[dict[str, list]]:
        """``[joint coordinates; rotors; modal coordinates]`` as one mapping per link.

        Of rates internal states follow, zero where they are left out.

        ``joint`` and ``modal`` are the names of their signals, ``joint`` one of ``ROTOR``.
        """
        m, es, ts = self.eta_q if joint == "q" else self.eta_v, self.eta_offset, self.theta_offset
        qs, t = self.q_offset if joint == "q" else self.v_offset, m - self.n_added
        links = [{joint: list(q[qs[i] : qs[i + 1]]), modal: list(q[m + es[i] : m + es[i + 1]])} for i in range(self.n)]
        for i, link in enumerate(links) if self.n_added else ():
            link[ADDED[joint]] = list(q[t + ts[i] : t + ts[i + 1]])
        if self.n_internal and joint in INTERNAL:
            z = q[self.nv :] if len(q) == self.nvz else [0.0] * self.n_internal
            for i, link in enumerate(links):
                link[INTERNAL[joint]] = list(z[self.z_offset[i] : self.z_offset[i + 1]])
        if self.n_held_states and joint == "qdot":
            z = q[self.held_states] if len(q) == self.nvz else [0.0] * self.n_held_states
            for i, link in enumerate(links):
                link["memory"] = list(z[self.memory_offset[i] : self.memory_offset[i + 1]])
        return links

    def join(self, links: Sequence[Mapping[str, list]], joint: str, modal: str) -> list:
        """The inverse of :meth:`split`."""
        parts = [
            joint,
            *([ADDED[joint]] if self.n_added else []),
            modal,
            *([INTERNAL[joint]] if joint in INTERNAL else []),
        ]  # internal states of forces between frames and of inputs are left out
        return [x for part in parts for link in links for x in link.get(part, ())]
