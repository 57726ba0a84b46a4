"""Axes and a base whose motion is given, in generated C: what they write in the files of derivatives."""

from __future__ import annotations

from ...spec.base import BASE_MOTION
from ...topology.chain import Chain

PRESCRIBED = ("prescribed",)
"""What they write, as :class:`..template_places.TemplatePlaces` finds it."""


def content(chain: Chain) -> dict[str, object]:
    """The templates' context: the ``places`` of the coordinates among rates, their ``inputs``, and
    which are ``axes``; the first input of a ``base``."""
    base = chain.inputs[BASE_MOTION].start if chain.moving else None
    return {"base": base, "places": list(chain.given.values()), "inputs": list(chain.given), "axes": chain.prescribed}
