"""The integrators as the C templates print them: operations, and named step lengths."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from ...integrators.method import LONGEST, Method
from ...integrators.plan import Plan
from .code import literal

NAMES = dict(enumerate(("half", "third", "quarter", "fifth", "sixth", "seventh", "eighth"), 2))
"""The names of the lengths dt / n."""


class Steps(Plan):
    """The operations of a method, with C names for its lengths."""

    def __init__(self, method: Method):
        super().__init__(method)
        self._names = {part: _name(part, i) for i, part in enumerate(self.lengths, 1)}

    @property
    def comment(self) -> str:
        """The method's description, for a comment."""
        return f"{self.method}: {self.method.meaning}, order {self.method.order}."

    @property
    def constants(self) -> str:
        """The definitions of the lengths, as one C declarator list; empty where there are none."""
        return ", ".join(f"{name} = {_value(part)}" for part, name in self._names.items())

    def stage(self, number: int, renewed: bool) -> str:
        """The comment of a stage; empty if there is only one."""
        terms = "" if renewed else ", the terms of the elastic forces as before"
        return f"Stage {number}{terms}." if len(self.method.stages) > 1 else ""

    def length(self, part: Fraction) -> str:
        """A fraction of the step in C."""
        if part == 0:
            return "0"
        return "-" * (part < 0) + self._names.get(abs(part), "dt")


def content(methods: Mapping[str, Method]) -> dict:
    """The templates' context of the integrators."""
    steps = [Steps(method) for method in methods.values()]
    orders = [method.order for method in methods.values()]
    return {"methods": list(methods), "orders": orders, "steps": steps, "registers": registers(methods)}


def registers(methods: Mapping[str, Method]) -> list[str]:
    """The states that the integrators need besides the step's start and end."""
    return max((Plan(method).registers for method in methods.values()), key=len)


def _name(part: Fraction, number: int) -> str:
    if part.denominator > LONGEST:
        return f"part_{number}"
    if part.numerator == 1 and part.denominator in NAMES:
        return NAMES[part.denominator]
    return f"dt_{part.numerator}" + f"_{part.denominator}" * (part.denominator > 1)


def _value(part: Fraction) -> str:
    if part.denominator > LONGEST:
        return f"{literal(float(part))} * dt"
    times, over = f"{part.numerator} * " * (part.numerator > 1), f" / {part.denominator}" * (part.denominator > 1)
    return f"{times}dt{over}"
