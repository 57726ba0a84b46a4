"""Static shapes: rows of a log in which the robot is at rest under its inputs, beside the rests of the model.

Joints that a column measures are held where it says, unless a column drives them or a spring carries them.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.columns import UNITS, Columns
from ..studies.equilibrium import rest_beside, rest_of
from ..studies.no_equilibrium import NoEquilibriumError
from ..studies.stiffness import stiffness
from .identification import Explained
from .logs import Log
from .problem import STEP, MeasuredCases, MotionMethod, Problem
from .signals import SensorSignal, Signals
from .unknowns import Unknowns, input_numbers, parameter_rows, sensor_numbers

POSITIONS = ("marker_position@", "point_position@")


@dataclass(frozen=True, eq=False)
class StaticShapes:
    """The shapes of a log: each is a case of one sample, at rest, so that nothing of its start is free."""

    model: RobotModel
    log: Log
    columns: Columns
    signals: Signals
    near_by: dict[int, np.ndarray] = field(default_factory=dict)
    """By case a rest (nq,) near which the next one is sought."""

    states = np.zeros(0, int)

    @cached_property
    def held(self) -> dict[str, int]:
        """The coordinates of joints that are held where a sensor says, with its place."""
        joints = self.model.n_joints
        names = self.model.chain.axis_names
        driven = {self.model.tau_names.index(str(column.drives)) for column in self.columns.inputs}
        free = [k in driven or spring > 0 for k, spring in enumerate(stiffness(self.model)[:joints])]
        measured = {column.measures: k for k, column in enumerate(self.columns.sensors)}
        return {name: measured[name] for name, x in zip(names, free, strict=True) if name in measured and not x}

    @cached_property
    def chosen(self) -> list[int]:
        """The sensors that are compared: those that say where joints are held are not."""
        return [k for k in range(len(self.columns.sensors)) if k not in self.held.values()]

    @property
    def names(self) -> list[str]:
        return [self.columns.sensors[k].name for k in self.chosen]

    @cached_property
    def compared(self) -> np.ndarray:
        return np.column_stack([self.log.columns[name] for name in self.names])[:, None]

    @property
    def stated(self) -> np.ndarray:
        return np.array([self.columns.sensors[k].noise or np.nan for k in self.chosen])

    @cached_property
    def quantities(self) -> tuple[str, ...]:
        """Of each sensor what it is one of: coordinates of points count together."""
        return tuple(_quantity(self.signals.signals[k]) for k in self.chosen)

    @cached_property
    def spread(self) -> np.ndarray:
        """(sensors,): how much readings vary, or how large they are if they do not; those of a quantity weigh alike."""
        of, out = np.array(self.quantities), np.ones(len(self.quantities))
        for name in set(self.quantities):
            own = self.compared[:, 0, of == name]
            out[of == name] = np.sqrt(np.mean(np.nanvar(own, axis=0))) or np.nanmax(np.abs(own)) or 1.0
        return out

    @property
    def step(self) -> float:
        return self.log.step

    @property
    def posture(self) -> np.ndarray:
        return self.near_by[min(self.near_by)]

    def near(self, other: MeasuredCases) -> bool:
        """Whether joints are held where those of another group are."""
        return all(np.array_equal(self._given(k), other._given(k)) for k in range(len(self.log)))  # type: ignore[attr-defined]

    def _given(self, case: int) -> np.ndarray:
        """The coordinates (nq,) of a case with held joints in place, others as they are at home."""
        q = np.array(self.model.chain.home, float)
        for name, k in self.held.items():
            column = self.columns.sensors[k]
            at = (self.log.columns[column.name][case] - column.offset) / column.scale
            if np.isnan(at):
                said = f"row {case + 1}: {column.name} says where a joint is held and has no reading"
                raise UsageError(f"{self.log.name}: {said}; leave the row out")
            q[self.model.q_names.index(name)] = at * UNITS[column.unit]
        return q

    def rest(self, case: int, p: np.ndarray, tau: np.ndarray) -> tuple:
        """What :func:`..studies.equilibrium.rest_of` finds of a case; raises NoEquilibriumError."""
        near = self.near_by.get(case, self._given(case))
        found = rest_of(self.model, near, tau, None, tuple(self.held), p)
        self.near_by[case] = found[1].q
        return found

    def beside(self, case: int, found: tuple, p: np.ndarray, tau: np.ndarray) -> np.ndarray:
        """The coordinates (nq,) at rest of a case whose numbers are a step of differences off those of a rest found."""
        if self.model.chain.n_added:
            return np.asarray(rest_of(self.model, found[1].q, tau, None, tuple(self.held), p)[1].q)
        statics, b, held, wanted, _ = found
        return rest_beside(statics, b, held, wanted, tau, p)

    def loads(self, problem: Problem, window: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Parameters (lanes, n) and inputs (lanes, n_tau) of lanes of cases, with numbers (lanes, k)."""
        tau = np.zeros((len(window), self.model.n_tau))
        for column in self.columns.inputs:
            gain, bias = input_numbers(problem.unknowns, column, values)
            own = self.log.columns[column.name][window]
            tau[:, self.model.tau_names.index(str(column.drives))] += gain * (own + bias)
        return parameter_rows(self.model, problem.unknowns, values), tau

    def rests(self, window: np.ndarray, p: np.ndarray, tau: np.ndarray) -> list[tuple | None]:
        """Of lanes of cases what :meth:`rest` finds, None without a rest."""
        out: list[tuple | None] = []
        for case, own, load in zip(window, p, tau, strict=True):
            try:
                out.append(self.rest(int(case), own, load))
            except NoEquilibriumError:
                out.append(None)
        return out

    def read(self, problem: Problem, window: np.ndarray, values: np.ndarray) -> np.ndarray:
        """What the model reads (lanes, 1, sensors) in lanes of cases, with numbers (lanes, k); inf without a rest."""
        p, tau = self.loads(problem, window, values)
        found = self.rests(window, p, tau)
        q = np.array([self.model.chain.home if x is None else x[1].q for x in found])
        out = self.readings(problem, values, q, p, tau)
        out[[x is None for x in found]] = np.inf
        return out

    def readings(
        self, problem: Problem, values: np.ndarray, q: np.ndarray, p: np.ndarray, tau: np.ndarray
    ) -> np.ndarray:
        """What sensors read (lanes, 1, sensors) of robots at rest at `q` (lanes, nq)."""
        still = np.zeros((len(q), 1, self.model.chain.nvz))
        out = self.signals(q[:, None].astype(float), still, tau[:, None], p, self.chosen)
        for k, sensor in enumerate(self.chosen):
            numbers = sensor_numbers(problem.unknowns, self.columns.sensors[sensor], values)
            out[..., k] = numbers["scale"][:, None] * out[..., k] + numbers["offset"][:, None]
        return out

    def differences(self, problem: Problem, window: np.ndarray, sought: np.ndarray, shift: np.ndarray) -> np.ndarray:
        made = self.read(problem, window, problem.unknowns.values(sought))
        return np.where(np.isinf(made), np.inf, self.compared[window] - made)

    def continued(self, problem: Problem, sought: np.ndarray, shift: np.ndarray) -> np.ndarray:
        return shift

    def linearised(
        self, problem: Problem, sought: np.ndarray, shift: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        window, k = np.arange(len(self.compared)), len(sought)
        begin = problem.unknowns.values(np.tile(sought, (len(window), 1)))
        found = self.rests(window, *self.loads(problem, window, begin))
        if None in found:
            said = "with the numbers that the fit starts from the model finds no rest; start from other numbers"
            raise UsageError(f"{self.log.name}: row {found.index(None) + 1}: {said}")
        lanes = np.repeat(sought + np.vstack([np.zeros(k), STEP * np.eye(k)]), len(window), axis=0)
        values, cases = problem.unknowns.values(lanes), np.tile(window, 1 + k)
        p, tau = self.loads(problem, cases, values)
        q = [one[1].q for one in found if one is not None]
        q += [self.beside(c, found[c], p[lane], tau[lane]) for lane, c in enumerate(cases) if lane >= len(window)]
        made = self.readings(problem, values, np.array(q), p, tau).reshape(1 + k, *self.compared.shape)
        by_p = np.moveaxis((made[0] - made[1:]) / STEP, 0, -1)
        return self.compared - made[0], by_p, np.zeros((*made[0].shape, 0))


def _quantity(one: SensorSignal) -> str:
    return str(one.column.measures).partition("@")[0] if one.row is not None else one.column.name


def shapes_of(model: RobotModel, log: Log, columns: Columns) -> StaticShapes:
    """The shapes of a log; raises UsageError where the robot's rest is not sought."""
    if model.chain.floating or model.chain.moving or model.chain.curved:
        what = "static shapes are those of robots on a fixed base without ball joints"
        raise UsageError(f"{log.name}: {what}; identify this one from logs in time")
    return StaticShapes(model, log, columns, Signals(model, columns.sensors))


def beside_rest(
    model: RobotModel, log: Log, own: Columns, asked: Unknowns, sought: np.ndarray, how: MotionMethod, held_out: bool
) -> Explained:
    """The shapes of a log beside the model of what was found, and beside that of the start."""
    shapes = shapes_of(model, log, own)
    problem, window = Problem(model, [shapes], asked, how), np.arange(len(log))
    before, found = (
        shapes.read(problem, window, np.tile(asked.values(x), (len(log), 1)))[:, 0]
        for x in (np.zeros_like(sought), sought)
    )
    y, places = shapes.compared[:, 0], _points(shapes)
    far = [np.linalg.norm(y[:, own] - found[:, own], axis=1) for own in places]
    distance = float(np.nanmean(far)) if far else None
    return Explained(
        *(log.name, held_out, log.t, tuple(shapes.names), y, found, before, found, window),
        quantities=shapes.quantities,
        static=True,
        distance=distance,
    )


def _points(shapes: StaticShapes) -> list[list[int]]:
    """Of each point whose three coordinates are measured the places of these among the sensors."""
    found: dict[str, list[int]] = {}
    for place, k in enumerate(shapes.chosen):
        said = str(shapes.columns.sensors[k].measures)
        if said.startswith(POSITIONS):
            found.setdefault(f"{said.partition('[')[0]} {shapes.columns.sensors[k].numbers}", []).append(place)
    return [places for places in found.values() if len(places) == 3]
