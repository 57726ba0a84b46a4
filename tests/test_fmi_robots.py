"""Units of robots of every sort: what fmpy says, steps against the C, derivatives against CasADi; and wrong use."""

from functools import partial

import numpy as np
import pytest
from conftest import swept
from fmi_units import Unit, written
from fmpy.fmi1 import FMICallException
from fmpy.validation import validate_fmu
from helpers import arm, example_dict, example_file, link, model_of, quick, relative
from test_fmi import responses, state_of

from screwgen.cli.main import main
from screwgen.errors import UsageError

FLAP = """
name = "flap"
gravity = [0.0, 0.0, -9.81]
[[links]]
name = "flap"
length = 1.0
section = { rhoA = 1.0 }
joint = { axes = ["y"] }
"""
ROBOTS = ("ella", "elastic_joint", "space_arm", "parallelogram", "crane", "gantry")


@pytest.mark.parametrize("name", swept(ROBOTS))
@pytest.mark.parametrize("target", ("fmu2", "fmu3"))
def test_units_of_every_sort(name, target):
    """Gears, floating bases, loops, cylinders and slides; away from where the run begins."""
    make = MAKERS[name]
    model, path = written(target, make)
    assert validate_fmu(str(path)) == []
    steps, c = Unit(target, "cs", make).ready(), quick(model)
    q, v = state_of(steps)
    for k in range(20):
        steps.step(k * 1e-3, 1e-3)
        q, v = c.step(q, v, None, None, 1e-3, "modal_implicit")
    assert [x.tobytes() for x in state_of(steps)] == [q.tobytes(), v.tobytes()]
    unit, rng = Unit(target, "me", make).ready(), np.random.default_rng(0)
    scale = [0.01 if ".eta" in x else 0.3 for x in unit.states]
    unit.set(dict(zip(unit.states, unit.get(unit.states) + scale * rng.normal(size=len(scale)), strict=True)))
    unit.set(dict(zip(unit.inputs, rng.normal(size=len(unit.inputs)), strict=True)))
    knowns, unknowns = unit.of(unit.states + unit.inputs), unit.of(unit.unknowns)
    expected = np.array(responses(model)(unit.get(unit.states + unit.inputs)))
    columns = [unit.fmu.getDirectionalDerivative(unknowns, [known], [1.0]) for known in knowns]
    assert relative(np.transpose(columns), expected) < 1e-12
    if target == "fmu3":
        rows = [unit.fmu.getAdjointDerivative([unknown], knowns, [1.0], len(knowns)) for unknown in unknowns]
        assert relative(rows, expected) < 1e-12


MAKERS = {name: partial(example_dict, name) for name in (*ROBOTS, "crane_loop")}


@pytest.mark.long
def test_open_loops_are_refused():
    with pytest.raises(FMICallException):
        Unit("fmu2", "cs", MAKERS["crane_loop"]).ready()


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
