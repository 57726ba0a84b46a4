"""The C interface for callers in other languages: one memory block, energies, the loop of a run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...algorithms import fused
from ...algorithms.signals import ROBOT
from ...ir.program import Program, live
from .code import Writer, literal, trimmed
from .columns import rendered
from .parameters import members
from .pieces import piece_place, pieces

if TYPE_CHECKING:
    from .project import CProject

FILES = ("shim.h", "shim.c", "run_shim.c", "dae_shim.c")
VIEWS = (
    *(f"state.{name}" for name in ROBOT["state"]),
    *(f"input.{name}" for name in ROBOT["input"]),
    *(f"output.{name}" for name in ROBOT["output"]),
    *(f"motion.{name}" for name in ROBOT["motion"]),
    "dae",
    "energy",
    "measures",
)
"""The members of an instance's memory that callers see."""
PARTS = 8
"""Steps beside which one that changes the energy of a robot with loops is held."""
CHANGE = 1e-4
"""The change of energy besides the work of the torques, over the largest kinetic energy so far, from which it is."""


def shims(project: CProject) -> dict[str, str]:
    """The files beside a robot's C that its shared library is made of."""
    energy = fused.energy(project.chain, "baked" if project.baked is not None else "constants")
    extra = extra_constants(project, energy)
    known = project.labels
    names = FILES + (("derivatives_shim.c",) if project.with_derivatives else ())
    chain = project.chain
    values = dict(
        views=VIEWS,
        extra=extra,
        extra_lines=extra_lines(project, extra),
        energy=_energy(project, energy, known, extra),
        parts=PARTS,
        change=literal(CHANGE),
        width=1 + chain.nq + chain.nv + chain.n_tau + 6 * chain.n + 3 + 2,
    )
    return {name: rendered(name, **project.context, **values) for name in names}


def extra_constants(project: CProject, energy: Program) -> list[tuple[int, str]]:
    """Link and label of the constants that the energy reads and `<robot>_prepare` does not compute."""
    known, found = project.labels, []
    for node in live([v for values in energy.outputs.values() for v in values]):
        if node.op == "input":
            link, _, what = node.args[0].partition(":")
            if what.startswith("c.") and what[2:] not in known[int(link)]:
                found.append((int(link), what[2:]))
    return sorted(set(found))


def extra_lines(project: CProject, extra: list[tuple[int, str]]) -> list[str]:
    """Their preparation, link by link."""
    out = []
    for i in sorted({link for link, _ in extra}):
        wanted = tuple(name for link, name in extra if link == i)
        whole = fused.preparation(project.chain.keys[i], wanted)
        outputs = {name: whole.outputs[name] for name in wanted}
        program = Program(whole.name, whole.inputs, outputs, [], whole.sections)
        link = project.chain.segments[i].link
        given = members(project.chain.robot, link)

        def place(name: str, k: int, i=i, link=link, given=given) -> str:
            if name.startswith("p."):
                return f"p->links[{link}].{given[name[2:]]}"
            return f"m->extra[{extra.index((i, name))}]"

        lines = trimmed(Writer(program, place, None, {"p", "m"}).lines())
        out += ["{", *(f"    {line}" if line else "" for line in lines), "}"]
    return out


def _energy(project: CProject, program: Program, known, extra: list[tuple[int, str]]) -> dict:
    own = {
        "kinetic": lambda k: "energy[0]",
        "potential": lambda k: "energy[1]",
        "gravity": lambda k: f"c->gravity[{k}]",
        "q": lambda k: f"state->q[{k}]",
        "v": lambda k: f"state->v[{k}]",
    }

    def place(name: str, k: int) -> str:
        link, member = name.split(":c.")
        prepared = member in known[int(link)]
        return f"c->links[{link}].{member}" if prepared else f"extra[{extra.index((int(link), member))}]"

    return pieces(program, piece_place(project.chain, "kept", own, place), ("c", "state", "extra", "kept", "energy"))
