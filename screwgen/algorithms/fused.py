"""Functions of the whole robot as single straight-line programs: phases inlined, zeros and constants folded."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import update_wrapper
from typing import Any, Protocol

from ..ir.program import Program, Tracer, Value
from ..ir.replay import inline, run
from ..lazily import mpmath
from ..spec.parameters import of_forces, parameters
from ..topology.chain import Chain
from .columns import columns, link_columns, width
from .dae_functions import DaeFunctions, state_size, unknown_size
from .functions import EVERYTHING, Functions
from .schedule import Algorithm, constant_labels, is_column, preparation, seen_by

DIGITS = 40
SPARE = 32
"""Bits by which a series in whole numbers is more accurate than the numbers that it is for."""

OF_FORCES = "forces."
"""The beginning of the names of inputs that are numbers of forces between frames; that of the parameter follows."""

Outputs = Mapping[str, Sequence[Value]]
Body = Callable[[Any, Mapping[str, Sequence[Value]]], Outputs]
"""Of the functions of a robot, of the class that :func:`fuse` is given, and of the inputs."""


def fuse(
    chain: Chain,
    name: str,
    inputs: Mapping[str, int],
    body: Body,
    constants: str = "parameters",
    kind: type[Functions] = Functions,
    algorithms: Sequence[Algorithm] = EVERYTHING,
) -> Program:
    """Trace a function of the whole robot into one program.

    ``constants`` says where the links' constants come from: prepared inside from an input ``p``
    (``"parameters"``), inputs of their own (``"constants"``), or numbers (``"baked"``); ``kind`` is the class of
    functions that ``body`` is given, ``algorithms`` are those for which there are constants.
    """
    tracer = Tracer()
    values = {key: tracer.input(key, size) for key, size in inputs.items()}
    read: dict[str, int] = dict(inputs)
    links, world = _sources(chain, tracer, constants, read, algorithms)
    names = chain.identifiers
    apply = lambda i, _, program, given: inline(program, given, tracer, names[i], i)  # noqa: E731
    functions = kind(chain, links, world, apply)
    functions.section = tracer.section
    outputs = body(functions, values)
    return tracer.program(name, read, {k: list(v) for k, v in outputs.items()})


def _sources(
    chain: Chain, tracer: Tracer, constants: str, read: dict[str, int], algorithms: Sequence[Algorithm]
) -> tuple[list[dict[str, list]], Sequence[Value]]:
    if constants == "baked":
        return baked(chain, algorithms), world(chain, [p.value for p in parameters(chain.robot)])
    if constants == "parameters":
        size = len(parameters(chain.robot))
        p = tracer.input("p", size)
        read["p"] = size
        called = chain.identifiers
        apply = lambda i, program, given: inline(program, given, tracer, called[i])  # noqa: E731
        return prepared(chain, p, apply, algorithms), world(chain, p)
    links = []
    for i in range(chain.n):
        names = {f"c.{label}": 1 for label in constant_labels(chain, i, algorithms)}
        for part, span in chain.coordinate_spans(i).items():
            names |= dict.fromkeys(link_columns(part), width(span))
        links.append({n: tracer.input(f"{i}:{n}", size) for n, size in names.items()})
        read |= {f"{i}:{n}": size for n, size in names.items()}
    sizes = {"gravity": 3} | {f"{OF_FORCES}{p.name}": 1 for p in of_forces(chain.robot)}
    read |= sizes
    return links, [x for name, size in sizes.items() for x in tracer.input(name, size)]


def world(chain: Chain, p: Sequence) -> Sequence:
    """Gravity and the numbers of forces between frames, from the parameter vector ``p``."""
    return [*p[:3], *p[len(p) - chain.n_force_numbers :]] if chain.forces else p[:3]


def prepared(
    chain: Chain,
    p: Sequence,
    evaluate: Callable[[int, Program, Mapping], Mapping[str, list]],
    algorithms: Sequence[Algorithm] = EVERYTHING,
) -> list[dict]:
    """The constants of every link from the parameter vector ``p``, by the names that the phases use.

    ``evaluate(link, program, inputs)`` runs a preparation on values of any algebra; ``algorithms`` are those that the
    constants are for.
    """
    out = []
    for i, key in enumerate(seen_by(chain, *algorithms).keys):
        program, places = preparation(key, constant_labels(chain, i, algorithms)), chain.parameter_labels[i]
        outputs = evaluate(i, program, {name: [p[places[name[2:]]]] for name in program.inputs})
        out.append({name if is_column(name) else f"c.{name}": values for name, values in outputs.items()})
    return out


def exact(chain: Chain, algorithms: Sequence[Algorithm] = EVERYTHING) -> tuple[list, list[dict[str, list]]]:
    """The parameters and the constants of every link in mpmath, at the precision of the surrounding context."""
    p = [mpmath.mpf(x.value) for x in parameters(chain.robot)]
    return p, prepared(chain, p, lambda _, program, given: run(program, given, precise)[0], algorithms)


def baked(chain: Chain, algorithms: Sequence[Algorithm] = EVERYTHING) -> list[dict[str, list[float]]]:
    """The constants of every link as numbers, evaluated with many digits: the same on every machine."""
    with mpmath.workdps(DIGITS):
        return [{n: [float(x) for x in v] for n, v in link.items()} for link in exact(chain, algorithms)[1]]


def precise(op: str, x: Any, *more: Any) -> Any:
    """The primitives in mpmath."""
    if op == "neg":
        return -x
    if op == "on":
        return mpmath.mpf(x > 0)
    if op[0] == "c" and op[1:].isdigit():
        return _stumpff(int(op[1]), x)
    return getattr(mpmath, op)(x, *more)


def _stumpff(order: int, x: Any) -> Any:
    """The Stumpff series in whole multiples of a small number: far faster than in mpmath, and as accurate.

    Terms grow to about exp(sqrt(|x|)) before they fall, so as many more bits are kept as that has.
    """
    bits = mpmath.mp.prec + SPARE + int(1.5 * math.sqrt(abs(float(x))))
    square, term = int(mpmath.ldexp(abs(x), bits)), (1 << bits) // math.factorial(order)
    total, k, sign = term, order, 1
    while term:
        term = (term * square >> bits) // ((k + 1) * (k + 2))
        k, sign = k + 2, -sign if x > 0 else sign
        total += sign * term
    return mpmath.ldexp(mpmath.mpf(total), -bits)


# ------------------------------------------------------------------------------ the functions of a robot


def stated(chain: Chain, names: str) -> list[str]:
    """The inputs of a function, which blanks separate: those in brackets where inputs act on forces between frames."""
    bare = {f"({name.strip('()')})": name.strip("()") for name in names.split()} if chain.chooses_forces else {}
    return [bare.get(name, name) for name in names.split() if name in bare or name[0] != "("]


def inputs(chain: Chain, names: str) -> dict[str, int]:
    """The lengths of inputs by name, in the order of ``names``, see :func:`stated`."""
    sizes = {"q": chain.nq, "v": chain.nvz, "vdot": chain.nvz, "tau": chain.n_tau, "w_ext": 6 * chain.n}
    sizes |= {"m_eta": chain.n_inertia, "f_eta": chain.n_given, "wrench": 6 * chain.n, "motion": 4 * chain.n}
    sizes |= {"x": state_size(chain), "z": unknown_size(chain)}
    return {name: sizes[name] for name in stated(chain, names)}


class Maker(Hashable, Protocol):
    """Makes a program of a robot; ``body`` is what it runs on the robot's functions."""

    body: Callable[..., Mapping[str, Sequence[Value]]]

    def __call__(self, chain: Chain, constants: str = ...) -> Program: ...


