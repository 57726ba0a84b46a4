"""The model in the fields of acados' ``AcadosModel``: ``model.acados()``.

acados itself is not needed: the export holds CasADi expressions on SX, and :meth:`AcadosExport.into` hands them over.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

import casadi as ca

from ...algorithms import linear_model
from ...algorithms.dae_functions import dae_names, state_size, unknown_size
from ...errors import UsageError
from ...spec.parameters import WRENCH, coordinate_names, parameters
from ...topology.chain import Chain
from .functions import by_inputs, coordinate_rates, expressions

FORMS = ("joint", "dae")
BINDINGS = ("runtime", "baked")
FIELDS = ("name", "x", "xdot", "u", "z", "p", "f_expl_expr", "f_impl_expr", "x_labels", "u_labels")
"""What ``AcadosModel`` has."""

Target = TypeVar("Target")


@dataclass(frozen=True, repr=False)
class AcadosExport:
    """A model for acados; columns of SX, SI units, radians.

    ``x`` (nx, 1): the state; ``xdot``: symbols of its rate; ``u``: joint torques ``tau`` in N m; ``z`` (nz, 1): the
    algebraic unknowns; ``p``: parameters.  ``f_expl_expr`` (nx, 1): ``xdot`` of ``x, u, p``, or None;
    ``f_impl_expr`` (nx + nz, 1): zero along motions, and regular in ``xdot, z``: index 1.  The labels name the entries.

    Parameters' values have their place in ``AcadosOcp`` and ``AcadosSim``: ``ocp.parameter_values =
    numpy.array(export.parameter_values)``.
    """

    name: str
    x: ca.SX
    xdot: ca.SX
    u: ca.SX
    z: ca.SX
    p: ca.SX
    f_expl_expr: ca.SX | None
    f_impl_expr: ca.SX
    x_labels: tuple[str, ...]
    u_labels: tuple[str, ...]
    z_labels: tuple[str, ...]
    p_labels: tuple[str, ...]
    parameter_values: tuple[float, ...]

    def into(self, acados_model: Target) -> Target:
        """Set the fields of an ``AcadosModel`` and return it; its other fields stay as they are."""
        for field in FIELDS:
            value = getattr(self, field)
            setattr(acados_model, field, list(value) if isinstance(value, tuple) else value)
        return acados_model

    def __repr__(self) -> str:
        sizes = ", ".join(f"{n} {getattr(self, n).numel()}" for n in ("x", "u", "z", "p"))
        return f"<AcadosExport of {self.name}: {sizes}>"


def acados(
    chain: Chain, functions: Mapping[str, Any], form: str = "joint", binding: str = "runtime", w_ext: bool = False
) -> AcadosExport:
    """The export of a chain from its CasADi functions; see :meth:`screwgen.Model.acados`."""
    chain.refuse_quaternion_joints("acados model", "take the CasADi functions")
    _check("form", form, FORMS)
    _check("binding of the parameters", binding, BINDINGS)
    tau = ca.SX.sym("tau", chain.n_tau)
    p, robot_p, wrenches, labels, values = _parameters(chain, binding, w_ext)
    instead = "step it by `casadi` or compiled C, which share the forces of these rows"
    chain.needs_independent_rows("export to acados, whose unknowns must be unique", instead)
    maker = _joint if form == "joint" else _dae
    parts = maker(chain, functions, tau, wrenches, robot_p)
    u_labels = tuple(coordinate_names(chain.robot).tau)
    return AcadosExport(
        name=chain.robot.name, u=tau, p=p, u_labels=u_labels, p_labels=labels, parameter_values=values, **parts
    )


def _check(what: str, given: object, allowed: tuple[str, ...]) -> None:
    if given not in allowed:
        raise UsageError(f"there is no {what} '{given}'; choose {' or '.join(allowed)}")


def _parameters(
    chain: Chain, binding: str, w_ext: bool
) -> tuple[ca.SX, ca.SX, ca.SX, tuple[str, ...], tuple[float, ...]]:
    """The column p, the robot's parameters and the tip wrenches (6 x n) in it, names and values of its entries."""
    own = parameters(chain.robot)
    values, names = [p.value for p in own], [p.name for p in own]
    symbols = ca.SX.sym("p", len(own))
    wrenches = ca.SX.sym("w_ext", 6, chain.n) if w_ext else ca.SX.zeros(6, chain.n)
    wrench_names = [f"{s.tipped}.w_ext.{c}" for s in chain.segments for c in WRENCH] if w_ext else []
    changeable = binding == "runtime"
    p = ca.vertcat(symbols if changeable else ca.SX(0, 1), ca.vec(wrenches) if w_ext else ca.SX(0, 1))
    labels = (names if changeable else []) + wrench_names
    numbers = (values if changeable else []) + [0.0] * len(wrench_names)
    return p, symbols if changeable else ca.SX(ca.DM(values)), wrenches, tuple(labels), tuple(numbers)


