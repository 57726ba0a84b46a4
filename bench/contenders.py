"""The same function from two code generators: screwgen's C, and CasADi's C of the same equations.

The function is the forward dynamics of the generated C: ``(q, v, tau, w_ext, constants)`` to ``vdot``, wrenches,
rotation and position of the last tip. CasADi is given exactly these inputs and outputs; ``c`` is the vector of all
prepared constants, ``p`` that of the robot file's parameters.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import casadi as ca

from screwgen import Model
from screwgen.chain import fuse
from screwgen.emit import casadi as backend
from screwgen.emit.c import METHODS, CProject
from screwgen.lower.program import Program
from screwgen.lower.replay import run

STATES = 8
TIME_STEP = 1e-3
SHORT_TERMS = 6


@dataclass(frozen=True)
class Library:
    """C sources that are compiled together; ``entries`` are what a caller calls."""

    name: str
    files: dict[str, str]
    sources: tuple[str, ...]
    entries: tuple[str, ...]
    defines: tuple[str, ...] = ()
    operations: int | None = None


@dataclass(frozen=True)
class Contender:
    """A library with its adapter: one line of the table. ``exact``: its results must agree with the first one's."""

    name: str
    title: str
    library: Library
    adapter: str
    defines: tuple[str, ...]
    exact: bool = True


# ------------------------------------------------------------------------------------------ the function


def same_function(model: Model, constants: str) -> Program:
    """The forward dynamics as the generated C computes it; ``constants`` as in :func:`screwgen.chain.fuse.fuse`."""
    chain = model.chain
    inputs = {"q": chain.nq, "v": chain.nq, "tau": chain.n_joints, "w_ext": 6 * chain.n}

    def body(f, x):
        vdot, wrench = f.forward_dynamics(x["q"], x["v"], x["tau"], x["w_ext"])
        R, position = f.poses(x["q"])[1][-1]
        return {"vdot": vdot, "wrench": wrench, "tip_rotation": R, "tip_position": position}

    return fuse.fuse(chain, "dynamics", inputs, body, constants)


def constant_values(model: Model, program: Program) -> list[float]:
    """The numbers of the input ``c``: the prepared constants in the order of the program's inputs."""
    links, gravity = fuse.baked(model.chain), model.parameter_values[:3]
    out: list[float] = []
    for name in list(program.inputs)[4:]:
        link, _, what = name.partition(":")
        out += gravity if name == "gravity" else links[int(link)][what]
    return out


def casadi_function(program: Program, name: str, unary: Callable, cse: bool) -> ca.Function:
    """The program as a casadi.Function with what follows ``w_ext`` as one vector."""
    order = list(program.inputs)
    symbols = {key: ca.SX.sym(f"x{i}", size) for i, (key, size) in enumerate(program.inputs.items())}
    outputs, _ = run(program, {key: ca.vertsplit(s) if s.numel() else [] for key, s in symbols.items()}, unary)
    columns = [ca.vertcat(*values) for values in outputs.values()]
    columns = ca.cse(columns) if cse else columns
    extra = [ca.vertcat(*(symbols[key] for key in order[4:]))] if order[4:] else []
    return ca.Function(name, [symbols[key] for key in order[:4]] + extra, columns)


def short_series(op: str, x: ca.SX) -> ca.SX:
    """The unary primitives with the Stumpff functions as the few terms that small angles need, no branches.

    Less than the C of screwgen offers (it is good for all angles), the same operations at the states measured here.
    """
    if op not in ("c4", "c5"):
        return backend.unary(op, x)
    order, series = int(op[1]), ca.SX(1)
    for j in reversed(range(1, SHORT_TERMS + 1)):
        series = 1 - x * (1.0 / ((order + 2 * j - 1) * (order + 2 * j))) * series
    return series * (1.0 / (24 if order == 4 else 120))


# ------------------------------------------------------------------------------------------ contenders


def screwgen_library(model: Model, layout: str, binding: str, name: str, extra=()) -> Library:
    """The generated C; only what forward dynamics and the joint form's steps need, and what ``extra`` names."""
    project = CProject(model.chain, model.version, binding, layout)
    r = project.name
    sources = [f"{r}_{part}.c" for part in ("dynamics", "step", "parameters", *extra)]
    if layout == "modular":
        sources.append(f"{r}_links.c")
    sources, entries = tuple(dict.fromkeys(sources)), (f"{r}_forward_dynamics",)
    return Library(name, project.files(), sources, entries, (), project.operations["total"])


def casadi_library(program: Program, name: str, unary=backend.unary, cse=False, options=None) -> Library:
    """What CasADi generates with its default options."""
    f = casadi_function(program, name, unary, cse)
    generator = ca.CodeGenerator(f"{name}.c", options or {})
    generator.add(f)
    needed = {"ARG": f.sz_arg(), "RES": f.sz_res(), "IW": f.sz_iw(), "W": f.sz_w()}
    sizes, source = tuple(f"-DSZ_{k}={v}" for k, v in needed.items()), f"{name}.c"
    return Library(name, {source: generator.dump()}, (source,), (name,), sizes, operations(f))


def operations(f: ca.Function) -> int:
    """Instructions of an SX function that compute something."""
    moves = (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST)
    return sum(f.instruction_id(i) not in moves for i in range(f.n_instructions()))


