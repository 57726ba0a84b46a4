"""Derivatives of vdot with q, v and tau: against CasADi's jacobian, and in C."""

import ctypes
from contextlib import nullcontext
from functools import cache

import casadi as ca
import mpmath
import numpy as np
import pytest
from helpers import EPS, EPS32, G, arm, equal_links, example, flat, link, model_of, quick, relative
from step_judges import point

from screwgen import SingularError
from screwgen.backends.c.project import CProject
from screwgen.backends.numpy.python import NAMESPACE
from screwgen.errors import ScrewgenError, TargetWarning
from screwgen.ir.derivative import columns, tangents
from screwgen.ir.program import Program, Tracer
from screwgen.ir.replay import run

SOFT = {"EA": 5e3, "EIy": 30.0, "EIz": 50.0, "GJ": 20.0}
TIP = [{"at": "tip", "mass": 1.0, "com": [0.1, 0.0, 0.02], "inertia": [0.01, 0.02, 0.02, 0.001, 0.0, 0.0]}]
MIXED = arm(
    link("a", axes=["z", [1, 2, 3]], modes={"bending_y": 2, "torsion": 1}, section=SOFT, frame_at=0.4, bodies=TIP),
    link("b", axes=[], modes={"bending_z": 1}, section=SOFT, joint={"mount": {"xyz": [0.1, 0, 0.2], "rpy": [1, 2, 3]}}),
    link("c", axes="xyx", joint={"stiffness": [1.0, 2.0, 3.0], "damping": [0.1, 0.2, 0.3], "armature": [0.01] * 3}),
    link("d", axes=["y"], modes={"axial": 1, "bending_y": 1, "bending_z": 1}, section=SOFT, bodies=TIP, frame_at=1.0),
)
UNTURNED = arm(
    link("a", axes="yz", modes={"bending_y": 1, "bending_z": 1}, section=SOFT),
    link("b", axes="z", modes={"bending_y": 1, "torsion": 1}, section=SOFT, bodies=TIP),
    section_rotation=False,
)


@cache
def jacobian(model) -> ca.Function:
    f = model.casadi()["forward_dynamics"]
    symbols = [ca.SX.sym(n, *f.size_in(n)) for n in f.name_in()]
    vdot = f.call(symbols)[0]
    return ca.Function("J", symbols, [ca.jacobian(vdot, x) for x in symbols[:3]])


def by_casadi(model, q, v, tau, w_ext):
    J = jacobian(model)
    return [x.full() for x in J(q, v, tau, np.reshape(w_ext, (-1, 6)).T, model.parameter_values)]


@cache
def own(name: str):
    return example("ella") if name == "ella" else model_of({"mixed": MIXED, "unturned": UNTURNED}[name])


def worst(found, expected):
    """The largest error of the three matrices, each relative to its largest entry."""
    return max(relative(a, b) for a, b in zip(found, expected, strict=True))


# -------- against CasADi


@pytest.mark.parametrize("robot", ["mixed", "unturned"])
@pytest.mark.parametrize(("angle", "modal"), [(1.0, 0.02), (1e-9, 1e-12), (1e4, 0.3)], ids=["usual", "tiny", "huge"])
def test_any_size_of_angles_equals_casadi(robot, angle, modal):
    """Huge: tip sections turned beyond two radians, where the Stumpff functions change their form."""
    model = own(robot)
    given = point(model, 7, angle, modal)
    M = model.numpy().mass_matrix(given[0])
    tolerance = max(1e-10, 50 * EPS * np.linalg.cond(M))
    assert worst(model.numpy().derivatives(*given), by_casadi(model, *given)) <= tolerance


def test_at_rest_and_straight():
    """eta = 0 exactly: finite, and that of a neighbouring state."""
    model = own("mixed")
    zero = [np.zeros_like(x) for x in point(model)]
    zero[0][3] = 0.4  # x, y, x is singular at zero
    near = [zero[0] + np.r_[np.zeros(model.n_joints), np.full(model.nq - model.n_joints, 1e-10)], *zero[1:]]
    assert worst(model.numpy().derivatives(*near), model.numpy().derivatives(*zero)) < 1e-6


