"""The coordinates of joints: their places, and how they move, which every joint says of its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from itertools import accumulate, pairwise
from typing import Any, NamedTuple

import numpy as np

from ..joints.exponential import Series
from ..joints.kind import JointKind
from ..joints.product import WELD as FLAT
from ..spec.link_class import LinkClass


class JointPlace(NamedTuple):
    """A joint whose coordinates move by other means than sums, and its slices of `q` and `v`."""

    link: int
    joint: JointKind
    q: slice
    v: slice


class JointCoordinates:
    """The joints of links of given classes: the offsets of their coordinates, rates and torques by link."""

    def __init__(self, keys: Sequence[LinkClass]):
        self.keys = list(keys)
        offsets = lambda size: list(accumulate(map(size, self.keys), initial=0))  # noqa: E731
        self.q_offset, self.v_offset = offsets(lambda k: k.joint.nq), offsets(lambda k: k.joints)
        self.tau_offset = offsets(lambda k: k.torques)

    @property
    def n_inner(self) -> int:
        """The number of coordinates behind those of the joints, which add up."""
        return 0

    @property
    def nq(self) -> int:
        """The number of coordinates: joints, rotors, modes."""
        return self.q_offset[-1] + self.n_inner

    @property
    def nv(self) -> int:
        """The number of their rates."""
        return self.v_offset[-1] + self.n_inner

    @cached_property
    def curved(self) -> tuple[JointPlace, ...]:
        """The joints whose coordinates move by other means than sums; `q` and `v` then differ in length."""
        places = zip(pairwise(self.q_offset), pairwise(self.v_offset), strict=True)
        parts = (JointPlace(i, self.keys[i].joint, slice(*q), slice(*v)) for i, (q, v) in enumerate(places))
        return tuple(part for part in parts if part.joint.curved)

    @property
    def home(self) -> list[float]:
        """The coordinates (nq) with joints and modes at zero, and a floating base at the inertial frame."""
        return [x for key in self.keys for x in key.joint.home] + [0.0] * self.n_inner

    def _moved(self, a: Any, by: Any, rates: bool, move: Callable[[JointKind, Any, Any], Any]) -> Any:
        """What joints make of their parts of two arrays, the second of rates, and sums of the rest, in order.

        ``rates``: the first and the result are of rates as well.
        """
        out, first, at = [], 0, 0
        for part in self.curved:
            mine = part.v if rates else part.q
            out += [move(FLAT, a[first : mine.start], by[at : part.v.start]), move(part.joint, a[mine], by[part.v])]
            first, at = mine.stop, part.v.stop
        return np.concatenate([*out, move(FLAT, a[first:], by[at:])])

    def integrate(self, q: np.ndarray, u: np.ndarray, series: Series) -> np.ndarray:
        """The coordinates (nq,) at a change ``u`` (nv,) from ``q``; entries may be symbols."""
        return self._moved(q, u, False, lambda joint, a, b: joint.integrate(a, b, series))

    def rate(self, u: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The rate (nv,) of the change ``u`` from a start where the rates are ``v``, to order four."""
        return self._moved(u, v, True, lambda joint, a, b: joint.rate(a, b))

    def difference(self, q: np.ndarray, other: np.ndarray, series: Series) -> np.ndarray:
        """The change (nv,) by which :meth:`integrate` takes ``q`` to ``other``, both of numbers."""
        out = np.zeros(self.nv)
        out[self.flat_v] = other[self.flat_q] - q[self.flat_q]
        for part in self.curved:
            out[part.v] = part.joint.difference(q[part.q], other[part.q], series)
        return out

    def unit(self, q: np.ndarray) -> np.ndarray:
        """The coordinates, of numbers, with quaternions of length one."""
        out = np.array(q, float)
        for part in self.curved:
            out[part.q] = part.joint.unit(out[part.q])
        return out

    def carried(self, v: np.ndarray) -> np.ndarray:
        """(nv, nv): by a change of the posture its rate at constant rates ``v``, as the axes of changes turn."""
        out = np.zeros((self.nv, self.nv))
        for part in self.curved:
            out[part.v, part.v] = part.joint.carried(v[part.v])
        return out

    def flat(self, q: np.ndarray) -> np.ndarray:
        """(nv,): the coordinates that add up, where their rates stand; zero for the others."""
        out = np.zeros(self.nv)
        out[self.flat_v] = q[self.flat_q]
        return out

    @cached_property
    def flat_q(self) -> np.ndarray:
        """The coordinates, as indices in `q`, that add up."""
        return np.setdiff1d(np.arange(self.nq), [k for part in self.curved for k in range(part.q.start, part.q.stop)])

    @cached_property
    def flat_v(self) -> np.ndarray:
        """Their rates, as indices in `v`."""
        return np.setdiff1d(np.arange(self.nv), [k for part in self.curved for k in range(part.v.start, part.v.stop)])

    @cached_property
    def axis_places(self) -> list[int]:
        """Where in `q` the coordinate along each torque stands; of a ball joint those of its quaternion's vector."""
        ahead = [0 if key.joint.turn_at is None else key.joint.turn_at + 1 for key in self.keys]
        return [self.q_offset[i] + ahead[i] + k for i, key in enumerate(self.keys) for k in range(key.torques)]
