"""The CasADi back end: the robot's functions as casadi.Function, on SX.

Vectors are columns; ``w_ext`` and ``wrench`` are 6 x n, a column per link; ``p`` holds the parameters of
the robot file.  The functions take SX and MX, differentiate, serialise and generate C.
"""

from __future__ import annotations

import tempfile
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, partial
from pathlib import Path
from typing import Any

import casadi as ca

from ...algorithms import fused
from ...algorithms import robot_programs as programs
from ...algorithms.dae_functions import unknown_size
from ...algorithms.functions import Functions
from ...algorithms.linearise import slopes
from ...algorithms.robot_function import RobotFunction, is_matrix, shape
from ...algorithms.robot_functions import offered
from ...algorithms.signals import Signal
from ...algorithms.tip_programs import COMPLIANT, settled_rows
from ...arguments import choice
from ...errors import TargetWarning, UsageError
from ...ir.program import Program
from ...spec.base import POSE
from ...spec.parameters import parameters, per_base, travels, turning
from ...spec.robot import Robot
from ...topology.chain import Chain
from ..lazy import LazyFunctions
from ..templates import render
from .checked import CheckedFunction
from .expressions import expressions
from .patterns import jacobians, structures


def symbols(chain: Chain, names: str) -> dict[str, ca.SX]:
    """Inputs of functions by name, in the order of ``names``, which blanks separate."""
    own = {"w_ext": (6, chain.n), "p": (len(parameters(chain.robot)),), "dt": (1,)}
    return {name: ca.SX.sym(name, *(own.get(name) or fused.inputs(chain, name).values())) for name in names.split()}


def functions(chain: Chain) -> dict[str, Callable[[], Any]]:
    """What makes the functions of the joint form, by name."""
    given = symbols(chain, "q v vdot tau w_ext p")

    @cache
    def outputs(maker: Callable[[Chain], Program]) -> dict[str, ca.SX]:
        return expressions(maker(chain), given)

    def made(name: str, inputs: Sequence[str], results: Callable[[], Mapping[str, ca.SX]]) -> Callable:
        return lambda: function(name, {k: given[k] for k in (*inputs, "p")}, **results())

    def results(row: RobotFunction) -> dict[str, ca.SX]:
        found = outputs(row.program)
        return {name: shaped(found[name], signal, chain) for name, signal in row.results.items()}

    def mass_matrix() -> dict[str, ca.SX]:
        if chain.curved:
            return {"M": ca.jacobian(outputs(fused.inertial_force)["force"], given["vdot"][: chain.nv])}
        lower = ca.SX(ca.Sparsity.lower(chain.nv).T, outputs(_inertia)["lower"]).T
        return {"M": ca.sparsify(ca.tril2symm(lower))}

    rows = {row.name: made(row.name, row.names, partial(results, row)) for row in offered(chain)}
    return rows | {"mass_matrix": made("mass_matrix", ("q",), mass_matrix)}


def shaped(values: ca.SX, signal: Signal, chain: Chain) -> ca.SX:
    """A result as CasADi's matrices have it: a column per link, matrices (stored row by row) side by side."""
    whole = shape(signal, chain)
    if is_matrix(signal) or len(whole) == 3:
        return side_by_side(values, *whole[-2:])
    return ca.reshape(values, whole[1], whole[0]) if len(whole) == 2 else values


@fused.program("q", "mass_matrix")
def _inertia(f: Functions, q: Sequence) -> fused.Outputs:
    """``(q) -> (lower)``: the lower triangle of the mass matrix, row by row."""
    rest, nothing = [0.0] * f.chain.nv, [0.0] * 6 * f.chain.n
    M = slopes(f, q, rest, rest, nothing, [0.0] * f.chain.n_tau).M
    return {"lower": [M[i, j] for i in range(f.chain.nv) for j in range(i + 1)]}


def dae_functions(chain: Chain) -> dict[str, Callable[[], ca.Function]]:
    """What makes the DAE form: ``assemble``, and ``dae_state``, which puts coordinates and rates onto the joints."""
    given = symbols(chain, "x tau w_ext q v p")

    def assemble() -> ca.Function:
        program, places = fused.assembly(chain)
        parts, size = expressions(program, given), unknown_size(chain)
        rows, columns = [i for i, _ in places], [j for _, j in places]
        M = ca.SX.triplet(rows, columns, parts["M"], size, size)
        inputs = {k: given[k] for k in ("x", "tau", "w_ext", "p")}
        return function("assemble", inputs, M_sys=M, H_sys=parts["H"], W_sys=parts["W"])

    def dae_state() -> ca.Function:
        x = expressions(fused.placement(chain), given)["x"]
        return function("dae_state", {k: given[k] for k in ("q", "v", "p")}, x=x)

    return {"assemble": assemble, "dae_state": dae_state}


