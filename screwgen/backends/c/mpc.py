"""The predictive controller of the C back end: sizes, tables and programs of its templates."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from math import inf
from typing import Any, NamedTuple

import numpy as np

from ...algorithms.gauges import Gauge, curvatures, gauges
from ...algorithms.tip_terms import tip_terms
from ...arguments import Numbers
from ...errors import UsageError
from ...spec.mpc import VARIABLES, Between, Mpc
from ...spec.parameters import coordinate_names
from ...spec.tendons import TENSIONS
from ...topology.chain import Chain
from ..templates import FEATURES, folder
from . import mpc_inputs
from .code import entries, literal
from .columns import rendered
from .derivatives import say_time
from .fields import fused_place
from .pieces import piece_place, pieces
from .project import CProject
from .stumpff_slopes import slopes

FILES = ("mpc.h", "mpc.c", "qp.h", "qp.c")
"""The files that a controller adds, without the robot's name; their templates have the same names."""

SOLVER = (
    "LICENSE",
    "auxiliary.c",
    "auxiliary.h",
    "constants.h",
    "daqp.c",
    "daqp.h",
    "factorization.c",
    "factorization.h",
    "types.h",
)
"""DAQP's files, which are copied as they are."""

PLANT_STEP = 1e-3
"""s: about a step of the arm in the example."""
TIP = ("tip_position", "tip_orientation", "tip_velocity")


class Rest(NamedTuple):
    """The arm at rest at the goal."""

    q: np.ndarray
    """(nq,)"""
    tau: np.ndarray
    """(n_tau,) N·m"""
    position: np.ndarray
    """(3,) m: of the last tip."""
    rotation: np.ndarray
    """(3, 3): of the last tip."""


