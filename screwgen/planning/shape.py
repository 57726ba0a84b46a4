"""Scheduled shapers of a robot: what vibrates is found over postures and payloads, and fitted by polynomials."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from ..arguments import Given, Numbers, array, choice, whole
from ..errors import UsageError
from ..robot_model import RobotModel
from .make import law_of
from .members import Still
from .refusals import GIVEN, refuse_robot
from .sampled_loop import LoopGains
from .scheduled_shaper import MOST_DEGREE, MOST_MODES, MOST_TERMS, FittedMode, ScheduledShaper
from .shapers import KINDS, LOCKED, LOOP
from .vibrations import DampedModes, followed, poles, slowest, vibrations

DEGREE = 4
CHECKED = 50
"""Postures at which it is looked at what is left; none of them is one of those that are fitted."""
PER_TERM, LEVELS, WAY = 4, 5, 7
"""Postures for each term of the polynomials, payloads, and postures on the way to each."""
SEED = 7


class Payload(NamedTuple):
    """A parameter that changes from motion to motion, by name, and between what, in its unit."""

    name: str
    lower: float
    upper: float


def shape(
    model: RobotModel,
    lower: Numbers,
    upper: Numbers,
    *,
    gains: Any = None,
    free: Numbers = (),
    payload: tuple[str, float, float] | None = None,
    kind: str = "zv",
    modes: int = 1,
    degree: int = DEGREE,
    parameters: Given = None,
) -> ScheduledShaper:
    """The shaper of the references of the joints, scheduled over postures from `lower` to `upper` (n_joints,).

    `gains`: a law with `kp` and `kd`, such as a :class:`PD`; what vibrates are then the poles of its closed loop.
    Without, joints are taken to follow their references exactly, as with a feedforward that knows the elastic
    motion, and what vibrates is the arm with joints locked, of elastic gears the rotors. `free`: numbers of joints that
    no drive moves, as that of a rope; under a law those without gains are free.
    `payload`: a parameter's name with its least and largest value. `modes`: how many of the slowest; `kind` as for
    :func:`shaper`. `degree`: of the polynomials of frequencies and damping ratios.

    Raises UsageError, also where fewer motions swing than are asked for.
    """
    refuse_robot(model, "scheduled shaper", "take screwgen.shaper with frequencies of your own", [GIVEN])
    m, names = model.n_joints, tuple(model.q_names[: model.n_joints])
    kind, modes = choice(kind, KINDS, "kind: there is no"), whole(modes, "modes", 1, MOST_MODES)
    degree = whole(degree, "degree", 0, MOST_DEGREE)
    low, high = array(lower, "lower:", (m,)), array(upper, "upper:", (m,))
    if (above := np.flatnonzero(low > high)).size:
        said = f"{low[above[0]]:g} of {names[above[0]]} is above {high[above[0]]:g}"
        raise UsageError(f"lower, upper (--from, --to): {said}; give the lesser one first")
    loop = _loop(gains, free, m)
    load = None if payload is None else _payload(model, payload)
    arm = Arm(model, model.chain.parameters.vector(parameters), loop, low, high, load)
    variables = tuple(names[j] for j in arm.varied) + ((load.name,) if load else ())
    box = np.array([low[arm.varied], high[arm.varied]])
    box = np.hstack([box, [[load.lower], [load.upper]]]) if load else box
    rows = [x for x in product(range(degree + 1), repeat=len(variables)) if sum(x) <= degree]
    powers = np.array(rows, int).reshape(len(rows), len(variables))
    if len(powers) > MOST_TERMS:
        raise UsageError(
            f"degree: {degree} takes {len(powers)} terms; take a smaller one, or fix joints by equal bounds"
        )
    fitted = _fitted(arm, powers, box, modes)
    law = LOOP if gains is not None else LOCKED
    made = ScheduledShaper(model.robot.name, kind, law, names, variables, box[0], box[1], powers, fitted)
    return _judged(made, arm, box)


class Arm:
    """What vibrates of a robot over postures and payloads; each motion is followed from the middle of the range."""

    def __init__(
        self, model: RobotModel, p: np.ndarray, loop: LoopGains, low: np.ndarray, high: np.ndarray, load: Payload | None
    ):
        self.model, self.p, self.loop, self.load = model, p, loop, load
        self.low, self.high = low, high
        self.varied = np.flatnonzero(low < high)
        self.middles: dict[float, tuple[Still, np.ndarray]] = {}

    def vibrations(self, places: np.ndarray, modes: int) -> list[DampedModes]:
        """At each place (places, V)."""
        return [vibrations(self._followed(place, modes)) for place in places]

    def _followed(self, place: np.ndarray, modes: int) -> np.ndarray:
        """The poles at a place, on a straight way from the middle posture on."""
        middle, posture = (self.low + self.high) / 2, self.low.copy()
        posture[self.varied] = place[: len(self.varied)]
        still, found = self._middle(float(place[-1]) if self.load else np.nan, modes)
        for share in np.linspace(0.0, 1.0, WAY)[1:]:
            joints = middle + share * (posture - middle)
            found = followed(found, poles(still, joints, self.loop), joints)
        return found

    def _middle(self, load: float, modes: int) -> tuple[Still, np.ndarray]:
        """The poles at the middle posture under a payload."""
        key = 0.0 if np.isnan(load) else load
        if key not in self.middles:
            middle = (self.low + self.high) / 2
            still = Still(self.model, self.p if self.load is None else self._loaded(load))
            found = poles(still, middle, self.loop)
            near = min(self.middles, key=lambda x: abs(x - key), default=None)
            found = slowest(found, modes, middle) if near is None else followed(self.middles[near][1], found, middle)
            self.middles[key] = still, found
        return self.middles[key]

    def _loaded(self, value: float) -> np.ndarray:
        assert self.load is not None
        p = self.p.copy()
        p[self.model.parameter_names.index(self.load.name)] = value
        return self.model.chain.parameters.vector(p)


def _fitted(arm: Arm, powers: np.ndarray, box: np.ndarray, modes: int) -> tuple[FittedMode, ...]:
    """Polynomials by least squares over a sequence of low discrepancy, and the corners of the box."""
    places = _on_levels(np.vstack([drawn(box, PER_TERM * len(powers), SEED), [*product(*box.T)]]), arm, box, LEVELS)
    found = arm.vibrations(places, modes)
    scaled = 2 * (places - box[0]) / (box[1] - box[0]) - 1
    terms = np.prod(scaled[:, None, :] ** powers, axis=2)
    out = []
    for k in range(modes):
        both = np.array([[x.frequencies[k], x.damping[k]] for x in found])
        least, most = both.min(axis=0).tolist(), both.max(axis=0).tolist()
        f, z = np.linalg.lstsq(terms, both, rcond=None)[0].T
        out.append(FittedMode(f, z, (least[0], most[0]), (least[1], most[1])))
    return tuple(out)


def _on_levels(places: np.ndarray, arm: Arm, box: np.ndarray, levels: int) -> np.ndarray:
    """Places whose payloads are a few: each is a model of its own. The middle ones come first."""
    if arm.load is None:
        return places
    own = np.cos(np.pi * np.arange(levels) / (levels - 1))
    own = box[0, -1] + (own + 1) / 2 * (box[1, -1] - box[0, -1])
    places[:, -1] = own[np.abs(places[:, -1:] - own).argmin(axis=1)]
    return places[np.argsort(np.abs(places[:, -1] - box[:, -1].mean()), kind="stable")]


def drawn(box: np.ndarray, count: int, seed: int) -> np.ndarray:
    """Places (count, V) that fill a box (2, V) evenly, the same in every run."""
    from scipy.stats.qmc import Halton

    if not box.shape[1]:
        return np.zeros((count, 0))
    return box[0] + Halton(box.shape[1], seed=seed).random(count) * (box[1] - box[0])


def _judged(made: ScheduledShaper, arm: Arm, box: np.ndarray) -> ScheduledShaper:
    """The shaper with what it leaves at postures of a grid of their own, with payloads of their own."""
    places = _on_levels(drawn(box, CHECKED if box.size else 1, SEED + 1), arm, box, LEVELS - 1)
    left = [
        max(float(made.at(place).residual(f, z)) for f, z in zip(*true, strict=True))
        for place, true in zip(places, arm.vibrations(places, len(made.modes)), strict=True)
    ]
    return replace(made, residual=max(left), table=np.column_stack([places, left]))


def _loop(gains: Any, free: Numbers, m: int) -> LoopGains:
    """Gains, or joints locked but those that are free."""
    if gains is not None:
        law = law_of(gains, m)
        return LoopGains(law.kp, law.kd)
    kp = np.full(m, np.inf)
    for j in np.atleast_1d(np.asarray(free, int)) if np.size(free) else ():
        kp[whole(int(j), "free", 0, m - 1)] = 0.0
    return LoopGains(kp, np.zeros(m))


def _payload(model: RobotModel, given: tuple[str, float, float]) -> Payload:
    name, low, high = given
    if name not in model.parameter_names:
        raise UsageError(f"payload: there is no parameter '{name}'; model.parameter_names lists them")
    low, high = (array(x, f"payload: {name}:", ()).item() for x in (low, high))
    if not low < high:
        raise UsageError(f"payload: {name}: the largest value must be above the least")
    return Payload(name, low, high)
