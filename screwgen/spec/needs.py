"""What the modes of a link need of its section, and what segments need of a link."""

from numbers import Integral
from typing import TYPE_CHECKING, Any

from .modes import NEEDS, Modes
from .section import PRODUCTS, SPIN
from .stations import AnySection, Stations
from .values import Path, quoted, refuse, shown

if TYPE_CHECKING:
    from .robot import Link

REMEDIES = dict.fromkeys(("GAy", "GAz"), "it is κGA, N; a profile with nu or G gives it") | dict.fromkeys(
    ("rhoIy", "rhoIz"), "several polynomials of shear beside bending turn sections alone, which must resist"
)
MOST_SEGMENTS = 64
RIGID = "is stated for a rigid link; state modes with it, or leave it out"


def segment_count(value: Any) -> int:
    """The number of segments of a link."""
    if isinstance(value, bool) or not isinstance(value, Integral):
        raise refuse(f"is {shown(value)}; it must be a whole number from 1 to {MOST_SEGMENTS}")
    if not 1 <= int(value) <= MOST_SEGMENTS:
        raise refuse(f"is {shown(value)}; it must be from 1 to {MOST_SEGMENTS}")
    return int(value)


def require_uniform(section: AnySection | None, modes: Modes, direction: str) -> None:
    """Refuse measured frequencies of a direction beside its stiffness, beside stations, shear or rotary inertia."""
    at, name = ("modes", "frequencies", direction), NEEDS[direction][0]
    if isinstance(section, Stations):
        what = "is stated beside stations; measured frequencies are those of a uniform rod, leave one of them out"
        raise refuse(what, at=at)
    stated = [f"modes.{name}" for name in ("shear_y", "shear_z") if getattr(modes, name)]
    stated += [f"section.{name}" for name in ("rhoIy", "rhoIz") if section and section.states(name)]
    if stated:
        what = f"is stated beside {stated[0]}; measured frequencies are those of a rod without shear and rotary inertia"
        raise refuse(f"{what}, leave one of them out", at=at)
    if getattr(section, name, None) is not None:
        spelling = " and ".join(map(quoted, PRODUCTS[name]))
        both = f"is stated beside section.{name} (in the material spelling: {spelling})"
        raise refuse(f"{both}, but either gives the stiffness; leave one of them out", at=at)


def require(section: AnySection, name: str, direction: str, at: Path = ()) -> None:
    """Refuse a section whose property `name` is missing or zero, though modes in `direction` rest on it."""
    value = section.least(name)
    if value:
        return
    wrong = "is missing" if value is None else "is zero"
    wrong += " at a station" if value is not None and section.places else ""
    hint = REMEDIES.get(name) or "in the material spelling: " + " and ".join(map(quoted, PRODUCTS.get(name, SPIN)))
    what = f"{wrong}, but modes.{direction} needs it; it must be > 0 ({hint})"
    raise refuse(what, at=(*at, "section", name))


def require_divisible(link: "Link") -> None:
    """Refuse segments of a link that is rigid, has measured frequencies, or a frame away from its base."""
    if not link.modes.total:
        raise refuse(RIGID, at=("segments",))
    for direction in link.modes.measured:
        what = f"is stated beside segments = {link.segments}, but frequencies are those of the whole link"
        remedy = f"state {NEEDS[direction][0]} in the section, or leave segments out"
        raise refuse(f"{what}; {remedy}", at=("modes", "frequencies", direction))
    if link.frame_at is not None:
        what = f"is stated beside segments = {link.segments}, of which each has its frame at its base"
        raise refuse(f"{what}; leave one of them out", at=("frame_at",))


def require_rigid(link: "Link") -> None:
    """Refuse what only rods of order "exact" that bend can state, of a link without modes."""
    for stated, at in ((link.order == "exact", ("order",)), (link.modes.points is not None, ("modes", "points"))):
        if stated:
            raise refuse(RIGID, at=at)
