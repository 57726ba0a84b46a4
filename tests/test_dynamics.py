"""Accelerations and joint wrenches of random robots against the oracle: an independent Lagrangian.

Every back end, both forms: NumPy, CasADi and the compiled C, joint form and DAE form. Each of the parts joint
accelerations, modal accelerations, joint moments and joint forces is measured against its own largest entry and
must be right to max(1e-10, 50 eps cond M).
"""

import tomllib
from functools import cache

import numpy as np
import pytest
from conftest import swept
from helpers import EPS32, Case, casadi_forward, disagreement, drawn, example, flat, quick, relative
from oracle import Oracle, part_error

from screwgen import Robot
from screwgen.spec import dump

SEEDS = range(50)


def links_of(seed: int) -> int:
    """Ten robots of each number of links."""
    return 1 + seed % 5


def name_of(seed: int) -> str:
    return f"seed{seed:02d}-{links_of(seed)}links"


every_robot = pytest.mark.parametrize("seed", swept(SEEDS, *SEEDS[:5], 6, 7), ids=name_of)
in_each_size = pytest.mark.parametrize("seed", swept(SEEDS, *SEEDS[:5]), ids=name_of)
some_robots = pytest.mark.parametrize("seed", swept(range(5, 10), 6, 7), ids=name_of)


@cache
def case_of(seed: int) -> Case:
    return drawn(seed, links_of(seed))


def layouts_of(seed: int) -> tuple[str, str]:
    """The layout in which a robot's C is compiled, and the other one."""
    return ("modular", "fused") if seed % 2 else ("fused", "modular")


def casadi_dae(case: Case) -> dict[str, np.ndarray]:
    """The unknowns of the DAE form: M_sys of CasADi, solved densely, with a step of refinement.

    Wrenches are up to 1e5 times as large as accelerations, and the base of an arm does not accelerate: an LU alone
    leaves eps of the wrenches there.
    """
    functions, p, n = case.model.casadi(), case.model.parameter_values, case.model.n_links
    q, v, tau, w_ext = case.inputs
    x = functions["dae_state"](q, v, p)
    M, H, W = (np.array(a.full()) for a in functions["assemble"](x, tau, w_ext.T, p))
    z = np.linalg.solve(M, W - H)
    z = (z + np.linalg.solve(M, W - H - M @ z))[:, 0]
    links = z[: 12 * n].reshape(n, 12)
    return {"tau": links[:, :3], "F": links[:, 3:6], "alpha": links[:, 6:9], "a": links[:, 9:], "etadd": z[12 * n :]}


def dae_errors(case: Case) -> dict[str, float]:
    """Errors of wrenches, of the rates of the twists (angular, linear), and of the modal accelerations."""
    q, v, _, _ = case.inputs
    vdot, wrench = case.oracle.forward_dynamics(**case.state)
    rates = case.oracle.link_twist_rates(q, v, vdot)
    expected = {"tau": wrench[:, :3], "F": wrench[:, 3:], "alpha": rates[:, :3], "a": rates[:, 3:]}
    expected["etadd"] = case.oracle.parts(vdot, wrench)["etadd"]
    other = {"tau": "F", "F": "tau", "alpha": "a", "a": "alpha", "etadd": "alpha"}
    found = casadi_dae(case)
    return {k: part_error(expected[k], found[k], expected[other[k]]) for k in expected}


def check(case: Case, results: dict[str, dict[str, float]]) -> None:
    """Every part of every result is right to the tolerance of the robot's state."""
    wrong = {(who, part): e for who, parts in results.items() for part, e in parts.items() if not e <= case.tolerance}
    assert not wrong, f"tolerance {case.tolerance:.1e}"


@every_robot
def test_accelerations_and_wrenches(seed):
    case, model = case_of(seed), case_of(seed).model
    judge = lambda result: case.oracle.errors(case.state, *result)  # noqa: E731
    errors = {
        "NumPy": judge(model.numpy().forward_dynamics(*case.inputs)),
        "NumPy, DAE": judge(model.numpy().dae_forward_dynamics(*case.inputs)),
        "CasADi": judge(casadi_forward(model, *case.inputs)),
        "CasADi, DAE": dae_errors(case),
    }
    check(case, errors)


@in_each_size
def test_accelerations_and_wrenches_in_c(seed):
    case = case_of(seed)
    compiled = quick(case.model, layout=layouts_of(seed)[0])
    results = {form: compiled.forward_dynamics(*case.inputs, form=form) for form in ("joint", "dae")}
    check(case, {form: case.oracle.errors(case.state, *result) for form, result in results.items()})


@pytest.mark.parametrize("seed", swept(range(4), 0, 1))
def test_single_precision(seed):
    """Float C is right to 50 eps32 cond M, on robots where that leaves digits."""
    case = drawn(200 + seed, 1 + seed, limit=2e3)
    compiled = quick(case.model, layout=layouts_of(seed)[0], single=True)
    expected = case.oracle.forward_dynamics(**case.state)
    tolerance = 50 * EPS32 * case.oracle.condition(case.state["q"])
    assert tolerance < 0.02
    for form in ("joint", "dae"):
        assert disagreement(case.oracle, expected, compiled.forward_dynamics(*case.inputs, form=form)) <= tolerance


