"""Derivatives of the joint form: the mass matrix and the partial derivatives of the inverse dynamics.

``d vdot / d x = -M^-1 d f / d x`` with ``f`` the inverse dynamics at held ``vdot``, and ``d vdot / d tau`` the
first columns of ``M^-1``.  The phases (:mod:`.sensitivity`) give the derivatives of a link with its own coordinates.
The blocks of two different links need two quantities at the nodes between them: outward the acceleration of a node
per unit of ``vdot`` (columns), and inward the derivatives with a node's motion (rows).
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import replace

import numpy as np

from ..elements import FRICTION
from ..ir.program import Array, Value
from ..spec.link_class import LinkClass
from ..topology.chain import Chain
from ..topology.tree import BASE, TIP
from . import matrices as mx
from . import rows as rw
from .axis_laws import of_robot
from .elastic_travels import GEAR_SLOPES, slope_names
from .force_functions import acting_tips
from .functions import Functions
from .inverse_slopes import Slopes as Slopes
from .loop_slopes import MOTION, RowChange, TipChange, loop_changes, tips
from .schedule import COLUMNS
from .scope import OF_TIP
from .signals import STORE
from .station_names import at_station, edge_name, plain
from .travels import INERTIA

PAIRS = (
    "F_q F_qdot f_q f_qdot u_q u_qdot rows_q axes F_eta F_etadot f_eta f_etadot tip_eta tip_etadot rows_eta M_eta_eta "
    "E R_T R_rel r_T udot_T omega_s omega_i omega_J r_B r_J v_J"
).split()
"""The signals of a link's store that the blocks of two links need."""

OF_MOTION = ("R_T", "r_T", "udot_T", "omega_s")
"""Those that a section's motion in the link consists of."""

LinkSection = Callable[[int], AbstractContextManager]


def slopes(
    f: Functions, q: Sequence, v: Sequence, vdot: Sequence, w_ext: Sequence, tau: Sequence, own: bool = True
) -> Slopes:
    """Over any algebra: ``M``, ``df/dq`` and ``df/dv`` of ``f(q, v, vdot) = M vdot + h`` at held ``vdot``.

    Where drives have transmissions ``f`` is less their torques, those of the efforts in ``tau``.  Only the lower
    triangle of ``M`` counts.  Without ``own`` the given inertia, the springs, dampers, friction and stops of single
    coordinates are left out: a step takes them elsewhere.
    """
    f, at = f.under_inputs(tau), list(dict.fromkeys(acting_tips(f.chain)))
    found, moved = moving_slopes(f, (q, v, vdot, f.with_forces(q, v, w_ext), tau), at, own)
    _take_forces(f, q, v, w_ext, found, moved)
    return found


def closed_slopes(
    f: Functions, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence, own: bool = True
) -> tuple[list, Slopes, RowChange]:
    """Of a robot with loops: ``vdot``, the same of ``f - J^T lambda`` at held forces lambda, and the loops' rows."""
    chain, f = f.chain, f.under_inputs(tau)
    vdot, loads, shut, forces, accelerating = f.closed_motion(q, v, tau, w_ext)
    acting = list(dict.fromkeys((*tips(chain), *acting_tips(chain))))
    found, at = moving_slopes(f, (q, v, vdot, loads.w_ext, tau), acting, own)
    _take_forces(f, q, v, w_ext, found, at)
    with f.section("loops: their rows, and what their wrenches do as the tips move"):
        rows, bend = loop_changes(chain, shut, accelerating(), forces, at, f.apply)
        found.f_q = found.f_q - bend
    return vdot, found, rows


def _take_forces(
    f: Functions, q: Sequence, v: Sequence, w_ext: Sequence, out: Slopes, at: Mapping[int, TipChange]
) -> None:
    """Take what acts on tips, as far as it changes in their frames, from the slopes."""
    if f.acts:
        with f.section("forces: what their wrenches do as the tips move"):
            by_q, by_v = f.force_slopes(q, v, w_ext, at)
            out.f_q, out.f_v = out.f_q - by_q, out.f_v - by_v
            columns = np.arange(f.chain.n_internal)[f.chain.force_states.start - f.chain.nv :]
            for states, loads in f.wrenches_by_states(q, v):
                own = columns[states]
                for i, by_state in loads.items():
                    out.f_z[:, own] = out.f_z[:, own] - mx.multiply(at[i].J.T, by_state)


