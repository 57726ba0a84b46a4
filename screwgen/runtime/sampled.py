"""Functions of a robot at the samples of many scenarios at once, in C over the lanes of vector registers.

An example: where the tip of a robot was at a thousand samples of each of 256 scenarios. Its kinematics are compiled
without the dynamics, when they are first asked for.
"""

from __future__ import annotations

import ctypes
from functools import partial
from math import prod
from typing import NamedTuple

import numpy as np

from ..algorithms.robot_function import RobotFunction, shape
from ..algorithms.robot_functions import BY_NAME, offered, reported
from ..backends.c.sampled import content
from ..robot_model import RobotModel
from ..topology.chain import Chain
from .asked import digest
from .batch import FLAGS
from .lean import RuntimeProject
from .library import load
from .memory import pointer

SOURCES = ("parameters.c", "real.c")
TIP = "tip_position"


class OfStates(NamedTuple):
    """A function of coordinates and rates alone, and those of its results that are wanted."""

    row: RobotFunction
    wanted: tuple[str, ...]


def sampled(chain: Chain, name: str) -> OfStates | None:
    """What is sampled under a name: a function, or the tip's position; None where it needs more than the state."""
    if name == TIP:
        return OfStates(BY_NAME["tip_pose"], ("position",))
    row = next((row for row in offered(chain) if row.name == name), None)
    return OfStates(row, tuple(row.results)) if row and set(row.names) <= {"q", "v"} else None


class _Samples(ctypes.Structure):
    """``shim_samples`` of the generated C."""

    _fields_ = (
        *((name, ctypes.c_int) for name in ("count", "samples", "own_constants")),
        *((name, ctypes.c_void_p) for name in ("q", "v", "found")),
    )


class SampledFunctions:
    """Functions of coordinates and rates alone in a shared library."""

    def __init__(self, model: RobotModel, names: tuple[str, ...]):
        self.model = model
        flags = (*model.compiler_flags, *FLAGS[1:])
        self.library = load(partial(_files, model, names), flags, asked=digest("sampled", model.robot, names))

    def __call__(self, name: str, p: np.ndarray, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, ...]:
        """The results (batch, samples, …) at `q` (batch, samples, nq), `v` (.., nv), the scenarios side by side.

        ``p`` (batch or 1, n): the parameters. What is not finite or cannot be found is not a number.
        """
        function = sampled(self.model.chain, name)
        assert function, name
        row, wanted = function
        shapes = [shape(row.results[of], self.model.chain) for of in wanted]
        sizes = [prod(size) for size in shapes]
        (count, samples, _), constants = q.shape, self._constants(p)
        found = np.empty((samples, sum(sizes), count))
        q, v = (np.ascontiguousarray(x.transpose(1, 2, 0), float) for x in (q, v if "v" in row.names else v[..., :0]))
        given = _Samples(count, samples, int(len(p) > 1), *map(pointer, (q, v, found)))
        if "v" not in row.names:
            given.v = None
        getattr(self.library, f"shim_sampled_{row.name}")(pointer(constants), ctypes.byref(given))
        parts = np.split(found.transpose(2, 0, 1), np.cumsum(sizes)[:-1], axis=2)
        return tuple(part.reshape(count, samples, *size) for part, size in zip(parts, shapes, strict=True))

    def _constants(self, p: np.ndarray) -> np.ndarray:
        """The constants of robots with the parameters ``p`` (robots, n), as bytes (robots, size)."""
        p, status = np.ascontiguousarray(p, float), np.zeros(len(p), np.int32)
        out = np.zeros((len(p), self.library.shim_constants_size()), np.uint8)
        self.library.shim_prepare(pointer(p), len(p), pointer(out), pointer(status))
        return out


def library_of(model: RobotModel, name: str) -> SampledFunctions:
    """The library that has a function, compiled when it is first asked for and kept by the model.

    What runs report stands in one, a sensor in one of its own.
    """
    told = [TIP, *(row.name for row in reported(model.chain) if sampled(model.chain, row.name))]
    names = tuple(told) if name in told else (name,)
    return model.once(("sampled", *names), lambda: SampledFunctions(model, names))


class _SampledProject(RuntimeProject):
    """The constants that all these functions read; one project of a model writes the headers for all of them."""

    def __init__(self, model: RobotModel):
        found = (sampled(model.chain, row.name) for row in offered(model.chain))
        self.further = tuple(a for one in found if one for a in one.row.algorithms)
        super().__init__(model.chain, model.version)


def _files(model: RobotModel, names: tuple[str, ...]) -> dict[str, str]:
    """The sources of the library."""
    project = model.once("sampled project", lambda: _SampledProject(model))
    used = {file: template for file, template in project.library.items() if file.endswith((".h", *SOURCES))}
    used = {file: template for file, template in used.items() if template != "reference.h"}
    used |= {f"{model.robot.name}_lanes.h": "lanes.h"}
    found = [one for name in names if (one := sampled(model.chain, name))]
    own = project.text("sampled.c", sampled=[content(*one, model.chain) for one in found])
    return {file: project.text(template) for file, template in used.items()} | {"sampled.c": own}
