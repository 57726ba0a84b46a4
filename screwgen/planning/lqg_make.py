"""The search for a law with a filter over a grid: designed at vertices, held against what it was not designed for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from ..arguments import Given, Numbers, array, seconds
from ..errors import UsageError
from ..robot_model import RobotModel
from .drive_coordinates import DriveCoordinates
from .further_modes import with_further_modes
from .gain_search import GROWTH
from .joint_gains import BAND, STEP, margin_words, postures_within
from .loop_margins import loop_margins, worst
from .lqg import Lqg
from .lqg_design import LqgGains, LqgTuning, RestMatrices, closed_by, designed
from .make import scaled
from .members import Still
from .refusals import PLANNED, refuse_robot
from .sampled_loop import LoopFigures, SampledLoop
from .scheduling import Grid

BANDWIDTHS, CALM, FILTERS = np.geomspace(2.0, 32.0, 7), (1.0, 10.0), (1.5, 3.0, 6.0, 12.0)
"""rad/s of the joints, and weights and ratios that are tried with each."""
POINTS, SEED, FIRST, CANDIDATES = 200, 1, 9, 6
"""Random points of the check and their seed, vertices that the search looks at, and tunings that are checked."""
SPARES = (0.5, 2.0)
"""Factors on all torques that have to be borne."""


def lqg(
    model: RobotModel,
    grid: Mapping[str, Numbers],
    *,
    postures: Sequence[Numbers] = (),
    models: Sequence[Mapping[str, float]] = (),
    step: float = STEP,
    efforts: Numbers | None = None,
    parameters: Given = None,
) -> Lqg:
    """A linear-quadratic law with integral and its Kalman filter of the encoders, over a grid.

    `grid`: ascending values by names of joint coordinates, and by patterns of parameters, whose factors are loads
    that are known at run time. Joints that are no variables stand as in the first of `postures` (n_joints,), zero
    by default, and in the check anywhere between all of them. `models`: factors of parameters of arms that the law
    has to bear as well and does not know of. `efforts` (n_joints,): limits beside those of the robot file.

    Of laws that are stable the one is taken under which the slowest motion decays fastest. Stable it has to be at
    the vertices, in the middles between and at 200 random points, of all models, and with the next two modes of
    every plane. Of a joint behind an elastic gear all is said of the rotor: its angle over the ratio, its effort times
    the ratio. Raises UsageError where none is.
    """
    refuse_robot(model, "law with a filter", "state gains of your own", PLANNED)
    m, step = model.n_joints, seconds(step, "the step")
    values = model.chain.parameters.vector(parameters)
    own = DriveCoordinates(model.chain, values).efforts(model.chain.most("effort"))
    limits = own if efforts is None else np.minimum(own, array(efforts, "efforts:", (m,)))
    if not (limits > 0).all():
        raise UsageError("efforts: must be > 0: the law needs a drive at every joint")
    over = Grid.of(model, grid)
    ways = [values, *(scaled(model, values, factors) for factors in models)]
    arms = LqgArms(model, with_further_modes(model), over, ways, postures_within(model, postures or [[0.0] * m]), step)
    rests = [arms.rest(x, arms.postures[0]) for x in over.vertices]
    if (short := np.argwhere(np.abs([x.hold for x in rests]) > limits)).size:
        k, j = short[0]
        said = f"{model.q_names[j]} has {limits[j]:.4g}, and holding the arm takes {abs(rests[k].hold[j]):.4g}"
        raise UsageError(f"efforts: {said}; allow more, or take a smaller grid")
    law = Lqg(model.robot.name, tuple(model.q_names[:m]), step, over, _stacked([]), limits, arms.postures[0])
    return LqgSearch(arms, rests, law).found()


def _stacked(each: Sequence[LqgGains]) -> LqgGains:
    return LqgGains(*(np.array([x[k] for x in each]) for k in range(len(LqgGains._fields))))


Points = dict[str, list[tuple[np.ndarray, list[SampledLoop]]]]
"""Kinds of points of a grid, and of each point the arms there."""


@dataclass(frozen=True)
class LqgArms:
    """All arms that a law is held against, at any point of a grid."""

    model: RobotModel
    richer: RobotModel | None
    grid: Grid
    ways: Sequence[np.ndarray]
    postures: np.ndarray
    step: float

    def rest(self, point: np.ndarray, others: np.ndarray) -> RestMatrices:
        """The small motions of the arm that is designed for."""
        return self._rest(self.model, self.ways[0], point, others)

    def plants(self, point: np.ndarray, others: np.ndarray) -> list[SampledLoop]:
        """The small motions of all arms; `others`: where joints stand that are no variables."""
        each = [(self.model, values) for values in self.ways]
        each += [] if self.richer is None else [(self.richer, self.ways[0])]
        return [self._rest(model, values, point, others).loop(self.step) for model, values in each]

    def others(self, rng: np.random.Generator) -> np.ndarray:
        """Joints that are no variables, anywhere between the postures."""
        return rng.uniform(self.postures.min(axis=0), self.postures.max(axis=0))

    def _rest(self, model: RobotModel, values: np.ndarray, point: np.ndarray, others: np.ndarray) -> RestMatrices:
        still = Still(model, self.grid.parameters(model, values, point))
        rest = still.held(self.grid.posture(point, others))
        return RestMatrices(*still.matrices(rest), rest.q[model.n_joints :], rest.effort)


@dataclass(frozen=True)
class LqgSearch:
    """The search for a tuning, and the check of what was found."""

    arms: LqgArms
    rests: Sequence[RestMatrices]
    law: Lqg

    def found(self) -> Lqg:
        """The fastest law that is stable at every point; raises UsageError where there is none."""
        points, best = self._points(), None
        for most, tuning in sorted(self._tried(points), key=lambda pair: -pair[0])[:CANDIDATES]:
            if best is not None and best[0] >= most:
                break
            law = self._with(tuning)
            figures = {name: self._figures(law, each) for name, each in points.items()}
            decay = min(x.decay for x in figures.values())
            if all(map(_stable, figures.values())) and (best is None or decay > best[0]):
                best = decay, law, tuning, figures
        if best is None:
            raise UsageError("lqg: no law was found that is stable all over the grid; take a finer or a smaller one")
        return replace(best[1], lines=tuple(self._lines(*best[1:], points)))

    def _tried(self, points: Points) -> list[tuple[float, LqgTuning]]:
        """Tunings that are stable at some vertices, also with other gains, with the decay there."""
        chosen = np.unique(np.linspace(0, len(self.rests) - 1, FIRST).astype(int)).tolist()
        out: list[tuple[float, LqgTuning]] = []
        for each in product(BANDWIDTHS.tolist(), CALM, FILTERS):
            tuning, decays = LqgTuning(*each), []
            for k in chosen:
                law, loops = designed(self.rests[k], tuning, self.law.step), points["vertices"][k][1]
                figures = [LoopFigures.of([self._poles(x, law)], self.band) for x in loops]
                spare = [LoopFigures.of([self._poles(stronger(loops[0], f), law)], self.band) for f in SPARES]
                if not all(map(_stable, (*figures, *spare))):
                    break
                decays += [x.decay for x in figures]
            else:
                out.append((min(decays), tuning))
        return out

    @property
    def band(self) -> float:
        """Hz: up to where motions count as those of the loop."""
        return BAND / self.law.step

    def _poles(self, plant: SampledLoop, law: LqgGains) -> np.ndarray:
        return plant.rates(closed_by(plant, law).transition)

    def _with(self, tuning: LqgTuning) -> Lqg:
        return replace(self.law, tables=_stacked([designed(x, tuning, self.law.step) for x in self.rests]))

    def _points(self) -> Points:
        """Points of the check with the plants there."""
        rng, grid, first = np.random.default_rng(SEED), self.law.grid, self.arms.postures[0]
        fixed = {"vertices": grid.vertices, "middles of cells": grid.middles}
        out = {name: [(x, self.arms.plants(x, first)) for x in each] for name, each in fixed.items()}
        drawn = [(x, self.arms.plants(x, self.arms.others(rng))) for x in grid.drawn(rng, POINTS)]
        return out | {"random points": drawn}

    def _figures(self, law: Lqg, points: Sequence[tuple[np.ndarray, list[SampledLoop]]]) -> LoopFigures:
        """Of all plants at some points, the law interpolated."""
        return LoopFigures.of([self._poles(y, law.at(x)) for x, loops in points for y in loops], self.band)

    def _lines(self, law: Lqg, tuning: LqgTuning, figures: Mapping[str, LoopFigures], points: Points) -> list[str]:
        out = [f"bandwidth of the joints {tuning.bandwidth:.3g} rad/s, of the filter {tuning.filter:.3g} times that"]
        for name, x in figures.items():
            out.append(f"{len(points[name])} {name}, each of {len(points[name][0][1])} arms: stable, {x.words}")
        if self.arms.richer is not None:
            out.append("of these arms one has the next two modes per plane")
        margins = [loop_margins(closed_by(loops[0], law.at(x)), law.step) for x, loops in points["vertices"]]
        return out + [f"joint {j}, all vertices: {margin_words(x, law.step)}" for j, x in enumerate(worst(margins))]


def _stable(figures: LoopFigures) -> bool:
    """Whether nothing grows, but for fast modes that nothing damps by less than materials do."""
    return figures.decay > 0 and figures.margin >= -2 * GROWTH


def stronger(plant: SampledLoop, factor: float) -> SampledLoop:
    """A plant whose drives give more or less by a factor."""
    return replace(plant, B=factor * plant.B)
