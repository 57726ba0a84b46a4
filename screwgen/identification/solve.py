"""Levenberg and Marquardt on the numbers that are free, the states in which windows begin eliminated by QR.

Of each window the rows [J_x J_p r] are triangularised. What is left below the states' rows holds J_p and r without
what states can make good; it is small, so that several dampings are tried, all as lanes of one rollout.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from .problem import MeasuredCases, Problem

DAMPINGS = (1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0)
"""The factors of the damping that are tried together."""
MARQUARDT = 0.25
"""Steps are damped by the size of columns to this power: 0 is Levenberg's way, which moves little what the data hardly
feel, 1 Marquardt's, which heeds no scales. All is sought in logarithms or over its scale."""
WORSE, MUCH = (2.0, 1.0), 0.05
"""How many times its cost before makes that of a window worse: then its start takes a shorter step. The second is tried
where with the first no step lessens the cost of all by this share."""
CALMED = (1e2, 1e4, 1e6, 1e8, 1e10, 1e12)
"""The dampings of the starts of windows that are tried where a window gets worse, beside their deviations' own 1."""
FIRST, LEAST, MOST = 1e-3, 1e-9, 1e9
SMALL, SHARE = 0.2, 3e-3
"""A step that lessens the cost by less, residuals with much in common counted as fewer, and by less than this share
ends the fit."""
STILL = 0.02
"""So does a step of numbers that have less than this to gain, a fifth of their deviations: starts of windows may creep
on where joints stick."""
LONGEST = 1.5
"""The longest step: a logarithm changes by no more, 4.5 times, nor another number by more of its scale."""
SETTLED = 3
"""How often the starts of windows alone are fitted."""
INTERRUPTED = "interrupted"
HUBER = 1.345
"""Beyond so many deviations a robust fit counts residuals by their size, no more by their square."""
MEDIAN = 0.6745
"""The median of normal deviates."""
EXACT = 1e-6
"""The least noise that is believed, over how much a column varies."""


@dataclass
class Estimate:
    """Where a fit stands: what is sought (k,), the starts of windows (W, states) of each log, and residuals."""

    sought: np.ndarray
    shift: list[np.ndarray]
    noise: np.ndarray
    """(sensors,): standard deviations, in units of columns."""
    differences: list[np.ndarray]
    cost: float
    history: list[float] = field(default_factory=list)
    """Of every iteration the cost."""
    stopped: str = ""
    """Why the fit ended before it converged."""


@dataclass(frozen=True, eq=False)
class StateFree:
    """The linear least squares of a step: of each window the rows of its states, and what is left of all."""

    states: list[list[tuple[np.ndarray, np.ndarray, np.ndarray]]]
    """By log and window: R_xx, R_xp, r_x."""
    R: np.ndarray
    r: np.ndarray

    def step(self, damping: float, free: np.ndarray) -> tuple[np.ndarray, list[np.ndarray]]:
        """The step of what is sought (k,), and of the starts of windows."""
        k = self.R.shape[1]
        size = np.linalg.norm(self.R, axis=0)
        most = np.max(size, initial=0.0) or 1.0
        scale = np.sqrt(damping) * most * np.maximum(size / most, 1e-12) ** MARQUARDT
        own = np.vstack([self.R, np.diag(scale)])[:, free]
        found = np.zeros(k)
        found[free] = -np.linalg.lstsq(own, np.concatenate([self.r, np.zeros(k)]), rcond=None)[0]
        found *= min(1.0, LONGEST / np.max(np.abs(found), initial=LONGEST))
        return found, [self.begun(k, found, range(len(log)), 0.0) for k, log in enumerate(self.states)]

    def to_gain(self, free: np.ndarray) -> float:
        """How much less the cost would be, were all linear, with the best of what is sought."""
        own = self.R[:, free]
        return float(np.sum((own @ np.linalg.lstsq(own, self.r, rcond=None)[0]) ** 2)) / 2

    def begun(self, log: int, step: np.ndarray, windows: Iterable[int], damping: float) -> np.ndarray:
        """The steps (windows, states) of the starts of some windows of a log that go with a step of what is sought."""
        parts = [self.states[log][w] for w in windows]
        calm = np.sqrt(damping) * np.eye(len(parts[0][0]))
        rows = [(np.vstack([a, calm]), np.append(c + b @ step, np.zeros(len(a)))) for a, b, c in parts]
        return np.array([-np.linalg.lstsq(a, r, rcond=None)[0] for a, r in rows])


