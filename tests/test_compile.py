"""`model.compile`: the C as functions on NumPy arrays."""

import threading
from functools import partial

import numpy as np
import pytest
from conftest import require_tool
from helpers import EPS32, arm, drawn, example, link, model_of, relative
from step_judges import point

import screwgen
from screwgen import ScrewgenError, SingularError, UsageError
from screwgen.runtime import compiled


@pytest.fixture(autouse=True)
def _compiler():
    require_tool("cc")


@pytest.fixture(scope="module")
def ella():
    return example("ella").compile(flags=("-O0",))


state = partial(point, angle=0.1, rate=0.1)


# -------- functions


def test_the_dae_form_is_compiled_when_it_is_first_called(monkeypatch):
    """By any instance, for all of them; what the joint form and simulations need does without it."""
    asked = []
    load = compiled.load
    monkeypatch.setattr(compiled, "load", lambda files, **how: asked.append(sorted(files())) or load(files, **how))
    model = model_of(arm(link("a", modes={"bending_y": 1}), link("b", axes="y")))
    c = model.compile(flags=("-O0",), cache=False)
    q, v, tau, w_ext = state(model)
    other = c.fresh()
    expected = other.forward_dynamics(q, v, tau, w_ext)
    c.step(q, v, tau, w_ext, 1e-6), c.energy(q, v), c.mass_matrix(q), c.kinematics(q), c.gravity(q), c.validity(q, v)
    assert len(asked) == 1 and not {"arm_dae.c", "dae_shim.c"} & set(asked[0])
    found = other.forward_dynamics(q, v, tau, w_ext, form="dae")
    assert relative(found[0], expected[0]) < 1e-10 and relative(found[1], expected[1]) < 1e-10
    c.dae_step(c.dae_state(q, v), tau, w_ext, 1e-6), c.assemble(c.dae_state(q, v), tau, w_ext)
    assert len(asked) == 2 and {"arm_dae.c", "dae_shim.c"} < set(asked[1])


def test_optimised_code_agrees_with_the_oracle_in_both_forms():
    case = drawn(12, 2, max_modes=2)
    c, expected = case.model.compile(flags=("-O2",)), case.oracle.forward_dynamics(*case.inputs)
    for form in ("joint", "dae"):
        for found, wanted in zip(c.forward_dynamics(*case.inputs, form=form), expected, strict=True):
            assert relative(found, wanted) < case.tolerance


def test_a_stepper_keeps_its_arrays_and_steps_as_the_model_does(ella):
    q, v, tau, w_ext = state(ella.model)
    stepper = ella.stepper(1e-5, count=4)
    places = stepper.q, stepper.v, stepper.tau, stepper.w_ext
    for place, value in zip(places, (q, v, tau, w_ext), strict=True):
        place[:] = value
    stepper()
    wanted = ella.step(q, v, tau, w_ext, 1e-5, "modal_midpoint", 4)
    assert np.array_equal(places[0], wanted[0]) and np.array_equal(places[1], wanted[1])
    assert np.array_equal(stepper.kinematics().tip_twist, ella.kinematics(*wanted).tip_twist)
    stepper()
    again = ella.step(*wanted, tau, w_ext, 1e-5, "modal_midpoint", 4)
    assert np.array_equal(stepper.q, again[0])  # neither reading poses nor others' calls disturb it
    stepper.tau[0] = np.nan
    with pytest.raises(ScrewgenError, match="non-finite"):
        stepper()
    assert np.array_equal(stepper.q, again[0])


def test_a_stepper_of_a_floating_base_starts_without_rotation():
    free = model_of(arm(link("body", axes=()), base="floating"))
    stepper = free.compile(flags=("-O0",)).stepper(0.1)
    stepper()
    assert np.allclose(stepper.q[:7], [0, 0, -0.5 * 9.81 * 0.1**2, 1, 0, 0, 0], atol=1e-12)


@pytest.mark.parametrize("count", [0, 1, 3])
def test_steps_take_and_return_what_they_are_given(ella, count):
    q, v, tau, w_ext = state(ella.model)
    kept = [x.copy() for x in (q, v, tau, w_ext)]
    found = ella.step(q.tolist(), v, tau, w_ext.ravel(), 1e-7, "rk4", count)
    wanted = q, v
    for _ in range(count):
        wanted = ella.step(*wanted, tau, w_ext, 1e-7, "rk4")
    assert all(np.array_equal(a, b) for a, b in zip(found, wanted, strict=True))
    assert all(np.array_equal(a, b) for a, b in zip(kept, (q, v, tau, w_ext), strict=True))
    assert not np.shares_memory(found[0], ella.q)


