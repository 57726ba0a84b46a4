"""The Kalman filter of robots with internal states: friction that remembers, in Python and in C."""

from functools import cache

import numpy as np
import pytest
from helpers import QUICK, arm, link, model_of

from screwgen import UsageError, assemble
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.estimator import Estimator

BRISTLES = {"coulomb": 1.0, "viscous": 0.4, "memory": {"stiffness": 1e4, "damping": 100.0}}
FALLING = BRISTLES | {"stribeck": {"static": 1.5, "velocity": 0.01}}
SOFT = {"rhoA": 1.0, "EA": 5e4, "EIy": 300.0, "EIz": 500.0, "GJ": 20.0}
CUBE = {"mass": 1.0, "inertia": [0.01, 0.01, 0.01, 0.0, 0.0, 0.0]}
CART = {"name": "cart", "length": 0.3, "bodies": [{"at": "tip", "com": [0.0, 0.0, 0.0]} | CUBE]}
HULL = {"name": "hull", "joint": {"axes": []}, "bodies": [{"at": "base"} | CUBE | {"mass": 9.0}]}
FINE = FALLING | {"memory": {"stiffness": 1e3, "damping": 1e-2}}
GEAR = {"ratio": 50.0, "rotor_inertia": 1e-4, "stiffness": 2e3, "friction": FINE}
LOW = {"coulomb": 1.0, "memory": {"stiffness": 500.0, "damping": 1.0}}


def links(**more):
    """Two flexible links; behind an elastic gear, on axes, and with both laws."""
    shoulder = {"drives": [GEAR, {"friction": FALLING}], "armature": [0.1, 0.1]}
    elbow = {"drives": [{"friction": LOW}], "armature": [0.05], **more}
    return (
        link("a", axes=["z", "y"], modes={"bending_y": 1}, section=SOFT, joint=shoulder),
        link("b", axes="y", modes={"bending_z": 1}, section=SOFT, joint=elbow),
    )


def linkage():
    """A crank with such friction turns a rocker."""
    rubbing = {"armature": [0.02], "drives": [{"friction": LOW}]}
    crank = {"name": "crank", "length": 0.3, "section": {"rhoA": 2.0}, "joint": {"axes": ["y"]} | rubbing}
    coupler = {"name": "coupler", "length": 0.7, "section": {"rhoA": 1.5}, "joint": {"axes": ["y"]}}
    foot = {"axes": ["y"], "mount": {"xyz": [0.8, 0.0, 0.0]}}
    rocker = {"name": "rocker", "parent": "world", "length": 0.6, "section": {"rhoA": 1.8}, "joint": foot}
    return arm(crank, coupler, rocker, loops=[{"between": ["coupler.tip", "rocker.tip"], "joint": {"axes": ["y"]}}])


ROBOTS = {
    "cart": arm(CART | {"joint": {"axes": [{"slide": "x"}], "drives": [{"friction": FALLING}]}}),
    "arm": arm(*links()),
    "floating": arm(HULL, *links(), base="floating"),
    "limits": arm(*links(limits=[{"effort": 0.5}])),
    "linkage": linkage(),
}
H = 1e-3


@cache
def model(name):
    return model_of(ROBOTS[name])


def noise_of(e) -> tuple[Noise, dict[str, float]]:
    """The noise of a filter, and the deviations of its sensors."""
    chain = e.model.chain
    sensors = {row.name: {"strain": 1e-5, "acceleration": 0.2}.get(row.name, 1e-3) for row in e.measurements}
    density = np.r_[np.full(chain.eta_v, 0.5), np.full(chain.n_modes, 1e-3), np.full(chain.n_internal, 1e-8)]
    return Noise(density, 1e-12, sensors=sensors | ({"fibre": 0.02} if "strain" in sensors else {})), sensors


def begin(name):
    """At home and at rest, or nearby where loops are closed, and the deviations there."""
    chain, home = model(name).chain, model(name).chain.home
    if chain.closing.rows:
        home = assemble(model(name), [0.3, -0.4, -1.5], hold=["crank.joint[0]"])
    q = np.where(np.arange(chain.nv) < chain.eta_v, 1e-2, 1e-4)
    return home, np.zeros(chain.nvz), q, np.r_[np.full(chain.nv, 0.1), np.full(chain.n_internal, 1e-5)]


def torque(chain, k):
    return 3.0 * np.sin(0.05 * k + np.arange(chain.n_tau)), np.zeros((chain.n, 6))


