"""Gains of a joint law from the sampled closed loop, over postures and models: its slowest motion decays fastest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arguments import Given, Numbers, array, seconds
from ..errors import UsageError
from ..robot_model import RobotModel
from .drive_coordinates import DriveCoordinates
from .further_modes import with_further_modes
from .gain_bounds import GainBounds
from .gain_search import GROWTH, GainSearch
from .loop_margins import LoopMargin, loop_margins, worst
from .make import scaled
from .members import Still
from .refusals import GIVEN, ROUNDING, refuse_robot
from .sampled_loop import LoopFigures, LoopGains, SampledLoop, noise_torques, step_torques

STEP = 1e-3
BAND = 0.025
"""Up to which frequency motions count as those of the loop, times the step."""
ROUNDS = 5
"""How often gains are sought, with closer bounds each time: the whole loop may exceed what one gain alone keeps."""
SAMPLES = 3000
"""Over how many samples after a jump of references its largest efforts are sought."""


@dataclass(frozen=True, eq=False)
class JointGains:
    """A joint law and what its sampled loop does, over all postures and models that were looked at."""

    kp: np.ndarray
    kd: np.ndarray
    ki: np.ndarray | None
    """None without integral."""
    figures: LoopFigures
    """How its motions decay; no damping of materials is assumed beyond the file's."""
    step: float
    """s: of the clock."""
    spare: float
    """The factor on all gains up to which nothing grows; at most ten."""
    postures: np.ndarray
    """(k, n_joints): the postures that were looked at."""
    margins: tuple[tuple[LoopMargin, ...], ...]
    """Of each posture those of each joint's loop, the worst of all models."""
    further: LoopFigures | None
    """Of the arm with the next two modes per plane; None where no link bends."""
    jump_efforts: np.ndarray
    """(n_joints,): the largest efforts after a jump of the references, with those that hold the arm."""
    noise_efforts: np.ndarray
    """(n_joints,): the standard deviations of efforts that the noise of sensors causes."""
    robot: str
    joints: tuple[str, ...]
    tau_max: np.ndarray
    """(n_joints,): limits of drives in the robot file, N·m, of slides and cylinders N, perhaps infinite."""
    levers: bool = False
    """Whether drives have transmissions: C is then given their levers."""

    @property
    def band(self) -> float:
        """Hz: up to where motions count as those of the loop."""
        return BAND / self.step

    @property
    def decay(self) -> float:
        """1/s: of the slowest motion of the loop below `band`."""
        return self.figures.decay

    @property
    def damping(self) -> float:
        """The least damping ratio of the motions below `band`."""
        return self.figures.damping

    @property
    def margin(self) -> float:
        """The least damping ratio of all motions, fast ones too."""
        return self.figures.margin

    @property
    def line(self) -> str:
        """The figures in words."""
        x = self.figures
        return (
            f"slowest decay {x.decay:.3g} 1/s and least damping {x.damping:.3g} up to {self.band:.3g} Hz; "
            f"least damping of all {x.margin:.2g}{x.growing}; all gains may grow by a factor {self.spare:.3g}"
        )

    @property
    def lines(self) -> list[str]:
        """All figures in words, a line each."""
        out = [self.line]
        if self.further is not None:
            x = self.further
            out.append(f"with the next two modes per plane: {x.words}")
        for what, efforts in (("after the jump of references", self.jump_efforts), ("by noise", self.noise_efforts)):
            if efforts.any():
                deviations = "standard deviations of " * (what == "by noise")
                out.append(f"{deviations}efforts {what}: {', '.join(f'{x:.3g}' for x in efforts)}")
        for q, loops in zip(self.postures, self.margins, strict=True):
            at = ", ".join(f"{x:g}" for x in q)
            driven = [j for j in range(len(loops)) if self.kp[j] or self.kd[j]]
            out += [f"at {at}: joint {j}: {margin_words(loops[j], self.step)}" for j in driven]
        return out

    def c(self) -> dict[str, str]:
        """The law as C99, texts by names of files: `<robot>_law.h` and `<robot>_law.c`, which need no others.

        `<robot>_law_sample` gives what a :class:`PD`, with `ki` a :class:`PID`, with these gains, limits and efforts
        ahead gives at the samples, to rounding. Raises UsageError.
        """
        from .joint_gains_c import law_files

        return law_files(self)


def margin_words(x: LoopMargin, step: float) -> str:
    """The margins of a loop in words, with a warning where it does not bear to be late by a sample of `step` s."""
    delay = "any delay" if np.isinf(x.delay) else f"delay {x.delay * 1e3:.3g} ms"
    delay += f", less than a sample of {step * 1e3:.3g} ms: torques that are late by one make it grow" * (
        x.delay < step
    )
    return f"gain {x.lower:.2g} to {x.upper:.3g}, disk {x.disk:.2g} (phase {x.phase:.0f} degrees), {delay}"


