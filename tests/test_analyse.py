"""Well-posedness, spectrum and step limits, each against a computation of its own."""

import json

import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from helpers import arm, equal_links, example, link, model_of, quick

import screwgen
from screwgen.integrators import METHODS
from screwgen.simulation.controllers import PD
from screwgen.simulation.integrate import Dynamics, HeldAccelerations
from screwgen.simulation.linearised import Linearised
from screwgen.simulation.state import State
from screwgen.studies.analysis import sample_states
from screwgen.studies.analysis.regularity import regularity
from screwgen.studies.analysis.spectrum import growth, jacobian, motions, step_map

SOFT = {"EIy": 60.0, "EIz": 90.0, "rhoIp": 1e-3}


def beam(ratio=None, **more) -> dict:
    """One welded link with one bending mode."""
    damping = {"damping": {"ratio": ratio}} if ratio is not None else {}
    modes = {"basis": "clamped_free", "bending_y": 1}
    return arm(link(axes=[], modes=modes, section={"EIz": 50.0}, **damping, **more), gravity=(0, 0, 0))


def single(ratio=None):
    model = model_of(beam(ratio))
    values = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    return model, 1.8751040687119611**2 * np.sqrt(values["arm.EIz"] / values["arm.rhoA"])


def state_of(robot: dict, rng, **options) -> State:
    s = rr.random_state(rng, robot, **options)
    return State(*(np.array(s[name]) for name in ("q", "v", "tau", "w_ext")))


def difference(f, x: np.ndarray, e: float = 1e-5) -> np.ndarray:
    """Derivative by differences of fourth order."""
    columns = [(8 * (f(x + d) - f(x - d)) - f(x + 2 * d) + f(x - 2 * d)) / (12 * e) for d in e * np.eye(len(x))]
    return np.array(columns).T


