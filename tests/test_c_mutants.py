"""How many wrong lines the self-check of the generated C finds: mutants by rule, over all sources of one robot."""

import re
from functools import cache

import pytest
from helpers import arm, model_of
from mutants import Folder, Mutant, mutants, spread

from screwgen.backends.c.project import CProject
from screwgen.joints.screw import Screw

SOUGHT = 0.95
"""The fraction of all mutants that the self-check must find."""

BODY = {"at": "tip", "mass": 0.7, "com": [0.1, -0.03, 0.02], "inertia": [0.02, 0.028, 0.033, 0.001, 0.002, -0.003]}
SECTION = {"rhoA": 1.0, "rhoIp": 1e-2, "EIz": 50.0, "GJ": 20.0}
BOOM = {
    "name": "boom",
    "length": 0.8,
    "section": SECTION,
    "modes": {"bending_y": 1, "torsion": 1},
    "damping": {"ratio": 0.03},
    "joint": {"axes": [[1.0, 2.0, 3.0]], "damping": [0.1], "stiffness": [3.0]},
}
JIB = {"name": "jib", "joint": {"axes": [Screw((0.48, 0.6, 0.64), travel=0.1)]}, "bodies": [BODY]}
ROBOT = arm(BOOM, JIB, gravity=(0.5, -1.0, -9.7)) | {"name": "robot"}
"""Little code of every sort, and no parameter that is zero: a sprung joint, a thread, bending, torsion, a body."""

EQUIVALENT = {
    "a term of a Stumpff series that is below the rounding error of the sum": ("real.c", r"\btail\b"),
    "a rounding error that the next summand takes back": ("real.c", r"\bnearly\b|\bleft\b"),
    "a part of the angle below its rounding error, within that error's square": ("real.c", r"\brest\b"),
    "the angle from which the series are replaced by reduction; they hold a little further": ("real.c", r"0\.785"),
    "K and D of joints without springs and dampers are not read": ("parameters.c", r"c->[KD]\[k\] = 0;"),
    "one per cent of a term of the fourth order in the step, below the tolerance": ("se3.h", r"REAL\(1\.0\) / 12"),
    "joint coordinates before the projection, whose two corrections find them from the poses": (
        "dae.c",
        r"->q\[k\] = ",
    ),
}
"""Changes without effect: why, and the file and the line where they stand."""


@cache
def texts(layout: str) -> dict[str, str]:
    model = model_of(ROBOT)
    return CProject(model.chain, model.version, "runtime", layout).files()


def unfound(folder: Folder, chosen: list[Mutant]) -> tuple[int, list[str]]:
    """The number of mutants that compile, and those of them that pass the self-check without an argument."""
    outcomes = [(mutant, folder.survives(mutant)) for mutant in chosen]
    alive = [mutant for mutant, survives in outcomes if survives]
    found = sum(survives is False for _, survives in outcomes)
    assert found >= SOUGHT * (found + len(alive)), [folder.shown(m) for m in alive]
    return found + len(alive), [folder.shown(m) for m in alive if not argued(folder, m)]


def argued(folder: Folder, mutant: Mutant) -> bool:
    """Whether a mutant stands where a change has no effect."""
    line = folder.line(mutant)
    return any(mutant.file.endswith(file) and re.search(where, line) for file, where in EQUIVALENT.values())


def test_the_self_check_finds_wrong_lines(tmp_path):
    """A few mutants of every source, more of the long ones."""
    folder = Folder(tmp_path, texts("modular"))
    chosen = []
    for file in folder.mutable:
        made = mutants(file, folder.texts[file], 1)
        chosen += spread(made, 4 + len(made) // 25)
    count, silent = unfound(folder, chosen)
    assert count >= 40 and not silent


@pytest.mark.long
@pytest.mark.parametrize("layout", ["modular", "fused"])
def test_the_self_check_finds_wrong_lines_everywhere(tmp_path, layout):
    """Mutants of every kind in every function."""
    folder = Folder(tmp_path, texts(layout))
    chosen = [m for file in folder.mutable for m in mutants(file, folder.texts[file], 1 if "links" in file else 3)]
    count, silent = unfound(folder, chosen)
    assert count >= 500 and not silent
