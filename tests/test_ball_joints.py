"""Ball joints: the oracle in other coordinates, three turns, in both forms; conserved quantities."""

import copy
import subprocess
from functools import cache
from typing import NamedTuple

import numpy as np
import pytest
import random_robots as rr
from c_tools import require_tool
from conftest import swept
from floating_robots import SATELLITE, momentum, rod
from helpers import casadi_forward, model_of, quick, relative
from oracle import Oracle, part_error
from scipy.spatial.transform import Rotation

import screwgen
from screwgen import Model, ScrewgenError, simulate
from screwgen.algorithms import fused
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.integrators import METHODS
from screwgen.ir.replay import run as replay

TURNS = ["z", "y", "x"]


def columns(angles: np.ndarray) -> np.ndarray:
    """(3, 3): the axes of three turns in axes of the link, which take their rates to its angular velocity."""
    later, last = Rotation.from_rotvec([0, angles[1], 0]), Rotation.from_rotvec([angles[2], 0, 0])
    return np.column_stack([(later * last).inv().apply([0, 0, 1]), last.inv().apply([0, 1, 0]), [1, 0, 0]])


def column_rates(axes: np.ndarray, rates: np.ndarray) -> np.ndarray:
    """Their rates times those of the angles: later turns carry the axes of earlier ones."""
    a, b, c = axes.T
    return rates[0] * np.cross(a, b * rates[1] + c * rates[2]) + rates[1] * np.cross(b, c * rates[2])


class Case(NamedTuple):
    """A robot with ball joints in a state, and the oracle's with three turns in their places."""

    model: Model
    oracle: Oracle
    state: dict
    chosen: tuple[int, ...]

    @property
    def given(self) -> tuple:
        """q, v, tau, w_ext of the package."""
        q, v, tau = (list(np.array(self.state[name], float)) for name in ("q", "v", "tau"))
        for i in reversed(self.chosen):
            own = self.oracle.joint_slices[i]
            axes = columns(np.array(q[own]))
            v[own], tau[own] = axes @ v[own], np.linalg.solve(axes.T, tau[own])
            q[own] = Rotation.from_euler("ZYX", q[own]).as_quat(scalar_first=True)
        return np.array(q), np.array(v), np.array(tau), np.array(self.state["w_ext"])

    @property
    def map(self) -> np.ndarray:
        """(nv, nv): the oracle's rates to those of the package."""
        out = np.eye(self.oracle.nv)
        for i in self.chosen:
            own = self.oracle.joint_slices[i]
            out[own, own] = columns(np.array(self.state["q"][own]))
        return out

    @cache  # noqa: B019
    def expected(self) -> tuple[np.ndarray, np.ndarray]:
        vdot, wrench = self.oracle.forward_dynamics(**self.state)
        out = self.map @ vdot
        for i in self.chosen:
            own = self.oracle.joint_slices[i]
            out[own] += column_rates(self.map[own, own], np.array(self.state["v"][own]))
        return out, wrench

    def error(self, vdot, wrench) -> float:
        """The worst of joints, modes, moments and forces, each over the largest entry of its kind."""
        (a, W), m = self.expected(), self.oracle.n_joint
        W, wrench = np.reshape(W, (-1, 6)), np.reshape(wrench, (-1, 6))
        parts = [part_error(a[s], np.asarray(vdot)[s], a) for s in (slice(m), slice(m, None))]
        return max(parts + [part_error(W[:, s], wrench[:, s], W) for s in (slice(3), slice(3, None))])

    __hash__ = object.__hash__


