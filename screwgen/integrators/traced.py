"""A time step in programs: the traced accelerations that a :class:`~.method.Method` asks for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from typing import Any

import numpy as np

from ..algorithms import matrices as mx
from ..algorithms.axis_laws import of_robot
from ..algorithms.columns import columns
from ..algorithms.functions import EVERYTHING, HOLD, Functions
from ..algorithms.fused import Outputs, fuse, inputs
from ..algorithms.law_programs import stage, state_rate
from ..algorithms.parameter_slopes import Differentiable
from ..algorithms.schedule import COLUMNS
from ..ir.derivative import gradients
from ..ir.program import Array, Program, Value
from ..topology.chain import Chain
from .method import Method, Motion
from .space import replayed


class TracedAccelerations:
    """Accelerations of nodes at held inputs: a :class:`~.method.Accelerations`."""

    def __init__(self, f: Functions, tau: Sequence[Value], w_ext: Sequence[Value]):
        self.f, self.held = f, (tau, w_ext)
        self.properties = {name: _array(own) for name, own in columns(f.chain, f.constants).items()}

    def explicit(self, q: Array, v: Array) -> Array:
        return self.implicit(q, v, 0.0)

    def implicit(self, q: Array, v: Array, h: Any, there: Motion | None = None) -> Array:
        ahead = there is not None and there[0] is not q
        return self.at_stage((q, v), h, there or (q, v), float(ahead))

    def at_stage(self, start: Motion, h: Any, there: Motion, ahead: Value) -> Array:
        """The same; ``ahead``: 1 at a stage ahead of the start, else 0."""
        chain, (q, v), (q_there, v_there) = self.f.chain, start, there
        x, rates = q[list(chain.given_places)], slice(chain.nv - chain.n_given, chain.nv)
        rate, later = v[rates], v_there[rates]
        M, K, D = (self.properties[name] for name in COLUMNS["eta"])
        times = chain.modal_product
        inertia, force = M + h * (D + h * K), times(K, x + h * rate) + times(D, rate)
        remembering = []
        for law, coordinates, sides, axes in of_robot(chain):
            for k, (i, side) in enumerate(zip(coordinates, sides, strict=True)):
                given = {name: [self.properties[name][k]] for name in law.constants}
                given |= {"side": [float(side)], "x": [x[i]], "w": [rate[i]], "there": [later[i]], "h": [h]}
                given |= {"axis": [x[axes[k]]]} if axes else {}
                if law in chain.internal:
                    given |= {"z": [v[chain.internal[law][k]]]}
                    remembering.append((chain.internal[law][k], law, rates.start + i, given))
                found = self.f.apply(0, -1, stage(law), given)
                inertia[i], force[i] = inertia[i] + found["inertia"][0], force[i] + found["force"][0]
        under = copy(self.f)
        under.given = list(inertia), list(force)
        (tau, w_ext), moved = self.held, (list(q_there), list(v_there))
        if chain.compliant and not isinstance(h, float):
            w_ext = under.with_rows(*moved, tau, w_ext, under.row_terms(list(q), list(v)), h, ahead)
        vdot = under.forward_dynamics(*moved, tau, w_ext)[0]
        rate_of = lambda law, i, given: self.f.apply(0, -1, state_rate(law), given | {"a": [vdot[i]]})  # noqa: E731
        order = sorted(remembering, key=lambda one: one[0])
        states = list(v[chain.force_states])
        of_forces = self.f.under_inputs(self.held[0]).force_rates(list(q_there), list(v_there), states, h)
        return _array([*vdot, *(rate_of(*one)["rate"][0] for _, *one in order), *of_forces])


def step(chain: Chain, method: Method) -> Differentiable:
    """``(q, v, tau, w_ext, dt) -> (q_next, v_next)``, the inputs held, efforts within their limits."""

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Outputs:
        def run(program: Program, given: dict[str, Any]) -> dict[str, Any]:
            found = f.apply(0, -1, program, {name: list(values) for name, values in given.items()})
            return {name: _array(values) for name, values in found.items()}

        tau = f.held(x["q"], x["v"], x["tau"]) if chain.holds else x["tau"]
        held = TracedAccelerations(f, tau, x["w_ext"])
        q, v = method.step(held, _array(x["q"]), _array(x["v"]), x["dt"][0], replayed(chain, run))
        return {"q_next": list(q), "v_next": list(v)}

    given = inputs(chain, "q v tau w_ext") | {"dt": 1}
    shapes = {"q_next": (chain.nq,), "v_next": (chain.nvz,)}
    return Differentiable(f"step_{method}", given, shapes, body, (*EVERYTHING, HOLD))


def stage_slopes(chain: Chain, constants: str = "constants") -> Program:
    """``(q, v, tau, w_ext, q_start, v_start, h, ahead, weights) -> (vdot, by_q, by_v, by_tau, by_q_start, …)``.

    The accelerations of an implicit stage at ``q, v``, which takes what is implicit ``h`` after the start, and the
    derivatives of their sum with ``weights`` (nvz,); those along coordinates are (nv,).  ``ahead``: as of
    :mod:`..algorithms.compliant_functions`.
    """

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> Outputs:
        held = TracedAccelerations(f, x["tau"], x["w_ext"])
        start, there = (_array(x["q_start"]), _array(x["v_start"])), (_array(x["q"]), _array(x["v"]))
        vdot = list(held.at_stage(start, x["h"][0], there, x["ahead"][0]))
        names = ("q", "v", "tau", "q_start", "v_start")
        found = gradients(vdot, x["weights"], [value for name in names for value in x[name]])
        slopes = dict(zip(names, np.split(_array(found), np.cumsum([len(x[n]) for n in names])[:-1]), strict=True))
        for name in ("q", "q_start"):
            ways = [f.coordinate_rates(x[name], [float(i == k) for i in range(chain.nv)]) for k in range(chain.nv)]
            slopes[name] = _array([mx.dot(mx.array(way), slopes[name]) for way in ways])
        return {"vdot": vdot, **{f"by_{name}": list(values) for name, values in slopes.items()}}

    given = inputs(chain, "q v tau w_ext") | {"q_start": chain.nq, "v_start": chain.nvz, "h": 1, "ahead": 1}
    return fuse(chain, "stage_slopes", given | {"weights": chain.nvz}, body, constants)


def _array(values: Sequence[Value]) -> Array:
    return np.fromiter(values, object)
