"""The batch of the C back end: forward dynamics on vector lanes, one scenario per lane."""

from __future__ import annotations

from collections.abc import Callable

from ...algorithms import fused
from ...ir.program import Node, Program
from ...ir.split import KEPT, split
from ...topology.chain import Chain
from .code import ATOM, Writer, with_unused

Place = Callable[[str, int], str]

FILES = ("lanes.h", "batch.h", "batch.c")
"""The files that a batch adds, without the robot's name; their templates have the same names."""

LANE_BYTES = 64
"""The widest vector register that the generated C uses, in bytes."""


PIECE = 4000
LONGEST = 6000
"""Operations of a C function: compilers take more than twice as long for twice as many."""


class LaneWriter(Writer):
    """A program over lanes: guards are collected, sine and cosine of an angle come from one call."""

    paired = False

    def _guard(self, node: Node, text: str) -> str:
        return f"bad = {self.prefix}_blame(bad, {text}, {self._guards[node.id]});"

    def _text(self, node: Node) -> tuple[str, int]:
        angle = _angle(node)
        return super()._text(node) if angle is None else (f"{node.op}_q[{angle}]", ATOM)

    def _outputs(self) -> list[str]:
        for name, values in self.program.outputs.items():
            self._written |= {(name, k) for k, v in enumerate(values) if v is None}
        return super()._outputs()


def dynamics(chain: Chain, baked: bool) -> Program:
    """``(q, v, tau, w_ext, m_eta, f_eta) -> (vdot)``: the forward dynamics without the outputs that no step needs."""
    whole = fused.complete_dynamics(chain, "baked" if baked else "constants")
    outputs = {"vdot": whole.outputs["vdot"]}
    return Program("batch_dynamics", whole.inputs, outputs, whole.guards, whole.sections, whole.origins)


def content(chain: Chain, name: str, baked: bool, constants: int, states: int, place: Place) -> dict:
    """The templates' context.

    ``constants`` are the members of a link's struct, ``states`` those of a scenario in a step, ``place`` is as in
    :class:`Writer`.
    """
    program = dynamics(chain, baked)
    pieces, kept = split(program, _pieces(program))
    angles = sorted({angle for node in program.nodes if (angle := _angle(node)) is not None})
    return {
        "operations": program.operation_count,
        "pieces": [_lines(piece, name, place) for piece in pieces],
        "kept": kept,
        "angles": angles,
        "stack": _stack(chain, constants, states, kept),
    }


def _pieces(program: Program) -> int:
    count = program.operation_count
    return 1 if count <= LONGEST else -(-count // PIECE)


def _lines(program: Program, name: str, place: Place) -> list[str]:
    """The body of a function over lanes."""

    def kept_or(signal: str, k: int) -> str:
        kind, _, first = signal.partition(":")
        if kind == "m_eta":
            return f"work->m_eta[{k}]"
        return f"{KEPT}[{int(first or 0) + k}]" if kind == KEPT else place(signal, k)

    pointers = ("c", "state", "input", "work", "output")
    taken = {*pointers, KEPT, "bad", "sin_q", "cos_q"}
    lines = LaneWriter(program, f"{name}_lanes", kept_or, _no_guard, taken, apart=True).lines()
    return with_unused((*pointers, "sin_q", "cos_q", KEPT), lines)


def _no_guard(test: str, link: int) -> str:
    raise AssertionError("guards of lanes are gathered")


def _stack(chain: Chain, constants: int, states: int, kept: int) -> int:
    """The size in bytes of a group of scenarios, for the widest lanes."""
    given, inertia = max(chain.n_given, 1), max(chain.n_inertia, 1)
    state, joints = 2 * max(chain.nq, 1), max(chain.n_joints, 1)
    group = 3 + chain.n * constants + 4 * inertia + given + states * state + state // 2 + joints + 6 * chain.n + 3
    return LANE_BYTES * (group + kept + 2 * joints)


def _angle(node: Node) -> int | None:
    """The coordinate of which a node is the sine or cosine."""
    if node.op in ("sin", "cos") and node.args[0].op == "input" and node.args[0].args[0] == "q":
        return node.args[0].args[1]
    return None
