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
    """The measures of a link from its modal coordinates, the axial force of its joint and its motion."""
    if not s.key.bends:
        s.write("measures", mx.zeros(len(MEASURES)))
        return
    motion, wrench = s.read("motion"), s.read("wrench")
    given = {"eta": s.read("eta"), "omega_t": motion[:2], "a_x": motion[2:3], "F_x": wrench[3:4]}
    given["F_own"] = motion[3:]
    s.write("measures", np.concatenate([np.ravel(x) for x in s.lower("validity", given, *MEASURES)]))
