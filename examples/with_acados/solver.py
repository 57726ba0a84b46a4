"""An optimal control problem with least squares on a model of ours, and acados' real-time iteration for it."""

from __future__ import annotations

import fcntl
import hashlib
import os
import shutil
import sys
import time
from collections.abc import Iterator
from contextlib import chdir, contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import casadi as ca
import numpy as np

from screwgen.backends.casadi.acados import AcadosExport

from .dynamics import discrete, loaded
from .install import FOLDER, acados_template


@dataclass(frozen=True)
class Problem:
    """min Σ h ½‖y − r‖²_W + ½‖y_e − r_e‖²_{W_e}; stage k < N has weight h."""

    name: str
    export: AcadosExport
    N: int
    h: float
    """s: interval, over which u is held."""
    y: ca.SX
    """Of x, u: (ny,), what a stage weighs."""
    W: np.ndarray
    """(ny, ny)"""
    y_end: ca.SX
    W_end: np.ndarray
    limit: np.ndarray
    """(nu,): |u| at most."""
    bounded: np.ndarray = field(default_factory=lambda: np.empty(0, int))
    """Entries of x with a bound, by slacks."""
    bound: np.ndarray = field(default_factory=lambda: np.empty(0))
    slack: tuple[float, float] = (1e6, 1e4)
    """Weights of s²/2 and s of the slacks."""
    after: ca.SX | None = None
    """x after h by a step of ours, for the integrator "DISCRETE"."""


@dataclass(frozen=True)
class Options:
    integrator: str = "DISCRETE"
    """"DISCRETE" (our step), "ERK" (explicit Runge–Kutta) or "IRK" (Gauss–Legendre, on `f_impl_expr`)."""
    stages: int = 4
    steps: int = 1
    collocation: str = "GAUSS_LEGENDRE"
    condensed: int | None = None
    """Intervals after partial condensing; None: all."""
    flags: str = "-O2"
    """Of the C compiler for what acados generates."""
    sqp: bool = False
    """Iterate to convergence; else one real-time iteration for each solve."""
    tolerance: float = 1e-6
    hpipm: str = "SPEED"
    qp_tolerance: float | None = None
    warm: int = 0


def weigh(model, end: str, residual: ca.SX, W: np.ndarray, unknowns: ca.SX) -> None:
    """½ eᵀ W e with the Hessian of Gauss and Newton, as expressions: W has few entries, unseen by acados."""
    J = ca.jacobian(residual, unknowns)
    setattr(model, f"cost_expr_ext_cost{end}", ca.bilin(ca.sparsify(ca.DM(W)), residual, residual) / 2)
    setattr(model, f"cost_expr_ext_cost_custom_hess{end}", J.T @ ca.sparsify(ca.DM(W)) @ J)


def stated(problem: Problem, options: Options):
    """The `AcadosOcp`."""
    template, e, o = acados_template(), problem.export, options
    ocp = template.AcadosOcp()
    e.into(ocp.model)
    ocp.model.name = problem.name
    ocp.dims.N = problem.N
    r = ca.SX.sym("r", len(problem.W))
    ocp.model.p, ocp.parameter_values = ca.vertcat(e.p, r), np.r_[e.parameter_values, np.zeros(len(problem.W))]
    ocp.cost.cost_type = ocp.cost.cost_type_e = "EXTERNAL"
    weigh(ocp.model, "", problem.y - r, problem.W, ca.vertcat(e.u, e.x))
    weigh(ocp.model, "_e", problem.y_end - r[: len(problem.W_end)], problem.W_end, e.x)
    c, nu = ocp.constraints, e.u.numel()
    c.x0 = np.zeros(e.x.numel())
    c.idxbu, c.lbu, c.ubu = np.arange(nu), -problem.limit, problem.limit
    if n := len(problem.bounded):
        quadratic, linear = (np.full(n, w) for w in problem.slack)
        for end in ("", "_e"):
            for name, value in (("idxbx", problem.bounded), ("idxsbx", np.arange(n))):
                setattr(c, name + end, value)
            setattr(c, "lbx" + end, -problem.bound)
            setattr(c, "ubx" + end, problem.bound)
            for side in "lu":
                setattr(ocp.cost, f"Z{side}{end}", quadratic)
                setattr(ocp.cost, f"z{side}{end}", linear)
    s = ocp.solver_options
    s.tf, s.integrator_type, s.hessian_approx = problem.N * problem.h, o.integrator, "GAUSS_NEWTON"
    s.qp_solver, s.hpipm_mode = "PARTIAL_CONDENSING_HPIPM", o.hpipm
    s.qp_solver_cond_N = o.condensed or problem.N
    s.nlp_solver_type = "SQP" if o.sqp else "SQP_RTI"
    s.collocation_type = o.collocation
    s.sim_method_num_stages, s.sim_method_num_steps = o.stages, o.steps
    s.ext_fun_compile_flags, s.qp_solver_warm_start = o.flags, o.warm
    for name in ("stat", "eq", "ineq", "comp"):
        setattr(s, f"nlp_solver_tol_{name}", o.tolerance)
        if o.qp_tolerance:
            setattr(s, f"qp_solver_tol_{name}", o.qp_tolerance)
    if o.integrator == "DISCRETE":
        m = ocp.model
        m.dyn_ext_fun_type, m.dyn_generic_source = "generic", "elsewhere.c"
        m.dyn_disc_fun, m.dyn_disc_fun_jac = f"{problem.name}_disc", f"{problem.name}_disc_jac"
    return ocp


