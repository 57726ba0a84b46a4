"""The loop of control as a run samples it: whether it is stable at the run's step, and what would make it so.

A run holds the torques over each step, so a gain `kd` at a joint that feels the inertia J is stable up to a step of
about `2 J / kd`. A joint without a rotor feels little where the links that it carries bend: of an arm of 10 kg·m², for
instance, 1e-3 kg·m², and that allows 0.25 ms for kd = 8 N·m·s/rad. The judge is the integrator's own amplification
matrix (`stable_steps`) about postures of the run, with the law's derivatives as gains. A loop that the same integrator
does not bear without any gains is no matter of control: then the integrator is named.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from ..errors import ScrewgenError
from ..integrators.method import Method
from ..robot_model import RobotModel
from ..spec.parameters import turning
from .gains import Gain, Posture, gains_of, rounded_down
from .inputs import Inputs
from .integrate import DEFAULT
from .linearised import Linearised
from .linearised_loops import linearised
from .stable_steps import LinearisedMotions, first_failure, shown_time

GROWN = 100.0
"""What an oscillation may be multiplied by within a run."""
HALVINGS = 10
"""Of intervals of factors, which are then known to a few per cent at worst."""
MOST = 1e3
"""The largest rotor inertia that is proposed, over `kd h + kp h²`, and the inverse of the least."""


LARGEST = {False: 40, True: 100}
"""The most coordinates of a robot whose loop is examined before a run, and after one that failed: the derivatives take
time with their square, milliseconds for a dozen and seconds for a hundred."""


class ControlLoopWarning(UserWarning):
    """A loop of control that is unstable at the step of a run; the text is one line."""


@dataclass(frozen=True)
class Sampled:
    """What is examined: a model at parameters `p`, what acts on it, and the steps of a run."""

    model: RobotModel
    p: np.ndarray
    given: Inputs
    law: object
    method: Method | None
    step: float
    duration: float

    @property
    def controlled(self) -> bool:
        """Whether a controller acts."""
        return callable(self.law)

    def fault(self, postures: Iterable[Posture], ended: bool = False) -> str:
        """One line on the loop, with the remedies; empty where it is stable, or where nothing can be said.

        `ended`: whether the run has ended, so that any function may be asked for torques.
        """
        if self.method is None or not self.controlled or self.model.nq > LARGEST[ended]:
            return ""
        try:
            loops = [loop for x in postures if (loop := self._loop(x, self.method, ended)) and loop.unstable]
            return self._said(loops, self.method) if loops else ""
        except (ScrewgenError, np.linalg.LinAlgError):
            return ""

    def _loop(self, at: Posture, method: Method, ended: bool) -> PostureLoop | None:
        found = gains_of(self.law, self.model, self.p, at, ended)
        if not found:
            return None
        motion = linearised(self.model, at.q, at.v, None, None, self.given.constant_wrenches, self.p.tolist()).trimmed()
        return PostureLoop(motion, found, method, self.step, np.log(GROWN) / self.duration)

    def _said(self, loops: Sequence[PostureLoop], method: Method) -> str:
        at = f"unstable at a step of {shown_time(self.step, 3)}"
        if any(not loop.stable(0.0) for loop in loops):
            other = "" if method.name == DEFAULT else f"take {DEFAULT}; or "
            said = f"the integrator '{method}' is {at}, also without the controller"
            return f"{said}: {other}{_shorter(min(loop.longest() for loop in loops))}"
        factors = lowered(loops)
        rows = sorted({gain.joint for gain, s in zip(loops[0].gains, factors, strict=True) if s < 1})
        joints = [self.model.chain.axis_names[j] for j in rows]
        named = f"loop of joint '{joints[0]}' is" if len(joints) == 1 else f"loops of joints {_listed(joints)} are"
        lower = [gain.lowered(s) for gain, s in zip(loops[0].gains, factors, strict=True) if s < 1]
        remedies = [_shorter(min(loop.longest() for loop in loops)), f"lower {_listed(lower, quote='')}"]
        remedies += self._inertias(loops, rows)
        return f"with these gains the sampled {named} {at}: {'; or '.join(remedies)}"

    def _inertias(self, loops: Sequence[PostureLoop], rows: Sequence[int]) -> list[str]:
        """What rotors would help, where the joints have none."""
        links = self.model.robot.links
        stated = [link.joint.has_inertia(k) for link in links for k in range(len(link.joint.axes))]
        found = np.zeros(0) if any(stated[j] for j in rows) else inertias(loops, rows)
        if not found.size:
            return []
        values = _listed([f"{_rounded_up(x):g}" for x in found], quote="")
        unit = "kg·m²" if all(turning(self.model.robot)[j] for j in rows) else "kg·m² (slides: kg)"
        what = "inertia" if len(rows) == 1 else "inertias"
        return [f"state the {what} of the rotors, {values} {unit} or more (joint.armature)"]


class PostureLoop:
    """A loop about a posture, with any gains and rotors."""

    def __init__(self, motion: Linearised, gains: Sequence[Gain], method: Method, step: float, rate: float):
        self.motion, self.gains, self.method, self.step, self.rate = motion, gains, method, step, rate
        self.unstable = not self.stable()

    def held(self, factors: float | np.ndarray = 1.0, armature: np.ndarray | None = None) -> LinearisedMotions:
        """The motion with gains times `factors`, one or one for each, and the `armature` (nv,) of rotors besides."""
        motion = self.motion if armature is None else self.motion.with_armature(armature)
        each = np.broadcast_to(factors, len(self.gains))
        return LinearisedMotions(motion.with_gains(sum((s * g.slope for s, g in zip(each, self.gains, strict=True)))))

    def stable(self, factors: float | np.ndarray = 1.0, armature: np.ndarray | None = None) -> bool:
        """Whether nothing grows at the run's step."""
        return not self.held(factors, armature).grows(self.method, self.step, self.rate)

    def longest(self, factors: float | np.ndarray = 1.0) -> float:
        """The longest step, s, up to which nothing grows; 0 if there is none."""
        held = self.held(factors)
        steps = np.append(held.steps[held.steps < self.step], self.step)
        return first_failure(steps, lambda h: not held.grows(self.method, h, self.rate)) or 0.0


