"""Timoshenko rods, shear and rotary inertia: against the oracle, and against formulas."""

import numpy as np
import pytest
import random_robots as rr
import scipy.linalg
import scipy.optimize
from helpers import arm, link, model_of, relative
from helpers import case_of as case_in

from screwgen import Robot
from screwgen.algorithms.gauges import gauges
from screwgen.bodies.markers import strains
from screwgen.studies.equilibrium import equilibrium
from screwgen.studies.modes import natural_frequencies
from screwgen.studies.stiffness import stiffness_matrix

# ------------------------------------------------------------------------------------ formulas

E, NU, RHO = 1e9, 0.3, 7850.0
KAPPA = 10 * (1 + NU) / (12 + 11 * NU)


def section_of(height: float, breadth: float, shear=True, rotary=True) -> dict:
    """A rectangle, its height along y."""
    area, Iy, Iz = height * breadth, height * breadth**3 / 12, breadth * height**3 / 12
    GA, rho = KAPPA * E / (2 * (1 + NU)) * area, RHO
    section = {"rhoA": rho * area, "EA": E * area, "EIy": E * Iy, "EIz": E * Iz}
    section |= {"GAy": GA, "GAz": GA} if shear else {}
    return section | ({"rhoIy": rho * Iy, "rhoIz": rho * Iz} if rotary else {})


def beam(length: float, height: float, modes: dict, axes=(), rotary=True, **more):
    section = section_of(height, height, any(name.startswith("shear") for name in modes), rotary)
    table = {"name": "beam", "length": length, "section": section, "modes": modes, "joint": {"axes": list(axes)}}
    return model_of({"name": "rod", "gravity": [0.0, 0.0, 0.0], "links": [table | more]})


def supported(model) -> np.ndarray:
    """Circular frequencies of a beam on a joint at its base whose tip is held in y by a row of Lagrange, ascending."""
    key, q = model.chain.keys[0], np.zeros(model.nq)
    tip = [x for d in dict.fromkeys(d for d, _ in key.directions) for x in key.shapes(d).tip_value]
    free = scipy.linalg.null_space([[model.robot.links[0].length, *tip]])
    M, K = model.numpy().mass_matrix(q), stiffness_matrix(model)
    return np.sqrt(scipy.linalg.eigh(free.T @ K @ free, free.T @ M @ free, eigvals_only=True))


@pytest.mark.parametrize("direction, axis", [("y", "z"), ("z", [0.0, -1.0, 0.0])])
def test_a_beam_on_two_supports_vibrates_as_published(direction, axis):
    """The near support is a joint, the far one a constraint on the tip: a chain has no second."""
    found = supported(beam(2.0, 0.4, {f"bending_{direction}": 9, f"shear_{direction}": 9}, [axis]))[:2]
    assert np.allclose(found, [95.633981, 332.234514], rtol=1e-6)
    slender = supported(beam(2.0, 0.4, {f"bending_{direction}": 9}, [axis], rotary=False))[0]
    assert abs(slender / (np.pi**2 * np.sqrt(E * 0.4**2 / 12 / RHO) / 4) - 1) < 1e-6 and abs(slender - 101.689) < 1e-3


def clamped_free(length: float, height: float, count: int) -> list[float]:
    """Circular frequencies of Timoshenko's cantilever, the roots of Huang's equation (J. Appl. Mech. 28, 1961)."""
    I, A = height**4 / 12, height**2
    r2, s2 = I / (A * length**2), E * I / (KAPPA * E / (2 * (1 + NU)) * A * length**2)

    def equation(b: float) -> float:
        root = np.sqrt((r2 - s2) ** 2 + 4 / b**2)
        alpha, beta = (b * np.sqrt((sign * (r2 + s2) + root) / 2) for sign in (-1, 1))
        bracket = b**2 * (r2 - s2) ** 2 + 2
        mixed = b * (r2 + s2) / np.sqrt(1 - b**2 * r2 * s2) * np.sinh(alpha) * np.sin(beta)
        return 2 + bracket * np.cosh(alpha) * np.cos(beta) - mixed

    grid = np.linspace(1.0, 0.999 / np.sqrt(r2 * s2), 4000)
    values = [equation(b) for b in grid]
    roots = [scipy.optimize.brentq(equation, a, b, xtol=1e-13)
             for a, b, f, g in zip(grid, grid[1:], values, values[1:], strict=False) if f * g < 0]  # fmt: skip
    return [b * np.sqrt(E * I / (RHO * A)) / length**2 for b in roots[:count]]


