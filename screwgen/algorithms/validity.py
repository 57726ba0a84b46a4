"""The phase that computes the validity measures of a link."""

from __future__ import annotations

import numpy as np

from ..bodies.validity import MEASURES
from ..ir.program import Array, Value
from . import matrices as mx
from .scope import Scope


def axial_motion(s: Scope, omega: Array, a_x: Value, own: Value) -> None:
    """The inputs of :func:`measure` from a motion, all in F_i.

    Angular velocity about y and z, axial acceleration relative to free fall, and the axial force that accelerates the
    link and its base bodies.
    """
    s.write("motion", np.array([omega[1], omega[2], a_x, own], dtype=object))


def measure(s: Scope) -> None:
    """The measures of a link from its modal coordinates, the axial force of its joint and its motion.

    A link of order 2 has no limit of axial load and rotation: these measures are zero.
    """
    if not s.key.bends:
        s.write("measures", mx.zeros(len(MEASURES)))
        return
    given, names = {"eta": s.read("eta")}, MEASURES[:2]
    if s.key.lacks_geometric_stiffness:
        motion, names = s.read("motion"), MEASURES
        given |= {"omega_t": motion[:2], "a_x": motion[2:3], "F_x": s.read("wrench")[3:4], "F_own": motion[3:]}
    found = [np.ravel(x) for x in s.lower("validity", given, *names)]
    s.write("measures", np.concatenate([*found, mx.zeros(len(MEASURES) - len(names))]))
