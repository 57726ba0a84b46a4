"""Why nothing balances a robot: the errors of a search for rest, which name the joint or the link."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import UsageError
from ..spec.parameters import changes

if TYPE_CHECKING:
    from .statics import Balance, Statics


class NoEquilibriumError(UsageError):
    """Torques that no posture balances; the text names the joint."""


def overbent(statics: Statics, b: Balance) -> NoEquilibriumError:
    """The error that names the link which its load bends by its own length."""
    chain = statics.model.chain
    k = chain.eta_v + int(np.argmax(np.abs(chain.flat(b.q) / statics.reach)[chain.eta_v :]))
    return NoEquilibriumError(
        f"{list(changes(statics.model.robot))[k]}: the search leaves what a model of small deflections can say, "
        "bending the link by its own length; stiffen the link, take load off it, or hold the joints elsewhere"
    )


def unbalanced(statics: Statics, b: Balance, start: np.ndarray) -> NoEquilibriumError:
    """The error that names the joint which turned and turned, or else has the largest unbalanced share."""
    away = statics.wandered(b.q, start)
    k = int(away[0]) if away.size else int(np.argmax(b.shares))
    joint = k < statics.model.chain.eta_v
    travel = statics.model.chain.travels.get(k) if k < statics.model.n_joints else None
    kind, unit = ("torque", "N·m") if statics.turning[k] else ("force", "N")
    kind, unit = (travel.EFFORT_NAME, travel.EFFORT_UNIT) if travel else (kind, unit)
    what = f"its {kind} of {statics.load[k]:.6g} {unit}" if joint and statics.load[k] else "its load"
    what += ", with the wrenches on the tips" if statics.w_ext.any() else ""
    return NoEquilibriumError(
        f"{list(changes(statics.model.robot))[k]}: no posture found balances {what}; "
        "give loads that weight and springs can balance, start elsewhere, or hold the joints"
    )
