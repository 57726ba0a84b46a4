"""Which joints of an arm at rest are held, and the efforts that act beside what holds them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..arguments import Numbers, choice
from ..errors import UsageError
from ..robot_model import RobotModel
from .linear import checked

Hold = bool | str | Sequence[str]
"""Whether joints are held: all but those with springs, "all" of them, or those that are named."""


class Asked(NamedTuple):
    """The joints that are to be held, (n_joints,) of bool each."""

    joints: np.ndarray
    held: np.ndarray
    """Of these joints those that drives hold: an axis with a spring is left to it, unless it is asked for by name."""
    by_name: bool
    """Whether each was named, so that none may follow loops."""
    at_all: bool
    """Whether holding is asked for, be there joints or not."""

    @property
    def preferred(self) -> np.ndarray | None:
        """The joints to state before others where loops leave a choice; None where all are asked for."""
        return None if self.joints.all() else self.held

    def following(self, stated: np.ndarray) -> np.ndarray:
        """Those that loops leave to follow the `stated` ones."""
        return self.joints & ~stated


def asked(model: RobotModel, hold: Hold, free: Sequence[str], sprung: np.ndarray) -> Asked:
    """The joints that the arguments of `equilibrium` hold; `sprung` (n_joints,): those with springs.

    Those whose motion is given are held by that.
    """
    given = np.isin(np.arange(model.n_joints), model.chain.prescribed)
    if isinstance(hold, str):
        choice(hold, ("all",), "hold: True, False, 'all' or a list of names; there is no")
    if not isinstance(hold, bool | str):
        if len(free):
            raise UsageError("hold and free both name joints; name those to hold, or those to leave free")
        named = _named(model, hold, "hold") | given
        return Asked(named, named, True, True)
    at_all, freed = bool(hold) or len(free) > 0, _named(model, free, "free")
    if stuck := [joint_names(model)[k] for k in np.flatnonzero(freed & given)]:
        raise UsageError(f"free: the motion of {stuck[0]} is given; leave it out")
    joints = (~freed & at_all) | given
    held = joints if hold == "all" else joints & (~sprung | given)
    return Asked(joints, held, False, bool(at_all or given.any()))


def joint_names(model: RobotModel) -> list[str]:
    """The names of the axes of joints (n_joints), see `Chain.axis_names`."""
    return model.chain.axis_names


def _named(model: RobotModel, names: Sequence[str], what: str) -> np.ndarray:
    """(n_joints,) of bool: the joints that names of coordinates or of links stand for."""
    coordinates = joint_names(model)
    links = dict.fromkeys(name.rpartition(".")[0] for name in coordinates)
    out = np.zeros(model.n_joints, bool)
    for name in [names] if isinstance(names, str) else names:
        choice(name, (*links, *coordinates), f"{what}: there is no joint")
        out |= [name in (one, one.rpartition(".")[0]) for one in coordinates]
    return out


def refuse_followers(model: RobotModel, wanted: Asked, stated: np.ndarray) -> None:
    """Raise UsageError where a joint that was named follows the loops while the others are held."""
    if wanted.by_name and (followers := np.flatnonzero(wanted.following(stated))).size:
        name = joint_names(model)[followers[0]]
        raise UsageError(f"hold: {name} follows the loops while the others are held; leave it out, or one of them")


def efforts_beside(model: RobotModel, tau: Numbers | None, held: np.ndarray, at_all: bool) -> np.ndarray:
    """The torques and tensions (n_tau,) that are given; those of joints in `held` (n_joints,) are found, so zero here.

    `at_all`: whether joints are held; then `tau` may be the inputs behind torques alone.
    """
    if tau is not None and at_all and np.size(tau) == model.n_tau - model.n_joints != model.n_tau:
        tau = np.append(np.zeros(model.n_joints), np.ravel(tau))
    out = checked(tau, "tau", model.n_tau)
    if (given := np.flatnonzero(held & (out[: model.n_joints] != 0))).size:
        name = model.tau_names[given[0]]
        raise UsageError(f"tau: {name} is found, as its joint is held; leave it at zero, or leave the joint free")
    return out
