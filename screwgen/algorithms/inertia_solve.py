"""Accelerations of given generalised forces, ``vdot = -M^-1 force``, by the elimination of the forward dynamics.

At rest, without weight and loads, the forward dynamics is linear in the forces of the coordinates. Its phases are those
of the dynamics, with these forces in place of what acts on the axes. They are then *parted*: what depends on the
posture alone, such as articulated inertias and factors, is found once, and each column of forces costs two passes along
the tree, O(n), where a factor of the whole mass matrix costs O(n^2).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from ..ir.parting import dependents, parted
from ..ir.program import Array, Node, Program
from ..topology.chain import Chain
from . import elastic_travels as et
from . import phases as ph
from .axis_terms import own_inertia
from .functions import KINEMATICS
from .schedule import INWARD, OUTWARD, Algorithm, Phase
from .scope import Scope
from .signals import is_node
from .station_names import plain
from .structure import Passage


def eliminate(s: Scope) -> None:
    """Tip to base: as in the forward dynamics, with the forces of joints and rotors in place of what acts on these."""
    ph.eliminate(s, condense_forces)


def condense_forces(s: Scope) -> tuple[Array, Array]:
    """Eliminate the rotors' accelerations from the joint's rows: the inertia that remains, and the driving force."""
    inertia, driving = own_inertia(s).copy(), -s.read("force")
    if not s.key.added_axes:
        return inertia, driving
    m, coupling, force = s.read("m_theta"), s.read("m_gear"), s.read("force_theta")
    follows, alone = coupling.copy(), force.copy()
    for k, axis in enumerate(s.key.added_axes):
        inverse = 1.0 / m[k]
        if axis in s.key.elastic_travels:
            follows[k], alone[k], inertia[axis], more = et.condensed(s, axis, 0.0, m[k], force[k], inverse)
            driving[axis] = driving[axis] + more
            continue
        follows[k], alone[k] = coupling[k] * inverse, -force[k] * inverse
        inertia[axis] = inertia[axis] - coupling[k] * follows[k]
        driving[axis] = driving[axis] - coupling[k] * alone[k]
    s.keep("rotor_W", follows)
    s.keep("rotor_w", alone)
    return inertia, driving


SOLVE: Algorithm = (KINEMATICS, Phase(eliminate, INWARD), Phase(ph.accelerate, OUTWARD))
ZERO = frozenset("qdot twist thetadot etadot w_ext f_q f_theta tau tension gravity".split())
"""The signals that are zero."""
FORCES = {"force": "qddot", "force_theta": "thetaddot", "f_eta": "etaddot"}
"""The forces, and the accelerations that they cause."""
SUMS = ("p", "delta")
"""What of nodes depends on the forces."""
FIXED = {"eliminate": "inward", "accelerate": "outward"}
"""What a link keeps of the values that do not, for the phases that read them."""


@dataclass(frozen=True)
class Parted:
    """The passages of all links, parted: what the posture fixes, and what each column of forces costs."""

    fixed: list[Passage]
    columns: list[Passage]
    kept: frozenset[str]
    """What links keep of columns between the passes."""


def part(found: Sequence[Passage], algorithm: Algorithm = SOLVE) -> Parted:
    """Part the passages of the algorithm; equal programs are parted once."""
    varying, done = _varying(found), {}
    fixed, columns = [], []
    for passage in found:
        name, key = algorithm[passage.phase].name, (id(passage.program), passage.wanted)
        if key not in done:
            done[key] = _part(passage, varying, FIXED.get(name, ""))
        still, rest = done[key]
        fixed.append(_passage(passage, still))
        columns.append(_passage(passage, rest))
    moving = [passage for passage in columns if passage.program.outputs]
    return Parted(fixed, moving, frozenset(name for name in varying if name.startswith("w.")))


def _part(passage: Passage, varying: frozenset[str], kept: str) -> tuple[Program, Program]:
    moving = [name for name in (*passage.program.inputs, *passage.program.outputs) if _varies(name, varying)]
    return parted(passage.program, frozenset(moving), f"w.{kept}")


def _passage(passage: Passage, program: Program) -> Passage:
    """The same with one of its parts."""
    wanted = {(name, k) for name, k in passage.wanted if name in program.outputs}
    wanted |= {
        (name, k)
        for name in program.outputs.keys() - passage.program.outputs.keys()
        for k in range(len(program.outputs[name]))
    }
    return replace(passage, program=program, wanted=frozenset(wanted))


def _varies(name: str, varying: Iterable[str]) -> bool:
    where, _, what = name.partition(".")
    return plain(what) in SUMS if is_node(where) else name in varying


def _varying(found: Sequence[Passage]) -> frozenset[str]:
    """The forces, accelerations, and what links keep that depends on the forces."""
    varying = {*FORCES, *FORCES.values()}
    for program in {id(p.program): p.program for p in found}.values():
        named = [name for name in program.inputs if _varies(name, varying)]
        moved = dependents(program, frozenset(named))
        varying |= {
            n
            for n, values in program.outputs.items()
            if n.startswith("w.") and any(isinstance(v, Node) and v.id in moved for v in values)
        }
    return frozenset(varying)


def operations(passages: Iterable[Passage]) -> int:
    """The operations of all links together."""
    return sum(passage.program.operation_count for passage in passages)


def is_offered(chain: Chain) -> bool:
    """Whether a robot's inertia can be solved with so: no acceleration is given, no brake closed."""
    return not chain.has_reactions
