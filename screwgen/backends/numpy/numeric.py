"""The NumPy back end: every program as a Python function on doubles. It is the reference implementation."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from functools import cached_property, partial
from typing import Any

import numpy as np

from ...algorithms import fused
from ...algorithms.brake_functions import BRAKED
from ...algorithms.dae_functions import DaeFunctions, state_size, unknown_size
from ...algorithms.functions import (
    ASSEMBLY,
    DAE_FORWARD,
    DAE_RATES,
    FORWARD,
    INVERSE,
    LEVERS,
    MEASURING,
    MOTION,
    PLACEMENT,
    PLACES,
    PROJECTION,
    SENSITIVITY,
    Functions,
)
from ...algorithms.gauges import strain_names
from ...algorithms.input_functions import PULLS
from ...algorithms.inverse_slopes import Slopes, of_numbers, symmetric
from ...algorithms.linearise import closed_slopes, slopes
from ...algorithms.marker_functions import STRAINED
from ...algorithms.parameter_slopes import BY_P
from ...algorithms.robot_function import RobotFunction, results
from ...algorithms.robot_functions import known
from ...algorithms.schedule import Algorithm
from ...arguments import Loads, Numbers, array
from ...errors import ScrewgenError, SingularError
from ...ir.program import Program
from ...spec.parameters import parameters
from ...topology.chain import Chain
from . import by_p, prescribed
from .braked import balance
from .internal_rates import with_internal_rates
from .python import Function, compiled
from .rates import ValuesPerRate

ELSEWHERE = 7
"""The seed of a posture in which no axes are in line."""
EPSILON = float(np.finfo(float).eps)
SPRINGS = ("K", "K_q", "K_below", "K_theta", "K_gear", "stop_K")
"""Constants of springs: their forces are no part of the mass matrix and would swamp it."""

_COMPILED: dict[int, tuple[Program, Function]] = {}


def function_of(program: Program) -> Function:
    """The Python function of a program, compiled once."""
    if id(program) not in _COMPILED:
        _COMPILED[id(program)] = (program, compiled(program))
    return _COMPILED[id(program)][1]


def singular(chain: Chain, link: int, p: Numbers | None = None) -> SingularError:
    """The error of a link that cannot be solved for: of its posture, or of all of them if another one has it too.

    ``p``: the parameters, by default the file's values.
    """
    if chain.keys[link].floats:
        return chain.singular(link)
    other = Numeric(chain, p)
    other._failure = Chain.singular
    q, rng = np.array(chain.home, float), np.random.default_rng(ELSEWHERE)
    q[list(chain.axis_places)] += rng.uniform(-1.0, 1.0, len(chain.axis_places))
    try:
        other.forward_dynamics(q, np.zeros(chain.nv), None, None)
    except ScrewgenError as error:
        if str(error) == str(chain.singular(link)):
            return chain.unresisted(link)
    return chain.singular(link)


class Numeric:
    """The functions of a robot on NumPy arrays; ``p`` is the parameter vector (default: the file's values).

    ``q`` (nq,), ``v``, ``vdot`` (nv,), ``tau`` (n_tau,), ``w_ext`` (n, 6), ``x`` as :func:`state_size` says; None is
    zero.  Raises :class:`UsageError` on other shapes, :class:`SingularError` naming the link whose joint is singular.
    """

    def __init__(self, chain: Chain, p: Numbers | None = None):
        self.chain = chain
        self.p = [x.value for x in parameters(chain.robot)] if p is None else [float(x) for x in p]
        self._made: dict[tuple[Algorithm, ...], DaeFunctions] = {}
        self._whole: dict[object, Program] = {}
        self._failure: Callable[[Chain, int], SingularError] = partial(singular, p=self.p)

    @cached_property
    def constants(self) -> list[dict[str, list[float]]]:
        """``M_eta``, ``K``, ``D`` of every link: of its modes; ``M_q``, ``K_q``, ``D_q``: of a sprung joint."""
        return self._prepared(())

    def _prepared(self, algorithms: Sequence[Algorithm]) -> list[dict[str, list[float]]]:
        evaluate = lambda _, program, given: function_of(program)(given, EPSILON)[0]  # noqa: E731
        return fused.prepared(self.chain, self.p, evaluate, algorithms)

    def _functions(self, *algorithms: Algorithm) -> DaeFunctions:
        """The functions that run these algorithms alone: others need not be traced for their constants."""
        if algorithms not in self._made:
            constants = self._prepared((*algorithms, MOTION) if self.chain.acts_on_tips else algorithms)
            world = fused.world(self.chain, self.p)
            self._made[algorithms] = DaeFunctions(self.chain, constants, world, self._apply)
        return self._made[algorithms]

    def _apply(
        self, link: int, _: int, program: Program, inputs: Mapping[str, Sequence[float]]
    ) -> dict[str, list[float]]:
        try:
            outputs, guards = function_of(program)(inputs, EPSILON)
        except (ZeroDivisionError, ValueError):  # a quotient, a root
            guards = [0.0]
        if not all(g > 0 for g in guards):
            raise self._failure(self.chain, link)
        return outputs

    def whole(self, key: object, program: Callable[[], Program], inputs: Mapping[str, Sequence]) -> dict[str, list]:
        """The outputs of a program of the whole robot, which is made once for ``key``; see :meth:`_apply`."""
        if key not in self._whole:
            self._whole[key] = program()
        made = self._whole[key]
        outputs, guards = function_of(made)(inputs, EPSILON)
        for guard, link in zip(guards, made.origins, strict=True):
            if not guard > 0:
                raise self._failure(self.chain, link)
        return outputs

    def step_by_p(
        self, q: Numbers, v: Numbers, tau: Loads, w_ext: Loads, dt: float, of: by_p.Chosen = "*", **method: Any
    ) -> tuple[np.ndarray, np.ndarray]:
        """The derivatives of a step, of ``modal_midpoint`` or of ``method=``, by parameters; see :mod:`.by_p`."""
        return by_p.of_step(self, q, v, tau, w_ext, dt, of, **method)

    @property
    def _closing(self) -> tuple[Algorithm, ...]:
        """The algorithms that loops and what acts on tips need besides."""
        acted = self.chain.closing.rows or self.chain.acts_on_tips
        return (FORWARD, MOTION, DAE_FORWARD, PLACEMENT) if acted else ()

    @property
    def _exerting(self) -> tuple[Algorithm, ...]:
        """The algorithms that the forces of inputs need."""
        return (PULLS, INVERSE) if self.chain.inputs_load_links else (PULLS,)

    def __getattr__(self, name: str) -> Callable:
        """The functions of :data:`~screwgen.algorithms.robot_functions.FUNCTIONS`, by name, and as
        ``forward_dynamics_by_p(q, v, tau, w_ext, of="arm.*")`` their derivatives by parameters, see :mod:`.by_p`."""
        functions, plain = known(self.chain) if "chain" in self.__dict__ else {}, name.removesuffix(BY_P)
        if plain not in functions:
            raise AttributeError(f"'Numeric' has no attribute '{name}'", name=name, obj=self)
        row = functions[plain].of(self.chain)
        return partial(self._results, row) if plain == name else partial(by_p.of_function, self, row)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *known(self.chain)]

    def _results(self, row: RobotFunction, *given: Loads, **more: Loads) -> Any:
        """The results of a function of the robot: arrays, numbers, a tuple where they are several."""
        arguments = dict(zip(row.names, given, strict=False)) | more
        values = dict(zip(row.names, self.rows(**{x: arguments.pop(x, None) for x in row.names}), strict=True))
        if arguments or len(given) > len(row.names):
            raise TypeError(f"the arguments of {row.name} are ({', '.join(row.names)})")
        closing = self._closing if "tau" in values else ()
        found = row.program.body(self._functions(*row.algorithms, *closing), **values)
        return results(row, self.chain, np.array([x for name in row.results for x in found[name]], float))

    def strain_slopes(self) -> np.ndarray:
        """(strains, n_modes): the strains per unit of each modal coordinate, in which they are linear."""
        units = np.eye(self.chain.nq)[self.chain.eta_q :]
        found = [self._functions(STRAINED).strains(unit) for unit in units.tolist()]
        return np.array(found, float).reshape(len(units), len(strain_names(self.chain))).T

    def gaps(self, q: Numbers, v: Numbers | None) -> tuple[np.ndarray, np.ndarray]:
        """The gaps (rows,) of the loops, m or differences of cosines, and their rates."""
        gap, rate = self._functions(MOTION).gaps(*self.rows(q=q, v=v))
        return np.array(gap, float), np.array(rate, float)

    def gap_slopes(self, q: Numbers) -> np.ndarray:
        """(rows, nv): the rates of the gaps per unit of each entry of v."""
        return self.by_rates(lambda functions, q, v: functions.gaps(q, v)[1], q)

    def offsets(self, q: Numbers) -> np.ndarray:
        """Differences of points, m, and of directions that vanish where all loops are closed, and only there."""
        found = self._functions(MOTION).offsets(*self.rows(q=q, v=None))
        return np.array([x for loop in found for x in (*loop.places, *loop.turns)], float)

    def offset_slopes(self, q: Numbers) -> np.ndarray:
        """(offsets, nv): the rates of :meth:`offsets` per unit of each entry of v."""
        rates = lambda found: [x for loop in found for x in (*loop.place_rates, *loop.turn_rates)]  # noqa: E731
        return self.by_rates(lambda functions, q, v: rates(functions.offsets(q, v)), q)

    def mismatch(self, q: Numbers) -> np.ndarray:
        """(loops, 2): how far the frames of each loop are apart where its joint does not let them, in m, and how far
        turned, in rad; of an angle θ it is 2 sin(θ/2)."""
        found = self._functions(MOTION).offsets(*self.rows(q=q, v=None))
        return np.array([[np.linalg.norm(np.array(x, float)) for x in loop[:2]] for loop in found]).reshape(-1, 2)

    def by_rates(self, rates: Callable, q: Numbers) -> np.ndarray:
        """Rates that are linear in v, by one pass with units of all its entries."""
        (values,) = self.rows(q=q)
        units = [ValuesPerRate(unit) for unit in np.eye(self.chain.nv)]
        functions = copy(self._functions(MOTION))
        functions.given = [0.0] * self.chain.n_inertia, [0.0] * self.chain.n_given  # forces are not linear in v
        found = rates(functions, values, units)
        return np.array([x.entries if isinstance(x, ValuesPerRate) else [0.0] * len(units) for x in found])

    def validity_at_rest(self, q: Numbers, w_ext: Loads = None) -> np.ndarray:
        """The measures (n, 4) with joints and modes held at ``q`` (nq,) against gravity and ``w_ext`` (n, 6)."""
        functions = self._functions(INVERSE, MEASURING)
        return np.array(functions.measures_at_rest(*self.rows(q=q, w_ext=w_ext)), float).reshape(self.chain.n, -1)

    def mass_matrix(self, q: Numbers) -> np.ndarray:
        """``M`` (nv, nv): what accelerations of one demand beyond what the arm at rest does, by one pass for all."""
        nv, (q, rest, w_ext) = self.chain.nv, self.rows(q=q, v=None, w_ext=None)
        still = self._functions(INVERSE).alone()
        stiff = still.constants
        still.constants = [dict(c) | {name: [0.0] * len(c[name]) for name in SPRINGS if name in c} for c in stiff]
        units = [ValuesPerRate(unit) for unit in np.eye(nv, nv + 1)]  # the last of the motions is rest
        found = still.inverse_dynamics(q, rest, units, w_ext)
        efforts = np.array([x.entries if isinstance(x, ValuesPerRate) else np.full(nv + 1, x) for x in found])
        efforts = efforts.reshape(nv, nv + 1)
        return efforts[:, :-1] - efforts[:, -1:]

    def derivatives(
        self, q: Numbers, v: Numbers, tau: Loads, w_ext: Loads
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Partial derivatives of ``vdot`` with q (nvz, nv), v (nvz, nvz), tau (nvz, n_tau); of poses `pose exp(δ)`."""
        given = self._by_inputs(q, v, tau)
        if self.chain.closing.rows:
            return self._closed_derivatives(given, *self.rows(q=q, v=v, tau=tau, w_ext=w_ext))
        vdot, _ = self.forward_dynamics(q, v, tau, w_ext)
        f = self._slopes(q, v, vdot, w_ext, tau)
        M, *forces = prescribed.set_apart(self.chain, symmetric(f.M), -f.f_q, -np.hstack([f.f_v, f.f_z]), given)
        by = balance(self, M, q, v, vdot, tau, w_ext).changes(*forces)
        return with_internal_rates(self, f, (q, v, tau), np.hstack(by))

    @property
    def braking(self) -> Functions:
        """The functions of the rows that brakes act on."""
        return self._functions(FORWARD, INVERSE, LEVERS, BRAKED, *self._closing)

    def _by_inputs(self, q: Numbers, v: Numbers, tau: Loads) -> np.ndarray:
        """(nv, n_tau): the generalised forces per unit of each input."""
        chain = self.chain
        out = np.zeros((chain.nv, chain.n_tau))
        out[:, : chain.n_joints] = np.eye(chain.nv)[:, chain.effort_places] * self.levers(q)
        out[list(chain.elastic_travels.values()), list(chain.elastic_travels)] = 1.0
        exerted = self._functions(*self._exerting).exerted(*self.rows(q=q, v=v, tau=tau))
        out[:, chain.n_joints :] = np.array(exerted, float).reshape(chain.n_tau - chain.n_joints, chain.nv).T
        return out

    def _closed_derivatives(
        self, given: np.ndarray, q: Sequence[float], v: Sequence[float], tau: Sequence[float], w_ext: Sequence[float]
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The same where loops close the tree: ``M dvdot - Jᵀ dλ = given dτ - df`` and ``J dvdot = -d(J vdot)``."""
        functions = self._functions(FORWARD, MOTION, INVERSE, SENSITIVITY)
        vdot, f, rows = closed_slopes(functions, q, v, tau, w_ext)
        f, J = of_numbers(f), rows.J.astype(float)
        inertia, others = symmetric(f.M), f.f_z.shape[1] + given.shape[1]
        drifts = [rows.by_q, rows.by_v, np.zeros((len(J), others))]
        inertia, *forces = prescribed.set_apart(self.chain, inertia, -f.f_q, np.hstack([-f.f_v, -f.f_z]), given)
        equations = balance(self, inertia, q, v, vdot, tau, w_ext)
        unconstrained = np.hstack(equations.changes(*forces))
        reach = equations.solve(J.T)
        reach[prescribed.places(self.chain)] = 0.0
        found = unconstrained - reach @ self.row_forces(J @ reach, J @ unconstrained + np.hstack(drifts).astype(float))
        return with_internal_rates(self, f, (q, v, tau), found)

    def row_forces(self, A: np.ndarray, b: np.ndarray) -> np.ndarray:
        """X (rows, n) of ``A X = b`` with ``A = J M⁻¹ Jᵀ`` of the loops' rows, as the dynamics solve for their forces.

        Raises SingularError where rows depend on each other that do not share what they bear.
        """
        return np.array(self._functions(MOTION).solve_rows(A, b.T.tolist()), float).reshape(-1, len(A)).T

    def slopes(
        self, q: Numbers, v: Numbers, vdot: Numbers | None, w_ext: Loads, tau: Loads = None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The mass matrix and the partial derivatives of the inverse dynamics with q and rates, (nv, nv) each.

        ``tau`` counts where drives have transmissions: what their efforts do changes with the posture.
        """
        found = self._slopes(q, v, vdot, w_ext, tau)
        return symmetric(found.M), found.f_q, found.f_v

    def _slopes(self, q: Numbers, v: Numbers, vdot: Numbers | None, w_ext: Loads, tau: Loads) -> Slopes:
        q, v, vdot, w_ext, tau = self.rows(q=q, v=v, vdot=vdot, w_ext=w_ext, tau=tau)
        return of_numbers(slopes(self._functions(INVERSE, SENSITIVITY), q, v, vdot, w_ext, tau))

    def tip_poses(self, q: Numbers) -> tuple[np.ndarray, np.ndarray]:
        """Rotations (n, 3, 3) and positions (n, 3) of the tip frames in the inertial frame."""
        return self._stacked(self._functions(PLACES).poses(*self.rows(q=q))[1])

    # DAE form ---------------------------------------------------------------------------------

    @property
    def dae_functions(self) -> DaeFunctions:
        """The functions of the DAE form's rates."""
        return self._functions(DAE_FORWARD, DAE_RATES, *self._closing)

    def dae_state(self, q: Numbers, v: Numbers) -> np.ndarray:
        """The state ``x`` of the DAE form on the joints."""
        return np.array(self._functions(PLACEMENT).place(*self.rows(q=q, v=v)))

    def dae_rates(self, x: Numbers, tau: Loads, w_ext: Loads) -> tuple[np.ndarray, np.ndarray]:
        """``xdot`` and the joint wrenches (n, 6), by block elimination."""
        xdot, _, wrench = self.dae_functions.rates(*self.rows(x=x, tau=tau, w_ext=w_ext))
        return np.array(xdot), np.array(wrench).reshape(self.chain.n, 6)

    def project(self, x: Numbers) -> np.ndarray:
        """``x`` taken back onto the joints."""
        return np.array(self._functions(PROJECTION, *self._closing).project(*self.rows(x=x)))

    def assemble(self, x: Numbers, tau: Loads, w_ext: Loads) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """``M_sys`` (dense), ``H_sys`` and ``W_sys``, rows and columns in the paper's order."""
        entries, H, W = self._functions(ASSEMBLY, *self._closing).assemble(*self.rows(x=x, tau=tau, w_ext=w_ext))
        M = np.zeros((unknown_size(self.chain),) * 2)
        M[tuple(np.array(list(entries)).T)] = np.array(list(entries.values()), float)
        return M, np.array(H), np.array(W)

    def dae_forward_dynamics(self, q: Numbers, v: Numbers, tau: Loads, w_ext: Loads) -> tuple[np.ndarray, np.ndarray]:
        """``vdot`` and the joint wrenches (n, 6) through the DAE form."""
        q, v, tau, w_ext = self.rows(q=q, v=v, tau=tau, w_ext=w_ext)
        _, vdot, wrench = self.dae_functions.rates(self._functions(PLACEMENT).place(q, v), tau, w_ext)
        return np.array(vdot), np.array(wrench).reshape(self.chain.n, 6)

    def rows(self, **given: Loads) -> list[list[float]]:
        """Arrays of the right shapes, flat; zeros for None, and for internal states that ``v`` or ``vdot`` lacks."""
        sizes = _sizes(self.chain)
        given |= {name: self.chain.with_internal(given[name]) for name in ("v", "vdot") if name in given}
        return [array(x, name, sizes[name], finite=False).ravel().tolist() for name, x in given.items()]

    def _stacked(self, places: Sequence[tuple[Sequence[float], Sequence[float]]]) -> tuple[np.ndarray, np.ndarray]:
        return np.array([R for R, _ in places]).reshape(-1, 3, 3), np.array([r for _, r in places])


def _sizes(chain: Chain) -> dict[str, tuple[int, ...]]:
    """The shapes of the functions' arguments, by name."""
    of_states = {"q": (chain.nq,), "v": (chain.nvz,), "vdot": (chain.nvz,), "x": (state_size(chain),)}
    return of_states | {"tau": (chain.n_tau,), "w_ext": (chain.n, 6)}