@contextmanager
def quiet(log: Path) -> Iterator[None]:
    """What acados, its renderer and the compiler print goes into `log`."""
    sys.stdout.flush()
    kept = [os.dup(k) for k in (1, 2)]
    with log.open("ab") as to:
        try:
            for k in (1, 2):
                os.dup2(to.fileno(), k)
            yield
        finally:
            sys.stdout.flush()
            for k, old in zip((1, 2), kept, strict=True):
                os.dup2(old, k)
                os.close(old)


class Solver:
    """What acados compiled for a problem; kept in build/acados by a digest of all that it was made from."""

    def __init__(self, problem: Problem, options: Options | None = None, folder: Path = FOLDER / "solvers"):
        self.problem, self.options, self.p = problem, options or Options(), np.array(problem.export.parameter_values)
        folder.mkdir(parents=True, exist_ok=True)
        start = time.perf_counter()
        ocp, of_dynamics = stated(problem, self.options), ""
        if self.options.integrator == "DISCRETE":
            e, include = problem.export, Path(os.environ["ACADOS_SOURCE_DIR"]) / "include"
            source = discrete(problem.name, e.x, e.u, e.p, problem.after)
            of_dynamics = loaded(source, folder, include, self.options.flags)
        key = digest(problem, self.options, of_dynamics)
        ocp.model.name = f"{problem.name}_{key}"
        place, log = folder / key, folder / f"{key}.log"
        with (folder / f"{key}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)  # another process may be making the same one
            self._make(ocp, place, log)
        self.seconds = time.perf_counter() - start
        """Of code generation and compilation."""

    def _make(self, ocp, place: Path, log: Path) -> None:
        kept = (place / "done").is_file()
        if not kept:
            log.unlink(missing_ok=True)
            shutil.rmtree(place, ignore_errors=True)
            place.mkdir()
            (place / "elsewhere.c").write_text("typedef int nothing_here;\n")
        ocp.code_export_directory = "code"
        try:
            with chdir(place), quiet(log):
                make = acados_template().AcadosOcpSolver
                self.acados = make(ocp, "ocp.json", generate=not kept, build=not kept)
        except Exception as error:
            name = self.problem.name
            raise RuntimeError(f"acados could not make the solver of {name} ({error}); see {log}") from error
        (place / "done").touch()

    def options_set(self, **options) -> None:
        for name, value in options.items():
            self.acados.options_set(name, value)

    def refer(self, y, y_end) -> None:
        """References of the stages, (ny,) for all or (N, ny), and of the end; these are parameters."""
        N, size = self.problem.N, len(self.problem.W)
        rows = np.zeros((N + 1, size))
        rows[:N], rows[N, : len(y_end)] = y, y_end
        for k, row in enumerate(rows):
            self.acados.set(k, "p", np.r_[self.p, row])

    def guess(self, x, u) -> None:
        """States (N + 1, nx) and inputs (N, nu)."""
        for k, row in enumerate(x):
            self.acados.set(k, "x", row)
        for k, row in enumerate(u):
            self.acados.set(k, "u", row)

    def begin(self, x) -> None:
        for bound in ("lbx", "ubx"):
            self.acados.set(0, bound, x)

    @property
    def x(self) -> np.ndarray:
        return np.array([self.acados.get(k, "x") for k in range(self.problem.N + 1)])

    @property
    def u(self) -> np.ndarray:
        return np.array([self.acados.get(k, "u") for k in range(self.problem.N)])

    def prepare(self) -> float:
        """Linearise about the last solution; s of processor time."""
        start = time.thread_time()
        self.acados.options_set("rti_phase", 1)
        self.acados.solve()
        return time.thread_time() - start

    def feedback(self, x) -> tuple[np.ndarray, float, int]:
        """The first input (nu,) from the state x, s of processor time, and acados' status: 0 if the QP is solved."""
        start = time.thread_time()
        self.begin(x)
        self.acados.options_set("rti_phase", 2)
        status = self.acados.solve()
        u = self.acados.get(0, "u")
        return u, time.thread_time() - start, status

    def settle(self, x, count: int) -> float:
        """Real-time iterations from one state; the largest change of an input over its limit in the last one."""
        self.begin(x)
        self.acados.options_set("rti_phase", 0)
        for _ in range(count):
            before = self.u
            if status := self.acados.solve():
                raise RuntimeError(f"acados gives status {status} for {self.problem.name}")
        return float(np.abs((self.u - before) / self.problem.limit).max())


def digest(problem: Problem, options: Options, source: str) -> str:
    e, parts = (
        problem.export,
        [
            Path(__file__).read_text(),
            repr(options),
            source,
            repr((problem.N, problem.h, problem.slack, ca.__version__)),
        ],
    )
    given = [e.x, e.xdot, e.u, e.z, e.p]
    for expression in (e.f_impl_expr, e.f_expl_expr, problem.y, problem.y_end):
        parts.append(ca.Function("f", given, [expression], {"cse": False}).serialize())
    arrays = (problem.W, problem.W_end, problem.limit, problem.bounded, problem.bound, np.array(e.parameter_values))
    text = "".join(parts).encode() + b"".join(np.ascontiguousarray(a).tobytes() for a in arrays)
    return hashlib.sha256(text).hexdigest()[:12]