@cache
def random_robot(seed: int) -> Case:
    """Trees of rigid and flexible links of both orders, one to three of whose joints are balls."""
    rng, count = np.random.default_rng(8100 + seed), 1 + seed % 5
    for _ in range(200):
        robot = rr.random_robot(
            rng, count, branching=0.4, second_order=0.15, stations=0.1, max_modes=1 + (seed % 4 < 2)
        )
        chosen = tuple(sorted(rng.choice(count, size=min(count, 1 + seed % 3), replace=False).tolist()))
        twin = copy.deepcopy(robot)
        for i in chosen:
            mount = {k: v for k, v in robot["links"][i]["joint"].items() if k == "mount"}
            robot["links"][i]["joint"] = {"axes": "ball", **mount}
            twin["links"][i]["joint"] = {"axes": TURNS, **mount}
        state = {name: np.array(x) for name, x in rr.random_state(rng, twin).items()}
        oracle = Oracle(twin)
        for i in chosen:
            state["q"][oracle.joint_slices[i]] = rng.uniform(-1.2, 1.2, 3)
        if oracle.condition(state["q"]) <= 1e8 and np.linalg.eigvalsh(oracle.mass_matrix(state["q"]))[0] > 0:
            return Case(model_of(robot), oracle, state, chosen)
    raise RuntimeError("no robot with a regular mass matrix in 200 draws")


@pytest.fixture(params=swept(range(40), 0, 2, 7))
def robot(request) -> Case:
    return random_robot(request.param)


def test_numpy_and_casadi_equal_the_oracle_in_both_forms(robot):
    numeric, given = robot.model.numpy(), robot.given
    tolerance = robot.oracle.tolerance(robot.state["q"])
    for found in (
        numeric.forward_dynamics(*given),
        numeric.dae_forward_dynamics(*given),
        casadi_forward(robot.model, *given),
    ):
        assert robot.error(*found) < tolerance
    q, v, tau, w_ext = given
    x = numeric.dae_state(q, v)
    M, H, W = numeric.assemble(x, tau, w_ext)
    n = robot.model.n_links
    z = np.linalg.solve(M, W - H)[: 12 * n].reshape(n, 12)
    assert relative(z[:, :6], robot.expected()[1]) < 1e3 * tolerance
    assert relative(numeric.project(x), x) < 1e-13


def test_mass_matrix_energy_and_places_are_the_oracles(robot):
    numeric, (q, v, tau, w_ext), state = robot.model.numpy(), robot.given, robot.state
    M = robot.map.T @ numeric.mass_matrix(q) @ robot.map
    assert relative(M, robot.oracle.mass_matrix(state["q"])) < 1e-12
    assert numeric.energy(q, v) == pytest.approx(robot.oracle.energy(state["q"], state["v"]), rel=1e-11, abs=1e-11)
    R, r = numeric.link_pose(q)
    poses = robot.oracle.poses(state["q"])
    assert relative(R, poses["R"]) < 1e-12 and relative(r, poses["origin"]) < 1e-12
    vdot = numeric.forward_dynamics(q, v, tau, w_ext)[0]
    force = np.concatenate([tau, np.zeros(robot.model.chain.n_modes)])
    rest = np.abs(numeric.mass_matrix(q)) @ np.abs(vdot)
    assert np.all(np.abs(numeric.inverse_dynamics(q, v, vdot, w_ext) - force) <= 1e-9 * rest.max())


def test_a_linear_model_is_along_turns_in_axes_of_the_link(robot):
    """By differences of states that move by `integrate`: what rates, accelerations and places become."""
    q, v, tau, w_ext = robot.given
    model, chain, h = robot.model, robot.model.chain, 1e-6
    found = model.linearise(q, v, tau, w_ext, outputs=["tip_position", "joint_angles"])
    last = robot.model.numpy().forward_dynamics(q, v, tau, w_ext)[0]

    def moved(u):
        there = chain.integrate(q, u[: chain.nv], SERIES)
        numeric = model.numpy()
        vdot = numeric.forward_dynamics(there, v + u[chain.nv :], tau, w_ext)[0]
        joints = there[chain.base_q : chain.base_q + chain.n_redundant]
        return vdot, np.concatenate([numeric.tip_pose(there)[1], joints])

    columns = [(moved(h * u), moved(-h * u)) for u in np.eye(2 * chain.nv)]
    slopes = [[(a[k] - b[k]) / (2 * h) for a, b in columns] for k in (0, 1)]
    assert np.array_equal(found.vdot, last) or relative(found.vdot, last) < 1e-12
    assert relative(found.A[chain.nv :], np.transpose(slopes[0])) < 1e-6
    assert relative(found.C, np.transpose(slopes[1])) < 1e-6
    assert len(found.state_names) == len(set(found.state_names)) == 2 * chain.nv


