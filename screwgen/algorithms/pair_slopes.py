"""The slopes of the inverse dynamics by recursion: what a link says once, and what a pair of coordinates then costs.

Everything behind a coordinate moves with it as one body. A small turn ``sigma`` of that body and a shift change the
motion ``[omega; omegadot; a]`` of a link behind it, in axes that turn with the link, by

    omega: sigma',    omegadot: sigma'' - omega x sigma',    a: c + sigma'' x (r - r_c) + 2 sigma' x (v - v_c)

with r and v of the link's origin, in inertial axes. So the *change* ``[sigma'; sigma''; c]`` of a coordinate, with its
point ``r_c`` and that point's velocity ``v_c``, says what it does to every link behind it. It is computed once, as are
the rows of a link in inertial axes that answer to it. A pair of coordinates then costs a few inner products, whatever
lies between their links, and nothing is handed from link to link.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np

from ..ir.program import Array, Program, Tracer, Vector
from ..topology.tree import TIP
from . import matrices as mx
from . import rows as rw
from .elastic_travels import GEAR_SLOPES
from .functions import SENSITIVITY
from .loop_slopes import MOTION
from .schedule import OUTWARD, Algorithm, Phase
from .scope import Scope
from .station_names import edge_name
from .travels import INERTIA

PARTS = {"q": ("q", "qdot"), "eta": ("eta", "etadot")}
"""The coordinates of a link: of its joint, and of its modes; each with the name of its rates."""


# -------------------------------------------------------------------------------------- what a link says


def spread(s: Scope) -> None:
    """Base to tip: the place of a link; the changes of its coordinates and its rows, in inertial axes."""
    R, r, v = _placed(s)
    s.write("change.origin", r)
    s.write("change.velocity", v)
    _write_point(s, "q", r, v)
    omega, turned = s.read("w.omega_i"), lambda x: rotated(R, x)
    with s.step("changes of the motion behind the joint with its coordinates and rates, in inertial axes"):
        s.write("change.U_q", turned(s.read("w.axes")))
        for name in PARTS["q"]:
            s.write(f"change.by_{name}", turned(_change(omega, s.read(f"w.u_{name}"))))
    with s.step("rows of the link's coordinates on its motion, and wrenches by them, in inertial axes"):
        for part, names in PARTS.items():
            s.write(f"change.rows_{part}", turned(_rows(omega, s.read(f"w.rows_{part}"))))
            for name in names:
                s.write(f"change.F_{name}", turned(s.read(f"w.F_{name}")))
    _write_blocks(s)
    _write_wrenches(s, R, r)
    for section in s.sections:
        _write_carried(s, section, R, r, v)


def _write_carried(s: Scope, section: Scope, R: Array, r: Vector, v: Vector) -> None:
    """The changes of what the tip carries, or a station, with the modes; its place and velocity."""
    omega, turned, number = s.read("w.omega_i"), lambda x: rotated(R, x), getattr(section, "number", TIP)
    with s.step("changes of the motion of what the tip carries with the modes and their rates, in inertial axes"):
        R_T, r_T, udot = (section.read(f"w.{name}") for name in ("R_T", "r_T", "udot_T"))
        omega_T = omega + section.read("w.omega_s")
        r, v = r + mx.multiply(R, r_T), v + mx.multiply(R, mx.cross(omega, r_T) + udot)
        s.write(edge_name("change.U_eta", number), turned(section.read("w.E")))
        for name in PARTS["eta"]:
            s.write(edge_name(f"change.by_{name}", number), turned(_change(omega_T, section.read(f"w.tip_{name}"))))
    _write_point(s, "eta", r, v, number)
    section.write("tip.R", mx.multiply(R, R_T))
    section.write("tip.r", r)
    section.write("tip.rdot", v)


def _placed(s: Scope) -> tuple[Array, Array, Array]:
    """Rotation, position and velocity of F_i, the latter two less those of a floating base; inertial axes."""
    if s.key.floats:
        return s.read("w.R_rel"), mx.zeros(3), mx.zeros(3)
    with s.step("place and velocity of F_i, in inertial axes"):
        R_P, r_J, r_B = s.read("base.R"), s.read("w.r_J"), s.read("w.r_B")
        R = s.name("R", mx.multiply(R_P, s.read("w.R_rel")))
        slip = mx.cross(s.read("base.omega_T"), r_J) + s.read("w.v_J")
        swing = mx.cross(s.read("w.omega_i"), r_B)
        r = s.read("base.r") + mx.multiply(R_P, r_J) - mx.multiply(R, r_B)
        return R, s.name("r", r), s.read("base.rdot") + mx.multiply(R_P, slip) - mx.multiply(R, swing)


def _write_point(s: Scope, part: str, r: Vector, v: Vector, number: int = TIP) -> None:
    """The point at which the changes of a part of the coordinates are taken, for each of them, and its velocity."""
    count = s.key.joints if part == "q" else s.key.modes
    for name, x in (("r", r), ("v", v)):
        s.write(edge_name(f"change.{name}_{part}", number), np.tile(mx.array(list(x), (3, 1)), (1, count)))


def rotated(R: Array, x: Array) -> Array:
    """Columns of vectors, three entries each, in other axes."""
    return np.vstack([mx.multiply(R, x[k : k + 3]) for k in range(0, len(x), 3)])


def _change(omega: Array, u: Array) -> Array:
    """``[sigma'; sigma''; c]`` from the changes (9, k) of a motion with the angular velocity ``omega``."""
    return np.vstack([u[:3], u[3:6] + rw.cross_columns(omega, u[:3]), u[6:]])


def _rows(omega: Array, rows: Array) -> Array:
    """The columns (9, k) on ``[sigma'; sigma''; c]`` of rows (k, 9) on a motion with the angular velocity ``omega``."""
    return np.hstack([rows[:, :3] + rw.cross_rows(omega, rows[:, 3:6]), rows[:, 3:]]).T


def own_blocks(link: Mapping[str, Array]) -> dict[str, Array]:
    """The block of one link in ``M``, ``df/dq`` and ``df/dv``, by parts; without its own inertia and stress."""
    rows_q, rows_eta, axes = link["rows_q"], link["rows_eta"], link["axes"]
    out = {"M_q_q": mx.multiply(rows_q[:, 3:], axes), "M_eta_q": mx.multiply(rows_eta[:, 3:], axes)}
    out |= {"M_eta_eta": link["M_eta_eta"]}
    for matrix, joint, modal in (("f_q", "q", "eta"), ("f_v", "qdot", "etadot")):
        out |= {f"{matrix}_q_q": link[f"f_{joint}"], f"{matrix}_eta_eta": link[f"f_{modal}"]}
        out[f"{matrix}_q_eta"] = mx.multiply(axes.T, link[f"F_{modal}"])
        out[f"{matrix}_eta_q"] = mx.multiply(rows_eta, link[f"u_{joint}"])
    return out


OF_BLOCKS = "rows_q rows_eta axes M_eta_eta f_q f_qdot f_eta f_etadot F_eta F_etadot u_q u_qdot".split()


def _write_blocks(s: Scope) -> None:
    """The block of the link."""
    with s.step("the link's own block"):
        found = own_blocks({name: s.read(f"w.{name}") for name in OF_BLOCKS})
        if s.key.has_constant_inertia and not s.key.has_axis_forces:
            own = [s.constant(f"armature_{k + 1}") for k in range(s.key.joints)]
            found["M_q_q"] = found["M_q_q"] + mx.diagonal(own)
        if s.key.has_travelling_inertia:
            found["M_q_q"] = found["M_q_q"] + mx.diagonal(s.read(f"w.{INERTIA}"))
        for name, values in found.items():
            s.write(f"block.{name}", values)
        for name in GEAR_SLOPES if s.key.elastic_travels else ():
            s.write(f"block.{name}", s.read(f"w.{name}"))


def _write_wrenches(s: Scope, R: Array, r: Array) -> None:
    """The joint's wrench, at the joint point in F_i axes, and what changes it; none of a floating base."""
    answer, r_B, turned = s.read("w.answer"), s.read("w.r_B"), lambda x: rotated(R, x)
    with s.step("wrench of the joint: what coordinates before and behind the link, and its own, change in it"):
        by_vdot = {"q": mx.multiply(answer[:, 3:], s.read("w.axes")), "eta": s.read("w.rows_eta")[:, 3:].T}
        for part, values in by_vdot.items():
            s.write(f"change.F_a_{part}", turned(values))
        rows = rw.shifted(-r_B, answer)
        of_joint, of_modes = (dict(zip("qv", PARTS[part], strict=True)) for part in PARTS)
        own = {f"q_{part}": mx.multiply(rows, s.read(f"w.u_{name}")) for part, name in of_joint.items()}
        own |= {f"eta_{part}": rw.shifted(-r_B, s.read(f"w.F_{name}")) for part, name in of_modes.items()}
        own |= {f"{part}_vdot": rw.shifted(-r_B, values) for part, values in by_vdot.items()}
        own |= {"rows": turned(_rows(s.read("w.omega_i"), rows)).T}
        if s.key.floats and not s.key.joint.given:
            own = {name: mx.zeros(*values.shape) for name, values in own.items()}
        own |= {"R": R, "point": r + mx.multiply(R, r_B), "wrench": s.read("w.w_J")}
        for name, values in own.items():
            s.write(f"of_joint.{name}", values)


SLOPES: Algorithm = (*SENSITIVITY, Phase(spread, OUTWARD))


# --------------------------------------------------------------------------------- what a pair costs


@cache
def moved() -> Program:
    """A coordinate's changes, taken at its point, at the origin of a link behind it: what differs there."""
    tracer = Tracer()
    read = lambda name, n: mx.array(list(tracer.input(name, n)), (n, 1))  # noqa: E731
    U, by_q, by_v = read("U", 6), read("by_q", MOTION), read("by_v", MOTION)
    apart, drift = (read(here, 3)[:, 0] - read(there, 3)[:, 0] for here, there in (("r", "r_c"), ("v", "v_c")))
    drift = 2.0 * drift
    carried = lambda c, sigma2, sigma1: c + rw.columns_cross(sigma2, apart) + rw.columns_cross(sigma1, drift)  # noqa: E731
    out = {
        "a": U[3:] + rw.columns_cross(U[:3], apart),
        "c_q": carried(by_q[6:], by_q[3:6], by_q[:3]),
        "c_v": carried(by_v[6:], by_v[3:6], by_v[:3]),
    }
    sizes = {"U": 6, "by_q": MOTION, "by_v": MOTION, "r": 3, "r_c": 3, "v": 3, "v_c": 3}
    return tracer.program("moved", sizes, {name: list(x.flat) for name, x in out.items()})


@cache
def entries(inertia: bool = True) -> Program:
    """The entries of a coordinate and of one that carries its link: of M, unless it has no ``inertia``, and of the
    slopes f_q and f_v.

    ``rows`` (9), ``F_q``, ``F_v`` (6): of the former; the latter's changes at the former's link: ``U`` (6), ``by_q``,
    ``by_v`` (9).
    """
    tracer = Tracer()
    sizes = {"rows": MOTION, "F_q": 6, "F_v": 6, "U": 6, "by_q": MOTION, "by_v": MOTION}
    x = {name: tracer.input(name, n) for name, n in sizes.items()}
    out = {"M": mx.dot(x["rows"][3:], x["U"])} if inertia else {}
    out |= {
        "q_row": mx.dot(x["rows"], x["by_q"]),
        "v_row": mx.dot(x["rows"], x["by_v"]),
        "q_column": mx.dot(x["F_q"], x["U"]),
        "v_column": mx.dot(x["F_v"], x["U"]),
    }
    return tracer.program("entries", sizes, {name: [value] for name, value in out.items()})


@cache
def tip_column(accelerating: bool) -> Program:
    """A coordinate's changes at a tip that it carries, in the tip's axes R: ``J``, ``V_q`` as of :class:`.TipChange`.

    ``twist``: that of the tip in its own axes; ``a``, ``c_q`` and ``c_v`` are taken at its point. Where it is asked for
    ``acc_q``, ``acc_v`` (6): those of its acceleration.
    """
    tracer = Tracer()
    sizes = {"U": 3, "a": 3, "by_q": 6, "by_v": 6, "c_q": 3, "c_v": 3, "R": 9, "twist": 6}
    sizes = sizes if accelerating else {**{k: n for k, n in sizes.items() if k not in ("by_v", "c_q")}, "by_q": 3}
    x = {name: mx.array(list(tracer.input(name, n))) for name, n in sizes.items()}
    inward = lambda values: mx.multiply(x["R"].reshape(3, 3).T, values)  # noqa: E731
    turn, omega, v = inward(x["U"]), x["twist"][:3], x["twist"][3:]
    out = {"J": [*turn, *inward(x["a"])]}
    out["V_q"] = [*inward(x["by_q"][:3]), *(0.5 * inward(x["c_v"]) + mx.cross(v, turn))]
    for k in "qv" if accelerating else "":
        rate, change = inward(x[f"by_{k}"][:3]), inward(x[f"by_{k}"][3:])
        out[f"acc_{k}"] = [*(change - mx.cross(omega, rate)), *inward(x[f"c_{k}"])]
    return tracer.program("tip_column", sizes, out)


@cache
def ball_row() -> Program:
    """What a row of ``V_q`` has besides in the columns of a ball joint with the rates ``w``, of its row of ``J``: see
    :meth:`.TipChange.twist_by_q`."""
    tracer = Tracer()
    J, w = (mx.array(list(tracer.input(name, 3))) for name in ("J", "w"))
    return tracer.program("ball_row", {"J": 3, "w": 3}, {"V_q": list(-0.5 * mx.multiply(mx.hat(w).T, J))})


@cache
def wrench_change() -> Program:
    """Less the change of a wrench on a tip, in the tip's axes ``R_T`` at ``r_T``: at p in the axes R of a joint."""
    tracer = Tracer()
    sizes = {"R": 9, "p": 3, "R_T": 9, "r_T": 3, "D_q": 6, "D_v": 6}
    x = {name: mx.array(list(tracer.input(name, n))) for name, n in sizes.items()}
    R, R_T, arm = x["R"].reshape(3, 3), x["R_T"].reshape(3, 3), x["r_T"] - x["p"]
    felt = lambda w: -mx.rotate_wrench(R.T, mx.shift_wrench(arm, mx.rotate_wrench(R_T, w)))  # noqa: E731
    return tracer.program("wrench_change", sizes, {f"with_{k}": list(felt(x[f"D_{k}"])) for k in "qv"})


@cache
def wrench_rows() -> Program:
    """A component of a joint's wrench, with the row (9) on its link's motion, by a coordinate that carries the link."""
    tracer = Tracer()
    sizes = {"rows": MOTION, "U": 6, "by_q": MOTION, "by_v": MOTION}
    x = {name: tracer.input(name, n) for name, n in sizes.items()}
    out = {
        "by_vdot": mx.dot(x["rows"][3:], x["U"]),
        "with_q": mx.dot(x["rows"], x["by_q"]),
        "with_v": mx.dot(x["rows"], x["by_v"]),
    }
    return tracer.program("wrench_rows", sizes, {name: [value] for name, value in out.items()})


@cache
def wrench_columns() -> Program:
    """A joint's wrench by a coordinate behind its link: the changes of a wrench at r, at the joint in axes R."""
    tracer = Tracer()
    sizes = {"R": 9, "p": 3, "r_F": 3, "F_a": 6, "F_q": 6, "F_v": 6}
    x = {name: mx.array(list(tracer.input(name, n))) for name, n in sizes.items()}
    R, arm = x["R"].reshape(3, 3), x["r_F"] - x["p"]
    moved = lambda F: mx.rotate_wrench(R.T, mx.shift_wrench(arm, F))  # noqa: E731
    out = {"by_vdot": moved(x["F_a"]), "with_q": moved(x["F_q"]), "with_v": moved(x["F_v"])}
    return tracer.program("wrench_columns", sizes, {name: list(values) for name, values in out.items()})