@pytest.mark.parametrize("slenderness", [4, 10, 50])
def test_cantilevers_vibrate_as_huang_has_it(slenderness):
    length = 1.0
    expected = clamped_free(length, length / slenderness, 3)
    model = beam(length, length / slenderness, {"bending_z": 10, "shear_z": 10})
    assert np.allclose(2 * np.pi * natural_frequencies(model)[:3], expected, rtol=1e-7)


@pytest.mark.parametrize("basis, modes, bound", [("polynomial", (2, 1), 1e-12), ("clamped_free", (6, 6), 2e-2)])
def test_the_tip_deflects_by_bending_and_shear(basis, modes, bound):
    length, height, force = 1.0, 0.25, 1e3
    model = beam(length, height, {"basis": basis, "bending_y": modes[0], "shear_y": modes[1]})
    section, key = section_of(height, height), model.chain.keys[0]
    tip = np.concatenate([key.shapes(d).tip_value for d in ("bending_y", "shear_y")])
    found = tip @ np.linalg.solve(stiffness_matrix(model), tip * force)
    expected = force * length**3 / (3 * section["EIz"]) + force * length / section["GAy"]
    assert abs(found / expected - 1) < bound


def test_an_equilibrium_hangs_by_its_own_weight_in_both():
    """``q l^4/8EI + q l^2/2GA`` at the tip."""
    height, q = 0.25, 9.81 * RHO * 0.25**2
    table = link("beam", 1.0, [], modes={"bending_z": 3, "shear_z": 2}, section=section_of(height, height))
    section = section_of(height, height)
    found = equilibrium(model_of(arm(table)))
    expected = q / (8 * section["EIy"]) + q / (2 * section["GAz"])
    assert abs(found.tip_position[2] / -expected - 1) < 1e-9


def test_slender_rods_do_not_lock():
    """Frequencies tend to Euler's as the square of the height, with the polynomials that Euler's rod needs."""
    errors = []
    for height in (1e-1, 1e-2, 1e-3):
        sheared, slender = (beam(1.0, height, {"bending_z": 4} | more, rotary=bool(more))
                            for more in ({"shear_z": 4}, {}))  # fmt: skip
        errors.append(1 - natural_frequencies(sheared)[0] / natural_frequencies(slender)[0])
    assert errors[2] < 2e-6 and np.allclose(np.array(errors[:2]) / errors[1:], 100, rtol=2e-2)


@pytest.mark.parametrize("ratio", [0.05, 0.5])
def test_a_column_that_shears_buckles_under_haringxs_load(ratio):
    """To second order, a dead load at the tip: ``P (1 + P/GA) = pi^2 EI/4 l^2``, with ``ratio`` the quotient P_E/GA."""
    euler, mass = np.pi**2 / 4, 1.0
    section = {"EIy": 1.0, "EIz": 1.0, "GAy": euler / ratio, "rhoIz": 1e-3}

    def lowest(load: float) -> float:
        table = link(
            "rod", 1.0, [], 1e-6, {"bending_y": 4, "shear_y": 4}, [{"at": "tip", "mass": mass}], section=section
        )
        model = model_of(arm(table, gravity=(-load / mass, 0, 0), order=2))
        q = np.zeros(model.nq)
        slope = model.numpy().derivatives(q, q, np.zeros(0), np.zeros((1, 6)))[0]
        K = -model.numpy().mass_matrix(q) @ slope
        return np.linalg.eigvalsh((K + K.T) / 2)[0]

    expected = (np.sqrt(1 + 4 * ratio) - 1) / (2 * ratio) * euler
    found = scipy.optimize.brentq(lowest, 0.9 * expected, 1.1 * expected, xtol=1e-6)
    assert abs(found / expected - 1) < 1e-4


# ------------------------------------------------------------------------------------ what follows, what costs


def test_rotary_inertia_of_a_rigid_link_is_that_of_a_body():
    plain = link("rod", 0.7, ["x", "y", "z"], 1.5)
    turning = plain | {"section": plain["section"] | {"rhoIy": 0.2, "rhoIz": 0.3}}
    carried = plain | {"bodies": [{"at": "base", "mass": 0.0, "inertia": [0.0, 0.14, 0.21, 0.0, 0.0, 0.0]}]}
    rng = np.random.default_rng(1)
    q, v, tau, w_ext = rng.uniform(-1, 1, 3), rng.uniform(-2, 2, 3), rng.uniform(-1, 1, 3), rng.uniform(-1, 1, (1, 6))
    # an inertia alone must obey the triangle inequality, so both carry some about x as well
    for table in (turning, carried):
        table["section"] = table["section"] | {"rhoIp": 0.5}
    carried["section"] = carried["section"] | {"rhoIp": 0.0}
    carried["bodies"][0]["inertia"][0] = 0.35
    found, expected = (model_of(arm(x)).numpy().forward_dynamics(q, v, tau, w_ext) for x in (turning, carried))
    assert relative(found[0], expected[0]) < 1e-12 and relative(found[1], expected[1]) < 1e-12


