"""The equation of every joint's torques with the numbers of its link: what readers look for by the joint's name."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from ...algorithms.scope import derived
from ...spec.parameters import coordinate_names, parameters, per_axis
from ...topology.chain import Chain
from . import elements
from .content import Display, DocumentSection, Heading, Item, Paragraph
from .joint_words import called
from .layout import PAGE, Formula, equation, matrix, width
from .numbers import MANY_LINKS
from .scalars import scalars
from .tables import axis_text, decimal, plain_unit

JOINTS = "Torques of the joints"


def instance(symbol: str, link: int | str) -> str:
    r"""The LaTeX of a symbol of link i for one link: ``\mathbf{M}_{D,i}`` as ``\mathbf{M}_{D,2}``."""
    head, sign, below = symbol.rpartition("_")
    if not sign:
        return f"{symbol}_{link}"
    below = below.removeprefix("{").removesuffix("}")
    if below == "i":
        return f"{head}_{link}"
    return f"{head}_{{{below.removesuffix(',i')},{link}}}"


def joints(chain: Chain) -> DocumentSection | None:
    """The section of the joints that have torques; None if there are none."""
    items = [item for i in range(min(chain.n, MANY_LINKS)) for item in _joint(chain, i)]
    if not items:
        return None
    about = (
        r"The rows of the joints with the number of the link in the place of $i$. Torques $\tau_k$ and coordinates "
        r"$q_k$ are numbered along the robot, as in `tau` and `q`. $\mathbf{w}_i$ is what the joint exerts on its "
        r"link: it accelerates the link, bears what the link's tip carries, and its part along the axes is the torque."
    )
    if any(key.bodies_at("tip") for key in chain.keys[: min(chain.n, MANY_LINKS)]):
        about += (
            r" The tip's twist has the rate $\dot{\mathbf{V}}_T = \mathbf{J}_T\,"
            r"[\dot{\mathbf{V}}_i;\ \ddot{\boldsymbol{\eta}}_i] + \mathbf{b}_T$."
        )
    acting = ["the wrenches of the loops"] * bool(chain.robot.rigid_loops) + ["those of forces"] * bool(chain.forces)
    if acting:
        about += rf" $\boldsymbol{{\mathcal{{W}}}}_{{ext,i}}$ has {' and '.join(acting)} in it."
    if chain.robot.couplings:
        about += r" $\boldsymbol{\tau}_{\lambda,i}$ are the forces of couplings on the axes of joint $i$."
    return DocumentSection(JOINTS, [Paragraph(about), *items])


def _joint(chain: Chain, i: int) -> Iterator[Item]:
    axes = range(chain.tau_offset[i], chain.tau_offset[i + 1])
    if not axes:
        return
    word = called(chain.names[i])
    yield Heading(f"Joint of link {i + 1}, `{chain.names[i]}`{f': the {word}' if word else ''}")
    yield Paragraph(" ".join(_names(chain, i, axes)))
    yield Display((*_torques(chain, i, axes), *_wrench(chain, i)), link=i + 1)
    if besides := [*_besides(chain, i)]:
        yield Paragraph(" ".join(besides))


def _names(chain: Chain, i: int, axes: Sequence[int]) -> Iterator[str]:
    """What the coordinates and torques of a joint are called in the robot file and in tables."""
    own, efforts = per_axis(chain.robot, "joint", "slide"), coordinate_names(chain.robot).tau
    screws = chain.keys[i].screws
    for k, axis in enumerate(axes):
        about = f", {'about' if screws[k].turn else 'along'} {axis_text(screws[k])}" if screws else ""
        moved = rf"$q_{{{axis + 1}}}$ is `{own[axis]}`{about}" if screws else f"about {'xyz'[k]} of the link's frame"
        yield rf"$\tau_{{{axis + 1}}}$ is `{efforts[axis]}`, {moved}."


def _torques(chain: Chain, i: int, axes: Sequence[int]) -> Formula:
    """The torques as parts of the joint's wrench along the axes."""
    key, n = chain.keys[i], i + 1
    names = [[rf"\tau_{{{axis + 1}}}"] for axis in axes]
    left = names[0][0] if len(names) == 1 else matrix(names)
    if chain.robot.couplings:
        left += rf" + \boldsymbol{{\tau}}_{{\lambda,{n}}}"
    terms = [rf"{_subspace(chain, i, axes)}\,{_moved(chain, i)}"]
    terms += [rf"+ \mathbf{{J}}_{{m,{n}}}\,\ddot{{\mathbf{{q}}}}_{n}"] * key.has_constant_inertia
    terms += [rf"+ \mathbf{{D}}_{{q,{n}}}\,\dot{{\mathbf{{q}}}}_{n}"] * key.has_dampers
    terms += [rf"+ \mathbf{{K}}_{{q,{n}}}\,\mathbf{{q}}_{n}"] * key.has_springs
    return equation(left, terms)


