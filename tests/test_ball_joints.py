"""Ball joints: steps on the sphere, conserved quantities, what is refused. The oracle judges them in `conformance/`."""

import copy

import numpy as np
import pytest
import random_robots as rr
from floating_robots import SATELLITE, momentum, rod
from helpers import model_of, quick, relative
from pydantic import ValidationError

import screwgen
from screwgen import ScrewgenError, simulate
from screwgen.algorithms import fused
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.integrators import METHODS, Method, Move, Stage
from screwgen.ir.replay import run as replay

PROBE = copy.deepcopy(SATELLITE)
PROBE["links"][1] = rod("left", ["z"], parent="hull", mount={"xyz": [0.0, 0.3, 0.0], "rpy": [0.2, -0.4, 0.7]})
PROBE["links"][1]["joint"]["axes"] = "ball"
TAU = (0.3, -0.2, 0.1, 0.2, 0.1, -0.1)
HEUN = Method("heun", 2, (Stage(), Stage([1])), Move(["1/2", "1/2"]), "Heun's method, two forward dynamics")


@pytest.fixture(scope="module")
def probe():
    return model_of(PROBE)


def begun(model) -> tuple[np.ndarray, np.ndarray]:
    """A posture and rates without pattern."""
    rng, chain = np.random.default_rng(3), model.chain
    q, v = np.array(chain.home), 0.3 * rng.normal(size=chain.nv)
    q = chain.integrate(q, np.append(rng.uniform(-1, 1, chain.eta_v), 0.01 * rng.normal(size=chain.n_modes)), SERIES)
    v[chain.eta_v :] *= 0.2
    return q, v


def test_integrate_and_difference_are_inverse_to_each_other(probe):
    model, rng, q = probe, np.random.default_rng(1), begun(probe)[0]
    u = rng.uniform(-1.5, 1.5, model.nv)
    assert relative(model.chain.difference(q, model.chain.integrate(q, u, SERIES), SERIES), u) < 1e-13
    q_rates = fused.coordinate_rates(model.chain)
    found = replay(q_rates, {"q": list(q), "v": list(u), "p": list(model.parameter_values)}, fused.precise)[0]["qdot"]
    moved = [model.chain.integrate(q, s * 1e-6 * u, SERIES) for s in (1, -1)]
    assert relative(found, (moved[0] - moved[1]) / 2e-6) < 1e-8


@pytest.mark.parametrize("method", [*METHODS.values(), HEUN], ids=str)
@pytest.mark.parametrize("robot", [PROBE, SATELLITE], ids=["ball joint", "floating base"])
def test_every_method_keeps_its_order_and_both_forms_agree(robot, method):
    """Of a floating base with and without a ball joint, whose quaternions keep their length."""
    model = model_of(robot)
    (q0, v0), tau, compiled = begun(model), TAU[: model.n_tau], quick(model, methods=(HEUN,))
    reference, errors = simulate(model, 0.02, 5e-5, q0, v0, tau, None, "rk4"), []
    for count in (40, 80):
        q, v = compiled.step(q0, v0, tau, None, 0.02 / count, method, count)
        errors.append(np.abs(np.append(q - reference.q[-1], v - reference.v[-1])).max())
    assert np.log2(errors[0] / errors[1]) > method.order - 0.35
    joint, dae = (simulate(model, 2e-3, 1e-4, q0, v0, tau, None, method, form) for form in ("joint", "dae"))
    assert relative(dae.q[-1], joint.q[-1]) < {1: 1e-5, 2: 1e-7, 4: 1e-10}[method.order]
    for part in model.chain.curved:
        turn = q[part.q][part.joint.turn_at :][:4]
        assert abs(np.linalg.norm(turn) - 1) < 1e-15


def test_energy_and_momentum_are_conserved_without_forces(probe):
    q, v = begun(probe)
    first, energy = momentum(probe, q, v), sum(probe.numpy().energy(q, v))
    q, v = quick(probe).step(q, v, None, None, 1e-4, "rk4", 1000)
    assert relative(momentum(probe, q, v), first) < 1e-8
    assert sum(probe.numpy().energy(q, v)) == pytest.approx(energy, rel=1e-7)


def test_dampers_of_a_ball_joint_take_its_energy():
    """With springs and dampers at other joints; the power of the damper is that of the energy."""
    robot = {"name": "pendulum", "gravity": [0.0, 0.0, -9.81], "links": [rod("upper", ["z"]), rod("bob", "ball")]}
    robot["links"][0]["joint"] |= {"stiffness": [3.0], "damping": [0.0]}
    robot["links"][1]["joint"] = {"axes": "ball", "damping": [0.3, 0.2, 0.1]}
    model = model_of(robot)
    numeric, (q, v) = model.numpy(), begun(model)
    vdot = numeric.forward_dynamics(q, v, np.zeros(4), np.zeros((2, 6)))[0]
    h = 1e-6
    sides = [model.chain.integrate(q, s * h * v, SERIES) for s in (1, -1)]
    energies = [sum(numeric.energy(side, v + s * h * vdot)) for side, s in zip(sides, (1, -1), strict=True)]
    lost = v[1:4] @ np.diag([0.3, 0.2, 0.1]) @ v[1:4]
    assert (energies[0] - energies[1]) / (2 * h) == pytest.approx(-lost, rel=1e-6)


