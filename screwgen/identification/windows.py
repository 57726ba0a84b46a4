"""Logs in windows: the inputs over each, its readings, and where its motion begins, with how well that is known.

An experiment is a log beside the robot. Over a window of about a second a motion stays near the readings although the
numbers of the robot are still wrong; so windows begin where smoothed readings say, within their deviations.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from ..backends.numpy.dae_step import SERIES
from ..errors import UsageError
from ..robot_model import RobotModel
from ..spec.columns import UNITS, Columns
from ..topology.chain import Chain
from . import smoothing
from .logged_motion import LoggedMotion, MovedPlaces, logged_motion, moved_places
from .logs import Log
from .loop_states import closed, closed_near, independent, walked
from .signals import SensorSignal, Signals

WIDE = 3.0
"""How many times more than its neighbours say a smoothed reading may be off."""
FAR, QUICK, BENT, SLIPPED, TWISTED = 10.0, 10.0, 0.1, 1e-3, 0.02
"""What is known of a state that nothing measures: joints are within 10 rad (m) and their rates within 10 times that per
second; the softest mode of a link is within 10 % of its length, others bend as under the same load, at their own
frequencies; states of friction are within 1e-3 rad (m); gears stretch by 0.02 rad (m) at their joints, ten times that
per second."""
ROUNDS = 6
STEP = 1e-6


@dataclass(frozen=True, eq=False)
class Experiment:
    """A log of a robot, with its columns in order."""

    model: RobotModel
    log: Log
    columns: Columns
    reach: int
    """Samples to either side over which readings are smoothed."""

    @cached_property
    def readings(self) -> np.ndarray:
        """(N, sensors)"""
        return np.column_stack([self.log.columns[column.name] for column in self.columns.sensors])

    @property
    def noise(self) -> np.ndarray:
        """(sensors,): the deviations of noise, NaN where none is stated."""
        return np.array([np.nan if c.noise is None else c.noise for c in self.columns.sensors])

    @cached_property
    def inputs(self) -> np.ndarray:
        """The columns that drive, (N, inputs)."""
        own = [self.log.columns[column.name] for column in self.columns.inputs]
        return np.column_stack(own) if own else np.zeros((len(self.log), 0))

    @cached_property
    def driven(self) -> list[int]:
        """The entry of `tau` that each of them drives."""
        return [self.model.tau_names.index(str(column.drives)) for column in self.columns.inputs]

    def coordinates(self, sensor: int) -> np.ndarray:
        """What a sensor of a coordinate reads, (N,) in SI units."""
        column = self.columns.sensors[sensor]
        return np.asarray((self.readings[:, sensor] - column.offset) / column.scale * UNITS[column.unit])

    @cached_property
    def moved(self) -> MovedPlaces:
        """The places of what the log moves: axes, and a base."""
        return moved_places(self.model, self.columns)

    @cached_property
    def given(self) -> LoggedMotion:
        """How these move."""
        return logged_motion(self.moved, self.log, self.columns, self.readings, self.reach)

    @cached_property
    def stated(self) -> np.ndarray:
        """(n_joints,) of bool: the joints from which others follow in loops: those that the log moves, or measures."""
        chain = self.model.chain
        names = chain.axis_names
        measured = {column.measures for column in self.columns.sensors}
        moved = {at - chain.base_v for at in self.moved.of_v if at >= chain.base_v}
        return np.array([k in moved if moved else name in measured for k, name in enumerate(names)], bool)

    @cached_property
    def stated_coordinates(self) -> np.ndarray:
        """(N, stated joints): where these are, as it was read."""
        chain, out = self.model.chain, []
        measured = {column.measures: k for k, column in enumerate(self.columns.sensors)}
        for at in chain.base_q + np.flatnonzero(self.stated):
            if at in self.moved.of_q:
                out.append(self.given.q[:, self.moved.of_q.index(at)])
            else:
                out.append(self.coordinates(measured[self.model.q_names[at]]))
        return np.reshape(out, (len(out), len(self.log))).T

    @property
    def compared(self) -> list[int]:
        """The sensors whose readings are compared: those that move axes or the base are not."""
        return [k for k in range(len(self.columns.sensors)) if k not in self.moved.sensors]

    def tau(self, first: np.ndarray, steps: int, gains: list[tuple[np.ndarray, np.ndarray]]) -> np.ndarray:
        """Inputs (lanes, steps, n_tau) of lanes that begin at samples `first`, by gain and bias (lanes,) of columns."""
        at = first[:, None] + np.arange(steps)
        out = np.zeros((len(first), steps, self.model.n_tau))
        for k, (place, (gain, bias)) in enumerate(zip(self.driven, gains, strict=True)):
            out[..., place] += gain[:, None] * (self.inputs[at, k] + bias[:, None])
        out[..., self.moved.of_tau] = self.given.vdot[at]
        return out

    def cut(self, seconds: float, shortest: int) -> list[tuple[int, int]]:
        """First sample and number of samples of windows of about so many seconds, of equal length."""
        number = max(1, round((len(self.log) - 1) * self.log.step / seconds))
        size = (len(self.log) - 1) // number
        if size < shortest:
            raise UsageError(f"{self.log.name}: windows of {seconds:g} s have {size} samples; {shortest} are needed")
        return [(k * size, size) for k in range(number)]


@dataclass(frozen=True, eq=False)
class StartState:
    """Where a motion begins, and how well that is known.

    Changes of a state (nv + nvz,) are those of the posture along v, turns of floating bases and ball joints among
    them, and those of rates.
    """

    x: np.ndarray
    """[q; v]"""
    deviation: np.ndarray
    """Of each change, 0 of those that are given, or that follow from others where loops are closed."""
    follow: np.ndarray = field(default_factory=lambda: np.zeros(0, int))
    """The coordinates that follow from others."""


def changed(chain: Chain, x: np.ndarray, change: np.ndarray) -> np.ndarray:
    """States (…, nq + nvz) after changes (…, nv + nvz) of them."""
    if not chain.curved:
        return x + change
    q, u = (
        np.broadcast_to(a, (*change.shape[:-1], a.shape[-1])) for a in (x[..., : chain.nq], change[..., : chain.nv])
    )
    rows = zip(q.reshape(-1, chain.nq), u.reshape(-1, chain.nv), strict=True)
    posture = np.array([chain.integrate(*row, SERIES) for row in rows]).reshape(q.shape)
    return np.concatenate([posture, x[..., chain.nq :] + change[..., chain.nv :]], axis=-1)


def change_between(chain: Chain, x: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The change (nv + nvz,) from a state to another."""
    n = chain.nq
    return np.append(chain.difference(x[:n], other[:n], SERIES), other[n:] - x[n:])