def program(
    names: str,
    name: str = "",
    kind: type[Functions] = Functions,
    constants: str = "parameters",
    algorithms: Sequence[Algorithm] = EVERYTHING,
) -> Callable[[Callable], Maker]:
    """Makes ``(chain, constants) -> Program`` of a function that takes the robot's functions and the inputs ``names``.

    ``name``: of the program, if it is not the function's; ``constants``: those by default; the rest as of :func:`fuse`.
    """

    def made(body: Callable) -> Maker:
        def make(chain: Chain, constants: str = constants) -> Program:
            given, run = inputs(chain, names), lambda f, x: body(f, **x)
            return fuse(chain, name or body.__name__, given, run, constants, kind, algorithms)

        named: Any = update_wrapper(make, body, updated=())
        del named.__wrapped__  # the signature is that of make
        named.body = body
        return named

    return made


def _watched(f: Functions, **x: Sequence) -> dict[str, Sequence[Value]]:
    """``vdot``, ``wrench`` and the motion for the validity measures; inertia and force of modes if they are inputs."""
    if "m_eta" in x:
        f.given = (x["m_eta"], x["f_eta"])
    vdot, wrench, motion = f.watched_dynamics(x["q"], x["v"], x["tau"], x["w_ext"])
    return {"vdot": vdot, "wrench": wrench, "motion": motion}


