"""The check of motions: what a plan says is what the robot does."""

from __future__ import annotations

import numpy as np
from scipy.linalg import eigvals

import screwgen
from conformance.cases import Case
from screwgen.planning.members import Still
from screwgen.planning.refusals import refuse_robot
from screwgen.planning.sampled_loop import LoopGains
from screwgen.planning.vibrations import poles
from screwgen.spec.dry_friction import without_dry_friction

WAY, TIME = 0.1, 2.0
"""rad or m, and s."""
STIFF, DAMPED = 4.0, 0.5
"""1/s² and 1/s, times inertia: of a law so weak that it mends little of what torques ahead are wrong."""
FIRMER = 2.0
"""By how much more than it takes a law holds an arm that falls over."""
STEP = 1.25e-4
H, CLOSE = 1e-5, 1e-6
"""rad or m: of differences of a law; by the size of a pole, how far it may be from that of the slopes."""
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
    if not still.drives.given:
        small_motions(still, start, LoopGains(stiff * inertia, DAMPED * inertia))
    found = screwgen.plan(model, start, start + WAY, TIME, gains=law, fast=True, parameters=light)
    step = STEP / np.ceil(STEP * quickest(still, start))
    played = screwgen.play(model, found, step=step, after=0.2, parameters=light)
    planned = np.array([found.reference(t)[0] for t in played.run.t])
    off = np.abs(still.drives.driven(played.run.q) - planned).max()
    assert off <= OFF and played.residual <= OFF, f"{off:.1e} off, its tip moves by {played.residual:.1e} after"


def quickest(still: Still, joints: np.ndarray) -> float:
    """The size, 1/s, of what changes fastest at a rest: what touches damps a thin link's twist within 10 µs."""
    rest, model = still.held(joints), still.model
    effort = np.append(rest.effort / still.drives.effort_ratios, np.zeros(model.n_tau - still.joints))
    linear = model.linearise(still.drives.to_robot(rest.q), tau=effort, parameters=still.p)
    return float(np.abs(np.linalg.eigvals(linear.A)).max())


def small_motions(still: Still, joints: np.ndarray, gains: LoopGains) -> None:
    """What swings about a rest under a law, as gains and shapers see it, is what the slopes of dynamics and law say."""
    model, rest = still.model, still.held(joints)
    p = without_dry_friction(model.robot, still.p, bend=False)
    law = screwgen.PD(gains.kp, gains.kd, joints).through(model.chain, p)
    effort = np.append(rest.effort / still.drives.effort_ratios, np.zeros(model.n_tau - still.joints))
    linear = model.linearise(still.drives.to_robot(rest.q), tau=effort, parameters=p)
    n, at = model.nq, np.append(still.drives.to_robot(rest.q), np.zeros(model.nv))
    slopes = [
        (law(0.0, *np.split(at + x, [n])) - law(0.0, *np.split(at - x, [n]))) / (2 * H) for x in H * np.eye(2 * n)
    ]
    found = np.linalg.eigvals(linear.A + linear.B[:, : model.n_tau] @ np.transpose(slopes))
    wanted = poles(still, joints, gains)
    off = np.abs(wanted[:, None] - found).min(axis=1)
    assert (off <= CLOSE * np.abs(wanted)).all(), f"poles {wanted} of the law, {found} of the slopes"


def falling(still: Still, joints: np.ndarray) -> float:
    """The rate, 1/s, at which an arm leaves a rest under the efforts that hold it there and at a way from it."""
    rests = still.held(joints), still.held(joints + WAY)
    least = (eigvals(*np.array(still.matrices(x))[[2, 0]]).real.min() for x in rests)
    return float(np.sqrt(max(0.0, -min(least))))
