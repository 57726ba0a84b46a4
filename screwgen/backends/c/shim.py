"""The C interface for callers in other languages: one memory block, what is reported, the loop of a run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...algorithms.robot_functions import reported
from ...algorithms.signals import ROBOT
from ...topology.chain import Chain
from .code import literal
from .columns import rendered
from .outputs import length_of

if TYPE_CHECKING:
    from .project import CProject

FILES = ("shim.h", "shim.c", "run_shim.c", "dae_shim.c")
SENSING = "sensors_shim.c"
VIEWS = (
    *(f"state.{name}" for name in ROBOT["state"]),
    *(f"input.{name}" for name in ROBOT["input"]),
    *(f"output.{name}" for name in ROBOT["output"]),
    *(f"motion.{name}" for name in ROBOT["motion"]),
    "dae",
    "measures",
)
"""The members of an instance's memory that callers see, besides what is reported."""
PARTS = 8
"""Steps beside which one that changes the energy of a robot with loops is held."""
CHANGE = 1e-4
"""The change of energy besides the work of the torques, over the largest kinetic energy so far, from which it is."""
ROW = (
    ("m->state.q", "$$_NQ"),
    ("m->state.v", "$$_NV"),
    ("m->input.tau", "$$_NTAU"),
    ("m->output.wrench[0]", "6 * $$_NLINKS"),
    ("m->output.tip_position", "3"),
)
"""What a sample of a run has behind the time, and before what is reported: where it is, and its length."""


def views(chain: Chain) -> tuple[str, ...]:
    """The members of an instance's memory that callers see."""
    return (*VIEWS, *(row.name for row in reported(chain)))


def shims(project: CProject) -> dict[str, str]:
    """The files beside a robot's C, which has outputs, that its shared library is made of."""
    names = FILES + (("derivatives_shim.c",) if project.with_derivatives else ())
    names, chain = names + (("by_p_shim.c",) if project.by_p.chosen else ()), project.chain
    told = [(f"m->{row.name}", length_of(row)) for row in reported(chain)]
    where = [(place, "$$_NVZ" if chain.n_internal and size == "$$_NV" else size) for place, size in ROW]
    values = dict(
        views=views(chain),
        parts=PARTS,
        change=literal(CHANGE),
        remembering=bool(chain.n_internal),
        row=[("&t", "1"), *where, *told],
        computed=[*where[3:], *told],
        given=[*where[:3], ("m->input.w_ext[0]", "6 * $$_NLINKS")],
    )
    return {name: rendered(name, **project.context, **values) for name in names}
