"""Derivatives by parameters beside JAX's and beside other parameters; what names stand for; the folder of C.

Differences in 40 digits of many robots, in NumPy, CasADi and C: `conformance.slopes.by_parameters`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from conformance.c_warnings import compile_cleanly
from conftest import package
from every_command import DONE, called, checked
from helpers import arm, link, model_of, quick, relative, unfolded

from screwgen import UsageError
from screwgen.integrators import METHODS

jax = package("jax")
SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}
DRIVE = {"friction": {"coulomb": 0.4, "viscous": 0.1, "velocity": 0.01}}
DRIVE["friction"] |= {"stribeck": {"static": 0.6, "velocity": 0.5}, "bend": {"friction": 0.3, "velocity": 0.2}}
ROBOT = arm(
    link("upper", 0.7, ("z", "y"), joint={"drives": [DRIVE, {}]}, damping={"ratio": 0.02}, **SOFT),
    link("fore", 0.5, ("z",), bodies=[{"at": "tip", "mass": 0.4}], **SOFT),
)
MODEL = model_of(ROBOT)
OF = ("gravity[2]", "*.length", "upper.joint.drives*", "fore.bodies[0].mass", "upper.damping.ratio")
Q, V = 0.01 * np.arange(1.0, MODEL.nq + 1), 0.2 * np.cos(np.arange(MODEL.nv))
TAU, W_EXT, P = np.array([0.4, -0.3, 0.2]), np.arange(12.0).reshape(2, 6) / 10, MODEL.parameter_values


def test_names_and_patterns_stand_for_parameters_in_their_order():
    chosen = MODEL.chain.parameters.chosen(OF)
    names = [MODEL.parameter_names[k] for k in chosen]
    assert names[0] == "gravity[2]" and len(names) == 12 and list(chosen) == sorted(chosen)
    with pytest.raises(UsageError, match=r"there is no 'fore.lenght'"):
        MODEL.numpy().energy_by_p(Q, V, of="fore.lenght")
    with pytest.raises(UsageError, match=r"there is no '\*.stiff'"):
        MODEL.casadi(by_p="*.stiff")


GIVEN = {"forward_dynamics": (Q, V, TAU, W_EXT), "energy": (Q, V), "tip_pose": (Q,)}


@pytest.fixture
def double():
    with jax.enable_x64(True):
        yield


@pytest.mark.parametrize("name, given", GIVEN.items(), ids=GIVEN)
def test_those_of_jax_are_those_of_numpy(double, name, given):
    functions, numeric = MODEL.jax(by_p=OF), MODEL.numpy()
    expected = getattr(numeric, f"{name}_by_p")(*given, of=OF)
    for found, wanted in zip(functions[f"{name}_by_p"](*given, P), expected, strict=True):
        assert found.shape == wanted.shape and relative(found, wanted) < 1e-11


def test_a_step_of_every_method_in_jax_and_casadi_has_those_of_numpy(double):
    numeric, by_jax, by_casadi = MODEL.numpy(), MODEL.jax(by_p=OF), MODEL.casadi(by_p=OF)
    for method in ("semi_implicit", "modal_implicit", "rk4"):
        wanted = numeric.step_by_p(Q, V, TAU, W_EXT, 1e-3, OF, method=method)
        others = by_casadi[f"step_{method}_by_p"](Q, V, TAU, W_EXT.T, P, 1e-3)
        for one, other, x in zip(by_jax[f"step_{method}_by_p"](Q, V, TAU, W_EXT, P, 1e-3), others, wanted, strict=True):
            assert relative(one, x) < 1e-10 and relative(other, x) < 1e-10


def test_methods_of_one_name_have_their_own():
    numeric, whole = MODEL.numpy(), METHODS["semi_implicit"]
    other = replace(METHODS["rk4"], name=whole.name)
    found = [numeric.step_by_p(Q, V, TAU, W_EXT, 1e-2, OF, method=method) for method in (whole, other, whole)]
    wanted = numeric.step_by_p(Q, V, TAU, W_EXT, 1e-2, OF, method="rk4")
    assert relative(found[1][0], wanted[0]) < 1e-14 and relative(found[0][0], wanted[0]) > 1e-6
    assert np.array_equal(found[2][0], found[0][0])


@pytest.mark.parametrize("of", ["gravity[2]", OF])
def test_slopes_of_constants_are_made_where_some_depend_on_a_parameter(of):
    c, expected = quick(MODEL, by_p=of), MODEL.numpy().forward_dynamics_by_p(Q, V, TAU, W_EXT, of=of)
    c.prepare(None)
    for found, wanted in zip(c.forward_dynamics_by_p(Q, V, TAU, W_EXT), expected, strict=True):
        assert relative(found, wanted) < 1e-11


def test_compiled_ones_follow_new_parameters_and_are_those_of_a_fresh_model():
    c, other = quick(MODEL, by_p=OF), {"upper.length": 0.8, "fore.bodies[0].mass": 0.7}
    for given in (None, other, None):
        c.prepare(given)
        expected = MODEL.numpy(given).forward_dynamics_by_p(Q, V, TAU, W_EXT, of=OF)
        for found, wanted in zip(c.forward_dynamics_by_p(Q, V, TAU, W_EXT), expected, strict=True):
            assert relative(found, wanted) < 1e-11
    for found, wanted in zip(
        c.fresh(other).energy_by_p(Q, V), MODEL.numpy(other).energy_by_p(Q, V, of=OF), strict=True
    ):
        assert relative(found, wanted) < 1e-12
    with pytest.raises(UsageError, match="in C there are no derivatives by parameters of 'rk4'"):
        c.step_by_p(Q, V, TAU, W_EXT, 1e-3, "rk4")
    with pytest.raises(UsageError, match=r'compiled without parameters to differentiate by; give by_p=\("arm.\*",\)'):
        quick(MODEL).forward_dynamics_by_p(Q, V)


def test_a_folder_compiles_without_a_warning(tmp_path):
    from screwgen import dump

    (tmp_path / "arm.toml").write_text(dump(MODEL.robot), encoding="utf-8")
    called(["generate", str(tmp_path / "arm.toml"), "-o", str(tmp_path / "out"), "--target", "c", "--by-p", "fore.*"])
    assert "fore.rhoA" in (tmp_path / "out" / "c" / "arm_by_p.h").read_text()
    unfolded(tmp_path / "c", MODEL.c_files(by_p=OF, layout="modular"))
    assert not compile_cleanly(tmp_path / "c", "gcc", "-O0")
    assert checked(tmp_path / "c").said == DONE
    with pytest.raises(
        UsageError, match='derivatives by parameters need parameters at run time; give parameters="runtime"'
    ):
        MODEL.c_files("baked", by_p=OF)