def test_integrate_and_difference_are_inverse_to_each_other():
    model = random_robot(3).model
    rng, q = np.random.default_rng(1), random_robot(3).given[0]
    u = rng.uniform(-1.5, 1.5, model.nv)
    assert relative(model.chain.difference(q, model.chain.integrate(q, u, SERIES), SERIES), u) < 1e-13
    q_rates = fused.coordinate_rates(model.chain)
    found = replay(q_rates, {"q": list(q), "v": list(u), "p": list(model.parameter_values)}, fused.precise)[0]["qdot"]
    moved = [model.chain.integrate(q, s * 1e-6 * u, SERIES) for s in (1, -1)]
    assert relative(found, (moved[0] - moved[1]) / 2e-6) < 1e-8


# -------- steps


PROBE = copy.deepcopy(SATELLITE)
PROBE["links"][1] = rod("left", ["z"], parent="hull", mount={"xyz": [0.0, 0.3, 0.0], "rpy": [0.2, -0.4, 0.7]})
PROBE["links"][1]["joint"]["axes"] = "ball"
TAU = (0.3, -0.2, 0.1, 0.2, 0.1, -0.1)


@pytest.fixture(scope="module")
def probe():
    return model_of(PROBE)


@pytest.fixture(scope="module")
def compiled(probe):
    return quick(probe)


def begun(model) -> tuple[np.ndarray, np.ndarray]:
    """A posture and rates without pattern."""
    rng, chain = np.random.default_rng(3), model.chain
    q, v = np.array(chain.home), 0.3 * rng.normal(size=chain.nv)
    q = chain.integrate(q, np.append(rng.uniform(-1, 1, chain.eta_v), 0.01 * rng.normal(size=chain.n_modes)), SERIES)
    v[chain.eta_v :] *= 0.2
    return q, v


@pytest.mark.parametrize("method", swept([*METHODS.values()], *[*METHODS.values()][3:]), ids=str)
def test_every_method_keeps_its_order_and_both_forms_agree(probe, compiled, method):
    q0, v0 = begun(probe)
    reference, errors = simulate(probe, 0.02, 5e-5, q0, v0, TAU, None, "rk4"), []
    for count in (40, 80):
        q, v = q0, v0
        for _ in range(count):
            q, v = compiled.step(q, v, TAU, None, 0.02 / count, method)
        errors.append(np.abs(np.append(q - reference.q[-1], v - reference.v[-1])).max())
    assert np.log2(errors[0] / errors[1]) > method.order - 0.35
    joint, dae = (simulate(probe, 2e-3, 1e-4, q0, v0, TAU, None, method, form) for form in ("joint", "dae"))
    assert relative(dae.q[-1], joint.q[-1]) < {1: 1e-5, 2: 1e-7, 4: 1e-10}[method.order]
    for part in probe.chain.curved:
        turn = q[part.q][part.joint.turn_at :][:4]
        assert abs(np.linalg.norm(turn) - 1) < 1e-15


def test_energy_and_momentum_are_conserved_without_forces(probe, compiled):
    q, v = begun(probe)
    first, energy = momentum(probe, q, v), sum(probe.numpy().energy(q, v))
    for _ in range(1000):
        q, v = compiled.step(q, v, None, None, 1e-4, "rk4")
    assert relative(momentum(probe, q, v), first) < 1e-8
    assert sum(probe.numpy().energy(q, v)) == pytest.approx(energy, rel=1e-7)