class Fit:
    """The fit of a problem."""

    def __init__(self, problem: Problem, robust: bool, progress: Callable[[str], None] | None = None):
        self.problem, self.robust, self.progress = problem, robust, progress
        self.priors = problem.unknowns.priors
        self.low, self.high = problem.unknowns.bounds
        spread = [np.broadcast_to(group.spread, group.compared.shape) for group in problem.groups]
        self.varies = np.sqrt(np.nanmean(problem.of_all(spread) ** 2, axis=0))
        self.stated = np.full(len(problem.sensor_names), np.nan)
        for group in problem.groups:
            self.stated[problem.own(group)] = group.stated

    def run(self, iterations: int, sought: np.ndarray) -> Estimate:
        """The estimate when it has converged, or where it is after so many iterations or an interruption."""
        at = self.start(sought)
        try:
            for _ in self._improved(at, iterations):
                if self.progress:
                    self.progress(self._line(at))
        except KeyboardInterrupt:
            at.stopped = INTERRUPTED
        return at

    def begun(self, sought: np.ndarray) -> Estimate:
        """The estimate with these numbers, in which the starts of windows alone are fitted."""
        at, none = self.start(sought), np.zeros(len(sought), bool)
        for _ in range(SETTLED):
            found = self._linearised(at)
            at = self._trial(at, self.reduced(at, found), 1.0, none)
        return at

    def _linearised(self, at: Estimate) -> list[tuple[np.ndarray, ...]]:
        """Differences and derivatives of every log, of which those and the noise become the estimate's."""
        pairs = zip(self.problem.groups, at.shift, strict=True)
        found: list[tuple[np.ndarray, ...]] = [group.linearised(self.problem, at.sought, own) for group, own in pairs]
        at.differences = [difference for difference, *_ in found]
        at.noise = self.noise(at.differences)
        return found

    def start(self, sought: np.ndarray) -> Estimate:
        """An estimate with these numbers (k,), whose windows begin where readings say."""
        groups = self.problem.groups
        shift = [np.zeros((len(group.compared), len(group.states))) for group in groups]
        return Estimate(sought.copy(), shift, self.varies.copy(), [], np.inf)

    def _improved(self, at: Estimate, iterations: int) -> Iterator[None]:
        """Improve the estimate in place, step by step."""
        damping = FIRST
        for _ in range(iterations):
            found = self._linearised(at)
            at.cost = self._cost(at.sought, at.shift, at.differences, at.noise)
            reduced = self.reduced(at, found)
            better, damping = self._searched(at, reduced, damping)
            if better is None:
                return
            gained = at.cost - better.cost
            share = self._independent(better.differences)
            done = gained < SHARE * at.cost and (
                gained * share < SMALL or reduced.to_gain(self._free(at, reduced)) * share < STILL
            )
            at.sought, at.shift, at.differences, at.cost = better.sought, better.shift, better.differences, better.cost
            at.history.append(at.cost)
            yield
            anew = gained < MUCH * at.cost and self._continued(at)
            if done and not anew:
                return
        at.stopped = f"not converged in {iterations} iterations"

    def _searched(self, at: Estimate, reduced: StateFree, damping: float) -> tuple[Estimate | None, float]:
        """A better estimate and the damping to go on with; None where no step lessens the cost."""
        free = self._free(at, reduced)
        while LEAST <= damping <= MOST:
            tried: list[Estimate] = []
            for worse in WORSE:
                tried += [self._trial(at, reduced, factor * damping, free, worse) for factor in DAMPINGS]
                best = min(range(len(tried)), key=lambda k: tried[k].cost)
                if tried[best].cost < (1 - MUCH) * at.cost:
                    break
            if tried[best].cost < at.cost:
                return tried[best], max(LEAST, damping * DAMPINGS[best % len(DAMPINGS)])
            damping *= DAMPINGS[-1] / DAMPINGS[0]
        return None, damping

    def _free(self, at: Estimate, reduced: StateFree) -> np.ndarray:
        """Of what is sought (k,) of bool: what its bounds let go where the cost falls."""
        gradient = reduced.R.T @ reduced.r
        return ~((at.sought <= self.low) & (gradient > 0) | (at.sought >= self.high) & (gradient < 0))

    def _trial(
        self, at: Estimate, reduced: StateFree, damping: float, free: np.ndarray, worse: float = WORSE[-1]
    ) -> Estimate:
        """The estimate after a step of some damping.

        Windows whose cost it makes so many times `worse` take shorter steps of their starts: where a joint sticks its
        start has no slope and the step no bound, and one such window among many would end the search.
        """
        step, begun = reduced.step(damping, free)
        sought = np.clip(at.sought + step, self.low, self.high)
        there = self.at(sought, [a + b for a, b in zip(at.shift, begun, strict=True)], at.noise)
        for log, group in enumerate(self.problem.groups):
            if len(group.states):
                steps = partial(reduced.begun, log, step)
                self._calm(log, at, there, worse, steps)
        there.cost = self._cost(sought, there.shift, there.differences, at.noise)
        return there

    def _calm(
        self, log: int, at: Estimate, there: Estimate, worse: float, steps: Callable[[np.ndarray, float], np.ndarray]
    ) -> None:
        """Shorten the steps of the starts of those windows of a log that are so many times `worse` `there`, in place.

        `steps` has them of some windows with a damping.
        """
        group = self.problem.groups[log]
        before, now = (self.costs(group, x.shift[log], x.differences[log], at.noise) for x in (at, there))
        for damping in CALMED:
            if not (windows := np.flatnonzero(now > worse * before)).size:
                break
            self._take(log, there, windows, at.shift[log][windows] + steps(windows, damping), now)

    def _continued(self, at: Estimate) -> bool:
        """Let windows begin where those before them end if that halves their costs; whether some do.

        The start of a window may be caught where no small step makes it better, as in a joint that sticks.
        """
        found = False
        for log, group in enumerate(self.problem.groups):
            if len(group.states):
                now = self.costs(group, at.shift[log], at.differences[log], at.noise)
                other = group.continued(self.problem, at.sought, at.shift[log])
                found |= self._take(log, at, np.arange(len(now)), other, now, 1 / WORSE[0])
        at.cost = self._cost(at.sought, at.shift, at.differences, at.noise)
        return found

    def _take(
        self, log: int, there: Estimate, windows: np.ndarray, other: np.ndarray, now: np.ndarray, share: float = 1.0
    ) -> bool:
        """Take `other` starts (windows, states) of windows of a log where their costs are less than a share of `now`.

        In place; whether some are.
        """
        group = self.problem.groups[log]
        found = group.differences(self.problem, windows, np.tile(there.sought, (len(windows), 1)), other)
        better = (own := self.costs(group, other, found, there.noise)) < share * now[windows]
        chosen = windows[better]
        there.shift[log][chosen], there.differences[log][chosen] = other[better], found[better]
        now[chosen] = own[better]
        return bool(better.any())

    def at(self, sought: np.ndarray, shift: list[np.ndarray], noise: np.ndarray) -> Estimate:
        """The estimate with these numbers and starts."""
        found = []
        for group, own in zip(self.problem.groups, shift, strict=True):
            lanes = np.arange(len(group.compared))
            found.append(group.differences(self.problem, lanes, np.tile(sought, (len(lanes), 1)), own))
        return Estimate(sought, shift, noise, found, self._cost(sought, shift, found, noise))

    # ------------------------------------------------------------------------------ cost

    def noise(self, differences: list[np.ndarray]) -> np.ndarray:
        """The deviation of each sensor: as stated, else one share of how much it varies, that of all residuals.

        What limits a fit is rarely the noise. A weight of each sensor by its own residuals would have one that is
        precise, such as an encoder, decide alone.
        """
        share = np.maximum(self.sizes(differences) / self.varies, EXACT)
        common = np.sqrt(np.mean(share[np.isnan(self.stated)] ** 2)) if np.isnan(self.stated).any() else 1.0
        return np.where(np.isnan(self.stated), common * self.varies, self.stated)

    def sizes(self, differences: list[np.ndarray]) -> np.ndarray:
        """The root mean square (sensors,) of residuals, of a robust fit what it would be without outliers."""
        rows = self.problem.of_all(differences)
        rows = np.where(np.isfinite(rows), rows, np.nan)
        return np.nanmedian(np.abs(rows), axis=0) / MEDIAN if self.robust else np.sqrt(np.nanmean(rows**2, axis=0))

    def correlations(self, differences: list[np.ndarray]) -> np.ndarray:
        """Of each sensor the correlation (sensors,) of a residual with the next one, 0 where none is next."""
        first, last = (
            np.nan_to_num(self.problem.of_all([x[:, part] for x in differences]))
            for part in (slice(None, -1), slice(1, None))
        )
        if not len(first):
            return np.zeros(first.shape[1])
        first, last = first - first.mean(axis=0), last - last.mean(axis=0)
        size = np.sqrt(np.sum(first**2, axis=0) * np.sum(last**2, axis=0))
        return np.asarray(np.sum(first * last, axis=0) / np.maximum(size, 1e-300))

    def _independent(self, differences: list[np.ndarray]) -> float:
        """The share of residuals that say something of their own."""
        found = np.clip(self.correlations(differences), 0.0, 1.0)
        return float(np.mean((1 - found) / (1 + found)))

    def _cost(
        self, sought: np.ndarray, shift: list[np.ndarray], differences: list[np.ndarray], noise: np.ndarray
    ) -> float:
        total = np.sum(((sought - self.priors[:, 0]) / self.priors[:, 1]) ** 2)
        for group, own, part in zip(self.problem.groups, shift, differences, strict=True):
            total += 2 * np.sum(self.costs(group, own, part, noise))
        return float(total) / 2

    def costs(self, group: MeasuredCases, shift: np.ndarray, found: np.ndarray, noise: np.ndarray) -> np.ndarray:
        """The costs (cases,) of cases of a group with these starts (cases, states) and differences."""
        r = np.abs(found / noise[self.problem.own(group)])
        r[np.isnan(r)] = 0.0
        own = np.where(r > HUBER, HUBER * (2 * r - HUBER), r**2) if self.robust else r**2
        return (np.sum(own, axis=(1, 2)) + np.sum(shift**2, axis=1)) / 2

    def weights(self, difference: np.ndarray, noise: np.ndarray) -> np.ndarray:
        """The factors of rows of residuals: 0 where there is no reading, less than one where a robust fit doubts it."""
        r = np.abs(difference / noise)
        doubt = np.sqrt(np.minimum(1.0, HUBER / np.maximum(np.nan_to_num(r), 1e-300))) if self.robust else 1.0
        return np.where(np.isnan(difference), 0.0, doubt / noise)

    def rows(self, group: MeasuredCases, at: Estimate, found: tuple[np.ndarray, ...], k: int) -> tuple[np.ndarray, ...]:
        """Residuals (rows,) of window k and their derivatives with states and with what is sought, weighted."""
        difference, by_p, by_x = (x[k] for x in found)
        weight = self.weights(difference, at.noise[self.problem.own(group)])
        r, J_p, J_x = weight * np.nan_to_num(difference), weight[..., None] * by_p, weight[..., None] * by_x
        return r.ravel(), np.nan_to_num(J_x.reshape(r.size, -1)), np.nan_to_num(J_p.reshape(r.size, -1))

    def reduced(self, at: Estimate, found: Sequence[tuple[np.ndarray, ...]]) -> StateFree:
        """The least squares of a step from differences and derivatives of every log, states of windows eliminated."""
        k, states = len(at.sought), []
        left = np.column_stack([np.diag(1 / self.priors[:, 1]), (at.sought - self.priors[:, 0]) / self.priors[:, 1]])
        for group, shift, own in zip(self.problem.groups, at.shift, found, strict=True):
            n, of_log = len(group.states), []
            for w in range(len(group.compared)):
                r, J_x, J_p = self.rows(group, at, own, w)
                prior = np.hstack([np.eye(n), np.zeros((n, k)), shift[w][:, None]])
                R = _triangle(np.vstack([np.column_stack([J_x, J_p, r]), prior]))
                of_log.append((R[:n, :n], R[:n, n:-1], R[:n, -1]))
                left = _triangle(np.vstack([left, R[n:, n:]]))
            states.append(of_log)
        return StateFree(states, left[:, :-1], left[:, -1])

    def worst(self, at: Estimate) -> float:
        """The largest share of a sensor's variation that is left."""
        return float(np.max(self.sizes(at.differences) / self.varies)) if at.differences else np.inf

    def _line(self, at: Estimate) -> str:
        """Where a fit stands, with the sensor that it explains worst."""
        names = self.problem.sensor_names
        share = self.sizes(at.differences) / self.varies
        worst = int(np.argmax(share))
        return f"iteration {len(at.history)}: {names[worst]} is {100 * share[worst]:.3g} % of its variation off"


def _triangle(rows: np.ndarray) -> np.ndarray:
    """The upper triangle with the same products of columns."""
    return np.asarray(np.linalg.qr(rows, mode="r"))
