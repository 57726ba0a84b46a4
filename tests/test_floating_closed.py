"""Floating bases with gears, dry friction and loops: closing, conservation laws, runs, batches."""

from functools import cache

import numpy as np
import pytest
from batch_c import STRICT
from conftest import swept
from dual_arm import dual_arm, start, torques
from floating_robots import SATELLITE, momentum
from floating_robots import start as flying
from helpers import model_of, quick, quick_batch, relative

from screwgen import PD, OpenLoopError, UsageError, assemble, rollout, simulate
from screwgen.integrators import METHODS
from screwgen.runtime.compiled import Compiled
from screwgen.simulation.dae import DaeStepper

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
