"""Rods to second order: the graded Lagrangian of the oracle, and published numbers."""

from functools import cache

import judges
import numpy as np
import pytest
import scipy.integrate
import scipy.linalg
import scipy.optimize
from conftest import swept
from helpers import ROOT, Case, arm, drawn, flat, link, model_of

from screwgen import Modes, SingularError, derive, load
from screwgen.studies.equilibrium import equilibrium

SEEDS = range(10)
SHORT = (0, 1, 2, 4, 5, 7)
"""One to four links; the others are judged in `make test-long`."""


@cache
def case_of(seed: int) -> Case:
    """Orders 1 and 2 and sections that vary mixed in one arm, all features of robot files."""
    return drawn(700 + seed, 1 + seed % 4, second_order=0.7, stations=0.3)


@pytest.mark.parametrize("seed", swept(range(200), *SHORT))
def test_random_robots_equal_the_oracle(seed):
    """A state is refused where the oracle's mass matrix has lost its definiteness, too."""
    case = case_of(seed)
    if np.linalg.eigvalsh(case.oracle.mass_matrix(case.state["q"]))[0] <= 0:
        with pytest.raises(SingularError):
            case.model.numpy().forward_dynamics(*case.inputs)
        return
    judges.numpy_and_casadi(case)


def test_most_of_the_robots_have_links_of_second_order():
    orders = [key.order for seed in SEEDS for key in case_of(seed).model.chain.keys]
    assert 0.3 <= orders.count(2) / len(orders) <= 0.9


# ------------------------------------------------------------------------------------ published numbers


def cantilever(modes: int, direction="bending_z", axis="z", **more):
    """A rod of unit length, mass per length and stiffness on a hub that turns about z."""
    section = {"EIy": 1.0, "EIz": 1.0, "EA": 1e4}
    links = [link("rod", 1.0, axis, 1.0, {direction: modes}, section=section, **more)]
    return model_of(arm(*links, gravity=(0, 0, 0), order=2))


def stiffness(model, v=None) -> np.ndarray:
    """The stiffness of the straight arm about steady rates, joints and modes: what its exact derivatives say."""
    v = np.zeros(model.nq) if v is None else v
    still, unloaded = np.zeros(model.nq), np.zeros((model.n_links, 6))
    slope = numeric(model).derivatives(still, v, np.zeros(model.n_joints), unloaded)[0]
    K = -numeric(model).mass_matrix(still) @ slope
    return (K + K.T) / 2


@cache
def numeric(model):
    return model.numpy()


def rotating_frequencies(model, rate: float) -> np.ndarray:
    """Circular frequencies of the modes about the steady rotation of the hub, its rate held."""
    v = np.zeros(model.nq)
    v[0] = rate
    M = numeric(model).mass_matrix(np.zeros(model.nq))[1:, 1:]
    return np.sqrt(scipy.linalg.eigh(stiffness(model, v)[1:, 1:], M, eigvals_only=True))


SPEEDS = (0, 2, 4, 6, 8, 10, 12)
FLAP = (
    (3.51602, 4.13732, 5.58500, 7.36037, 9.25684, 11.20233, 13.17015),
    (22.03449, 22.61492, 24.27335, 26.80908, 29.99538, 33.64037, 37.60311),
)


@pytest.mark.parametrize("modes, bounds", [(5, (2e-4, 1e-3)), pytest.param(8, (2e-6, 2e-6), marks=pytest.mark.long)])
def test_a_rotating_cantilever_stiffens(modes, bounds):
    """Flapwise frequencies of a cantilever on a hub of no radius."""
    flap = cantilever(modes)
    for k, rate in enumerate(SPEEDS):
        found = rotating_frequencies(flap, rate)[:2]
        assert all(abs(found[i] / FLAP[i][k] - 1) <= bounds[i] for i in (0, 1))


def test_lagwise_the_squared_frequency_is_less_by_the_squared_rate():
    flap, lag = (rotating_frequencies(cantilever(3, d), 12.0) for d in ("bending_z", "bending_y"))
    assert np.allclose(lag**2, flap**2 - 144.0, rtol=1e-9)


