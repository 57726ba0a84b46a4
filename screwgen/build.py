"""From a robot to everything: the compiler's stages in one place.

robot file -> Robot -> blocks (per link class) -> programs (per phase) -> schedule -> NumPy, CasADi, C, LaTeX
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path

from .chain.chain import Chain
from .chain.dae_functions import dae_names
from .chain.scope import common, derived
from .chain.z_functions import cauchy_names
from .derive.block import Block
from .emit.numeric import Numeric
from .errors import UsageError
from .folder import check_folder, write_folder
from .spec.parameters import coordinate_names, parameters
from .spec.robot import Robot
from .version import __version__ as VERSION

TARGETS = ("c", "casadi", "latex")


class Model:
    """A robot with its derived blocks; every product is made when it is first asked for."""

    def __init__(self, robot: Robot):
        self.robot = robot
        self.chain = Chain(robot)
        names = coordinate_names(robot)
        self.q_names, self.v_names = list(names.q), list(names.v)
        self.tau_names, self.wrench_names = list(names.tau), list(names.wrench)
        self.parameter_names = [p.name for p in parameters(robot)]
        self.parameter_values = [p.value for p in parameters(robot)]

    @property
    def version(self) -> str:
        """The version of the tool that derived the model."""
        return VERSION

    @property
    def nq(self) -> int:
        """The number of coordinates: joint angles, then modal coordinates."""
        return self.chain.nq

    @property
    def n_links(self) -> int:
        return self.chain.n

    @property
    def n_joints(self) -> int:
        """The number of joint coordinates, which is the number of torques."""
        return self.chain.n_joints

    def blocks(self, link: int) -> dict[str, Block]:
        """The derived blocks of a link (those of its class, and those that all links share) by name."""
        return derived(self.chain.keys[link]) | common()

    @property
    def dae_names(self) -> dict[str, list[str]]:
        """The names of the entries of ``x`` and ``z`` of the DAE form."""
        return dae_names(self.chain)

    @property
    def cauchy_names(self) -> dict[str, list[str]]:
        """The names of the entries of ``x_c`` and of the unknowns ``q_sys`` of the Z-form."""
        return cauchy_names(self.chain)

    @cached_property
    def _casadi(self) -> Mapping:
        from .emit import casadi, casadi_z

        functions = casadi.functions(self.chain) | casadi.dae_functions(self.chain)
        functions |= casadi_z.z_functions(self.chain)
        return functions | {
            "ode": casadi.ode(self.chain, functions["forward_dynamics"]),
            "dae": casadi.dae(self.chain, functions["assemble"]),
        }

    def casadi(self) -> Mapping:
        """The CasADi functions by name, with ``ode`` and ``dae`` as dictionaries for casadi.integrator."""
        return self._casadi

    def write(
        self, folder, targets=TARGETS, parameters="runtime", layout="auto", batch=False, derivatives=False
    ) -> list[str]:
        """Write the targets into ``folder``, each into a folder of its own, and return the files' names.

        ``parameters``: ``"runtime"`` or ``"baked"`` (folded into the C as numbers); ``layout`` of the C:
        ``"fused"`` (one piece), ``"modular"`` (a function per phase and class) or ``"auto"``; ``batch``: also C
        that steps many scenarios at once; ``derivatives``: also C of those of ``vdot`` with q, v and tau.  Writes
        all or nothing; refuses a folder that holds files it did not write (:class:`UsageError`).
        """
        check_folder(Path(folder))
        makers = {
            "c": lambda: self.c_files(parameters, layout, batch, derivatives),
            "casadi": self._casadi_files,
            "latex": self._latex_files,
        }
        unknown = [t for t in targets if t not in makers]
        if unknown:
            raise UsageError(f"there is no target '{unknown[0]}'; choose {' or '.join(TARGETS)}")
        files = {f"{t}/{name}": data for t in targets for name, data in makers[t]().items()}
        return write_folder(folder, files, tuple(targets))

    def c_files(self, parameters="runtime", layout="auto", batch=False, derivatives=False) -> dict[str, bytes]:
        """The files of the C target."""
        from .emit.c import CProject

        project = CProject(self.chain, VERSION, parameters, layout, batch, derivatives)
        return {name: text.encode() for name, text in project.files().items()}

    def _casadi_files(self) -> dict[str, bytes]:
        from .emit.casadi import casadi_files

        return casadi_files(self.robot, self.casadi(), self.parameter_names, VERSION)

    def _latex_files(self) -> dict[str, bytes]:
        from .emit import latex

        name = self.robot.name
        return {f"{name}.tex": latex.document(self.robot).encode(), f"{name}.html": latex.html(self.robot).encode()}

    def _repr_html_(self) -> str:
        """The equations, as a notebook shows them."""
        from .emit import latex

        return latex.notebook(self.robot)

    def numpy(self, p: Sequence[float] | None = None) -> Numeric:
        """The functions on NumPy arrays, at the file's parameters or at ``p``."""
        return Numeric(self.chain, p)


def derive(robot: Robot) -> Model:
    """Derive a robot's model.  Cheap: blocks are derived per link class, when they are needed."""
    return Model(robot)