def starts(experiment: Experiment, signals: Signals, firsts: list[int], p: np.ndarray) -> list[StartState]:
    """The states at these samples, by Gauss and Newton from smoothed readings, at parameters (n,)."""
    out = list[StartState]()
    for first in firsts:
        near = along(experiment, out[-1].x, slice(firsts[len(out) - 1], first + 1), p) if out else None
        out.append(_start(experiment, signals, first, p, near))
    return out


def along(experiment: Experiment, x: np.ndarray, samples: slice, p: np.ndarray) -> np.ndarray | None:
    """The state near which loops are closed at the last of some samples, at the first of which it is `x`.

    Linkages have several postures of one crank angle; from sample to sample they stay in that in which they are.
    """
    model, kept = experiment.model, experiment.stated
    if not model.chain.closing.rows or not kept.any():
        return None
    own = experiment.stated_coordinates[samples]
    return walked(model, x, p, model.chain.base_q + np.flatnonzero(kept), own[np.isfinite(own).all(axis=1)], kept)


def _start(experiment: Experiment, signals: Signals, first: int, p: np.ndarray, near: np.ndarray | None) -> StartState:
    model, step = experiment.model, experiment.log.step
    plain = [k for k in experiment.compared if not signals.signals[k].accelerates]
    seen = smoothing.smoothed(experiment.readings[:, plain], first, step, experiment.reach)
    columns = [experiment.columns.sensors[k] for k in plain]
    scale, offset = np.array([c.scale for c in columns]), np.array([c.offset for c in columns])
    value, rate = (seen.value - offset) / scale, seen.rate / scale
    size = np.nanstd(experiment.readings[:, plain], axis=0) / np.abs(scale)
    of_value = np.maximum(WIDE * seen.of_value / np.abs(scale), 1e-3 * size)
    of_rate = np.maximum(WIDE * seen.of_rate / np.abs(scale), 1e-3 * size / (experiment.reach * step))
    chain, n, nv = model.chain, model.nq, model.nv
    x, wide = _at_rest(model, p)
    joints = slice(chain.base_q, chain.base_q + chain.n_joints)
    if near is not None:
        x[joints] = near[joints]
    for k, sensor in enumerate(plain):
        if (one := signals.signals[sensor]).kind in ("q", "v"):
            unit = UNITS[one.column.unit]
            x[one.place + model.nq * (one.kind == "v")] = value[k] * unit
            mode, rates = (one.place - chain.eta_v, nv) if one.kind == "v" else (one.place - chain.eta_q, 0)
            if mode >= 0:  # one that rings is not bent as under the load of others
                at = rates + chain.eta_v + mode
                wide[at] = max(wide[at], WIDE * size[k] * unit)
    if chain.n_added:
        for begin, end in ((chain.base_q, chain.eta_q), (n + chain.base_v, n + chain.eta_v)):
            x[begin:end] = chain.with_added(x[begin : end - chain.n_added], p)
    held = np.zeros(len(wide), bool)
    of_v = np.array(experiment.moved.of_v, int)
    x[np.array(experiment.moved.of_q, int)] = experiment.given.q[first]
    x[n + of_v], held[[of_v, nv + of_v]] = experiment.given.v[first], True
    x[:n] = chain.unit(x[:n])
    (middle, _), likely = _at_rest(model, p), _likely(chain, p, wide)
    free, kept = np.flatnonzero(~held), experiment.stated
    if chain.closing.rows:
        x = closed_near(model, x, p, kept, experiment.log.name)
    by_q = [not _needs_rates(signals.signals[k]) for k in plain]
    for _ in range(ROUNDS):
        h, H = _slopes(signals, x, p, plain)
        rows = [(value - h) / of_value]
        slopes = [H / of_value[:, None]]
        moving = np.flatnonzero(by_q)
        by_rate = np.zeros((len(moving), len(wide)))
        by_rate[:, nv : 2 * nv] = H[moving][:, :nv]
        rates = by_rate[:, nv : 2 * nv] @ x[n : n + nv]
        rows += [(rate[moving] - rates) / of_rate[moving], (likely @ change_between(chain, x, middle))[free]]
        slopes += [by_rate / of_rate[moving, None], likely[free]]
        places, T = independent(model, x, p, kept)
        own = ~held[places]
        A, b = np.vstack(slopes) @ T[:, own], np.concatenate(rows)
        x = changed(chain, x, T[:, own] @ np.linalg.lstsq(A, b, rcond=None)[0])
        follow = np.setdiff1d(np.arange(nv), places)
        if follow.size:
            if held[follow].any():
                said = "moves an axis that loops move; leave the axis free, or that column out"
                raise UsageError(f"{experiment.log.name}: {model.v_names[follow[held[follow]][0]]}: the log {said}")
            x = closed(model, x, p, follow)
    deviation = np.zeros(len(wide))
    deviation[places[own]] = np.sqrt(np.diag(np.linalg.inv(A.T @ A)))
    return StartState(x, deviation, follow)


