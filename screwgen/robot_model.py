"""A robot with what follows from it: the links' classes, names, parameters, blocks, functions, and a cache.

It is data, with functions on arrays, on CasADi's and on JAX's values. What one does with a model, runs, studies, files,
stands in the layers above: functions whose first argument is a :class:`RobotModel`.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, TypeVar, cast

import numpy as np

from .algorithms.dae_functions import dae_names
from .algorithms.gauges import strain_names
from .algorithms.scope import derived
from .arguments import Given
from .backends.numpy.loop_rows import choose_rows
from .backends.numpy.numeric import Numeric
from .integrators.method import Method
from .ir.block import Block
from .plugins import Plugin, merged, plugins
from .spec.parameters import coordinate_names, parameters
from .spec.robot import Robot
from .topology.chain import Chain
from .version import __version__ as VERSION

if TYPE_CHECKING:
    from .backends.casadi.acados import AcadosExport
    from .backends.lazy import LazyFunctions

_T = TypeVar("_T")
KEPT = 16
"""Parameters of a robot for which is kept what follows from them."""


class RobotModel:
    """A robot with its derived blocks; every product is made when it is first asked for.

    ``plugins``: those that add to the model, all that are installed if None.
    """

    compiler_flags: Sequence[str] = ("-O2",)
    """With which its C is compiled where a call does not say."""

    def __init__(self, robot: Robot, plugins: Sequence[Plugin] | None = None):
        self.robot = robot
        self._given_plugins = plugins
        self.chain = Chain(robot)
        choose_rows(self.chain)
        names = coordinate_names(robot)
        self.q_names, self.v_names = list(names.q), list(names.v)
        self.tau_names, self.wrench_names = list(names.tau), list(names.wrench)
        self.marker_names = [m.name for m in self.chain.markers]
        self.force_quantities = {name: x.unit for name, x in self.chain.force_quantities.items()}
        self.parameter_names = [p.name for p in parameters(robot)]
        self.parameter_values = [p.value for p in parameters(robot)]
        self._kept: dict[Hashable, object] = {}

    def once(self, key: Hashable, make: Callable[[], _T]) -> _T:
        """What ``make`` returns; made when ``key`` is first asked for, and kept as long as the model."""
        if key not in self._kept:
            self._kept[key] = make()
        return cast(_T, self._kept[key])

    def once_for(self, key: Hashable, p: np.ndarray, make: Callable[[], _T]) -> _T:
        """What ``make`` returns at parameters ``p`` (n,); kept for a few of them, as where many rests are sought."""
        kept, own = self.once((key, "by parameters"), dict[bytes, _T]), p.tobytes()
        if own not in kept:
            if len(kept) >= KEPT:
                kept.clear()
            kept[own] = make()
        return kept[own]

    def made(self, key: Hashable) -> bool:
        """Whether :meth:`once` has made it."""
        return key in self._kept

    @cached_property
    def strain_names(self) -> list[str]:
        """Of the strains at bases and markers, as `forearm.base_strain.bending_y`."""
        return list(strain_names(self.chain))

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
        merged("attribute", dict.fromkeys(dir(self)), *(p.attributes for p in found))
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
    def _casadi(self) -> LazyFunctions:
        from .backends.casadi import functions as casadi
        from .backends.casadi import steps
        from .backends.lazy import LazyFunctions

        own = (casadi.functions, casadi.dae_functions, steps.motion_functions)
        integrands = {
            "ode": lambda: casadi.ode(self.chain, found["forward_dynamics"]),
            "dae": lambda: casadi.dae(self.chain, found["assemble"]),
        }
        makers = (make(self.chain) for make in (*own, *(p.casadi for p in self._plugins)))
        found: LazyFunctions = LazyFunctions(merged("CasADi function", *makers, integrands))
        return found

    def casadi(self, methods: Sequence[Method] = (), by_p: str | Sequence[str] = ()) -> Mapping:
        """The CasADi functions by name, with ``ode`` and ``dae`` as dictionaries for casadi.integrator.

        Each is made when it is first asked for.  ``step (q, v, tau, w_ext, p, dt) -> (q_next, v_next)`` is a step of
        ``modal_midpoint``, ``step_<method>`` one of :data:`screwgen.integrators.METHODS` or of ``methods``.
        ``tip_jacobian (q, p) -> (J)``: J v is the twist [ω; ṙ] of the last tip in inertial components.
        ``scaling (p) -> (q, v, tau)``: sizes by which an optimisation may divide, so that numbers are of order one.
        ``by_p``: names of parameters, or patterns as ``arm.*``: then also ``<function>_by_p``, derivatives by these.
        """
        from .backends.casadi.by_p import by_parameters
        from .backends.casadi.steps import steps
        from .integrators.methods import with_built_in

        with_built_in(more := tuple(methods))
        found = self.once(("casadi", more), lambda: self._casadi.joined(steps(self.chain, more))) if more else None
        found, chosen = found or self._casadi, self.chain.parameters.chosen(by_p)
        made = lambda: found.joined(by_parameters(self.chain, found, chosen))  # noqa: E731
        return self.once(("casadi", more, chosen), made) if chosen else found

    def jax(
        self,
        precision: str = "double",
        forward_mode: bool = False,
        methods: Sequence[Method] = (),
        by_p: str | Sequence[str] = (),
    ) -> Mapping:
        """The functions on arrays of JAX by the names of :meth:`casadi`, pure and jitted; :mod:`.backends.jax`."""
        from .backends.jax import functions

        given = (self.chain, precision, forward_mode, tuple(methods), self.chain.parameters.chosen(by_p))
        return self.once(("jax", given[1:]), partial(functions, *given))

    def acados(self, form: str = "joint", parameters: str = "runtime", w_ext: bool = False) -> AcadosExport:
        """The model in the fields of acados' ``AcadosModel``, on SX: an :class:`AcadosExport`.

        ``form``: ``"joint"``: x = [q; v] (2 nq), ``f_expl_expr`` and ``f_impl_expr``, z empty; ``"dae"``: x and z of
        :attr:`dae_names`, so that joint wrenches can be constrained, ``f_impl_expr`` alone.  u: the joint torques.
        ``parameters``: ``"runtime"`` (the symbols p) or ``"baked"`` (numbers of the robot file); ``w_ext``: whether the
        external tip wrenches are parameters behind them, link by link [τ; F], or zero.
        Of the DAE the joints drift by the integrator's error; start at ``casadi()["dae_state"](q, v, p)``.
        """
        from .backends.casadi.acados import acados

        return acados(self.chain, self.casadi(), form, parameters, w_ext)

    @cached_property
    def statics(self) -> Callable[..., Any]:
        """The CasADi function ``(q, w_ext, p) -> (potential, force, stiffness, weight, wrench, tip)`` of rest."""
        from .backends.casadi.linear import statics

        return statics(self.chain)

    @cached_property
    def tendon_work(self) -> Callable[..., Any]:
        """The CasADi function ``(q, others, p) -> (work, force, slope)`` of tendons."""
        from .backends.casadi.linear import tendon_work

        return tendon_work(self.chain)

    def __repr__(self) -> str:
        return f"<Model '{self.robot.name}': {self.robot.summary}; q has {self.nq} entries>"

    def _repr_markdown_(self) -> str:
        """Links, and the blocks of the equations of every class of links."""
        from .backends.latex import document as latex

        return latex.notebook(self.robot)

    def numpy(self, parameters: Given = None) -> Numeric:
        """The functions on NumPy arrays, at the file's parameters or at ``parameters``."""
        return Numeric(self.chain, self.chain.parameters.vector(parameters))

    def __reduce__(self) -> tuple[Callable, tuple]:
        """What was said is pickled; the rest is made again from it."""
        return type(self), (self.robot, self._given_plugins)
