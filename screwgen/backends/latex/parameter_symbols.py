"""The symbols of parameters in the equations of a document."""

from __future__ import annotations

from collections import Counter
from functools import cache

from ...algorithms.scope import derived
from ...elements import KINDS, TRAVELS, brake, friction, gear, stop
from ...spec.drive import BRISTLES
from ...spec.limit import OF_LAWS
from ...spec.link_class import LinkClass
from ...spec.parameters import Parameter, parameters
from ...topology.chain import Chain
from ...topology.parameters import label
from ..equations.names import spelled
from . import forces
from .joints import instance
from .scalars import entry

BLOCKS = ("link", "tip", "tip_body", "joint", "joint_rows")
"""The blocks whose inputs are parameters, or follow from them alone."""
OF_AXES = {"joint.armature": "j_{m", "joint.damping": "d_{q", "joint.stiffness": "k_{q"}
"""The symbols of what each axis of a joint has one of, without the number of the axis."""


def with_symbols(chain: Chain) -> list[tuple[Parameter, str]]:
    """All parameters of a robot, each with its LaTeX; empty where a parameter only makes others."""
    return [(p, _symbol(chain, p)) for p in parameters(chain.robot)]


def of_links(chain: Chain) -> list[str]:
    """The same with the number of the link in the place of ``i``, or as the last index; no two are alike."""
    own = [_of_link(chain, p, symbol) for p, symbol in with_symbols(chain)]
    times = Counter(own)
    every = zip(own, parameters(chain.robot), strict=True)
    return [symbol if symbol and times[symbol] == 1 else spelled(p).latex for symbol, p in every]


def _of_link(chain: Chain, p: Parameter, symbol: str) -> str:
    if p.link is None or not symbol:
        return symbol
    if p.field.startswith("joint.drives.") and len(chain.robot.links[p.link].joint.axes) > 1:
        symbol = instance(symbol, p.index[0] + 1)
    number = chain.firsts[p.link] + 1
    own = symbol.replace("_i", f"_{number}" if number < 10 else f"_{{{number}}}").replace(",i}", f",{number}}}")
    return own if own != symbol else instance(symbol, number)


def _symbol(chain: Chain, p: Parameter) -> str:
    if p.field.startswith("force."):
        return forces.parameter_symbol(chain.robot, p)
    if p.link is None:
        return rf"g_{'xyz'[p.index[0]]}"
    if p.field in OF_AXES:
        return rf"{OF_AXES[p.field]},{p.index[0] + 1}}}"
    if p.field == "tendons.at":
        return rf"d_{{{p.index[1]},{'xyz'[p.index[2]]}}}"
    first = chain.firsts[p.link]
    own = [key for s, key in zip(chain.segments[first:], chain.keys[first:], strict=True) if s.link == p.link]
    found = (_inputs(key).get(label(p), "") for key in dict.fromkeys(own))
    return next(filter(None, found), "") or _of_axis(chain, p)


def _of_axis(chain: Chain, p: Parameter) -> str:
    """That of what acts on an axis."""
    *_, table, name = ("", *p.field.split("."))
    if p.field.startswith("joint.limits."):
        return OF_LAWS[name].symbol if name in OF_LAWS else stop.LETTERS.get(name, "")
    if p.field.startswith("joint.brake."):
        return brake.LETTERS[name]
    if p.field.startswith("joint.elements."):
        own = [kind for key in chain.keys for kind in (*dict(key.elements), *(law.kind for law in key.held_laws))]
        kinds = KINDS | {kind.KIND: kind for kind in own}
        return kinds[table].table()[name].symbol if table in kinds else ""
    if ".transmission." in p.field:
        below = p.field.partition(".transmission.")[2]
        return next((kind.KEYS[name].symbol for kind in TRAVELS if below == f"{kind.TABLE}{name}"), "")
    if below := p.field.partition(".friction.")[2]:
        return BRISTLES[table].KEYS[name].symbol if table in BRISTLES else friction.LETTERS.get(below, "")
    return gear.LETTERS.get(name, "") if p.field.startswith("joint.drives.") else ""


@cache
def _inputs(key: LinkClass) -> dict[str, str]:
    """The entries of the parameters of a class's blocks, by label."""
    signals = (s for name in BLOCKS for s in derived(key)[name].inputs.values())
    return {own: entry(s, index) for s in signals for index, own in s.labels()}
