"""The generalised forces of a motion by parameters in which they are linear, in CasADi.

Forces are not linear in a centre of mass, but they are in the first moment of the mass, and in the inertia about the
point from which the centre is meant. So these stand in place of a body's centre of mass and of its inertia about that.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import casadi as ca

from ...spec.parameters import Parameter, parameters
from ...topology.chain import Chain
from .functions import function

PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
"""The entries of an inertia in their order."""
BODY = MASS, COM, INERTIA = "bodies.mass", "bodies.com", "bodies.inertia"
MOMENT, ABOUT_POINT = ".first_moment[", ".inertia_about_point["


@dataclass(frozen=True)
class _Body:
    """The places of a body's numbers among the parameters."""

    mass: int
    com: tuple[int, ...]
    inertia: tuple[int, ...]


def linear_parameters(chain: Chain) -> tuple[Parameter, ...]:
    """The parameters, first moments and inertias about points in place of centres of mass and inertias about these."""
    out = list(parameters(chain.robot))
    for body in _bodies(chain):
        mass, com = out[body.mass].value, [out[k].value for k in body.com]
        for k, c in zip(body.com, com, strict=True):
            out[k] = replace(out[k], name=out[k].name.replace(".com[", MOMENT), value=mass * c, unit="kg·m")
        for (i, j), k in zip(PAIRS, body.inertia, strict=False):
            name = out[k].name.replace(".inertia[", ABOUT_POINT)
            out[k] = replace(out[k], name=name, value=out[k].value + _shifted(mass, com, i, j))
    return tuple(out)


def forces_by_parameters(
    chain: Chain, known: Mapping[str, ca.Function], chosen: Sequence[int]
) -> tuple[ca.Function, ca.Function]:
    """The regressor, and how it bends.

    ``regressor (q, v, vdot, w_ext, p) -> (Y, rest)``: by the chosen ones of :func:`linear_parameters`, at values p of
    the robot's own parameters. ``bends (q, v, vdot, w_ext, p, weights) -> (H)``: the second derivatives of the sum of
    weighted forces; an entry that is not stored is zero in all states and at all values of the parameters. Entries that
    a comparison with a parameter decides are stored, though their derivative is zero but where it jumps.
    """
    dynamics, values = known["inverse_dynamics"], parameters(chain.robot)
    given = {name: ca.SX.sym(name, dynamics.sparsity_in(name)) for name in ("q", "v", "vdot", "w_ext")}
    own, weights = ca.SX.sym("linear", len(values)), ca.SX.sym("weights", dynamics.size1_out(0))
    force = dynamics(*given.values(), _stated(chain, own))
    some = ca.vertcat(*[own[k] for k in chosen])
    slope = ca.jacobian(force, some)
    by_weights = ca.gradient(ca.dot(weights, force), some)
    bend = ca.project(ca.jacobian(by_weights, some), ca.jacobian_sparsity(by_weights, some))
    by_own = ca.Function("by_own", [*given.values(), own, weights], [slope, force - slope @ some, bend])
    p = ca.SX.sym("p", len(values))
    Y, rest, H = by_own(*given.values(), _linear(chain, p), weights)
    shown = given | {"p": p}
    return function("regressor", shown, Y=ca.densify(Y), rest=ca.densify(rest)), function(
        "bends", shown | {"weights": weights}, H=H
    )


def _bodies(chain: Chain) -> list[_Body]:
    """The bodies whose centre of mass is a parameter."""
    found: dict[tuple[int | None, int], dict[str, list[int]]] = {}
    for k, one in enumerate(parameters(chain.robot)):
        if one.field in BODY:
            found.setdefault((one.link, one.index[0]), {key: [] for key in BODY})[one.field].append(k)
    return [_Body(x[MASS][0], tuple(x[COM]), tuple(x[INERTIA])) for x in found.values() if x[MASS] and x[COM]]


def _shifted(mass: Any, com: Sequence[Any], i: int, j: int) -> Any:
    """The entry of ``mass (c·c 1 − c cᵀ)``."""
    return mass * ((com[0] ** 2 + com[1] ** 2 + com[2] ** 2 if i == j else 0.0) - com[i] * com[j])


def _linear(chain: Chain, p: ca.SX) -> ca.SX:
    """The linear parameters of the robot's own."""
    out = ca.vertsplit(p)
    for body in _bodies(chain):
        mass, com = p[body.mass], [p[k] for k in body.com]
        for k, c in zip(body.com, com, strict=True):
            out[k] = mass * c
        for (i, j), k in zip(PAIRS, body.inertia, strict=False):
            out[k] = p[k] + _shifted(mass, com, i, j)
    return ca.vertcat(*out)


def _stated(chain: Chain, linear: ca.SX) -> ca.SX:
    """The robot's own parameters of the linear ones."""
    out = ca.vertsplit(linear)
    for body in _bodies(chain):
        mass = linear[body.mass]
        com = [linear[k] / mass for k in body.com]
        for k, c in zip(body.com, com, strict=True):
            out[k] = c
        for (i, j), k in zip(PAIRS, body.inertia, strict=False):
            out[k] = linear[k] - _shifted(mass, com, i, j)
    return ca.vertcat(*out)
