"""The CasADi functions: the contract's names and shapes, what users do with them, and the integrators."""

import os
import subprocess

import casadi as ca
import mpmath
import numpy as np
import pytest
from conftest import require_tool
from helpers import arm, example, flat, link, model_of, relative

from screwgen import Robot, UsageError, derive
from screwgen.algorithms.functions import Functions
from screwgen.backends.casadi.expressions import functions
from screwgen.integrators import METHODS
from screwgen.simulation.simulate import stepper
from screwgen.studies.stiffness import stiffness

ELLA = {"nq": 9, "m": 3, "n": 2}
SIX = {"nq": 15, "m": 6, "n": 6}
NAMES = {
    "forward_dynamics": (["q", "v", "tau", "w_ext", "p"], ["vdot", "wrench"]),
    "inverse_dynamics": (["q", "v", "vdot", "w_ext", "p"], ["force"]),
    "mass_matrix": (["q", "p"], ["M"]),
    "bias": (["q", "v", "w_ext", "p"], ["h"]),
    "energy": (["q", "v", "p"], ["kinetic", "potential"]),
    "tip_pose": (["q", "p"], ["R", "position"]),
    "link_pose": (["q", "p"], ["R", "position"]),
    "assemble": (["x", "tau", "w_ext", "p"], ["M_sys", "H_sys", "W_sys"]),
}


def arguments(model, seed=0) -> dict[str, np.ndarray]:
    """A value of every input, small deflections."""
    rng, nq, n = np.random.default_rng(seed), model.nq, model.n_links
    modal = np.ones(nq)
    modal[model.n_joints :] = 0.01
    given = {"q": rng.normal(size=nq) * modal, "v": rng.normal(size=nq) * modal, "vdot": rng.normal(size=nq)}
    given |= {"tau": rng.normal(size=model.n_joints), "w_ext": rng.normal(size=(6, n))}
    p = np.array(model.parameter_values)
    return given | {"p": p, "x": flat(model.casadi()["dae_state"](given["q"], given["v"], p))}


def called(function: ca.Function, given: dict) -> list[np.ndarray]:
    return [
        np.array(y.full() if isinstance(y, ca.DM) else y)
        for y in function.call([ca.DM(given[n]) for n in function.name_in()])
    ]


# -------- what optimal control asks for


@pytest.mark.parametrize("method", METHODS)
def test_steps_are_those_of_the_simulation(method):
    """The same lines of code on symbols; `step` itself is that of the default."""
    model, given = example("ella"), arguments(example("ella"))
    plant, functions = stepper(model, method), model.casadi()
    q, v, tau, w_ext, p = (given[name] for name in ("q", "v", "tau", "w_ext", "p"))
    expected = plant.step(plant.initial(q, v), tau, w_ext.T, 1e-5)
    f = functions[f"step_{method}"]
    assert f.name_in() == ["q", "v", "tau", "w_ext", "p", "dt"] and f.name_out() == ["q_next", "v_next"]
    assert all(np.array_equal(flat(a), b) for a, b in zip(f(q, v, tau, w_ext, p, 1e-5), expected, strict=True))
    if method == "modal_midpoint":
        assert np.array_equal(flat(functions["step"](q, v, tau, w_ext, p, 1e-5)[0]), expected.q)
        assert np.isfinite(np.array(f.jacobian()(q, v, tau, w_ext, p, 1e-5, *f(q, v, tau, w_ext, p, 1e-5))[0])).all()


@pytest.mark.parametrize("spring", [0.0, 3.0], ids=["free", "sprung"])
def test_one_rigid_link_has_steps_and_sizes(spring):
    """Without modes: nothing but a spring is implicit, and one coordinate is no row of none."""
    joint = {"axes": ["y"]} | ({"stiffness": [spring]} if spring else {})
    link = {"name": "bar", "length": 1.0, "section": {"rhoA": 1.0}, "joint": joint}
    model = model_of({"name": "one", "gravity": [0.0, 0.0, -9.81], "links": [link]})
    assert [x.shape for x in model.casadi()["scaling"](model.parameter_values)] == [(1, 1)] * 3
    q, v = model.casadi()["step"](0.1, 0.2, 0.3, np.zeros((6, 1)), model.parameter_values, 1e-4)
    (vdot,), _ = model.numpy().forward_dynamics([0.1], [0.2], [0.3], None)
    assert float(v) == pytest.approx(0.2 + 1e-4 * vdot, abs=1e-7) and float(q) == pytest.approx(0.1 + 2e-5, abs=1e-6)