def _joint(chain: Chain, functions: Mapping, tau: ca.SX, w_ext: ca.SX, p: ca.SX) -> dict[str, Any]:
    """x = [q; v].  Implicit: ``qdot - v`` and ``inverse_dynamics - [tau; 0]``, which cost less than ``xdot - f``, and
    the rates of internal states.

    Of a floating base ``qdot`` is that of position and quaternion, whose length nothing corrects: the dynamics do not
    depend on it. Where loops close the tree, z are the forces of their rows, and the rows ``g̈ + 2 c ġ + c² g = 0``
    stand last: in place of g itself, so that the index is 1.
    """
    nq, nv, names = chain.nq, chain.nv, coordinate_names(chain.robot)
    x, xdot = ca.SX.sym("x", nq + chain.nvz), ca.SX.sym("xdot", nq + chain.nvz)
    q, v = x[:nq], x[nq:]
    rates = coordinate_rates(chain, q, v, p)
    vdot = functions["forward_dynamics"](q, v, tau, w_ext, p)[0]
    z = ca.SX.sym("force", len(chain.closing.rows))
    rows, torques, loads = _closing(chain, q, v, xdot[nq:], z, p) if chain.closing.rows else (ca.SX(0, 1), 0, 0)
    force = functions["inverse_dynamics"](q, v, xdot[nq:], w_ext + loads, p)
    driven = ca.SX(nv, 1)
    torques_of_axes = tau[: chain.n_joints]
    driven[chain.effort_places] = torques_of_axes * functions["levers"](q, p) if chain.travels else torques_of_axes
    if chain.other_inputs:
        driven += by_inputs(chain, q, v, tau, p)
    for joint, place in chain.elastic_travels.items():
        driven[place] = tau[joint]
    if chain.closing.couplings:
        driven[chain.base_v : chain.base_v + chain.n_joints] += torques
    balance = force - driven
    for number, place in chain.given.items():  # its acceleration in place of its balance
        balance[place] = xdot[nq + place] - tau[number]
    if chain.braked:
        at = [chain.held_places[joint] for joint in chain.braked]
        given = {"q": q, "v": v, "vdot": xdot[nq:], "tau": tau, "efforts": balance[at], "p": p}
        balance[at] = expressions(linear_model.braked_balance(chain), given)["balance"]
    internal = xdot[nq + nv :] - vdot[nv:]
    implicit = ca.vertcat(xdot[:nq] - rates, balance, internal, rows)
    return {
        "x": x,
        "xdot": xdot,
        "z": z,
        "f_expl_expr": ca.densify(ca.vertcat(rates, vdot)),
        "f_impl_expr": ca.densify(implicit),
        "x_labels": (*names.q, *names.v),
        "z_labels": _row_names(chain),
    }


def _row_names(chain: Chain) -> tuple[str, ...]:
    """The forces of the loops' rows, N, of angles N m: ``loop[0].force[0]``, numbered in each loop."""
    names = [row.name for row in chain.closing.rows]
    return tuple(f"{name}.force[{names[:k].count(name)}]" for k, name in enumerate(names))


def _closing(chain: Chain, q: ca.SX, v: ca.SX, vdot: ca.SX, forces: ca.SX, p: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
    """The rows of the loops at given accelerations, and what their forces exert: on axes, and on tips (6 x n)."""
    given = {"q": q, "v": v, "vdot": vdot, "forces": forces, "p": p}
    found = expressions(linear_model.gap_accelerations(chain), given)
    return found["rows"], found["torque"], ca.reshape(found["wrench"], 6, chain.n)


def _dae(chain: Chain, functions: Mapping, tau: ca.SX, w_ext: ca.SX, p: ca.SX) -> dict[str, Any]:
    """The state and the unknowns of ``model.dae_names``.  The implicit rows are ``xdot - ode`` and ``alg``."""
    x, z = ca.SX.sym("x", state_size(chain)), ca.SX.sym("z", unknown_size(chain))
    xdot, dae, names = ca.SX.sym("xdot", state_size(chain)), functions["dae"], dae_names(chain)
    integrand = ca.Function("dae", [dae[k] for k in ("x", "z", "u", "p")], [dae["ode"], dae["alg"]])
    ode, alg = integrand(x, z, ca.vertcat(tau, ca.vec(w_ext)), p)
    return {
        "x": x,
        "xdot": xdot,
        "z": z,
        "f_expl_expr": None,
        "f_impl_expr": ca.densify(ca.vertcat(xdot - ode, alg)),
        "x_labels": tuple(names["x"]),
        "z_labels": tuple(names["z"]),
    }
