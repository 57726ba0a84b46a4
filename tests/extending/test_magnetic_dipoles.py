"""A force between frames that the product does not contain: two magnets, which pull and turn each other."""

from dataclasses import dataclass

import casadi as ca
import numpy as np
import pytest
from fmi_units import Unit
from helpers import arm, link, model_of, quick, relative
from outside import Outside, every_check

from screwgen import Robot, RobotFileError, ScrewgenError, UsageError, dump, simulate
from screwgen.interactions import Interaction, ReportedQuantity, WrenchOnSecond, number
from screwgen.spec.forces import Force

K = 1e-7
"""N/A²: the magnetic constant over 4 π."""


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def seen(t, x, first, second):
    """Both moments and the unit vector between the magnets in the first's axes; what the force is measured in, J; m."""
    r = t.named("distance", t.call("sqrt", dot(x.d, x.d)))
    return (first, 0.0, 0.0), [second * row[0] for row in x.R], [y / r for y in x.d], K / (r * r * r), r


@dataclass(frozen=True)
class Dipole(Interaction):
    """Two magnets, each along x of its frame."""

    KIND = "dipole"
    WORDS = "magnets"
    QUANTITIES = {"distance": ReportedQuantity("m", "distance of the magnets")}  # noqa: RUF012

    first: float = number("A·m²", "moment of the first magnet", "m_1")
    second: float = number("A·m²", "moment of the second magnet", "m_2")

    @staticmethod
    def wrench(t, x, first, second):
        a, b, e, k, r = seen(t, x, first, second)
        ae, be = dot(a, e), dot(b, e)
        force = [3.0 * k / r * (ae * b[i] + be * a[i] + (dot(a, b) - 5.0 * ae * be) * e[i]) for i in range(3)]
        return WrenchOnSecond(cross(b, [k * (3.0 * ae * e[i] - a[i]) for i in range(3)]), force)

    @staticmethod
    def energy(t, x, first, second):
        a, b, e, k, _ = seen(t, x, first, second)
        return k * (dot(a, b) - 3.0 * dot(a, e) * dot(b, e))

    @staticmethod
    def outputs(t, x, first, second):
        return {"distance": seen(t, x, first, second)[-1]}


HALL = (0.9, 0.3, 0.4)
PAIRS = {"inside": ("upper.eye", "fore.tip", 3000.0, 900.0), "outside": ("world", "fore.tip", 4000.0, 900.0)}
SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}


def robot(magnets=True) -> dict:
    """Two links that bend, and magnets on both and in the world."""
    upper = link("upper", 0.7, ("z", "y"), markers=[{"name": "eye", "at": 0.6}], **SOFT)
    place = lambda x: {"world": HALL} if x == "world" else x  # noqa: E731
    forces = [
        Force(name=name, between=(place(a), place(b)), law=Dipole(*moments)) for name, (a, b, *moments) in PAIRS.items()
    ]
    out = arm(upper, link("fore", 0.5, ("y",), **SOFT), gravity=(0.0, 0.0, -2.0)) | {"name": "magnets"}
    return out | {"forces": forces * magnets}


MODEL, BARE = model_of(robot()), model_of(robot(magnets=False))


def state(model=MODEL):
    q, v = 0.01 * np.cos(np.arange(model.nq)), 0.6 * np.cos(np.arange(model.nv))
    q[:3] = 0.4, 0.5, -0.9
    return q, v, np.array([0.4, -0.3, 0.2]), np.zeros((model.n_links, 6))


def energy_of(q):
    """The magnets' energy in the poses of markers, in the inertial frame; casadi.SX."""
    R, r = BARE.casadi()["marker_pose"](q, BARE.parameter_values)
    at = {name: (R[:, 3 * k], r[:, k]) for k, name in enumerate(BARE.marker_names)}
    at["world"], total = (ca.DM([1, 0, 0]), ca.DM(HALL)), 0
    for a, b, first, second in PAIRS.values():
        (x, p), (y, s) = at[a], at[b]
        way = s - p
        long = ca.norm_2(way)
        total += K * first * second * (ca.dot(x, y) / long**3 - 3 * ca.dot(x, way) * ca.dot(y, way) / long**5)
    return total