class Fitted:
    """A controller's numbers at a robot's sizes. Raises :class:`UsageError` with the file, key, fault and remedy."""

    rest: Rest
    scatter: np.ndarray
    """(nv + nvz,): by how much an ordinary sample may miss the model's prediction."""
    terminal: np.ndarray
    """The regulator's cost-to-go (nv + nvz, nv + nvz) behind the last state; only where the file asks for it."""

    def __init__(self, chain: Chain, wrench_names: Sequence[str], said: Mpc, file: str):
        self.chain, self.wrench_names, self.said, self.file = chain, wrench_names, said, file
        for asked, what in (
            (bool(chain.robot.rigid_loops), "loops"),
            (bool(chain.robot.couplings), "couplings"),
            (chain.floating and not chain.moving, f"a {chain.robot.base} base"),
            (any(not part.joint.in_space for part in chain.curved), "a ball joint"),
            (bool(chain.n_added), "elastic drives"),
            (bool(chain.travels), "transmissions"),
            (chain.holds_by_motion, "drives whose steps hold what their motion allows"),
            (bool(chain.n_held_states), "drives that remember what they are told"),
        ):
            if asked:
                raise UsageError(
                    f"robot '{chain.robot.name}' has {what}; predictive control in C is not made for them; "
                    "use model.acados()"
                )
        self.chosen, self.given = chain.chosen_inputs, chain.given_inputs
        if not self.chosen:
            raise UsageError(f"robot '{chain.robot.name}' has no efforts; predictive control needs torques to choose")
        self.n, self.joints, self.modes = len(self.chosen), chain.n_joints, chain.n_modes
        self.states = chain.n_changes
        if (count := self.n * len(said.horizon.lengths)) > VARIABLES:
            raise self.refuse(
                "horizon.blocks",
                f"leave {count} torques to choose; at most {VARIABLES} are solved in real time; state longer blocks",
            )
        self.gauges = gauges(chain) if said.bounds.strains else []
        self.goal = self.entries("goal.joints", said.goal.joints, self.joints)
        self.still = self._still()
        self.bounds, _ = self._bounds(), (self.wrenches, self.weights)

    def refuse(self, key: str, what: str) -> UsageError:
        return UsageError(f"{self.file}: {key}: {what}")

    def entries(self, key: str, value: Any, size: int) -> list[float]:
        """One number for each of `size` entries."""
        values = list(value) if isinstance(value, tuple) else [value] * size
        if len(values) != size:
            raise self.refuse(key, f"has length {len(values)}; it must be a number or an array of {size}")
        return values

    def _still(self) -> np.ndarray:
        """All inputs (n_tau,) at the goal as the file gives them, those that are chosen zero."""
        out, names = np.zeros(self.chain.n_tau), coordinate_names(self.chain.robot).tau
        out[self.given] = self.entries("goal.given", self.said.goal.given, len(self.given))
        for k in self.chain.given:
            if out[k]:
                at = f"goal.given[{self.given.index(k)}]"
                raise self.refuse(at, f"is {out[k]:g}, of {names[k]}; it must be 0, as what rests does not accelerate")
        return out

    def both(self, key: str, value: Any, size: int) -> tuple[list[float], list[float]]:
        if isinstance(value, Between):
            lower, upper = (self.entries(f"{key}.{k}", getattr(value, k), size) for k in ("lower", "upper"))
        else:
            upper = self.entries(key, value, size)
            lower = [-x for x in upper]
        for i, (a, b) in enumerate(zip(lower, upper, strict=True)):
            if not a < b:
                raise self.refuse(f"{key}.lower[{i}]", f"is {a:g}; it must be less than upper[{i}] = {b:g}")
        return lower, upper

    @cached_property
    def weights(self) -> dict[str, list[float]]:
        cost, sizes = self.said.cost, dict.fromkeys(("joints", "joint_rates"), self.joints)
        sizes |= dict.fromkeys(("torques", "torque_rates"), self.n)
        sizes |= {"modes": self.modes, "mode_rates": self.modes} | dict.fromkeys(TIP, 3)
        given = {name: getattr(cost, name) for name in sizes}
        out = {name: self.entries(f"cost.{name}", w, sizes[name]) for name, w in given.items() if w is not None}
        for i, (a, b) in enumerate(zip(out["torques"], out["torque_rates"], strict=True)):
            if not a + b > 0:
                what = f"joint {i}" if not self.given else coordinate_names(self.chain.robot).tau[self.chosen[i]]
                raise self.refuse("cost.torques", f"and torque_rates are 0 for {what}; one of them must be > 0")
        return out

    def _bounds(self) -> dict[str, Sequence[float]]:
        """The members of the options with the bounds that the file states."""
        bounds, n, count = self.said.bounds, self.n, len(self.gauges)
        lower, upper = self._torques()
        out: dict[str, Sequence[float]] = {"torque_lower": lower, "torque_upper": upper}
        if bounds.torque_rates is not None:
            out["torque_rate"] = self.entries("bounds.torque_rates", bounds.torque_rates, n)
        if bounds.joints is not None:
            out["joint_lower"], out["joint_upper"] = self.both("bounds.joints", bounds.joints, self.joints)
        if bounds.joint_rates is not None:
            out["joint_rate"] = self.entries("bounds.joint_rates", bounds.joint_rates, self.joints)
        if bounds.strains is not None:
            if not count:
                raise self.refuse("bounds.strains", "bounds the bending of links, and no link bends; leave it out")
            for name, values in (("strain", bounds.strains.limit), ("fibre", bounds.strains.fibre)):
                out[name] = self.entries(f"bounds.strains.{'limit' if name == 'strain' else name}", values, count)
        return out | ({"wrench": [w.limit for w in bounds.wrenches]} if bounds.wrenches else {})

    def _torques(self) -> tuple[list[float], list[float]]:
        """The bounds of the torques: those of the file, the limits of efforts where these are tighter."""
        stated, key = self.said.bounds.torques, "bounds.torques"
        most = np.append(self.chain.most("effort"), np.full(self.chain.n_tau - self.joints, inf))[self.chosen]
        if stated is None and not np.isfinite(most).all():
            free = coordinate_names(self.chain.robot).tau[self.chosen[int(np.flatnonzero(~np.isfinite(most))[0])]]
            raise self.refuse(key, f"is missing; state it, or limits of effort of all axes: {free} has none")
        lower, upper = ([-inf] * self.n, [inf] * self.n) if stated is None else self.both(key, stated, self.n)
        pulling = range(self.chain.n_tau)[self.chain.inputs.get(TENSIONS, slice(0))]
        least = np.where(np.isin(self.chosen, pulling), 0.0, -most)
        lower, upper = np.maximum(lower, least).tolist(), np.minimum(upper, most).tolist()
        for i in np.flatnonzero(~np.less(lower, upper)):
            raise self.refuse(f"{key}[{i}]", f"leaves nothing within the limit of the effort, {most[i]:g}")
        return lower, upper

    @cached_property
    def wrenches(self) -> list[dict[str, Any]]:
        """Link and component of the bounded joint wrenches."""
        out = []
        for i, wrench in enumerate(self.said.bounds.wrenches):
            if wrench.component not in self.wrench_names:
                known = ", ".join(self.wrench_names[:6])
                raise self.refuse(f"bounds.wrenches[{i}].component", f"is no joint wrench; the first are {known}")
            at = self.wrench_names.index(wrench.component)
            out.append({"link": at // 6, "component": at % 6, "name": wrench.component})
        return out


class MpcProject(CProject):
    """The files of a robot's C with a predictive controller, and with derivatives in any case."""

    def __init__(self, fitted: Fitted, version: str, *said: Any, **options: Any):
        """``said``, ``options``: as :class:`CProject` takes them."""
        super().__init__(fitted.chain, version, *said, **options)
        self.fitted, self.with_derivatives = fitted, True

    @property
    def library(self) -> dict[str, str]:
        return super().library | {f"{self.name}_{file}": file for file in FILES}

    def files(self) -> dict[str, str]:
        return super().files() | self.solver() | self.example()

    def example(self) -> dict[str, str]:
        """A program that closes the loop; no part of the library."""
        return {"mpc_main.c": rendered("mpc_main.c", **self.context)}

    def solver(self) -> dict[str, str]:
        """DAQP's sources and licence, and what makes them part of one file."""
        own = {f"daqp/{name}": (folder() / "daqp" / name).read_text() for name in SOLVER}
        return own | {"daqp/screwgen.h": rendered("daqp.h", **self.context)}

    @cached_property
    def context(self) -> dict:
        mine, chain = super().context, self.chain
        asked = content(self.fitted, bool(self.baked)) | mpc_inputs.content(chain)
        written = mine[FEATURES] + mpc_inputs.features(chain) + features(asked)
        return mine | {"n_joints": chain.n_joints, "mpc": asked, FEATURES: written}


def features(asked: Mapping[str, Any]) -> tuple[str, ...]:
    """What the terms and bounds of the file write, as :class:`..template_places.TemplatePlaces` finds it."""
    return (
        *("planned_wrenches",) * bool(asked["wrenches"]),
        *("planned_tip",) * bool(asked["terms"]),
        *("soft_bounds",) * bool(asked["soft"]),
        *("bounded_states",) * bool(asked["plain"] or asked["gauges"]),
        *("bounded_strains",) * bool(asked["gauges"]),
        *("terminal_cost",) * asked["terminal"],
    )


def content(fitted: Fitted, baked: bool) -> dict[str, Any]:
    """The templates' context."""
    said, n, chain = fitted.said, fitted.n, fitted.chain
    horizon, bounds = said.horizon, said.bounds
    lengths, first = horizon.lengths, chain.base_v
    found = fitted.gauges
    bounded = {name: getattr(bounds, name) is not None for name in ("joints", "joint_rates", "strains", "torque_rates")}
    plain = [
        *(range(first, first + chain.n_joints) if bounded["joints"] else ()),
        *(range(chain.nv + first, chain.nv + first + chain.n_joints) if bounded["joint_rates"] else ()),
        *range(2 * chain.nv, 2 * chain.nv + chain.z_offset[-1]),
    ]
    nz, stages = n * len(lengths), len(plain) + len(found)
    soft = (stages + len(fitted.wrenches)) * horizon.intervals
    rows = soft + nz * bounded["torque_rates"]
    return {
        "intervals": horizon.intervals,
        "step": repr(horizon.step),
        "step_literal": literal(horizon.step),
        "substeps": horizon.substeps,
        "method": horizon.method,
        "blocks": len(lengths),
        "block": [b for b, length in enumerate(lengths) for _ in range(length)],
        "length": lengths,
        "nz": nz,
        "rows": rows,
        "soft": stages + len(fitted.wrenches),
        "active": nz + soft + 2,
        "plain": plain,
        "bounded": bounded,
        "rate_rows": bounded["torque_rates"],
        "gauges": [{"first": g.first, "count": len(g.curvatures)} for g in found],
        "curvatures": [literal(x) for x in _curvatures(chain, found)],
        "wrenches": fitted.wrenches,
        "terminal": said.cost.terminal.riccati,
        "terminal_factor": literal(said.cost.terminal.factor),
        "penalty": literal(bounds.penalty),
        "iterations": said.solver.iterations,
        "delay": said.solver.delay,
        "margin": literal(said.solver.margin),
        "patience": said.solver.patience,
        "plant_steps": max(horizon.substeps, round(horizon.step / PLANT_STEP)),
        "check_duration": repr(max(1.0, 2 * horizon.intervals * horizon.step)),
        **_tip(fitted, baked),
        **_tables(fitted),
    }


def _tip(fitted: Fitted, baked: bool) -> dict[str, Any]:
    """The terms of the tip that the file weighs, and the program of its pose and velocity."""
    chain, weighed = fitted.chain, [name for name in TIP if name in fitted.weights]
    at = {name: 3 * i for i, name in enumerate(weighed)}
    out: dict[str, Any] = {
        "terms": 3 * len(weighed),
        "weights": [f"o->{name}" for name in weighed],
        "placed": "tip_position" in at,
        "turning": "tip_orientation" in at,
        "moving": "tip_velocity" in at,
        "turning_at": at.get("tip_orientation"),
        "moving_at": at.get("tip_velocity"),
    }
    if not weighed:
        return out | {"tip": {"pieces": [], "kept": 1}, "slopes_of_stumpff": []}
    program = tip_terms(chain, out["turning"], out["moving"], "baked" if baked else "constants")
    say_time(chain, "terms of the tip", program.operation_count)
    own = {
        "r": entries("m->r"),
        "r_q": entries("m->r_q", 3),
        "R": entries("m->R_tip"),
        "R_q": entries("m->R_q", 9),
        "u": entries("m->u"),
        "u_q": entries("m->u_q", 3),
    }
    written = pieces(program, piece_place(chain, "m->kept", own, fused_place), ("c", "state", "m"))
    return out | {"tip": written, "slopes_of_stumpff": slopes([program])}


def _curvatures(chain: Chain, found: Sequence[Gauge]) -> list[float]:
    """Those of the file's lengths; at least one, as C has no array of none."""
    return np.array(curvatures(chain, chain.parameters.vector().tolist(), found) or [0.0], float).tolist()


def _tables(fitted: Fitted) -> dict[str, Any]:
    """The numbers of the file: constant arrays, and the members that start with them."""
    q, tau, r, R = fitted.rest
    tables: dict[str, Numbers] = {"GOAL_Q": q, "GOAL_TAU": tau, "GOAL_PLACE": r, "GOAL_ROTATION": R.ravel()}
    members: dict[str, Numbers] = {f"o->{name}": w for name, w in (fitted.weights | fitted.bounds).items() if len(w)}
    members["o->scatter"] = fitted.scatter
    if fitted.said.cost.terminal.riccati:
        members["&o->terminal[0][0]"] = fitted.terminal.ravel()
    defaults = []
    for member, values in members.items():
        name = "DEFAULT_" + member.split(">")[1].partition("[")[0].upper()
        tables[name] = values
        defaults.append((member, name, len(values)))
    return {"tables": [(k, [literal(float(x)) for x in v]) for k, v in tables.items()], "defaults": defaults}
