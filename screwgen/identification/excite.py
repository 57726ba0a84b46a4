"""Motions that tell most of what is sought: Fourier series of the joints within limits, checked in a run."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..arguments import Numbers, array, seconds, whole
from ..errors import UsageError
from ..planning.drive_coordinates import DriveCoordinates
from ..planning.joint_gains import gains as found_gains
from ..planning.limits import motion_limits
from ..planning.make import law_of
from ..planning.members import Still
from ..planning.plan import MotionPlan
from ..planning.refusals import BY_MOTION, PLANNED, refuse_robot
from ..planning.task import MotionLimits
from ..robot_model import RobotModel
from ..simulation.measured import strain as strains
from ..simulation.played import Played
from ..simulation.runs import Run
from ..simulation.simulate import simulate
from ..spec.columns import Column, Columns
from ..spec.excitation import STEP, TIME
from ..studies.equilibrium import equilibrium
from .beside import how_of, windows_of_log
from .evolution import minimised
from .excitation import Excitation
from .excited_motions import MotionMaker, Motions, RestingArm, broken_limit
from .fourier import FourierSeries
from .information import NOISE, Bench, log_of_motion
from .logs import Log
from .odd import of_inputs
from .signals import Signals
from .sources import columns_of
from .uncertainty import LOST, lost_directions
from .unknowns import unknowns_of_logs
from .words import direction_in_words

RANDOM = 16
"""Random motions that are looked at: the best is where the search starts, the middle one is compared."""
GENERATIONS = 40
SLOW = 100
"""The samples of a period of the highest frequency, unless a bandwidth is stated."""
FAST = 0.1
"""The highest frequency over the sample rate at most."""
LEAST = 1e-300
ROUNDED, TOUCHED = 1e-14, 1e-6
"""Information, over the largest, that is rounding; the entry of a direction from which a number takes part in it."""


def excite(
    model: RobotModel,
    *,
    free: str | Sequence[str],
    sensors: str | os.PathLike[str] | Columns | None = None,
    limits: Mapping[str, Any] | None = None,
    strain: float = np.inf,
    gains: Any = None,
    time: float = TIME,
    step: float = STEP,
    start: Numbers | None = None,
    bandwidth: float | None = None,
    window: float = 1.0,
    generations: int = GENERATIONS,
    seed: int = 0,
    progress: Callable[[str], None] | None = None,
) -> Excitation:
    """A motion within limits that makes best known what is known worst of what is `free`.

    `free`, `sensors`, `window` as of :func:`screwgen.identify`; without `sensors` the joints are measured, of elastic
    drives the rotors, and the inputs known, and a sensor without `noise` has a hundredth of how much it varies in a
    random motion. The joints, of elastic drives the rotors over the ratio with efforts times the ratio, move
    along Fourier series about `start` (n_joints,) of frequencies up to `bandwidth`, Hz, a tenth of the sample rate at
    most; both ends are at rest. In loops as many joints do so as these leave free, those with drives before others, and
    the limits of those that follow are kept, too; the law is to be stated then.
    `limits`: `lower`, `upper`, `rates`, `efforts` (n_joints,) and `strains`, tighter ones than those of the robot file;
    `strain`: of all entries of `model.strain_names`. `gains`: the law under which the motion is played, as
    :class:`PD`; without, :func:`screwgen.gains` finds one. `progress` is told a line per generation; an interruption
    keeps the best so far.

    The motion is run on the model under its law. Raises UsageError where the run breaks a limit, which it names, or
    where an argument makes no sense.
    """
    refuse_robot(model, "excitation", "state a motion of your own", (*PLANNED, BY_MOTION), loops=True)
    m, time, step = model.n_joints, seconds(time, "time"), seconds(step, "step")
    bounds = _limits(model, limits or {}, strain)
    p = np.asarray(model.chain.parameters.values)
    begin = array(np.clip(np.zeros(m), bounds.lower, bounds.upper) if start is None else start, "start:", (m,))
    resting = _resting(model, begin, p)
    begin = DriveCoordinates(model.chain, p).driven(resting.q)
    if ((begin <= bounds.lower) | (begin >= bounds.upper)).any():
        raise UsageError(f"start: {begin.tolist()} is not within the joints' limits; state start between them")
    if not (np.isfinite(bounds.rates) | np.isfinite(bounds.upper - bounds.lower))[list(resting.leading)].all():
        raise UsageError("limits: ranges and rates leave a joint free to go any way; state rates")
    series = _series(time, step, 1.0 / (SLOW * step) if bandwidth is None else seconds(bandwidth, "bandwidth"))
    if gains is None and model.chain.closing.rows:
        raise UsageError("gains: there are none found for robots with loops; state the law, as PD or in gains")
    maker = MotionMaker(model, series, resting, bounds, p)
    law = gains if gains is not None else found_gains(model, [begin], step=step)
    rng = np.random.default_rng(whole(seed, "seed", 0))
    factors = rng.standard_normal((RANDOM, maker.size))
    random = maker.largest(factors)
    columns = _columns(model, sensors)
    bench = _bench(model, columns, free, random, step, seconds(window, "window"), rng)
    known = _worst(bench, random, step)
    middle = int(np.argsort(known)[len(known) // 2])

    def told(generation: int, least: float) -> None:
        if progress:
            narrower = np.exp(known[middle] - least)
            progress(f"generation {generation + 1}: worst direction {narrower:.3g} times better known than by chance")

    score = lambda rows: _worst(bench, maker.largest(rows), step)  # noqa: E731
    best = minimised(score, factors[np.argmin(known)], whole(generations, "generations", 0), rng, told)
    found = maker.largest(best[None])
    plan, by_chance = (_plan(maker, made, k, law) for made, k in ((found, 0), (random, middle)))
    run = _checked(model, plan, bounds, step, resting.q)
    information = bench.information(found, 0, step)
    return Excitation(
        plan,
        run,
        by_chance,
        bench.unknowns,
        _deviation(information),
        _deviation(bench.information(random, middle, step)),
        tuple(direction_in_words(bench.unknowns, *x) for x in lost_directions(information, information)),
        tuple(of_inputs(model, columns)),
        _with_noise(columns, bench.noise),
    )


# ------------------------------------------------------------------------------ what is given


def _limits(model: RobotModel, given: Mapping[str, Any], strain: float) -> MotionLimits:
    for name in ("wrenches", "effort_rates"):
        if name in given:
            raise UsageError(f"limits: {name}: an excitation does not look at these; leave them out")
    own = motion_limits(model, given, headroom=1.0)
    if not strain > 0:
        raise UsageError(f"strain: is {strain}; it must be a number > 0")
    return replace(own, strains=np.minimum(own.strains, strain))


def _resting(model: RobotModel, start: np.ndarray, p: np.ndarray) -> RestingArm:
    """The arm at rest with its joints, of loops those that lead, where they are said to be."""
    still = Still(model, p)
    if not model.chain.closing.rows:
        rest = still.held(start)
        return RestingArm(still.drives.to_robot(rest.q), rest.effort, tuple(range(len(start))))
    found = equilibrium(model, start, hold=True)
    leading = tuple(model.q_names.index(name) for name in found.held_joints)
    return RestingArm(found.q, still.drives.efforts(found.tau), leading)


def _series(time: float, step: float, bandwidth: float) -> FourierSeries:
    """The series of the joints; refuses frequencies of which samples do not show the motion."""
    if bandwidth > FAST / step * (1.0 + 1e-9):
        said = f"bandwidth: is {bandwidth:g} Hz, and samples are {step:g} s apart"
        raise UsageError(f"{said}; state a tenth of the sample rate at most, {FAST / step:g} Hz, or a shorter step")
    if time * FAST < 2 * step * (1.0 - 1e-9):
        raise UsageError(f"time: is {time:g} s; a motion takes 20 steps at least, {20 * step:g} s")
    return FourierSeries(time, step, bandwidth)


def _columns(model: RobotModel, sensors: str | os.PathLike[str] | Columns | None) -> Columns:
    """The columns of a log; without a table what drives measure is, and inputs are known."""
    if sensors is not None:
        return columns_of(model, sensors, Log("motion", np.zeros(0), {}))
    measured = [Column(name=name, measures=name) for name in map(model.q_names.__getitem__, model.chain.held_places)]
    return Columns(columns=(*measured, *(Column(name=name, drives=name) for name in model.tau_names)))


def _bench(
    model: RobotModel,
    columns: Columns,
    free: str | Sequence[str],
    random: Motions,
    step: float,
    window: float,
    rng: np.random.Generator,
) -> Bench:
    """What measures the robot; noise that is not stated, and how well windows begin, are those in a random motion."""
    p = np.asarray(model.chain.parameters.values)
    log = log_of_motion(Signals(model, columns.sensors), columns, random, 0, step, p)
    sizes = [float(log.columns[column.name].std()) for column in columns.sensors]
    noise = np.array(
        [column.noise or max(NOISE * size, LEAST) for column, size in zip(columns.sensors, sizes, strict=True)]
    )
    noisy = dict(log.columns)
    for column, own in zip(columns.sensors, noise, strict=True):
        noisy[column.name] = noisy[column.name] + own * rng.standard_normal(len(log))
    windows = windows_of_log(model, Log(log.name, log.t, noisy), columns, window, p)
    follow = windows.begin[0].follow
    deviation = np.median([x.deviation for x in windows.begin], axis=0)
    deviation[follow] = deviation[model.nv + follow] = 0.0
    asked = unknowns_of_logs(model, columns, free, [log])
    reach, how = windows.experiment.reach, how_of("modal_midpoint", 1, 1)
    return Bench(model, columns, asked, noise, deviation, follow, reach, window, how)


def _with_noise(columns: Columns, noise: np.ndarray) -> Columns:
    """The columns with the noise of their sensors (sensors,)."""
    own = {column.name: float(x) for column, x in zip(columns.sensors, noise, strict=True)}
    return columns.model_copy(
        update={
            "columns": tuple(
                c.model_copy(update={"noise": own[c.name]}) if c.name in own else c for c in columns.columns
            )
        }
    )


# ------------------------------------------------------------------------------ the search


def _worst(bench: Bench, made: Motions, step: float) -> np.ndarray:
    """(lanes,): the logarithm of the deviation of the direction that is known worst."""
    out = []
    for lane in range(len(made.q)):
        least = np.linalg.eigvalsh(bench.information(made, lane, step))[0]
        out.append(-0.5 * np.log(max(float(least), LEAST)))
    return np.array(out)


def _deviation(information: np.ndarray) -> np.ndarray:
    """(k,): standard deviations of what is sought; infinite where it is not determined."""
    values, vectors = np.linalg.eigh(information)
    told = values > ROUNDED * values.max()
    lost = (np.abs(vectors[:, ~told]) > TOUCHED).any(axis=1)
    deviation = np.sqrt(vectors[:, told] ** 2 @ (1.0 / values[told]))
    return np.where(lost | (deviation > LOST), np.inf, deviation)


def _plan(maker: MotionMaker, made: Motions, lane: int, law: Any) -> MotionPlan:
    """A motion as a plan for a law: at rest at both ends, and between samples with the means of what is held."""
    model, held, still = maker.model, maker.drives.efforts(made.tau[lane]), maker.begin.torque
    tau = np.vstack([still, (held[:-2] + held[1:-1]) / 2, still])
    q, v, a = made.references[lane]
    held_by = law_of(law, model.n_joints)
    joints, efforts = tuple(model.q_names[: model.n_joints]), maker.limits.efforts
    return MotionPlan(model.robot.name, joints, maker.series.t, q, v, a, tau, held_by.kp, held_by.kd, efforts)


def _checked(model: RobotModel, plan: MotionPlan, limits: MotionLimits, step: float, q0: np.ndarray) -> Run:
    """The run of a motion under its law; raises UsageError where it breaks a limit."""
    run = simulate(model, plan.time, step, controller=Played.of(plan), q0=q0)
    bent = strains(model, run.q[None], np.asarray(model.chain.parameters.values))[0]
    if broken := broken_limit(limits, model, run, bent):
        raise UsageError(
            f"limits: {broken} in a run of the motion under its law; state other gains, or a lower bandwidth"
        )
    return run
