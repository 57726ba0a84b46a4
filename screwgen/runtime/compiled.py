"""The generated C, compiled and loaded: its functions on NumPy arrays."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from functools import cached_property, partial
from typing import Any

import numpy as np

from ..algorithms.dae_functions import state_size, unknown_size
from ..algorithms.robot_function import RobotFunction, entries, results
from ..algorithms.robot_functions import SENSORS, known
from ..arguments import Given, Loads, Numbers, array, choice, seconds, whole
from ..errors import ScrewgenError
from ..integrators.method import Method
from ..integrators.methods import with_built_in
from ..robot_model import RobotModel
from .asked import digest
from .differentiated import CompiledDerivatives
from .forms import Forms, LazyLibrary
from .lean import RuntimeProject
from .library import load
from .memory import Array, LinkMotions, Pair, pointer
from .pace import slices
from .stepper import Stepper


class Compiled(CompiledDerivatives):
    """A robot's C in a shared library.  Arrays are those of the NumPy back end; precision may be single.

    Numbers are copied from the caller's arrays into the structs of the C, and from there into ``out`` or new arrays.
    Arrays of another number type are converted. Arguments may have the shape named or be flat; axes of length 1 do not
    count.  ``q`` (nq,), ``v`` (nv,), ``tau`` (n_tau,), ``w_ext`` (n, 6), ``vdot`` (nv,), ``wrench`` (n, 6),
    ``tip_rotation`` (3, 3), ``tip_position`` (3,) are views of those structs after the last call.

    An instance keeps its state in memory of its own.  Threads may share one: their calls take turns.  To compute at
    the same time, give each a :meth:`fresh` one.  A pickled one is compiled, or found in the cache, again.

    ``cache``: as :func:`.library.load` takes it.  Raises :class:`ScrewgenError` without a C compiler or where a call is
    not OK, :class:`SingularError` naming the link whose joint is singular, and :class:`UsageError` on wrong shapes.
    """

    def __init__(
        self,
        model: RobotModel,
        layout: str = "auto",
        parameters: str = "runtime",
        single: bool = False,
        flags: Sequence[str] = ("-O2",),
        compiler: str | None = None,
        derivatives: bool = False,
        cache: bool | str | os.PathLike = False,
        methods: Sequence[Method] = (),
        by_p: tuple[str, ...] = (),
    ):
        self._arguments = (layout, parameters, single, tuple(flags), compiler, derivatives, cache, tuple(methods), by_p)
        self.model, self.chain, self.single = model, model.chain, single
        self.real = np.dtype(np.float32 if single else np.float64)
        self.methods, self.chosen = with_built_in(methods), self.chain.parameters.chosen(by_p)
        self.with_derivatives = derivatives
        define = [f"-D{self.chain.robot.name.upper()}_REAL_FLOAT"] if single else []
        asked = digest(model.robot, layout, parameters, derivatives, tuple(methods), self.chosen)
        compiled = partial(load, flags=[*flags, *define], compiler=compiler, cache=cache)
        found = lambda part: compiled(lambda: self.project.part(part), asked=asked and f"{part} {asked}")  # noqa: E731
        self.library = Forms(found("joint"), LazyLibrary(lambda: found("dae")))
        self._sensors = LazyLibrary(lambda: found("sensors"))
        self._place()
        self.prepare(None)

    @cached_property
    def project(self) -> RuntimeProject:
        """Of which the sources are written, where the cache does not have what is made of them.

        The model keeps it for both precisions, and for a layout whether or not it was chosen automatically.
        """
        layout, parameters, *_, methods, by_p = self._arguments
        options: dict[str, Any] = {"derivatives": self.with_derivatives, "outputs": True, "by_p": by_p}
        make = lambda: RuntimeProject(self.chain, self.model.version, parameters, layout, methods=methods, **options)  # noqa: E731
        said = parameters, self.with_derivatives, self.chosen, *methods
        asked = self.model.once(("project", layout, *said), make)
        return self.model.once(("project", asked.layout, *said), lambda: asked)

    def __reduce__(self) -> tuple[Callable, tuple]:
        return _compiled_anew, (self.model, self._arguments, self.p)

    def fresh(self, parameters: Given = None) -> Compiled:
        """Another instance with memory of its own in the same library, at ``parameters`` (None: the file's)."""
        out = object.__new__(Compiled)
        out.__dict__.update({k: v for k, v in self.__dict__.items() if k not in ("_scratch", "_prepared_for")})
        out._place()
        out.prepare(parameters)
        return out

    def prepare(self, parameters: Given) -> None:
        """Set the parameters (None: the robot file's values); if they are refused the previous ones remain."""
        values = None if parameters is None else self.chain.parameters.vector(parameters)
        given = None if values is None else values.astype(self.real)
        with self._lock:
            before = self._block.bytes.copy()
            try:
                self.check(self.library.shim_prepare(self.memory, None if given is None else pointer(given)))
            except ScrewgenError:
                self._block.bytes[:] = before
                raise
            self.p = values

    # joint form -------------------------------------------------------------------------------

    def forward_dynamics(
        self,
        q: Numbers,
        v: Numbers,
        tau: Loads = None,
        w_ext: Loads = None,
        form: str = "joint",
        out: Pair | None = None,
    ) -> Pair:
        """``vdot`` (nq,) and the joint wrenches (n, 6); torques and tip wrenches left out are zero."""
        call = self._forward if form == "joint" else self._forward_of(form)
        with self._lock:
            self._set(q, v, tau, w_ext)
            if status := call(self.memory):
                self.check(status)
            if out is None:
                return self.vdot.copy(), self.wrench.copy()
            return self._given(out, self.vdot, self.wrench)

    def _forward_of(self, form: str) -> Callable[..., int]:
        dae = choice(form, ("joint", "dae"), "there is no form") == "dae"
        return self.library.shim_dae_forward if dae else self._forward

    def complete_dynamics(
        self, q: Numbers, v: Numbers, tau: Loads = None, w_ext: Loads = None, form: str = "joint"
    ) -> tuple[Array, Array, Array, Array]:
        """``vdot``, wrenches, rotation (3, 3) and position (3,) of the last tip."""
        call = self._forward_of(form)
        with self._lock:
            self._set(q, v, tau, w_ext)
            self.check(call(self.memory))
            return self.vdot.copy(), self.wrench.copy(), self.tip_rotation.copy(), self.tip_position.copy()

    def validity(self, q: Numbers, v: Numbers, tau: Loads = None, w_ext: Loads = None) -> Array:
        """How far every link is from the limits of the model (n, 4): `derive.validity.MEASURES`."""
        with self._lock:
            self._set(q, v, tau, w_ext)
            self.check(self.library.shim_watched(self.memory))
            return self._measures.copy()

    def accelerations(
        self, q: Numbers, v: Numbers, tau: Loads = None, w_ext: Loads = None, out: Array | None = None
    ) -> Array:
        """``vdot`` alone."""
        with self._lock:
            self._set(q, v, tau, w_ext)
            if status := self._accelerations(self.memory):
                self.check(status)
            return self.vdot.copy() if out is None else self._given((out,), self.vdot)[0]

    def __getattr__(self, name: str) -> Callable:
        """What the C reports, by name: :data:`~screwgen.algorithms.robot_functions.FUNCTIONS`."""
        row = known(self.chain).get(name) if "chain" in self.__dict__ else None
        if row is None or not row.c_file:
            return super().__getattr__(name)
        return partial(self._report, row)

    def _report(
        self, row: RobotFunction, q: Numbers, v: Numbers | None = None, tau: Loads = None, w_ext: Loads = None
    ) -> Any:
        """The results of a function: arrays, numbers, a tuple where they are several."""
        with self._lock:
            self._set(q, self._no_v if v is None else v, tau, w_ext)
            if row.c_file == SENSORS:
                found = np.zeros(max(entries(row, self.chain), 1), self.real)
                self.check(getattr(self._sensors, f"shim_{row.name}")(self.memory, pointer(found)))
                return results(row, self.chain, found[: entries(row, self.chain)])
            self.check(getattr(self.library, f"shim_{row.name}")(self.memory))
            return results(row, self.chain, self._reports[row.name].copy())

    def inverse_dynamics(self, q: Numbers, v: Numbers, vdot: Numbers, w_ext: Loads = None) -> Pair:
        """The generalised forces (nv,) and the joint wrenches (n, 6) of a motion."""
        c = self.chain
        force, wrench = np.zeros(max(c.nv, 1), self.real), np.zeros((c.n, 6), self.real)
        given = self._in(c.with_internal(vdot), (c.nvz,), "vdot")
        with self._lock:
            self._set(q, v, None, w_ext)
            self.check(self.library.shim_inverse(self.memory, *map(pointer, (given, force, wrench))))
        return force[: c.nv], wrench

    def mass_matrix(self, q: Numbers) -> Array:
        """``M`` (nv, nv)."""
        nv, size = self.chain.nv, max(self.chain.nv, 1)
        M = np.zeros((size, size), self.real)
        with self._lock:
            self._set(q, self._no_v)
            self.check(self.library.shim_mass_matrix(self.memory, pointer(M)))
        return M[:nv, :nv]

    def step(
        self, q: Numbers, v: Numbers, tau: Loads, w_ext: Loads, dt: float, method: str | Method = "rk4", count: int = 1
    ) -> Pair:
        """The state after ``count`` steps of the joint form, the input held; long work can be interrupted.

        ``method``: a built-in integrator, or one of those that the model was compiled with.
        """
        step, read = self._stepping(self.library.shim_step, method, dt), lambda: (self.q.copy(), self.v.copy())
        q, v = self._steps(step, count, (q, v), lambda q, v: self._set(q, v, tau, w_ext), read)
        return q, v

    def _stepping(self, call: Callable[..., int], method: str | Method, dt: float) -> Callable[[int], int]:
        """What makes so many steps of the state in memory."""
        number, size = self.number(method), self._real(seconds(dt, "dt"))
        return lambda count: call(self.memory, number, count, size)

    def _steps(
        self, call: Callable[[int], int], count: int, state: tuple, place: Callable, read: Callable[[], tuple]
    ) -> tuple[Array, ...]:
        """The state after steps, in parts between which others may use the memory.

        ``place``: writes a state and the inputs into memory; ``read``: returns the state there.
        """
        for _, part in slices(whole(count, "count", 0)) if count else ((0, 0),):
            with self._lock:
                place(*state)
                if status := call(part):
                    self.check(status)
                state = read()
        return state

    def stepper(
        self, dt: float, method: str | Method = "modal_midpoint", count: int = 1, parameters: Given = None
    ) -> Stepper:
        """Steps that begin and end in arrays of their own: a :class:`.stepper.Stepper`.

        A call makes ``count`` steps of ``dt`` seconds; ``parameters``: those of the robot, None: the file's.
        """
        number, size = self.number(method), self._real(seconds(dt, "dt"))
        return Stepper(self.fresh(parameters), number, whole(count, "count", 1), size)

    # poses and statics ------------------------------------------------------------------------

    def kinematics(self, q: Numbers, v: Numbers | None = None) -> LinkMotions:
        """Poses of all links and of their tips, and the twists of the tips; rates left out are zero."""
        with self._lock:
            self._set(q, self._no_v if v is None else v)
            return self.motion()

    def motion(self) -> LinkMotions:
        """The same of the state in memory."""
        self.check(self.library.shim_kinematics(self.memory))
        return LinkMotions(*(x.copy() for x in self._motion))

    def tip_jacobian(self, q: Numbers) -> Array:
        """``J`` (6, nv): J v is the twist [omega; v] of the last tip, in inertial components."""
        nv = self.chain.nv
        J = np.zeros((6, max(nv, 1)), self.real)
        with self._lock:
            self._set(q, self._no_v)
            self.check(self.library.shim_tip_jacobian(self.memory, pointer(J)))
        return J[:, :nv]

    def gravity(self, q: Numbers, w_ext: Loads = None) -> Pair:
        """The equilibrium at the joint coordinates of ``q``: ``force`` (nv,) and the posture ``q`` (nq,).

        Of a fixed base the first n_joints entries of ``force`` are the torques that hold the arm, those of the modes
        what is left of their forces, N: `<robot>_gravity` of the generated C.  The modes of ``q`` are where the search
        for theirs starts.
        """
        force = np.zeros(max(self.chain.nv, 1), self.real)
        with self._lock:
            self._set(q, self._no_v, None, w_ext)
            self.check(self.library.shim_gravity(self.memory, pointer(force)))
            return force[: self.chain.nv], self.q.copy()

    def loop_mismatch(self, q: Numbers) -> Array:
        """(loops, 2): how far the frames of each loop are apart where its joint does not let them, m, and turned, rad
        (of an angle θ it is 2 sin(θ/2)). Both vanish where loops are closed, and only there."""
        out = np.zeros((len(self.chain.closing.junctions), 2), self.real)
        if self.chain.closing.rows:
            with self._lock:
                self._set(q, self._no_v)
                self.check(self.library.shim_loop_mismatch(self.memory, pointer(out)))
        return out

    def coupling_torques(self, q: Numbers, v: Numbers | None = None, tau: Loads = None, w_ext: Loads = None) -> Array:
        """(n_joints,): the torques with which couplings act on the joint axes, N·m, N on those that slide."""
        out = np.zeros(max(self.chain.n_joints, 1), self.real)
        if self.chain.closing.couplings:
            with self._lock:
                self._set(q, self._no_v if v is None else v, tau, w_ext)
                self.check(self.library.shim_coupling_torques(self.memory, pointer(out)))
        return out[: self.chain.n_joints]

    # DAE form ---------------------------------------------------------------------------------

    def dae_state(self, q: Numbers, v: Numbers) -> Array:
        """The state ``x`` of the DAE form."""
        with self._lock:
            self._set(q, v)
            self.check(self.library.shim_dae_state(self.memory))
            return self.x

    def dae_step(
        self, x: Numbers, tau: Loads, w_ext: Loads, dt: float, method: str | Method = "rk4", count: int = 1
    ) -> Array:
        """``x`` after ``count`` steps of the DAE form, each projected, the input held."""
        x, (tau, w_ext) = array(x, "x", (state_size(self.chain),), finite=False), self._input(tau, w_ext)

        def place(x: Array) -> None:
            self.x, self.tau[:], self.w_ext[:] = x, tau, w_ext

        step = self._stepping(self.library.shim_dae_step, method, dt)
        return self._steps(step, count, (x,), place, lambda: (self.x,))[0]

    def assemble(self, x: Numbers, tau: Loads, w_ext: Loads) -> tuple[Array, Array, Array]:
        """``M_sys`` (dense), ``H_sys`` and ``W_sys``."""
        size, rows, columns = unknown_size(self.chain), *self._pattern()
        values, H, W = np.zeros(len(rows), self.real), np.zeros(size, self.real), np.zeros(size, self.real)
        x, (tau, w_ext) = array(x, "x", (state_size(self.chain),), finite=False), self._input(tau, w_ext)
        with self._lock:
            self.x, self.tau[:], self.w_ext[:] = x, tau, w_ext
            self.check(self.library.shim_assemble(self.memory, *map(pointer, (values, H, W))))
        M = np.zeros((size, size), self.real)
        for j in range(size):
            M[rows[columns[j] : columns[j + 1]], j] = values[columns[j] : columns[j + 1]]
        return M, H, W

    def _pattern(self) -> Pair:
        rows = np.zeros(self.project.context["nnz"], np.int32)
        columns = np.zeros(unknown_size(self.chain) + 1, np.int32)
        self.library.shim_pattern(pointer(rows), pointer(columns))
        return rows, columns


def _compiled_anew(model: RobotModel, said: tuple, p: Array | None) -> Compiled:
    """The instance that a pickled one is restored to."""
    out = Compiled(model, *said)
    out.prepare(p)
    return out
