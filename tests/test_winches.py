"""Lines whose rest length a winch changes: by closed forms, by their energy, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
from helpers import model_of

import screwgen

MASS, STIFFNESS, DAMPING, GRAVITY, REST = 10.0, 5e3, 40.0, 9.81, 1.5
SPEED = 0.4
"""m/s: at which the load is lifted."""


def hoist(**line) -> dict:
    """A load that slides up and down on a line from a point 2 m above."""
    body = {"at": "tip", "mass": MASS, "inertia": [0.1, 0.1, 0.1, 0.0, 0.0, 0.0]}
    load = {"name": "load", "joint": {"axes": [{"slide": "z"}]}, "bodies": [body]}
    line = {"stiffness": STIFFNESS, "rest": REST, "damping": DAMPING, "winch": True} | line
    rope = {"name": "rope", "between": [{"world": [0.0, 0.0, 2.0]}, "load.tip"], "line": line}
    return {"name": "hoist", "gravity": [0.0, 0.0, -GRAVITY], "links": [load], "forces": [rope]}


HANGING = 2.0 - REST - MASS * GRAVITY / STIFFNESS


def lifted(step: float, **line) -> screwgen.Run:
    """From rest at a constant speed; every step holds what the winch has paid out at its middle."""
    wound = lambda t, q, v: [0.0, -SPEED * (t + step / 2), -SPEED]  # noqa: E731
    return screwgen.simulate(model_of(hoist(**line)), 0.5, step, q0=[HANGING], controller=wound, integrator="rk4")


def closed_form(t: np.ndarray) -> np.ndarray:
    """A mass on a spring and a damper whose upper end moves at once at the speed."""
    decay = DAMPING / (2 * MASS)
    omega = np.sqrt(STIFFNESS / MASS - decay**2)
    return HANGING + SPEED * (t - np.exp(-decay * t) * np.sin(omega * t) / omega)


@pytest.mark.parametrize("slack", [False, True])
def test_a_load_that_is_lifted_follows_the_closed_form(slack):
    errors = [np.abs((run := lifted(h, slack=slack)).q[:, 0] - closed_form(run.t)).max() for h in (2e-3, 1e-3)]
    assert errors[1] < 1e-6 and errors[0] / errors[1] == pytest.approx(4.0, rel=0.05), errors


def test_the_winch_gives_the_energy_that_the_load_gains():
    """Without a damper."""
    run, step = lifted(1e-3, damping=0.0), 1e-3
    stretch = 2.0 - run.q[:, 0] - REST + SPEED * run.t
    held = stretch + SPEED * step / 2  # the samples have what a step holds
    weight = MASS * GRAVITY * run.q[:, 0]
    assert run.drive_power[:, 2] == pytest.approx(SPEED * STIFFNESS * held, rel=1e-9)
    assert run.force_quantities[:, 1] == pytest.approx(STIFFNESS * held, rel=1e-9)
    assert run.energy[:, 1] - run.energy[0, 1] == pytest.approx(
        weight - weight[0] + STIFFNESS * (held**2 - held[0] ** 2) / 2, abs=1e-9
    )
    energy = MASS * run.v[:, 0] ** 2 / 2 + weight + STIFFNESS * stretch**2 / 2
    power = SPEED * STIFFNESS * stretch
    given = np.append(0.0, np.cumsum((power[1:] + power[:-1]) / 2 * np.diff(run.t)))
    assert energy - energy[0] == pytest.approx(given, abs=1e-8) and given[-1] > 15.0


def test_an_idle_winch_is_the_line_of_the_file():
    wound, bare = model_of(hoist()).numpy(), model_of(hoist(winch=False)).numpy()
    for f, tau in ((wound, [1.0, 0.0, 0.0]), (bare, [1.0])):
        found = f.forward_dynamics([0.3], [0.2], tau, None)[0]
        assert found == pytest.approx((1.0 - MASS * GRAVITY + STIFFNESS * 0.2 - DAMPING * 0.2) / MASS, rel=1e-12)


def test_a_load_rests_where_the_winch_holds_it():
    model = model_of(hoist(slack=True))
    rest = screwgen.equilibrium(model, [0.6], tau=[0.0, -0.3, 0.0])
    assert rest.q == pytest.approx([HANGING + 0.3], rel=1e-10) and list(rest.tau) == [0.0, -0.3, 0.0]
    with pytest.raises(screwgen.UsageError, match=r"tau: rope\.speed is 0\.1, .*; set it to zero, or simulate it$"):
        screwgen.equilibrium(model, [0.6], tau=[0.0, 0.0, 0.1])


class Magnet(screwgen.interactions.SpringLine):
    """A line with an input whose name torques of axes have."""

    KIND = "magnet"
    INPUTS = {"torque": screwgen.interactions.ForceInput("A", "current", "i")}  # noqa: RUF012

    @staticmethod
    def has_inputs(has) -> bool:
        return True


def test_an_input_with_the_name_of_another_kind_is_refused():
    stated = hoist() | {"forces": [{"name": "m", "between": ["world", "load.tip"], "law": Magnet(stiffness=1.0)}]}
    with pytest.raises(screwgen.UsageError, match=r"inputs: 'm\.torque' is a name that the product's own inputs have"):
        model_of(stated)