def test_scaling_has_a_size_for_each_coordinate_of_an_arm_without_modes():
    """Where the one coordinate with a force of its own is that of a joint with stops."""
    stops = {"limits": [{"lower": -0.1, "upper": 0.15, "stiffness": 90.0, "damping": 3.0}]}
    model = model_of(arm(link(joint=stops)))
    sizes = model.casadi()["scaling"](model.parameter_values)
    assert [x.full().ravel().tolist() for x in sizes] == [[1.0], [1.0], [pytest.approx(1 / 3)]]


def test_scaling_makes_energies_alike():
    """A mode at its size holds the energy E, a joint or mode at its rate has it; torques do 2 E over a radian."""
    model = example("ella")
    q, v, tau = map(flat, model.casadi()["scaling"](model.parameter_values))
    M, k = model.numpy().mass_matrix(np.zeros(model.nq)), stiffness(model)
    energy = max(np.diag(M)[:3]) / 2
    assert np.allclose(np.diag(M) * v**2 / 2, energy, rtol=1e-9) and np.allclose(tau, 2 * energy, rtol=1e-9)
    assert (q[:3] == 1).all() and np.allclose((k * q**2 / 2)[3:], energy, rtol=1e-9)


def test_directions_can_be_left_out():
    """As if the file did not state them; a name that is no direction is refused."""
    model = example("ella")
    bending = derive(model.robot.without("axial"))
    assert bending.nq == 7 and not any("axial" in name for name in bending.q_names) and model.nq == 9
    links = [x.model_copy(update={"modes": x.modes.model_copy(update={"axial": 0})}) for x in model.robot.links]
    assert bending.robot == Robot(**dict(model.robot) | {"links": tuple(links)})
    with pytest.raises(UsageError, match="no direction 'bending'; choose axial or bending_y"):
        model.robot.without("bending")
    measured = {"bending_y": [20.0], "torsion": [300.0]}
    rod = link("rod", modes={"bending_y": 1, "torsion": 1, "frequencies": measured, "basis": "clamped_free"})
    for name in ("EIy", "EIz", "EA", "GJ"):
        del rod["section"][name]
    assert Robot.model_validate(arm(rod)).without("torsion").links[0].modes.frequencies.stated == {"bending_y": (20.0,)}


# -------- names and shapes


@pytest.mark.parametrize(("name", "size"), [("ella", ELLA), ("six_link", SIX)])
def test_names_and_shapes_are_the_contracts(name, size):
    model = example(name)
    functions, nq, m, n = model.casadi(), size["nq"], size["m"], size["n"]
    np_, r = len(model.parameter_values), nq - m
    nx, nz = 13 * n + 2 * r + m, 12 * n + r
    shapes = {"q": (nq, 1), "v": (nq, 1), "vdot": (nq, 1), "tau": (m, 1), "w_ext": (6, n), "p": (np_, 1), "x": (nx, 1)}
    results = {
        "vdot": (nq, 1),
        "wrench": (6, n),
        "force": (nq, 1),
        "M": (nq, nq),
        "h": (nq, 1),
        "kinetic": (1, 1),
        "potential": (1, 1),
        "M_sys": (nz, nz),
        "H_sys": (nz, 1),
        "W_sys": (nz, 1),
    }
    for key, (inputs, outputs) in NAMES.items():
        f = functions[key]
        assert isinstance(f, ca.Function) and f.name() == key
        assert (f.name_in(), f.name_out()) == (inputs, outputs)
        assert [f.size_in(i) for i in range(f.n_in())] == [shapes[i] for i in inputs]
        if "pose" not in key:
            assert [f.size_out(i) for i in range(f.n_out())] == [results[o] for o in outputs]
    assert functions["tip_pose"].size_out("R") == (3, 3) and functions["tip_pose"].size_out("position") == (3, 1)
    assert functions["link_pose"].size_out("R") == (3, 3 * n) and functions["link_pose"].size_out("position") == (3, n)
    ode, dae = functions["ode"], functions["dae"]
    assert {"x", "u", "p", "ode"} == set(ode) and {"x", "z", "u", "p", "ode", "alg"} == set(dae)
    assert [ode[k].numel() for k in ("x", "u", "p", "ode")] == [2 * nq, m + 6 * n, np_, 2 * nq]
    assert [dae[k].numel() for k in ("x", "z", "u", "p", "ode", "alg")] == [nx, nz, m + 6 * n, np_, nx, nz]
    assert len(model.dae_names["x"]) == nx and len(model.dae_names["z"]) == nz


