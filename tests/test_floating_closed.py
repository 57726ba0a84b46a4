"""Floating bases with gears, dry friction and loops: the oracle, conservation laws, and all back ends."""

import subprocess
from functools import cache

import casadi as ca
import numpy as np
import pytest
from batch_c import STRICT
from conftest import require_tool, swept
from dual_arm import dual_arm, start, torques
from floating_robots import SATELLITE, TAU, momentum
from floating_robots import start as flying
from helpers import casadi_forward, flat, model_of, quick, quick_batch, relative
from oracle import Oracle, part_error
from oracle_floating import case_of, coordinates, draw, twin
from test_couplings import coupled, names
from test_loops import JOINTS, SIXTH, bridged, constrained

from screwgen import PD, OpenLoopError, UsageError, assemble, rollout, simulate
from screwgen.backends.casadi.functions import coordinate_rates
from screwgen.backends.numpy.closing import moving
from screwgen.backends.numpy.dae_step import space_of
from screwgen.integrators import METHODS
from screwgen.runtime.batch import CompiledBatch
from screwgen.runtime.compiled import Compiled
from screwgen.simulation.dae import DaeStepper
from screwgen.studies.assemble import redundant

SMALL = 16
"""The draw of drives that is kept: it has an elastic gear and dry friction."""

# -------- random robots against the oracle


@pytest.mark.parametrize("seed", swept(range(24), SMALL))
def test_random_drives_equal_the_oracle_in_every_back_end(seed):
    more = {} if seed == SMALL else {"second_order": 0.1, "stations": 0.2}
    more |= {"sliding": 0.3, "branching": 0.4, "bodies": 0.8, "drives": 0.9}
    case = draw(9100 + seed, 2 + seed % 4, max_modes=1 + seed % 4, **more)
    numeric, library = case.model.numpy(), quick(case.model, layout=("fused", "modular")[seed % 2])
    found = [numeric.forward_dynamics(*case.given), numeric.dae_forward_dynamics(*case.given)]
    found += [casadi_forward(case.model, *case.given)]
    found += [library.forward_dynamics(*case.given, form) for form in ("joint", "dae")]
    assert max(error for x in found for error in case.errors(*x).values()) < case.tolerance
    q, v = case.given[:2]
    assert numeric.energy(q, v) == pytest.approx(case.oracle.energy(case.state["q"], case.state["v"]), rel=1e-11)


@pytest.mark.parametrize("closing", ["loop", "coupling", "loop and coupling"])
@pytest.mark.parametrize("seed", swept(range(2 * len(JOINTS)), 6))
def test_random_closed_trees_equal_the_constrained_oracle(seed, closing):
    """What closes is closed; in every other draw open, unless rows are left out that an open loop leaves unequal."""
    rng, more = np.random.default_rng([950, seed]), {"branching": 0.5, "drives": 0.4, "max_modes": 1}
    case = draw(9300 + seed, 3 + seed % 3 + ("coupling" in closing), **more)
    robot, state = case.robot, case.state
    if "loop" in closing:
        robot, state = bridged(rng, JOINTS[seed % len(JOINTS)], robot, state, case.oracle)
    if "coupling" in closing:
        couplings = coupled(rng, twin(robot), state, among=names(robot))["couplings"]
        assert couplings
        robot = robot | {"couplings": couplings}
    oracle, model = Oracle(twin(robot)), model_of(robot)
    opened = seed % 2 and not redundant(model)
    if opened:
        state["q"] = state["q"] + 0.02 * rng.normal(size=oracle.nv) * (np.arange(oracle.nv) < oracle.n_joint)
    closed = case_of(robot, state, oracle)
    q, v, tau, w_ext = closed.given
    numeric = model.numpy()
    if not opened:
        assert np.max(np.abs(numeric.gaps(q, None)[0])) < 1e-12
        v = moving(numeric, q, v)
        assert np.allclose(v[:6], closed.given[1][:6], rtol=0, atol=1e-13)
        state["v"] = np.linalg.solve(closed.twist_map(), v)
        v = coordinates(oracle, state["q"], state["v"])[1]
    vdot = constrained(oracle, twin(robot), state | {"tau": np.append(np.zeros(6), tau)})
    expected = np.append(oracle.link_twist_rates(state["q"], state["v"], vdot)[0], vdot[6:])
    library = quick(model, layout=("fused", "modular")[seed % 2])
    given = q, v, tau, w_ext
    found = [numeric.forward_dynamics(*given), numeric.dae_forward_dynamics(*given), casadi_forward(model, *given)]
    found += [library.forward_dynamics(*given, form) for form in ("joint", "dae")]
    for x, _ in found:
        for part in (np.s_[:6], np.s_[6 : model.chain.eta_v], np.s_[model.chain.eta_v :]):
            assert part_error(expected[part], x[part], expected) < 1e-9