def test_dampers_of_a_ball_joint_take_its_energy(tmp_path):
    """With springs and dampers at other joints; the power of the damper is that of the energy."""
    robot = {"name": "pendulum", "gravity": [0.0, 0.0, -9.81], "links": [rod("upper", ["z"]), rod("bob", "ball")]}
    robot["links"][0]["joint"] |= {"stiffness": [3.0], "damping": [0.0]}
    robot["links"][1]["joint"] = {"axes": "ball", "damping": [0.3, 0.2, 0.1]}
    model = model_of(robot)
    numeric, (q, v) = model.numpy(), begun(model)
    vdot = numeric.forward_dynamics(q, v, np.zeros(4), np.zeros((2, 6)))[0]
    compiled = quick(model)
    for form in ("joint", "dae"):
        assert relative(compiled.forward_dynamics(q, v, np.zeros(4), np.zeros((2, 6)), form)[0], vdot) < 1e-12
    h = 1e-6
    sides = [model.chain.integrate(q, s * h * v, SERIES) for s in (1, -1)]
    energies = [sum(numeric.energy(side, v + s * h * vdot)) for side, s in zip(sides, (1, -1), strict=True)]
    lost = v[1:4] @ np.diag([0.3, 0.2, 0.1]) @ v[1:4]
    assert (energies[0] - energies[1]) / (2 * h) == pytest.approx(-lost, rel=1e-6)
    run, dae = (simulate(model, 5e-3, 1e-4, q, v, None, form=form) for form in ("joint", "dae"))
    assert relative(dae.q[-1], run.q[-1]) < 1e-7
    model.write(tmp_path / "out", ("c",))
    make = [require_tool("make"), "-s", "CFLAGS=-O0", "check"]
    done = subprocess.run(make, cwd=tmp_path / "out" / "c", capture_output=True, text=True)
    assert done.returncode == 0 and "all checks passed" in done.stdout, done.stdout + done.stderr


# -------- what is refused


REFUSED = [
    ({"axes": "ball", "stiffness": [1.0, 1.0, 1.0]}, {}, "links[1].joint.stiffness (link fore): is stated of a ball"),
    ({"axes": "ball", "armature": [1.0, 1.0, 1.0]}, {}, "links[1].joint.armature (link fore): is stated of a ball"),
    ({"axes": "ball", "damping": [1.0]}, {}, "it must hold one number per axis, 3"),
    ({"axes": "bal"}, {}, 'is "bal"; it must be an array of axes, as ["y", "z"], or "ball"'),
    (
        {"axes": "ball"},
        {"limits": [{"lower": -1.0, "upper": 1.0}]},
        "that of link 'fore', beside which it is not known",
    ),
    (
        {"axes": "ball"},
        {"drives": [{"friction": {"viscous": 0.1}}]},
        "that of link 'fore', beside which it is not known",
    ),
]


@pytest.mark.parametrize(("joint", "other", "said"), REFUSED, ids=[str(k) for k in range(len(REFUSED))])
def test_what_no_ball_joint_has_is_refused_in_a_line(joint, other, said, tmp_path):
    first = rod("arm", ["z"])
    first["joint"] |= other
    robot = {"name": "robot", "gravity": [0.0, 0.0, -9.81], "links": [first, {**rod("fore", []), "joint": joint}]}
    (tmp_path / "robot.toml").write_text(rr.to_toml(robot))
    with pytest.raises(ScrewgenError) as error:
        screwgen.load(tmp_path / "robot.toml")
    assert said in str(error.value) and "\n" not in str(error.value).strip()


USES = {
    "equilibrium": screwgen.equilibrium,
    "modes under load": lambda model: screwgen.natural_frequencies(model, loaded=True),
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
