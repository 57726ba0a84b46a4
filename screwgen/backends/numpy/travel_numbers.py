"""Transmissions of a robot in numbers: their travels, where elastic gears have their rotors, efforts behind torques."""

from __future__ import annotations

import numpy as np

from ...algorithms.travels import relation
from ...arguments import Numbers
from ...errors import SingularError
from ...topology.chain import Chain
from .numeric import EPSILON, function_of

NEWTONS, CLOSE = 20, 1e-14
"""Steps of the search for where a rigid gear would have a joint, and the last of them."""
DEAD = 1e-9
"""m/rad, of a linkage 1: a lever that counts as none."""


def travels(chain: Chain, q: Numbers, p: Numbers) -> np.ndarray:
    """(3, n_joints): ``l``, ``l'`` and ``l''`` of every axis at the joint coordinates ``q``; q, 1 and 0 without one.

    Raises SingularError where the length of a cylinder is zero, as parameters may make it, and where a linkage does not
    reach the link.
    """
    out = np.array([q, np.ones(chain.n_joints), np.zeros(chain.n_joints)], float)
    for i, place, travel, given in chain.travel_numbers(np.asarray(p, float).tolist()):
        at = float(q[place])
        try:
            found, guards = function_of(relation(travel))({"q": [at], "given": given}, EPSILON)
            length = travel.travel(at, *given)
        except (ZeroDivisionError, ValueError):
            guards = [0.0]
        if not all(x > 0 for x in guards):
            raise chain.singular(i)
        out[:, place] = length, *found["relation"]
    return out


def ahead_of_joints(chain: Chain, q: Numbers, v: Numbers, p: Numbers) -> tuple[np.ndarray, np.ndarray]:
    """How far rotors behind elastic gears of transmissions are ahead of their joints, and how fast: (n_joints,) each.

    ``q`` (nq,) and ``v`` (nv,) are those of the robot. A rotor that is ahead of its transmission by ``e`` stands where
    that of a rigid gear has the joint at ``y`` with ``l(y) = l(q) + e``, so ``l'(y) ydot = l'(q) qdot + edot``: these
    are ``y - q`` and ``ydot - qdot``, 0 of other joints and in a dead centre. Raises SingularError where a linkage does
    not reach that far.
    """
    none = np.zeros(chain.n_joints)
    if not chain.elastic_travels:
        return none, none
    q, v = np.asarray(q, float), np.asarray(v, float)
    joints, rates = np.array(chain.of_joints(q), float), chain.of_joints(v, rates=True)
    places = list(chain.elastic_travels.values())
    stretch, faster = none.copy(), none.copy()
    stretch[list(chain.elastic_travels)] = q[[chain.place_in_q(place) for place in places]]
    faster[list(chain.elastic_travels)] = v[places]
    length, slope, _ = travels(chain, joints, p)
    moves = np.isin(np.arange(chain.n_joints), list(chain.elastic_travels)) & (np.abs(slope) > DEAD)
    there, reached, lever = joints.copy(), length, slope
    for _ in range(NEWTONS):
        step = np.where(moves, length + stretch - reached, 0.0) / np.where(moves, lever, 1.0)
        there = there + step
        reached, lever, _ = travels(chain, there, p)
        if np.abs(step).max() <= CLOSE * (1.0 + np.abs(there).max()):
            break
    rate = (slope * rates + faster) / np.where(moves, lever, 1.0)
    return there - joints, np.where(moves, rate - rates, 0.0)


def efforts(chain: Chain, torques: np.ndarray, q: Numbers, p: Numbers, held: bool = False) -> np.ndarray:
    """Torques of the joints (n_joints,) at ``q`` as the efforts behind them: forces of cylinders, torques of cranks.

    ``held``: they are the generalised forces at ``chain.held_places``, which are efforts already where gears are
    elastic. Raises SingularError where a transmission stands in a dead centre and would need an infinite effort.
    """
    if not chain.travels:
        return torques
    slope = travels(chain, q, p)[1]
    slope[list(chain.elastic_travels) if held else []] = 1.0
    for joint in chain.travels:
        if abs(slope[joint]) < DEAD and torques[joint]:
            name = chain.axis_names[joint]
            its = chain.travels[joint]
            said = f"its {its.WORD} is in a dead centre, where no {its.EFFORT} turns the joint"
            raise SingularError(f"{name}: {said}; leave it")
    return torques / np.where(slope == 0, 1.0, slope)
