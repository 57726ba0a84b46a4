"""Units of robots with loops, rows that cancel in their derivatives; and wrong use."""

from ctypes import c_double
from functools import partial

import mpmath
import numpy as np
import pytest
from fmi_units import Unit
from fmpy.fmi1 import FMICallException
from helpers import arm, example_dict, example_file, link, model_of, relative
from mechanisms import slider_crank
from test_closed_runs import moving_off
from test_fmi import responses

from screwgen.algorithms import fused
from screwgen.algorithms.response import Response
from screwgen.cli.main import main
from screwgen.errors import UsageError
from screwgen.integrators.methods import METHODS
from screwgen.ir.adjoint import only
from screwgen.ir.replay import run

FLAP = """
name = "flap"
gravity = [0.0, 0.0, -9.81]
[[links]]
name = "flap"
length = 1.0
section = { rhoA = 1.0 }
joint = { axes = ["y"] }
"""


def away(unit: Unit) -> None:
    """Random states and inputs, away from where the run begins."""
    rng, scale = np.random.default_rng(0), [0.01 if ".eta" in x else 0.3 for x in unit.states]
    unit.set(dict(zip(unit.states, unit.get(unit.states) + scale * rng.normal(size=len(scale)), strict=True)))
    unit.set(dict(zip(unit.inputs, rng.normal(size=len(unit.inputs)), strict=True)))


def test_the_wrench_about_a_free_axis_is_its_torque():
    """Of the platform's hinge, which states no armature: of all states and inputs its rate and its torque count."""
    chain = model_of(example_dict("parallelogram")).chain
    about_y = Response(chain).sparsity()["wrench"][6 * 1 + 1]
    assert about_y == [chain.nq + 1, chain.nq + chain.nv + 1]


@pytest.mark.long
def test_rows_that_cancel_against_fifty_digits():
    """Rows of reactions in the parallelogram, each beside its own largest entry.

    What the rod's foot bears about x is 1 where its terms are 1e6, so doubles keep eleven digits, those of CasADi too.
    """
    unit = Unit("fmu3", "me", partial(example_dict, "parallelogram")).ready()
    away(unit)
    model, point = unit.model, unit.get(unit.states + unit.inputs)
    knowns, unknowns = unit.of(unit.states + unit.inputs), unit.of(model.wrench_names)
    exact, first = wrench_slopes(model, point), unit.unknowns.index(model.wrench_names[0])
    casadi = np.array(responses(model)(point))[first : first + len(exact)]
    columns = [unit.fmu.getDirectionalDerivative(unknowns, [known], [1.0]) for known in knowns]
    ours, theirs = ([relative(a, b) for a, b in zip(x, exact, strict=True)] for x in (np.transpose(columns), casadi))
    hard = model.wrench_names.index("rod.tau_x")
    assert max(np.delete(ours, hard)) < 1e-12
    assert 1e-12 < ours[hard] < 1e-9 and 1e-12 < theirs[hard] < 1e-9 and np.abs(exact[hard]).max() < 2.0


def wrench_slopes(model, point) -> np.ndarray:
    """The derivatives of the joint wrenches with states and inputs, by central differences of 50 digits."""
    program = only(fused.forward_dynamics(model.chain), ["wrench"])
    ends = np.cumsum([model.nq, model.nv, model.n_tau])
    with mpmath.workdps(50):
        exact, h = (np.vectorize(mpmath.mpf, otypes=[object])(x) for x in (point, "1e-16"))
        p = [mpmath.mpf(x) for x in model.parameter_values]

        def at(x):
            given = dict(zip(("q", "v", "tau", "w_ext"), map(list, np.split(x, ends)), strict=True)) | {"p": p}
            return np.array(run(program, given, fused.precise)[0]["wrench"], dtype=object)

        unit = np.eye(len(exact), dtype=int)
        return np.transpose([(at(exact + h * e) - at(exact - h * e)) / (2 * h) for e in unit]).astype(float)


@pytest.mark.long
def test_open_loops_are_refused():
    with pytest.raises(FMICallException):
        Unit("fmu2", "cs", partial(example_dict, "crane_loop")).ready()


def test_a_start_with_frames_half_a_turn_apart_is_refused():
    """A slider-crank whose piston is turned over: all rows of its loop vanish."""
    unit = Unit("fmu2", "cs", partial(slider_crank, "guide"))
    with pytest.raises(FMICallException):
        unit.ready(**{"piston.joint[0]": np.pi})


@pytest.mark.parametrize(("target", "kind"), [("fmu2", "cs"), ("fmu3", "me")])
def test_a_loop_that_opens_stops_the_unit(target, kind):
    """In co-simulation a step is discarded; in model exchange the end is asked for."""
    unit = Unit(target, kind, slider_crank)
    rates = moving_off(unit.model, 20.0)
    unit.ready(**dict(zip(unit.model.v_names, rates, strict=True)))
    if kind == "cs":
        unit.choose(list(METHODS).index("euler") + 1)
        unit.set({"solver.step": 0.01})
        with pytest.raises(FMICallException):
            for k in range(100):
                unit.step(0.01 * k, 0.01)
    else:
        states = np.zeros(4)
        for opened in (False, True):
            states[0] = 0.1 * opened
            unit.fmu.setContinuousStates((c_double * 4)(*states), 4)
            assert unit.fmu.completedIntegratorStep()[1] == opened


def test_without_a_compiler_there_are_the_sources(tmp_path, monkeypatch, capsys):
    """One line says so; the command ends well."""
    monkeypatch.setenv("CC", "no-such-compiler")
    (tmp_path / "flap.toml").write_text(FLAP)
    assert main(["generate", str(tmp_path / "flap.toml"), "-o", str(tmp_path / "out"), "--target", "fmu3"]) == 0
    out = capsys.readouterr()
    assert "sources alone, since there is no C compiler" in out.err and out.err.count("warning") == 1
    assert out.out.split() == [str(tmp_path / "out" / name) for name in ("MANIFEST.sha256", "fmu3/flap.fmu")]


def test_wrong_use_is_one_line(tmp_path, capsys):
    robot, out = str(example_file("ella")), str(tmp_path / "out")
    assert main(["generate", robot, "-o", out, "--target", "fmu4"]) == 2
    assert main(["generate", robot, "-o", out, "--target", "fmu2", "--derivatives"]) == 2
    said = capsys.readouterr().err.splitlines()
    assert len(said) == 2 and "choose c or casadi or latex or fmu2 or fmu3" in said[0] and "--target c" in said[1]
    with pytest.raises(UsageError, match="has no coordinates"):
        model_of(arm(link(axes=[]))).write(tmp_path / "out", targets=("fmu2",))
    assert not list(tmp_path.iterdir())