# -------- the generated C


@pytest.mark.parametrize(("robot", "binding"), [("ella", "runtime"), ("mixed", "baked")])
def test_c_equals_numpy_in_double_and_float(robot, binding):
    model = example("ella") if robot == "ella" else model_of(MIXED)
    given = point(model, 5)
    expected = model.numpy().derivatives(*given)
    condition = np.linalg.cond(model.numpy().mass_matrix(given[0]))
    for single, eps in ((False, EPS), (True, EPS32)):
        c = quick(model, derivatives=True, single=single, parameters=binding)
        vdot, *found = c.linearise(*given)
        assert worst(found, expected) <= max(1e-12 if not single else 1e-4, 50 * eps * condition)
        assert np.array_equal(vdot, c.linearise(*given)[0])
        assert relative(vdot, c.forward_dynamics(*given)[0]) <= max(1e-12 if not single else 1e-4, 50 * eps * condition)


def test_solver_in_loops():
    """More coordinates than the solver writes out; parameters changed at run time."""
    modes = {"bending_y": 3, "bending_z": 3, "axial": 1, "torsion": 2}
    model = model_of(arm(*(link(n, 0.7, "zy", modes=modes, section=SOFT) for n in "ab")))
    assert model.nq > 16
    p = np.array(model.parameter_values) * 1.1
    given = point(model, 2)
    c = quick(model, derivatives=True)
    c.prepare(p)
    assert worst(c.linearise(*given)[1:], model.numpy(p).derivatives(*given)) <= 1e-9


def test_without_joints_or_without_modes():
    for robot in (
        arm(link("a", axes=[], modes={"bending_y": 2})),
        arm(link("a"), link("b", axes="y")),
        arm(link(axes=[])),
    ):
        model = model_of(robot)
        given = point(model)
        found = quick(model, derivatives=True).linearise(*given)[1:]
        for a, b in zip(found, model.numpy().derivatives(*given), strict=True):
            assert a.shape == b.shape and relative(a, b) < 1e-11


def test_statuses():
    """Singular names the link, NaN is non-finite, a null pointer a bad argument."""
    spherical = model_of(arm(link("wrist", axes="xzx", bodies=TIP)))
    c = quick(spherical, derivatives=True)
    with pytest.raises(SingularError, match="wrist"):
        c.linearise(np.zeros(3), np.zeros(3), np.zeros(3), np.zeros((1, 6)))
    with pytest.raises(SingularError, match="wrist"):
        spherical.numpy().derivatives(np.zeros(3), np.zeros(3), np.zeros(3), np.zeros((1, 6)))
    good = [np.array([0.1, 0.5, 0.2]), np.zeros(3), np.zeros(3), np.zeros((1, 6))]
    for number in range(4):
        for value in (np.nan, np.inf):
            bad = [x.copy() for x in good]
            bad[number].flat[0] = value
            with pytest.raises(ScrewgenError, match="non-finite"):
                c.linearise(*bad)
    c.linearise(*good)
    call = c.library[f"{spherical.robot.name}_linearise"]
    buffer = ctypes.create_string_buffer(100_000)
    for missing in range(5):
        assert call(*(None if k == missing else ctypes.byref(buffer) for k in range(5))) == 3


# -------- the folder


def test_the_files_of_make_and_cmake_build_them():
    files = CProject(own("mixed").chain, "0", derivatives=True).files()
    assert "arm_derivatives.c" in files["Makefile"] and "arm_derivatives.c" in files["CMakeLists.txt"]


def test_only_on_request():
    files = CProject(example("ella").chain, "0").files()
    assert not any("derivatives" in name or "derivatives" in text for name, text in files.items())


@pytest.mark.parametrize("layout", ["fused", "auto"])
def test_derivatives_of_a_long_chain(layout):
    """In one piece they say how long they take to compile, which is the user's to spend; by links they do not."""
    model = model_of(equal_links(11))
    said = r"of wrenches in C have \d+ operations, .* about [3-6]\d s at -O2"
    with pytest.warns(TargetWarning, match=said) if layout == "fused" else nullcontext():
        c = quick(model, layout=layout, derivatives=True)
    given = point(model)
    condition = np.linalg.cond(model.numpy().mass_matrix(given[0]))
    assert worst(c.linearise(*given)[1:], model.numpy().derivatives(*given)) <= max(1e-12, 50 * EPS * condition)