def contenders(model: Model) -> list[Contender]:
    """All contenders of forward dynamics for one robot; those that are compared run next to each other."""
    given, own, baked = (same_function(model, how) for how in ("constants", "parameters", "baked"))
    fused = screwgen_library(model, "fused", "runtime", "fused")
    single = casadi_library(given, "casadi_float", options={"casadi_real": "float"})
    return [
        _ours(model, "fused", "screwgen, fused", fused),
        _theirs("casadi", "CasADi", casadi_library(given, "casadi"), "c"),
        _theirs("casadi_cse", "CasADi, cse", casadi_library(given, "casadi_cse", cse=True), "c"),
        _theirs("casadi_short", "CasADi, short series", casadi_library(given, "casadi_short", short_series, True), "c"),
        _ours(model, "modular", "screwgen, modular", screwgen_library(model, "modular", "runtime", "modular")),
        _ours(model, "prepare", "screwgen, prepare + fused", fused, ("-DWITH_PREPARE",)),
        _theirs("casadi_p", "CasADi", casadi_library(own, "casadi_p"), "p"),
        _theirs("casadi_p_cse", "CasADi, cse", casadi_library(own, "casadi_p_cse", cse=True), "p"),
        _ours(model, "baked", "screwgen, fused baked", screwgen_library(model, "fused", "baked", "baked")),
        _theirs("casadi_baked", "CasADi", casadi_library(baked, "casadi_baked"), None),
        _theirs("casadi_baked_cse", "CasADi, cse", casadi_library(baked, "casadi_baked_cse", cse=True), None),
        _theirs(
            "casadi_baked_short",
            "CasADi, short series",
            casadi_library(baked, "casadi_baked_short", short_series, True),
            None,
        ),
        _ours(model, "float", "screwgen, fused float", float_library(fused, model), exact=False),
        _theirs("casadi_float", "CasADi, float", single, "c", "float"),
    ]


def float_library(fused: Library, model: Model) -> Library:
    define = f"-D{model.robot.name.upper()}_REAL_FLOAT"
    return Library("float", fused.files, fused.sources, fused.entries, (define,), fused.operations)


def step_contenders(model: Model) -> list[Contender]:
    """A step of every integrator, joint and DAE form, next to the forward dynamics it is made of."""
    library = screwgen_library(model, "fused", "runtime", "steps", extra=("dae", "links"))
    r, out = model.robot.name, []
    for form, infix in (("STEP", "step"), ("DAE_STEP", "dae_step")):
        for method in METHODS:
            defines = (f"-D{form}={r}_{infix}_{method}", f"-DTIME_STEP={TIME_STEP}")
            title = f"{form[:-5] or 'joint'} {method}"
            out.append(_ours(model, f"{infix}_{method}", title, library, defines, exact=False))
    return out


def _ours(model: Model, name: str, title: str, library: Library, defines=(), exact=True) -> Contender:
    r = model.robot.name
    return Contender(name, title, library, "adapter_screwgen.c", (f"-DROBOT={r}", f'-DHEADER="{r}.h"', *defines), exact)


def _theirs(name: str, title: str, library: Library, extra: str | None, real="double") -> Contender:
    given = f"-DEXTRA=data_{extra}" if extra else "-DBAKED"
    real_define = () if real == "double" else (f"-Dcasadi_real={real}",)
    defines = (f"-DFUNCTION={library.name}", given, *real_define)
    return Contender(name, title, library, "adapter_casadi.c", defines, real == "double")


# ----------------------------------------------------------------------------------------------- states


def data_header(model: Model) -> str:
    """The states at which everything is measured, the constants and the parameters, as C arrays."""
    chain, rows = model.chain, range(STATES)
    c = constant_values(model, same_function(model, "constants"))
    arrays = {
        "q": [_numbers(chain.n_joints, k, 1, 1.2) + _numbers(chain.n_modes, k, 2, 0.01) for k in rows],
        "v": [_numbers(chain.n_joints, k, 3, 0.8) + _numbers(chain.n_modes, k, 4, 0.1) for k in rows],
        "tau": [_numbers(chain.n_joints, k, 5, 20.0) for k in rows],
        "w_ext": [_numbers(6 * chain.n, k, 6, 5.0) for k in rows],
    }
    sizes = {"NQ": chain.nq, "NTAU": chain.n_joints, "NLINKS": chain.n, "STATES": STATES}
    lines = [f"enum {{ {', '.join(f'{k} = {v}' for k, v in sizes.items())} }};"]
    for name, values in arrays.items():
        table = ",\n".join(f"    {{ {', '.join(map(repr, row))} }}" for row in values)
        lines.append(f"static const double data_{name}[{STATES}][{len(values[0])}] = {{\n{table}\n}};")
    for name, values in (("c", c), ("p", model.parameter_values)):
        table = ", ".join(repr(float(x)) for x in values)
        lines.append(f"static const double data_{name}[{len(values)}] = {{ {table} }};")
    return "\n".join(lines) + "\n"


def _numbers(count: int, number: int, salt: int, size: float) -> list[float]:
    """Numbers in (-size, size) without pattern, the same everywhere."""
    start = (number + 1) * 0.6180339887498949 + salt * 0.7548776662466927
    places = (start + (j + 1) * 0.5698402909980532 for j in range(count))
    return [round(size * (2.0 * (x % 1.0) - 1.0), 6) for x in places]


def prepare_folder(folder: Path, library: Library) -> None:
    """Write the sources of a library."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in library.files.items():
        (folder / name).write_text(text)
