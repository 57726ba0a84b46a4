"""Coordinates of an arm in the order in which plans have them: what drives act on and measure, then all others.

A drive behind an elastic gear acts on its rotor, where its encoder sits. Its coordinate is the rotor's angle over the
ratio, where the joint would be if the gear did not twist; its effort is that of the rotor times the ratio. By how much
the joint is ahead of it, the twist of the gear, is one of the others, as coordinates of modes are.

A drive with a transmission acts along a travel `l`, the length of a cylinder or the angle of a crank. Its coordinate is
that of the joint, its effort that along the travel, which acts on the coordinate through the lever `l'`. Behind an
elastic gear the coordinate `y` is again where the joint would be if the gear did not give way, so the rotor's travel is
`l(y)` and the effort acts on y alone, through `l'(y)`.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from ..algorithms.travels import relation
from ..backends.casadi.expressions import expressions
from ..backends.numpy.travel_numbers import ahead_of_joints

if TYPE_CHECKING:
    from ..elements import Travel
    from ..topology.chain import Chain

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(8)
"""Of the mean from -1 to 1: exact to rounding over the way that a gear gives."""


class DriveCoordinates:
    """Those of a robot on a fixed base at parameters, numbers or symbols.

    Without elastic drives they are the coordinates of the robot themselves, and these are `map x` where no elastic gear
    drives a transmission.
    """

    def __init__(self, chain: Chain, p: Any):
        self.chain, self.p = chain, p
        self.joints, self.count = chain.n_joints, chain.nq
        self.places = list(chain.held_places)
        """(n_joints,): where in `q` of the robot the coordinates of its drives stand."""
        self.ratios = [1.0] * chain.n_joints
        """(n_joints,): turns of the rotors per turn of the joints, 1 of rigid drives and of transmissions."""
        for joint, ratio in zip(chain.added_joints, chain.ratios(p), strict=True):
            if joint not in chain.elastic_travels:
                self.ratios[joint] = ratio
        self.given = list(chain.prescribed)
        """The joints whose motion is given; their effort is an acceleration, that of the rotor over the ratio."""

    @cached_property
    def map(self) -> ca.SX:
        """(nq, nq): of the robot's coordinates by these."""
        out = ca.SX(self.count, self.count)
        others = sorted(set(range(self.count)) - set(self.places))
        for column, place in enumerate([*self.places, *others]):
            out[place, column] = self.ratios[column] if column < self.joints else 1.0
        for joint, place in enumerate(self.places):
            if place != joint:
                out[joint, joint] = 1.0
        return out

    def to_robot(self, x: Any) -> Any:
        """Coordinates (nq,) of the robot, numbers or a column of symbols."""
        if not isinstance(x, ca.SX):
            return np.array(self._to_robot(np.asarray(x, float))).ravel()
        q = self.map @ x
        for _, joint, travel, given in self.chain.travel_numbers(self.p):
            if joint in self.chain.elastic_travels:
                q[self.places[joint]] = _way(travel, given, q[joint], x[joint])
        return q

    @cached_property
    def _to_robot(self) -> ca.Function:
        x = ca.SX.sym("x", self.count)
        return ca.Function("to_robot", [x], [self.to_robot(x)])

    def motion(self, x: ca.SX, v: ca.SX, a: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
        """Coordinates, rates and accelerations (nq,) of the robot, of symbols."""
        q = self.to_robot(x)
        rates = ca.jacobian(q, x) @ v
        return q, rates, ca.jacobian(q, x) @ a + ca.jacobian(rates, x) @ v

    def forces(self, f: ca.SX, x: ca.SX) -> ca.SX:
        """Forces (nq,) of the robot at coordinates x, symbols, as these coordinates have them: equal power."""
        return ca.jacobian(self.to_robot(x), x).T @ f

    def levers(self, x: ca.SX) -> ca.SX:
        """(n_joints,): the force on each drive's coordinate by a unit of its effort, `l'` of transmissions, else 1."""
        out = ca.SX.ones(self.joints)
        for _, joint, travel, given in self.chain.travel_numbers(self.p):
            out[joint] = _slope(travel, given, x[joint])
        return out

    def driven(self, q: np.ndarray) -> np.ndarray:
        """(…, n_joints): what drives measure, of coordinates (…, nq) of the robot."""
        return q[..., self.places_measured] / np.array(self.ratios, float) + self._ahead(q, 0.0 * q)[0]

    def driven_rates(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """(…, n_joints): the rates of that, of coordinates and rates (…, nq) of the robot."""
        return v[..., self.places_measured] / np.array(self.ratios, float) + self._ahead(q, v)[1]

    @cached_property
    def places_measured(self) -> list[int]:
        """(n_joints,): where in `q` stand the coordinates of drives, of transmissions those of their joints."""
        return [k if k in self.chain.elastic_travels else place for k, place in enumerate(self.places)]

    def _ahead(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """How far rotors of transmissions are ahead of joints, and how fast, (…, n_joints) each."""
        shape = (*q.shape[:-1], self.joints)
        if not self.chain.elastic_travels:
            return np.zeros(shape), np.zeros(shape)
        rows = zip(q.reshape(-1, q.shape[-1]), v.reshape(-1, v.shape[-1]), strict=True)
        found = np.array([ahead_of_joints(self.chain, *row, self.p) for row in rows])
        return found[:, 0].reshape(shape), found[:, 1].reshape(shape)

    def efforts(self, tau: np.ndarray) -> np.ndarray:
        """(…, n_joints): of efforts (…, n_tau) where drives act, times the ratios; of given accelerations over them."""
        return tau[..., : self.joints] * self.effort_ratios

    @property
    def effort_ratios(self) -> np.ndarray:
        """(n_joints,): of efforts here to those where drives act."""
        return np.array([1.0 / x if joint in self.given else x for joint, x in enumerate(self.ratios)], float)

    def with_accelerations(self, force: ca.SX, a: ca.SX) -> ca.SX:
        """Forces (nq,) of these coordinates, of joints whose motion is given the accelerations in their place."""
        out = ca.SX(force)
        for joint in self.given:
            out[joint] = a[joint]
        return out


def _slope(travel: Travel, given: list[Any], q: ca.SX) -> ca.SX:
    """`l'` at a coordinate."""
    numbers = ca.vertcat(*map(ca.SX, given))
    return expressions(relation(travel), {"q": q, "given": numbers})["relation"][0]


def _way(travel: Travel, given: list[Any], begin: ca.SX, end: ca.SX) -> ca.SX:
    """`l(end) − l(begin)`, as the mean of `l'` between times the way: no digits are lost where this is short."""
    middle, half = (begin + end) / 2, (end - begin) / 2
    parts = (w * _slope(travel, given, middle + x * half) for x, w in zip(POINTS, WEIGHTS, strict=True))
    return sum(parts, ca.SX(0.0)) * half