def equilibrium(model, joints: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """q, v, tau at rest: the modes bent by the weight, the joints held."""
    rest = screwgen.equilibrium(model, joints, hold=True)
    return rest.q, np.zeros(model.nq), rest.tau


# -------- the linearised dynamics and the steps


@pytest.mark.parametrize("seed", swept(range(4), 3))
def test_the_jacobian_is_the_derivative_of_the_dynamics(seed):
    robot, state, _ = rr.draw_regular(np.random.default_rng(seed), 2, limit=1e6)
    model, s = model_of(robot), State(*(np.array(state[k]) for k in ("q", "v", "tau", "w_ext")))

    def rates(x):
        return np.append(x[model.nq :], model.numpy().forward_dynamics(*np.split(x, 2), s.tau, s.w_ext)[0])

    expected = difference(rates, np.append(s.q, s.v))
    found = jacobian(model, s.q, s.v, s.tau, s.w_ext)
    assert np.abs(found - expected).max() < 1e-6 * np.abs(expected).max()


@pytest.mark.parametrize("method", ["euler", "semi_implicit", "modal_implicit"])
def test_maps_of_one_evaluation_are_derivatives_of_the_c_step_in_any_state(method):
    model, rng = example("ella"), np.random.default_rng(1)
    s = next(iter(sample_states(model, 1, 3).values()))
    c, w_ext = quick(model), rng.uniform(-1, 1, (2, 6))

    def step(x):
        return np.concatenate(c.step(*np.split(x, 2), s.tau, w_ext, 1e-3, method))

    expected = difference(step, np.append(s.q, s.v))
    found = step_map(model, method, s.q, s.v, 1e-3, s.tau, w_ext=w_ext)
    assert np.abs(found - expected).max() < 1e-7 * np.abs(expected).max()


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", ["ella", "six_link"])
def test_every_map_is_the_derivative_of_the_step_at_an_equilibrium(method, name):
    model = example(name)
    q, v, tau = equilibrium(model, np.linspace(-0.5, 0.9, model.n_joints))
    held = HeldAccelerations(Dynamics(model, model.parameter_values), tau, np.zeros((model.n_links, 6)))

    def step(x):
        return np.concatenate(METHODS[method].step(held, *np.split(x, 2), 5e-4))

    expected = difference(step, np.append(q, v), 1e-4)
    found = step_map(model, method, q, v, 5e-4, tau)
    assert np.abs(found - expected).max() < 1e-6 * np.abs(expected).max()
    assert growth(found) == pytest.approx(np.abs(np.linalg.eigvals(expected)).max(), rel=1e-5)


def test_a_controller_acts_on_the_state_at_the_steps_start():
    model = example("ella")
    law = PD((400.0, 300.0, 200.0), (20.0, 15.0, 9.0), (0.1, 0.2, -0.3), tau_max=(1e4, 1e4, 1e-3))
    q, v = np.array([0.1, 0.3, 0.2, *6 * [1e-4]]), np.linspace(-0.1, 0.1, 9)
    c, w_ext = quick(model), np.zeros((2, 6))

    def step(x):
        return np.concatenate(c.step(x[:9], x[9:], law(0.0, x[:9], x[9:]), w_ext, 1e-3, "modal_implicit"))

    expected = difference(step, np.append(q, v))
    found = step_map(model, "modal_implicit", q, v, 1e-3, controller=law)
    assert np.abs(found - expected).max() < 1e-7 * np.abs(expected).max()


def test_growth_predicted_is_growth_of_a_run():
    model, omega = single()
    h, steps = 1e-3, 400
    run = screwgen.simulate(model, steps * h, h, [1e-3], integrator="euler", backend="casadi")
    S = step_map(model, "euler", [0.0], [0.0], h)
    amplitude = np.hypot(run.q[:, 0] * omega, run.v[:, 0])
    assert growth(S) == pytest.approx(np.sqrt(1 + (omega * h) ** 2), rel=1e-12)
    assert amplitude[-1] / amplitude[0] == pytest.approx(growth(S) ** steps, rel=1e-9)


# -------- step limits


def limits(model, **options) -> dict:
    found = screwgen.analyse(model, [{}], **options).states[0].limits
    return {limit.method: limit for limit in found}


def test_limits_of_a_single_undamped_mode():
    model, omega = single()
    found = limits(model, step=1e-3)
    assert found["euler"].limit == 0.0 and not found["euler"].borne
    assert found["euler"].rate == pytest.approx(np.log(1 + (omega * 1e-3) ** 2) / 2e-3, rel=1e-9)
    assert found["semi_implicit"].limit == pytest.approx(2 / omega, rel=1e-4)
    assert found["rk4"].limit == pytest.approx(2 * np.sqrt(2) / omega, rel=5e-4)
    assert found["modal_implicit"].limit is None and found["modal_midpoint"].limit is None
    assert found["modal_midpoint"].factor == pytest.approx(1, abs=1e-12)
    assert found["modal_implicit"].factor < 1


def test_forward_euler_bears_what_damping_allows():
    model, omega = single(0.02)
    assert limits(model)["euler"].limit == pytest.approx(2 * 0.02 / omega, rel=0.01)


def test_an_arm_that_falls_does_not_spoil_the_limits():
    """The limit of the stiffest mode, though gravity makes the posture unstable."""
    model = example("ella")
    q, v, tau = equilibrium(model, np.array([-1.2, 0.3, 0.2]))
    eigenvalues = np.linalg.eigvals(jacobian(model, q, v, tau))
    assert eigenvalues.real.max() > 1
    found = {x.method: x for x in screwgen.analyse(model, [State(q, v, tau, np.zeros((2, 6)))]).states[0].limits}
    assert found["semi_implicit"].limit == pytest.approx(2 / np.abs(eigenvalues).max(), rel=1e-3)
    assert found["rk4"].limit == pytest.approx(2 * np.sqrt(2) / np.abs(eigenvalues).max(), rel=1e-3)
    assert found["modal_midpoint"].borne and found["modal_midpoint"].rate == pytest.approx(
        eigenvalues.real.max(), rel=0.02
    )


def test_a_fast_state_is_judged_by_what_is_faster_than_it():
    """Joints at 15 rad/s: the slow swings gain 0.02 1/s, which a state that changes within them cannot judge."""
    v = [10.3694, -9.2416, 5.4964, *6 * [0.0]]
    state = {"q": [-0.256, 0.7035, 0.6334], "v": v}
    analysis = screwgen.analyse(example("ella"), {"fast": state})
    assert analysis.states[0].turning == pytest.approx(np.linalg.norm(v))
    found = {limit.method: limit for limit in analysis.states[0].limits}
    assert found["modal_implicit"].borne and found["modal_midpoint"].borne
    assert found["modal_implicit"].limit is None or found["modal_implicit"].limit > 0.05
    assert not any(found[name].borne for name in ("euler", "semi_implicit", "rk4"))
    assert "Joints turn at up to 14.9 rad/s, 0.0149 rad in a step" in " ".join(analysis.text().split())


def test_dampers_of_joints_bound_explicit_methods_only():
    """Beyond its limit the factor of rk4 is real and above 1: what dies away by itself grows without swinging."""
    robot = arm(link(axes=["z"], joint={"damping": [50.0]}), gravity=(0, 0, 0))
    found = {limit.method: limit.limit for limit in screwgen.analyse(model_of(robot), [{}]).states[0].limits}
    for method in ("euler", "semi_implicit"):
        assert found[method] == pytest.approx(2 / 3 / 50.0, rel=1e-3)
    assert found["rk4"] == pytest.approx(2.7853 / 3 / 50.0, rel=1e-3)
    assert found["modal_implicit"] is None and found["modal_midpoint"] is None


def test_high_gains_bound_the_step_of_implicit_modes_too():
    robot = arm(link(axes=["z"], section={"rhoIp": 1e-3}), gravity=(0, 0, 0))
    law = PD((0.0,), (50.0,), (0.0,))
    found = screwgen.analyse(model_of(robot), [{}], controller=law, step=0.02).states[0].limits
    inertia = 1 / 3
    assert [x.limit for x in found] == pytest.approx(5 * [2 * inertia / 50.0], rel=1e-3)
    assert not any(x.borne for x in found)


def test_the_papers_bound_is_that_of_its_formula():
    assert screwgen.analyse(example("ella"), [{}]).paper_bound == pytest.approx(10.37e-3, rel=1e-3)
    assert screwgen.analyse(model_of(arm(link())), [{}]).paper_bound is None


# -------- spectrum


def test_the_spectrum_holds_the_natural_frequencies():
    robot = rr.random_robot(np.random.default_rng(5), 2, no_gravity=1.0, rhoIp=1.0)
    robot["gravity"] = [0.0, 0.0, 0.0]
    for table in robot["links"]:
        table.pop("damping", None)
        table["joint"] = {"axes": table["joint"]["axes"]}
    model = model_of(robot)
    q = np.append(np.full(model.n_joints, 0.4), np.zeros(model.nq - model.n_joints))
    expected = screwgen.natural_frequencies(model, q, "free")
    found = motions(Linearised(model, q, np.zeros(model.nq)))
    frequencies = sorted(m.frequency_hz for m in found if m.kind == "oscillates")
    assert np.allclose(frequencies, expected[expected > 0], rtol=1e-8)
    assert sum(m.kind == "free" for m in found) == 2 * np.sum(expected == 0)


def test_damping_ratios_and_falling_are_named():
    found = motions(Linearised(single(0.03)[0], [0.0], [0.0]))
    assert [m.kind for m in found] == ["oscillates"] and found[0].damping == pytest.approx(0.03, rel=1e-9)
    up = model_of(arm(link(axes=["y"], length=1.0)))
    found = motions(Linearised(up, [-np.pi / 2], [0.0]))
    assert [m.kind for m in found] == ["falls", "decays"]
    assert found[0].eigenvalue.real == pytest.approx(np.sqrt(1.5 * 9.81), rel=1e-9)


# -------- the assembled system


def assembled(model, s: State) -> np.ndarray:
    f = model.casadi()
    x = f["dae_state"](s.q, s.v, model.parameter_values)
    return np.array(f["assemble"](x, s.tau, s.w_ext.T, model.parameter_values)[0])


@pytest.mark.parametrize("seed", swept(range(5), 2))
def test_numbers_of_random_robots(seed):
    """Rank, condition and structure against numpy on CasADi's M_sys; one zero singular value per axis with P alone."""
    rng = np.random.default_rng(seed)
    robot, _, _ = rr.draw_regular(rng, limit=1e6, max_links=3, max_modes=1, rhoIp=1.0)
    model, s = model_of(robot), state_of(robot, rng)
    a = screwgen.analyse(model, [s])
    found, M = a.states[0], assembled(model, s)
    sigma = np.linalg.svd(M, compute_uv=False)
    assert found.system.smallest == pytest.approx(sigma[-1], rel=1e-6)
    assert found.system.condition == pytest.approx(sigma[0] / sigma[-1], rel=1e-6)
    assert found.system.regular and a.well_posed
    assert found.projectors.size - found.projectors.rank == model.n_joints
    assert a.structure.nonzeros == model.casadi()["assemble"].nnz_out("M_sys")
    inside = np.zeros_like(M, bool)
    inside[a.structure.rows, a.structure.columns] = True
    assert (M[~inside] == 0).all() and a.structure.block_bandwidth == 1
    for block in found.blocks:
        assert block.definite and block.smallest > 0 and block.asymmetry < 1e-12 and block.rank_M_star == 6


def test_condition_of_the_equilibrated_matrix_does_not_depend_on_the_units_of_its_rows():
    model = example("ella")
    s = next(iter(sample_states(model, 1).values()))
    M = assembled(model, s)
    other = np.logspace(-6, 6, len(M))[:, None] * M
    assert regularity(other).condition_scaled == pytest.approx(regularity(M).condition_scaled, rel=1e-9)
    assert regularity(M).condition_scaled < regularity(M).condition < regularity(other).condition


def test_a_link_without_spin_inertia_is_only_semidefinite():
    """Straight, and bent with the same modes in y and z: the block is singular, M_sys is not (E29)."""
    robot = arm(
        link("upper", modes={"bending_y": 1, "bending_z": 1}, section={**SOFT}, axes=["y", "z"]),
        link("forearm", modes={"bending_y": 1, "bending_z": 1}, section={**SOFT}, axes=["z"]),
    )
    del robot["links"][1]["section"]["rhoIp"]
    model = model_of(robot)
    bent = np.array([0.2, 0.3, 0.4, 0.01, 0.02, 0.03, -0.02])
    a = screwgen.analyse(model, {"straight": {}, "bent": bent})
    assert a.well_posed
    for state in a.states:
        upper, forearm = state.blocks
        assert upper.definite and upper.rank_M_star == 6 and not upper.null
        assert not forearm.definite and forearm.rank_M_star == 5
        assert "forearm: turning about its own axis" in forearm.null and "give rhoIp or a body" in forearm.null
    assert "its modes giving way" in a.states[1].blocks[1].null
    assert a.states[0].blocks[1].smallest == pytest.approx(0, abs=1e-15)
    assert "ONLY SEMIDEFINITE" in a.text()
    robot["links"][1]["bodies"] = [{"at": "tip", "mass": 1.0, "inertia": [1e-3, 1e-3, 1e-3, 0, 0, 0]}]
    assert all(b.definite for b in screwgen.analyse(model_of(robot), [{}]).states[0].blocks)


def test_a_singular_posture_is_reported_and_the_rest_goes_on():
    robot = arm(link("wrist", axes=["x", "z", "x"]), gravity=(0, 0, 0))
    model = model_of(robot)
    a = screwgen.analyse(model, {"home": [0.0, 0.0, 0.0], "bent": [0.0, 0.7, 0.0]})
    home, bent = a.states
    assert "wrist" in home.singular and not home.well_posed and not home.motions
    assert bent.well_posed and bent.limits and not a.well_posed
    assert a.text().splitlines()[2].startswith("NOT WELL POSED: in 1 of 2 states") and "home: " in a.text()
    assert json.loads(a.to_json())["states"][0]["system"] is None


def test_a_roll_joint_without_inertia_is_singular_everywhere_yet_analysed():
    robot = arm(link("arm", axes=["z"]), link("spit", axes=["x"]))
    del robot["links"][1]["section"]["rhoIp"]
    a = screwgen.analyse(model_of(robot), [[0.1, 0.2]])
    (state,) = a.states
    assert "spit" in state.singular and state.system.rank == state.system.size - 1
    assert not state.blocks[1].definite and a.structure.nonzeros > 0


def test_many_links_and_none_that_moves():
    a = screwgen.analyse(model_of(equal_links(12, 3)), [{}])
    assert a.well_posed and a.structure.size == 12 * 12 + 4 * 1 + 4 * 1 + 4 * 2
    state = a.states[0]
    assert state.projectors.size - state.projectors.rank == 12 and a.structure.block_bandwidth == 1
    assert max(map(len, a.text().splitlines())) <= 100
    welded = screwgen.analyse(model_of(arm(link(axes=[]), link("tip", axes=[]))), [{}])
    assert welded.well_posed and welded.states[0].motions == () and welded.text()
