"""What recurs in the functions of links, as C functions of their own: the sections and masses of a rod."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

from ...ir.program import Node, Program
from ...ir.routines import CALL, FOUND, GIVEN, Routine, outlined
from .code import Writer, called, trimmed


@dataclass(frozen=True)
class RoutineFunction:
    """A C function that others call."""

    comment: list[str]
    signature: str
    lines: list[str]
    routine: Routine

    @property
    def c_name(self) -> str:
        """The name of the function."""
        return called(self.routine.name)


class Routines:
    """Programs with calls of what recurs in them, and the C functions that are called."""

    def __init__(self, programs: Iterable[Program]):
        self._whole = {id(p): p for p in programs}
        calling, self.called = outlined(list(self._whole.values()))
        self._calling = dict(zip(self._whole, calling, strict=True))

    def calling(self, program: Program) -> Program:
        """The program with its calls."""
        return self._calling[id(program)]

    @cached_property
    def functions(self) -> list[RoutineFunction]:
        """The C functions, in the order in which they are first called."""
        return [_function(routine) for routine in self.called]

    def called_by(self, programs: Iterable[Program]) -> list[RoutineFunction]:
        """The functions that some of the programs call."""
        called = {id(n.args[0]) for p in programs for n in self.calling(p).nodes if n.op == CALL}
        return [f for f in self.functions if id(f.routine) in called]


def _function(routine: Routine) -> RoutineFunction:
    program = routine.program
    found, given = program.outputs[FOUND], program.inputs[GIVEN]
    writer = Writer(program, lambda name, k: f"{name}[{k}]", None, {GIVEN, FOUND}, apart=True)
    work = f"{routine.name.replace('_', ' ')}: {program.operation_count} operations, called {routine.calls} times;"
    signature = f"const $_real {GIVEN}[restrict {given}], $_real {FOUND}[restrict {len(found)}]"
    finds = [v.label.quantity if isinstance(v, Node) and v.label else "" for v in found]
    comment = [work, f"{GIVEN}: {_places(routine.reads)};", f"{FOUND}: {_places(finds)}"]
    return RoutineFunction(comment, signature, trimmed(writer.lines()), routine)


def _places(names: Sequence[str]) -> str:
    """The quantities of an array with the places of their entries, those without a name left out."""
    out: dict[str, list[int]] = {}
    for k, name in enumerate(names):
        out.setdefault(name.removeprefix("c.").removeprefix("w."), []).append(k)
    spans = {
        name: f"{places[0]} to {places[-1]}" if len(places) > 1 else str(places[0]) for name, places in out.items()
    }
    return ", ".join(f"{name} {span}" for name, span in spans.items() if name)