# -------- what is refused


REFUSED = [
    ({"axes": "ball", "stiffness": [1.0, 1.0, 1.0]}, {}, "links[1].joint.stiffness (link fore): is stated of a ball"),
    ({"axes": "ball", "armature": [1.0, 1.0, 1.0]}, {}, "links[1].joint.armature (link fore): is stated of a ball"),
    ({"axes": "ball", "damping": [1.0]}, {}, "it must hold one number per axis, 3"),
    ({"axes": "bal"}, {}, 'is "bal"; it must be an array of axes, as ["y", "z"], or "ball"'),
    (
        {"axes": "ball", "limits": [{"lower": -1.0, "upper": 1.0}] * 3},
        {},
        "links[1].joint.limits (link fore): is stated of a ball joint, which has no axes",
    ),
    (
        {"axes": "ball", "drives": [{"friction": {"viscous": 0.1}}] * 3},
        {},
        "links[1].joint.drives (link fore): is stated of a ball joint, which has no axes",
    ),
    (
        {"axes": "ball"},
        {"couplings": [{"axis": "arm.joint[1]", "of": "arm.joint[0]", "ratio": 2.0}]},
        "couplings: is stated of a robot with a ball joint, that of link 'fore', beside which it is not known",
    ),
]


@pytest.mark.parametrize(("joint", "other", "said"), REFUSED, ids=[str(k) for k in range(len(REFUSED))])
def test_what_no_ball_joint_has_is_refused_in_a_line(joint, other, said, tmp_path):
    first = rod("arm", ["z", "y"])
    robot = {"name": "robot", "gravity": [0.0, 0.0, -9.81], "links": [first, {**rod("fore", []), "joint": joint}]}
    robot |= other
    (tmp_path / "robot.toml").write_text(rr.to_toml(robot))
    with pytest.raises(ScrewgenError) as error:
        screwgen.load(tmp_path / "robot.toml")
    assert said in str(error.value) and "\n" not in str(error.value).strip()


def test_the_axes_that_a_refusal_offers_in_place_of_a_ball_joint_are_taken():
    """A load on a rope, a point mass, beside a coupling: nothing resists a spin about it, so "x" is no way out."""
    heel, rope = rod("heel", ["z", "y"]), {"name": "rope", "length": 1.5, "joint": {"axes": "ball"}}
    rope["bodies"] = [{"at": "tip", "mass": 300.0}]
    robot = {"name": "crane", "gravity": [0.0, 0.0, -9.81], "links": [heel, rope]}
    robot["couplings"] = [{"axis": "heel.joint[1]", "of": "heel.joint[0]", "ratio": 2.0}]
    with pytest.raises(ValidationError) as error:
        model_of(robot)
    said = error.value.errors()[0]["msg"]
    assert said.endswith("""in place of "ball": ["y", "z"], or ["x", "y", "z"] where something resists its spin""")
    rope["joint"] = {"axes": ["y", "z"]}
    model = model_of(robot)
    vdot, _ = model.numpy().forward_dynamics(np.full(model.nq, 0.1), np.zeros(model.nv), np.zeros(4), None)
    assert np.isfinite(vdot).all()


def test_a_ball_joint_that_nothing_resists_is_told_what_it_may_have():
    """No armature, which no ball joint has."""
    rope = {"name": "rope", "length": 1.5, "joint": {"axes": "ball"}, "bodies": [{"at": "tip", "mass": 300.0}]}
    model = model_of({"name": "crane", "gravity": [0.0, 0.0, -9.81], "links": [rope]})
    words = 'give the link rhoIp, a body with inertia, or axes in place of "ball" about which something resists$'
    with pytest.raises(screwgen.SingularError, match=words):
        model.numpy().forward_dynamics(model.chain.home, np.zeros(3), np.zeros(3), None)


USES = {
    "acados model": lambda model: model.acados(),
}


@pytest.mark.parametrize("what", USES)
def test_what_does_not_know_ball_joints_names_the_joint(what, probe):
    with pytest.raises(
        ScrewgenError, match=f"'satellite' has a ball joint, that of link 'left', for which .* {what} yet"
    ):
        USES[what](probe)


def test_a_quaternion_of_another_length_is_refused(probe):
    q, v = begun(probe)
    q[7:11] *= 1.1
    with pytest.raises(ScrewgenError, match=r"has a quaternion of length 1\.1, entries 7 to 10 \(w, x, y, z\)"):
        simulate(probe, 1e-3, 1e-4, q, v)