# -------- what users do


def test_casadis_own_c_gives_the_same(tmp_path):
    """Function.generate, compiled by gcc, loaded as an external: equal to rounding."""
    model, here = example("ella"), os.getcwd()
    f, given = model.casadi()["forward_dynamics"], arguments(model)
    os.chdir(tmp_path)
    try:
        f.generate("ella_casadi.c")
    finally:
        os.chdir(here)
    library = tmp_path / "ella_casadi.so"
    subprocess.run(
        [require_tool("gcc"), "-O1", "-shared", "-fPIC", str(tmp_path / "ella_casadi.c"), "-o", str(library), "-lm"],
        check=True,
    )
    for a, b in zip(called(ca.external("forward_dynamics", str(library)), given), called(f, given), strict=True):
        assert relative(a, b) <= 1e-12


def test_assembled_matrix_is_sparse():
    """Blocks only between neighbours, (67) and (100): nonzeros grow as the number of links."""
    count = [
        model_of(arm(*(link(f"l{i}", 0.4, "y", modes={"bending_z": 1}) for i in range(n))))
        .casadi()["assemble"]
        .nnz_out(0)
        for n in (2, 3, 4)
    ]
    assert count[2] - count[1] == count[1] - count[0] < 250
    ella = example("ella").casadi()["assemble"].sparsity_out(0)
    assert ella.nnz() < 0.5 * ella.numel()


# -------- integrators

START = np.array([0.3, -0.2, 0.5, 0, 0.005, 0.003, 0, 0.002, -0.004])


def test_idas_and_cvodes_integrate_alike():
    """0.2 s of ELLA: the DAE by IDAS (which does not project) and the ODE by CVODES reach one state, one wrench."""
    model = example("ella")
    functions, p, u = model.casadi(), model.parameter_values, np.zeros(15)
    options = {"abstol": 1e-8, "reltol": 1e-8, "max_num_steps": 200000}
    x0 = functions["dae_state"](START, np.zeros(9), p)
    M, H, W = functions["assemble"](x0, np.zeros(3), np.zeros((6, 2)), p)
    dae = ca.integrator("dae", "idas", functions["dae"], 0, 0.2, options)(x0=x0, z0=ca.solve(M, W - H), p=p, u=u)
    tight = options | {"abstol": 1e-10, "reltol": 1e-10}
    ode = ca.integrator("ode", "cvodes", functions["ode"], 0, 0.2, tight)(x0=np.r_[START, np.zeros(9)], p=p, u=u)
    q, v = np.split(flat(ode["xf"]), 2)
    assert np.abs(q - START).max() > 0.05
    assert np.allclose(flat(dae["xf"]), flat(functions["dae_state"](q, v, p)), rtol=0, atol=1e-5)
    wrench = flat(functions["forward_dynamics"](q, v, np.zeros(3), np.zeros((6, 2)), p)[1])
    assert relative(flat(dae["zf"])[:6], wrench[:6]) < 1e-3


# -------- the Stumpff primitive


