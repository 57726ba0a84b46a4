"""Friction that remembers (LuGre's), an internal state: its published properties, and an independent integration."""

from __future__ import annotations

import numpy as np
import pytest
from helpers import model_of
from scipy.integrate import solve_ivp

import screwgen

COULOMB, STATIC, SPEED = 1.0, 1.5, 1e-3
STIFF, DAMP, VISCOUS = 1e5, 316.0, 0.4
"""The numbers of the paper that introduced the model, with a mass of 1 kg: N, m/s, N/m, N·s/m."""
FRICTION = {
    "coulomb": COULOMB,
    "viscous": VISCOUS,
    "memory": {"stiffness": STIFF, "damping": DAMP},
    "stribeck": {"static": STATIC, "velocity": SPEED},
}
INERTIA = [1e-2, 1e-2, 1e-2, 0.0, 0.0, 0.0]


def cart(friction: dict = FRICTION):
    """A mass of 1 kg that slides on a plane."""
    link = {"name": "cart", "length": 0.3, "bodies": [{"at": "tip", "mass": 1.0, "com": [0.0] * 3, "inertia": INERTIA}]}
    joint = {"axes": [{"slide": "x"}], "drives": [{"friction": friction}]}
    return model_of({"name": "rubbing", "gravity": [0.0, 0.0, -9.81], "links": [link | {"joint": joint}]})


def steady(w: float) -> float:
    """The friction of bristles that slip steadily, without the viscous part."""
    return np.sign(w) * (COULOMB + (STATIC - COULOMB) * np.exp(-((w / SPEED) ** 2)))


def pushed(model, force, duration: float, step: float, **more):
    """A run from rest under a force ``t -> N``."""
    return screwgen.simulate(model, duration=duration, step=step, controller=lambda t, q, v: [force(t)], **more)


@pytest.mark.parametrize("method", ["modal_midpoint", "modal_implicit", "rk4", "semi_implicit"])
def test_a_run_is_that_of_a_stiff_solver(method):
    """Of SciPy, on equations that are written here; at a step over which explicit methods bear the bristles."""

    def rates(t, x):
        _, w, z = x
        zdot = w - STIFF * abs(w) * z / abs(steady(w or 1e-30))
        return [w, force(t) - VISCOUS * w - STIFF * z - DAMP * zdot, zdot]

    def force(t):
        return 2.5 * np.sin(40.0 * t)

    wanted = solve_ivp(rates, (0.0, 0.1), [0.0] * 3, method="Radau", rtol=1e-9, atol=1e-13).y[:, -1]
    run = pushed(cart(), force, 0.1, 1e-5, integrator=method)
    found = np.array([run.q[-1, 0], *run.v[-1]])
    assert np.abs(found - wanted).max() <= 3e-3 * np.abs(wanted).max()
    assert abs(found[2] - wanted[2]) <= 0.02 * abs(wanted[2])


def test_it_sticks_as_a_spring_and_breaks_away_at_its_static_friction():
    """A force that grows slowly: bristles give F = g (1 - exp(-σ x / g)) the first time; the mass lets go near F_s."""
    run = pushed(cart(), lambda t: t, 2.0, 1e-4)
    for force in (0.3, 0.9):
        way = -STATIC / STIFF * np.log(1 - force / STATIC)
        assert run.q[np.searchsorted(run.t, force), 0] == pytest.approx(way, rel=0.02)
    (a, _), _ = cart().numpy().forward_dynamics([0.0], [0.0, 2e-6], [0.0], None)
    assert -a == pytest.approx(2e-6 * STIFF)
    moving = run.t[np.argmax(run.v[:, 0] > 0.01)]
    assert STATIC * 0.98 < moving < STATIC * 1.05


def test_it_holds_without_creep_under_half_of_its_static_friction():
    """For a hundred seconds, at a step a hundred times as long as the bristles' swing."""
    run = pushed(cart(), lambda t: STATIC / 2, 100.0, 0.02)
    settled = run.q[np.searchsorted(run.t, 10.0), 0]
    assert 0 < settled < 1e-4
    assert abs(run.q[-1, 0] - settled) < 1e-12


def test_a_steady_rate_meets_the_curve_of_stribeck():
    """At twenty rates, both ways: where z stays the friction is that of the curve."""
    numeric = cart().numpy()
    for w in np.geomspace(1e-5, 1.0, 10):
        for rate in (w, -w):
            z = steady(rate) / STIFF
            (a, zdot), _ = numeric.forward_dynamics([0.0], [rate, z], [0.0], None)
            assert abs(zdot) < 1e-12 * w
            assert -a == pytest.approx(steady(rate) + VISCOUS * rate, rel=1e-10)


def test_small_motions_to_and_fro_take_energy_and_close_their_loop():
    """The work of a force over a period is what is lost, and positions return to within what the loop drifts."""
    run = pushed(cart(), lambda t: 0.9 * np.sin(2 * np.pi * t), 6.0, 1e-4)
    period = np.searchsorted(run.t, 1.0)
    power = run.tau[:, 0] * run.v[:, 0]
    work = [1e-4 * power[k : k + period].sum() for k in (4 * period, 5 * period)]
    assert work[1] > 0 and work[1] == pytest.approx(work[0], rel=0.02)
    last, before = run.q[5 * period, 0], run.q[4 * period, 0]
    assert abs(last - before) < 0.05 * np.ptp(run.q[4 * period :, 0])


def test_nothing_is_gained():
    """Energy, that of the bristles included, never grows while nothing pushes."""
    run = screwgen.simulate(cart(), duration=1.0, step=1e-4, v0=[0.4])
    total = run.outputs["kinetic"] + run.outputs["potential"] if hasattr(run, "outputs") else None
    if total is None:
        numeric = cart().numpy()
        total = np.array([sum(numeric.energy(q, v)) for q, v in zip(run.q[::20], run.v[::20], strict=True)])
    assert np.diff(total).max() < 1e-9 and abs(run.v[-1, 0]) < 1e-6


def test_a_spring_that_is_drawn_makes_it_stick_and_slip():
    """As published with the model: drawn by 2 N/m at 0.1 m/s it sticks until 1.5 N, and slips in jumps from then on."""
    drawn, rate = 2.0, 0.1
    law = lambda t, q, v: [drawn * (rate * t - q[0])]  # noqa: E731
    run = screwgen.simulate(cart(), duration=20.0, step=1e-3, controller=law)
    slips = np.flatnonzero(np.diff((run.v[:, 0] > 0.02).astype(int)) == 1)
    assert run.t[slips[0]] == pytest.approx(STATIC / drawn / rate, rel=0.02)
    stuck = run.v[:, 0] < 1e-3
    assert len(slips) >= 2 and 0.3 < stuck[slips[0] :].mean() < 0.9


@pytest.mark.parametrize(
    ("friction", "said"),
    [
        ({"memory": {"stiffness": 900.0}}, "states no friction"),
        ({"viscous": 1.0, "memory": {"stiffness": 900.0}}, "state the friction of bristles that slip"),
        ({"coulomb": 0.0, "memory": {"stiffness": 900.0}}, "state the friction of bristles that slip"),
        (
            {"coulomb": 1.0, "velocity": 0.1, "memory": {"stiffness": 900.0}},
            "whose bristles stick and would creep with a smooth sign; leave it out",
        ),
        ({"coulomb": 1.0, "memory": {"stiffness": 0.0}}, "stiffness"),
    ],
)
def test_what_cannot_be_is_refused_in_a_line(friction, said):
    with pytest.raises(ValueError, match=said):
        cart(friction)
