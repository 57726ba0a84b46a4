"""Functions of the whole robot as single straight-line programs: phases inlined, zeros and constants folded."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import mpmath

from ..ir.program import Program, Tracer, Value
from ..ir.replay import inline, run
from ..spec.parameters import parameters
from ..topology.chain import Chain
from .columns import columns
from .dae_functions import DaeFunctions, state_size, unknown_size
from .functions import EVERYTHING, Functions
from .schedule import COLUMNS, Algorithm, constant_labels, preparation

ALL_COLUMNS = tuple(name for names in COLUMNS.values() for name in names)
DIGITS = 40

Body = Callable[[Functions, Mapping[str, Sequence[Value]]], Mapping[str, Sequence[Value]]]


def fuse(
    chain: Chain, name: str, inputs: Mapping[str, int], body: Body, constants="parameters", kind=Functions
) -> Program:
    """Trace a function of the whole robot into one program.

    ``constants`` says where the links' constants come from: prepared inside from an input ``p``
    (``"parameters"``), inputs of their own (``"constants"``), or numbers (``"baked"``); ``kind`` is the class of
    functions that ``body`` is given.
    """
    tracer = Tracer()
    values = {key: tracer.input(key, size) for key, size in inputs.items()}
    read: dict[str, int] = dict(inputs)
    links, gravity = _sources(chain, tracer, constants, read)
    names = chain.identifiers
    apply = lambda i, _, program, given: inline(program, given, tracer, names[i], i)  # noqa: E731
    functions = kind(chain, links, gravity, apply)
    functions.section = tracer.section
    outputs = body(functions, values)
    return tracer.program(name, read, {k: list(v) for k, v in outputs.items()})


def _sources(chain: Chain, tracer: Tracer, constants: str, read: dict[str, int]):
    if constants == "baked":
        return baked(chain), [p.value for p in parameters(chain.robot)[:3]]
    if constants == "parameters":
        size = len(parameters(chain.robot))
        p = tracer.input("p", size)
        read["p"] = size
        names = chain.identifiers
        return prepared(chain, p, lambda i, program, given: inline(program, given, tracer, names[i])), p[:3]
    links = []
    for i, key in enumerate(chain.keys):
        names = {f"c.{label}": 1 for label in constant_labels(key, EVERYTHING)}
        for part, span in chain.given(i).items():
            names |= dict.fromkeys(COLUMNS[part], span.stop - span.start)
        links.append({n: tracer.input(f"{i}:{n}", size) for n, size in names.items()})
        read |= {f"{i}:{n}": size for n, size in names.items()}
    read["gravity"] = 3
    return links, tracer.input("gravity", 3)


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
    for i, key in enumerate(chain.keys):
        program, places = preparation(key, constant_labels(key, algorithms)), chain.parameter_labels[i]
        outputs = evaluate(i, program, {name: [p[places[name[2:]]]] for name in program.inputs})
        out.append({name if name in ALL_COLUMNS else f"c.{name}": values for name, values in outputs.items()})
    return out


def exact(chain: Chain) -> tuple[list, list[dict[str, list]]]:
    """The parameters and the constants of every link in mpmath, at the precision of the surrounding context."""
    p = [mpmath.mpf(x.value) for x in parameters(chain.robot)]
    return p, prepared(chain, p, lambda _, program, given: run(program, given, precise)[0])


def baked(chain: Chain) -> list[dict[str, list[float]]]:
    """The constants of every link as numbers, evaluated with many digits: the same on every machine."""
    with mpmath.workdps(DIGITS):
        return [{n: [float(x) for x in v] for n, v in link.items()} for link in exact(chain)[1]]


def precise(op: str, x):
    """The unary primitives in mpmath."""
    if op == "neg":
        return -x
    if op == "on":
        return mpmath.mpf(x > 0)
    if op in ("c4", "c5", "c6", "c7"):
        return _stumpff(int(op[1]), x)
    return getattr(mpmath, op)(x)


def _stumpff(order: int, x):
    """The Stumpff series; at this precision it is accurate for every admissible rotation of a section."""
    term = 1 / mpmath.factorial(order)
    total, j = term, 0
    while abs(term) > mpmath.eps * abs(total):
        term *= -x / ((order + 2 * j + 1) * (order + 2 * j + 2))
        total, j = total + term, j + 1
    return total


# ------------------------------------------------------------------------------ the functions of a robot


def _dynamics_inputs(chain: Chain, given: bool) -> dict[str, int]:
    sizes = {"q": chain.nq, "v": chain.nv, "tau": chain.n_tau, "w_ext": 6 * chain.n}
    return sizes | ({"m_eta": chain.n_inertia, "f_eta": chain.n_given} if given else {})


def _dynamics(f: Functions, x: Mapping[str, Sequence[Value]]) -> dict[str, Sequence[Value]]:
    """``vdot`` and ``wrench``, with inertia and force of modes and sprung joints where they are inputs."""
    return {name: values for name, values in _watched(f, x).items() if name != "motion"}


def _watched(f: Functions, x: Mapping[str, Sequence[Value]]) -> dict[str, Sequence[Value]]:
    """The same, with the quantities of the motion that the validity measures need."""
    if "m_eta" in x:
        f.given = (x["m_eta"], x["f_eta"])
    vdot, wrench, motion = f.watched_dynamics(x["q"], x["v"], x["tau"], x["w_ext"])
    return {"vdot": vdot, "wrench": wrench, "motion": motion}


def forward_dynamics(chain: Chain, constants="parameters") -> Program:
    """``(q, v, tau, w_ext) -> (vdot, wrench)``."""
    return fuse(chain, "forward_dynamics", _dynamics_inputs(chain, False), _dynamics, constants)


def modal_dynamics(chain: Chain, constants="parameters") -> Program:
    """``(q, v, tau, w_ext, m_eta, f_eta) -> (vdot, wrench, motion)``: the forward dynamics of an integrator.

    ``m_eta`` and ``f_eta`` are the inertia and the force of stress and damping of every mode. If a joint is sprung,
    those of every joint coordinate precede them. Implicit steps give their own values.
    """
    return fuse(chain, "modal_dynamics", _dynamics_inputs(chain, True), _watched, constants)


def measures(chain: Chain, constants="parameters") -> Program:
    """``(q, wrench, motion) -> (measures)``: four numbers per link, see :mod:`..bodies.validity`."""
    inputs = {"q": chain.nq, "wrench": 6 * chain.n, "motion": 4 * chain.n}

    def body(f: Functions, x):
        return {"measures": f.measures(x["q"], x["wrench"], x["motion"])}

    return fuse(chain, "measures", inputs, body, constants)


def validity(chain: Chain, constants="parameters") -> Program:
    """``(q, v, tau, w_ext) -> (measures)``."""

    def body(f: Functions, x):
        found = _watched(f, x)
        return {"measures": f.measures(x["q"], found["wrench"], found["motion"])}

    return fuse(chain, "validity", _dynamics_inputs(chain, False), body, constants)


def complete_dynamics(chain: Chain, constants="constants") -> Program:
    """The forward dynamics of the generated C: :func:`modal_dynamics` with the pose of the last tip."""

    def body(f: Functions, x):
        outputs = _watched(f, x)
        R, position = f.poses(x["q"])[1][chain.last]
        return outputs | {"tip_rotation": R, "tip_position": position}

    return fuse(chain, "complete_dynamics", _dynamics_inputs(chain, True), body, constants)


def modal_properties(chain: Chain, constants="parameters") -> Program:
    """``() -> (M_eta, K, D)``: inertia, stiffness and damping behind the inputs of :func:`modal_dynamics`."""
    return fuse(chain, "modal_properties", {}, lambda f, _: columns(chain, f.constants), constants)


def loop_wrenches(chain: Chain, constants="parameters") -> Program:
    """``(q, v, tau, w_ext, m_eta, f_eta) -> (closed)``: the wrenches on all tips, those of the loops included."""

    def body(f: Functions, x):
        f.given = (x["m_eta"], x["f_eta"])
        return {"closed": f.with_loops(x["q"], x["v"], x["tau"], x["w_ext"])}

    return fuse(chain, "loop_wrenches", _dynamics_inputs(chain, True), body, constants)


def correction(chain: Chain, constants="parameters") -> Program:
    """``(q, v) -> (new_q, new_v)``: one correction of the gaps of the loops and of their rates."""

    def body(f: Functions, x):
        return dict(zip(("new_q", "new_v"), f.correct(x["q"], x["v"]), strict=True))

    return fuse(chain, "correction", {"q": chain.nq, "v": chain.nv}, body, constants)


def inverse_dynamics(chain: Chain, constants="parameters") -> Program:
    """``(q, v, vdot, w_ext) -> (force)``."""
    inputs = {"q": chain.nq, "v": chain.nv, "vdot": chain.nv, "w_ext": 6 * chain.n}

    def body(f: Functions, x):
        return {"force": f.inverse_dynamics(x["q"], x["v"], x["vdot"], x["w_ext"])}

    return fuse(chain, "inverse_dynamics", inputs, body, constants)


def bias(chain: Chain, constants="parameters") -> Program:
    """``(q, v, w_ext) -> (h)``: the bias force, which is the inverse dynamics without accelerations."""
    inputs = {"q": chain.nq, "v": chain.nv, "w_ext": 6 * chain.n}

    def body(f: Functions, x):
        return {"h": f.inverse_dynamics(x["q"], x["v"], [0.0] * chain.nv, x["w_ext"])}

    return fuse(chain, "bias", inputs, body, constants)


def levers(chain: Chain, constants="parameters") -> Program:
    """``(q) -> (levers)``: what the torque of each axis is multiplied by."""
    return fuse(chain, "levers", {"q": chain.nq}, lambda f, x: {"levers": f.levers(x["q"])}, constants)


def inertial_force(chain: Chain, constants="parameters") -> Program:
    """``(q, vdot) -> (force)`` at rest: its Jacobian in ``vdot`` is the mass matrix."""

    def body(f: Functions, x):
        still = Functions(chain, f.constants, [0.0] * 3, f.apply)
        rest = {"q": x["q"], "v": [0.0] * chain.nv, "w_ext": [0.0] * 6 * chain.n}
        return {"force": still.inverse_dynamics(vdot=x["vdot"], **rest)}

    return fuse(chain, "inertial_force", {"q": chain.nq, "vdot": chain.nv}, body, constants)


def energy(chain: Chain, constants="parameters") -> Program:
    """``(q, v) -> (kinetic, potential)``."""

    def body(f: Functions, x):
        kinetic, potential = f.energy(x["q"], x["v"])
        return {"kinetic": [kinetic], "potential": [potential]}

    return fuse(chain, "energy", {"q": chain.nq, "v": chain.nv}, body, constants)


def coordinate_rates(chain: Chain, constants="parameters") -> Program:
    """``(q, v) -> (qdot)``."""

    def body(f: Functions, x):
        return {"qdot": f.coordinate_rates(x["q"], x["v"])}

    return fuse(chain, "coordinate_rates", {"q": chain.nq, "v": chain.nv}, body, constants)


def poses(chain: Chain, constants="parameters") -> Program:
    """``(q) -> (link_R, link_position, tip_R, tip_position)``, every R row by row, link by link."""

    def body(f: Functions, x):
        frames, tips = f.poses(x["q"])
        flat = lambda places, k: [v for place in places for v in place[k]]  # noqa: E731
        return {
            "link_R": flat(frames, 0),
            "link_position": flat(frames, 1),
            "tip_R": flat(tips, 0),
            "tip_position": flat(tips, 1),
        }

    return fuse(chain, "poses", {"q": chain.nq}, body, constants)


def assembly(chain: Chain, constants="parameters") -> tuple[Program, list[tuple[int, int]]]:
    """``(x, tau, w_ext) -> (M, H, W)`` of the DAE form, with the places of the entries of ``M``."""
    inputs = {"x": state_size(chain), "tau": chain.n_tau, "w_ext": 6 * chain.n}
    places: list[tuple[int, int]] = []

    def body(f: DaeFunctions, x):
        entries, H, W = f.assemble(x["x"], x["tau"], x["w_ext"])
        places.extend(entries)
        return {"M": list(entries.values()), "H": H, "W": W}

    return fuse(chain, "assemble", inputs, body, constants, DaeFunctions), places


def kinematic_rates(chain: Chain, constants="parameters") -> Program:
    """``(x, z[, tau]) -> (ode)``: the differential equations of the DAE form, the accelerations given.

    ``tau`` is an input where drives are elastic.
    """

    def body(f: DaeFunctions, x):
        return {"ode": f.kinematic_rates(x["x"], x["z"], x.get("tau", ()))}

    sizes = {"x": state_size(chain), "z": unknown_size(chain)} | ({"tau": chain.n_tau} if chain.n_motors else {})
    return fuse(chain, "kinematic_rates", sizes, body, constants, DaeFunctions)


def dae_dynamics(chain: Chain, constants="parameters") -> Program:
    """``(x, tau, w_ext, m_eta, f_eta) -> (xdot, vdot, wrench)``: the DAE form by block elimination."""
    inputs = {
        "x": state_size(chain),
        "tau": chain.n_tau,
        "w_ext": 6 * chain.n,
        "m_eta": chain.n_inertia,
        "f_eta": chain.n_given,
    }

    def body(f: DaeFunctions, x):
        f.given = (x["m_eta"], x["f_eta"])
        xdot, vdot, wrench = f.rates(x["x"], x["tau"], x["w_ext"])
        return {"xdot": xdot, "vdot": vdot, "wrench": wrench}

    return fuse(chain, "dae_dynamics", inputs, body, constants, DaeFunctions)


def joint_rates(chain: Chain, constants="parameters") -> Program:
    """``(x) -> (qdot)``: the joint rates that follow from the twists of the DAE form."""

    def body(f: DaeFunctions, x):
        return {"qdot": f.joint_rates(x["x"])}

    return fuse(chain, "joint_rates", {"x": state_size(chain)}, body, constants, DaeFunctions)


def projection(chain: Chain, constants="parameters") -> Program:
    """``(x) -> (projected)``: the state projected onto the joint constraints."""

    def body(f: DaeFunctions, x):
        return {"projected": f.project(x["x"])}

    return fuse(chain, "project", {"x": state_size(chain)}, body, constants, DaeFunctions)


def placement(chain: Chain, constants="parameters") -> Program:
    """``(q, v) -> (x)``: the state of the DAE form from coordinates and rates."""

    def body(f: DaeFunctions, x):
        return {"x": f.place(x["q"], x["v"])}

    return fuse(chain, "placement", {"q": chain.nq, "v": chain.nv}, body, constants, DaeFunctions)
