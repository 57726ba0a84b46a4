"""Checks of the folders of generated C: warnings, headers in C++, and the self-check that they bring."""

from __future__ import annotations

from conftest import require_tool
from every_command import DONE, checked
from helpers import unfolded

from conformance.c_warnings import COMPILERS, STRICT
from conformance.cases import Case

LAYOUTS, BINDINGS = ("auto", "modular"), ("runtime", "baked")


def folder(case: Case) -> None:
    """A folder with all that a robot can have compiles without a warning, and its self-check passes, also in float.

    Its Makefile compiles every source, the example and the self-check too, in double and in float.
    Compilers, layouts and bindings of parameters take turns from robot to robot.
    """
    turns = ((1, COMPILERS), (2, LAYOUTS), (4, BINDINGS))
    compiler, layout, binding = (names[case.seed // k % 2] for k, names in turns)
    place, options = case.folder / "c", dict(batch=True, derivatives=True, estimator=True, outputs=True)
    unfolded(place, case.model.c_files(binding, layout, None, **options))
    require_tool(compiler)
    found = checked(place, compiler, STRICT[compiler])
    assert found.said == DONE, found