def moving_slopes(
    f: Functions, state: Sequence[Sequence], at: Sequence[int], own: bool
) -> tuple[Slopes, dict[int, TipChange]]:
    """The slopes, and how the tips of some links move; their motions stand below the rows of f."""
    (q, v, vdot, w_ext, tau), section = state, f.section
    stores = f.sensitivities(q, v, vdot, w_ext, tau)
    links = [arrays(f.chain, i, store) for i, store in enumerate(stores)]
    nv = f.chain.nv
    out = Slopes.zero(f.chain, MOTION * len(at))
    name = lambda i: f.chain.names[i]  # noqa: E731
    for i, link in enumerate(links):
        with section(f"{name(i)}, rows: what its own coordinates change" + ", joint stiffness and damping added" * own):
            _own(f, i, link, out, own)
    if f.chain.elastic_travels:
        _travels(f.chain, links, out)
    if own and (f.chain.n_added or of_robot(f.chain)):
        with section("drives: rotors, gears and dry friction" + _more(f.chain)):
            _axes(f, q, v, out)
    J = _outward(f.chain, links, out, lambda i: section(f"{name(i)}, pairs: the rows of the links that carry it"), at)
    moved, places_of = {}, list(zip(at, range(nv, len(out.f_q), MOTION), strict=True))
    inward(
        f.chain,
        links,
        lambda i: (np.vstack([links[i]["rows_q"], links[i]["rows_eta"]]), _coordinates(f.chain, i)),
        (out.f_q, out.f_v),
        lambda i: section(f"{name(i)}, pairs: the rows of the links that it carries"),
        {i: list(range(first, first + MOTION)) for i, first in places_of},
    )
    for i, first in places_of:
        columns, owners = J[f.chain.tree.tip(i)]
        moved[i] = TipChange(mx.zeros(6, nv), *(x[first : first + MOTION] for x in (out.f_q, out.f_v)))
        moved[i].J[:, owners] = columns
    return replace(out, f_q=out.f_q[:nv], f_v=out.f_v[:nv]), moved


def arrays(chain: Chain, i: int, store: Mapping[str, list], more: Sequence[str] = ()) -> dict[str, Array]:
    """What the blocks of two links need of a link's store, and ``more``."""
    key = chain.keys[i]
    names = [
        *PAIRS,
        *more,
        *(at_station(name, k) for name in PAIRS if name in OF_TIP for k in range(len(key.stations_at))),
    ]
    names += slope_names(key)
    shapes = {name: STORE[plain(name)].size_of(key) for name in names}
    return {name: np.fromiter(store[f"w.{name}"], object).reshape(shape) for name, shape in shapes.items()}


def places(chain: Chain, i: int) -> tuple[slice, slice]:
    """The slices of v with the joint and the modal rates of a link."""
    return slice(*chain.v_offset[i : i + 2]), slice(*(chain.eta_v + e for e in chain.eta_offset[i : i + 2]))


def _coordinates(chain: Chain, i: int) -> list[int]:
    return np.r_[places(chain, i)].tolist()


def _own(f: Functions, i: int, link: Mapping[str, Array], out: Slopes, own: bool) -> None:
    """The block of one link."""
    q, eta = places(f.chain, i)
    constants, key = f.constants[i], f.chain.keys[i]
    M_q, K_q, D_q = _joint_columns(key, constants, own)
    out.M[q, q] = mx.multiply(link["rows_q"][:, 3:], link["axes"]) + mx.diagonal(M_q)
    if key.has_travelling_inertia:
        out.M[q, q] = out.M[q, q] + mx.diagonal(link[INERTIA])
    out.M[eta, q] = mx.multiply(link["rows_eta"][:, 3:], link["axes"])
    empty = mx.zeros(key.modes, key.modes)
    of_modes = lambda A, below: mx.coupled(constants[A], key.coupled, constants.get(below, ()))  # noqa: E731
    modal_matrix = of_modes if own else lambda *_: empty
    out.M[eta, eta] = link["M_eta_eta"] + modal_matrix("M_eta", "M_below")
    for J, joint, modal, passive, stress in (
        (out.f_q, "q", "eta", K_q, modal_matrix("K", "K_below")),
        (out.f_v, "qdot", "etadot", D_q, modal_matrix("D", "D_below")),
    ):
        J[q, q] = link[f"f_{joint}"] + mx.diagonal(passive)
        J[q, eta] = mx.multiply(link["axes"].T, link[f"F_{modal}"])
        J[eta, q] = mx.multiply(link["rows_eta"], link[f"u_{joint}"])
        J[eta, eta] = link[f"f_{modal}"] + stress


