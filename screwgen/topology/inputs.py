"""What `tau` holds: the kinds of input of a robot, with the places of their entries."""

from __future__ import annotations

from functools import cached_property
from itertools import accumulate, pairwise

import numpy as np

from ..arguments import Parameters
from ..spec.forces import FORCE_INPUTS
from ..spec.input import Input
from ..spec.inputs import TORQUES, inputs
from ..spec.robot import Robot
from ..spec.tendons import TENSIONS
from .forces import PlacedForce, added_numbers


class ChosenInputs:
    """What :class:`.chain.Chain` has for its inputs; the attributes, and what raises here, are its own."""

    robot: Robot
    forces: tuple[PlacedForce, ...]

    @property
    def n_joints(self) -> int:
        """The number of joint coordinates."""
        raise NotImplementedError

    @cached_property
    def prescribed(self) -> list[int]:
        """The joint coordinates whose motion is given."""
        raise NotImplementedError

    @cached_property
    def parameters(self) -> Parameters:
        """The robot's parameters."""
        raise NotImplementedError

    @property
    def n_tau(self) -> int:
        """The number of inputs, the entries of ``tau``: a torque per axis, then those of other kinds."""
        return max(own.stop for own in self.inputs.values())

    @cached_property
    def inputs(self) -> dict[Input, slice]:
        """The kinds of input, torques of axes first, each with the slice of its entries in ``tau``."""
        rows = inputs(self.robot)
        ends = list(accumulate((len(row.names(self.robot)) for row in rows), initial=0))
        return {row: slice(*span) for row, span in zip(rows, pairwise(ends), strict=True)}

    @property
    def other_inputs(self) -> dict[Input, slice]:
        """The same without torques of axes."""
        return {row: own for row, own in self.inputs.items() if row is not TORQUES}

    @cached_property
    def chosen_inputs(self) -> list[int]:
        """The entries of ``tau`` that a controller chooses: no accelerations of axes, and of kinds that say so."""
        found = (k for row, own in self.inputs.items() if row.chosen for k in range(own.start, own.stop))
        return [k for k in found if k not in self.prescribed]

    @property
    def given_inputs(self) -> list[int]:
        """The other entries, which are given to it."""
        return [k for k in range(self.n_tau) if k not in self.chosen_inputs]

    @property
    def falls(self) -> bool:
        """Whether an input changes the acceleration of free fall."""
        return any(row.free_fall is not None for row in self.inputs)

    @property
    def chooses_forces(self) -> bool:
        """Whether inputs act on forces between frames, whose wrenches, energy and reports then depend on ``tau``."""
        return any(force.shape.inputs for force in self.forces)

    @property
    def inputs_load_links(self) -> bool:
        """Whether inputs change joint wrenches at held accelerations."""
        return self.falls or self.chooses_forces

    @property
    def n_tensions(self) -> int:
        """The number of tensions."""
        return len(TENSIONS.names(self.robot))

    def with_idle_inputs(self, torques: np.ndarray) -> np.ndarray:
        """The inputs (n_tau,) of torques (n_joints,) alone: all others are zero, so tendons are slack."""
        return np.append(torques, np.zeros(self.n_tau - self.n_joints))

    @cached_property
    def tensions(self) -> list[list[int]]:
        """For every link the tension of each piece of a tendon along it, as its number among all tensions."""
        return TENSIONS.of_links(self)

    def fallen(self, p: np.ndarray, tau: np.ndarray) -> np.ndarray:
        """The parameters of the arm as inputs (n_tau,) make it: gravity where they change free fall, numbers of forces
        to which they are added. Raises UsageError where a force has another input that is not zero."""
        out = np.array(p, float)
        for row, own in self.inputs.items():
            out[:3] += [0.0] * 3 if row.free_fall is None else [float(x) for x in row.free_fall(tau[own].tolist())]
        for name, value in added_numbers(self.forces, tau[self.inputs.get(FORCE_INPUTS, slice(0))]):
            out[self.parameters.names.index(name)] += value
        return out
