"""Checks of the folders of generated C: warnings, headers in C++, and the self-check that they bring."""

from __future__ import annotations

from every_command import DONE, checked
from helpers import unfolded

from conformance.c_warnings import COMPILERS, compile_cleanly
from conformance.cases import Case

LAYOUTS, BINDINGS = ("auto", "modular"), ("runtime", "baked")


def folder(case: Case) -> None:
    """A folder with all that a robot can have compiles without a warning, and its self-check passes, also in float.

    Compilers, layouts and bindings of parameters take turns from robot to robot.
    """
    turns = ((1, COMPILERS), (2, LAYOUTS), (4, BINDINGS))
    compiler, layout, binding = (names[case.seed // k % 2] for k, names in turns)
    place, options = case.folder / "c", dict(batch=True, derivatives=True, estimator=True, outputs=True)
    unfolded(place, case.model.c_files(binding, layout, None, **options))
    said = compile_cleanly(place, compiler, "-O0")
    assert not said, said
    found = checked(place)
    assert found.said == DONE, found
