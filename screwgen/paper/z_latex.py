"""The section on the Z-form: its coordinates and rates, the system in ``Zdot``, the Cauchy form."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..algorithms.scope import common
from ..backends.latex.content import Item, Section, equation, parse
from ..backends.latex.pattern import pattern
from ..backends.latex.steps import BlockView, block_view
from ..backends.templates import render
from ..topology.chain import Chain
from .z_functions import cauchy_size

STEPS = re.compile(r"^@ (.*)$", re.MULTILINE)
"""A line of the template that stands for steps of the block."""


def z_view() -> BlockView:
    """The block of the Z-form as it is shown."""
    return block_view(common()["z_form"])


def z_section(chain: Chain) -> Section:
    """The Z-form of a robot."""
    prose = render("latex/z_form.tex.jinja", pattern=pattern(chain, "Z"), size=cauchy_size(chain))
    return Section("The Z-form", list(_items(prose)))


def _items(prose: str) -> Iterator[Item]:
    """Prose with the steps that it asks for."""
    steps = {step.name: step for step in z_view().steps}
    for i, part in enumerate(STEPS.split(prose)):
        yield from map(equation, (steps[name] for name in part.split())) if i % 2 else parse(part)
