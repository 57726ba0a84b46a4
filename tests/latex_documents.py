"""The documents that the tests of the LaTeX back end share, one of them of a robot with everything at once."""

from __future__ import annotations

import re
import subprocess
from functools import cache
from pathlib import Path

import pytest
from conftest import require_tool
from helpers import example_file

from screwgen import Robot, load
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.content import Document
from screwgen.backends.latex.steps import BlockView
from screwgen.backends.latex.style import DocumentStyle
from screwgen.ir.block import Block
from screwgen.plugins import plugins
from screwgen.spec.link_class import LinkClass
from screwgen.topology.chain import Chain

ROOT = Path(__file__).resolve().parents[1]
PLUGINS = plugins()
NAMES = ("ella", "six_link", "strange", "measured")
every_robot = pytest.mark.parametrize("name", NAMES)

SECTION = {"rhoA": 1.0, "EA": 1e6, "EIy": 1e3, "EIz": 2e3, "GJ": 3e2, "rhoIp": 1e-3}
BODY = {"mass": 1.5, "com": [0.1, 0.0, -0.02], "inertia": [0.02, 0.03, 0.03, 0.0, 0.001, 0.0]}
STRANGE = {
    "name": "strange",
    "gravity": [1.0, 0.0, -9.81],
    "links": [
        {
            "name": "a_link_with_a_name_as_long_as_names_can_",
            "length": 1.0,
            "frame_at": 0.25,
            "section": SECTION,
            "modes": {"basis": "polynomial", "axial": 2, "bending_y": 4, "bending_z": 3, "torsion": 1},
            "damping": {"ratio": 0.01},
            "joint": {
                "axes": [[0.3, -0.4, 0.866], "y", [0.1, 0.2, -0.97]],
                "mount": {"xyz": [0.0, 0.1, 0.2], "rpy": [0.1, 0.2, 0.3]},
                "armature": [0.1, 0.2, 0.3],
                "damping": [0.1, 0.2, 0.3],
                "stiffness": [1.0, 2.0, 3.0],
            },
            "bodies": [{"at": "base", **BODY}, {"at": "tip", **BODY}, {"at": "tip", **BODY}],
        },
        {"name": "welded", "length": 0.5, "section": {"rhoA": 2.0}, "joint": {"axes": []}},
        {
            "name": "thin",
            "length": 0.7,
            "section": {"rhoA": 0.3, "EIy": 10.0},
            "modes": {"bending_z": 1},
            "joint": {"axes": ["x", [1.0, 1.0, 0.0]]},
        },
    ],
}
FOUND = {"axial": [900.0, 2500.0], "bending_y": [20.0, 131.0, 340.0], "bending_z": [27.0], "torsion": [310.0]}
MEASURED = {
    "name": "measured",
    "gravity": [0.0, 0.0, -9.81],
    "links": [
        {
            "name": "by_frequencies",
            "length": 1.0,
            "section": {"rhoA": 1.0, "rhoIp": 1e-3},
            "modes": {d: len(f) for d, f in FOUND.items()} | {"frequencies": FOUND},
            "damping": {"ratio": 0.01},
            "joint": {"axes": ["y", "z"]},
        },
        {
            "name": "by_both",
            "length": 0.7,
            "section": {"rhoA": 0.3, "EIy": 10.0},
            "modes": {"bending_y": 1, "bending_z": 2, "frequencies": {"bending_y": [12.0]}},
            "joint": {"axes": ["z"]},
        },
    ],
}
BUILT = {"strange": STRANGE, "measured": MEASURED}


@cache
def robot(name: str) -> Robot:
    return Robot.model_validate(BUILT[name]) if name in BUILT else load(example_file(name))


@cache
def content(name: str) -> Document:
    return latex.content(robot(name), PLUGINS)


WHOLE = DocumentStyle(whole=True)
"""With the derivation and all further forms."""


@cache
def tex(name: str, style: DocumentStyle = WHOLE) -> str:
    return latex.tex(content(name), style)


@cache
def page(name: str) -> str:
    return latex.page(content(name), latex.extras(Chain(robot(name))))


@cache
def views(key: LinkClass) -> tuple[tuple[Block, BlockView], ...]:
    """The blocks that the section of a class shows, those of plug-ins too."""
    blocks = latex.class_blocks(key, PLUGINS)
    return tuple((blocks[view.name], view) for view in latex.class_views(key, blocks))


def too_wide(text: str, where: Path) -> float:
    """By how many points the widest line of a LaTeX document runs off its column or the page."""
    (where / "equations.tex").write_text(text, encoding="utf-8")
    command = [require_tool("pdflatex"), "-interaction=nonstopmode", "-halt-on-error", "equations.tex"]
    done = subprocess.run(command, cwd=where, capture_output=True, text=True, errors="replace")
    assert done.returncode == 0, done.stdout[-2000:]
    log = (where / "equations.log").read_text(errors="replace").replace("\n", " ")
    return max(map(float, re.findall(r"Overfull \\hbox \(([\d.]+)pt", log)), default=0.0)