@program("q v tau w_ext")
def forward_dynamics(f: Functions, **x: Sequence) -> Outputs:
    """``(q, v, tau, w_ext) -> (vdot, wrench)``."""
    return {name: values for name, values in _watched(f, **x).items() if name != "motion"}


@program("q v tau w_ext m_eta f_eta")
def modal_dynamics(f: Functions, **x: Sequence) -> Outputs:
    """``(q, v, tau, w_ext, m_eta, f_eta) -> (vdot, wrench, motion)``: the forward dynamics of an integrator.

    ``m_eta`` and ``f_eta`` are the inertia and the force of stress and damping of every mode. If a joint is sprung,
    those of every joint coordinate precede them. Implicit steps give their own values.
    """
    return _watched(f, **x)


@program("q wrench motion")
def measures(f: Functions, q: Sequence, wrench: Sequence, motion: Sequence) -> Outputs:
    """``(q, wrench, motion) -> (measures)``: four numbers per link, see :mod:`..bodies.validity`."""
    return {"measures": f.measures(q, wrench, motion)}


@program("q v tau w_ext")
def validity(f: Functions, **x: Sequence) -> Outputs:
    """``(q, v, tau, w_ext) -> (measures)``."""
    found = _watched(f, **x)
    return {"measures": f.measures(x["q"], found["wrench"], found["motion"])}


@program("q v tau w_ext m_eta f_eta", constants="constants")
def complete_dynamics(f: Functions, **x: Sequence) -> Outputs:
    """The forward dynamics of the generated C: :func:`modal_dynamics` with the pose of the last tip."""
    outputs, (R, position) = _watched(f, **x), f.poses(x["q"])[1][f.chain.last]
    return outputs | {"tip_rotation": R, "tip_position": position}


@program("")
def modal_properties(f: Functions) -> Outputs:
    """``() -> (M_eta, K, D)``: inertia, stiffness and damping behind the inputs of :func:`modal_dynamics`."""
    return columns(f.chain, f.constants)


@program("q v vdot w_ext")
def inverse_dynamics(f: Functions, q: Sequence, v: Sequence, vdot: Sequence, w_ext: Sequence) -> Outputs:
    """``(q, v, vdot, w_ext) -> (force)``."""
    return {"force": f.inverse_dynamics(q, v, vdot, w_ext)}


@program("q v w_ext")
def bias(f: Functions, q: Sequence, v: Sequence, w_ext: Sequence) -> Outputs:
    """``(q, v, w_ext) -> (h)``: the bias force, which is the inverse dynamics without accelerations."""
    return {"h": f.inverse_dynamics(q, v, [0.0] * f.chain.nv, w_ext)}


