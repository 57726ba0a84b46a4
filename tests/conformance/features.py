"""The features of a robot file, as levels of factors, and which of them cannot stand together.

A robot of the matrix is a small arm: a rod, the *boom*, carries a second link, the *fore*, on which more may hang. Each
factor changes one thing of it: the boom's joint, the drive of the fore's axis, what closes a loop. A *row* chooses a
level of every factor; the first level of each is the plain one and is no feature.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping

Row = Mapping[str, str]

FACTORS: dict[str, dict[str, str]] = {
    "base": {
        "fixed": "",
        "floating": "a floating base, a rigid body that carries the arm",
        "afloat": "a floating base that is itself a flexible link",
        "moving": "a base that moves as is given, a rigid body that carries the arm",
        "accelerated": "a base that accelerates as is given, `base_acceleration = true`",
    },
    "turn": {
        "hinge": "",
        "ball": "a ball joint",
        "slide": "a joint that slides",
        "screw": "a joint that screws, and turns about a second axis",
        "two axes": "a joint of two axes, one of them skew, on a mount",
        "three axes": "a joint of three axes",
    },
    "order": {"first order": "", "second order": "links with `order = 2`", "exact rod": 'links with `order = "exact"`'},
    "section": {
        "uniform": "",
        "stations": "a section by stations",
        "profile": "a section by a profile, with modulus and density",
    },
    "pieces": {"whole": "", "segments": "a link in segments"},
    "modes": {
        "bending": "",
        "stretch and twist": "axial and torsional modes",
        "shear": "modes of shear, with rotary inertia",
        "clamped_free": "the basis `clamped_free`",
        "frequencies": "measured frequencies in place of stiffness",
    },
    "damping": {"undamped": "", "ratio": "damping by a ratio", "time": "damping of the material"},
    "tendon": {
        "none": "",
        "tendon": "a tendon along a link, beside one that is not actuated",
        "shared tendon": "a tendon along two links",
    },
    "fore": {
        "rigid": "",
        "rod": "a second flexible link",
        "curved fore": "a second link, exact, curved and twisted at rest, that another one carries",
        "elements": "a body from finite elements",
    },
    "at": {"tip": "", "station": "a link carried between base and tip of another"},
    "drive": {
        "none": "",
        "rotor": "a rigid gear with a rotor",
        "elastic gear": "an elastic gear",
        "cylinder": "a cylinder",
        "four-bar": "a four-bar linkage",
        "elastic cylinder": "a cylinder behind an elastic gear",
        "elastic four-bar": "a four-bar linkage behind an elastic gear",
    },
    "friction": {
        "smooth": "",
        "friction": "dry and viscous friction of a drive, which falls and bends",
        "loaded friction": "friction behind an elastic gear that grows with its load",
        "bristles": "friction that remembers, an internal state",
        "Dahl": "friction that yields as metal does, an internal state",
    },
    "axis": {
        "free": "",
        "spring": "a preloaded spring, an element of an axis",
        "stops": "stops at limits",
        "limited": "limits of efforts, which steps keep",
        "limited rate": "limits of the rate of efforts, an internal state, besides",
        "passive": "armature, damping and stiffness of an axis",
        "given motion": "axes whose motion is given",
        "brakes": "brakes of axes, inputs, half closed",
    },
    "closing": {
        "open": "",
        "coupling": "a coupling of two axes",
        "ball loop": "a loop closed by a ball joint",
        "hinge loop": "a loop closed by a hinge",
        "slide loop": "a loop closed by a slide",
        "welded loop": "a loop closed by a weld",
        "compliant loop": "a loop whose joint gives way where it blocks, a slide and a hinge",
    },
    "force": {
        "none": "",
        "line spring": "a spring and damper between a place along a link and a tip",
        "rope": "a rope from a point of the world to a tip",
        "bushing": "a bushing between a place along a link and a tip",
        "winch": "lines with winches, inputs, one taken at the end of steps, and one that relaxes, an internal state",
        "contact": "spheres that press and rub on a plane of another link and on a sphere of the world, and drag",
    },
    "push": {
        "unpushed": "",
        "push": "a wrench from outside in world axes, at a place along a link",
        "marker push": "a wrench from outside in the axes of a tip, beside that of the link",
    },
    "more": {
        "nothing": "",
        "frame": "a link frame away from the joint",
        "flat": "`section_rotation = false`",
        "bodies": "bodies at base and tip, off centre, with inertia",
        "markers": "markers along links, and sensors there",
    },
}
"""Levels by factor, with what each is in words; the first of each, the plain one, has none."""

FEATURES: dict[str, str] = {name: words for levels in FACTORS.values() for name, words in levels.items() if words}
FACTOR_OF: dict[str, str] = {
    name: factor for factor, levels in FACTORS.items() for name, words in levels.items() if words
}

BESIDE_BALLS = "what closes loops is not known beside ball joints yet"
NO_JOINT = "a base that floats has no joint"
TRAVELS = ("cylinder", "four-bar", "elastic cylinder", "elastic four-bar")
IMPOSSIBLE: dict[tuple[str, str], str] = {
    ("exact rod", "flat"): "an exact rod turns what its tip carries",
    ("curved fore", "flat"): "an exact rod turns what its tip carries",
    ("segments", "flat"): "segments turn what their tips carry",
    ("segments", "frame"): "the frame of a link in pieces is at its joint",
    ("segments", "frequencies"): "measured frequencies are those of a whole link",
    ("stations", "frequencies"): "measured frequencies take the place of stiffness, which stations state",
    ("profile", "frequencies"): "measured frequencies take the place of stiffness, which a profile states",
    **{("afloat", turn): NO_JOINT for turn in list(FACTORS["turn"])[1:]},
    **{
        (drive, "loaded friction"): "only the stretch of an elastic gear tells its load"
        for drive in ("rotor", *TRAVELS)
    },
    **{
        (drive, friction): "bristles are not known behind transmissions yet"
        for friction in ("bristles", "Dahl")
        for drive in TRAVELS
    },
    **{(drive, "given motion"): "the input of a transmission is its force" for drive in TRAVELS},
    **{(drive, "brakes"): "brakes are not known behind such gears" for drive in TRAVELS[2:]},
    **{("ball", closing): BESIDE_BALLS for closing in list(FACTORS["closing"])[1:] if closing != "compliant loop"},
}
"""Pairs that a robot file cannot state, with the reason; a test states each and is refused."""

BUILT_OTHERWISE: dict[tuple[str, str], str] = {
    ("shared tendon", "elements"): "a tendon runs along rods",
}
"""Pairs that the two links of the matrix leave no place for; another robot may have them."""

NEEDS: dict[str, tuple[str, ...]] = {
    "shared tendon": ("rod", "curved fore"),
    "loaded friction": ("elastic gear",),
}
"""What a level needs one of."""


def possible(row: Row) -> bool:
    """Whether a row, also one that chooses only some factors, can be built."""
    chosen = set(row.values())
    if any(a in chosen and b in chosen for a, b in (*IMPOSSIBLE, *BUILT_OTHERWISE)):
        return False
    return not any(
        level in chosen and FACTOR_OF[needed[0]] in row and not chosen & set(needed) for level, needed in NEEDS.items()
    )


def conditions() -> list[dict]:
    """The same as conditions of `covertable`: of each pair that cannot stand together, and each need."""
    is_ = lambda level: {"operator": "eq", "left": FACTOR_OF[level], "value": level}  # noqa: E731
    never = [
        {"operator": "not", "condition": {"operator": "and", "conditions": [is_(a), is_(b)]}}
        for a, b in (*IMPOSSIBLE, *BUILT_OTHERWISE)
    ]
    needs = [
        {"operator": "or", "conditions": [{"operator": "not", "condition": is_(level)}, *map(is_, needed)]}
        for level, needed in NEEDS.items()
    ]
    return never + needs


def features(row: Row) -> tuple[str, ...]:
    """The features of a row, in the order of the table."""
    return tuple(level for level in row.values() if level in FEATURES)


def pairs(names: tuple[str, ...]) -> set[frozenset[str]]:
    """All pairs of these features."""
    return {frozenset(pair) for pair in itertools.combinations(names, 2)}


def possible_pairs() -> set[frozenset[str]]:
    """All pairs of features of different factors that can stand together."""
    found = set()
    for a, b in itertools.combinations(FEATURES, 2):
        if FACTOR_OF[a] != FACTOR_OF[b] and possible({FACTOR_OF[a]: a, FACTOR_OF[b]: b}):
            found.add(frozenset((a, b)))
    return found