@pytest.mark.parametrize("name", ROBOTS)
def test_the_filter_in_c_is_that_in_python(name):
    """200 samples in which friction sticks and slips; a prediction is a step, mean and covariance are the same."""
    chain, filters = model(name).chain, (CompiledEstimator(model(name), flags=QUICK), Estimator(model(name)))
    (noise, sensors), rng, worst, lowest = noise_of(filters[1]), np.random.default_rng(0), 0.0, np.inf
    for e in filters:
        e.start(*begin(name), noise)
    step = model(name).compile(flags=QUICK).step
    for k in range(200):
        inputs, before = torque(chain, k), filters[0].state
        for e in filters:
            e.predict(*inputs, H)
        after = step(*before, *inputs, H, "modal_midpoint")
        assert chain.closing.rows or all(
            np.allclose(a, b, rtol=0, atol=1e-13) for a, b in zip(filters[0].state, after, strict=True)
        )
        told = {}
        for row in filters[1].measurements:
            if row.group == 1:
                expected = -filters[1].compared(row, np.zeros(row.size(chain)), *inputs).rest
                told[row.name] = expected + sensors[row.name] * rng.normal(size=expected.size)
        for e in filters:
            e.update(*inputs, **told)
        (_, v), (_, w), P, Q = filters[0].state, filters[1].state, filters[0].covariance, filters[1].covariance
        sd = np.sqrt(np.diag(Q))
        worst = max(worst, np.max(np.abs(P - Q) / np.outer(sd, sd)), np.max(np.abs(v - w) / sd[chain.nv :]))
        lowest = min(lowest, np.linalg.eigvalsh(P / np.outer(sd, sd)).min())
    assert np.max(np.abs(v[chain.nv :])) > 5e-5, "no bristles are bent"
    assert worst < 1e-7 and lowest > -1e-12


@pytest.mark.parametrize("name", ["cart", "arm"])
def test_the_covariance_is_carried_as_differences_of_the_motion_say(name):
    """The transition over a short step, against pairs of runs of fine steps, apart by every change of the state."""
    e, rng = Estimator(model(name)), np.random.default_rng(3)
    chain, stepper = model(name).chain, e._stepper
    q, inputs, h = np.array(chain.home), torque(chain, 7), 1e-5
    v = np.r_[0.02 + 0.01 * rng.uniform(size=chain.nv), 3e-5 * rng.uniform(size=chain.n_internal)]

    def later(change):
        state = stepper.initial(e._space.moved(q, change[: chain.nv]), v + change[chain.nv :])
        for _ in range(20):
            motion = stepper.step(state, *inputs, h / 20)
            state = stepper.initial(*motion)
        return np.concatenate(motion)

    sizes = np.r_[np.full(2 * chain.nv, 1e-6), np.full(chain.n_internal, 1e-9)]
    apart = [(later(change) - later(-change)) / 2 for change in np.diag(sizes)]
    e.start(q, v, 0.0, 0.0, Noise(0.0))
    e.put(q, v, np.diag(sizes**2))
    e.predict(*inputs, h)
    expected, scale = np.transpose(apart) @ np.array(apart), np.sqrt(np.diag(e.covariance))
    assert np.max(np.abs(e.covariance - expected) / np.outer(scale, scale)) < 1e-3


@pytest.mark.parametrize("kind", [Estimator, CompiledEstimator])
def test_positions_tell_how_far_bristles_are_bent(kind):
    """A cart that sticks on bent bristles swings back; the filter, which takes them for straight, finds that."""
    robot = model("cart")
    e = kind(robot, measurements=["encoder"], **({"flags": QUICK} if kind is CompiledEstimator else {}))
    stepper, rng, nothing = Estimator(robot)._stepper, np.random.default_rng(5), ([0.0], np.zeros((1, 6)))
    q, v = np.zeros(1), np.array([0.0, 5e-5])
    noise = Noise([1e-6, 1e-14], encoder=1e-7)
    e.start(q, [0.0, 0.0], 1e-6, [1e-4, 1e-4], noise)
    for _ in range(200):
        q, v = stepper.step(stepper.initial(q, v), *nothing, H)
        e.predict(*nothing, H)
        e.update(*nothing, encoder=q + 1e-7 * rng.normal(size=1))
    sd = np.sqrt(e.covariance[2, 2])
    assert sd < 1e-6 and abs(e.state[1][1] - v[1]) < 4 * sd
    ignorant = kind(robot, measurements=["encoder"], **({"flags": QUICK} if kind is CompiledEstimator else {}))
    ignorant.start([0.0], [0.0], 1e-6, 1e-4, noise)
    assert ignorant.state[1][1] == 0.0 and ignorant.covariance[2, 2] == 0.0
    with pytest.raises(UsageError, match="density_v"):
        ignorant.set(Noise([1.0, 1.0, 1.0]))
