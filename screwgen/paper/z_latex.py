"""The chapter on the Z-form: its coordinates and rates, the system in ``Zdot``, the Cauchy form."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from ..backends.latex.content import Chapter, DocumentSection, Item, Named, equation, parse
from ..backends.latex.pattern import pattern
from ..backends.latex.steps import StepView, block_view
from ..backends.templates import render
from ..ir.block import Binding
from ..topology.chain import Chain
from .z_form_blocks import z_form_block
from .z_functions import cauchy_size

TEMPLATES = Path(__file__).parent
STEPS = re.compile(r"^@ (.*)$", re.MULTILINE)
"""A line of the template that stands for steps of the block."""

STATE = Binding.STATE
DYNAMIC = "12 n × 12 n, 12 n"
SYMBOLS: tuple[Named, ...] = (
    (r"\boldsymbol{\Psi},\ \boldsymbol{\Psi}_Z", "wrenches, rates of twists or of Z", "mixed", "12 n", "F_i", STATE),
    (r"\mathbf{T}_{\gamma},\ \boldsymbol{\Gamma}^{*}", "change from one to the other", "mixed", DYNAMIC, "F_i", STATE),
    (r"\mathbf{M}_{dyn},\ \mathbf{h}_{dyn}", "dynamic rows of the Z-form, bias", "mixed", DYNAMIC, "F_i", STATE),
    (r"\mathbf{h}_{M_s}", "bias of the change to Z in the dynamic rows", "mixed", "12 n", "F_i", STATE),
    (r"\mathbf{x}_c", "state of the Cauchy form", "mixed", r"n_c = 12 n + 2 \sum r_i", "F_i", STATE),
    (r"\mathbf{A}_c,\ \mathbf{g}_c", "matrix, free term of the Cauchy form", "mixed", "n_c × n_c, n_c", "F_i", STATE),
)


def z_chapter(chain: Chain) -> Chapter:
    """The Z-form of a robot."""
    block = z_form_block()
    view = block_view(block)
    prose = render("z_form.tex.jinja", TEMPLATES, pattern=pattern(chain, "Z"), size=cauchy_size(chain))
    steps = {step.name: step for step in view.steps}
    section = DocumentSection("The Z-form", list(_items(prose, steps)), appendix=True)
    return Chapter((section,), ((block, view),), SYMBOLS)


def _items(prose: str, steps: Mapping[str, StepView]) -> Iterator[Item]:
    """Prose with the steps that it asks for."""
    for i, part in enumerate(STEPS.split(prose)):
        yield from map(equation, (steps[name] for name in part.split())) if i % 2 else parse(part)
