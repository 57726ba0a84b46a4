"""The check of predictive control: its quadratic program is the dense one of CasADi's functions."""

from __future__ import annotations

import numpy as np
from helpers import QUICK
from mpc_judge import off_the_dense_program

from conformance.cases import Case

FILE = """
[horizon]
intervals = 3
step = 4e-3
substeps = 2
blocks = [1, 2]
method = "{method}"
[goal]
joints = 0.0
[cost]
tip_position = 20.0
tip_velocity = 0.5
joints = 5.0
modes = 1.0
joint_rates = 0.1
mode_rates = 0.1
torques = 1e-2
torque_rates = 1e-6
[bounds]
torques = 25.0
torque_rates = 500.0
joints = {{ lower = -1.5, upper = 1.5 }}
joint_rates = 2.0
wrenches = [ {{ component = "{wrench}", limit = 5.0 }} ]
[solver]
delay = {delay}
"""
METHODS = ("modal_midpoint", "modal_implicit")
SMALL, LARGEST = 1e-3, 25.0
"""Changes of coordinates; inputs, among them accelerations of a base that the judge's state has far larger."""


def program(case: Case) -> None:
    """Hessian, gradient, rows and bounds about a plan that is none of the motion, given inputs other ones in every
    interval; methods and the delay take turns."""
    model, rng = case.model, np.random.default_rng(case.seed)
    said = {"method": METHODS[case.seed // 2 % 2], "delay": case.seed % 2, "wrench": model.wrench_names[-2]}
    (case.folder / "mpc.toml").write_text(FILE.format(**said))
    c = model.mpc(case.folder / "mpc.toml", flags=QUICK)
    for stage in c.reference:
        stage["tau"][:] = np.clip(case.given[2], -LARGEST, LARGEST) * rng.uniform(0.5, 1.0, model.n_tau)
    if c.fitted.given:
        c.options["given"][:] = c.reference[0]["tau"][c.fitted.given]
    sizes = np.where(np.arange(model.nv) < model.chain.eta_v, SMALL, 0.05 * SMALL)
    sizes = np.concatenate([sizes, sizes, np.full(model.chain.n_internal, 0.05 * SMALL)])
    sizes[: model.chain.base_v] = 1e-4 * SMALL
    off = off_the_dense_program(c, model, model.chain.home, sizes)
    assert off <= 100 * case.tolerance, f"off by {off:.1e}"
