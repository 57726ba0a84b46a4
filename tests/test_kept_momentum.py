"""What docs/robot.md says of a step that corrects the base's twist: momentum, energy, order, operations."""

import casadi as ca
import numpy as np
import pytest
from floating_robots import SATELLITE, momentum, start
from helpers import example, model_of, relative
from kept_momentum import keeping

from screwgen.algorithms import fused
from screwgen.algorithms import matrices as mx
from screwgen.algorithms import phases as ph
from screwgen.algorithms.functions import KINEMATICS, Functions
from screwgen.algorithms.schedule import INWARD, Phase
from screwgen.backends.casadi.expressions import expressions


@pytest.mark.long
@pytest.mark.parametrize(("method", "order", "h"), [("modal_midpoint", 2, 1e-3), ("semi_implicit", 1, 2.5e-4)])
def test_correcting_the_base_keeps_momentum_and_order(method, order, h):
    model = model_of(SATELLITE)
    functions, p = model.casadi(), model.parameter_values
    tau, w_ext = np.zeros(model.n_tau), np.zeros((6, model.n_links))
    q0, v0 = start(model)

    def step_of(name):
        return lambda q, v, h: tuple(np.array(x).ravel() for x in functions[f"step_{name}"](q, v, tau, w_ext, p, h))

    inertia = lambda q: functions["mass_matrix"](q, p).full()  # noqa: E731
    energy = lambda q, v: sum(model.numpy().energy(q, v))  # noqa: E731
    exact = keeping(step_of("rk4"), inertia)(q0, v0, 1e-4, 2000, False)[0]
    first, errors, changes = momentum(model, q0, v0), {}, {}
    for keep in (False, True):
        for n in (1, 2):
            q, v = keeping(step_of(method), inertia)(q0, v0, h / n, round(0.2 / h) * n, keep)
            errors[keep, n] = np.abs(q - exact).max()
            changes[keep] = np.abs(momentum(model, q, v) - first).max() / np.abs(first).max()
            gained = abs(energy(q, v) / energy(q0, v0) - 1)
        changes[keep, "energy"] = gained
        assert errors[keep, 1] / errors[keep, 2] == pytest.approx(2**order, rel=0.25)
    assert changes[True] < 1e-13 < 1e-9 < changes[False]
    assert changes[True, "energy"] < 2 * changes[False, "energy"] and errors[True, 2] < 1.1 * errors[False, 2]


def test_operations_of_momentum_and_locked_inertia():
    """What the correction adds for the space arm: 15 % of a step of two dynamics, but for its 6 x 6 solve."""
    model = example("space_arm")
    chain = model.chain

    def locked(s):
        total = ph.rows(s)[0]
        for section in s.sections:
            total = total + mx.shift(section.kept("r_T"), ph.tip_load(section)[0])
        if s.key.floats:
            s.keep("Lambda_i", total)
            return
        s.write("base.Lambda", mx.pack(mx.rotate(s.kept("R_P"), mx.shift(s.kept("lever"), total))))
        s.write("base.p", [0.0] * 6)

    def both(f, x):
        still = Functions(chain, f.constants, [0.0] * 3, f.apply)
        still.given = x["m_eta"], [0.0] * chain.n_given
        rest, none = [0.0] * chain.nv, [0.0] * 6 * chain.n
        force = still.inverse_dynamics(x["q"], rest, x["v"], none)
        algorithm = KINEMATICS, Phase(locked, INWARD)
        links = still._run(algorithm, still._state(x["q"], rest), still._wrenches(none))[0]
        return {"momentum": list(force[:6]), "inertia": list(links[0]["w.Lambda_i"])}

    sizes = {"q": chain.nq, "v": chain.nv, "m_eta": chain.n_inertia}
    program = fused.fuse(chain, "momentum", sizes, both, "constants")
    dynamics = fused.modal_dynamics(chain, "constants").operation_count
    assert 0.12 < program.operation_count / (2 * dynamics) < 0.17
    program, names = fused.fuse(chain, "momentum", sizes, both), ("q", "v", "m_eta", "p")
    given = {name: ca.SX.sym(name, size) for name, size in (sizes | {"p": len(model.parameter_values)}).items()}
    found = ca.Function("f", [given[name] for name in names], list(expressions(program, given).values()))
    (q, v), p = start(model), model.parameter_values
    own = next(iter(expressions(fused.modal_properties(chain), given).values()))
    columns = ca.Function("f", [given["p"]], [own])(p)
    M = model.numpy().mass_matrix(q)
    force, inertia = (np.array(x).ravel() for x in found(q, v, columns, p))
    assert relative(force, (M @ v)[:6]) < 1e-12
    assert relative(inertia, [M[i, j] for i in range(6) for j in range(i, 6)]) < 1e-12
