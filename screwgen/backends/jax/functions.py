"""The JAX back end: the robot's functions on arrays of JAX, pure and batched by ``jax.vmap``.

``q`` (nq,), ``v``, ``vdot`` (nv,), ``tau`` (n_tau,), ``w_ext`` (n, 6), a row per link, ``p``: the parameters of the
robot file. SI units, radians. JAX cannot raise from inside: where a joint cannot be solved for, every result and every
gradient of a function is NaN.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cache, partial
from typing import Any

import jax
import jax.numpy as jnp

from ...algorithms import fused, tip_programs
from ...algorithms.axis_laws import of_robot
from ...algorithms.law_programs import replayed, spring_stage, stage, state_rate
from ...algorithms.parameter_slopes import BY_P
from ...algorithms.robot_function import RobotFunction, shape
from ...algorithms.robot_functions import BY_NAME, offered
from ...algorithms.robot_programs import force_rates, held_inputs
from ...algorithms.schedule import COLUMNS
from ...arguments import choice
from ...errors import UsageError
from ...integrators import space
from ...integrators.method import Method, Motion
from ...integrators.methods import with_built_in
from ...ir.adjoint import only
from ...ir.program import Program
from ...topology.chain import Chain
from ..lazy import LazyFunctions
from .programs import JaxProgram, Values, straight

PRECISIONS = {"double": jnp.float64, "single": jnp.float32}
STEP, STEP_INPUTS = "modal_midpoint", "q v tau w_ext p dt"
"""The method of the function `step`, which is that of a simulation."""


def functions(
    chain: Chain, precision: str, forward_mode: bool, methods: Iterable[Method], by_p: Sequence[int] = ()
) -> LazyFunctions:
    """The functions by name, each made when it is first asked for; see :meth:`screwgen.Model.jax`."""
    choice(precision, PRECISIONS, "there is no precision")
    if precision == "double" and not jax.config.read("jax_enable_x64"):
        said = "call jax.config.update('jax_enable_x64', True) first, or give precision='single'"
        raise UsageError(f"JAX is set to single precision; {said}")
    own = Own(chain, PRECISIONS[precision], straight if forward_mode else JaxProgram)
    found = with_built_in(methods)
    bodies = {"step": found[STEP], **{f"step_{name}": method for name, method in found.items()}}
    steps = {name: (STEP_INPUTS, partial(own.step, method)) for name, method in bodies.items()}
    made: dict[str, Callable] = {name: partial(own.function, *x) for name, x in own.bodies().items()}
    made |= {name: partial(own.function, *x) for name, x in steps.items()}
    differentiated = own.functions_of_robot() | steps if by_p else {}
    slopes = {n + BY_P: partial(own.function, x, own.by_p(body, by_p)) for n, (x, body) in differentiated.items()}
    return LazyFunctions({**made, **slopes})


class Own:
    """What makes the functions of one robot; ``evaluated`` makes a JAX function of a program."""

    def __init__(self, chain: Chain, real: Any, evaluated: Callable[[Program], Callable]):
        self.chain, self.real = chain, real
        self.sizes: dict[str, tuple[int, ...]] = {
            "q": (chain.nq,),
            "v": (chain.nvz,),
            "vdot": (chain.nvz,),
            "tau": (chain.n_tau,),
            "w_ext": (chain.n, 6),
            "p": (len(fused.parameters(chain.robot)),),
            "dt": (),
        }

        @cache
        def evaluator(maker: Callable[[Chain], Program], outputs: tuple[str, ...]) -> Callable:
            return evaluated(only(maker(chain), outputs))

        self._evaluator, self._evaluated = evaluator, evaluated

    def run(self, maker: Callable[[Chain], Program], outputs: str, given: Values) -> list:
        """Outputs of a program; NaN, gradients included, where one of its guards is not > 0."""
        names = tuple(outputs.split())
        flat = {name: jnp.ravel(x) for name, x in given.items()}
        found, guards = self._evaluator(maker, names)(flat)
        fine = jnp.where(jnp.all(guards > 0), 1, jnp.nan).astype(self.real)
        return [found[name] * fine for name in names]

    def replay(self, program: Program, given: Values) -> dict[str, Any]:
        """The outputs of a program without guards."""
        return self._evaluated(program)(given)[0]

    def function(self, inputs: str, body: Callable[..., Any]) -> Callable:
        """``body`` of the named inputs, converted and checked."""
        names = inputs.split()

        def call(*args: Any, **named: Any) -> Any:
            given = dict(zip(names, args, strict=False)) | named
            if len(args) > len(names) or given.keys() != set(names) or len(given) != len(args) + len(named):
                raise UsageError(f"the arguments are ({', '.join(names)})")
            return compiled({name: self._array(name, given[name]) for name in names})

        compiled = jax.jit(body)
        call.__doc__ = f"``({', '.join(names)})``"
        return call

    def _array(self, name: str, value: Any) -> jax.Array:
        try:
            out = jnp.asarray(value, self.real)
        except (TypeError, ValueError):
            raise UsageError(f"{name} is not an array of numbers") from None
        if out.shape != self.sizes[name]:
            wanted = f"it must be {self.sizes[name]}; take many at a time by jax.vmap"
            raise UsageError(f"{name} has the shape {out.shape}; {wanted}")
        return out

    def bodies(self) -> dict[str, tuple[str, Callable]]:
        """The inputs and the body of all but the steps, by name."""
        own: dict[str, tuple[str, Callable]] = {
            "mass_matrix": ("q p", self._mass_matrix),
            "tip_jacobian": ("q p", self._tip_jacobian),
            "coordinate_rates": ("q v p", self._coordinate_rates),
        }
        if self.chain.closing.rows:
            own["correct"] = "q v p", lambda x: tuple(self.run(tip_programs.correction, "new_q new_v", x))
        return own | self.functions_of_robot()

    def functions_of_robot(self) -> dict[str, tuple[str, Callable]]:
        """Those of the functions that every back end offers."""
        return {row.name: (f"{row.inputs} p", partial(self._results, row)) for row in offered(self.chain)}

    def by_p(self, body: Callable[[Values], Any], chosen: Sequence[int]) -> Callable[[Values], Any]:
        """The derivatives of results by the chosen parameters, which number the last axis."""
        places = jnp.array(chosen, int)
        return lambda x: jax.jacrev(lambda own: body({**x, "p": x["p"].at[places].set(own)}))(x["p"][places])

    def _results(self, row: RobotFunction, x: Values) -> Any:
        """The results of a function of the robot, a tuple where they are several."""
        found = self.run(row.program, " ".join(row.results), x)
        shaped = [y.reshape(shape(of, self.chain)) for y, of in zip(found, row.results.values(), strict=True)]
        return tuple(shaped) if len(shaped) > 1 else shaped[0]

    def _mass_matrix(self, x: Values) -> jax.Array:
        force = lambda vdot: self.run(fused.inertial_force, "force", {**x, "vdot": vdot})[0]  # noqa: E731
        return jax.jacrev(force)(jnp.zeros(self.chain.nvz, self.real))[:, : self.chain.nv]

    def _coordinate_rates(self, x: Values) -> jax.Array:
        return self.run(fused.coordinate_rates, "qdot", x)[0] if self.chain.curved else x["v"][: self.chain.nv]

    def _tip_jacobian(self, x: Values) -> jax.Array:
        """The twist of the last tip, [ω; ṙ] in inertial components, of unit rates."""
        tip_pose = partial(self._results, BY_NAME["tip_pose"])
        pose = lambda q: (tip_pose({**x, "q": q}),) * 2  # noqa: E731
        (turning, moving), (R, _) = jax.jacrev(pose, has_aux=True)(x["q"])
        units = jnp.eye(self.chain.nv, self.chain.nvz, dtype=self.real)
        rates = jax.vmap(lambda v: self._coordinate_rates({**x, "v": v}), out_axes=1)(units)
        spin = jnp.einsum("ijk,kl,mj->iml", turning, rates, R)
        return jnp.concatenate([jnp.stack([spin[2, 1], spin[0, 2], spin[1, 0]]), moving @ rates])

    def step(self, method: Method, x: Values) -> tuple[jax.Array, jax.Array]:
        """Coordinates and rates after a step of dt seconds, the inputs held, efforts within their limits."""
        moves = space.replayed(self.chain, self.replay)
        if self.chain.holds:
            x = {**x, "tau": self.run(held_inputs, "held", x)[0]}
        q, v = method.step(JaxAccelerations(self, x), x["q"], x["v"], x["dt"], moves)
        return q * jnp.where(jnp.all(jnp.isfinite(v)), 1, jnp.nan).astype(self.real), v


class JaxAccelerations:
    """Accelerations at held torques and wrenches: a :class:`~screwgen.integrators.method.Accelerations`."""

    def __init__(self, own: Own, x: Values):
        self.own, self.chain = own, own.chain
        self.given = {name: x[name] for name in ("tau", "w_ext", "p")}
        self.laws = of_robot(self.chain)
        names = [*COLUMNS["eta"], *(name for one in self.laws for name in one.law.constants)]
        values = own.run(fused.modal_properties, " ".join(names), {"p": x["p"]})
        self.properties = dict(zip(names, values, strict=True))

    def explicit(self, q: Any, v: Any) -> Any:
        return self.implicit(q, v, 0.0)

    def implicit(self, q: Any, v: Any, h: Any, there: Motion | None = None) -> Any:
        q_there, v_there = there or (q, v)
        x = q[jnp.array(self.chain.given_places, int)]
        rates, remembering = slice(self.chain.nv - self.chain.n_given, self.chain.nv), []
        rate, later = v[rates], v_there[rates]
        M, K, D = (self.properties[name] for name in COLUMNS["eta"])
        rows, felt, entries = self.chain.springs
        inertia = M + replayed(spring_stage(), {"x": 0.0, "w": 0.0, "h": h, "K": K, "D": D}, _functions)["inertia"]
        springs = {"x": x[felt], "w": rate[felt], "h": h, "K": K[entries], "D": D[entries]}
        force = jnp.zeros_like(x).at[rows].add(replayed(spring_stage(), springs, _functions)["force"])
        for law, coordinates, sides, axes in self.laws:
            at, side = jnp.array(coordinates), jnp.array(sides, self.own.real)
            state = {"side": side, "x": x[at], "w": rate[at], "there": later[at], "h": h}
            state |= {name: self.properties[name] for name in law.constants}
            state |= {"axis": x[jnp.array(axes)]} if axes else {}
            if law in self.chain.internal:
                state |= {"z": v[jnp.array(self.chain.internal[law])]}
                remembering.append((law, at, state))
            found = replayed(stage(law), state, _functions)
            inertia, force = inertia.at[at].add(found["inertia"]), force.at[at].add(found["force"])
        given = {**self.given, "m_eta": inertia, "f_eta": force, "q": q_there, "v": v_there}
        if self.chain.compliant and not isinstance(h, float):
            terms = self.own.run(tip_programs.row_terms, "terms", {"q": q, "v": v, "p": given["p"]})[0]
            over = {
                "terms": terms,
                "h": h,
                "ahead": jnp.asarray(there is not None and there[0] is not q, self.own.real),
            }
            acted = self.own.run(tip_programs.row_wrenches, "acted", {**given, **over})[0]
            given["w_ext"] = acted.reshape(self.chain.n, 6)
        vdot = self.own.run(fused.modal_dynamics, "vdot", given)[0]
        a = vdot[rates]
        out = jnp.concatenate([vdot, jnp.zeros(self.chain.n_internal, vdot.dtype)])
        for law, at, state in remembering:
            found = replayed(state_rate(law), state | {"a": a[at]}, _functions)["rate"]
            out = out.at[jnp.array(self.chain.internal[law])].set(found)
        if self.chain.n_force_states:
            own = self.chain.force_states
            over = {**self.given, "q": q_there, "v": v_there, "start": v[own], "h": jnp.asarray(h, self.own.real)}
            out = out.at[own].set(self.own.run(force_rates, "rate", over)[0])
        return out


def _functions(op: str, x: Any, *more: Any) -> Any:
    """The primitives of laws on arrays."""
    if op == "neg":
        return -x
    return (x > 0).astype(x.dtype) if op == "on" else getattr(jnp, op)(x, *more)
