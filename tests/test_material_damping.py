"""Kelvin–Voigt damping of links, `damping = { time = … }`: the whole stiffness times a time, at every order."""

import re

import numpy as np
import pytest
from helpers import arm, link, model_of, relative
from test_reduced import arm_of, free_cloud

import screwgen
from screwgen import RobotFileError, simulate
from screwgen.backends.latex import document
from screwgen.integrators import methods
from screwgen.spec import Damping, Link
from screwgen.spec.advice import advice

TIME = 0.02
KINDS = {
    "uniform": {"modes": {"bending_y": 2, "bending_z": 1, "torsion": 1}},
    "stations": {
        "modes": {"bending_y": 3, "axial": 2},
        "section": [{"at": s, "rhoA": 1.0, "EA": 9e2, "EIz": 3.0 - s} for s in (0.0, 0.4, 1.0)],
    },
    "shear": {"modes": {"bending_y": 2, "shear_y": 1}, "section": {"GAy": 40.0, "rhoIz": 1e-3}},
    "measured": {"modes": {"bending_y": 2, "frequencies": {"bending_y": [1.0, 6.3]}}, "section": {"EIz": None}},
}
"""Rods with modes that are and are not coupled."""


def rod(kind: str, order=1, **more) -> dict:
    table = link("rod", 0.8, "z", modes=KINDS[kind]["modes"], **more)
    section = KINDS[kind].get("section", {})
    own = section if isinstance(section, list) else {k: x for k, x in (table["section"] | section).items() if x}
    return arm(table | {"section": own}, order=order)


def matrix(model, name: str, i: int = 0) -> np.ndarray:
    """The stiffness, inertia or damping of the modes of a link."""
    constants, places = model.numpy().constants[i], model.chain.keys[i].coupled
    full = np.diag(constants[name])
    for (row, column), value in zip(places, constants[f"{name[0]}_below"] if places else (), strict=True):
        full[row, column] = full[column, row] = value
    return full


# -------- the matrix


@pytest.mark.parametrize("order", [1, 2, "exact"])
@pytest.mark.parametrize("kind", KINDS)
def test_damping_is_the_stiffness_times_the_time(kind, order):
    model = model_of(rod(kind, order, damping={"time": TIME}))
    D, K = matrix(model, "D"), matrix(model, "K")
    assert relative(D, TIME * K) < 1e-15 and bool(model.chain.keys[0].coupled) == (kind in ("stations", "shear"))
    rates = np.arange(1.0, model.nq)
    q, v, free = np.zeros(model.nq), np.append(0.0, rates), np.zeros((1, 6))
    bare = model_of(rod(kind, order))
    force, without = (m.numpy().inverse_dynamics(q, v, 0 * v, free) for m in (model, bare))
    assert relative((force - without)[1:], TIME * K @ rates) < 1e-9


@pytest.mark.parametrize("kind", KINDS)
def test_ratio_and_time_add(kind):
    both, ratio, time = (
        matrix(model_of(rod(kind, damping=damping)), "D")
        for damping in ({"ratio": 0.03, "time": TIME}, {"ratio": 0.03}, {"time": TIME})
    )
    assert relative(both, ratio + time) < 1e-15 and np.all(np.diag(ratio) > 0)
    assert np.array_equal(ratio, np.diag(np.diag(ratio)))


def test_stated_zero_is_a_parameter_that_can_be_changed():
    model = model_of(rod("stations", damping={"time": 0.0}))
    place, values = model.parameter_names.index("rod.damping.time"), np.array(model.parameter_values)
    values[place] = TIME
    assert np.any(model.numpy(values).constants[0]["D_below"]) and not np.any(matrix(model, "D"))


def test_a_body_from_finite_elements_has_it_too(tmp_path):
    cloud = free_cloud(3)
    plain, damped = (model_of(arm_of(tmp_path, cloud, **more)) for more in ({}, {"damping": {"time": TIME}}))
    assert plain.chain.keys[0].coupled and relative(matrix(damped, "D"), TIME * cloud.stiffness) < 1e-12
    q, v, w = np.array([0.3, -0.2, 0.01, 0.02]), np.array([0.5, 1.0, 0.2, -0.3]), np.zeros((1, 6))
    force, bare = (m.numpy().inverse_dynamics(q, v, v, w) for m in (damped, plain))
    assert np.allclose(force - bare, [0, 0, *(TIME * cloud.stiffness @ v[2:])], atol=1e-10)
    own = type(cloud)(**{**vars(cloud), "damping": np.array([1.0, 2.0])})
    with pytest.raises(ValueError, match="whose file has De; leave one of them out"):
        model_of(arm_of(tmp_path, own, damping={"time": TIME}))


