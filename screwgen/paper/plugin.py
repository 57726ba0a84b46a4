"""The paper's check as a plug-in: the command `paper`, the printed formulation, the Z-form."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..errors import UsageError
from ..plugins import Plugin, PluginChapter

if TYPE_CHECKING:
    import typer

    from ..robot_model import RobotModel
    from ..spec.link_class import LinkClass
    from ..spec.robot import Robot
    from ..topology.chain import Chain
    from .printed import PrintedModel

NO_TREE = "the Z-form is that of a chain on a fixed base; leave out parent, loops and base"
NO_ROTORS = "the Z-form has no rotors; leave out the stiffness of drives"

Z_FORM = """\
The Z-form of the paper (arXiv:2601.16242v3), with `q` the joint coordinates alone as memory: `x_c` = [θ_1; r_1; θ_2;
r_2; …; η; Z_1; Z_2; …; dη/dt] holds for every link its rotation vector, the position of its origin in its own
components, and Z = [ω; dr/dt]. `exponential` gives R = exp(θ), J with ω = J dθ/dt, and its inverse, which is infinite
from a full turn on (|θ| = 2π: exponential coordinates end there). `cauchy_state` takes coordinates and rates to
`x_c`, with angles from 0 to π; at π, θ and −θ are one rotation, and a motion through it makes θ jump. `z_form` gives
T_γ, Γ\\*, h_Ms, M_dyn and h_dyn of the rows of joints and links; `assemble_z` the whole system with unknowns [w_1;
dZ_1/dt; w_2; dZ_2/dt; …; d²η/dt²]. `cauchy` gives dx_c/dt = A_c x_c + g_c, the rates of the memory, and the joint
wrenches. `J_inverse` and `A_c` are smooth up to that full turn, `cauchy_state` up to that jump."""


# What takes long to import is imported when a hook is called.


def _commands(app: typer.Typer) -> None:
    from .command import add

    add(app)


def _printed(robot: Robot) -> PrintedModel:
    from .printed import PrintedModel

    return PrintedModel(robot)


def _names(model: RobotModel) -> dict[str, list[str]]:
    from .z_functions import cauchy_names

    if not model.chain.serial:
        raise UsageError(f"{model.robot.name}: {NO_TREE}")
    if model.chain.n_added:
        raise UsageError(f"{model.robot.name}: {NO_ROTORS}")
    return cauchy_names(model.chain)


def _blocks(key: LinkClass) -> dict:
    from .z_form_blocks import z_rows_block

    return {"z_rows": z_rows_block(key)}


def _common() -> dict:
    from .z_form_blocks import z_form_block

    return {"z_form": z_form_block()}


def _casadi(chain: Chain) -> dict:
    from .z_casadi import z_functions

    return z_functions(chain) if chain.serial and not chain.n_added else {}


def _chapter(chain: Chain) -> PluginChapter:
    from .z_latex import z_chapter

    return z_chapter(chain)


PLUGIN = Plugin(
    commands=_commands,
    formulations={"printed": _printed},
    attributes={"cauchy_names": _names},
    blocks=_blocks,
    common=_common,
    casadi=_casadi,
    casadi_notes=Z_FORM,
    chapter=_chapter,
    trees=False,
)
