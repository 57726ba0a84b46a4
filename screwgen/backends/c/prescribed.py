"""Axes whose motion is given, in generated C: what they write in the files of derivatives."""

from __future__ import annotations

from ...topology.chain import Chain

PRESCRIBED = ("prescribed",)
"""What they write, as :class:`..templates.TemplatePlaces` finds it."""


def content(chain: Chain) -> dict[str, object]:
    """The templates' context: the ``places`` of the coordinates among rates, and their ``inputs`` among torques."""
    return {"places": [chain.held_places[k] for k in chain.prescribed], "inputs": chain.prescribed}