def test_fewer_operations_than_casadi():
    """The reason why the C is the tool's own: against the best that CasADi's jacobian of our function makes."""
    model = example("ella")
    q, v, tau, w = ca.SX.sym("q", 9), ca.SX.sym("v", 9), ca.SX.sym("tau", 3), ca.SX.sym("w", 6, 2)
    vdot = model.casadi()["forward_dynamics"](q, v, tau, w, model.parameter_values)[0]
    J = ca.Function("J", [q, v, tau, w], [vdot, *(ca.jacobian(vdot, x) for x in (q, v, tau))])
    own = CProject(model.chain, "0", "baked", derivatives=True).context["derivatives"]
    assert own["operations"] < 8000
    assert 1.4 * (own["operations"] + own["solve"]) < J.n_instructions() - J.nnz_in() - J.nnz_out()


# -------- tangents


def test_tangents_of_every_operation():
    """Against central differences of 40 digits."""
    tracer = Tracer()
    a, b = tracer.input("a", 1)[0], tracer.input("b", 1)[0]
    call = tracer.call
    values = [a + b, a - b, a * b, a * a, a / b, -(a * b), 3.0 / a, call("sqrt", a), call("sin", a * b), call("cos", a)]
    values += [call("c4", a), call("c5", a * b), 2.5]
    slopes = columns(values, [a, b])
    program = Program("f", {"a": 1, "b": 1}, {"f": values, "d": [s for column in slopes for s in column]}, [], [""])
    with mpmath.workdps(40):
        at = lambda x, y: run(program, {"a": [mpmath.mpf(x)], "b": [mpmath.mpf(y)]}, precise())[0]  # noqa: E731
        x, y, h = mpmath.mpf("1.3"), mpmath.mpf("0.7"), mpmath.mpf("1e-12")
        pairs = [(at(x + h, y), at(x - h, y)), (at(x, y + h), at(x, y - h))]
        expected = [(p - m) / (2 * h) for plus, minus in pairs for p, m in zip(plus["f"], minus["f"], strict=True)]
        assert max(abs(d - e) for d, e in zip(at(x, y)["d"], expected, strict=True)) < 1e-15


def precise():
    from screwgen.algorithms.fused import precise

    return precise


def test_a_seed_hides_what_it_was_made_from():
    tracer = Tracer()
    a = tracer.input("a", 1)[0]
    middle = a * a
    assert tangents([middle * a], {middle: 1.0}) == [a]
    assert tangents([a + 1.0, 4.0], {}) == [0.0, 0.0]


@pytest.mark.parametrize("order", [6, 7])
@pytest.mark.parametrize("x", [0.0, 1e-300, 1e-8, 0.2499, 0.25, 1.0, 3.999, 4.0, 9.0, 50.0])
def test_stumpff_of_order_six_and_seven(order, x):
    with mpmath.workdps(40):
        exact = float(mpmath.nsum(lambda j: (-mpmath.mpf(x)) ** int(j) / mpmath.factorial(order + 2 * int(j)), [0, 80]))
    assert np.isclose(NAMESPACE[f"c{order}"](x), exact, rtol=2e-13, atol=0)


def test_physics_of_a_pendulum():
    """One rigid rod, level at q = 0, by hand: I vdot = tau + m g l/2 cos(q)."""
    model = model_of(arm(link("rod", 2.0, "y", rhoA=0.5)))
    q, inertia = 0.3, 0.5 * 2.0**3 / 3
    by_q, by_v, by_tau = model.numpy().derivatives([q], [0.7], [0.0], np.zeros((1, 6)))
    assert np.isclose(by_q.item(), -(0.5 * 2.0 * G * 1.0) * np.sin(q) / inertia, rtol=1e-13)
    assert by_v.item() == 0.0 and np.isclose(by_tau.item(), 1 / inertia, rtol=1e-14)
    assert flat(by_tau).shape == (1,)
