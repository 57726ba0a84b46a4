"""The model of a robot: the front door to all stages of the compiler.

robot file -> Robot -> blocks (per link class) -> programs (per phase) -> schedule -> NumPy, CasADi, C, LaTeX
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, overload

from . import target_files
from .arguments import Given, Loads, Numbers, choice
from .backends.equations.equations import Equations
from .backends.equations.make import OPERATIONS, equations
from .beside import beside
from .errors import UsageError
from .folder import check_folder, write_folder
from .integrators.method import Method
from .plugins import Formulation, merged, plugins
from .robot_model import RobotModel
from .simulation.validity import Validity, validity, validity_at_rest
from .spec.robot import Robot
from .studies.linear import INPUTS, OUTPUTS, LinearModel, linearise

if TYPE_CHECKING:
    from .algorithms.measurement import Measurement
    from .identification.regressor import Regressor
    from .runtime.compiled import Compiled
    from .runtime.mpc import CompiledMpc

TARGETS = ("c", "casadi", "latex")
"""What is written unless targets are named."""
UNITS = ("fmu2", "fmu3")
FEEDFORWARD = "feedforward"
FURTHER = (*UNITS, FEEDFORWARD)
"""What is written where it is named."""
CONSISTENT = "consistent"
DOCUMENTS = "documents"


class Model(RobotModel):
    """A robot with its derived blocks, and by name what one does with it: each method is that of a module.

    Every product is made when it is first asked for. ``plugins``: those that add to the model, all that are installed
    if None.
    """

    def linearise(
        self,
        q: Numbers,
        v: Numbers | None = None,
        tau: Loads = None,
        w_ext: Loads = None,
        parameters: Given = None,
        outputs: Sequence[str] | str = OUTPUTS,
        inputs: Sequence[str] | str = INPUTS,
    ) -> LinearModel:
        """The linear model about a state, by exact derivatives: A, B, C, D with names, units and operating point.

        ``q`` (nq, or the joints alone), ``v`` (nv), ``tau`` (n_tau), ``w_ext`` (n, 6): zero where left out; loops must
        be closed; ``parameters``: values in the order of ``parameter_names``, or by name those that are not the file's.
        ``outputs``: names of groups or entries out of ``joint_angles``, ``joint_rates``, ``rotor_angles``,
        ``rotor_rates`` (of elastic drives), ``modes``, ``mode_rates``, ``base_pose``, ``base_twist`` (of a floating
        base), ``tip_position``, ``tip_velocity``, ``tip_acceleration`` (inertial frame), ``wrenches`` (of the joints),
        ``base_strain`` (of each link's beam: axial strain; curvature u'', 1/m, which times the distance from the
        neutral axis is the strain that bending adds there; twist), ``strain`` (the same also at markers); ``inputs``:
        out of ``torques``, ``tip_wrench``, ``wrenches_on_tips``.  A name such as ``forearm.tau`` or ``forearm.w_ext``
        stands for all entries below it.
        Raises UsageError, and SingularError that names the joint.
        """
        return linearise(self, q, v, tau, w_ext, parameters, outputs, inputs)

    def validity(
        self, q: Numbers, v: Numbers | None = None, tau: Loads = None, w_ext: Loads = None, parameters: Given = None
    ) -> Validity:
        """How far every link is from the limits of its model, in a state.

        ``q`` (nq,), ``v`` (nv,), ``tau`` (n_tau,), ``w_ext`` (n, 6): what is left out is zero; ``parameters``: in
        the order of ``parameter_names``, the file's by default.  Raises SingularError that names the joint.
        """
        return validity(self, q, v, tau, w_ext, parameters)

    def validity_at_rest(self, q: Numbers, w_ext: Loads = None, parameters: Given = None) -> Validity:
        """The same at rest, with the posture ``q`` (nq,) held against gravity and ``w_ext`` (n, 6)."""
        return validity_at_rest(self, q, w_ext, parameters)

    def regressor(self, of: str | Sequence[str] = "*") -> Regressor:
        """The matrix ``Y`` of a motion by the parameters in which its forces are linear: ``Y @ values + rest``.

        ``of``: names of parameters, or patterns as ``arm.*``, out of which those are chosen; first moments and inertias
        about points stand in place of centres of mass. Base parameters are :attr:`.Regressor.base_parameters`.
        Raises UsageError where a pattern names none, and for loops.
        """
        from .identification.regressor import Regressor

        return self.once(("regressor", tuple([of] if isinstance(of, str) else of)), lambda: Regressor(self, of))

    def equations(self, operations: int = OPERATIONS) -> Equations:
        """The equations of motion entry by entry, ``M(q) qddot + C(q, qdot) qdot + D qdot + K q + g(q) = tau``.

        Expressions of sympy in closed form, derived from the programs of the robot: an :class:`Equations` with the
        matrices, symbols and values of parameters; it shows itself in text and in notebooks. Parameters that the file
        states as zero are left out. ``operations``: how many all entries may take. Raises UsageError for robots whose
        equations are larger, with their size, and for loops, quaternions, transmissions and stops.
        """
        return self.once(("equations", operations), lambda: equations(self.chain, operations))

    def write(
        self,
        folder: str | os.PathLike[str],
        targets: Sequence[str] = TARGETS,
        parameters: str = "runtime",
        layout: str = "auto",
        batch: bool = False,
        derivatives: bool = False,
        estimator: bool | Sequence[str | Measurement] = False,
        functions: str | Sequence[str] | None = None,
        methods: Sequence[Method] = (),
        mpc: str | os.PathLike | None = None,
        outputs: bool = False,
        by_p: str | Sequence[str] = (),
        estimate: str | Sequence[str] = (),
    ) -> list[str]:
        """Write the targets into ``folder``, each into a folder of its own, and return the files' names.

        ``"fmu2"``, ``"fmu3"``: functional mock-up units, with a binary of this machine where there is a compiler.
        ``"feedforward"``: C of the efforts of joint motions, see :func:`screwgen.feedforward`.

        ``parameters``: ``"runtime"`` or ``"baked"`` (folded into the C as numbers); ``layout`` of the C:
        ``"fused"`` (one piece), ``"modular"`` (a function per phase and class) or ``"auto"``; ``batch``: also C
        that steps many scenarios at once; ``derivatives``: also C of those of ``vdot``, steps and joint wrenches;
        ``estimator``: also a Kalman filter in C, with the derivatives that it needs, of the usual measurements or of
        those that are named, as ``gyro@boom.tip``; ``functions``: names of
        :meth:`casadi` to save, or ``"all"``; without it those whose size grows with the number of links alone and
        that do not follow from another; ``methods``: integrators for the C beside the built-in ones; ``mpc``: the file
        of a predictive controller; ``outputs``: also C of what runs report and sensors measure, and of units these
        as outputs; ``by_p``: names of parameters, or patterns as ``arm.*``: also C of the derivatives of dynamics,
        outputs and steps by these; ``estimate``: such names: a filter that also finds these parameters.  Writes all or
        nothing; refuses folders with other files (:class:`UsageError`).
        """
        options: dict[str, Any] = {"parameters": parameters, "layout": layout, "methods": methods}
        more: dict[str, Any] = {
            "batch": batch,
            "derivatives": derivatives,
            "estimator": estimator,
            "mpc": mpc,
            "outputs": outputs,
            "by_p": by_p,
            "estimate": estimate,
        }
        check_folder(Path(folder))
        makers = {
            "c": lambda: self.c_files(**options, **more),
            "casadi": lambda: self.casadi_files(functions),
            "latex": lambda: self._documents(),
        }
        makers |= {t: partial(target_files.unit_files, self, t, **options, sensors=outputs) for t in UNITS}
        makers[FEEDFORWARD] = lambda: target_files.feedforward_files(self, **options)
        unknown = [t for t in targets if t not in makers]
        if unknown:
            raise UsageError(f"there is no target '{unknown[0]}'; choose {' or '.join(makers)}")
        files = {f"{t}/{name}": data for t in targets for name, data in makers[t]().items()}
        return write_folder(folder, files, tuple(targets))

    def _documents(self) -> dict[str, bytes]:
        """The documents, those of a second process within :meth:`documents_beside`."""
        made = self._kept.get(DOCUMENTS)
        return made() if callable(made) else target_files.latex_files(self.robot, self._plugins)

    @contextmanager
    def documents_beside(self) -> Iterator[None]:
        """Within it a second process makes the documents that :meth:`write` writes, see :mod:`.beside`."""
        with beside(lambda: target_files.latex_files(self.robot, self._plugins)) as documents:
            self._kept[DOCUMENTS] = documents
            try:
                yield
            finally:
                del self._kept[DOCUMENTS]

    def c_files(
        self, parameters: str = "runtime", layout: str = "auto", mpc: str | os.PathLike | None = None, **options: Any
    ) -> dict[str, bytes]:
        """The files of the C target, ``options`` as :meth:`write` takes them.

        Gives a PrecisionWarning where float will not do, raises UsageError where double will not.
        """
        return target_files.c_files(self, mpc, parameters, layout, **options)

    def compile(
        self,
        layout: str = "auto",
        precision: str = "double",
        derivatives: bool = False,
        flags: Sequence[str] | None = None,
        cache: bool | str | os.PathLike = True,
        parameters: str = "runtime",
        methods: Sequence[Method] = (),
        by_p: str | Sequence[str] = (),
    ) -> Compiled:
        """The C, compiled and loaded: a :class:`screwgen.runtime.compiled.Compiled`, functions on NumPy arrays.

        ``layout``, ``parameters``, ``derivatives``, ``methods``, ``by_p``: as :meth:`write` takes them; ``precision``:
        ``"double"`` or ``"single"``; ``flags`` of the compiler (CC, else cc), -O2 by default; ``cache``: a folder for
        compiled libraries, True for that of the user (SCREWGEN_CACHE, else ``~/.cache/screwgen``), False for none.
        Raises :class:`ScrewgenError` where there is no compiler.
        """
        from .runtime.compiling import compile_model

        return compile_model(self, layout, precision, derivatives, flags, cache, parameters, methods, by_p)

    def mpc(self, file: str | os.PathLike, **options: Any) -> CompiledMpc:
        """The predictive controller of a file in generated C: :class:`screwgen.runtime.mpc.CompiledMpc`."""
        from .studies.predictive import controller

        return controller(self, file, **options)

    def casadi_files(self, functions: str | Sequence[str] | None = None) -> dict[str, bytes]:
        """The files of the CasADi target: ``functions`` as :meth:`write` takes them, and a README."""
        return target_files.casadi_files(self, self._plugins, functions)


def formulations() -> dict[str, Callable[[Robot], Model | Formulation]]:
    """What makes a model in each formulation, by name: the product's own first, then those of plug-ins."""
    return merged("formulation", {CONSISTENT: Model}, *(p.formulations for p in plugins()))


@overload
def derive(robot: Robot, formulation: Literal["consistent"] = "consistent") -> Model: ...


@overload
def derive(robot: Robot, formulation: str) -> Model | Formulation: ...


def derive(robot: Robot, formulation: str = CONSISTENT) -> Model | Formulation:
    """A robot's model.  Cheap: blocks are derived per link class, when they are needed.

    ``formulation``: ``"consistent"``, derived and equal to Lagrange's equations, or what a plug-in adds:
    ``"printed"``, the paper's equations as they stand, to be looked at beside the other.  Raises UsageError for a
    name that nothing has.
    """
    if formulation == CONSISTENT:
        return Model(robot)
    known = formulations()
    return known[choice(formulation, known, "there is no formulation")](robot)