# -------- derivatives, and the export to acados


def tangent(model, q) -> np.ndarray:
    """(nq, nv): the rates of q by those in v, to which a change of the pose by ``exp(delta)`` belongs."""
    x, v = ca.SX.sym("q", model.nq), ca.SX.sym("v", model.nv)
    rates = coordinate_rates(model.chain, x, v, ca.SX(ca.DM(model.parameter_values)))
    return ca.Function("tangent", [x], [ca.jacobian(rates, v)])(q).full()


@pytest.mark.parametrize("seed", swept(range(12), 0))
def test_derivatives_along_the_rates_equal_automatic_ones(seed):
    """In NumPy and C: of a floating base with ``pose exp(delta)``."""
    more = {"drives": 0.6, "sliding": 0.3, "branching": 0.4, "bodies": 0.8}
    case = draw(
        9100 + seed, 2 + seed % 3, max_modes=1, **more | ({"second_order": 0.2, "stations": 0.2} if seed else {})
    )
    model, (q, v, tau, w_ext) = case.model, case.given
    f = model.casadi()["forward_dynamics"].jacobian()
    by_q, by_v, by_tau = (x.full() for x in f(q, v, tau, w_ext.T, model.parameter_values, 0, 0)[:3])
    expected = by_q @ tangent(model, q), by_v, by_tau
    library = quick(model, layout=("fused", "modular")[seed % 2], derivatives=True)
    for found in (model.numpy().derivatives(*case.given), library.linearise(*case.given)[1:]):
        for x, y in zip(found, expected, strict=True):
            assert x.shape == y.shape and relative(x, y) < 10 * case.tolerance


def test_derivatives_with_the_pose_are_those_of_its_exponential():
    """By differences of sixth order along ``pose exp(delta)``, in weight."""
    model = model_of({**SATELLITE, "gravity": [1.0, 2.0, -9.0]})
    (q, v), tau, numeric, space = flying(model), np.array(TAU), model.numpy(), space_of(model.chain)
    by_q, h = numeric.derivatives(q, v, tau, None)[0], 1e-3
    at = lambda u: numeric.forward_dynamics(space.moved(q, u), v, tau, None)[0]  # noqa: E731
    for k in range(8):
        unit = np.eye(model.nv)[k]
        slope = sum(c * (at(j * h * unit) - at(-j * h * unit)) for j, c in SIXTH) / h
        assert np.max(np.abs(by_q[:, k] - slope)) < 1e-7 * np.max(np.abs(by_q[:, : k + 1]))


def test_acados_takes_position_and_quaternion_as_plain_states():
    model = model_of(SATELLITE)
    (q, v), tau, p = flying(model), np.array(TAU), model.parameter_values
    export = model.acados()
    assert export.x.numel() == model.nq + model.nv and export.x_labels[3] == "base.qw"
    given = [export.x, export.xdot, export.u, export.p]
    f = ca.Function("f", given, [export.f_expl_expr, export.f_impl_expr, ca.jacobian(export.f_impl_expr, export.xdot)])
    x = np.append(q, v)
    rate = flat(f(x, np.zeros(len(x)), tau, p)[0])
    expected = model.numpy().forward_dynamics(q, v, tau, None)[0]
    assert relative(rate[: model.nq], tangent(model, q) @ v) < 1e-14 and relative(rate[model.nq :], expected) < 1e-11
    _, implicit, slope = f(x, rate, tau, p)
    assert np.max(np.abs(implicit)) < 1e-9 and np.linalg.matrix_rank(slope.full()) == len(x)
    dae = model.acados(form="dae")
    given = [dae.x, dae.xdot, dae.z, dae.u, dae.p]
    f = ca.Function("f", given, [dae.f_impl_expr, ca.jacobian(dae.f_impl_expr, ca.vertcat(dae.xdot, dae.z))])
    place = model.casadi()["dae_state"](q, v, p)
    misfit, slope = f(place, np.zeros(dae.x.numel()), np.zeros(dae.z.numel()), tau, p)
    unknown = -np.linalg.solve(slope.full(), misfit.full())[:, 0]
    z = unknown[dae.x.numel() :]
    assert relative(z[6:12], expected[:6]) < 1e-10 and not np.any(np.abs(z[:6]) > 1e-9)


# -------- two arms that hold one object


@cache
def holding(planar: bool = True):
    return model_of(dual_arm(planar))