def _likely(chain: Chain, p: np.ndarray, wide: np.ndarray) -> np.ndarray:
    """(changes, changes): what is as large as 1 in a likely change that nothing measures, of rotors the stretch."""
    out, nv = np.diag(1 / wide), chain.nv
    for k, (joint, ratio) in enumerate(zip(chain.added_joints, chain.ratios(p), strict=True)):
        rotor, size = chain.eta_v - chain.n_added + k, TWISTED * (ratio or 1.0)
        for first, most in ((0, size), (nv, QUICK * size)):
            out[first + rotor, [first + rotor, first + chain.base_v + joint]] = 1 / most, -ratio / most
    return out


def _needs_rates(one: SensorSignal) -> bool:
    return one.kind == "v" or (one.row is not None and "v" in one.row.inputs.split())


def _at_rest(model: RobotModel, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A state at rest, and changes of it (nv + nvz,) as large as one may be that nothing measures."""
    chain = model.chain
    wide, rates = np.full(model.nv, FAR), np.full(chain.nvz, SLIPPED)
    rates[: model.nv] = QUICK * FAR
    for i, (segment, constants) in enumerate(zip(chain.segments, model.numpy(p).constants, strict=True)):
        modes = slice(chain.eta_offset[i], chain.eta_offset[i + 1])
        K, M = (np.asarray(constants[name], float)[: chain.keys[i].modes] for name in ("K", "M_eta"))
        own = BENT * (model.robot.links[segment.link].length or 1.0) / segment.count * K.min(initial=np.inf) / K
        wide[chain.eta_v :][modes], rates[chain.eta_v :][: chain.n_modes][modes] = own, np.sqrt(K / M) * own
    return np.concatenate([np.array(chain.home, float), np.zeros(chain.nvz)]), np.concatenate([wide, rates])


def _slopes(signals: Signals, x: np.ndarray, p: np.ndarray, fields: list[int]) -> tuple[np.ndarray, np.ndarray]:
    """Signals (fields,) at a state, and their derivatives (fields, changes) by differences."""
    chain, n = signals.model.chain, signals.model.nq
    size = chain.nv + chain.nvz
    points = changed(chain, x, np.vstack([np.zeros(size), STEP * np.eye(size), -STEP * np.eye(size)]))
    q, v = points[:, None, :n], points[:, None, n:]
    tau = np.zeros((len(points), 1, signals.model.n_tau))
    found = signals(q, v, tau, np.tile(p, (len(points), 1)), fields)[:, 0]
    ahead, behind = np.split(found[1:], 2)
    return found[0], (ahead - behind).T / (2 * STEP)