def dae(chain: Chain, assemble: ca.Function) -> dict[str, ca.SX]:
    """``dict(x, z, u, p, ode, alg)`` for ``casadi.integrator``: ``alg = M_sys z + H_sys - W_sys``.

    The order of x and z is ``model.dae_names``.  Integrators of CasADi do not project: the joints drift
    by the integrator's own error.
    """
    given = symbols(chain, "x z p")
    u = ca.SX.sym("u", chain.n_tau + 6 * chain.n)
    tau, w_ext = u[: chain.n_tau], ca.reshape(u[chain.n_tau :], 6, chain.n)
    M, H, W = assemble(given["x"], tau, w_ext, given["p"])
    ode = expressions(fused.kinematic_rates(chain), given | {"tau": tau})["ode"]
    return dict(x=given["x"], z=given["z"], u=u, p=given["p"], ode=ode, alg=M @ given["z"] + H - W)


def modal_functions(chain: Chain) -> LazyFunctions:
    """What integrators need: ``modal_dynamics``, ``modal_properties``, and those of the DAE form.

    ``dae_dynamics``, ``joint_rates``, ``project``.  ``f_eta`` belongs to the last ``chain.n_given`` of q, and so
    does ``m_eta``, which ends with the entries below the diagonal where modes are coupled.
    """
    given = symbols(chain, "q v tau w_ext m_eta f_eta x wrench motion p")

    @cache
    def found(program: fused.Maker) -> dict[str, ca.SX]:
        out = expressions(program(chain), given)
        return out | ({"wrench": ca.reshape(out["wrench"], 6, chain.n)} if "wrench" in out else {})

    def making(name: str, inputs: str, program: fused.Maker, *results: str) -> Callable[[], ca.Function]:
        taken = {k: given[k] for k in inputs.split()}
        return lambda: function(name, taken, **{k: x for k, x in found(program).items() if k in results or not results})

    joint, dae = "q v tau w_ext m_eta f_eta p", "x tau w_ext m_eta f_eta p"
    rows = (
        ("dae_dynamics", dae, fused.dae_dynamics),
        ("joint_rates", "x p", fused.joint_rates),
        ("project", "x p", fused.projection),
        ("modal_dynamics", joint, fused.modal_dynamics, "vdot", "wrench"),
        ("watched_dynamics", joint, fused.modal_dynamics, "wrench", "motion"),
        ("measures", "q wrench motion p", fused.measures),
        ("modal_properties", "p", fused.modal_properties),
    )
    return LazyFunctions({row[0]: making(*row) for row in rows} | _beside_dynamics(chain))


def _beside_dynamics(chain: Chain) -> dict[str, Callable[[], ca.Function]]:
    """What steps need besides in both forms: the rates of the internal states of forces between frames, and what rows
    that give way bear at the end of a step."""

    def made(name: str, make: Callable[[Chain], Program]) -> ca.Function:
        program = make(chain)
        given = {x: ca.SX.sym(x, size) for x, size in program.inputs.items()}
        return function(name, given, **expressions(program, given))

    in_dae = {f"dae_{make.__name__}": partial(make, dae=True) for make in COMPLIANT}
    rows: dict[str, Callable] = (
        {make.__name__: make for make in (*COMPLIANT, settled_rows)} | in_dae if chain.compliant else {}
    )
    if chain.n_force_states:
        rows |= {"force_rates": programs.force_rates, "dae_force_rates": programs.dae_force_rates}
    return {name: partial(made, name, make) for name, make in rows.items()}


def function(name: str, inputs: Mapping[str, ca.SX], **outputs: ca.SX) -> ca.Function:
    return CheckedFunction(name, list(inputs.values()), list(outputs.values()), list(inputs), list(outputs))


def ode(chain: Chain, dynamics: ca.Function) -> dict[str, ca.SX]:
    """``dict(x, u, p, ode)`` of the joint form for ``casadi.integrator``: x = [q; v], u = [tau; vec(w_ext)]."""
    x, u = ca.SX.sym("x", chain.nq + chain.nvz), ca.SX.sym("u", chain.n_tau + 6 * chain.n)
    p = ca.SX.sym("p", dynamics.size1_in("p"))
    q, v = x[: chain.nq], x[chain.nq :]
    w_ext = ca.reshape(u[chain.n_tau :], 6, chain.n)
    vdot = dynamics(q, v, u[: chain.n_tau], w_ext, p)[0]
    return dict(x=x, u=u, p=p, ode=ca.vertcat(coordinate_rates(chain, q, v, p), vdot))


def coordinate_rates(chain: Chain, q: ca.SX, v: ca.SX, p: ca.SX) -> ca.SX:
    """``dq/dt``, which is v but for joints whose coordinates do not add up."""
    return (
        expressions(fused.coordinate_rates(chain), {"q": q, "v": v, "p": p})["qdot"] if chain.curved else v[: chain.nv]
    )


