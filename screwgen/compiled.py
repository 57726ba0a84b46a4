"""The generated C, compiled and loaded: its functions on NumPy arrays."""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from .build import Model
from .chain.dae_functions import state_size, unknown_size
from .emit.c import METHODS, CProject
from .errors import ScrewgenError, SingularError

STATUS = ("ok", "non-finite input or result", "singular", "bad argument")
FLAGS = ("-std=c99", "-fPIC", "-shared")


def build_library(folder: Path, files: Mapping[str, str], compiler: str, flags: Sequence[str]) -> ctypes.CDLL:
    """Write the files of a robot's C into a folder, compile them but the programs, and load the library.

    Raises :class:`ScrewgenError` where the compiler is missing or fails.
    """
    if shutil.which(compiler) is None:
        raise ScrewgenError(f"no C compiler '{compiler}'; install gcc or name one in the environment variable CC")
    for name, text in files.items():
        (folder / name).write_text(text)
    sources = sorted(name for name in files if name.endswith(".c") and name not in ("main.c", "check.c"))
    command = [compiler, *FLAGS, *flags, "-o", "model.so", *sources, "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise ScrewgenError(f"{compiler} failed on the generated C: {done.stderr.strip().splitlines()[:1]}")
    return ctypes.CDLL(str(folder / "model.so"))


class Compiled:
    """A robot's C in a shared library.  Arrays are those of the NumPy back end; precision may be single.

    Raises :class:`ScrewgenError` where there is no C compiler or a call does not return OK, and
    :class:`SingularError` naming the link whose joint is singular.
    """

    def __init__(
        self,
        model: Model,
        layout="auto",
        parameters="runtime",
        single=False,
        flags=("-O2",),
        compiler=None,
        derivatives=False,
    ):
        self.model, self.chain, self.single = model, model.chain, single
        self.real = np.float32 if single else np.float64
        self.project = CProject(self.chain, model.version, parameters, layout, derivatives=derivatives)
        self._folder = tempfile.TemporaryDirectory(prefix="screwgen-")
        self.library = self._load(compiler or os.environ.get("CC") or "cc", flags)
        self.prepare(None)

    def _load(self, compiler: str, flags) -> ctypes.CDLL:
        define = [f"-D{self.project.name.upper()}_REAL_FLOAT"] if self.single else []
        files = self.project.files() | {"shim.c": self.project.shim()}
        if self.project.with_derivatives:
            files |= {"derivatives_shim.c": self.project.shim("derivatives_shim.c")}
        return build_library(Path(self._folder.name), files, compiler, [*flags, *define])

    def prepare(self, p) -> None:
        """Set the parameters (None: the robot file's values)."""
        if p is None:
            self._check(self.library.shim_prepare(None))
        else:
            self._check(self.library.shim_prepare(self._in(p, len(self.model.parameter_values))))

    def forward_dynamics(self, q, v, tau, w_ext, form="joint") -> tuple[np.ndarray, np.ndarray]:
        """``vdot`` (nq,) and the joint wrenches (n, 6)."""
        return self.complete_dynamics(q, v, tau, w_ext, form)[:2]

    def complete_dynamics(self, q, v, tau, w_ext, form="joint"):
        """``vdot``, wrenches, rotation (3, 3) and position (3,) of the last tip."""
        c = self.chain
        vdot, wrench, R, r = (np.zeros(s, self.real) for s in (max(c.nq, 1), (c.n, 6), (3, 3), 3))
        call = self.library.shim_forward if form == "joint" else self.library.shim_dae_forward
        self._check(call(*self._state(q, v), *self._input(tau, w_ext), *map(self._out, (vdot, wrench, R, r))))
        return vdot[: c.nq], wrench, R, r

    def linearise(self, q, v, tau, w_ext) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """``vdot`` (nq,) and its partial derivatives with q, v (nq, nq) and tau (nq, m).

        Needs ``derivatives=True``.  Arrays of a robot without joint coordinates have no columns in the last.
        """
        nq, m = self.chain.nq, self.chain.n_joints
        arrays = [np.zeros(shape, self.real) for shape in (nq, (nq, nq), (nq, nq), (nq, m))]
        status = self.library.shim_linearise(*self._state(q, v), *self._input(tau, w_ext), *map(self._out, arrays))
        self._check(status, "shim_linearise_fault")
        return tuple(arrays)

    def accelerations(self, q, v, tau, w_ext) -> np.ndarray:
        """``vdot`` alone."""
        vdot = np.zeros(max(self.chain.nq, 1), self.real)
        self._check(self.library.shim_accelerations(*self._state(q, v), *self._input(tau, w_ext), self._out(vdot)))
        return vdot[: self.chain.nq]

    def inverse_dynamics(self, q, v, vdot, w_ext) -> tuple[np.ndarray, np.ndarray]:
        """The forces on all coordinates (nq,) and the joint wrenches (n, 6) that a motion needs."""
        c = self.chain
        force, wrench = np.zeros(max(c.nq, 1), self.real), np.zeros((c.n, 6), self.real)
        given = (*self._state(q, v), self._in(w_ext, 6 * c.n), self._in(vdot, c.nq))
        self._check(self.library.shim_inverse(*given, self._out(force), self._out(wrench)))
        return force[: c.nq], wrench

    def mass_matrix(self, q) -> np.ndarray:
        """``M`` (nq, nq)."""
        size = max(self.chain.nq, 1)
        M = np.zeros((size, size), self.real)
        self._check(self.library.shim_mass_matrix(self._in(q, self.chain.nq), self._out(M)))
        return M[: self.chain.nq, : self.chain.nq]

    def step(self, q, v, tau, w_ext, dt: float, method="rk4", count=1) -> tuple[np.ndarray, np.ndarray]:
        """The state after ``count`` steps of the joint form, the input held."""
        q, v = self._copy(q, self.chain.nq), self._copy(v, self.chain.nq)
        number = METHODS.index(method)
        self._check(
            self.library.shim_step(number, count, self._real(dt), *self._input(tau, w_ext), *map(self._out, (q, v)))
        )
        return q[: self.chain.nq], v[: self.chain.nq]

    def dae_state(self, q, v) -> np.ndarray:
        """The state ``x`` of the DAE form."""
        x = np.zeros(state_size(self.chain), self.real)
        self._check(self.library.shim_dae_state(*self._state(q, v), self._out(x)))
        return x

    def dae_step(self, x, tau, w_ext, dt: float, method="rk4", count=1) -> np.ndarray:
        """``x`` after ``count`` steps of the DAE form, each projected, the input held."""
        x = self._copy(x, state_size(self.chain))
        number = METHODS.index(method)
        self._check(self.library.shim_dae_step(number, count, self._real(dt), *self._input(tau, w_ext), self._out(x)))
        return x

    def assemble(self, x, tau, w_ext) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """``M_sys`` (dense), ``H_sys`` and ``W_sys``."""
        size, rows, columns = unknown_size(self.chain), *self._pattern()
        values, H, W = np.zeros(len(rows), self.real), np.zeros(size, self.real), np.zeros(size, self.real)
        given = self._in(x, state_size(self.chain))
        self._check(self.library.shim_assemble(given, *self._input(tau, w_ext), *map(self._out, (values, H, W))))
        M = np.zeros((size, size), self.real)
        for j in range(size):
            M[rows[columns[j] : columns[j + 1]], j] = values[columns[j] : columns[j + 1]]
        return M, H, W

    def _pattern(self) -> tuple[np.ndarray, np.ndarray]:
        rows = np.zeros(self.project.context["nnz"], np.int32)
        columns = np.zeros(unknown_size(self.chain) + 1, np.int32)
        self.library.shim_pattern(self._out(rows), self._out(columns))
        return rows, columns

    # arrays -----------------------------------------------------------------------------------

    def _state(self, q, v):
        return self._in(q, self.chain.nq), self._in(v, self.chain.nq)

    def _input(self, tau, w_ext):
        return self._in(tau, self.chain.n_joints), self._in(w_ext, 6 * self.chain.n)

    def _copy(self, values, size: int) -> np.ndarray:
        out = np.zeros(max(size, 1), self.real)
        out[:size] = np.ravel(values)
        return out

    def _in(self, values, size: int):
        return np.ctypeslib.as_ctypes(self._copy(values, size))

    def _out(self, array: np.ndarray):
        return ctypes.c_void_p(array.ctypes.data)

    def _real(self, value: float):
        return ctypes.c_float(value) if self.single else ctypes.c_double(value)

    def _check(self, status: int, fault="shim_fault") -> None:
        if status == 2:
            link = self.chain.robot.links[getattr(self.library, fault)()].name
            raise SingularError(f"the joint of link '{link}' is singular in this posture")
        if status:
            raise ScrewgenError(f"the generated C reports: {STATUS[status]}")


class CompiledStepper:
    """A stepper of :mod:`screwgen.simulation` that steps the joint form in the generated C."""

    default = "modal_implicit"

    def __init__(self, compiled: Compiled, model: Model, integrator: str, p):
        self.compiled, self.integrator = compiled, integrator
        compiled.prepare(p)

    def initial(self, q, v):
        return np.array(q, float), np.array(v, float)

    def step(self, state, tau, w_ext, dt: float):
        return self.compiled.step(*state, tau, w_ext, dt, self.integrator)

    def coordinates(self, state):
        return state
