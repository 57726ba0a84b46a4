"""What the generated C and its judge refuse: non-finite numbers, bad arguments, singular postures.

On anything but OK the state is as it was, bit for bit.
"""

import ctypes
import subprocess
from functools import cache

import numpy as np
import pytest
from conftest import require_tool
from helpers import arm, example, link, model_of, quick, unfolded

from screwgen.backends.c.project import CProject
from screwgen.errors import ScrewgenError, SingularError
from screwgen.integrators import METHODS

OK, NONFINITE, SINGULAR, BAD_ARGUMENT = range(4)
NAN, INF = float("nan"), float("inf")
LAYOUTS = ("fused", "modular")
FORMS = ("joint", "dae")


@cache
def ella(layout: str):
    return quick(example("ella"), layout=layout)


def step(compiled, form: str, method: str, q, v, tau, w_ext, dt=1e-4) -> tuple[int, bool]:
    """Status of one step, and whether it left the state's bits alone."""
    number, dt = list(METHODS).index(method), ctypes.c_double(dt)
    compiled.tau[:], compiled.w_ext[:] = tau, w_ext
    if form == "joint":
        compiled.q[:], compiled.v[:], call = q, v, compiled.library.shim_step
    else:
        compiled.x, call = np.asarray(q), compiled.library.shim_dae_step
    state = lambda: [x.tobytes() for x in ((compiled.q, compiled.v) if form == "joint" else (compiled.x,))]  # noqa: E731
    before = state()
    status = call(compiled.memory, number, 1, dt)
    return status, state() == before


def start(compiled, form: str) -> tuple:
    """A regular state of ELLA and its inputs; the DAE form has all of its state in the first array."""
    rng = np.random.default_rng(0)
    q, v = 0.01 * rng.normal(size=9), 0.1 * rng.normal(size=9)
    first = q if form == "joint" else compiled.dae_state(q, v)
    return first, v, rng.normal(size=3), rng.normal(size=(2, 6))


every_step = pytest.mark.parametrize("method", METHODS)
every_form = pytest.mark.parametrize("form", FORMS)
every_layout = pytest.mark.parametrize("layout", LAYOUTS)


# -------- non-finite input, bad steps


@every_layout
@every_form
@every_step
def test_regular_steps_are_taken(method, form, layout):
    assert step(ella(layout), form, method, *start(ella(layout), form)) == (OK, False)


@every_layout
@every_form
@pytest.mark.parametrize("bad", [NAN, INF, -INF])
def test_non_finite_input_is_refused(form, layout, bad):
    """Every single entry of state and input in turn, by every integrator."""
    c, model = ella(layout), example("ella")
    x, v, tau, w_ext = start(c, form)
    names = [model.q_names if form == "joint" else model.dae_names["x"], model.v_names, model.tau_names, range(12)]
    taken = set()
    for method in METHODS:
        for which in range(4) if form == "joint" else (0, 2, 3):
            for k, name in enumerate(names[which]):
                given = [x.copy(), v.copy(), tau.copy(), w_ext.copy()]
                given[which].flat[k] = bad
                if step(c, form, method, *given) != (NONFINITE, True):
                    taken.add((method, name))
    assert not taken


@every_layout
@every_form
@every_step
@pytest.mark.parametrize("dt", [0.0, -0.0, -1e-3, NAN, INF, -INF, 5e-324, 1e-310])
def test_bad_steps_are_refused(method, form, layout, dt):
    assert step(ella(layout), form, method, *start(ella(layout), form), dt=dt) == (BAD_ARGUMENT, True)


@every_form
@every_step
def test_results_that_overflow_are_refused(method, form):
    """Finite input, infinite result: a status, and the state as it was."""
    q, v, tau, w_ext = start(ella("fused"), form)
    for given in ((q, v, 1e308 * np.ones(3), w_ext), (q, v, tau, 1e308 * np.ones((2, 6)))):
        status, untouched = step(ella("fused"), form, method, *given, dt=1e3)
        assert status in (NONFINITE, SINGULAR) and untouched


