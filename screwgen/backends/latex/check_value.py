"""A state of a robot with its accelerations and joint wrenches: a check for whoever programs the equations."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ...errors import ScrewgenError
from ...spec.link_class import EXACT
from ...spec.parameters import parameters
from ...topology.chain import Chain
from ..numpy.reference import accelerations, bristle_stiffness
from .content import DocumentTable, Heading, Item, Paragraph
from .tables import exact

TURN = (0.3, -0.5, 0.7, 0.2, -0.4, 0.6)
RATE = (4.0, -3.0, 3.5, -4.5, 2.5, 5.0)
EFFORT = (1.0, -2.0, 1.5, 0.5, -1.0, 2.5)
OTHER = (-0.05, 0.15, 0.1, 0.5, 1.0, -0.8)
WRENCH = (0.1, -0.2, 0.3, 1.0, -2.0, 1.5)
QUATERNION = (0.8, 0.4, 0.4, 0.2)
MODES: dict[int | str, float] = {1: 0.15, 2: 0.03, EXACT: 0.3}
"""Sizes of first modes over the length of a link, by its order (2 is for small ones); further ones a tenth."""
MODE_RATE, SLACK = 20.0, 1e-4
"""The size of their rates, so large that every term shows in the first digits of a result; the twist of gears."""
NEARER = (1.0, 0.4, 0.1, 0.0)
"""By what the posture is scaled until the robot has accelerations there."""
PLACES = 12
"""How many digits results have: those that do not depend on the last digits of constants."""
CANCELLED = 1e-25
"""Smaller parts of the largest value are the last digits of values that cancel."""
ACROSS = 4
"""How many links have their wrenches side by side."""
ALONE, BESIDE = (0.1, 0.28, 0.14, 0.14, 0.34), (0.08, 0.22, 0.11, 0.11, 0.22, 0.07, 0.19)
"""The columns of the state: alone, and beside the wrench of a single link."""
LETTERS = [rf"$\tau_{{w,{x}}}$" for x in "xyz"] + [f"$F_{x}$" for x in "xyz"]
MANY = 8
"""Of more links only the wrenches of the first are given."""


def items(chain: Chain) -> Iterator[Item]:
    """The tables, below a heading of their own; none for a robot that has no accelerations in these postures."""
    for nearer in NEARER:
        q, v, u, w_ext = state(chain, nearer)
        try:
            found = accelerations(chain, q, v, u, w_ext.tolist())
            vdot, wrench = map(_rounded, found)
        except ScrewgenError:
            continue
        if np.all(np.isfinite(vdot)):
            yield from _tables(chain, q, v, u, vdot, np.reshape(wrench, (chain.n, 6)))
            return


def _rounded(values: Sequence[float]) -> np.ndarray:
    """Values with as many digits as they have; what is left of those that cancel is zero."""
    least = CANCELLED * max(map(abs, values), default=0.0)
    return np.array([float(f"{x:.{PLACES}g}") if abs(x) > least else 0.0 for x in values])


def _besides(chain: Chain) -> str:
    """What acts on tips besides external wrenches."""
    acting = ["the loops"] * bool(chain.robot.rigid_loops) + ["the forces between frames"] * bool(chain.forces)
    return f" besides {' and '.join(acting)}" if acting else ""


def _tables(
    chain: Chain, q: Sequence[float], v: Sequence[float], u: Sequence[float], vdot: np.ndarray, wrench: np.ndarray
) -> Iterator[Item]:
    yield Heading("Check value")
    about = (
        "A state, with all digits, and the accelerations and joint wrenches that a program of these equations gives,"
    )
    about += f" to {PLACES} digits of the largest."
    if chain.closing.rows:
        about += " Loops need not be closed there: their gaps close by the stabilisation."
    wrench_of = {chain.n: WRENCH} | ({1: OTHER} if chain.n > 1 else {})
    acting = " and ".join(
        rf"$\boldsymbol{{\mathcal{{W}}}}_{{ext,{i}}} =$ [{', '.join(map(exact, x))}]"
        for i, x in sorted(wrench_of.items())
    )
    where, besides = "s of the first and the last link" * (chain.n > 1), _besides(chain)
    yield Paragraph(f"{about} At the tip{where}, {acting}; at others nothing acts{besides}.")
    head = ["entry", r"$\mathbf{q}$", r"$\mathbf{v}$", r"$\mathbf{u}$", r"$\dot{\mathbf{v}}$"]
    columns = [[exact(x) for x in column] for column in (q, v, u, vdot)]
    size = max(map(len, columns)) if chain.n > 1 else max(len(wrench[0]), *map(len, columns))
    columns = [[f"{k + 1}" if k < len(v) else "" for k in range(size)], *columns]
    if chain.n == 1:
        head += ["", r"$\mathbf{w}_1$"]
        columns += [LETTERS, list(map(exact, wrench[0]))]
    rows = zip(*(column + [""] * (size - len(column)) for column in columns), strict=True)
    yield DocumentTable(tuple(head), BESIDE if chain.n == 1 else ALONE, tuple(rows))
    if chain.n == 1:
        return
    yield Paragraph(r"The joint wrenches $\mathbf{w}_i$ there:")
    for first in range(0, min(chain.n, MANY), ACROSS):
        links = range(first, min(first + ACROSS, chain.n, MANY))
        lines = tuple((letter, *(exact(wrench[i][k]) for i in links)) for k, letter in enumerate(LETTERS))
        widths = (0.1, *[0.9 / ACROSS] * len(links))
        yield DocumentTable(("entry", *(rf"$\mathbf{{w}}_{{{i + 1}}}$" for i in links)), widths, lines)


def state(chain: Chain, nearer: float) -> tuple[list[float], list[float], list[float], np.ndarray]:
    """``q, v, u, w_ext``; joints and modes are ``nearer`` to their home than 1."""
    q = np.array(chain.home, float)
    for k, place in enumerate(chain.axis_places):
        q[place] = nearer * TURN[k % len(TURN)]
    for part in chain.curved:
        first = part.q.start + (part.joint.turn_at or 0)
        q[first : first + 4] = QUATERNION if nearer else (1.0, 0.0, 0.0, 0.0)
    if chain.n_added:
        p = [x.value for x in parameters(chain.robot)]
        joints = slice(chain.base_q, chain.q_offset[-1])
        q[chain.base_q : chain.eta_q] = chain.with_added(q[joints], p)
        q[chain.eta_q - chain.n_added : chain.eta_q] += SLACK
    v = np.array([RATE[k % len(RATE)] for k in range(chain.nv)])
    modes = [(number, i) for i, key in enumerate(chain.keys) for _, number in key.directions]
    for k, (number, i) in enumerate(modes):
        size = _length(chain, i) / 10.0**number
        q[chain.eta_q + k] = (-1) ** k * (nearer or 1.0) * MODES.get(chain.keys[i].order, MODES[1]) * size
        v[chain.eta_v + k] = MODE_RATE * RATE[k % len(RATE)] * size
    bent = [EFFORT[k % len(EFFORT)] / stiffness for k, stiffness in enumerate(bristle_stiffness(chain))]
    u = [EFFORT[k % len(EFFORT)] for k in range(chain.n_tau)]
    w_ext = np.zeros((chain.n, 6))
    w_ext[0], w_ext[-1] = OTHER, WRENCH
    rounded = [float(f"{x:.12g}") for x in q]
    return rounded, [float(f"{x:.12g}") for x in (*v, *bent)], u, w_ext


def _length(chain: Chain, i: int) -> float:
    """The length of a link or segment that modes are measured by; that of a body from a file is its reach."""
    link, key = chain.robot.links[chain.segments[i].link], chain.keys[i]
    length = link.length if key.elastic is None else key.elastic.reach
    return float(length or 1.0) / link.pieces