def _travels(chain: Chain, links: Sequence[Mapping[str, Array]], out: Slopes) -> None:
    """The rows and columns of the elastic gears of transmissions, but for their springs and dampers."""
    state = [(i, k) for i, key in enumerate(chain.keys) for k in range(len(key.added_axes))]
    for (i, k), joint in zip(state, chain.added_joints, strict=True):
        if joint not in chain.elastic_travels:
            continue
        place = chain.elastic_travels[joint]
        M, by_q, by_qdot, back, own = (links[i][name][k] for name in GEAR_SLOPES)
        axis = chain.base_v + joint
        out.M[place, axis] = out.M[axis, place] = M
        out.f_q[place, axis], out.f_v[place, axis], out.f_v[axis, place] = by_q, by_qdot, back
        out.f_v[place, place] = own


def _more(chain: Chain) -> str:
    words = [law.words for law in chain.laws if law != FRICTION]
    return "".join(f"; {word}" for word in words)


def _axes(f: Functions, q: Sequence, v: Sequence, out: Slopes) -> None:
    """The rows and columns of added coordinates, and the slopes of laws."""
    chain, first = f.chain, f.chain.eta_v - f.chain.n_added
    added, state = enumerate(chain.added_joints, first), f.motion(q, v)
    coordinates = {one.law: iter(one.coordinates) for one in of_robot(chain)}
    axes = {one.law: iter(one.axes) for one in of_robot(chain)}
    internal = {law: iter(own) for law, own in chain.internal.items()}
    for i, key in enumerate(chain.keys):
        own = f.constants[i]
        for k in range(len(key.added_axes)):
            place, joint = next(added)
            joint += chain.base_v
            for J, name in ((out.M, "M"), (out.f_q, "K"), (out.f_v, "D")):
                J[place, place] = J[place, place] + own[f"{name}_theta"][k]
                if key.added_axes[k] not in key.elastic_travels:
                    J[place, joint] = J[joint, place] = own[f"{name}_gear"][k]
        for acting in f.laws(i, state[i]):
            place, found = next(coordinates[acting.law]) + chain.base_v, acting.values
            out.f_q[place, place] = out.f_q[place, place] + found["by_x"]
            out.f_v[place, place] = out.f_v[place, place] + found["by_w"]
            if acting.law in chain.internal:
                z = next(internal[acting.law])
                row = z - chain.nv
                out.f_z[place, row], out.z_q[row, place] = found["by_z"], found["rate_x"]
                out.z_v[row, place], out.z_v[row, z] = found["rate_w"], found["rate_z"]
            if acting.law.beside:
                axis = next(axes[acting.law]) + chain.base_v
                out.f_q[place, axis] = out.f_q[place, axis] + found["by_axis"]
                if acting.law in chain.internal:
                    out.z_q[row, axis] = found["rate_axis"]


def _joint_columns(key: LinkClass, constants: Mapping[str, Sequence[Value]], own: bool) -> list[Sequence[Value]]:
    """Inertia, stiffness and damping of the joint's own coordinates; without ``own`` those that are not given."""
    none = [0.0] * key.joints
    if key.has_axis_forces:
        return [constants[name] for name in COLUMNS["q"]] if own else [none] * 3
    inertia = [constants[f"c.armature_{k + 1}"][0] for k in range(key.joints)] if key.has_constant_inertia else none
    return [inertia, none, none]


Columns = list[tuple[Array, list[int]]]
"""At every node: a matrix, and the numbers of its columns among the coordinates or of its rows among those of ``f``."""


def _outward(
    chain: Chain, links: Sequence[Mapping[str, Array]], out: Slopes, section: LinkSection, tips: Sequence[int]
) -> Columns:
    """The rows of a link's ancestors: the link's wrench, projected on their virtual accelerations.

    Returns these accelerations, of nodes that carry links and of the given tips.
    """
    at_nodes: Columns = [(mx.zeros(6, 0), [])] * chain.tree.size
    for i, owners, here in accelerations(chain, links, section, at_nodes, tips):
        link, (q, eta) = links[i], places(chain, i)
        for s, rows in ((q, "rows_q"), (eta, "rows_eta")):
            out.M[s, owners] = mx.multiply(link[rows][:, 3:], here)
            out.M[owners, s] = out.M[s, owners].T
        for J, joint, modal in ((out.f_q, "q", "eta"), (out.f_v, "qdot", "etadot")):
            J[owners, q] = mx.multiply(here.T, link[f"F_{joint}"])
            J[owners, eta] = mx.multiply(here.T, link[f"F_{modal}"])
    return at_nodes