def test_what_has_no_modes_is_free_of_cost():
    """GAy beside no modes of shear is a parameter that nothing reads."""
    plain = link("rod", modes={"bending_y": 2, "torsion": 1})
    stated = plain | {"section": plain["section"] | {"GAy": 5.0}}
    a, b = (model_of(arm(x)) for x in (plain, stated))
    assert a.chain.keys == b.chain.keys and "rod.GAy" in b.parameter_names
    sheared = model_of(arm(stated | {"modes": {"bending_y": 2, "torsion": 1, "shear_y": 1}}))
    assert a.chain.keys[0].coupled == () and len(sheared.chain.keys[0].coupled) == 2


def test_gauges_do_not_see_shear_and_strains_name_it():
    model = model_of(arm(link("rod", modes={"bending_y": 2, "shear_y": 2}, section={"GAy": 5.0, "rhoIz": 1e-2})))
    assert [(g.direction, g.first, len(g.curvatures)) for g in gauges(model.chain)] == [("bending_y", 0, 2)]
    found = strains(model.chain.keys[0], 0.3)[1]
    shapes = model.chain.keys[0].shapes("shear_y")
    assert (found.direction, found.modes, found.order) == ("shear_y", [2, 3], 1)
    assert np.allclose(found.weights, np.ravel(shapes.evaluate([0.3], 1)))
    assert model.q_names[-1] == "rod.eta.shear_y[1]"
    assert "rod.base_strain.shear_y" in model.linearise(np.zeros(5), outputs=("base_strain",)).output_names


def test_sections_may_turn_without_inertia_where_the_tip_has_some():
    """The modal inertia of the link alone is singular then."""
    body = {"at": "tip", "mass": 0.6, "com": [0.0, 0.1, 0.05], "inertia": [1e-2, 2e-2, 2e-2, 0.0, 0.0, 0.0]}
    modes = {"axial": 2, "bending_y": 2, "bending_z": 3, "torsion": 3, "shear_y": 2, "shear_z": 2}
    section = {"EA": 1e3, "EIy": 3.0, "EIz": 5.0, "GJ": 2.0, "rhoIp": 1e-2, "GAy": 50.0, "GAz": 70.0}
    robot = arm(link("rod", 1.0, ["z", "y"], 1.0, modes, [body], section=section))
    case = case_in(robot, rr.random_state(np.random.default_rng(3), robot))
    assert case.model.chain.keys[0].has_inertialess_section_modes and case.oracle.condition(case.state["q"]) < 1e8
    assert (
        max(case.oracle.errors(case.state, *case.model.numpy().forward_dynamics(*case.inputs)).values())
        < case.tolerance
    )
    bare = arm(link("rod", 1.0, ["z", "y"], 1.0, modes, section=section))
    with pytest.raises(ValueError, match=r"is missing, but modes\.shear_y needs it"):
        Robot.model_validate(bare)


@pytest.mark.parametrize("between", ["step", "linear", "polynomial"])
def test_equal_stations_are_a_uniform_rod(between):
    section = {**section_of(0.3, 0.2), "GJ": 1e6, "rhoIp": 50.0}
    stated = [{"at": s, **section} for s in (0.0, 0.4, 0.4, 1.0)]
    stated = stated if between == "step" else {"stations": [*stated[:2], stated[3]], "between": between}
    modes = {"axial": 1, "bending_y": 1, "bending_z": 2, "torsion": 1, "shear_y": 2, "shear_z": 1}
    table = {"name": "rod", "length": 0.8, "section": stated, "modes": modes, "joint": {"axes": ["y", "x"]}}
    model = model_of(arm(table | {"damping": {"ratio": 0.01}}))
    uniform = model_of(arm(table | {"damping": {"ratio": 0.01}, "section": section}))
    rng = np.random.default_rng(2)
    q, v, tau, w_ext = 0.01 * rng.uniform(-1, 1, 10), rng.uniform(-1, 1, 10), np.ones(2), np.ones((1, 6))
    found, expected = (m.numpy().forward_dynamics(q, v, tau, w_ext)[0] for m in (model, uniform))
    assert relative(found, expected) < 1e-9
    assert relative(model.numpy().mass_matrix(q), uniform.numpy().mass_matrix(q)) < 1e-13
