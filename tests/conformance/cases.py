"""A robot of the matrix with its judge, its model and what is made of it once for all checks."""

from __future__ import annotations

from functools import cached_property, lru_cache
from pathlib import Path
from tempfile import mkdtemp

import flexible_robots as fr
import numpy as np
from helpers import model_of, quick

from conformance.arms import arm_of, varied
from conformance.drawn import drawn
from conformance.features import FACTORS, Row, features
from conformance.judge import Judge
from screwgen import Model
from screwgen.backends.c.recursive_slopes import is_chosen, is_offered
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.runtime.compiled import Compiled

STEP = 1e-3
DIFFERENCE = 4e-3
"""The longest step of differences, rad or m."""


class Case:
    """The robot of a row in a state; what is derived and compiled is kept while checks of one robot follow another."""

    step: float = STEP

    def __init__(self, row: Row, seed: int = 0, drawn: bool = False):
        """``drawn``: the robot has numbers of its own, those of `conformance.arms` changed at random."""
        self.row, self.seed, self.drawn = dict(row), seed, drawn

    def __repr__(self) -> str:
        return f"<robot with {', '.join(self.features) or 'nothing'}>"

    @property
    def features(self) -> tuple[str, ...]:
        return features(self.row)

    def without(self, names) -> Case:
        """The robot whose features of these names are plain."""
        row = tuple((f, next(iter(FACTORS[f])) if x in names else x) for f, x in self.row.items())
        return case_of(row, self.seed, self.drawn)

    @cached_property
    def judge(self) -> Judge:
        robot = arm_of(self.row)
        return drawn(self.row, varied(robot, np.random.default_rng(self.seed)) if self.drawn else robot, self.seed)

    @cached_property
    def folder(self) -> Path:
        return Path(mkdtemp(prefix="screwgen-conformance-"))

    @cached_property
    def robot(self) -> dict:
        """As the robot file has it; bodies from finite elements stand in files."""
        return fr.with_files(self.judge.robot, self.folder)

    @cached_property
    def model(self) -> Model:
        return model_of(self.robot)

    @property
    def given(self) -> tuple[np.ndarray, ...]:
        """q, v, tau, w_ext."""
        return self.judge.given

    @cached_property
    def acting(self) -> np.ndarray:
        """The inputs as a step holds them: those beyond the limits of the robot file are cut off there."""
        return self.judge.limits.held(self.given[2])

    def acting_at(self, v: np.ndarray) -> np.ndarray:
        """The same in another state, of rates and internal states ``v``."""
        limits = self.judge.limits
        return limits.held(self.given[2], v[len(v) - len(limits.z) :])

    def energy(self, functions, q, v, tau, *p):
        """Kinetic and potential; of the inputs too where these act on forces between frames."""
        of = functions["energy"] if p else functions.energy
        return of(q, v, *(tau,) * self.model.chain.chooses_forces, *p)

    @property
    def tolerance(self) -> float:
        """Of the judge: the larger of 1e-10 and 50 eps cond."""
        return self.judge.tolerance

    @property
    def agreement(self) -> float:
        """Between back ends in double precision: a hundredth of that, not below 1e-12."""
        return max(1e-12, self.tolerance / 100)

    @property
    def solved(self) -> float:
        """The same of what is solved for, accelerations and what follows from them: not below 5 eps cond, as two
        roundings of one solution differ by some eps cond."""
        return max(self.agreement, 5 * np.finfo(float).eps * self.judge.condition)

    @cached_property
    def compiled(self) -> dict[tuple, Compiled]:
        return {}

    def c(self, layout: str = "auto", **options) -> Compiled:
        """The generated C, compiled without optimisation."""
        key = (layout, *sorted(options.items()))
        if key not in self.compiled:
            self.compiled[key] = quick(self.model, layout=layout, **options)
        return self.compiled[key]

    @property
    def differentiated(self) -> list[Compiled]:
        """The C with derivatives, by recursion too where the robot can have them so."""
        chain = self.model.chain
        layouts = ("auto", "modular") if is_offered(chain) and not is_chosen(chain, "auto") else ("auto",)
        return [self.c(layout, derivatives=True) for layout in layouts]

    # ------------------------------------------------------------------------------- changes of coordinates

    def moved(self, q, change) -> np.ndarray:
        """Coordinates after a small change (nv,), of quaternions by the exponential."""
        return np.array(self.model.chain.integrate(np.asarray(q, float), change, SERIES))

    def change(self, before, after) -> np.ndarray:
        """(nv,): the change from one set of coordinates to another near it."""
        return np.array(self.model.chain.difference(np.asarray(before, float), np.asarray(after, float), SERIES))

    @property
    def sizes(self) -> np.ndarray:
        """(nv,): how far each coordinate moves for a difference of functions."""
        return np.where(np.arange(self.model.nv) < self.model.chain.eta_v, 1.0, 0.05)

    def differences(self, f, h: float = DIFFERENCE) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Slopes of ``f(q, v, tau) -> (m,)`` with q (m, nv), v, tau, by differences extrapolated twice.

        A step is shortened where its two extrapolations do not agree, as beside the corner of a stop that lets go."""
        q, v, tau, _ = self.given
        nv, end = self.model.nv, self.model.nv + len(v)

        def at(x):
            return np.ravel(f(self.moved(q, x[:nv]), v + x[nv:end], tau + x[end:]))

        # inputs act all but linearly, and over a step so little that short differences are those of rounding
        internal = np.full(len(v) - nv, 0.05)
        sizes = np.concatenate([self.sizes, self.sizes, internal, np.full(len(tau), 25.0)])
        found = np.array(
            [slope(at, h * size * e) / (h * size) for size, e in zip(sizes, np.eye(len(sizes)), strict=True)]
        )
        found = found.reshape(len(sizes), -1).T
        return found[:, :nv], found[:, nv:end], found[:, end:]


def slope(f, x: np.ndarray, smooth: float = 1e-6) -> np.ndarray:
    """The slope of f at 0 along x, by differences extrapolated twice: of the steps 1, 1/8, 1/64 and 1/512 the first
    whose extrapolations agree within a share of the largest entry, or else the one that comes closest to that."""
    best, least = np.zeros(0), np.inf
    for way in (1.0, 0.125, 0.015625, 0.001953125):
        a, b, c = ((f(x * s) - f(-x * s)) / (2 * s) for s in (way, way / 2, way / 4))
        once, twice = (4 * b - a) / 3, (4 * c - b) / 3
        apart = np.abs(twice - once).max(initial=0.0) / max(np.abs(twice).max(initial=0.0), np.finfo(float).tiny)
        if apart < least:
            best, least = (16 * twice - once) / 15, apart
        if least <= smooth:
            break
    return best


@lru_cache(maxsize=3)
def case_of(row: tuple[tuple[str, str], ...], seed: int = 0, drawn: bool = False) -> Case:
    """The case of a row; the last few are kept."""
    return Case(dict(row), seed, drawn)
