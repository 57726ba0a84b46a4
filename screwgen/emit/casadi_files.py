"""The CasADi target: every function in a file of its own, as CasADi serialises it."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

import casadi as ca

from ..spec.robot import Robot
from .templates import render

INTEGRANDS = {"ode": (("x", "u", "p"), ("ode",)), "dae": (("x", "z", "u", "p"), ("ode", "alg"))}


def casadi_files(robot: Robot, functions: Mapping, parameter_names: Sequence[str], version: str) -> dict[str, bytes]:
    """``NAME.casadi`` per function and a README that lists their signatures."""
    saved = {name: _function(name, value) for name, value in functions.items()}
    files = {f"{name}.casadi": _serialised(f) for name, f in saved.items()}
    rows = [{"name": name, "inputs": _signature(f, "in"), "outputs": _signature(f, "out")} for name, f in saved.items()]
    readme = render(
        "casadi/README.md.jinja", name=robot.name, version=version, functions=rows, parameters=parameter_names
    )
    return files | {"README.md": readme.encode()}


def _function(name: str, value) -> ca.Function:
    """A function as it is; a dictionary for ``casadi.integrator`` as the function of its expressions."""
    if isinstance(value, ca.Function):
        return value
    inputs, outputs = INTEGRANDS[name]
    return ca.Function(name, [value[i] for i in inputs], [value[o] for o in outputs], list(inputs), list(outputs))


def _serialised(f: ca.Function) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "function.casadi"
        f.save(str(path))
        return path.read_bytes()


def _signature(f: ca.Function, side: str) -> str:
    """``q[9], v[9], w_ext[6x2]``."""
    count, name, size = (getattr(f, f"{x}_{side}") for x in ("n", "name", "size"))
    shapes = [size(i) for i in range(count())]
    return ", ".join(f"{name(i)}[{r}x{c}]" if c > 1 else f"{name(i)}[{r}]" for i, (r, c) in enumerate(shapes))
