"""A kind of joint that the product does not contain: a ball joint whose rates are in axes of its carrier.

The product's own ball joint has them in axes of the link, where its motion subspace is constant. Here it turns with the
link. The same robot with the product's joint is the judge.
"""

import copy
from dataclasses import dataclass

import numpy as np
import pytest
from floating_robots import SATELLITE, rod
from helpers import model_of, relative
from outside import Outside, every_check
from scipy.spatial.transform import Rotation

from screwgen import Robot, UsageError, dump, simulate
from screwgen.algebra.expression import identity, zeros
from screwgen.backends.numpy.dae_step import SERIES
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


@pytest.fixture(scope="module")
def outside(pair):
    """With accelerations and wrenches of the product's robot, as those of the one from outside."""
    q, v = start(pair[0])
    turn = to_link(pair[0], q)
    found, wrench = pair[1].numpy().forward_dynamics(q, turn @ v, torques(pair[0], TAU, turn), W_EXT)
    return Outside(pair[0], (q, v, TAU, W_EXT), turn.T @ found, wrench)


@every_check
def test_it_moves_as_the_products_joint_does(outside, check):
    outside.holds(check)


def test_energy_and_mass_matrix_are_those_of_the_products(pair):
    model, other = pair
    q, v = start(model)
    turn = to_link(model, q)
    assert relative(model.numpy().mass_matrix(q), turn.T @ other.numpy().mass_matrix(q) @ turn) < 1e-12
    assert relative(model.numpy().energy(q, v), other.numpy().energy(q, turn @ v)) < 1e-12


@pytest.mark.parametrize("form", ["joint", "dae"])
def test_runs_are_those_of_the_products(pair, form):
    model, other = pair
    q, v = start(model)
    given = dict(duration=0.02, step=1e-4, q0=q, controller=None, integrator="rk4")
    run, wanted = simulate(model, v0=v, form=form, **given), simulate(other, v0=to_link(model, q) @ v, **given)
    assert relative(run.q[-1], wanted.q[-1]) < 1e-9


def test_a_kind_that_moves_in_part_is_refused():
    with pytest.raises(TypeError, match="Half states integrate; it must state difference, rate, coordinate_rates"):
        type("Half", (JointKind,), {"integrate": CarriedBall.integrate})


def test_a_file_cannot_state_it():
    with pytest.raises(UsageError, match=r"joint\.axes holds an object made in Python"):
        dump(Robot(**robot(CARRIED_BALL)))
    assert copy.deepcopy(Robot(**robot(CARRIED_BALL))) == Robot(**robot(CARRIED_BALL))
