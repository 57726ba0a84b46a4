"""Derivatives of the joint wrenches of a motion: with q and v at held vdot, and with vdot.

A wrench changes with the motion of its link, ``answer``: that of the link's own coordinates and of those that carry it,
as rows handed inward (:func:`.linearise.inward`). What the coordinates of links behind it change in their own wrenches
is handed on as these are, in columns.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..ir.program import Array, Program, Value
from ..topology.chain import Chain
from ..topology.tree import BASE
from . import matrices as mx
from . import rows as rw
from .force_functions import acting_tips
from .functions import Functions
from .fused import fuse, inputs
from .linearise import LinkSection, accelerations, arrays, carrying, inward, moving_slopes, places
from .loop_slopes import tips as loop_tips
from .loop_slopes import wrench_changes

KINDS = "q", "v", "vdot"


def wrench_slopes(
    f: Functions, q: Sequence, v: Sequence, vdot: Sequence, w_ext: Sequence, tau: Sequence, forces: Sequence = ()
) -> dict[str, Array]:
    """``wrench`` (6 n,) and its partial derivatives ``q``, ``v``, ``vdot`` (6 n, nv); zero for a base that floats.

    Where loops close the tree: at held ``forces`` of their rows, and with these, ``row`` (6 n, rows).
    """
    chain, f = f.chain, f.under_inputs(tau)
    acted, shut = f.with_forces(q, v, w_ext), f.loop_state(q, v) if chain.closing.rows else None
    if shut is not None:
        with f.section("loops: their wrenches on the tips"):
            acted = [a + b for a, b in zip(acted, shut.wrenches(forces), strict=True)]
    stores = f.sensitivities(q, v, vdot, acted, tau)
    links = [arrays(chain, i, store, ("answer", "w_J")) for i, store in enumerate(stores)]
    out = {kind: mx.zeros(6 * chain.n, chain.nv) for kind in KINDS}
    of = lambda i: slice(6 * i, 6 * i + 6)  # noqa: E731
    rows = [rw.shifted(-link["r_B"], link["answer"]) for link in links]
    named = lambda i: f.section(f"{chain.names[i]}: its wrench")  # noqa: E731
    for i, owners, here in accelerations(chain, links, named, [(mx.zeros(6, 0), [])] * chain.tree.size):
        out["vdot"][of(i), owners] = mx.multiply(rows[i][:, 3:], here)
    handed = lambda i: (rows[i], range(6 * i, 6 * i + 6))  # noqa: E731
    inward(chain, links, handed, (out["q"], out["v"]), named)
    _columns(chain, links, rows, out, named)
    tips = list(dict.fromkeys((*loop_tips(chain), *acting_tips(chain))))
    if tips:
        at, none = moving_slopes(f, (q, v, vdot, acted, tau), tips, own=False)[1], mx.zeros(6, chain.nv)
        changes = list(f.force_changes(q, v, w_ext, at)) if f.acts else []
        with f.section("loops: what their wrenches do as the tips move"):
            bent = wrench_changes(chain, shut, forces, at, f.apply) if shut is not None else ()
            changes += [(i, by_q, none) for i, by_q in bent]
        _take_forces(chain, links, changes, out, named)
    if shut is not None:
        out["row"] = mx.array(f.felt(q, map(shut.wrenches, shut.units()))).T
    for i, key in enumerate(chain.keys):
        for kind in KINDS if key.floats and not key.joint.given else ():
            out[kind][of(i)] = 0.0
    return out | {"wrench": np.concatenate([link["w_J"] for link in links])}


def _columns(
    chain: Chain,
    links: Sequence[Mapping[str, Array]],
    rows: Sequence[Array],
    out: Mapping[str, Array],
    section: LinkSection,
) -> None:
    """What the coordinates of a link, and of those that it carries, change in its wrench."""
    none: tuple[Array, list[int]] = (mx.zeros(6, 0), [])
    at_nodes = [dict.fromkeys(KINDS, none) for _ in range(chain.tree.size)]
    for i in reversed(range(chain.n)):
        link, (q, eta) = links[i], places(chain, i)
        owned = np.r_[q, eta].tolist()
        coupling, spread = link["rows_eta"][:, 3:].T, mx.multiply(link["answer"][:, 3:], link["axes"])
        turning = {"q": link["F_q"], "v": link["F_qdot"], "vdot": spread}
        modal = {"q": link["F_eta"], "v": link["F_etadot"], "vdot": coupling}
        own = {"q": mx.multiply(rows[i], link["u_q"]), "v": mx.multiply(rows[i], link["u_qdot"])}
        own["vdot"] = rw.shifted(-link["r_B"], spread)
        with section(i):
            for kind in KINDS:
                here, owners = none
                for node, at in carrying(chain, i, link):
                    carried, those = at_nodes[node][kind]
                    here = np.hstack([here, rw.shifted(at["r_T"], rw.rotated_columns(at["R_T"], carried))])
                    owners = [*owners, *those]
                at_joint = rw.shifted(-link["r_B"], np.hstack([here, turning[kind], modal[kind]]))
                J, count = out[kind], len(owners)
                J[6 * i : 6 * i + 6, owners] = at_joint[:, :count]
                J[6 * i : 6 * i + 6, q] = own[kind]
                J[6 * i : 6 * i + 6, eta] = at_joint[:, count + chain.keys[i].joints :]
                if chain.tree.parents[i] != BASE:
                    handed = rw.shifted(link["r_J"], rw.rotated_columns(link["R_rel"], at_joint))
                    there = at_nodes[chain.tree.base(i)]
                    others, known = there[kind]
                    there[kind] = np.hstack([others, handed]), [*known, *owners, *owned]


def _take_forces(
    chain: Chain,
    links: Sequence[Mapping[str, Array]],
    changes: Sequence[tuple[int, Array, Array]],
    out: Mapping[str, Array],
    section: LinkSection,
) -> None:
    """Take the changes (6, nv) with q and v of the wrenches on tips from those of the joint wrenches behind them."""
    at_nodes = [[mx.zeros(6, chain.nv), mx.zeros(6, chain.nv)] for _ in range(chain.tree.size)]
    for i, *both in changes:
        at_tip = at_nodes[chain.tree.tip(i)]
        at_tip[:] = [a + b for a, b in zip(at_tip, both, strict=True)]
    tips = {i for i, *_ in changes}
    for i in reversed(range(chain.n)):
        link, base = links[i], at_nodes[chain.tree.base(i)]
        with section(i):
            here = [mx.zeros(6, chain.nv), mx.zeros(6, chain.nv)]
            for node, at in carrying(chain, i, link, tips):
                moved = (rw.shifted(at["r_T"], rw.rotated_columns(at["R_T"], x)) for x in at_nodes[node])
                here = [a + b for a, b in zip(here, moved, strict=True)]
            at_joint = [rw.shifted(-link["r_B"], x) for x in here]
            for kind, x in zip(("q", "v"), at_joint, strict=True):
                out[kind][6 * i : 6 * i + 6] = out[kind][6 * i : 6 * i + 6] - x
            handed = (rw.shifted(link["r_J"], rw.rotated_columns(link["R_rel"], x)) for x in at_joint)
            base[:] = [a + b for a, b in zip(base, handed, strict=True)]


def wrench_program(chain: Chain, constants: str = "constants") -> Program:
    """``(q, v, vdot, tau, w_ext) -> (wrench, wrench_q, wrench_v, wrench_vdot)``, matrices row by row.

    Where loops close the tree the forces ``row`` of their rows are given too, and ``wrench_row`` (6 n, rows) is what a
    unit of each adds at held accelerations. Of rows that share forces the accelerations of gaps ``wanted`` of these and
    the inertia ``m_eta`` are given besides, and ``row_share`` (rows, nv) is what the forces change with q beyond what
    the motion needs. Where inputs change free fall, or forces between frames, ``wrench_input`` (inputs, 6 n) is what a
    unit of each but torques adds alike; with internal states of forces so is ``wrench_state`` (states, 6 n).
    """
    rows, shares = len(chain.closing.rows), chain.closing.overconstrained
    given = inputs(chain, "q v vdot tau w_ext" + " m_eta" * shares)
    given |= ({"row": rows} if rows else {}) | ({"wanted": rows} if shares else {})

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> dict[str, list[Value]]:
        found = wrench_slopes(f, x["q"], x["v"], x["vdot"], x["w_ext"], x["tau"], x.get("row", ()))
        own = f.wrenches_of_inputs(x["q"], x["v"], x["tau"]) if chain.inputs_load_links else []
        more = {"wrench_input": [w for wrench in own for w in wrench]} if chain.inputs_load_links else {}
        more |= {"wrench_row": list(found["row"].flat)} if rows else {}
        if shares:
            slopes = f.share_slopes(x["q"], x["v"], x["tau"], x["wanted"], x["m_eta"])
            more["row_share"] = list(slopes.flat)
        if chain.n_force_states:
            by_state = f.wrenches_of_states(x["q"], x["v"], x["tau"])
            more |= {"wrench_state": [w for wrench in by_state for w in wrench]}
        return {"wrench": list(found["wrench"])} | {f"wrench_{kind}": list(found[kind].flat) for kind in KINDS} | more

    found = fuse(chain, "wrench_slopes", given, body, constants)
    # The accelerations are of a state at which the forward dynamics found its guards to hold.
    return replace(found, guards=[], origins=[])
