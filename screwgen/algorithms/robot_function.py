"""A function of a robot as every back end knows it: its inputs, its results and the lines that compute them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..topology.chain import Chain
from . import fused
from .gauges import strain_names
from .schedule import Algorithm
from .signals import Signal

OUTPUTS, SENSORS = "outputs", "sensors"
"""The files of the C: what runs, rollouts and mock-up units report at every sample, and what only who asks is told."""


@dataclass(frozen=True)
class RobotFunction:
    """A function of a robot, of ``inputs``, names that blanks separate, see :func:`.fused.stated`.

    ``results``: name -> shape, unit, frame and meaning; ``program`` makes it as one program, whose ``body`` runs on
    `Functions`; ``algorithms``: those that the body runs; ``offered``: of which robots there is one; ``c_file``: which
    file of the C has it, if any, see ``OUTPUTS``; ``sensor``: whether a sensor reads it, which mock-up units and linear
    models have as outputs where they are asked for; ``about``: a sentence.
    """

    name: str
    inputs: str
    results: Mapping[str, Signal]
    program: fused.Maker
    algorithms: tuple[Algorithm, ...]
    about: str
    offered: Callable[[Chain], bool] = lambda chain: True
    c_file: str = ""
    sensor: bool = False

    @property
    def names(self) -> list[str]:
        """The names of the inputs, those left out that only robots have whose inputs act on forces between frames."""
        return [name for name in self.inputs.split() if name[0] != "("]

    def of(self, chain: Chain) -> RobotFunction:
        """The function as a robot has it: with all its inputs."""
        inputs = " ".join(fused.stated(chain, self.inputs))
        return self if inputs == self.inputs else replace(self, inputs=inputs)


def shape(signal: Signal, chain: Chain) -> tuple[int, ...]:
    """The shape of a result for a robot."""
    sizes = {"NQ": chain.nq, "NV": chain.nv, "NVZ": chain.nvz, "NTAU": chain.n_tau, "NAXES": chain.n_joints}
    sizes |= {"NLINKS": chain.n, "NTENDONS": chain.n_tensions, "NCYLINDERS": len(chain.cylinders)}
    sizes |= {"NQUANTITIES": len(chain.force_quantities)}
    sizes |= {"NMARKERS": len(chain.markers), "NSTRAINS": len(strain_names(chain))}
    return tuple(sizes[size] if isinstance(size, str) else size for size in signal.shape)


def is_matrix(signal: Signal) -> bool:
    """Whether a result is one matrix, of the robot; others with two axes have a row per link or marker."""
    return len(signal.shape) == 2 and not isinstance(signal.shape[0], str)


def results(function: RobotFunction, chain: Chain, values: Sequence[float] | np.ndarray) -> Any:
    """The results from all their entries: arrays, numbers, a tuple where they are several."""
    shapes = [shape(of, chain) for of in function.results.values()]
    parts = np.split(np.asarray(values), np.cumsum([math.prod(size) for size in shapes])[:-1])
    out = [part.reshape(size) if size else part.item() for part, size in zip(parts, shapes, strict=True)]
    return tuple(out) if len(out) > 1 else out[0]


def entries(function: RobotFunction, chain: Chain) -> int:
    """The number of entries of all results."""
    return sum(math.prod(shape(of, chain)) for of in function.results.values())
