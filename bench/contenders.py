"""The pieces of the benchmark: generated C as a library, and a library with its adapter as a contender.

The function is the forward dynamics of the generated C: ``(q, v, tau, w_ext, constants)`` to ``vdot``, wrenches,
rotation and position of the last tip. CasADi is given exactly these inputs and outputs; ``c`` is the vector of all
prepared constants, ``p`` that of the robot file's parameters.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import casadi as ca

from screwgen import Model
from screwgen.algorithms import fused
from screwgen.backends.c.project import CProject
from screwgen.backends.casadi.expressions import expressions
from screwgen.errors import UsageError
from screwgen.ir.program import Program

STATES = 8
"""As in contract.h."""


class Missing(Exception):
    """A contender that this machine cannot run; one line that says why."""


@dataclass(frozen=True)
class Library:
    """C sources that are compiled together; ``entries`` are what a caller calls, ``objects`` are linked as they are."""

    name: str
    files: dict[str, str]
    sources: tuple[str, ...]
    entries: tuple[str, ...]
    defines: tuple[str, ...] = ()
    operations: int | None = None
    objects: tuple[Path, ...] = ()
    layout: str = ""


@dataclass(frozen=True)
class Contender:
    """A library with its adapter: one row of the table.

    ``against``: the contender that its time is divided by, itself for the first of a group; ``target``: the bounds of
    that ratio; ``per``: links or modes that the time is divided by before. ``exact``: its results must agree with
    those of the first contender that has the same ``data``.
    """

    name: str
    title: str
    library: Library
    adapter: str
    data: str
    defines: tuple[str, ...] = ()
    against: str = ""
    target: tuple[float | None, float | None] = (None, None)
    per: int = 1
    exact: bool = True

    @property
    def symbol(self) -> str:
        """Its name in the driver."""
        return f"run_{self.name}"


# ------------------------------------------------------------------------------------------- screwgen's C


def screwgen_library(model: Model, layout: str, binding: str, name: str, extra=(), single=False) -> Library:
    """The generated C; only what forward dynamics and the joint form's steps need, and what ``extra`` names."""
    try:
        project = CProject(model.chain, model.version, binding, layout)
    except UsageError as refusal:
        raise Missing(str(refusal)) from None
    r, files = project.name, project.files()
    wanted = [f"{r}_{part}.c" for part in ("dynamics", "step", "parameters", "real", *extra)]
    wanted += [f"{r}_links.c"] if project.layout == "modular" else []
    defines = (f"-D{r.upper()}_REAL_FLOAT",) if single else ()
    entries = (f"{r}_forward_dynamics",)
    sources, count = tuple(dict.fromkeys(wanted)), project.operations["total"]
    return Library(name, files, sources, entries, defines, count, layout=project.layout)


def accelerations(model: Model, library: Library, title: str, **more) -> Contender:
    """A library as a contender that gives vdot alone, as Lagrange's equations and articulated-body algorithms do.

    Operations are known of the whole forward dynamics only.
    """
    r = model.robot.name
    alone = replace(library, entries=(f"{r}_accelerations",), operations=None)
    return ours(model, library.name, f"{library.layout}, {title}", alone, "-DACCELERATIONS", **more)


def ours(model: Model, name: str, title: str, library: Library, *defines: str, exact=True, **more) -> Contender:
    r = model.robot.name
    defined = (f"-DROBOT={r}", f'-DHEADER="{r}.h"', *defines)
    return Contender(name, f"screwgen {title}", library, "adapter_screwgen.c", r, defined, exact=exact, **more)


# --------------------------------------------------------------------------------------------- CasADi's C


def same_function(model: Model, constants: str) -> Program:
    """The forward dynamics as the generated C computes it; ``constants`` see :func:`screwgen.algorithms.fused.fuse`."""
    chain = model.chain
    inputs = {"q": chain.nq, "v": chain.nv, "tau": chain.n_tau, "w_ext": 6 * chain.n}

    def body(f, x):
        vdot, wrench = f.forward_dynamics(x["q"], x["v"], x["tau"], x["w_ext"])
        R, position = f.poses(x["q"])[1][-1]
        return {"vdot": vdot, "wrench": wrench, "tip_rotation": R, "tip_position": position}

    return fused.fuse(chain, "dynamics", inputs, body, constants)


def constant_values(model: Model, program: Program) -> list[float]:
    """The numbers of the input ``c``: the prepared constants in the order of the program's inputs."""
    links, gravity = fused.baked(model.chain), model.parameter_values[:3]
    out: list[float] = []
    for name in list(program.inputs)[4:]:
        link, _, what = name.partition(":")
        out += gravity if name == "gravity" else links[int(link)][what]
    return out


