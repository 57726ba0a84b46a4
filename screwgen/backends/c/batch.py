"""The batch of the C back end: forward dynamics on vector lanes, one scenario per lane."""

from __future__ import annotations

from ...algorithms import fused
from ...algorithms.robot_programs import force_rates
from ...ir.program import Node, Program, Value
from ...ir.split import KEPT
from ...topology.chain import Chain
from .code import ATOM, Place, Writer, entries
from .curved import lanes, turns
from .pieces import bodies, piece_place

FILES = ("lanes.h", "batch.h", "batch.c")
"""The files that a batch adds, without the robot's name; their templates have the same names."""

LANE_BYTES = 64
"""The widest vector register that the generated C uses, in bytes."""

LONGEST = 6000
"""A program of more operations is cut into several C functions."""


class FunctionOfLanes(Writer):
    """A program over lanes as a function of its own."""

    paired, prefix = False, "$_lanes"

    def _argument(self, value: Value) -> str:
        text = super()._argument(value)
        return text if isinstance(value, Node) else f"$_lanes_all({text})"


class LaneWriter(FunctionOfLanes):
    """A program over lanes: guards are collected, sine and cosine of an angle come from one call."""

    def _guard(self, node: Node, text: str) -> str:
        return f"bad = {self.prefix}_blame(bad, {text}, {self._guards[node.id]});"

    def _text(self, node: Node) -> tuple[str, int]:
        angle = _angle(node)
        return super()._text(node) if angle is None else (f"{node.op}_q[{angle}]", ATOM)


def dynamics(chain: Chain, baked: bool) -> Program:
    """``(q, v, tau, w_ext, m_eta, f_eta) -> (vdot)``: the forward dynamics without the outputs that no step needs."""
    whole = fused.complete_dynamics(chain, "baked" if baked else "constants")
    outputs = {"vdot": whole.outputs["vdot"]}
    return Program("batch_dynamics", whole.inputs, outputs, whole.guards, whole.sections, whole.origins)


def content(chain: Chain, baked: bool, constants: int, states: int, place: Place) -> dict:
    """The templates' context.

    ``constants`` are the members of a link's struct, ``states`` those of a scenario in a step, ``place`` is that of the
    fused function.
    """
    program = dynamics(chain, baked)
    angles = angles_of(program)
    turned = ("sin_q", "cos_q") if angles else ()
    pointers = ("c", "state", "input", "work", "output", *turned, KEPT)
    placed = piece_place(chain, KEPT, {"m_eta": lambda k: f"work->m_eta[{k}]"}, place)
    found = bodies(lambda piece: LaneWriter(piece, placed, None, {*pointers, "bad"}, True), program, pointers, LONGEST)
    return (
        found
        | {
            "memory": _memory(chain, baked, place),
            "angles": angles,
            "stack": _stack(chain, constants, states, found["kept"], angles),
        }
        | {"moves_of": lanes(chain, FunctionOfLanes)}
    )


def _memory(chain: Chain, baked: bool, place: Place) -> dict | None:
    """What finds the rates of internal states of forces, with the coordinates whose sines it needs."""
    if not chain.n_force_states:
        return None
    program = force_rates(chain, "baked" if baked else "constants")
    angles = angles_of(program)
    pointers = ("c", "state", "input", "start", "dt", *("sin_q", "cos_q") * bool(angles), KEPT, "rate")
    own = {"start": entries("start"), "rate": entries("rate"), "h": lambda k: "dt"}
    placed = piece_place(chain, KEPT, own, place)
    writer = lambda piece: LaneWriter(piece, placed, None, {*pointers, "bad"}, True)  # noqa: E731
    return bodies(writer, program, pointers, LONGEST) | {"angles": angles}


def _stack(chain: Chain, constants: int, states: int, kept: int, angles: list[int]) -> int:
    """The size in bytes of a group of scenarios, for the widest lanes."""
    given, inertia = max(chain.n_given, 1), max(chain.n_inertia, 1)
    state, joints = max(chain.nq, 1) + max(chain.nvz, 1) + turns(chain), max(chain.q_offset[-1], 1)
    group = 3 + chain.n * constants + 4 * inertia + given + states * state + state // 2 + joints + 6 * chain.n + 3
    return LANE_BYTES * (group + kept + 2 * joints * bool(angles))


def angles_of(program: Program) -> list[int]:
    """The coordinates of which a program needs sine or cosine."""
    return sorted({angle for node in program.nodes if (angle := _angle(node)) is not None})


def _angle(node: Node) -> int | None:
    """The coordinate of which a node is the sine or cosine."""
    if node.op in ("sin", "cos") and node.args[0].op == "input" and node.args[0].args[0] == "q":
        return node.args[0].args[1]
    return None
