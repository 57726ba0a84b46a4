"""What the laws of what a step holds (:mod:`..elements.held`) depend on."""

from __future__ import annotations

from ..elements import HeldLaw
from ..ir.program import Tracer


def reads_motion(kind: type[HeldLaw]) -> bool:
    """Whether what is held depends on the motion, or on what is remembered of it, not on the input alone."""
    tracer = Tracer()
    remembered = ("z",) * (kind.state is not None)
    tau, x, w, *numbers = (tracer.input(name, 1)[0] for name in ("tau", "x", "w", *remembered, *kind.table()))
    program = tracer.program(kind.KIND, {}, {"held": [kind.held(tracer, tau, x, w, *numbers)]})
    return any(node.op == "input" and node.args[0] in ("x", "w", "z") for node in program.nodes)
