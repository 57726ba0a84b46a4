"""A dead load: a wrench at a marker in axes of the world, of which a body that tumbles takes the whole impulse."""

from __future__ import annotations

import numpy as np
import pytest
from floating_robots import SATELLITE
from helpers import model_of

import screwgen

FORCE, DURATION = np.array([20.0, 0.0, 0.0]), 1.0
"""N, and s that it lasts."""


def tumbling(axes: str, links: int = 4) -> screwgen.Model:
    """The satellite with stiff arms, or its hull with one arm that is welded to it."""
    stiff = [{key: x for key, x in link.items() if key != "modes"} for link in SATELLITE["links"]]
    if links == 2:
        stiff = [stiff[0], stiff[2] | {"parent": "hull", "joint": {"axes": []}}]
    return model_of(SATELLITE | {"links": stiff, "pushes": [{"name": "load", "at": "left_fore.tip", "axes": axes}]})


def lost(model: screwgen.Model, step: float, method: str, turned: bool = False) -> float:
    """What a run leaves out of the impulse, N·s; ``turned``: the wrench is stated in the turning axes of the tip."""
    numeric, at = model.numpy(), model.chain.wrench_rows["load"]
    tip, v0 = model.chain.names.index("left_fore"), np.full(model.nv, 0.3)
    v0[:6] = 0.3, -0.5, 0.4, 0.2, 0.1, -0.3

    def load(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        w_ext = np.zeros((model.n_links, 6))
        w_ext[at, 3:] = numeric.link_pose(q)[0][tip].T @ FORCE if turned else FORCE
        return w_ext

    run = screwgen.simulate(model, DURATION, step, v0=v0, w_ext=load, integrator=method)
    first, last = (numeric.momentum(run.q[k], run.v[k])[1] for k in (0, -1))
    return float(np.abs(last - first - DURATION * FORCE).max())


@pytest.mark.parametrize(("method", "order", "most"), [("rk4", 4, 5e-8), ("modal_midpoint", 2, 5e-3)])
def test_what_is_lost_of_its_impulse_is_of_the_order_of_the_method(method, order, most):
    """Every stage of a step has it in the axes of its own posture."""
    model = tumbling("world")
    errors = [lost(model, step, method) for step in (5e-3, 2.5e-3)]
    assert errors[0] < most and np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.1)


def test_by_rk4_the_impulse_is_whole_to_the_last_digits():
    assert lost(tumbling("world", 2), 1e-3, "rk4") < 1e-12 * np.linalg.norm(FORCE) * DURATION


def test_in_axes_that_a_step_holds_it_is_of_first_order():
    errors = [lost(tumbling("marker", 2), step, "rk4", turned=True) for step in (5e-3, 2.5e-3)]
    assert errors[0] > 1e-3 and errors[0] / errors[1] == pytest.approx(2.0, rel=0.05)
