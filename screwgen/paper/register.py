"""All equations and errata of the paper, in its order, and how they are looked up."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import TypeVar

from ..errors import UsageError
from .equation import Equation
from .erratum import Erratum

_Entry = TypeVar("_Entry")

SECTIONS = {
    "2": "Problem statement",
    "3": "The flexible link",
    "4": "Synthesis",
    "5": "Modal projection",
    "6": "Well-posedness",
    "7": "The two-link arm",
    "A": "Kinematic identities",
    "B": "Modal projection matrices",
}
MODULES = ("kinematics", "link", "synthesis", "stacking", "projection", "discretised", "appendix_b", "cauchy")
ERRATA_MODULES = ("errata_kinematics", "errata_link", "errata_synthesis", "errata_projection", "errata_ella")


@cache
def equations() -> tuple[Equation, ...]:
    """Every equation, section by section."""
    found = [e for name in (*MODULES, "ella_section") for e in _module(name).EQUATIONS]
    order = list(SECTIONS)
    return tuple(sorted(found, key=lambda e: order.index(e.section)))


@cache
def errata() -> tuple[Erratum, ...]:
    """Every erratum, by number."""
    found = [e for name in ERRATA_MODULES for e in _module(name).ERRATA]
    return tuple(sorted(found, key=lambda e: int(e.number[1:])))


def _module(name: str) -> ModuleType:
    return import_module(f".{name}", __package__)


def equation(label: str) -> Equation:
    """The equation of a label, written ``29``, ``(29)`` or ``eq:29``; UsageError names the nearest ones."""
    return _found(label, {e.label: e for e in equations()}, "equation")


def erratum(number: str) -> Erratum:
    """The erratum of a number such as ``E7``."""
    return _found(number.upper(), {e.number: e for e in errata()}, "erratum")


def _found(given: str, known: Mapping[str, _Entry], kind: str) -> _Entry:
    name = given.strip().removeprefix("eq:").removeprefix("tab:").strip("()")
    by_lower = {key.lower(): key for key in known}
    key = by_lower.get(name.lower())
    if key is None:
        near = get_close_matches(name.lower(), by_lower, n=3, cutoff=0.5)
        hint = f"did you mean {' or '.join(by_lower[n] for n in near)}?" if near else "'screwgen paper' lists them"
        raise UsageError(f"the paper has no {kind} '{name}'; {hint}")
    return known[key]


def is_erratum(label: str) -> bool:
    """Whether a label is an erratum's number."""
    return label[:1].upper() == "E" and label[1:].isdigit()
