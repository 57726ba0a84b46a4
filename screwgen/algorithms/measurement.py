"""What a filter is told of a sensor: the contract of a measurement, and the program that compares it with a state.

An example: a sensor says how far a marker is from a beacon. Its row states that it measures one number, in m, and how
this follows from the coordinates. From the row come the innovation, what was measured less what the state says, and
its derivatives along v, both traced; the keyword of an update and that of a noise model; members of structs in C. The
filters in Python and in C loop over rows and know no sensor by name. A row that is ``told`` is a function of the robot
too, which every back end, mock-up units and linear models have. `measurements` has the rows, `measurement_names` says
which a caller means.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from ..errors import UsageError
from ..ir.derivative import columns, tangents
from ..ir.program import Node, Program, Value
from ..joints.exponential import angular_velocity, rotated
from ..spec.sensor import Sensor
from ..topology.chain import Chain
from . import felt
from . import matrices as mx
from .functions import PLACES, Functions
from .fused import fuse, inputs
from .marker_functions import MEASURED
from .robot_function import SENSORS
from .schedule import Algorithm

Labels = Callable[[Chain], Sequence[str]]
Columns = list[list[Value]]
SCALE = "is 0: such a sensor says nothing; state by what its readings are multiplied"


def every_robot(chain: Chain) -> bool:
    """Whether a robot has what most of them have."""
    return True


@dataclass(frozen=True)
class SensorNumber:
    """Numbers of a sensor that may be changed between calls: members of the filter in C, keywords of a noise model."""

    name: str
    size: Callable[[Chain], int]
    about: str
    """Unit and meaning."""
    start: float | tuple[float, ...] | Callable[[Chain, Sequence[Value]], Sequence[Value]] = 0.0
    """What they are unless they are stated: one number for all, or those of one sensor, which all others have too.
    Or how they follow from the robot's parameters, and cannot be stated."""
    zero: str = ""
    """Where they must not be 0 of an entry that is measured: what is said of it."""
    role: str = ""
    """The argument of the row's value that they are, the name itself by default."""

    @property
    def stated(self) -> bool:
        """Whether the caller may state them."""
        return not callable(self.start)

    @property
    def keyword(self) -> str:
        """The argument of the row's value that they are."""
        return self.role or self.name

    @property
    def own_starts(self) -> tuple[float, ...]:
        """What those of one sensor, or all of them, are unless they are stated."""
        assert not callable(self.start)
        return self.start if isinstance(self.start, tuple) else (self.start,)

    def starts(self, chain: Chain) -> list[float]:
        """What each of them is unless it is stated."""
        size, own = self.size(chain), self.own_starts
        if size % len(own):
            raise UsageError(f"{self.name}: starts as {len(own)} numbers, and there are {size}; start one, or each")
        return [float(x) for x in own] * (size // len(own))


@dataclass(frozen=True)
class AtMarkers:
    """The labels of a sensor that sits at every marker: of its entries at one, such as ``("x", "y")``; () for one."""

    parts: tuple[str, ...] = ()

    def __call__(self, chain: Chain) -> list[str]:
        return [f"{m.name}.{part}" if part else m.name for m in chain.markers for part in self.parts or ("",)]


class Told(NamedTuple):
    """How a sensor is a function of the robot besides, by its name, with its numbers as they start."""

    result: str
    """The name of its result, which no other function has."""
    meaning: str
    """What this is, as ``angular velocity of every marker``."""
    about: str
    """A sentence on the function."""
    frame: str = "-"
    """The frame of its entries."""
    shape: tuple[int | str, ...] = ()
    """Of the result, of a sensor that does not sit at markers; sizes as in `robot_function.shape`."""
    c_file: str = SENSORS
    """Which file of the C has it, see :data:`.robot_function.SENSORS`."""
    offered: Callable[[Chain], bool] | None = None
    """Which robots have the function, if others than have the measurement."""


@dataclass(frozen=True)
class Measurement(Sensor):
    """A row: what a sensor measures in a state. ``value(f, **given)`` is traced, over `Functions` of the robot.

    ``given`` are the ``inputs``, out of ``q v vdot tau w_ext``, and the sensor's ``numbers``; where ``vdot`` is among
    them it is that of the forward dynamics. Torques and wrenches are as a step holds them, and known: where a limit
    makes them change with the state, a row that reads them itself has no derivative of that. Entries are compared by
    their difference, and each is judged by itself.
    """

    name: str
    """An identifier: of the keyword, of members in C."""
    inputs: str
    value: Callable[..., Sequence[Value]]
    labels: Labels
    """What its entries are, a text for each; :class:`AtMarkers` of a sensor that sits at every marker."""
    unit: str
    about: str
    """What is measured, the end of a sentence."""
    algorithms: tuple[Algorithm, ...] = (PLACES, *MEASURED)
    """Those that the value runs."""
    offered: Callable[[Chain], bool] = every_robot
    """Which robots have it."""
    missing: str = ""
    """What a robot has that does not have it, such as ``a fixed base``."""
    numbers: tuple[SensorNumber, ...] = ()
    count: str = ""
    """The constant of the C that says how many entries there are, if there is one."""
    gated: bool = False
    """Whether it has a gate of its own."""
    told: Told | None = None
    """What it is as a function of the robot, if it is one."""
    noise: float = 0.0
    """The standard deviation of every entry unless one states it; 0: one must."""

    group = 1
    """How many entries are judged as one."""
    readings = 1
    """How many numbers a sensor gives for each group."""

    def size(self, chain: Chain) -> int:
        """The number of entries."""
        return len(self.labels(chain))

    def n_values(self, chain: Chain) -> int:
        """How many numbers are measured."""
        return self.size(chain) // self.group * self.readings

    def innovation(self, measured: Sequence[Value], expected: Sequence[Value]) -> list[Value]:
        """What was measured less what the state says, entry by entry."""
        return [z - y for z, y in zip(measured, expected, strict=True)]

    def slopes(self, f: Functions, given: Mapping[str, Sequence[Value]], expected: Sequence[Value]) -> list[Columns]:
        """The derivatives of entries with changes of the posture, with v and with vdot, column by column."""
        of = lambda name: columns(expected, given[name]) if name in given else []  # noqa: E731
        return [along_changes(f, given["q"], expected) if "q" in given else [], of("v"), of("vdot")]

    @property
    def calibrated(self) -> Measurement:
        """The same sensor with a scale and an offset of every entry: it reads ``scale * value + offset``."""

        def value(f: Functions, scale: Sequence[Value], offset: Sequence[Value], **given: Any) -> list[Value]:
            return [s * y + o for s, y, o in zip(scale, self.value(f, **given), offset, strict=True)]

        scale = SensorNumber(f"{self.name}_scale", self.size, "factor of readings", 1.0, SCALE, role="scale")
        offset = SensorNumber(f"{self.name}_offset", self.size, f"{self.unit}: added to readings", role="offset")
        return replace(self, value=value, numbers=(*self.numbers, scale, offset), noise=0.0)


@dataclass(frozen=True)
class Attitude(Measurement):
    """A row of attitudes: quaternions of either sign are measured, three entries for each, which are judged as one.

    Its value has the quaternions, or rotations row by row if they are ``matrices``. An innovation is twice the vector
    part of the quaternion that leads from the attitude of the state to the measured one, the turn θ less θ³/24.
    """

    turning: Callable[..., Sequence[Value]] = lambda f, q, v: ()
    """The angular velocities in the axes of what turns, ``(f, q, v)``, linear in v."""
    matrices: bool = False

    group, readings = 3, 4

    def innovation(self, measured: Sequence[Value], expected: Sequence[Value]) -> list[Value]:
        between = turn_of_matrix if self.matrices else turn_of_quaternion
        size = 9 if self.matrices else 4
        pairs = zip(_split(measured, 4), _split(expected, size), strict=True)
        return [x for Z, y in pairs for x in between(y, Z)]

    def slopes(self, f: Functions, given: Mapping[str, Sequence[Value]], expected: Sequence[Value]) -> list[Columns]:
        units = np.eye(f.chain.nv).tolist()
        return [[list(self.turning(f, given["q"], unit)) for unit in units], [], []]

    @property
    def calibrated(self) -> Measurement:
        raise UsageError(f"{self.name}: an attitude has neither scale nor offset; leave 'calibrated' out")


@dataclass(frozen=True)
class CyclicAngle(Measurement):
    """A row of angles that begin again after a whole turn, as those of `atan2`: innovations have no whole turns."""

    def innovation(self, measured: Sequence[Value], expected: Sequence[Value]) -> list[Value]:
        return [without_turns(x) for x in super().innovation(measured, expected)]

    @property
    def calibrated(self) -> Measurement:
        raise UsageError(f"{self.name}: an angle of whole turns has no scale; leave 'calibrated' out")


def _split(values: Sequence[Value], size: int) -> list[np.ndarray]:
    return [mx.array(values[k : k + size]) for k in range(0, len(values), size)]


def turn_of_quaternion(Q: np.ndarray, Z: np.ndarray) -> list[Value]:
    """Twice the vector part of what leads from the unit quaternion Q to Z, of any length and either sign."""
    Z = Z / root(mx.dot(Z, Z))
    sign = 1.0 - 2.0 * Z[0].tracer.call("on", -mx.dot(Q, Z))
    return [sign * x for x in angular_velocity(Q, Z)]


def turn_of_matrix(R: np.ndarray, Z: np.ndarray) -> list[Value]:
    """The same from a rotation (9,), row by row."""
    E = mx.multiply(R.reshape(3, 3).T, np.array([rotated(Z, axis) for axis in np.eye(3)]).T)
    between = _along_quaternion(E)
    size = 0.5 * root(mx.dot(between, between)) * (1.0 - 2.0 * between[0].tracer.call("on", -between[0]))
    return [x / size for x in between[1:]]


def _along_quaternion(E: np.ndarray) -> np.ndarray:
    """What is parallel to the quaternion Q of a rotation: the column of ``4 Q Qᵀ`` with the largest diagonal entry.

    At every turn one of the columns vanishes, the first at half a turn.
    """
    trace = E[0, 0] + E[1, 1] + E[2, 2]
    between = np.array([E[k, j] - E[j, k] for j, k in ((1, 2), (2, 0), (0, 1))])
    sizes, columns = [1.0 + trace], [np.array([1.0 + trace, *between])]
    for k in range(3):
        sizes.append(1.0 + 2.0 * E[k, k] - trace)
        columns.append(np.array([between[k], *(sizes[-1] if j == k else E[j, k] + E[k, j] for j in range(3))]))
    largest, size = columns[0], sizes[0]
    for column, own in zip(columns[1:], sizes[1:], strict=True):
        here = trace.tracer.call("on", own - size)
        largest, size = (1.0 - here) * largest + here * column, (1.0 - here) * size + here * own
    return largest


def root(x: Value) -> Value:
    """The square root of a value that is traced."""
    return x.tracer.call("sqrt", x) if isinstance(x, Node) else float(np.sqrt(x))


def atan2(y: Value, x: Value) -> Value:
    """The angle from x to the point (x, y), rad, of values that are traced; at the origin 0, without a derivative."""
    if isinstance(y, Node) or isinstance(x, Node):
        tracer = y.tracer if isinstance(y, Node) else x.tracer  # type: ignore[union-attr]
        return tracer.call("atan2", y, x)
    return math.atan2(y, x)


def without_turns(x: Value) -> Value:
    """An angle, rad, from -pi to pi, of a value that is traced."""
    return (
        atan2(x.tracer.call("sin", x), x.tracer.call("cos", x)) if isinstance(x, Node) else math.remainder(x, math.tau)
    )


def along_changes(f: Functions, q: Sequence[Value], values: Sequence[Value]) -> Columns:
    """The derivatives of values with changes of the posture, by which joints move it (nv), column by column."""
    chain = f.chain
    flat = columns(values, [q[k] for k in chain.flat_q])
    out = dict(zip(chain.flat_v.tolist(), flat, strict=True))
    for part in chain.curved:
        for k in range(part.v.start, part.v.stop):
            rates = f.coordinate_rates(q, [float(i == k) for i in range(chain.nv)])[part.q]
            change = {x: r for x, r in zip(q[part.q], rates, strict=True) if isinstance(x, Node)}
            out[k] = tangents(values, change)
    return [out[k] for k in range(chain.nv)]


# ------------------------------------------------------------------------------ the program


class Comparison(NamedTuple):
    """How a measurement is compared with a state."""

    program: Program
    """``rest`` (n): the innovation. ``rows``: its derivatives with changes [δq; δv] of the state, negative, of each
    entry those in its span. ``by_vdot`` (n, nvz), row by row: those with the accelerations, if these are among the
    inputs."""
    spans: list[tuple[int, int]]
    """Of every entry where its derivatives begin in [δq; δv; …], and how many there are; others are zero."""


class Further(NamedTuple):
    """Derivatives of what is expected with entries of a filter's state behind [q; v]."""

    inputs: Mapping[str, int]
    """The lengths of the inputs that they read besides."""
    columns: Callable[[Functions, Mapping[str, Sequence[Value]], Sequence[Value]], Columns]
    """Of functions, inputs and what is expected, a column for each entry."""


NOTHING = Further({}, lambda f, x, expected: [])


def comparison(row: Measurement, chain: Chain, constants: str = "parameters", further: Further = NOTHING) -> Comparison:
    """Of a row that has entries, for a robot. ``constants`` as :func:`.fused.fuse` has them."""
    given = inputs(chain, felt.reads(row, chain)) | {number.keyword: number.size(chain) for number in row.numbers}
    spans: list[tuple[int, int]] = []

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> dict[str, list[Value]]:
        own = {name: x[name] for name in given}
        expected = felt.expected(row, f, own)
        by_q, by_v, by_vdot = row.slopes(f, own, expected)
        n = row.size(chain)
        still = [[0.0] * n for _ in range(chain.nvz)]
        more = further.columns(f, x, expected)
        rows = list(zip(*(by_q or still[: chain.nv]), *(by_v or still), *more, strict=True))
        spans.extend((0, chain.n_changes + len(more)) if by_vdot else _span(entries) for entries in rows)
        inside = [v for (first, size), row in zip(spans, rows, strict=True) for v in row[first : first + size]]
        out = {"rest": row.innovation(x["measured"], expected), "rows": inside}
        return out | ({"by_vdot": [v for row in zip(*by_vdot, strict=True) for v in row]} if by_vdot else {})

    sizes = given | {"measured": row.n_values(chain), **further.inputs}
    return Comparison(fuse(chain, row.name, sizes, body, constants, algorithms=row.algorithms), spans)


def _span(entries: Sequence[Value]) -> tuple[int, int]:
    """Where the entries are that are not always zero, and how many from the first to the last."""
    there = [k for k, x in enumerate(entries) if isinstance(x, Node) or x != 0.0]
    return (there[0], there[-1] + 1 - there[0]) if there else (0, 0)
