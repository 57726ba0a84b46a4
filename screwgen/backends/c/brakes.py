"""Brakes in generated C: what they write in the files of every robot; empty for a robot without any."""

from __future__ import annotations

from collections.abc import Callable
from itertools import accumulate

from ...algorithms.brakes import ROWS
from ...spec.brake import BRAKES as INPUT
from ...topology.chain import Chain
from .code import entries

BRAKES = ("brakes",)
"""What they write, as :class:`..template_places.TemplatePlaces` finds it."""


def content(chain: Chain) -> dict[str, object] | None:
    """The templates' context: the ``places`` of the coordinates among rates, the ``first`` of their inputs, and of
    every link the first of its brakes, ``offset``."""
    if not chain.braked:
        return None
    offset = [0, *accumulate(len(own) for own in INPUT.of_links(chain))]
    places = [chain.held_places[k] for k in chain.braked]
    return {"places": places, "first": chain.inputs[INPUT].start, "offset": offset[:-1], "rows": ROWS}


def rows(chain: Chain) -> dict[str, Callable[[int], str]]:
    """Where derivatives have what the rows with brakes are made of."""
    return {name: entries(f"work->{name}") for name in ROWS} if chain.braked else {}


def note(chain: Chain) -> str:
    """What is added to the comment of inputs."""
    return "; then how far each brake is closed, from 0 to 1" if chain.braked else ""