def gains(
    model: RobotModel,
    postures: Sequence[Numbers],
    *,
    models: Sequence[Mapping[str, float]] = (),
    step: float = STEP,
    integral: bool = False,
    bounds: Mapping[str, Any] | None = None,
    parameters: Given = None,
) -> JointGains:
    """Gains `kp`, `kd` of all joints under which the slowest motion decays fastest, in all `postures` and `models`.

    The loop is the one that a clock of `step` seconds closes: torques are held between samples. `models`: factors of
    parameters, as :func:`plan` has them. The decay is that of motions up to a fortieth of the clock's rate. Faster
    ones, also those of the next two modes of every plane, must not grow, and must not with twice the gains.

    `integral`: whether the law also integrates the errors of joints, with gains `ki`. `bounds`: `decay` and `damping`
    wanted; the largest `kp`, `kd` and `ki` (n_joints,); `jump` (n_joints,) of the references and the largest `efforts`
    after it; `noise_q`, `noise_v` (n_joints,) of sensors and the largest deviations `noise_efforts` of efforts.

    Of a joint behind an elastic gear all is said of the rotor: its angle over the ratio, its effort times the ratio.
    Gains are those of torques at joints where a cylinder or a four-bar linkage moves them, too; efforts are then forces
    of the cylinder, N, and torques of the crank, with the levers of the postures.

    Raises UsageError where no gains are stable, or none keep the bounds.
    """
    refuse_robot(model, "search for gains", "state gains of your own", [GIVEN])
    m, step = model.n_joints, seconds(step, "the step")
    at = postures_within(model, postures)
    values = model.chain.parameters.vector(parameters)
    most = DriveCoordinates(model.chain, values).efforts(model.chain.most("effort"))
    limits = GainBounds.of(bounds or {}, most)
    ways = [values, *(scaled(model, values, f) for f in models)]
    own = RestLoops.of(model, ways, at, step)
    richer = with_further_modes(model)
    further = None if richer is None else RestLoops.of(richer, ways, at, step)
    search = GainSearch(
        own.loops, own.inertia[:m], BAND / step, limits, integral, limits.largest(own.holding, own.levers)
    )
    law, efforts, noise = _within_bounds(search, own, limits)
    if further is not None and not search.borne(law, further.loops):
        search = search.beside(further.loops)
        law, efforts, noise = _within_bounds(search, own, limits)
        if not search.borne(law, further.loops):
            raise UsageError("gains: those that were found are unstable with the next two modes per plane; lower kd")
    figures = LoopFigures.of([loop.poles(law) for loop in own.loops], BAND / step)
    search.check(figures)
    count = len(ways)
    each = [loop_margins(loop.closed(law), step) for loop in own.loops]
    return JointGains(
        *law,
        figures,
        step,
        search.spare(law),
        at,
        tuple(worst(each[k * count : (k + 1) * count]) for k in range(len(at))),
        None if further is None else LoopFigures.of([x.poles(law) for x in further.loops], BAND / step),
        efforts,
        noise,
        model.robot.name,
        tuple(model.q_names[:m]),
        most,
        bool(model.chain.travels),
    )


def postures_within(model: RobotModel, given: Sequence[Numbers]) -> np.ndarray:
    """Postures (k, n_joints) within the limits of the joints; raises UsageError."""
    m = model.n_joints
    at = np.array([array(q, "postures:", (m,)) for q in given]).reshape(-1, m)
    if not len(at):
        raise UsageError("postures: are none; give at least one")
    lower, upper = model.chain.limits.T
    if (out := np.argwhere((at < lower - ROUNDING) | (at > upper + ROUNDING))).size:
        k, j = out[0]
        said = f"{model.q_names[j]} is {at[k, j]:g}; its limits are {lower[j]:g} and {upper[j]:g}"
        raise UsageError(f"postures: {said}; choose one within them")
    return at


@dataclass(frozen=True)
class RestLoops:
    """The small motions of an arm about rests, posture by posture those of all its models."""

    loops: Sequence[SampledLoop]
    inertia: np.ndarray
    """The largest inertias that torques feel, all others free."""
    holding: np.ndarray
    """(loops, n_joints): the sizes of efforts that hold the arm."""
    levers: np.ndarray
    """(loops, n_joints): sizes of torques at joints by a unit of effort, 1 of drives without a transmission."""

    @classmethod
    def of(cls, model: RobotModel, ways: Sequence[np.ndarray], postures: np.ndarray, step: float) -> RestLoops:
        """Of a model at several parameters."""
        stills = [Still(model, p) for p in ways]
        rests = [(still, still.held(q)) for q in postures for still in stills]
        inertia = np.max([np.diag(np.array(still.inertia(rest.q))) for still, rest in rests], axis=0)
        holding = np.abs([rest.effort for _, rest in rests])
        per_torque = np.abs([still.efforts_behind(np.ones(still.joints), rest.q) for still, rest in rests])
        return cls([SampledLoop.of(still, rest, step) for still, rest in rests], inertia, holding, 1.0 / per_torque)


def _within_bounds(search: GainSearch, own: RestLoops, limits: GainBounds) -> tuple[LoopGains, np.ndarray, np.ndarray]:
    """The best gains with the efforts after a jump and by noise, sought with closer bounds until all are kept."""
    for _ in range(ROUNDS):
        law = search.found()
        efforts, noise = np.zeros((2, own.holding.shape[1]))
        if limits.jump.any():
            reached = [step_torques(loop, law, limits.jump, SAMPLES) for loop in own.loops]
            efforts = (own.holding + reached / own.levers).max(axis=0)
        if limits.noise.any():
            noise = ([noise_torques(loop, law, limits.noise) for loop in own.loops] / own.levers).max(axis=0)
        by_jump = efforts / limits.efforts
        by_noise = np.where(noise > 0, noise / limits.noise_efforts, 0.0)
        if max(by_jump.max(), by_noise.max()) <= 1 + GROWTH:
            return law, efforts, noise
        pushed = np.where(limits.jump > 0, by_jump.max(), by_jump)  # what jumps moves the other joints too
        search = search.closer(law, np.maximum(pushed, by_noise), by_noise)
    named = "efforts after the jump" if by_jump.max() > 1 + GROWTH else "noise_efforts"
    raise UsageError(
        f"bounds: {named}: no gains keep them within {ROUNDS} searches; raise this bound, or bound kp and kd"
    )