def test_a_link_spun_up_deflects_as_published():
    """Ten metres, spun up to 6 rad/s in 15 s: the tip lags by 0.574 m at most and ends on the turning radius."""
    end, rate = 15.0, 6.0
    section = {"EIy": 1.4e4, "EIz": 1.4e4, "EA": 2.8e7}
    model = model_of(arm(link("rod", 10.0, "z", 1.2, {"bending_y": 3}, section=section), gravity=(0, 0, 0), order=2))
    inertia, bias = (model.casadi()[name] for name in ("mass_matrix", "bias"))
    shapes, p = np.array(model.chain.keys[0].shapes("bending_y").tip_value), model.parameter_values

    def slope(t, x):
        phase = 2 * np.pi * t / end
        q, v = np.append(0.0, x[:3]), np.append(rate / end * (t - end / (2 * np.pi) * np.sin(phase)), x[3:])
        M, h = inertia(q, p).full(), flat(bias(q, v, np.zeros((6, 1)), p))
        return np.append(x[3:], np.linalg.solve(M[1:, 1:], -h[1:] - M[1:, 0] * rate / end * (1 - np.cos(phase))))

    run = scipy.integrate.solve_ivp(slope, (0, 8), np.zeros(6), method="DOP853", rtol=1e-7, atol=1e-9, max_step=0.1)
    assert abs((shapes @ run.y[:3]).min() + 0.5744) < 1e-3


def column(modes: int, load: float, mass: float = 0.0):
    """A clamped rod of unit length, mass and stiffness that stands on its base, or under a mass on its tip."""
    bodies = [{"at": "tip", "mass": mass}] if mass else None
    flexible = {"modes": {"bending_y": modes}, "section": {"EIy": 1.0, "EIz": 1.0}}
    return model_of(arm(link("rod", 1.0, [], 1.0, bodies=bodies, **flexible), gravity=(-load, 0, 0), order=2))


@pytest.mark.parametrize("modes, bound", [(4, 1.4e-4), (5, 1e-6)])
def test_a_column_buckles_under_its_weight(modes, bound):
    lowest = lambda load: np.linalg.eigvalsh(stiffness(column(modes, load)))[0]  # noqa: E731
    assert abs(scipy.optimize.brentq(lowest, 6, 9) / 7.837347 - 1) <= bound


def test_a_column_buckles_under_a_tip_load():
    mass = 1e6
    lowest = lambda load: np.linalg.eigvalsh(stiffness(column(4, load / mass, mass)))[0]  # noqa: E731
    assert abs(scipy.optimize.brentq(lowest, 2, 3) / (np.pi**2 / 4) - 1) <= 1e-4


ELASTICA = {1: (0.301721, 0.056433), 2: (0.493457, 0.160642), 4: (0.669964, 0.328941)}


def bent(load: float, order: int, segments: int) -> np.ndarray:
    """Deflection and approach of the tip of a cantilever of unit length and stiffness under a dead load at its tip."""
    flexible = {"modes": {"bending_z": 3}, "section": {"EIy": 1.0, "EIz": 1.0}, "rhoA": 1e-9}
    beam = link("beam", 1.0, [], bodies=[{"at": "tip", "mass": 1.0}], segments=segments, **flexible)
    found = equilibrium(model_of(arm(beam, gravity=(0, 0, -load), order=order)))
    return np.array([-found.tip_position[2], 1 - found.tip_position[0]])


@pytest.mark.parametrize("load", ELASTICA)
def test_segments_tend_to_the_elastica(load):
    """The error falls with the cube of the segments' number at order 2, with its square at order 1."""
    errors = {o: [abs(bent(load, o, k) / ELASTICA[load] - 1).max() for k in (4, 8)] for o in (1, 2)}
    assert errors[2][1] < 2e-3 and errors[1][1] < 2e-2
    assert 7 < errors[2][0] / errors[2][1] < 9 and 3.5 < errors[1][0] / errors[1][1] < 5.5


def test_the_watch_knows_orders():
    """A column past its buckling load: order 1 warns of axial load and names order 2, which has no such bound."""
    state = np.zeros(2)
    first = column(2, 12.0).robot.model_copy(update={"order": 1})
    said = derive(first).validity(state).line()
    assert "axial load" in said and "order = 2" in said
    assert column(2, 12.0).validity(state).holds


@pytest.mark.parametrize("pieces, lost", [(1, True), (2, False)])
def test_a_bent_link_with_torsion_wants_pieces(pieces, lost):
    """ELLA's weight bends its upper arm by 15 mm, and its sections have a radius of gyration of 11 mm. In one piece, of
    two modes per plane, the mass matrix is no longer definite: what twisting swings out is left out of the energy."""
    robot = load(ROOT / "examples" / "ella.toml")
    bent = {"modes": Modes(bending_y=2, bending_z=2, torsion=1), "segments": pieces}
    links = tuple(x.model_copy(update=bent) for x in robot.links)
    model = derive(robot.model_copy(update={"order": 2, "links": links}))
    numeric, unloaded = model.numpy(), np.zeros((model.n_links, 6))
    rest = equilibrium(model, np.zeros(model.n_joints), hold=True).q
    assert (np.linalg.eigvalsh(numeric.mass_matrix(rest))[0] < 0) == lost
    if lost:
        with pytest.raises(SingularError):
            numeric.forward_dynamics(rest, 0 * rest, np.zeros(model.n_joints), unloaded)