@every_layout
@pytest.mark.parametrize("bad", [NAN, INF])
def test_forward_dynamics_refuses_non_finite_input(layout, bad):
    c = ella(layout)
    state = start(c, "joint")
    for form in FORMS:
        for which in range(4):
            given = [x.copy() for x in state]
            given[which].flat[-1] = bad
            with pytest.raises(ScrewgenError, match="non-finite"):
                c.forward_dynamics(*given, form=form)


def test_bad_parameters_are_refused():
    """Not a number: NONFINITE; a mass or length that is not positive: BAD_ARGUMENT. Good ones are then taken again."""
    c, model = quick(example("ella")), example("ella")
    expected = c.forward_dynamics(*start(c, "joint"))[0]
    for name, value, message in (
        ("forearm.rhoA", NAN, "not finite"),
        ("gravity[1]", INF, "not finite"),
        ("upper_arm.length", 0.0, "must be > 0"),
        ("forearm.rhoA", -1.0, "must be > 0"),
    ):
        p = list(model.parameter_values)
        p[model.parameter_names.index(name)] = value
        with pytest.raises(ScrewgenError, match=message):
            c.prepare(p)
    c.prepare(None)
    assert np.array_equal(c.forward_dynamics(*start(c, "joint"))[0], expected)


# -------- singular postures


def bare(table: dict) -> dict:
    """A link without spin inertia."""
    del table["section"]["rhoIp"]
    return table


SOFT = {"EIy": 30.0, "EIz": 50.0}
SINGULAR_ARMS = {
    # three axes x, z, x in line at q = 0: in the joint's own rows
    "spherical": (arm(link("base", axes="z"), link("wrist", axes="xzx"), link("hand", axes="y")), "wrist", np.zeros(5)),
    # a rod that turns about its own axis
    "roll": (arm(link("base", axes="z"), bare(link("rod", axes="x"))), "rod", np.array([0.4, 0.7])),
    # a bent rod whose shapes in y and z are the same still has no inertia about its chord
    "bent roll": (
        arm(link("base", axes="z"), bare(link("rod", axes="x", modes={"bending_y": 1, "bending_z": 1}, section=SOFT))),
        "rod", np.array([0.4, 0.7, 0.02, -0.03]),
    ),
    # the universal arm at q2 = 90 degrees, all that follows in line
    "universal": (
        arm(bare(link("first", axes="yz")), bare(link("second", axes="z"))),
        "first", np.array([0.3, np.pi / 2, 0.0]),
    ),
}  # fmt: skip


ALWAYS_SINGULAR = ("roll", "bent roll")
"""Arms that no posture makes regular: no C is written for them."""


@pytest.mark.parametrize("name", SINGULAR_ARMS)
def test_singular_postures_are_named_by_the_judge(name):
    """What is singular in every posture is said so, by evaluation as by generation."""
    robot, culprit, q = SINGULAR_ARMS[name]
    model = model_of(robot)
    said = "nothing resists the joint of" if name in ALWAYS_SINGULAR else "is singular in this posture"
    with pytest.raises(SingularError, match=f"^(?=.*link '{culprit}').*{said}"):
        model.numpy().forward_dynamics(q, 0 * q, np.ones(model.n_joints), None)
    with pytest.raises(SingularError, match=f"'{culprit}'"):
        model.numpy().dae_forward_dynamics(q, 0 * q, np.ones(model.n_joints), None)


@every_layout
@pytest.mark.parametrize("name", ALWAYS_SINGULAR)
def test_an_arm_that_is_always_singular_is_refused(name, layout):
    """One line names the link and the remedy; nothing is generated that could never run."""
    robot, culprit, _ = SINGULAR_ARMS[name]
    with pytest.raises(SingularError, match=f"nothing resists the joint of link '{culprit}'; give"):
        model_of(robot).c_files(layout=layout)


