"""The coordinates on which laws of single coordinates act, and the internal states that such laws have."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from itertools import accumulate
from typing import Any, NamedTuple

import numpy as np

from ..elements import FRICTION, STOP, HeldLaw, Law
from ..spec.link_class import LinkClass
from .held_laws import reads_motion
from .joint_coordinates import JointCoordinates


class LawPlace(NamedTuple):
    """Where a law acts: the link, the coordinate as its number among the last ``n_given``, the side there.

    ``axis``: the number of the axis that an elastic gear joins to this coordinate, of a law that depends on it.
    """

    link: int
    coordinate: int
    side: int
    axis: int | None = None


class LawCoordinates(JointCoordinates):
    """The joints and rotors of links of given classes, with the laws that act on them."""

    def __init__(self, keys: Sequence[LinkClass]):
        super().__init__(keys)
        offsets = lambda size: list(accumulate(map(size, self.keys), initial=0))  # noqa: E731
        self.theta_offset, self.z_offset = offsets(lambda k: len(k.added_axes)), offsets(lambda k: len(k.internal))
        self.memory_offset = offsets(lambda k: len(k.remembering))

    @cached_property
    def laws(self) -> dict[Law, list[LawPlace]]:
        """The laws of all joints, each with the coordinates on which it acts, link by link."""
        found: dict[Law, list[LawPlace]] = {FRICTION: [], STOP: []}
        places = {"q": 0, "theta": self.tau_offset[-1]}
        offsets = {"q": self.tau_offset, "theta": self.theta_offset}
        for i, key in enumerate(self.keys):
            for law, part, place, side, _ in key.laws:
                axis = self.tau_offset[i] + key.added_axes[place] if law.beside else None
                found.setdefault(law, []).append(LawPlace(i, places[part] + offsets[part][i] + place, side, axis))
        return {law: acted for law, acted in found.items() if acted}

    def acted(self, law: Law) -> list[LawPlace]:
        """Where a law acts, nowhere if it is not among them."""
        return self.laws.get(law, [])

    @cached_property
    def holds(self) -> bool:
        """Whether steps hold something else of the inputs than they are given: there are held laws."""
        return any(self.laws_of_inputs)

    @cached_property
    def holds_by_motion(self) -> bool:
        """Whether what they hold depends on the state besides."""
        return any(reads_motion(law) for laws in self.laws_of_inputs for law in laws)

    @cached_property
    def laws_of_inputs(self) -> list[list[type[HeldLaw]]]:
        """For each torque the laws of what a step holds of it, in the order in which they act."""
        axes = ((key, axis) for key in self.keys for axis in range(key.torques))
        return [[one.kind for one in key.held_laws if one.axis == axis] for key, axis in axes]

    @cached_property
    def internal(self) -> dict[Law, list[int]]:
        """The laws with internal states, of first order: where in `v` these stand, one where each law acts."""
        own = [one.law for key in self.keys for one in key.internal]
        return {law: [k for k, other in enumerate(own, self.nv) if other == law] for law in dict.fromkeys(own)}

    @property
    def n_internal(self) -> int:
        """The number of internal states: those of laws, then those of forces between frames and of inputs."""
        return self.z_offset[-1] + self.n_force_states

    @property
    def n_force_states(self) -> int:
        """The number of internal states of forces between frames, then of held laws, which follow no acceleration."""
        return self.n_held_states

    @property
    def n_held_states(self) -> int:
        """The number of internal states of held laws."""
        return self.memory_offset[-1]

    @property
    def force_states(self) -> slice:
        """Where in `v` these stand: behind those of laws."""
        return slice(self.nv + self.z_offset[-1], self.nvz)

    @property
    def held_states(self) -> slice:
        """Where in `v` those of held laws stand, the last."""
        return slice(self.nvz - self.n_held_states, self.nvz)

    @property
    def nvz(self) -> int:
        """The length of `v`: the rates of the coordinates, then the internal states."""
        return self.nv + self.n_internal

    @property
    def n_changes(self) -> int:
        """The number of changes [δ; δv] of a state."""
        return self.nv + self.nvz

    def with_internal(self, v: Any) -> Any:
        """The entries of `v` (nvz,) where those of coordinates alone are given (nv,): internal states are zero."""
        if not self.n_internal or v is None or np.shape(v) != (self.nv,):
            return v
        return np.append(np.asarray(v, float), np.zeros(self.n_internal))
