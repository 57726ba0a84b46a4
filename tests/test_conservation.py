"""What a motion keeps: energy, the joints of the DAE form, bounds of the modal-implicit step.

All in compiled, optimised C. ELLA swings freely from a bent rest; nothing in it dissipates.
"""

from functools import cache

import numpy as np
import pytest
from helpers import example, example_dict, rotation_of
from oracle import Oracle

from screwgen.errors import ScrewgenError
from screwgen.runtime.compiled import Compiled
from screwgen.simulation.dae import DaeStepper

START = np.array([-0.3, 0.4, 0.5, 0.0, 0.004, -0.003, 0.0, 0.002, 0.003])
STRETCHED = START + np.array([0, 0, 0, 1e-4, 0, 0, -1e-4, 0, 0])
"""The same with both links stretched and squeezed by a tenth of a millimetre: modes of about 1.4 kHz."""

REST = np.zeros(9)
FREE = (np.zeros(3), np.zeros((2, 6)))


@cache
def ella() -> Compiled:
    return Compiled(example("ella"), cache=True)


def energy(q, v) -> float:
    return sum(example("ella").numpy().energy(q, v))


# -------- energy


@pytest.mark.parametrize(("start", "dt"), [(START, 1e-5), (STRETCHED, 2e-6)], ids=["bent", "stretched"])
def test_rk4_keeps_the_energy_of_a_swinging_arm(start, dt):
    """1 s: the drift stays below 1e-8 of the largest kinetic energy, at fifty samples.

    RK4 itself takes (omega h)^6 / 72 of a mode's energy in a step: an axial mode of 1.4 kHz that holds 1 J would lose
    7e-4 J in a second at 1e-5 s, so the stretched arm is stepped finer.
    """
    q, v, energies = start, REST, []
    for _ in range(50):
        energies.append(example("ella").numpy().energy(q, v))
        q, v = ella().step(q, v, *FREE, dt, "rk4", round(0.02 / dt))
    energies = np.array([*energies, example("ella").numpy().energy(q, v)])
    total, most = energies.sum(axis=1), energies[:, 0].max()
    assert most > 50
    assert np.max(np.abs(total - total[0])) <= 1e-8 * most


# -------- the joints of the DAE form


@cache
def judge() -> Oracle:
    return Oracle(example_dict("ella"))


def violations(x) -> tuple[float, float]:
    """How far poses (rad, m) and twists (over the largest) are from what q, eta and their rates say."""
    poses, twists = x[:14].reshape(2, 7), x[20:32]
    placed = judge().poses(np.concatenate([x[-3:], x[14:20]]))
    turned = np.abs([rotation_of(pose[:4]) for pose in poses] - placed["R"]).max()
    columns = np.array([judge().link_twists(np.concatenate([x[-3:], x[14:20]]), e).ravel() for e in np.eye(9)]).T
    rest = twists - columns[:, 3:] @ x[32:38]
    left = rest - columns[:, :3] @ np.linalg.lstsq(columns[:, :3], rest, rcond=None)[0]
    return max(turned, np.abs(poses[:, 4:] - placed["origin"]).max()), np.abs(left).max() / np.abs(twists).max()


def test_projection_keeps_the_joints_together():
    """DAE form, rk4 at 1e-4 s, 10 s with several turns of the elbow: joints hold to 1e-12 at every sample."""
    x = ella().dae_state(START, REST)
    worst = []
    for _ in range(20):
        x = ella().dae_step(x, *FREE, 1e-4, "rk4", 5000)
        worst.append(violations(x))
    assert abs(x[-1]) > 2 * np.pi
    assert np.max(worst) <= 1e-12


# -------- stiff modes at one millisecond


implicit_methods = pytest.mark.parametrize("method", ["modal_implicit", "modal_midpoint"])


@implicit_methods
def test_modal_implicit_steps_stay_bounded(method):
    """1 ms with axial modes of 1.4 kHz active, 5 s: the energy never grows by a tenth of the swing's."""
    q, v, totals, swing = STRETCHED, REST, [], 0.0
    for _ in range(100):
        q, v = ella().step(q, v, *FREE, 1e-3, method, 50)
        kinetic, potential = example("ella").numpy().energy(q, v)
        totals.append(kinetic + potential)
        swing = max(swing, kinetic)
    assert max(totals) - energy(STRETCHED, REST) < 0.1 * swing
    assert np.abs(q[3:]).max() < 0.05


@implicit_methods
@pytest.mark.parametrize("form", ["joint", "dae"])
def test_modes_may_be_of_any_stiffness(method, form):
    """1 ms with all modes a million times stiffer, up to 1.4 MHz: in 2 s the swing keeps its energy."""
    model, c = example("ella"), ella()
    p, q, v = np.array(model.parameter_values), STRETCHED.copy(), REST
    p[[name.endswith((".EA", ".EIy", ".EIz")) for name in model.parameter_names]] *= 1e6
    q[3:] *= 1e-6
    judge = model.numpy(p)
    first, reader = sum(judge.energy(q, v)), DaeStepper(model, method, p)
    c.prepare(p)
    try:
        for _ in range(4):
            if form == "joint":
                q, v = c.step(q, v, *FREE, 1e-3, method, 500)
            else:
                q, v = reader.coordinates(c.dae_step(c.dae_state(q, v), *FREE, 1e-3, method, 500))
            assert abs(sum(judge.energy(q, v)) - first) < (1.0 if method == "modal_implicit" else 1e-3)
    finally:
        c.prepare(model.parameter_values)


FAST = np.array([-0.256, 0.7035, 0.6334, *6 * [0.0]]), np.array([10.3694, -9.2416, 5.4964, *6 * [0.0]])
"""ELLA whose joints turn at 15 rad/s."""


@implicit_methods
def test_steps_must_resolve_the_turning(method):
    """0.015 rad a step hold, 0.075 do not: no method takes the turning itself implicitly."""
    first = energy(*FAST)
    q, v = ella().step(*FAST, *FREE, 1e-3, method, 2000)
    assert abs(energy(q, v) - first) < 0.1 * first
    with pytest.raises(ScrewgenError):
        ella().step(*FAST, *FREE, 5e-3, method, 1000)


@implicit_methods
def test_modal_implicit_steps_of_the_dae_form_stay_bounded(method):
    x = ella().dae_state(STRETCHED, REST)
    for _ in range(50):
        x = ella().dae_step(x, *FREE, 1e-3, method, 100)
        assert np.abs(x[14:20]).max() < 0.05
    assert max(violations(x)) <= 1e-12


@pytest.mark.parametrize("method", ["euler", "semi_implicit", "rk4"])
def test_explicit_steps_cannot_hold_the_axial_modes(method):
    """omega h = 8.8 is beyond every explicit bound (2 for symplectic Euler, 2.8 for RK4): they diverge, and say so."""
    with pytest.raises(ScrewgenError):
        ella().step(STRETCHED, REST, *FREE, 1e-3, method, 5000)