def test_what_fits_is_taken_and_all_else_converted(ella):
    q, v, tau, w_ext = state(ella.model)
    expected = ella.forward_dynamics(q, v, tau, w_ext)
    others = [
        (q.tolist(), tuple(v), tau.tolist(), w_ext.tolist()),
        (np.repeat(q, 2)[::2], v[:, None], tau, np.asfortranarray(w_ext)),
        (q.astype(">f8"), v.astype(object), tau, w_ext.ravel()),
    ]
    for given in others:
        assert all(np.array_equal(a, b) for a, b in zip(ella.forward_dynamics(*given), expected, strict=True))
    rough = ella.forward_dynamics(*(x.astype(np.float32) for x in (q, v, tau, w_ext)))
    assert 0 < relative(rough[0], expected[0]) < 1e3 * EPS32
    alone = ella.forward_dynamics(q, v)
    nothing = ella.forward_dynamics(q, v, 0 * tau, 0 * w_ext)
    assert np.array_equal(alone[0], nothing[0]) and not np.array_equal(alone[0], expected[0])


def test_results_go_where_they_are_wanted(ella):
    given = state(ella.model)
    expected = ella.forward_dynamics(*given)
    out = np.full(ella.model.nq, np.nan), np.full((2, 12), np.nan)[:, ::2]
    found = ella.forward_dynamics(*given, out=out)
    assert found[0] is out[0] and found[1] is out[1]
    assert all(np.array_equal(a, b) for a, b in zip(out, expected, strict=True))
    ella.forward_dynamics(*(2 * x for x in given))
    assert np.array_equal(expected[0], out[0])  # what was returned is the caller's
    assert ella.accelerations(*given, out=out[0]) is out[0] and np.array_equal(out[0], expected[0])
    with pytest.raises(UsageError, match=r"out: wrench has the shape \(12,\); it must be \(2, 6\)"):
        ella.forward_dynamics(*given, out=(out[0], np.zeros(12)))


@pytest.mark.parametrize(("place", "name", "count"), [(0, "q", 9), (1, "v", 9), (2, "tau", 3), (3, "w_ext", 12)])
def test_arrays_of_another_size_are_refused(ella, place, name, count):
    given = list(state(ella.model))
    for bad, message in ((np.zeros(count + 1), f"it must have {count}"), ("text", "not an array of numbers")):
        given[place] = bad
        with pytest.raises(UsageError, match=f"^{name} .*{message}"):
            ella.forward_dynamics(*given)


def test_arms_without_joints_or_modes():
    welded = model_of(arm(link("beam", axes=(), modes={"bending_y": 2}))).compile(flags=("-O0",))
    vdot, wrench = welded.forward_dynamics([0.01, 0.0], [0.0, 0.0])
    assert vdot.shape == (2,) and wrench.shape == (1, 6) and vdot[0] < 0
    rigid = model_of(arm(link("rod", axes=()))).compile(flags=("-O0",))
    vdot, wrench = rigid.forward_dynamics([], [])
    assert vdot.shape == (0,) and wrench[0, 5] == pytest.approx(9.81) and rigid.energy([], []) == (0.0, 0.0)


def test_precisions_and_layouts():
    model = model_of(arm(link("a", modes={"bending_y": 1}), link("b", axes="y")))
    given = state(model)
    expected = model.numpy().forward_dynamics(*given)[0]
    for layout in ("fused", "modular"):
        single = model.compile(layout, "single", flags=("-O0",))
        assert single.forward_dynamics(*given)[0].dtype == np.float32
        assert relative(single.forward_dynamics(*given)[0], expected) < 1e3 * EPS32
        exact = model.compile(layout, derivatives=True, parameters="baked", flags=("-O0",))
        assert relative(exact.linearise(*given)[0], expected) < 1e-12
    for option, message in (
        ({"layout": "best"}, "fused"),
        ({"precision": "half"}, "single"),
        ({"flags": "-O3"}, "sequence"),
    ):
        with pytest.raises(UsageError, match=message):
            model.compile(**option)
    with pytest.raises(UsageError, match="derivatives=True"):
        model.compile("fused", flags=("-O0",)).linearise(*given)