def test_arms_in_a_plane_have_three_rows_and_closing_leaves_the_base_where_it_is():
    model = holding()
    assert [row.text for row in model.chain.closing.rows] == [
        "loop[0], distance along x",
        "loop[0], distance along y",
        "loop[0], angle between x and y",
    ]
    q, v = start(model)
    gap, rate = model.numpy().gaps(q, v)
    assert np.max(np.abs(gap)) < 1e-12 and np.max(np.abs(rate)) < 1e-12
    off = q.copy()
    off[7:11] += (0.02, -0.03, 0.05, 0.01)
    again = assemble(model, off)
    assert np.array_equal(again[:7], q[:7]) and np.max(np.abs(model.numpy().gaps(again, None)[0])) < 1e-12
    home = assemble(model, q[7:11])
    assert np.array_equal(home[:7], model.chain.home[:7]) and np.allclose(home[7:], q[7:], atol=1e-9)
    with pytest.raises(OpenLoopError, match=r"loop\[0\] stays open by"):
        assemble(model, off, hold=[f"{arm}.joint[0]" for arm in ("left", "left_fore", "right", "right_fore")])


def test_what_closes_the_loop_keeps_momentum_and_centre_of_mass():
    """A projection's corrections are those of forces inside the robot: of q to second order in the gap."""
    model, (q, v) = holding(), start(holding())
    faster = v + 0.05 * np.cos(np.arange(model.nv))
    end = projected(model, q, faster)
    assert np.max(np.abs(model.numpy().gaps(*end)[1])) < 1e-12 < np.max(np.abs(end[1] - faster))
    assert relative(momentum(model, *end), momentum(model, q, faster)) < 1e-10
    moved = []
    for size in (1e-2, 1e-3):
        off = q.copy()
        off[7:11] += size * np.array([0.5, -1.0, 1.0, 0.3])
        end, _ = projected(model, off, np.zeros(model.nv))
        assert np.max(np.abs(model.numpy().gaps(end, None)[0])) < 1e-12
        assert abs(np.linalg.norm(end[3:7]) - 1) < 1e-15 and np.any(end[:3] != off[:3])
        moved.append(np.max(np.abs(first_moment(model, end) - first_moment(model, off))))
    assert moved[0] < 1e-2 and moved[1] < 0.02 * moved[0]


def projected(model, q, v) -> tuple[np.ndarray, np.ndarray]:
    """q and v of the DAE form's projection."""
    stepper = DaeStepper(model, "rk4", model.parameter_values)
    return stepper.coordinates(model.numpy().project(model.numpy().dae_state(q, v)))


def first_moment(model, q) -> np.ndarray:
    """Mass times the place of the centre of mass, by the potential of weight."""
    p = np.tile(model.parameter_values, (4, 1))
    p[1:, :3] = -np.eye(3)
    potential = [model.numpy(x).energy(q, np.zeros(model.nv))[1] for x in p]
    return np.array(potential[1:]) - potential[0]


@pytest.mark.parametrize("planar", swept([True, False], True))
def test_momentum_and_energy_are_conserved_with_gears_and_a_loop(planar):
    """Over 1e4 steps of rk4: momentum with torques and friction, energy without."""
    model, library = holding(planar), quick(holding(planar)).fresh()
    (q, v), still = (
        start(model),
        [x for x in model.parameter_names if "damping" in x or "coulomb" in x or "viscous" in x],
    )
    for friction in (True, False):
        library.prepare(None if friction else dict.fromkeys(still, 0.0))
        tau = torques(model) if friction else np.zeros(model.n_tau)
        a, b = library.step(q, v, tau, None, 1e-4, "rk4", 10_000)
        assert np.abs(a[7:] - q[7:]).max() > 0.1
        assert relative(momentum(model, a, b), momentum(model, q, v)) < 1e-9
        gap, rate = model.numpy().gaps(a, b)
        assert np.max(np.abs(gap)) < 1e-9 and np.max(np.abs(rate)) < 1e-9
        energies = [sum(model.numpy().energy(*x)) for x in ((q, v), (a, b))]
        assert friction or abs(energies[1] / energies[0] - 1) < 1e-7


@pytest.mark.parametrize("method", swept(METHODS, "modal_midpoint"))
def test_steps_of_all_back_ends_and_forms_agree(method):
    model = holding()
    (q0, v0), tau = start(model), torques(model)
    joint, dae = (simulate(model, 1e-3, 1e-4, q0, v0, tau, None, method, form) for form in ("joint", "dae"))
    q, v = quick(model).step(q0, v0, tau, None, 1e-4, method, 10)
    step, a, b = model.casadi()[f"step_{method}"], q0, v0
    for _ in range(10):
        a, b = map(flat, step(a, b, tau, np.zeros((6, model.n_links)), model.parameter_values, 1e-4))
    for x in ((q, v), (a, b)):
        assert relative(np.append(*x), np.append(joint.q[-1], joint.v[-1])) < 1e-12
    order = METHODS[method].order
    assert relative(dae.q[-1], joint.q[-1]) < {1: 1e-5, 2: 1e-7, 4: 1e-10}[order]
    assert relative(momentum(model, dae.q[-1], dae.v[-1]), momentum(model, q0, v0)) < {1: 1e-2, 2: 1e-4, 4: 1e-9}[order]
    assert np.max(np.abs(np.concatenate(model.numpy().gaps(dae.q[-1], dae.v[-1])))) < 1e-11


