"""A kind of joint that the product does not contain: a ball joint whose rates are in axes of its carrier.

The product's own ball joint has them in axes of the link, where its motion subspace is constant. Here it turns with the
link. The same robot with the product's joint is the judge.
"""

import copy
from dataclasses import dataclass

import numpy as np
import pytest
from conftest import package
from floating_robots import SATELLITE, rod
from helpers import casadi_forward, flat, model_of, quick, relative
from scipy.spatial.transform import Rotation

from screwgen import Robot, UsageError, dump, rollout, simulate
from screwgen.algebra.expression import identity, zeros
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.integrators import METHODS
from screwgen.joints.ball import TURNS
from screwgen.joints.exponential import (
    angular_velocity,
    cross,
    quaternion_rate,
    rotated,
    rotation,
    turn_between,
    turned,
)
from screwgen.joints.kind import JointKind, Kinematics


def back(Q):
    """The conjugate of a quaternion, which turns back."""
    return np.concatenate([Q[:1], -Q[1:]])


@dataclass(frozen=True)
class CarriedBall(JointKind):
    """``q``: the quaternion of F_i in the mount's axes; rates: the angular velocity of the link relative to it there.

    A change u moves the link by ``exp(u)`` before its own turn.
    """

    def kinematics(self, coordinates):
        R = rotation(coordinates)
        return Kinematics(R, zeros(3), R.T @ identity(3), zeros(3, 3))

    def integrate(self, q, u, series):
        return back(turned(back(q), -u, series))

    def difference(self, q, other, series):
        return rotated(q, turn_between(q, other))

    def rate(self, u, v):
        first = cross(u, v)
        return v - first / 2 + cross(u, first) / 12

    def coordinate_rates(self, q, v):
        return back(quaternion_rate(back(q), -v))

    def rates_of(self, q, change):
        return -angular_velocity(back(q), back(change))

    def carried(self, v):
        return cross(v[None], np.eye(3)).T


CARRIED_BALL = CarriedBall(4, 3, 3, name="carried ball", along=TURNS, turn_at=0)
TAU = np.array([0.3, -0.2, 0.1, 0.2, 0.1, -0.1])
W_EXT = np.zeros((4, 6))


def robot(kind):
    """A free hull with two arms; the shoulder of the first is of the kind, and damped alike in all directions."""
    out = copy.deepcopy(SATELLITE)
    out["links"][1] = rod("left", [], parent="hull", mount={"xyz": [0.0, 0.3, 0.0], "rpy": [0.2, -0.4, 0.7]})
    out["links"][1]["joint"] |= {"axes": kind, "damping": [0.2, 0.2, 0.2]}
    return out


@pytest.fixture(scope="module")
def pair():
    """The robot with the joint from outside, and with the product's."""
    return model_of(robot(CARRIED_BALL)), model_of(robot("ball"))


@pytest.fixture(scope="module")
def compiled(pair):
    return quick(pair[0], derivatives=True)


def start(model):
    """A posture and rates without pattern."""
    rng, chain = np.random.default_rng(3), model.chain
    size = np.where(np.arange(chain.nv) < chain.eta_v, 1.0, 0.02)
    q = chain.integrate(np.array(chain.home), 0.4 * size * rng.normal(size=chain.nv), SERIES)
    return q, 0.3 * size * rng.normal(size=chain.nv)


def shoulder(model):
    return model.chain.curved[1]


def to_link(model, q):
    """(nv, nv): rates of the robot from outside to those of the product's, which are in axes of the link."""
    part, out = shoulder(model), np.eye(model.nv)
    out[part.v, part.v] = Rotation.from_quat(q[part.q], scalar_first=True).as_matrix().T
    return out


def torques(model, tau, turn):
    """Torques of the robot from outside as those of the product's."""
    first = model.chain.base_v
    own = turn[first : first + model.n_tau, first : first + model.n_tau]
    return own @ tau


def expected(pair):
    """Accelerations and wrenches of the product's robot, as those of the one from outside."""
    q, v = start(pair[0])
    turn = to_link(pair[0], q)
    found, wrench = pair[1].numpy().forward_dynamics(q, turn @ v, torques(pair[0], TAU, turn), W_EXT)
    return turn.T @ found, wrench