@pytest.fixture(scope="module")
def judged():
    """The same motion as with the gradient of the energy among the generalised forces of an arm without magnets."""
    q, v, tau, w_ext = state()
    x = ca.SX.sym("q", BARE.nq)
    pull = ca.Function("pull", [x], [-ca.gradient(energy_of(x), x)])(q).full().ravel()
    force = pull - BARE.numpy().bias(q, v, np.zeros((BARE.n_links, 6)))
    force[:3] += tau
    assert np.abs(pull).max() > 0.5
    return Outside(MODEL, (q, v, tau, w_ext), np.linalg.solve(BARE.numpy().mass_matrix(q), force))


@every_check
def test_they_pull_and_turn_as_their_energy_says(judged, check):
    judged.holds(check)


def test_energies_distances_and_numbers():
    q, v, tau, w_ext = state()
    x = ca.SX.sym("q", BARE.nq)
    stored = float(ca.Function("stored", [x], [energy_of(x)])(q))
    assert MODEL.numpy().energy(q, v)[1] - BARE.numpy().energy(q, v)[1] == pytest.approx(stored, rel=1e-11)
    assert MODEL.force_quantities == {"inside.distance": "m", "outside.distance": "m"}
    r = dict(zip(MODEL.marker_names, MODEL.numpy().marker_pose(q)[1], strict=True))
    far = np.linalg.norm(r["fore.tip"] - HALL)
    assert MODEL.numpy().force_quantities(q, v)[1] == pytest.approx(far, rel=1e-12)
    none, compiled = {"inside.first": 0.0, "outside.second": 0.0}, quick(MODEL)
    compiled.prepare(none)
    expected = BARE.numpy().forward_dynamics(q, v, tau, np.zeros((BARE.n_links, 6)))[0]
    assert relative(compiled.forward_dynamics(q, v, tau, w_ext)[0], expected) < 1e-11
    with pytest.raises(ScrewgenError):
        compiled.prepare({"inside.first": np.nan})


def test_a_run_keeps_its_energy_to_the_order_of_its_steps():
    """Half the step, a sixteenth of the error."""
    q, v, *_ = state()
    lost = []
    for h in (1e-4, 5e-5):
        run = simulate(MODEL, 0.05, h, q0=q, v0=v, integrator="rk4")
        lost.append(np.ptp(run.energy.sum(axis=1)))
    assert lost[0] < 1e-3 and lost[0] / lost[1] > 15


def test_a_mock_up_unit_has_them():
    unit = Unit("fmu2", "me", robot)
    q, v, tau, w_ext = state()
    unit.ready(**dict(zip(unit.states, [*q, *v], strict=True)))
    unit.set(dict(zip(unit.inputs, [*tau, *w_ext.ravel()], strict=True)))
    vdot = MODEL.numpy().forward_dynamics(q, v, tau, w_ext)[0]
    assert relative(unit.get([f"der({name})" for name in MODEL.v_names]), vdot) < 1e-11
    expected = MODEL.numpy().force_quantities(q, v)
    assert relative(unit.get(["inside.distance", "outside.distance"]), expected) < 1e-12


def test_a_file_cannot_state_one_and_bad_numbers_are_refused():
    given = robot(magnets=False)
    with pytest.raises(RobotFileError, match=r"forces\[0\]\.dipole: is an unknown key; known here: name, between"):
        Robot(**given | {"forces": [{"name": "m", "between": ["upper.eye", "fore.tip"], "dipole": {"first": 1.0}}]})
    with pytest.raises(RobotFileError, match=r"first: is .*inf; it must be"):
        Force(name="m", between=("upper.eye", "fore.tip"), law=Dipole(np.inf, 1.0))
    with pytest.raises(UsageError, match=r"forces\[0\]: law is an object made in Python; a robot file"):
        dump(MODEL.robot)