def _moved(chain: Chain, i: int) -> str:
    """The wrench of a joint at the origin of its link's frame."""
    return (rf"\mathbf{{J}}_{{B,{i + 1}}}^{{\top}}\," if chain.keys[i].frame_at else "") + rf"\mathbf{{w}}_{i + 1}"


def _subspace(chain: Chain, i: int, axes: Sequence[int]) -> str:
    """The motion subspace, transposed: its entries where they are short, else its symbol."""
    key = chain.keys[i]
    block = derived(key)["joint"]
    subspace = derived(key)["joint_motion"].values["S"] if key.screws else None
    named = rf"\mathbf{{S}}_{i + 1}^{{\top}}"
    if subspace is None or subspace.shape[1] != len(axes):
        return named
    numbered = {sp.Symbol(label, real=True): rf"q_{{{axes[k] + 1}}}" for (k, _), label in block.inputs["q"].labels()}
    write = scalars(block)
    write = replace(write, names={**write.names, **numbered})
    made = dict(block.steps["A"].assignments)
    shown = matrix([[write(sp.sympify(made.get(e, e))) for e in column] for column in subspace.T])
    return shown if width(shown) <= PAGE / 2 else named


def _wrench(chain: Chain, i: int) -> Formula:
    """The wrench of a joint from the motion of its link and from what the tip carries."""
    key, n = chain.keys[i], i + 1
    flexible = rf"+ \mathbf{{M}}_{{D,{n}}}\,\ddot{{\boldsymbol{{\eta}}}}_{n}"
    own = [rf"\mathbf{{M}}_{{V,{n}}}\,\dot{{\mathbf{{V}}}}_{n}", *[flexible] * bool(key.modes)]
    own.append(rf"+ \mathbf{{h}}_{{V,{n}}}")
    body = rf"\mathbf{{M}}_{{T,{n}}}\,\dot{{\mathbf{{V}}}}_{{T,{n}}} + \mathbf{{h}}_{{T,{n}}}"
    tip = [body] * bool(key.bodies_at("tip"))
    carried = [j for j, parent in enumerate(chain.tree.parents) if parent == i]
    tip += [rf"\mathbf{{X}}_{{{j + 1}}}^{{\top}}\,\mathbf{{w}}_{{{j + 1}}}" for j in carried]
    external, reach = rf"\boldsymbol{{\mathcal{{W}}}}_{{ext,{n}}}", rf"\mathbf{{J}}_{{TV,{n}}}^{{\top}}"
    at_tip = rf"+ {reach}\,\left( {' + '.join(tip)} - {external} \right)" if tip else rf"- {reach}\,{external}"
    return equation(_moved(chain, i), [*own, at_tip])


def _besides(chain: Chain, i: int) -> Iterator[str]:
    """What else acts on the axes, and the numbers of the joint."""
    key, link = chain.keys[i], chain.segments[i].link
    acting = [name for name, present in elements.remarks(key).items() if present]
    if acting:
        yield f"On its axes act besides, as their sections say: {', '.join(acting)}."
    if any(chain.tree.stations[i : i + 1]):
        yield r"What a section before the tip carries enters with the $\mathbf{J}_{TV}$ of that section."
    stated = [p for p in parameters(chain.robot) if p.link == link and re.match(r"joint\.(?!mount)", p.field)]
    if stated and chain.segments[i].first:
        shown = ", ".join(f"`{p.name}` {decimal(p.value)} {plain_unit(p.unit)}".strip() for p in stated)
        yield f"Its parameters: {shown}."
