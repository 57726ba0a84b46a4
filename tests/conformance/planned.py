"""The check of motions: what a plan says is what the robot does."""

from __future__ import annotations

import numpy as np
from scipy.linalg import eigvals

import screwgen
from conformance.cases import Case
from screwgen.planning.members import Still
from screwgen.planning.refusals import refuse_robot

WAY, TIME = 0.1, 2.0
"""rad or m, and s."""
STIFF, DAMPED = 4.0, 0.5
"""1/s² and 1/s, times inertia: of a law so weak that it mends little of what torques ahead are wrong."""
FIRMER = 2.0
"""By how much more than it takes a law holds an arm that falls over."""
STEP = 1.25e-4
OFF = 5e-4
"""rad or m, half a percent of the way: how far joints may be from what was planned, and the tip may move after."""


def plan(case: Case) -> None:
    """A small motion, planned by least squares and played: joints go as planned, and then nothing moves.

    Under little weight, as links of second order bend little. Efforts that are held let some arms fall over, as those
    of a cylinder whose lever grows: what is a rounding then grows without a law, too.
    """
    model, start = case.model, np.zeros(case.model.n_joints)
    light = {f"gravity[{k}]": 0.1 * g for k, g in enumerate(case.robot["gravity"])}
    refuse_robot(model)
    still = Still(model, model.chain.parameters.vector(light))
    inertia, falls = np.diag(still.rigid_inertia(still.held(start).q)), falling(still, start)
    stiff = STIFF + FIRMER * falls**2
    law = screwgen.PD(tuple(stiff * inertia), tuple(DAMPED * inertia), tuple(start))
    found = screwgen.plan(model, start, start + WAY, TIME, gains=law, fast=True, parameters=light)
    played = screwgen.play(model, found, step=STEP, after=0.2, parameters=light)
    planned = np.array([found.reference(t)[0] for t in played.run.t])
    off = np.abs(still.drives.driven(played.run.q) - planned).max()
    assert off <= OFF and played.residual <= OFF, f"{off:.1e} off, its tip moves by {played.residual:.1e} after"


def falling(still: Still, joints: np.ndarray) -> float:
    """The rate, 1/s, at which an arm leaves a rest under the efforts that hold it there and at a way from it."""
    rests = still.held(joints), still.held(joints + WAY)
    least = (eigvals(still.stiffness(x.q, x.effort), still.matrices(x.q)[0]).real.min() for x in rests)
    return float(np.sqrt(max(0.0, -min(least))))