@pytest.mark.parametrize("layout", swept(["fused", "modular"]))
def test_the_self_check_of_the_c_passes(layout, tmp_path):
    model = holding()
    model.write(tmp_path, targets=("c",), layout=layout)
    make = [require_tool("make"), "CFLAGS=-O0", "-C", tmp_path / "c", "check"]
    done = subprocess.run(make, capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.count("all checks passed") == 2, done.stdout[-2000:] + done.stderr
    assert "warning" not in done.stderr


def test_a_law_moves_the_arms_through_their_gears():
    """The compiled loop of a run and the law in Python, which read the rotors behind the base."""
    model = holding()
    q, v = start(model)
    goal = assemble(model, q[7:11] + 0.1 * np.eye(4)[0], hold=["left.joint[0]"])[7:11]
    law = PD(kp=(100.0, 4.0) * 2, kd=(10.0, 1.0) * 2, q_des=tuple(goal))
    runs = [simulate(model, 0.02, 1e-3, q, v, law, backend=backend) for backend in ("c", "numpy")]
    assert relative(runs[0].q[-1], runs[1].q[-1]) < 1e-10
    apart = lambda x: np.abs(x[7:11] - goal).max()  # noqa: E731
    longer = simulate(model, 3.0, 1e-3, q, np.zeros(model.nv), law, every=100)
    assert apart(longer.q[-1]) < 0.1 * apart(q)


# -------- batches


@pytest.mark.parametrize("robot", swept(["satellite", "dual_arm"], "dual_arm"))
def test_a_batch_has_the_bits_of_the_compiled_steps(robot):
    model = holding() if robot == "dual_arm" else model_of(SATELLITE)
    q, v = (start if robot == "dual_arm" else flying)(model)
    x = np.tile(np.append(q, v), (5, 1))
    x[:, model.nq :] *= np.linspace(0.2, 1.0, 5)[:, None]
    x[1, 3:7] *= 1.0005
    tau, library = 0.1 * torques(model), Compiled(model, "fused", flags=STRICT, cache=True)
    quick_batch(model)
    for method in METHODS:
        found = rollout(model, x, tau, step=1e-4, steps=3, substeps=2, integrator=method)
        assert found.ok.all() and found.q.shape == (5, 4, model.nq) and found.v.shape == (5, 4, model.nv)
        assert found.x.shape == (5, 4, model.nq + model.nv)
        for i in range(5):
            end = library.step(found.q[i, 0], found.v[i, 0], tau, None, 5e-5, method, 6)
            assert all(np.array_equal(*pair) for pair in zip(end, (found.q[i, -1], found.v[i, -1]), strict=True))
    assert abs(np.linalg.norm(found.q[1, 0, 3:7]) - 1) < 1e-15


@pytest.mark.long
def test_a_batch_of_one_lane_and_in_single_precision():
    model = model_of(SATELLITE)
    q, v = (a[:, None] for a in flying(model))
    flags = (*STRICT, "-DSATELLITE_LANE_BYTES=0")
    ends = []
    for single in (False, True):
        b = CompiledBatch(model, single, flags)
        paths = [np.repeat(a[None], 2, 0).astype(b.real) for a in (q, v)]
        inputs = [np.zeros((1, n, 1), b.real) for n in (model.n_tau, 6 * model.n_links)]
        status, *_ = b.run(*paths, *inputs, b.constants(np.atleast_2d(model.parameter_values)), 1e-3, 5, "rk4", 1)
        assert not status.any()
        ends.append(np.concatenate([path[1, :, 0] for path in paths]))
    step = Compiled(model, "fused", flags=STRICT, cache=True).step(q[:, 0], v[:, 0], None, None, 1e-3, "rk4", 5)
    assert np.array_equal(ends[0], np.concatenate(step)) and relative(ends[1], ends[0]) < 1e-4


def test_states_of_a_batch_that_are_none_are_refused():
    model = model_of(SATELLITE)
    with pytest.raises(
        UsageError, match=r"x0 has the shape \(2, 34\); it must be \(batch, nq \+ nv\) or \(nq \+ nv,\)"
    ):
        rollout(model, np.zeros((2, 34)), step=1e-3, steps=1)
    x = np.tile(np.append(*flying(model)), (2, 1))
    x[1, 3:7] *= 2.0
    with pytest.raises(UsageError, match=r"x0 has a quaternion of length 2, entries 3 to 6 .* of scenario 1; it must"):
        rollout(model, x, step=1e-3, steps=1)
