"""What arms of order 2 keep: the energy of a free swing, the momentum of a free chain; against the oracle's sums.

The accelerations are the generated C's; an eighth-order method integrates them, so that no step is seen.
"""

from functools import cache

import numpy as np
import pytest
import random_robots as rr
from helpers import model_of
from oracle import Oracle
from scipy.integrate import solve_ivp

from screwgen import Screw
from screwgen.runtime.compiled import Compiled

DURATION, SAMPLES = 1.0, 21
E_X, E_Y, E_Z = np.eye(3)
FREE = [*(Screw(tuple(axis), turn=False, travel=1.0) for axis in (E_X, E_Y, E_Z)), "z", "y", "x"]
"""The joint of a body in space: three slides along the axes of the inertial frame, then yaw, pitch and roll."""


def undamped(rng, links: int) -> dict:
    """A random arm in space, flexible links of order 2; nothing dissipates, and no joint has a singular posture."""
    robot = rr.random_robot(rng, links, rigid=0.0, welded=0.0, material=0.0, soft=0.0, max_axes=2)
    robot |= {"order": 2, "gravity": rr.numbers(rng.uniform(-10, 10, 3))}
    for link in robot["links"]:
        link.pop("damping", None)
        link["joint"].pop("damping", None)
        link["modes"] = {"bending_y": 2, "bending_z": 1, "torsion": 1} if link["name"] == "link_0" else {
            "axial": 1, "bending_y": 1, "bending_z": 2,
        }  # fmt: skip
        link["section"] = {"rhoA": 1.0, "EA": 2e3, "EIy": 30.0, "EIz": 50.0, "GJ": 20.0, "rhoIp": 5e-3}
    return robot


def free_chain(rng) -> dict:
    """Three links in space without gravity, motors' inertia, springs or ground; the first one is free."""
    robot = undamped(rng, 3) | {"gravity": [0.0, 0.0, 0.0]}
    for link in robot["links"]:
        for key in ("armature", "stiffness"):
            link["joint"].pop(key, None)
    robot["links"][0]["joint"] = {"axes": FREE}
    return robot


@cache
def motion(kind: str, seed: int):
    """The oracle, the model, and q and v (SAMPLES, nq) of a motion without torques and loads from outside."""
    rng = np.random.default_rng(seed)
    robot = free_chain(rng) if kind == "free" else undamped(rng, 2 + seed % 2)
    model = model_of(robot)
    state = rr.random_state(rng, robot, angle=1.0, rate=1.0, modal=0.5)
    compiled, free = Compiled(model, flags=("-O1",)), (np.zeros(model.n_joints), np.zeros((model.n_links, 6)))
    slope = lambda _, x: np.append(x[model.nq :], compiled.forward_dynamics(*np.split(x, 2), *free)[0])  # noqa: E731
    start = np.append(state["q"], state["v"])
    times = np.linspace(0, DURATION, SAMPLES)
    run = solve_ivp(slope, (0, DURATION), start, method="DOP853", rtol=1e-12, atol=1e-13, t_eval=times)
    assert run.success, run.message
    return Oracle(robot), model, *np.split(run.y.T, 2, axis=1)


@pytest.mark.parametrize("seed", range(3))
def test_a_free_swing_keeps_its_energy(seed):
    """To 1e-8 of the largest kinetic energy in a second; the energy is the tool's, and the oracle's."""
    oracle, model, q, v = motion("swing", seed)
    numeric = model.numpy()
    energies = np.array([numeric.energy(*at) for at in zip(q, v, strict=True)])
    total, most = energies.sum(axis=1), energies[:, 0].max()
    assert np.ptp(energies[:, 0]) > 0.1 * most
    assert np.abs(total - total[0]).max() <= 1e-8 * most
    judged = np.array([oracle.energy(*at) for at in zip(q[::5], v[::5], strict=True)])
    assert np.allclose(energies[::5], judged, rtol=1e-10, atol=1e-10 * most)


@pytest.mark.parametrize("seed", range(2))
def test_a_free_chain_keeps_its_momentum(seed):
    """Linear and angular, summed by the oracle over the elements of the links; no wrench holds the base."""
    oracle, model, q, v = motion("free", seed)
    momenta = [np.concatenate(oracle.momentum(*at)) for at in zip(q, v, strict=True)]
    linear, angular = np.split(np.array(momenta), 2, axis=1)
    moved = np.abs(v - v[0]).max(axis=0)
    assert moved[:3].min() > 0.01 and moved[3:6].min() > 0.1
    for momentum in (linear, angular):
        assert np.abs(momentum - momentum[0]).max() <= 1e-9 * np.linalg.norm(momentum[0])
    free = np.zeros(model.n_joints), np.zeros((model.n_links, 6))
    _, wrench = model.numpy().forward_dynamics(q[-1], v[-1], *free)
    assert np.abs(wrench[0]).max() <= 1e-9 * np.abs(wrench[1:]).max()