def casadi_function(program: Program, name: str, cse: bool) -> ca.Function:
    """The program as a casadi.Function with what follows ``w_ext`` as one vector."""
    order = list(program.inputs)
    symbols = {key: ca.SX.sym(f"x{i}", size) for i, (key, size) in enumerate(program.inputs.items())}
    columns = list(expressions(program, symbols).values())
    columns = ca.cse(columns) if cse else columns
    extra = [ca.vertcat(*(symbols[key] for key in order[4:]))] if order[4:] else []
    return ca.Function(name, [symbols[key] for key in order[:4]] + extra, columns)


def casadi_library(f: ca.Function, options=None) -> Library:
    """What CasADi generates for a function, by default with its default options."""
    generator = ca.CodeGenerator(f"{f.name()}.c", options or {})
    generator.add(f)
    sizes = f.sz_arg(), f.sz_res(), f.sz_iw(), f.sz_w()
    return written_by_casadi(f.name(), generator.dump(), operations(f), sizes)


def written_by_casadi(name: str, text: str, count: int, sizes=(3, 1, 0, 0)) -> Library:
    """C with CasADi's calling convention; ``sizes`` of its work arrays, by default those of SX of q, v and tau."""
    defines = tuple(f"-DSZ_{k}={v}" for k, v in zip(("ARG", "RES", "IW", "W"), sizes, strict=True))
    return Library(name, {f"{name}.c": text}, (f"{name}.c",), (name,), defines, count)


def operations(f: ca.Function) -> int:
    """Instructions of an SX function that compute something."""
    moves = (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST)
    return sum(f.instruction_id(i) not in moves for i in range(f.n_instructions()))


def theirs(model: Model, title: str, library: Library, *defines: str, exact=True, **more) -> Contender:
    """A CasADi library; ``defines`` say what it is given: ``-DEXTRA=data_c``, ``-DBAKED`` or ``-DBAKED -DPLAIN``."""
    defined = (f"-DFUNCTION={library.name}", *defines)
    return Contender(library.name, title, library, "adapter_casadi.c", model.robot.name, defined, exact=exact, **more)


def has_avx() -> bool:
    """Whether this machine's processor has AVX."""
    flags = Path("/proc/cpuinfo")
    return flags.exists() and " avx " in flags.read_text()


# ------------------------------------------------------------------------------------------------- states


def data_header(model: Model, joints=(), loads: bool = True) -> str:
    """The states at which everything is measured, the constants and the parameters, as C arrays.

    ``joints``: rows that describe a rigid chain to others; ``loads``: external wrenches other than zero.
    """
    chain, rows = model.chain, range(STATES)
    c = constant_values(model, same_function(model, "constants"))
    arrays = {
        "q": [_numbers(chain.n_joints, k, 1, 1.2) + _numbers(chain.n_modes, k, 2, 0.01) for k in rows],
        "v": [_numbers(chain.n_joints, k, 3, 0.8) + _numbers(chain.n_modes, k, 4, 0.1) for k in rows],
        "tau": [_numbers(chain.n_joints, k, 5, 20.0) for k in rows],
        "w_ext": [_numbers(6 * chain.n, k, 6, 5.0 if loads else 0.0) for k in rows],
    }
    arrays |= {"joints": joints} if joints else {}
    sizes = {"NQ": chain.nq, "NTAU": chain.n_joints, "NLINKS": chain.n}
    lines = [f"enum {{ {', '.join(f'{k} = {v}' for k, v in sizes.items())} }};"]
    for name, values in arrays.items():
        table = ",\n".join(f"    {{ {', '.join(map(repr, row))} }}" for row in values)
        lines.append(f"static const double data_{name}[{len(values)}][{len(values[0])}] = {{\n{table}\n}};")
    for name, values in (("c", c), ("p", model.parameter_values)):
        table = ", ".join(repr(float(x)) for x in values)
        lines.append(f"static const double data_{name}[{len(values)}] = {{ {table} }};")
    return "\n".join(lines) + "\n"


def _numbers(count: int, number: int, salt: int, size: float) -> list[float]:
    """Numbers in (-size, size) without pattern, the same everywhere."""
    start = (number + 1) * 0.6180339887498949 + salt * 0.7548776662466927
    places = (start + (j + 1) * 0.5698402909980532 for j in range(count))
    return [round(size * (2.0 * (x % 1.0) - 1.0), 6) for x in places]
