"""The gains of a controller about a posture: the derivatives of its torques by coordinates and rates."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from ..backends.numpy.dae_step import space_of
from ..robot_model import RobotModel
from .captured_state import CapturedState
from .controllers import PD
from .inputs import Inputs
from .linearised import DIFFERENCE, slopes_of

BEFORE, AFTER = 0.02, 2.0
"""How long a function in Python may be asked for its gains before a run, and after one that failed, s."""
WIDER = 10.0
"""A second width of differences, over the first: where the two disagree the law is not smooth."""
ALIKE = 1e-3
"""The largest difference of the two, relative to the largest gain of the torque."""


class Posture(NamedTuple):
    """Where a law is examined: a time, s, and coordinates (nq,) and rates (nv,)."""

    t: float
    q: np.ndarray
    v: np.ndarray


@dataclass(frozen=True)
class Gain:
    """How the torque of a joint follows the coordinates, or the rates."""

    joint: int
    of_rate: bool
    size: float
    """At the joint's own coordinate: N·m/rad or N·m·s/rad, of slides N/m or N·s/m."""
    slope: np.ndarray
    """(n_tau, 2 nv): the torques by changes and rates of the coordinates."""
    name: str
    stated: bool
    """Whether the name is that of a number which the user states, such as `kd[0]`."""

    def lowered(self, factor: float) -> str:
        """What to do with it, such as `kd[0] to 0.4`."""
        now, then = self.size, rounded_down(factor * self.size)
        return f"{self.name} to {then:g}" if self.stated else f"{self.name} from {now:.3g} to {then:g}"


def rounded_down(x: float) -> float:
    """A number >= 0 to two digits."""
    if x <= 0:
        return 0.0
    scale = 10.0 ** (np.floor(np.log10(x)) - 1)
    return float(f"{np.floor(x / scale) * scale:.3g}")


def gains_of(law: Any, model: RobotModel, p: np.ndarray, at: Posture, ended: bool) -> list[Gain]:
    """The gains of a started law, two for each joint; none where they cannot be had.

    Of a :class:`PD` those of its numbers, without limits and without the help against gravity. Those of another
    function of `(t, q, v)` are estimated by differences, if it is smooth and quick: before a run only if it has no side
    effects (`pure`), after one in any case.
    """
    plain = isinstance(law, PD) and law.proportional
    if plain and law.efforts is None and law.ahead_of_joints is None:
        return _by_joint(_stated(law, model), law, model)
    if plain:
        law = replace(law, tau_max=None, gravity=None)
    given, space = Inputs(model, law, None), space_of(model.chain)
    torque = lambda q, v: given(at.t, q, v)[0]  # noqa: E731
    seen = CapturedState(law)
    if not (plain or ended or seen.admissible):
        return []
    try:
        if not plain and _lasts(torque, at) * 8 * model.nv > (AFTER if ended else BEFORE):
            return []
        G = slopes_of(torque, at.q, at.v, space, model.nv)
        if not plain and not _smooth(G, slopes_of(torque, at.q, at.v, space, model.nv, WIDER * DIFFERENCE)):
            return []
    except Exception:  # a function of the user's, at states that it may not know; the run shows what is wrong
        return []
    finally:
        seen.restore()
    return _by_joint(G, law if plain else None, model)


def _stated(law: PD, model: RobotModel) -> np.ndarray:
    """The derivatives of a law without transmissions, from its gains."""
    places = np.arange(model.chain.base_v, model.chain.base_v + model.n_joints) if law.driven is None else law.driven
    G, rows = np.zeros((model.n_tau, 2 * model.nv)), np.arange(model.n_joints)
    for gains, first in ((law.kp, 0), (law.kd, model.nv)):
        G[rows, first + np.array(places, int)] = -np.array(gains) / law.own_ratios**2
    return G


def _lasts(torque: Callable[[np.ndarray, np.ndarray], object], at: Posture) -> float:
    """How long a call takes, s: the second, since a first one may prepare something."""
    torque(at.q, at.v)
    clock = time.perf_counter()
    torque(at.q, at.v)
    return time.perf_counter() - clock


def _smooth(G: np.ndarray, other: np.ndarray) -> bool:
    most = np.abs(G).max(axis=1, initial=0.0)[:, None]
    return bool(np.isfinite(G).all() and (np.abs(G - other) <= ALIKE * most + DIFFERENCE).all())


def _by_joint(G: np.ndarray, law: PD | None, model: RobotModel) -> list[Gain]:
    """Each row of the derivatives in its halves, those of other inputs left out."""
    chain, out = model.chain, []
    for j, row in enumerate(G[: model.n_joints]):
        joint = chain.axis_names[j]
        for of_rate in (False, True):
            slope, half = np.zeros_like(G), slice(of_rate * model.nv, (1 + of_rate) * model.nv)
            slope[j, half] = row[half]
            if law is not None:
                key = "kd" if of_rate else "kp"
                out.append(Gain(j, of_rate, getattr(law, key)[j], slope, f"{key}[{j}]", True))
            elif slope.any():
                what = "rate" if of_rate else "coordinate"
                size = float(np.abs(row[half]).max())
                out.append(Gain(j, of_rate, size, slope, f"the gain of '{joint}' on its {what}", False))
    return out
