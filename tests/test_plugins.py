"""Plug-ins of others: every hook is asked, entry points are found, and what is wrong with one is said on one line."""

from __future__ import annotations

import importlib
import pickle
import sys

import casadi as ca
import numpy as np
import pytest
from helpers import arm, link
from latex_documents import WHOLE

import screwgen
from screwgen import Model, Robot, ScrewgenError
from screwgen.algebra.expression import number
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.content import Chapter, DocumentSection, Paragraph
from screwgen.cli.main import main
from screwgen.ir.block import Binding, Block
from screwgen.plugins import GROUP, Plugin, merged, plugins

ROBOT = Robot.model_validate(arm(link("rod", axes="y", modes={"bending_z": 1})))


def square(chain) -> dict:
    x = ca.SX.sym("x")
    return {"square": lambda: ca.Function("square", [x], [chain.n * x**2])}


def doubled(key) -> dict[str, Block]:
    block = Block("doubled", "Twice the speed")
    v = block.input("speed", (1, 1), "v_d", "m/s", "-", "a speed")
    block.step("twice", number(2) @ v, "t_d", unit="m/s", meaning="twice a speed")
    return {"doubled": block}


def chapter(chain) -> Chapter:
    named = (r"\mathbf{Q}_q", "a symbol of the text", "m", "3", "-", Binding.STATE)
    return Chapter((DocumentSection("Of a plug-in", [Paragraph(r"$\mathbf{Q}_q$ is squared.")]),), symbols=(named,))


def links(model) -> list[str]:
    return [found.name for found in model.robot.links]


MINE = Plugin(
    attributes={"links": links}, blocks=doubled, casadi=square, casadi_notes="`square` is x².", chapter=chapter
)


def test_a_model_has_what_its_plug_in_adds(tmp_path):
    model = Model(ROBOT, [MINE])
    assert model.links == ["rod"]
    assert "doubled" in model.blocks(0) and "link" in model.blocks(0)
    assert float(model.casadi()["square"](3.0)) == 9.0
    model.write(tmp_path / "out", ("casadi", "latex"), functions="all")
    assert "`square` is x²." in (tmp_path / "out" / "casadi" / "README.md").read_text(encoding="utf-8")
    for text in (latex.document(ROBOT, [MINE], WHOLE), latex.html(ROBOT, [MINE])):
        for part in ("Of a plug-in", "Twice the speed", "twice a speed", "a symbol of the text"):
            assert part in text
    assert pickle.loads(pickle.dumps(model)).links == ["rod"]


def test_a_model_without_plug_ins_has_nothing_of_them():
    model = Model(ROBOT, [])
    assert "square" not in model.casadi() and "doubled" not in model.blocks(0)
    with pytest.raises(AttributeError, match="'Model' has no attribute 'links'"):
        model.links  # noqa: B018
    assert "Of a plug-in" not in latex.document(ROBOT)


def test_a_name_that_two_have_is_refused():
    with pytest.raises(ScrewgenError, match="have the CasADi function 'square'"):
        Model(ROBOT, [Plugin(casadi=square)] * 2).casadi()
    with pytest.raises(ScrewgenError, match="have the block 'doubled'"):
        latex.document(ROBOT, [MINE, MINE])
    for name in ("nq", "robot"):
        with pytest.raises(ScrewgenError, match=f"have the attribute '{name}'"):
            Model(ROBOT, [Plugin(attributes={name: links})]).casadi()
    assert merged("thing", {"a": 1}, {"b": 2}) == {"a": 1, "b": 2}


MODULE = """
import numpy as np
import screwgen
from screwgen.plugins import Plugin


class Halved:
    def __init__(self, robot):
        self.model = screwgen.Model(robot, ())

    def forward_dynamics(self, q, v, tau, w_ext=None):
        vdot, wrench = self.model.numpy().forward_dynamics(q, v, tau, w_ext)
        return vdot / 2, wrench / 2

    def record(self):
        return {"remark": "halved"}


def hello() -> None:
    print("hello")


PLUGIN = Plugin(commands=lambda app: app.command()(hello), formulations={"halved": Halved})
"""


@pytest.fixture
def installed(tmp_path, monkeypatch):
    """Puts a module and its entry point on the path, as an installer does."""

    def install(module: str, text: str, value: str) -> None:
        (tmp_path / f"{module}.py").write_text(text, encoding="utf-8")
        folder = tmp_path / f"{module}-1.0.dist-info"
        folder.mkdir()
        (folder / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {module}\nVersion: 1.0\n", encoding="utf-8")
        (folder / "entry_points.txt").write_text(f"[{GROUP}]\n{module} = {value}\n", encoding="utf-8")
        monkeypatch.syspath_prepend(str(tmp_path))
        monkeypatch.delitem(sys.modules, module, raising=False)
        importlib.invalidate_caches()

    return install


def test_an_entry_point_is_found(installed, capsys, tmp_path):
    before = plugins()
    installed("halving", MODULE, "halving:PLUGIN")
    assert len(plugins()) == len(before) + 1
    assert main(["hello"]) == 0 and capsys.readouterr().out == "hello\n"
    derived, halved = screwgen.derive(ROBOT), screwgen.derive(ROBOT, formulation="halved")
    given = np.array([0.3, 0.0]), np.array([0.2, 0.0]), np.array([1.0]), np.zeros((1, 6))
    assert np.array_equal(2 * halved.forward_dynamics(*given)[0], derived.numpy().forward_dynamics(*given)[0])
    file = tmp_path / "rod.toml"
    file.write_text(screwgen.dump(ROBOT), encoding="utf-8")
    assert main(["evaluate", str(file), "--formulation", "halved"]) == 0
    assert '"remark": "halved"' in capsys.readouterr().out


def test_a_command_that_two_have_is_refused(installed, capsys):
    installed("halving", MODULE.replace("hello", "generate"), "halving:PLUGIN")
    assert main(["--help"]) == 2
    assert capsys.readouterr().err.endswith("have commands of one name\n")


@pytest.mark.parametrize(
    ("text", "value", "message"),
    [
        ("import no_such_module_at_all", "wrong:PLUGIN", "the plug-in 'wrong' cannot be imported: No module named"),
        ("from math import nothing", "wrong:PLUGIN", "the plug-in 'wrong' cannot be imported: cannot import name"),
        ("", "wrong:PLUGIN", "the plug-in 'wrong' cannot be imported: module 'wrong' has no attribute"),
    ],
)
def test_one_that_cannot_be_imported_is_an_error(installed, capsys, text, value, message):
    installed("wrong", text, value)
    assert main(["--help"]) == 2
    error = capsys.readouterr().err
    assert message in error and error.count("\n") == 1


def test_a_name_that_two_packages_take_is_refused(installed, tmp_path, capsys):
    installed("halving", MODULE, "halving:PLUGIN")
    other = tmp_path / "other-1.0.dist-info"
    other.mkdir()
    (other / "METADATA").write_text("Metadata-Version: 2.1\nName: other\nVersion: 1.0\n", encoding="utf-8")
    (other / "entry_points.txt").write_text(f"[{GROUP}]\nhalving = other:PLUGIN\n", encoding="utf-8")
    assert main(["--help"]) == 2
    assert "two packages have a plug-in 'halving': " in capsys.readouterr().err


def test_one_whose_module_is_not_there_is_left_out(installed, capsys):
    before = plugins()
    installed("gone", "", "no_such_module_at_all.inside:PLUGIN")
    assert plugins() == before
    assert main(["gone"]) == 2
    error = capsys.readouterr().err
    assert error == "screwgen: error: the command 'gone' is that of a plug-in which is not installed\n"