def test_it_moves_as_the_products_joint_does_in_every_back_end(pair, compiled):
    model, (q, v) = pair[0], start(pair[0])
    given, (vdot, wrench) = (q, v, TAU, W_EXT), expected(pair)
    found = {"NumPy": model.numpy().forward_dynamics(*given), "DAE": model.numpy().dae_forward_dynamics(*given)}
    found |= {"CasADi": casadi_forward(model, *given)}
    jax = package("jax")
    with jax.enable_x64(True):
        found["JAX"] = model.jax()["forward_dynamics"](*given, np.array(model.parameter_values))
    found |= {f"C, {form}": compiled.forward_dynamics(*given, form) for form in ("joint", "dae")}
    found["C, modular"] = quick(model, layout="modular").forward_dynamics(*given)
    for name, (own, of_joints) in found.items():
        assert relative(np.asarray(own), vdot) < 1e-11, name
        assert relative(np.reshape(of_joints, wrench.shape), wrench) < 1e-11, name


def test_energy_and_mass_matrix_are_those_of_the_products(pair):
    model, other = pair
    q, v = start(model)
    turn = to_link(model, q)
    assert relative(model.numpy().mass_matrix(q), turn.T @ other.numpy().mass_matrix(q) @ turn) < 1e-12
    assert relative(model.numpy().energy(q, v), other.numpy().energy(q, turn @ v)) < 1e-12


def test_derivatives_are_along_turns_in_axes_of_the_carrier(pair, compiled):
    """Against differences of coordinates that move by `integrate`."""
    model, (q, v), h = pair[0], start(pair[0]), 1e-6
    numeric, chain, none = model.numpy(), model.chain, np.zeros(pair[0].nv)
    at = lambda u, w: numeric.forward_dynamics(chain.integrate(q, u, SERIES), v + w, TAU, W_EXT)[0]  # noqa: E731
    by_q, by_v, _ = numeric.derivatives(q, v, TAU, W_EXT)
    for found, sides in ((by_q, lambda u: (u, none)), (by_v, lambda u: (none, u))):
        differences = [(at(*sides(u)) - at(*sides(-u))) / (2 * h) for u in h * np.eye(chain.nv)]
        assert relative(found, np.transpose(differences)) < 1e-7
    for found, in_c in zip((by_q, by_v), compiled.linearise(q, v, TAU, W_EXT)[1:], strict=False):
        assert relative(in_c, found) < 1e-12
    slope = model.linearise(q, v, TAU).A[chain.nv :]
    assert relative(slope, np.hstack([by_q, by_v])) < 1e-12


@pytest.mark.parametrize("name", METHODS)
def test_steps_of_every_method_agree_and_are_differentiated(pair, compiled, name):
    model, (q, v), h = pair[0], start(pair[0]), 1e-3
    chain, nv = model.chain, model.nv
    expected = model.casadi()[f"step_{name}"](q, v, TAU, W_EXT.T, model.parameter_values, h)
    for found, wanted in zip(compiled.step(q, v, TAU, W_EXT, h, name), expected, strict=True):
        assert relative(found, flat(wanted)) < 1e-12
    after, rates, A, B = compiled.step_derivatives(q, v, TAU, W_EXT, h, name)

    def moved(u):
        there, faster = compiled.step(
            chain.integrate(q, u[:nv], SERIES), v + u[nv : 2 * nv], TAU + u[2 * nv :], W_EXT, h, name
        )
        return np.append(chain.difference(after, there, SERIES), faster - rates)

    differences = [(moved(u) - moved(-u)) / 2e-6 for u in 1e-6 * np.eye(2 * nv + model.n_tau)]
    assert relative(A, np.transpose(differences[: 2 * nv])) < 1e-8
    assert relative(B, np.transpose(differences[2 * nv :])) < 1e-7


def test_runs_forms_and_lanes_agree_with_the_products(pair):
    model, other = pair
    q, v = start(model)
    given = dict(duration=0.02, step=1e-4, q0=q, controller=None, integrator="rk4")
    run, dae = (simulate(model, v0=v, form=form, **given) for form in ("joint", "dae"))
    wanted = simulate(other, v0=to_link(model, q) @ v, **given)
    assert relative(run.q[-1], wanted.q[-1]) < 1e-9
    assert relative(dae.q[-1], wanted.q[-1]) < 1e-9
    rolled = rollout(model, np.append(q, v), step=1e-4, steps=20).x[0, -1]
    alone = simulate(model, 2e-3, 1e-4, q, v)
    assert relative(rolled, np.append(alone.q[-1], alone.v[-1])) < 1e-12


def test_a_kind_that_moves_in_part_is_refused():
    with pytest.raises(TypeError, match="Half states integrate; it must state difference, rate, coordinate_rates"):
        type("Half", (JointKind,), {"integrate": CarriedBall.integrate})


def test_a_file_cannot_state_it():
    with pytest.raises(UsageError, match=r"joint\.axes holds an object made in Python"):
        dump(Robot(**robot(CARRIED_BALL)))
    assert copy.deepcopy(Robot(**robot(CARRIED_BALL))) == Robot(**robot(CARRIED_BALL))