def exerted(chain: Chain, q: ca.SX, v: ca.SX, tau: ca.SX, p: ca.SX) -> ca.SX:
    """(nv, inputs): the generalised forces per unit of each input but torques of axes."""
    found = expressions(programs.exerted(chain), {"q": q, "v": v, "tau": tau, "p": p})["exerted"]
    return ca.densify(ca.reshape(found, chain.nv, chain.n_tau - chain.n_joints))


def by_inputs(chain: Chain, q: ca.SX, v: ca.SX, tau: ca.SX, p: ca.SX) -> ca.SX:
    """(nv,): the generalised forces of all inputs but torques of axes."""
    return expressions(programs.by_inputs(chain), {"q": q, "v": v, "tau": tau, "p": p})["force"]


def side_by_side(entries: ca.SX, rows: int, columns: int) -> ca.SX:
    """Matrices stored one after the other, row by row, side by side."""
    size = rows * columns
    parts = [entries[k : k + size] for k in range(0, entries.numel() if size else 0, size)]
    return ca.horzcat(ca.SX(rows, 0), *(ca.reshape(part, columns, rows).T for part in parts))


# ------------------------------------------------------------------------------------ the CasADi target

DEFAULT = ("forward_dynamics", "inverse_dynamics", "energy", "tip_pose", "link_pose")
"""The functions that are written by default: those that grow with the links and do not follow from another."""

INTEGRANDS = {"ode": (("x", "u", "p"), ("ode",)), "dae": (("x", "z", "u", "p"), ("ode", "alg"))}


def stated(asked: Sequence[str] | str | None) -> tuple[str, ...]:
    """The names that are asked for, ``"all"`` perhaps among them."""
    return DEFAULT if asked is None else (asked,) if isinstance(asked, str) else tuple(asked)


def chosen(asked: Sequence[str] | str | None, known: Iterable[str]) -> tuple[str, ...]:
    """The names of the functions to write: those asked for, DEFAULT (None), or all (``"all"``, also in a list).

    All are without the single steps, of which ``step`` is one.  Raises UsageError for an unknown name.
    """
    names = stated(asked)
    every = tuple(name for name in known if not name.startswith("step_"))
    for name in names:
        choice(name, (*known, "all"), "there is no function")
    return tuple(dict.fromkeys(x for name in names for x in (every if name == "all" else (name,))))


def casadi_files(
    robot: Robot,
    functions: Mapping,
    asked: Sequence[str] | str | None,
    parameter_names: Sequence[str],
    version: str,
    notes: Mapping[str, Sequence[str]],
) -> dict[str, bytes]:
    """``NAME.casadi`` per function asked for and a README: signatures, and the sparsity of the Jacobians.

    ``asked`` as :func:`chosen` takes it; ``notes``: paragraphs on functions that plug-ins add, with the names of these.
    Of all functions those that the robot does not have are left out, each with a :class:`TargetWarning`.
    """
    saved, missing = there(functions, asked)
    for name, reason in missing.items():
        warnings.warn(f"there is no CasADi function '{name}': {reason}", TargetWarning, stacklevel=4)
    files = {f"{name}.casadi": _serialised(f) for name, f in saved.items()}
    rows = [{"name": name, "inputs": signature(f, "in"), "outputs": signature(f, "out")} for name, f in saved.items()]
    patterns = {"jacobians": jacobians(saved), "structures": structures(robot, saved)}
    readme = render(
        "casadi/README.md.jinja",
        name=robot.name,
        version=version,
        casadi=".".join(ca.CasadiMeta.version().split(".")[:2]),
        functions=rows,
        others=[name for name in functions if name not in saved | missing],
        parameters=parameter_names,
        sliding=not all(turning(robot)),
        efforts=list(dict.fromkeys(kind.EFFORTS for kind in travels(robot))),
        pose=per_base(robot, POSE),
        balls=[link.name for link in robot.links if link.joint.kind.curved],
        split=any(link.pieces > 1 for link in robot.links),
        notes=[text for text, of in notes.items() if not saved.keys().isdisjoint(of)],
        **patterns,
    )
    return files | {"README.md": readme.encode()}


def there(functions: Mapping, asked: Sequence[str] | str | None) -> tuple[dict[str, ca.Function], dict[str, str]]:
    """The functions asked for, and of all functions those that the robot does not have, with the reason.

    Raises UsageError where it does not have one that is asked for by its name.
    """
    saved, missing = {}, {}
    for name in chosen(asked, functions):
        try:
            saved[name] = as_function(name, functions[name])
        except UsageError as error:
            if name in stated(asked):
                raise
            missing[name] = str(error)
    return saved, missing


def as_function(name: str, value: Any) -> ca.Function:
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


def signature(f: ca.Function, side: str) -> str:
    """``q[9], v[9], w_ext[6x2]``."""
    count, name, size = (getattr(f, f"{x}_{side}") for x in ("n", "name", "size"))
    shapes = [size(i) for i in range(count())]
    return ", ".join(f"{name(i)}[{r}x{c}]" if c > 1 else f"{name(i)}[{r}]" for i, (r, c) in enumerate(shapes))
