"""The runs: the algorithms that are C functions over the links, and their results."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from ...algorithms import functions as alg
from ...algorithms.schedule import Algorithm
from ...algorithms.signals import H_SYS, M_SYS


@dataclass(frozen=True)
class CFunction:
    """An algorithm that is a C function, and its results."""

    algorithm: Algorithm
    comment: str
    results: frozenset[str]
    apart: bool
    """Whether no result shares memory with an input."""
    skipped: Mapping[str, str] = field(default_factory=dict)
    """Phases that run only where a condition on the call holds."""
    zero: frozenset[str] = frozenset()
    """Signals that are zero in this run."""
    parts: tuple[tuple[str, int], ...] = ()
    """The C functions that the phases are divided among, and their numbers of phases; none: one of the run's name."""
    parts_if_sprung: tuple[tuple[str, int], ...] = ()
    """The same for robots with sprung joints or loops, whose forces need the joint rates, if it differs."""
    each_tip: bool = False
    """Whether results at nodes are those of every tip, not of the last alone."""


def _run(
    algorithm: Algorithm,
    comment: str,
    results: str,
    apart: bool = False,
    skipped: Mapping[str, str] | None = None,
    **more: Any,
) -> CFunction:
    return CFunction(algorithm, comment, frozenset(results.split()), apart, skipped or {}, **more)


RUNS: dict[str, CFunction] = {
    "joint_dynamics": _run(
        (*alg.FORWARD, alg.POSES),
        "Joint form: accelerations, wrenches and poses by block elimination.",
        "qddot thetaddot etaddot wrench motion tip.R tip.r",
        apart=True,
        skipped={"poses": "call->tip_pose"},
    ),
    "dae_dynamics": _run(
        alg.DAE_FORWARD,
        "DAE form: rates of the twists, wrenches, joint rates, by the same elimination.",
        "qdot qddot thetaddot etaddot wrench Vdot",
        apart=True,
        parts_if_sprung=(("dae_motion", 1), ("dae_solution", 3)),
    ),
    "projection": _run(
        alg.PROJECTION,
        "The state of the DAE form, projected onto the joint constraints.",
        "new_q new_quaternion new_position new_twist",
    ),
    "placement": _run(
        alg.PLACEMENT,
        "Poses and twists of the DAE form from coordinates and rates.",
        "new_quaternion new_position new_twist tip.R tip.r",
    ),
    "inverse": _run(
        alg.INVERSE, "Joint form: inverse dynamics, with joint wrenches.", "force force_theta force_eta wrench"
    ),
    "inertia": CFunction(
        alg.INVERSE,
        "Joint form at rest, without weight and springs: the posture, and the inertial forces of accelerations.",
        frozenset({"force", "force_theta", "force_eta"}),
        False,
        zero=frozenset("qdot twist thetadot etadot w_ext f_q f_theta f_eta gravity".split()),
        parts=(("inertia_posture", 1), ("inertia_column", 2)),
    ),
    "motion_of": _run(
        alg.MOTION, "Poses of links and tips, twists of the tips.", "R r tip.R tip.r tip_twist", each_tip=True
    ),
    "measuring": _run(alg.MEASURING, "How far every link is from the limits of its model.", "measures", apart=True),
    "assembly": _run(alg.ASSEMBLY, "M_sys, H_sys and W_sys.", " ".join([*M_SYS, *H_SYS])),
}