@program("q vdot")
def inertial_force(f: Functions, q: Sequence, vdot: Sequence) -> Outputs:
    """``(q, vdot) -> (force)`` at rest: its Jacobian in ``vdot`` is the mass matrix."""
    still = f.alone()
    return {"force": still.inverse_dynamics(q, [0.0] * f.chain.nv, vdot, [0.0] * 6 * f.chain.n)}


@program("q v (tau)")
def energy(f: Functions, q: Sequence, v: Sequence, tau: Sequence = ()) -> Outputs:
    """``(q, v) -> (kinetic, potential)``."""
    kinetic, potential = f.under_inputs(tau).energy(q, v)
    return {"kinetic": [kinetic], "potential": [potential]}


@program("q v")
def coordinate_rates(f: Functions, q: Sequence, v: Sequence) -> Outputs:
    """``(q, v) -> (qdot)``."""
    return {"qdot": f.coordinate_rates(q, v)}


@program("q")
def poses(f: Functions, q: Sequence) -> Outputs:
    """``(q) -> (link_R, link_position, tip_R, tip_position)``, every R row by row, link by link."""
    frames, tips = f.poses(q)
    flat = lambda places, k: [v for place in places for v in place[k]]  # noqa: E731
    return {
        "link_R": flat(frames, 0),
        "link_position": flat(frames, 1),
        "tip_R": flat(tips, 0),
        "tip_position": flat(tips, 1),
    }


def assembly(chain: Chain, constants: str = "parameters") -> tuple[Program, list[tuple[int, int]]]:
    """``(x, tau, w_ext) -> (M, H, W)`` of the DAE form, with the places of the entries of ``M``."""
    places: list[tuple[int, int]] = []

    def body(f: DaeFunctions, x: Mapping[str, Sequence]) -> Outputs:
        entries, H, W = f.assemble(x["x"], x["tau"], x["w_ext"])
        places.extend(entries)
        return {"M": list(entries.values()), "H": H, "W": W}

    return fuse(chain, "assemble", inputs(chain, "x tau w_ext"), body, constants, DaeFunctions), places


def kinematic_rates(chain: Chain, constants: str = "parameters") -> Program:
    """``(x, z[, tau]) -> (ode)``: the differential equations of the DAE form, the accelerations given.

    ``tau`` is an input where drives are elastic or internal states may follow it.
    """

    def body(f: DaeFunctions, x: Mapping[str, Sequence]) -> Outputs:
        return {"ode": f.kinematic_rates(x["x"], x["z"], x.get("tau", ()))}

    given = inputs(chain, "x z tau" if chain.n_added or chain.n_force_states else "x z")
    return fuse(chain, "kinematic_rates", given, body, constants, DaeFunctions)


@program("x tau w_ext m_eta f_eta", kind=DaeFunctions)
def dae_dynamics(f: DaeFunctions, **x: Sequence) -> Outputs:
    """``(x, tau, w_ext, m_eta, f_eta) -> (xdot, vdot, wrench)``: the DAE form by block elimination."""
    f.given = (x["m_eta"], x["f_eta"])
    return dict(zip(("xdot", "vdot", "wrench"), f.rates(x["x"], x["tau"], x["w_ext"]), strict=True))


@program("x", kind=DaeFunctions)
def joint_rates(f: DaeFunctions, x: Sequence) -> Outputs:
    """``(x) -> (qdot)``: the joint rates that follow from the twists of the DAE form."""
    return {"qdot": f.joint_rates(x)}


@program("x", "project", kind=DaeFunctions)
def projection(f: DaeFunctions, x: Sequence) -> Outputs:
    """``(x) -> (projected)``: the state projected onto the joint constraints."""
    return {"projected": f.project(x)}


@program("q v", kind=DaeFunctions)
def placement(f: DaeFunctions, q: Sequence, v: Sequence) -> Outputs:
    """``(q, v) -> (x)``: the state of the DAE form from coordinates and rates."""
    return {"x": f.place(q, v)}