# -------- motion


@pytest.mark.parametrize("order", [1, 2, "exact"])
def test_a_mode_decays_as_the_oscillator_that_it_is(order):
    """Amplitude exp(−time ω² t / 2), frequency ω √(1 − (time ω / 2)²)."""
    table = link("rod", 1.0, [], modes={"basis": "clamped_free", "bending_y": 1}, damping={"time": TIME})
    model = model_of(arm(table, order=order, gravity=(0, 0, 0)))
    omega = 1.8751040687119611**2
    assert np.allclose(2 * np.pi * screwgen.natural_frequencies(model), omega, rtol=1e-9)
    run = simulate(model, 2.0, 1e-3, q0=[1e-6], integrator="rk4")
    decay = TIME * omega**2 / 2
    turning = np.sqrt(omega**2 - decay**2)
    expected = np.exp(-decay * run.t) * (np.cos(turning * run.t) + decay / turning * np.sin(turning * run.t))
    assert np.abs(run.q[:, 0] / 1e-6 - expected).max() < 1e-8


@pytest.mark.parametrize("integrator", ["modal_implicit", "modal_midpoint"])
@pytest.mark.parametrize("backend", ["c", "casadi"])
def test_implicit_steps_take_all_of_the_matrix(integrator, backend):
    """Below the diagonal too: at steps a hundred times those of rk4 they tend to its motion with their order."""
    model = model_of(rod("stations", damping={"time": 0.05}))
    run = lambda h, **how: simulate(model, 0.02, h, q0=[0.0, 0.0, 0.0, 0.02, 0.01, 0.005], **how).q[-1]  # noqa: E731
    exact = run(2e-6, integrator="rk4")
    errors = [relative(run(h, integrator=integrator, backend=backend), exact) for h in (2e-4, 1e-4)]
    assert errors[0] < 5e-3 and abs(np.log2(errors[0] / errors[1]) - methods.METHODS[integrator].order) < 0.1


@pytest.mark.parametrize("segments", [1, 3])
def test_segments_damp_the_modes_of_the_link(segments):
    """The ratio of every vibration of the link is time ω / 2, however it is divided; no advice is given."""
    table = link("rod", 1.0, [], modes={"bending_y": 2}, damping={"time": TIME}, segments=segments)
    model = model_of(arm(table, gravity=(0, 0, 0)))
    roots = np.linalg.eigvals(model.linearise(np.zeros(model.nq)).A)
    omega = 2 * np.pi * screwgen.natural_frequencies(model)
    under = omega[TIME * omega < 2]
    turning = roots[np.abs(roots.imag) > 1e-9]
    assert len(under) >= 2 and len(turning) == 2 * len(under)
    assert np.allclose(np.sort(-turning.real), np.sort(np.repeat(TIME * under**2 / 2, 2)), rtol=1e-8)
    assert not any("damping" in line for line in advice(model.robot))


# -------- files and documents


@pytest.mark.parametrize(
    ("damping", "said"),
    [
        ({}, r"damping: states nothing; state ratio or time, or leave damping out"),
        ({"time": -0.1}, r"damping.time: is -0.1; it must be >= 0"),
        ({"time": "1 s"}, r'damping.time: is "1 s"; it must be a number'),
        ({"tme": 0.1}, r"damping.tme: is an unknown key; did you mean time\?"),
    ],
)
def test_wrong_damping_is_refused_in_a_line(damping, said):
    with pytest.raises(RobotFileError, match=said) as error:
        Link(name="rod", joint={"axes": []}, damping=damping)
    assert "\n" not in str(error.value)


def test_it_is_a_parameter_with_a_unit():
    model = model_of(rod("uniform", damping={"ratio": 0.01, "time": TIME}))
    (own,) = (p for p in screwgen.spec.parameters(model.robot) if p.field == "damping.time")
    assert (own.name, own.unit, own.value) == ("rod.damping.time", "s", TIME)
    assert Damping(time=1.0).terms == ("time",)


def test_documents_have_its_formula():
    text = document.tex(document.content(model_of(rod("stations", damping={"ratio": 0.1, "time": TIME})).robot))
    assert re.search(r"t_\{d,i\}.*\\mathbf\{K\}_i", text) and "damping of the modes over their stiffness" in text
