"""The model of a robot: the front door to all stages of the compiler.

robot file -> Robot -> blocks (per link class) -> programs (per phase) -> schedule -> NumPy, CasADi, C, LaTeX
"""

from __future__ import annotations

import os
from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np

from . import target_files
from .algorithms.dae_functions import dae_names
from .algorithms.scope import derived
from .arguments import Given, choice, parameters_keyword
from .backends.numpy.loop_rows import choose_rows
from .backends.numpy.numeric import Numeric
from .errors import UsageError
from .folder import check_folder, write_folder
from .integrators.method import Method
from .ir.block import Block
from .plugins import Formulation, Plugin, merged, plugins
from .simulation.validity import Validity
from .spec.parameters import coordinate_names, parameters
from .spec.robot import Robot
from .studies.linear import INPUTS, OUTPUTS, LinearModel, linearise
from .topology.chain import Chain
from .version import __version__ as VERSION

if TYPE_CHECKING:
    from .backends.casadi.functions import Made

TARGETS = ("c", "casadi", "latex")
"""What is written unless targets are named."""
UNITS = ("fmu2", "fmu3")
CONSISTENT = "consistent"


class Model:
    """A robot with its derived blocks; every product is made when it is first asked for.

    ``plugins``: those that add to the model, all that are installed if None.
    """

    def __init__(self, robot: Robot, plugins: Sequence[Plugin] | None = None):
        self.robot = robot
        self._given_plugins = plugins
        self.chain = Chain(robot)
        if self.chain.closures:
            choose_rows(self.chain)
        names = coordinate_names(robot)
        self.q_names, self.v_names = list(names.q), list(names.v)
        self.tau_names, self.wrench_names = list(names.tau), list(names.wrench)
        self.parameter_names = [p.name for p in parameters(robot)]
        self.parameter_values = [p.value for p in parameters(robot)]
        self._kept: dict[Hashable, object] = {}

    def once(self, key: Hashable, make: Callable[[], object]):
        """What ``make`` returns; made when ``key`` is first asked for, and kept as long as the model."""
        if key not in self._kept:
            self._kept[key] = make()
        return self._kept[key]

    def made(self, key: Hashable) -> bool:
        """Whether :meth:`once` has made it."""
        return key in self._kept

    @property
    def version(self) -> str:
        """The version of the tool that derived the model."""
        return VERSION

    @property
    def nq(self) -> int:
        """The number of coordinates: joint angles, angles of rotors, then modal coordinates."""
        return self.chain.nq

    @property
    def nv(self) -> int:
        """The number of their rates."""
        return self.chain.nv

    @property
    def n_links(self) -> int:
        """The number of links; one with segments counts as so many."""
        return self.chain.n

    @property
    def n_joints(self) -> int:
        """The number of joint coordinates, the first of `q`."""
        return self.chain.n_joints

    @property
    def n_tau(self) -> int:
        """The number of torques."""
        return self.chain.n_tau

    def blocks(self, link: int) -> dict[str, Block]:
        """The derived blocks of a link by name: those of its class and those of plug-ins."""
        key = self.chain.keys[link]
        more = (blocks for p in self._plugins for blocks in (p.blocks(key), p.common()))
        return merged("block", derived(key), *more)

    @cached_property
    def _plugins(self) -> tuple[Plugin, ...]:
        found = plugins() if self._given_plugins is None else tuple(self._given_plugins)
        merged("attribute", vars(type(self)) | vars(self), *(p.attributes for p in found))
        return found

    if not TYPE_CHECKING:  # so that a checker still sees a name that nothing has

        def __getattr__(self, name: str) -> Any:
            """What plug-ins add, such as ``cauchy_names``."""
            known = {} if name.startswith("_") else merged("attribute", *(p.attributes for p in self._plugins))
            if name not in known:
                raise AttributeError(f"'Model' has no attribute '{name}'", name=name, obj=self)
            return known[name](self)

    @property
    def dae_names(self) -> dict[str, list[str]]:
        """The names of the entries of ``x`` and ``z`` of the DAE form."""
        return dae_names(self.chain)

    @cached_property
    def modal_functions(self) -> Mapping:
        """The CasADi functions by name that steps in NumPy are made of."""
        from .backends.casadi.functions import modal_functions

        return modal_functions(self.chain)

    @cached_property
    def _casadi(self) -> Made:
        from .backends.casadi import functions as casadi
        from .backends.casadi import motion as casadi_motion

        own = (casadi.functions, casadi.dae_functions, casadi_motion.motion_functions)
        integrands = {
            "ode": lambda: casadi.ode(self.chain, found["forward_dynamics"]),
            "dae": lambda: casadi.dae(self.chain, found["assemble"]),
        }
        makers = (make(self.chain) for make in (*own, *(p.casadi for p in self._plugins)))
        found: Made = casadi.Made(merged("CasADi function", *makers, integrands))
        return found

    def casadi(self, methods: Sequence[Method] = ()) -> Mapping:
        """The CasADi functions by name, with ``ode`` and ``dae`` as dictionaries for casadi.integrator.

        Each is made when it is first asked for.  ``step (q, v, tau, w_ext, p, dt) -> (q_next, v_next)`` is a step of
        ``modal_midpoint``, ``step_<method>`` one of :data:`screwgen.integrators.METHODS` or of ``methods``.
        ``tip_jacobian (q, p) -> (J)``: J v is the twist [ω; ṙ] of the last tip in inertial components.
        ``scaling (p) -> (q, v, tau)``: sizes by which an optimisation may divide, so that numbers are of order one.
        """
        from .backends.casadi.motion import steps
        from .integrators.methods import with_built_in

        with_built_in(more := tuple(methods))
        made = lambda: self._casadi.joined(steps(self.chain, more))  # noqa: E731
        return self.once(("casadi", more), made) if more else self._casadi

    def jax(self, precision="double", forward_mode=False, methods: Sequence[Method] = ()) -> Mapping:
        """The functions on arrays of JAX by the names of :meth:`casadi`, pure and jitted; :mod:`.backends.jax`."""
        from .backends.jax import functions

        given = (self.chain, precision, forward_mode, tuple(methods))
        return self.once(("jax", given[1:]), partial(functions, *given))  # type: ignore[return-value]

    def acados(self, form="joint", parameters="runtime", w_ext=False):
        """The model in the fields of acados' ``AcadosModel``, on SX: an :class:`AcadosExport`.

        ``form``: ``"joint"``: x = [q; v] (2 nq), ``f_expl_expr`` and ``f_impl_expr``, z empty; ``"dae"``: x and z of
        :attr:`dae_names`, so that joint wrenches can be constrained, ``f_impl_expr`` alone.  u: the joint torques.
        ``parameters``: ``"runtime"`` (the symbols p) or ``"baked"`` (numbers of the robot file); ``w_ext``: whether the
        external tip wrenches are parameters behind them, link by link [τ; F], or zero.
        Of the DAE the joints drift by the integrator's error; start at ``casadi()["dae_state"](q, v, p)``.
        """
        from .backends.casadi.acados import acados

        return acados(self.chain, self.casadi(), form, parameters, w_ext)

    def linearise(
        self, q, v=None, tau=None, w_ext=None, parameters=None, outputs=OUTPUTS, inputs=INPUTS
    ) -> LinearModel:
        """The linear model about a state, by exact derivatives: A, B, C, D with names, units and operating point.

        ``q`` (nq, or the joints alone), ``v`` (nv), ``tau`` (n_tau), ``w_ext`` (n, 6): zero where left out; loops must
        be closed; ``parameters``: values in the order of ``parameter_names``, or by name those that are not the file's.
        ``outputs``: names of groups or entries out of ``joint_angles``, ``joint_rates``, ``rotor_angles``,
        ``rotor_rates`` (of elastic drives), ``modes``, ``mode_rates``, ``base_pose``, ``base_twist`` (of a floating
        base), ``tip_position``, ``tip_velocity``, ``tip_acceleration`` (inertial frame), ``wrenches`` (of the joints),
        ``base_strain`` (of each link's beam: axial strain; curvature u'', 1/m, which times the distance from the
        neutral axis is the strain that bending adds there; twist); ``inputs``: out of ``torques``, ``tip_wrench``,
        ``wrenches_on_tips``.  A name such as ``forearm.tau`` or ``forearm.w_ext`` stands for all entries below it.
        Raises UsageError, and SingularError that names the joint.
        """
        return linearise(self, q, v, tau, w_ext, parameters, outputs, inputs)

    def validity(self, q, v=None, tau=None, w_ext=None, parameters=None) -> Validity:
        """How far every link is from the limits of the first-order model, in a state.

        ``q`` (nq,), ``v`` (nv,), ``tau`` (n_tau,), ``w_ext`` (n, 6): what is left out is zero; ``parameters``: in
        the order of ``parameter_names``, the file's by default.  Raises SingularError that names the joint.
        """
        v, tau = np.zeros(self.nv) if v is None else v, np.zeros(self.n_tau) if tau is None else tau
        w_ext = np.zeros((self.n_links, 6)) if w_ext is None else w_ext
        return Validity(tuple(self.chain.names), self.numpy(parameters).validity(q, v, tau, w_ext))

    def validity_at_rest(self, q, w_ext=None, parameters=None) -> Validity:
        """The same at rest, with the posture ``q`` (nq,) held against gravity and ``w_ext`` (n, 6)."""
        return Validity(tuple(self.chain.names), self.numpy(parameters).validity_at_rest(q, w_ext))

    @cached_property
    def statics(self):
        """The CasADi function ``(q, w_ext, p) -> (potential, force, stiffness, weight, wrench, tip)`` of rest."""
        from .backends.casadi.linear import statics

        return statics(self.chain)

    def write(
        self,
        folder,
        targets=TARGETS,
        parameters="runtime",
        layout="auto",
        batch=False,
        derivatives=False,
        estimator=False,
        functions: str | Sequence[str] | None = None,
        methods: Sequence[Method] = (),
        mpc: str | os.PathLike | None = None,
        outputs=False,
    ) -> list[str]:
        """Write the targets into ``folder``, each into a folder of its own, and return the files' names.

        ``"fmu2"``, ``"fmu3"``: functional mock-up units, with a binary of this machine where there is a compiler.

        ``parameters``: ``"runtime"`` or ``"baked"`` (folded into the C as numbers); ``layout`` of the C:
        ``"fused"`` (one piece), ``"modular"`` (a function per phase and class) or ``"auto"``; ``batch``: also C
        that steps many scenarios at once; ``derivatives``: also C of those of ``vdot``, steps and joint wrenches;
        ``estimator``: also a Kalman filter in C, with the derivatives that it needs; ``functions``: names of
        :meth:`casadi` to save, or ``"all"``; without it those whose size grows with the number of links alone and
        that do not follow from another; ``methods``: integrators for the C beside the built-in ones; ``mpc``: the file
        of a predictive controller; ``outputs``: also C of what runs report.  Writes all or nothing; refuses folders
        with other files (:class:`UsageError`).
        """
        options = {"parameters": parameters, "layout": layout, "methods": methods}
        more = {"batch": batch, "derivatives": derivatives, "estimator": estimator, "mpc": mpc, "outputs": outputs}
        check_folder(Path(folder))
        makers = {
            "c": lambda: self.c_files(**options, **more),
            "casadi": lambda: self.casadi_files(functions),
            "latex": lambda: target_files.latex_files(self.robot, self._plugins),
        }
        makers |= {t: partial(target_files.unit_files, self, t, **options) for t in UNITS}
        unknown = [t for t in targets if t not in makers]
        if unknown:
            raise UsageError(f"there is no target '{unknown[0]}'; choose {' or '.join(makers)}")
        files = {f"{t}/{name}": data for t in targets for name, data in makers[t]().items()}
        return write_folder(folder, files, tuple(targets))

    def c_files(
        self, parameters="runtime", layout="auto", mpc: str | os.PathLike | None = None, **options
    ) -> dict[str, bytes]:
        """The files of the C target, ``options`` as :meth:`write` takes them.

        Gives a PrecisionWarning where float will not do, raises UsageError where double will not.
        """
        return target_files.c_files(self, mpc, parameters, layout, **options)

    def compile(
        self,
        layout="auto",
        precision="double",
        derivatives=False,
        flags: Sequence[str] = ("-O2",),
        cache: bool | str | os.PathLike = True,
        parameters="runtime",
        methods: Sequence[Method] = (),
    ):
        """The C, compiled and loaded: a :class:`screwgen.runtime.compiled.Compiled`, functions on NumPy arrays.

        ``layout``, ``parameters``, ``derivatives`` and ``methods``: as :meth:`write` takes them; ``precision``:
        ``"double"`` or ``"single"``; ``flags`` of the compiler (CC, else cc); ``cache``: a folder for compiled
        libraries, True for that of the user (SCREWGEN_CACHE, else ``~/.cache/screwgen``), False for none.  Raises
        :class:`ScrewgenError` where there is no compiler.
        """
        from .runtime.compiling import compile_model

        return compile_model(self, layout, precision, derivatives, flags, cache, parameters, methods)

    def mpc(self, file: str | os.PathLike, **options):
        """The predictive controller of a file in generated C: :class:`screwgen.runtime.mpc.Mpc`."""
        from .studies.predictive import controller

        return controller(self, file, **options)

    def casadi_files(self, functions: str | Sequence[str] | None = None) -> dict[str, bytes]:
        """The files of the CasADi target: ``functions`` as :meth:`write` takes them, and a README."""
        return target_files.casadi_files(self, self._plugins, functions)

    def __repr__(self) -> str:
        return f"<Model '{self.robot.name}': {self.robot.summary}; q has {self.nq} entries>"

    def _repr_html_(self) -> str:
        """The equations, as a notebook shows them."""
        from .backends.latex import document as latex

        return latex.notebook(self.robot)

    @parameters_keyword
    def numpy(self, parameters: Given = None) -> Numeric:
        """The functions on NumPy arrays, at the file's parameters or at ``parameters``."""
        return Numeric(self.chain, self.chain.parameters.vector(parameters))

    def __reduce__(self) -> tuple[Callable, tuple]:
        """What was said is pickled; the rest is made again from it."""
        return type(self), (self.robot, self._given_plugins)


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