def test_instances_of_one_library_keep_apart(ella):
    """Also in threads: each its own parameters and state."""
    given, heavy = state(ella.model), np.array(ella.model.parameter_values) * 1.5
    others = [ella.fresh(p) for p in (None, heavy)]
    expected = [x.forward_dynamics(*given)[0] for x in others]
    assert not np.allclose(*expected)
    wrong = []

    def work(c, answer):
        for _ in range(2000):
            if not np.array_equal(c.forward_dynamics(*given)[0], answer):
                wrong.append(1)

    threads = [threading.Thread(target=work, args=pair) for pair in zip(others, expected, strict=True)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert not wrong


def test_errors_name_what_is_wrong():
    c = model_of(arm(link("wrist", 0.5, "xzx"))).compile(flags=("-O0",))
    with pytest.raises(SingularError, match="'wrist'"):
        c.forward_dynamics(np.zeros(3), np.zeros(3))
    with pytest.raises(ScrewgenError, match="non-finite"):
        c.forward_dynamics(np.array([0.1, 0.5, np.nan]), np.zeros(3))


# -------- what is refused


def test_arrays_in_another_layout_are_refused_everywhere(ella):
    """(6, n) is CasADi's layout; read as (n, 6) it would be another wrench."""
    model = ella.model
    q, v, tau, w_ext = state(model)
    turned, message = w_ext.T, r"w_ext.* shape \(6, 2\); it must.* \(2, 6\)"
    x = ella.dae_state(q, v)
    calls = (
        lambda: ella.forward_dynamics(q, v, tau, turned),
        lambda: ella.step(q, v, tau, turned, 1e-3),
        lambda: ella.dae_step(x, tau, turned, 1e-3),
        lambda: ella.inverse_dynamics(q, v, v, turned),
        lambda: model.numpy().forward_dynamics(q, v, tau, turned),
        lambda: model.numpy().dae_forward_dynamics(q, v, tau, turned),
        lambda: model.linearise(q, w_ext=turned),
        lambda: screwgen.equilibrium(model, q, w_ext=turned),
        lambda: screwgen.simulate(model, 0.01, 1e-3, w_ext=turned),
    )
    for call in calls:
        with pytest.raises(UsageError, match=message):
            call()
    with pytest.raises(UsageError, match=r"^q has 10 numbers; it must have 9"):
        model.numpy().forward_dynamics([*q, 1.0], v, tau, w_ext)
    for words in (q + 0j, q.astype(str), q > 0):
        with pytest.raises(UsageError, match=r"^q is not an array of numbers"):
            ella.forward_dynamics(words, v)


@pytest.mark.parametrize("count", [2**32 + 1, -5, "3", 2.5, True])
def test_a_number_of_steps_that_is_none_is_refused(ella, count):
    q, v, tau, w_ext = state(ella.model)
    with pytest.raises(UsageError, match=r"^count is .*it must be a whole number from 0 to"):
        ella.step(q, v, tau, w_ext, 1e-4, count=count)
    with pytest.raises(UsageError, match=r"^count is"):
        ella.dae_step(ella.dae_state(q, v), tau, w_ext, 1e-4, count=count)


def test_names_and_times_that_make_no_sense_are_refused(ella):
    q, v, tau, w_ext = state(ella.model)
    with pytest.raises(UsageError, match=r"there is no form 'jiont'; choose joint or dae; did you mean 'joint'\?"):
        ella.forward_dynamics(q, v, form="jiont")
    with pytest.raises(UsageError, match=r"no integrator 'rk5'.*did you mean 'rk4'"):
        ella.step(q, v, tau, w_ext, 1e-4, "rk5")
    for dt in (0.0, -1e-3, np.nan, "1"):
        with pytest.raises(UsageError, match=r"^dt is .*number.*> 0"):
            ella.step(q, v, tau, w_ext, dt)


def test_results_go_into_floats_alone(ella):
    q, v, _, _ = state(ella.model)
    fixed = np.zeros(9)
    fixed.flags.writeable = False
    for bad, message in ((np.zeros(9, int), ": vdot holds int64"), ([0.0] * 9, " cannot"), (fixed, " cannot")):
        with pytest.raises(UsageError, match=rf"^out{message}.*; give (an array|arrays) of float64"):
            ella.accelerations(q, v, out=bad)
    wrench = np.ones((2, 6))
    with pytest.raises(UsageError, match="out: vdot"):
        ella.forward_dynamics(q, v, out=(np.zeros(9, int), wrench))
    assert (wrench == 1).all()


def test_a_refused_preparation_leaves_the_last_one(ella):
    given, c, p = state(ella.model), ella.fresh(), np.array(ella.model.parameter_values)
    expected = c.forward_dynamics(*given)
    p[c.model.parameter_names.index("forearm.rhoA")] = 1e308
    with pytest.raises(ScrewgenError, match="non-finite"):
        c.prepare(p)
    assert all(np.array_equal(a, b) for a, b in zip(c.forward_dynamics(*given), expected, strict=True))


def test_parameters_of_no_robot_are_refused_wherever_they_enter(ella):
    model, bad = ella.model, {"forearm.EIy": -1.0}
    calls = (
        lambda: ella.fresh(bad),
        lambda: ella.prepare(bad),
        lambda: model.numpy(bad),
        lambda: model.linearise([0.0] * 3, parameters=bad),
        lambda: screwgen.equilibrium(model, hold=True, parameters=bad),
        lambda: screwgen.natural_frequencies(model, parameters=bad),
        lambda: screwgen.simulate(model, 0.01, 1e-3, parameters=bad, backend="casadi"),
        lambda: screwgen.rollout(model, np.zeros(18), step=1e-3, steps=1, parameters=bad),
    )
    for call in calls:
        with pytest.raises(UsageError, match=r"^parameters: forearm.EIy is -1; it must be > 0"):
            call()
    body = arm(link("a", bodies=[{"at": "tip", "mass": 1.0, "inertia": [0.1, 0.1, 0.1, 0.0, 0.0, 0.0]}]))
    with pytest.raises(UsageError, match=r"a\.bodies\[0\]\.inertia is an inertia that no body has"):
        model_of(body).numpy({"a.bodies[0].inertia[0]": 1.0})