def stumpff(order: int, x, derivative=0):
    """The series at fifty digits; derivatives term by term."""
    with mpmath.workdps(50):
        x = mpmath.mpf(x)
        terms = (
            (-1) ** j * mpmath.ff(j, derivative) * x ** (j - derivative) / mpmath.factorial(order + 2 * j)
            for j in range(derivative, 60)
        )
        return float(mpmath.fsum(terms))


POINTS = [0.0, 1e-300, 1e-16, 1e-8, 1e-3, 0.2499, 0.25, 1.0, 3.9, np.nextafter(4, 0), 4.0, np.nextafter(4, 5), 4.1, 9.0]


@pytest.mark.parametrize("order", [4, 5])
@pytest.mark.parametrize("x", POINTS)
def test_stumpff_value_and_derivatives(order, x):
    """Regular at zero and across the switch from series to closed form at x = 4, in value and two derivatives.

    Just above the switch the closed form's leading term 1/(6x) is 5 times c5, and its derivatives are 50 and 1000 times
    those of c5: they cancel, so rounding grows by these factors.
    """
    s = ca.SX.sym("s")
    y = functions(f"c{order}", s)
    f = ca.Function("f", [s], [y, ca.jacobian(y, s), ca.jacobian(ca.jacobian(y, s), s)])
    for derivative, found in enumerate(f(x)):
        assert np.isclose(float(found), stumpff(order, x, derivative), rtol=(2e-14, 2e-13, 4e-12)[derivative], atol=0)


def test_derivatives_are_finite_at_rest():
    """eta = 0 exactly: first and second derivatives of the accelerations exist and match a neighbouring state."""
    model = example("ella")
    f, p = model.casadi()["forward_dynamics"], model.parameter_values
    q, v, tau, w = ca.SX.sym("q", 9), ca.SX.sym("v", 9), np.zeros(3), np.zeros((6, 2))
    total = ca.sum1(f(q, v, tau, w, p)[0])
    hessian = ca.Function("hessian", [q, v], [ca.hessian(total, ca.vertcat(q, v))[0], ca.gradient(total, q)])
    at = lambda eta: [x.full() for x in hessian([0.3, 0.2, 0.1, *[eta] * 6], 0.1 * np.ones(9))]  # noqa: E731
    for rest, near in zip(at(0.0), at(1e-9), strict=True):
        assert np.all(np.isfinite(rest)) and relative(rest, near) < 1e-6


@pytest.mark.parametrize("torques", [[2.0], [1.0, 2.0], np.ones(5), ca.SX.sym("tau")], ids=["1", "2", "5", "symbol"])
def test_torques_of_a_wrong_number_are_refused(torques):
    """CasADi by itself lets one drive all joints; the functions of an algebra take what they are given."""
    model = example("ella")
    x, f = arguments(model), model.casadi()
    given, count = {**x, "tau": torques}, ca.SX(torques).numel()
    for call in (
        lambda: f["forward_dynamics"](*(given[k] for k in ("q", "v", "tau", "w_ext", "p"))),
        lambda: f["drive_power"](**{k: given[k] for k in ("q", "v", "tau", "p")}),
        lambda: f["step"].call([*(given[k] for k in ("q", "v", "tau", "w_ext", "p")), 1e-3]),
        lambda: Functions(model.chain, [], [], None).of_links([0.0] * count),
    ):
        with pytest.raises(UsageError, match=f"^tau has {count} numbers?; it must have 3"):
            call()


def test_a_zero_stands_for_zeros_and_columns_for_calls():
    model = example("ella")
    x, f = arguments(model), model.casadi()["forward_dynamics"]
    zero = f(x["q"], x["v"], 0, ca.SX(0), x["p"])[0]
    assert flat(ca.DM(zero)) == pytest.approx(flat(f(x["q"], x["v"], np.zeros(3), np.zeros((6, 2)), x["p"])[0]))
    many = f(*(np.hstack([np.reshape(x[k], (f.size1_in(k), -1))] * 2) for k in f.name_in()))[0]
    assert many.shape == (model.nv, 2)
