"""What measures at the markers of a robot: each a program, which `robot_functions` lists with its units."""

from __future__ import annotations

from collections.abc import Sequence

from ..ir.program import Value
from .functions import EVERYTHING, Functions
from .fused import Outputs, program
from .marker_functions import MEASURED

ALL = (*EVERYTHING, *MEASURED)


@program("q", algorithms=ALL)
def marker_pose(f: Functions, q: Sequence) -> Outputs:
    """``(q) -> (R, position)`` of all markers, R row by row."""
    return dict(zip(("R", "position"), f.marker_poses(q), strict=True))


@program("q", algorithms=ALL)
def marker_jacobian(f: Functions, q: Sequence) -> Outputs:
    """``(q) -> (J)``, row by row."""
    return {"J": f.marker_jacobians(q)}


@program("q v", algorithms=ALL)
def marker_bias(f: Functions, q: Sequence, v: Sequence) -> Outputs:
    """``(q, v) -> (bias)``: the accelerations that rates alone cause."""
    return {"bias": f.marker_biases(q, v)}


def turning(f: Functions, q: Sequence, v: Sequence) -> list[Value]:
    """The angular velocities of the markers."""
    twists = f.marker_velocities(q, v)
    return [x for k in range(0, len(twists), 6) for x in twists[k : k + 3]]


def felt(f: Functions, q: Sequence, v: Sequence, vdot: Sequence) -> list[Value]:
    """The accelerations of the markers less that of free fall, of a motion."""
    found = f.marker_accelerations(q, v, vdot)
    return [x for k in range(3, len(found), 6) for x in found[k : k + 3]]


@program("q v vdot", algorithms=ALL)
def marker_motion(f: Functions, q: Sequence, v: Sequence, vdot: Sequence) -> Outputs:
    """``(q, v, vdot) -> (R, position, twist, acceleration)``, the last against free fall."""
    twist, acceleration = f.marker_velocities(q, v), f.marker_accelerations(q, v, vdot)
    return {**marker_pose.body(f, q), "twist": twist, "acceleration": acceleration}


@program("q", algorithms=ALL)
def strain(f: Functions, q: Sequence) -> Outputs:
    """``(q) -> (strain)``."""
    return {"strain": f.strains(q)}
