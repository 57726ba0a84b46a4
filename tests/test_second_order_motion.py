"""What arms of order 2 keep: the energy of a free swing, the momentum of a free chain; against the oracle's sums.

The accelerations are the generated C's; an eighth-order method integrates them, so that no step is seen.
"""

from functools import cache

import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from helpers import QUICK, model_of
from oracle import Oracle
from scipy.integrate import solve_ivp

from screwgen import Screw
from screwgen.runtime.compiled import Compiled

DURATION, SAMPLES = 1.0, 21
SLIDES = [Screw(tuple(axis), turn=False, travel=1.0) for axis in np.eye(3).tolist()]
"""The joint of a carriage that is free along the axes of the inertial frame; a link on it turns by yaw, pitch, roll."""


def undamped(rng, links: int) -> dict:
    """A random arm in space, flexible links of order 2; nothing dissipates.

    Joints of two axes have no singular posture. Motors have rotors: without them the mass matrix to second order loses
    its definiteness at smaller deflections.
    """
    robot = rr.random_robot(rng, links, rigid=0.0, welded=0.0, material=0.0, soft=0.0, max_axes=2)
    robot |= {"order": 2, "gravity": rr.numbers(rng.uniform(-10, 10, 3))}
    for link in robot["links"]:
        link.pop("damping", None)
        link["joint"].pop("damping", None)
        link["joint"]["armature"] = [0.1] * len(link["joint"]["axes"])
        link["bodies"] = [rr.random_body(rng, "tip")]
        link["modes"] = {"bending_y": 2, "bending_z": 1, "torsion": 1} if link["name"] == "link_0" else {
            "axial": 1, "bending_y": 1, "bending_z": 2,
        }  # fmt: skip
        link["section"] = {"rhoA": 1.0, "EA": 5e3, "EIy": 200.0, "EIz": 300.0, "GJ": 100.0, "rhoIp": 5e-3}
    return robot


def free_chain(rng) -> dict:
    """Two links in space without gravity; the first one turns freely about a point mass that slides freely."""
    robot = undamped(rng, 2) | {"gravity": [0.0, 0.0, 0.0]}
    for link in robot["links"]:
        link["joint"].pop("stiffness", None)
    robot["links"][0] |= {"joint": {"axes": ["z", "y", "x"]}, "bodies": [rr.random_body(rng, "base")]}
    carriage = {"name": "carriage", "length": 0.1, "section": {"rhoA": 1e-9}, "joint": {"axes": SLIDES}}
    carriage["bodies"] = [{"at": "tip", "mass": 0.5}]
    return robot | {"links": [carriage, *robot["links"]]}


@cache
def motion(kind: str, seed: int):
    """The oracle, the model, and q and v (SAMPLES, nq) of a motion without torques and loads from outside."""
    rng = np.random.default_rng(seed)
    robot = free_chain(rng) if kind == "free" else undamped(rng, 2 + seed % 2)
    model = model_of(robot)
    state = rr.random_state(rng, robot, angle=0.5, rate=1.0, modal=0.2)
    compiled, free = Compiled(model, flags=QUICK), (np.zeros(model.n_joints), np.zeros((model.n_links, 6)))
    slope = lambda _, x: np.append(x[model.nq :], compiled.forward_dynamics(*np.split(x, 2), *free)[0])  # noqa: E731
    start = np.append(state["q"], state["v"])
    times = np.linspace(0, DURATION, SAMPLES)
    run = solve_ivp(slope, (0, DURATION), start, method="DOP853", rtol=1e-12, atol=1e-13, t_eval=times)
    assert run.success, run.message
    return Oracle(robot), model, *np.split(run.y.T, 2, axis=1)


@pytest.mark.parametrize("seed", swept(range(3), 0))
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


@pytest.mark.parametrize("seed", swept(range(2), 0))
def test_a_free_chain_keeps_its_momentum(seed):
    """Linear and angular, summed by the oracle over the elements of the links; the ground gives no wrench."""
    oracle, model, q, v = motion("free", seed)
    momenta = [np.concatenate(oracle.momentum(*at)) for at in zip(q, v, strict=True)]
    linear, angular = np.split(np.array(momenta), 2, axis=1)
    moved = np.abs(v - v[0]).max(axis=0)
    assert moved[:3].min() > 0.01 and moved[3:6].min() > 0.1 and np.ptp(q[:, 3:6], axis=0).min() > 0.1
    for momentum in (linear, angular):
        assert np.abs(momentum - momentum[0]).max() <= 1e-9 * np.linalg.norm(momentum[0])
    free = np.zeros(model.n_joints), np.zeros((model.n_links, 6))
    _, wrench = model.numpy().forward_dynamics(q[-1], v[-1], *free)
    assert np.abs(wrench[0]).max() <= 1e-9 * np.abs(wrench[1:]).max()