def lowered(loops: Sequence[PostureLoop]) -> np.ndarray:
    """The factors, 1 for most, by which gains must be lowered; as few of them as single trials find."""
    stable = lambda s: all(loop.stable(s) for loop in loops)  # noqa: E731
    count = len(loops[0].gains)
    common = largest(lambda s: stable(np.full(count, s)))
    factors = np.full(count, common)
    for k in range(count):
        trial = np.where(np.arange(count) == k, 1.0, factors)
        if stable(trial):
            factors = trial
    for k in np.flatnonzero(factors < 1).tolist():
        one = np.arange(count) == k
        factors = np.where(one, largest(partial(_with, stable, factors, one), float(factors[k])), factors)
    return factors


def _with(stable: Callable[[np.ndarray], bool], factors: np.ndarray, one: np.ndarray, s: float) -> bool:
    return stable(np.where(one, s, factors))


def largest(holds: Callable[[float], bool], low: float = 0.0) -> float:
    """The largest number up to 1 at which something holds that holds at `low`."""
    high = 1.0
    for _ in range(HALVINGS):
        middle = np.sqrt(low * high) if low else high / 4
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low


def inertias(loops: Sequence[PostureLoop], rows: Sequence[int]) -> np.ndarray:
    """The least inertias of rotors at joints `rows` that make the loops stable; empty if none do.

    They are in proportion to what the gains ask for, `kd h + kp h²`.
    """
    first, chain = loops[0], loops[0].motion.model.chain
    places = [chain.base_v + j for j in rows]
    wanted = np.zeros(chain.nv)
    for gain in first.gains:
        if gain.joint in rows:
            wanted[chain.base_v + gain.joint] += gain.size * first.step ** (1 if gain.of_rate else 2)
    stable = lambda s: all(loop.stable(1.0, s * wanted) for loop in loops)  # noqa: E731
    if not stable(MOST):
        return np.zeros(0)
    low, high = 1 / MOST, MOST
    for _ in range(HALVINGS):
        middle = np.sqrt(low * high)
        low, high = (low, middle) if stable(middle) else (middle, high)
    return high * wanted[places]


# ------------------------------------------------------------------------------ words


def _shorter(limit: float) -> str:
    return f"the step may be {shown_time(rounded_down(limit), 3)}" if limit else "no step is short enough"


def _rounded_up(x: float) -> float:
    scale = 10.0 ** (np.floor(np.log10(x)) - 1)
    return float(f"{np.ceil(x / scale) * scale:.3g}")


def _listed(names: Sequence[str], quote: str = "'") -> str:
    quoted = [f"{quote}{name}{quote}" for name in names]
    return quoted[0] if len(quoted) == 1 else f"{', '.join(quoted[:-1])} and {quoted[-1]}"