@every_layout
@pytest.mark.parametrize("name", sorted(set(SINGULAR_ARMS) - set(ALWAYS_SINGULAR)))
def test_singular_postures_are_named_in_c(name, layout):
    """Every integrator of both forms: SINGULAR, the link in work->fault, the state untouched."""
    robot, culprit, q = SINGULAR_ARMS[name]
    model = model_of(robot)
    c = quick(model, layout=layout)
    tau, w_ext = np.ones(model.n_joints), np.zeros((model.n_links, 6))
    for form in FORMS:
        with pytest.raises(SingularError, match=f"'{culprit}'"):
            c.forward_dynamics(q, 0 * q, tau, w_ext, form)
    for method in METHODS:
        assert step(c, "joint", method, q, 0 * q, tau, w_ext) == (SINGULAR, True), method
        x = model.numpy().dae_state(q, 0 * q)
        assert step(c, "dae", method, x, 0 * q, tau, w_ext) == (SINGULAR, True), method
        assert model.robot.links[c.library.shim_fault(c.memory)].name == culprit


def test_near_a_singular_posture_the_numbers_are_finite():
    """The guard refuses what rounding would decide, not what is merely steep."""
    robot, _, _ = SINGULAR_ARMS["spherical"]
    model = model_of(robot)
    c = quick(model)
    for angle in (1e-3, 1e-2, 0.1):
        q = np.array([0.0, 0.2, angle, 0.1, 0.0])
        vdot, _ = c.forward_dynamics(q, 0 * q, np.ones(5), np.zeros((3, 6)))
        judge, _ = model.numpy().forward_dynamics(q, 0 * q, np.ones(5), np.zeros((3, 6)))
        assert np.allclose(vdot, judge, rtol=1e-8)


# -------- results that are not finite, inputs that no result shows


PROGRAM = """
#include <math.h>
#include <stdio.h>
#include "arm_estimator.h"

static arm_parameters p;
static arm_constants c;
static arm_state x, y, deviation;
static arm_input u;
static arm_chain chain;
static arm_dae_work work;
static arm_dae_state dae;
static arm_estimator e;
static arm_real vdot[ARM_NV], force[ARM_NV], wrench[ARM_NLINKS][6], M[ARM_NV][ARM_LENGTH(ARM_NV)];

int main(void)
{
    arm_parameters_default(&p);
    printf("%d", arm_prepare(&p, &c));
    x.q[0] = (arm_real)NAN;
    printf(" %d", arm_mass_matrix(&c, &x, &chain, M));
    x.q[0] = 0.3;
    u.w_ext[0][3] = 1.5e308;
    u.w_ext[1][3] = 1.5e308;
    u.w_ext[0][0] = -1.5e308;
    printf(" %d", arm_inverse_dynamics(&c, &x, &u, vdot, &chain, force, wrench));
    x.q[ARM_NTAU] = 1e155;
    printf(" %d", arm_dae_from_state(&c, &x, &work, &dae));
    deviation.q[0] = 1e200;
    printf(" %d", arm_estimator_init(&p, &y, &deviation, &e));
    e.state.q[0] = 0.25;
    e.state.v[0] = 0.5;
    printf(" %d", arm_estimator_init(&p, &e.state, &e.state, &e));
    printf(" %g %g %g\\n", e.state.q[0], e.P[0][0], e.P[ARM_NQ][ARM_NQ]);
    return 0;
}
"""


@every_layout
def test_what_is_not_finite_has_a_status(tmp_path, layout):
    """Mass matrix of NaN, an infinite wrench, poses that overflow, an infinite covariance; aliasing is harmless."""
    flexible = link("b", 0.5, "z", rhoA=0.1, modes={"bending_y": 1}, section={"EIz": 5.0})
    model = model_of(arm(link("a", 4.0, "z"), flexible, link("c", 0.1, []), gravity=(0, 0, 0)))
    texts = CProject(model.chain, "x", "runtime", layout, estimator=True).files() | {"main.c": PROGRAM}
    sources = ["main.c", *unfolded(tmp_path, texts)]
    subprocess.run([require_tool("gcc"), "-std=c99", "-o", "arm", *sources, "-lm"], cwd=tmp_path, check=True)
    said = subprocess.run([tmp_path / "arm"], capture_output=True, text=True, check=True).stdout.split()
    statuses, left = list(map(int, said[:6])), said[6:]
    assert statuses == [OK, NONFINITE, NONFINITE, NONFINITE, NONFINITE, OK]
    assert left == ["0.25", "0.0625", "0.25"]
