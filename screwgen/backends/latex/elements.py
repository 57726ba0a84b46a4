"""What a document says of the elements that act on the axes of a robot (:mod:`screwgen.elements`)."""

from __future__ import annotations

from collections.abc import Iterable

from ...elements import (
    STOP,
    TRAVELS,
    BristleFriction,
    ElementLaw,
    Size,
    brake,
    friction,
    gear,
    stop,
)
from ...ir.block import Binding
from ...spec.drive import BRISTLES
from ...spec.drive_class import DriveClass
from ...spec.link_class import LinkClass
from ...topology.chain import Chain
from .content import Named


def symbols(chain: Chain) -> list[Named]:
    """Their symbols."""
    stated = [*gear.SYMBOLS, *friction.SYMBOLS] if driven(chain) else []
    stated += [symbol for kind in chain.travel_kinds for symbol in kind.SYMBOLS]
    stated += gear.TRAVEL_SYMBOLS if chain.elastic_travels else ()
    stated += stop.SYMBOLS if STOP in chain.laws else ()
    stated += [symbol for law in _bristles(_drives(chain)) for symbol in law.SYMBOLS]
    stated += friction.FALLING_SYMBOLS if any(drive.stribeck for drive in _drives(chain)) else ()
    stated += friction.LOAD_SYMBOLS if any(drive.load for drive in _drives(chain)) else ()
    stated += friction.BEND_SYMBOLS if any(drive.bend for drive in _drives(chain)) else ()
    stated += brake.SYMBOLS if chain.braked else ()
    stated += brake.ROTOR_SYMBOLS if _brakes_rotors(chain) else ()
    binding = {True: Binding.STATE, False: Binding.PARAMETER}
    return [(symbol, meaning, unit, "1", "-", binding[state]) for symbol, meaning, unit, state in dict.fromkeys(stated)]


def acting(chain: Chain) -> bool:
    """Whether anything acts on the axes but torques, and springs and dampers with one end at rest."""
    return driven(chain) or bool(chain.laws) or bool(chain.robot.couplings) or bool(chain.braked)


def effort(chain: Chain) -> str:
    """The LaTeX of what acts on the axes of a joint."""
    return r"\boldsymbol{\tau}_{q,i}" if acting(chain) else r"\boldsymbol{\tau}_i"


def moved_axes(chain: Chain) -> bool:
    """Whether the motion of axes is given; where a drive is elastic that of its rotor is."""
    return any(axis not in key.added_axes for key in chain.keys for axis in key.prescribed)


def _brakes_rotors(chain: Chain) -> bool:
    """Whether brakes act on rotors of elastic drives."""
    return any(axis in key.added_axes for key in chain.keys for axis in key.brakes)


GIVEN_ROTOR = r"""
A rotor whose motion is given, as the table of inputs says, has its input as acceleration:

$$
\ddot{\vartheta} &= \tau
$$
"""


def equations(chain: Chain) -> list[str]:
    """Their sections of text."""
    drives, bends = _drives(chain), any(drive.bend for drive in _drives(chain))
    out = [gear.equations(_size(drive for drive in drives if not drive.bristles), bends)] if driven(chain) else []
    out += [law.equations(_size(own), bends) for law, own in _bristles(drives).items()]
    out += [stop.EQUATIONS] if STOP in chain.laws else []
    out += [law.kind.equations() for law in chain.laws if isinstance(law, ElementLaw)]
    out += [kind.EQUATIONS for kind in chain.travel_kinds]
    out += [GIVEN_ROTOR] * any(axis in key.added_axes for key in chain.keys for axis in key.prescribed)
    out += [brake.EQUATIONS] * bool(chain.braked) + [brake.ROTOR] * _brakes_rotors(chain)
    out += [law.equations() for law in dict.fromkeys(law for laws in chain.laws_of_inputs for law in laws)]
    return out + ([gear.travel_equations(chain.travel_kinds)] if chain.elastic_travels else [])


def remarks(key: LinkClass) -> dict[str, object]:
    """What acts on the axes of a link in words, each with whether it is there."""
    return {
        "elastic drives": key.added_axes,
        "rigid gears": any(drive.rotor_inertia and not drive.elastic for drive in key.drives),
        **{kind.PLURAL: type(kind) in map(type, key.travels.values()) for kind in TRAVELS},
        "friction": any((drive.coulomb and not drive.bristles) or drive.viscous or drive.bend for drive in key.drives),
        **{law.words: True for law in _bristles(key.drives)},
        "stops": key.stops,
        **{law.WORDS: True for law, _ in key.limits},
        "brakes": key.brakes,
        **{kind.WORDS: True for kind, _ in key.elements},
    }


def driven(chain: Chain) -> bool:
    """Whether axes have drives."""
    return any(key.drives for key in chain.keys)


def _bristles(drives: Iterable[DriveClass]) -> dict[type[BristleFriction], list[DriveClass]]:
    """The drives with bristles of each kind."""
    return {law: own for table, law in BRISTLES.items() if (own := [one for one in drives if one.bristles == table])}


def _size(drives: Iterable[DriveClass]) -> Size:
    """What the size of the dry friction of any of these depends on."""
    sizes = [drive.size for drive in drives]
    return Size(any(size.falls for size in sizes), any(size.loaded for size in sizes))


def _drives(chain: Chain) -> list[DriveClass]:
    """What the drives of all axes state."""
    return [drive for key in chain.keys for drive in key.drives]