@some_robots
def test_all_other_functions(seed):
    """Inverse dynamics, mass matrix, bias, energies and poses of NumPy, CasADi and C equal the oracle's."""
    case, rng = case_of(seed), np.random.default_rng(seed)
    (q, v, _, w_ext), oracle, numeric = case.inputs, case.oracle, case.model.numpy()
    functions, p = case.model.casadi(), case.model.parameter_values
    vdot = rng.normal(size=oracle.nv)
    force, M, h = oracle.inverse_dynamics(q, v, vdot, w_ext), oracle.mass_matrix(q), oracle.bias(q, v, w_ext)
    assert relative(numeric.inverse_dynamics(q, v, vdot, w_ext), force) < 1e-10
    assert relative(flat(functions["inverse_dynamics"](q, v, vdot, w_ext.T, p)), force) < 1e-10
    assert relative(numeric.mass_matrix(q), M) < 1e-12 and relative(functions["mass_matrix"](q, p), M) < 1e-12
    assert (
        relative(numeric.bias(q, v, w_ext), h) < 1e-10
        and relative(flat(functions["bias"](q, v, w_ext.T, p)), h) < 1e-10
    )
    assert np.allclose(
        numeric.energy(q, v), oracle.energy(q, v), rtol=1e-12, atol=1e-12 * abs(sum(oracle.energy(q, v)))
    )
    assert np.allclose([float(e) for e in functions["energy"](q, v, p)], numeric.energy(q, v), rtol=1e-12)
    check_poses(case, functions, p, layouts_of(seed)[0])


def check_poses(case: Case, functions, p, layout: str):
    (q, v, tau, w_ext), numeric, n = case.inputs, case.model.numpy(), case.model.n_links
    poses = case.oracle.poses(q)
    for given, R, origin in ((numeric.link_pose(q), "R", "origin"), (numeric.tip_poses(q), "tip_R", "tip_point")):
        assert np.allclose(given[0], poses[R], atol=1e-12) and np.allclose(given[1], poses[origin], atol=1e-12)
    R, position = (np.array(a) for a in functions["link_pose"](q, p))
    assert np.allclose(np.stack(np.hsplit(R, n)), poses["R"], atol=1e-12)
    assert np.allclose(position.T, poses["origin"], atol=1e-12)
    compiled = quick(case.model, layout=layout)
    tips = [numeric.tip_pose(q), functions["tip_pose"](q, p)]
    tips += [compiled.complete_dynamics(q, v, tau, w_ext, form)[2:] for form in ("joint", "dae")]
    for R, position in tips:
        assert np.allclose(np.array(R), poses["tip_R"][-1], atol=1e-12)
        assert np.allclose(flat(position), poses["tip_point"][-1], atol=1e-12)


@pytest.mark.parametrize("name", swept(["ella", "six_link"], "ella"))
def test_changed_parameters(name):
    """Other parameter values at run time give what a robot file with these values gives."""
    model, rng = example(name), np.random.default_rng(3)
    p = np.array(model.parameter_values) * rng.uniform(0.9, 1.1, len(model.parameter_values))
    changed = changed_robot(model, p)
    oracle = Oracle(tomllib.loads(dump(changed)))
    state = {"q": 0.1 * rng.normal(size=model.nq), "v": rng.normal(size=model.nq)}
    state["q"][model.n_joints :] *= 0.01
    state |= {"tau": rng.normal(size=model.n_joints), "w_ext": rng.normal(size=(model.n_links, 6))}
    inputs = tuple(state.values())
    compiled = quick(model)
    compiled.prepare(p)
    results = [model.numpy(p).forward_dynamics(*inputs), compiled.forward_dynamics(*inputs)]
    vdot, wrench = model.casadi()["forward_dynamics"](*inputs[:3], inputs[3].T, p)
    results.append((flat(vdot), np.array(wrench).T))
    for result in results:
        assert max(oracle.errors(state, *result).values()) <= oracle.tolerance(state["q"])


def changed_robot(model, p):
    """The robot with the parameter values `p`, put into its description by their names."""
    data = model.robot.model_dump(exclude_none=True)
    for name, value in zip(model.parameter_names, p, strict=True):
        put(data, name, float(value))
    return Robot.model_validate(data)


def put(data: dict, name: str, value: float) -> None:
    """Put one parameter in place: `gravity[2]`, `upper_arm.rhoA`, `upper_arm.bodies[0].com[1]`."""
    if not name.startswith("gravity"):
        link, _, name = name.partition(".")
        data = next(x for x in data["links"] if x["name"] == link)
        if name in ("rhoA", "EA", "EIy", "EIz", "GJ", "rhoIp"):
            data = data["section"]
    *path, last = name.replace("[", ".").replace("]", "").split(".")
    for key in path:
        inner = data[int(key)] if key.isdigit() else data[key]
        if isinstance(inner, tuple):
            inner = list(inner)
            data[int(key) if key.isdigit() else key] = inner
        data = inner
    data[int(last) if last.isdigit() else last] = value
