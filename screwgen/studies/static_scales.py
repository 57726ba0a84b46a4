"""The sizes beside which a force left over at rest is nothing, and the units in which coordinates are stepped.

A round beam bends in y and in z under a force across it, and the moments of both planes about its axis cancel: what
twists it is zero, but for rounding. No sum of forces can be the measure of that zero. So loads are measured before they
cancel: a weight or a force acts on a coordinate with a lever, which is at most its size times how far the coordinate
moves what it carries. That is ``m g √(M_kk/m)``, with the mass m carried and the entry M_kk of the mass matrix.

Coordinates differ in units and stiffness. A force f on a coordinate of the stiffness k does the work of ``f²/k``, so
that ``f/√k`` of all coordinates compare.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..robot_model import RobotModel
from ..spec.parameters import changes
from ..topology.chain import Chain
from ..topology.tree import BASE
from .stiffness import stiffness, stiffness_matrix


class Carried(NamedTuple):
    """What every coordinate of a robot carries."""

    mass: np.ndarray
    """(nv,): of its link and of all behind it, kg."""
    lever: np.ndarray
    """(nv,): how far a change of the coordinate moves this mass, its root mean square: m/rad, or m/m."""
    turn: np.ndarray
    """(nv,): how much it turns what it carries: 1, or rad per m."""
    links: np.ndarray
    """(nv, n) of bool: the links that it carries."""


def carried(model: RobotModel, p: np.ndarray, reach: np.ndarray) -> Carried:
    """What coordinates carry where all are zero; `reach` (nv,): the change of each that is a turn of about 1 rad."""
    mass, lever = model.once_for("carried", p[3:], lambda: _masses(model, p))
    return Carried(mass, lever, 1 / reach, _behind(model.chain)[_links(model.chain)])


def _masses(model: RobotModel, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(nv,): the mass that each coordinate carries, and its lever."""
    straight, chain = np.array(model.chain.home), model.chain
    falling = np.concatenate([[0.0, 0.0, -1.0], p[3:]])
    weights = np.array(model.statics(straight, np.zeros((6, chain.n)), falling)[4])[3:]
    mass = np.linalg.norm(weights, axis=0)[_links(chain)]
    inertia = np.diag(model.numpy(p).mass_matrix(straight))
    return mass, np.sqrt(np.divide(inertia, mass, out=np.ones(len(mass)), where=mass > 0))


def _links(chain: Chain) -> np.ndarray:
    """(nv,): the link of each coordinate, of a joint the one that it moves."""
    offsets = (chain.tau_offset, chain.theta_offset, chain.eta_offset)
    return np.concatenate([np.repeat(np.arange(chain.n), np.diff(places)) for places in offsets])


def _behind(chain: Chain) -> np.ndarray:
    """(n, n) of bool: in each row a link with all that it carries."""
    out = np.eye(chain.n, dtype=bool)
    for link in reversed(range(chain.n)):
        if (parent := chain.tree.parents[link]) != BASE:
            out[parent] |= out[link]
    return out


def largest_loads(model: RobotModel, p: np.ndarray, w_ext: np.ndarray, others: np.ndarray, of: Carried) -> np.ndarray:
    """(nv,): what weight, wrenches on tips and tensions do to each coordinate at most, before any of them cancel."""
    moments, forces = (np.linalg.norm(part, axis=1) for part in np.split(w_ext, 2, axis=1))
    force = of.mass * np.linalg.norm(p[:3]) + of.links @ forces
    out = force * of.lever + (of.links @ moments) * of.turn
    straight = np.array(model.chain.home)
    tensions = others[: model.chain.n_tensions]
    for k in np.flatnonzero(tensions):
        alone = np.where(np.arange(len(tensions)) == k, tensions, 0.0)
        out = out + np.abs(np.array(model.tendon_work(straight, alone, p)[1])[:, 0])
    return out


def step_units(model: RobotModel, p: np.ndarray, loads: np.ndarray) -> np.ndarray:
    """(nv,): D, such that D q has stiffnesses about one: by springs and gears, and of a joint by its largest load."""
    joint, own = np.arange(model.nv) < model.n_joints, stiffness(model, p)
    if model.chain.n_added:
        own = np.diag(stiffness_matrix(model, p))
    own = own + np.where(joint, loads, 0.0)
    return np.sqrt(np.where(own > 0, own, 1.0))


def turns(model: RobotModel) -> np.ndarray:
    """(nv,) of bool: whether a coordinate is an angle."""
    return np.array([unit == "rad" for unit in changes(model.robot).values()], bool)