def accelerations(
    chain: Chain,
    links: Sequence[Mapping[str, Array]],
    section: LinkSection,
    at_nodes: Columns,
    tips: Container[int] = (),
) -> Iterator[tuple[int, list, Array]]:
    """Every link that another carries, the coordinates of those that do, and its acceleration per unit of theirs.

    The columns (6, k) are those of F_i at its origin; what is done with them stands in the section of the link.
    ``at_nodes``, empty columns for every node, receives those of the nodes that carry links and of the given tips.
    """
    for i, link in enumerate(links):
        given, owners = at_nodes[chain.tree.base(i)]
        with section(i):
            R = link["R_rel"]
            at_joint = rw.rotated_columns(R.T, _moved(link["r_J"], given))
            here = _moved(-link["r_B"], at_joint)
            if owners:
                yield i, owners, here
            for node, own in carrying(chain, i, link, tips):
                at_tip = np.hstack([_moved(own["r_T"], np.hstack([here, link["axes"]])), own["E"]])
                at_nodes[node] = rw.rotated_columns(own["R_T"].T, at_tip), owners + _coordinates(chain, i)


def carrying(
    chain: Chain, i: int, link: Mapping[str, Array], tips: Container[int] = ()
) -> Iterator[tuple[int, dict[str, Array]]]:
    """The nodes at which a link carries others, each with what the link stores of it, by the names of the tip's.

    Of the links ``tips`` their tips are among them.
    """
    for where, node in chain.tree.places(i).items():
        if where != "base" and (chain.tree.children[node] or (where == "tip" and i in tips)):
            number = TIP if where == "tip" else int(where[2:])
            yield node, {name: link[edge_name(name, number)] for name in PAIRS if name in OF_TIP}


def _moved(r: Array, accelerations: Array) -> Array:
    """Accelerations (6, k) of the origin, converted to the point ``r``."""
    arm = mx.multiply(mx.hat(r), accelerations[:3])
    return np.vstack([accelerations[:3], accelerations[3:] - arm])


def inward(
    chain: Chain,
    links: Sequence[Mapping[str, Array]],
    own_rows: Callable[[int], tuple[Array, Sequence[int]]],
    out: tuple[Array, Array],
    section: LinkSection,
    tips: Mapping[int, list[int]] | None = None,
) -> None:
    """The rows of a link's descendants, applied to the motion of its tip per unit of its coordinates.

    ``own_rows(i)``: the rows (k, 9) of a link on the motion of F_i, and their places in the matrices ``out``, whose
    columns are coordinates and rates.  The motions of the given ``tips`` are further rows, at the places stated.
    """
    at_nodes: Columns = [(mx.zeros(0, MOTION), [])] * chain.tree.size
    tips = tips or {}
    for i, those in tips.items():
        at_nodes[chain.tree.tip(i)] = mx.identity(MOTION), those
    for i in reversed(range(chain.n)):
        link, (q, eta) = links[i], places(chain, i)
        with section(i):
            owners: list[int] = []
            rows = mx.zeros(0, 9)
            for node, own in carrying(chain, i, link, tips):
                carried, those = at_nodes[node]
                R_T, r_T, udot, omega_s = (own[x] for x in OF_MOTION)
                at_tip, here = rw.to_link(carried, R_T, r_T, udot, omega_s, link["omega_i"])
                for J, joint, modal in zip(out, ("q", "qdot"), ("eta", "etadot"), strict=True):
                    J[those, q] = mx.multiply(here, link[f"u_{joint}"])
                    J[those, eta] = mx.multiply(at_tip, own[f"tip_{modal}"])
                rows, owners = np.vstack([rows, here]), [*owners, *those]
            if (parent := chain.tree.parents[i]) != BASE:
                added, at_rows = own_rows(i)
                handed = np.vstack([rows, added])
                R_rel, omega, omega_J = (link[x] for x in ("R_rel", "omega_i", "omega_J"))
                carrier, at, node = links[parent], chain.tree.at(i), chain.tree.base(i)
                omega_s, R_T = (carrier[edge_name(name, at)] for name in ("omega_s", "R_T"))
                omega_P = mx.multiply(R_T.T, carrier["omega_i"] + omega_s)
                handed = rw.to_parent(handed, R_rel, omega, omega_J, omega_P, link["r_B"], link["r_J"], link["v_J"])
                others, known = at_nodes[node]
                at_nodes[node] = np.vstack([others, handed]), [*known, *owners, *at_rows]
