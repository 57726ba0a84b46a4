"""Small robots for the reader of documents: a three-link arm with features that can be chosen."""

from __future__ import annotations

import copy
from collections.abc import Callable
from dataclasses import dataclass

from screwgen.elements import AxisElement, Bristle, Key, key

Change = Callable[[dict], None]
BODY = {"mass": 0.7, "com": [0.05, 0.02, -0.03], "inertia": [0.02, 0.03, 0.025, 0.001, -0.002, 0.0015]}
SECTION = {"rhoA": 1.3, "EA": 4e3, "EIy": 11.0, "EIz": 17.0, "GJ": 7.0, "rhoIp": 2e-3}
FRICTION = {"coulomb": 0.4, "viscous": 0.3, "velocity": 0.2}
STICKING = {"coulomb": 0.4, "viscous": 0.3, "memory": {"stiffness": 3.0, "damping": 0.2}}
FALLING = {"stribeck": {"static": 0.6, "velocity": 0.7}}
LOAD = {"load": 0.3}
GEARED_BRISTLES = STICKING | FALLING | LOAD
BEND = {"bend": {"friction": 0.5, "velocity": 0.4}}
FOUR_BAR = {"ground": 0.42, "crank": 0.24, "coupler": 0.46, "rocker": 0.27, "angle": -1.4, "branch": "crossed"}
UPPER, FORE, HAND = range(3)


@dataclass(frozen=True)
class Dahl(AxisElement):
    """Dahl's friction, an element with an internal state that the product lacks: ``F = σ z``."""

    KIND = "dahl"
    WORDS = "Dahl's friction"
    FORMULA = r"\sigma\,z"
    RATE = r"\dot{q} - \frac{\sigma\,\left| \dot{q} \right|}{F_c}\,z"
    state = Key("rad", "m", "deflection of Dahl's friction", "z")

    stiffness: float = key("N·m/rad", "N/m", "stiffness while it sticks", r"\sigma", sign="positive")
    coulomb: float = key("N·m", "N", "friction while it slips", "F_c", sign="positive")

    @staticmethod
    def bristle(t, x, w, z, stiffness, coulomb):
        rate = w * (t.call("on", w) - t.call("on", -w))
        return Bristle(stiffness, 0.0, 1.0, stiffness * rate / coulomb)


def arm() -> dict:
    """Two links that bend and one that does not."""
    upper = {"name": "upper", "length": 0.6, "section": dict(SECTION), "joint": {"axes": ["y"]}}
    fore = {"name": "fore", "length": 0.5, "section": dict(SECTION), "joint": {"axes": ["z"]}}
    upper["modes"], fore["modes"] = {"bending_y": 1, "bending_z": 2, "torsion": 1}, {"axial": 1, "bending_z": 1}
    hand = {"name": "hand", "length": 0.3, "section": {"rhoA": 0.9, "rhoIp": 1e-3}, "joint": {"axes": ["x"]}}
    return {
        "name": "arm",
        "gravity": [0.4, -0.3, -9.7],
        "links": [upper, fore, hand | {"bodies": [{"at": "tip", **BODY}]}],
    }


def joint(link: int, **keys) -> Change:
    return lambda robot: robot["links"][link]["joint"].update(copy.deepcopy(keys))


def of(link: int, **keys) -> Change:
    return lambda robot: robot["links"][link].update(copy.deepcopy(keys))


def varying(robot: dict) -> None:
    own = robot["links"][UPPER]["section"]
    half = {name: 0.5 * x for name, x in own.items()}
    robot["links"][UPPER]["section"] = [{"at": 0.0, **own}, {"at": 0.4, **half}, {"at": 1.0, **half}]


def tendons(robot: dict) -> None:
    first = {"name": "left", "at": [[0.0, 0.02, 0.01], [0.0, 0.015, -0.01]]}
    second = {"name": "right", "from": 0.1, "to": 0.8, "at": [[0.0, -0.02, 0.0], [0.0, -0.01, 0.02]]}
    robot["links"][UPPER]["tendons"] = [first, second]
    robot["links"][FORE]["tendons"] = [first | {"at": [[0.0, 0.01, 0.01], [0.0, 0.02, 0.01]]}]


def floating(robot: dict) -> None:
    robot["base"] = "floating"
    first = robot["links"][UPPER]
    first["joint"] = {"axes": []}
    first["bodies"] = [*first.get("bodies", []), {"at": "base", **BODY}]


def coupled(robot: dict) -> None:
    robot["couplings"] = [
        {"axis": "hand.joint[0]", "of": "fore.joint[0]", "ratio": 0.7, "offset": 0.1, "stabilisation": 15.0}
    ]


def looped(end: str, *axes) -> Change:
    """A loop from a section of the arm to a link that goes wherever the loop leads."""

    def change(robot: dict) -> None:
        cart = {"name": "cart", "parent": "world", "joint": {"axes": [{"slide": "x"}, {"slide": "y"}, {"slide": "z"}]}}
        stay = {"name": "stay", "length": 0.2, "section": {"rhoA": 0.8}, "joint": {"axes": ["x", "y", "z"]}}
        robot["links"] += [
            cart | {"bodies": [{"at": "base", "mass": 0.5}]},
            stay | {"bodies": [{"at": "base", **BODY}]},
        ]
        robot["links"][FORE]["markers"] = [{"name": "eye", "at": 0.55}]
        robot["loops"] = [{"between": [end, "stay.tip"], "joint": {"axes": list(axes)}, "stabilisation": 12.0}]

    return change


def forced(robot: dict) -> None:
    """A spring between two links, a rope from the world, and pushes in both kinds of axes."""
    marked = [*robot["links"][UPPER].get("markers", []), {"name": "lug", "at": 0.4}]
    robot["links"][UPPER]["markers"] = marked
    spring = {"name": "spring", "between": ["upper.lug", "hand.tip"]}
    rope = {"name": "rope", "between": [{"world": [0.1, 0.2, 2.0]}, "fore.tip"]}
    robot["forces"] = [
        spring | {"line": {"stiffness": 12.0, "rest": 0.5, "damping": 0.5}},
        rope | {"line": {"stiffness": 4.0, "rest": 0.3, "damping": 0.2, "slack": True}},
    ]
    robot["pushes"] = [{"name": "wind", "at": "upper.lug"}, {"name": "grip", "at": "hand.tip", "axes": "marker"}]


def curved(robot: dict) -> None:
    """Exact links, two of them curved at rest: by stations, and the same all along."""
    robot["order"] = "exact"
    bent = {"bending_y": 0.6, "bending_z": -0.4, "torsion": 0.5}
    robot["links"][UPPER]["rest"] = [
        {"at": 0.0, **bent},
        {"at": 0.35, "bending_y": 0.2, "bending_z": 0.3, "torsion": -0.2},
    ]
    robot["links"][UPPER]["rest"] += [{"at": 1.0, **bent}]
    robot["links"][FORE]["rest"] = {"bending_z": 0.8}
    for link in robot["links"]:
        link.pop("frame_at", None)


def branched(robot: dict) -> None:
    robot["links"][HAND]["parent"] = "upper"
    robot["links"][HAND]["at"] = {"s": 0.45}


def elastic(transmission: dict) -> Change:
    drive = {"ratio": 30.0, "rotor_inertia": 1e-3, "stiffness": 60.0, "damping": 0.2, "friction": FRICTION}
    return joint(FORE, drives=[drive | {"transmission": transmission}])


CYLINDER = {"crank": 0.1, "base": 0.3, "angle": 1.1}
SLOTS: dict[str, dict[str, Change]] = {
    "order": {
        "order 2": lambda robot: robot.update(order=2),
        "exact": lambda robot: robot.update(order="exact"),
        "one exact": of(UPPER, order="exact"),
        "curved": curved,
    },
    "upper": {
        "varying": varying,
    },
    "fore": {
        "carried": of(FORE, at={"s": 0.6}),
        "mounted": joint(FORE, mount={"xyz": [0.02, -0.03, 0.04], "rpy": [0.2, -0.3, 0.4]}),
    },
    "damping": {"ratio": of(UPPER, damping={"ratio": 0.02}), "time": of(UPPER, damping={"time": 0.01})},
    "base": {"floating": floating},
    "tendons": {"tendons": tendons},
    "drive": {
        "rigid": joint(FORE, drives=[{"ratio": 30.0, "rotor_inertia": 1e-3, "friction": FRICTION}]),
        "falling": joint(FORE, drives=[{"friction": FRICTION | FALLING | BEND}]),
        "geared bend": joint(
            FORE, drives=[{"rotor_inertia": 1e-3, "stiffness": 60.0, "friction": FRICTION | FALLING | BEND}]
        ),
        "geared load": joint(
            FORE, drives=[{"ratio": 3.0, "rotor_inertia": 1e-3, "stiffness": 60.0, "friction": FRICTION | LOAD}]
        ),
        "bristles": joint(FORE, drives=[{"ratio": 30.0, "rotor_inertia": 1e-3, "friction": STICKING}]),
        "geared bristles": joint(
            FORE, drives=[{"ratio": 30.0, "rotor_inertia": 1e-3, "stiffness": 60.0, "friction": GEARED_BRISTLES}]
        ),
        "four-bar": joint(FORE, drives=[{"transmission": {"four_bar": FOUR_BAR}, "rotor_inertia": 0.1, "ratio": 3.0}]),
        "elastic cylinder": elastic(CYLINDER),
    },
    "axis": {
        "stops": joint(FORE, limits=[{"lower": 0.35, "upper": 0.5, "stiffness": 40.0, "damping": 0.3}]),
        "spring": joint(FORE, elements=[{"spring": {"stiffness": 3.0, "rest": 0.4}}]),
        "dahl": joint(UPPER, elements=[Dahl(2.5, 0.7)]),
        "passive": joint(FORE, stiffness=[2.0], damping=[0.3]),
    },
    "hand": {
        "skew": joint(HAND, axes=[[0.3, -0.4, 0.866], "y"], armature=[0.01, 0.02]),
        "slide": joint(HAND, axes=[{"slide": [0.6, 0.0, 0.8]}, "y"], damping=[0.1, 0.2]),
        "plain": joint(HAND, drives=[{"friction": FRICTION}]),
        "bent bristles of a slide": joint(HAND, axes=[{"slide": "x"}], drives=[{"friction": STICKING | BEND}]),
        "bristles of a slide": joint(HAND, axes=[{"slide": "x"}], drives=[{"friction": STICKING | FALLING}]),
        "screw": joint(HAND, axes=[{"screw": "z", "pitch": -0.07}]),
        "branched": branched,
    },
    "closing": {
        "coupling": coupled,
        "hinge loop": looped("fore.tip", [0.6, 0.8, 0.0]),
        "weld loop": looped("fore.eye"),
        "sliding loop": looped("fore.eye", {"slide": "x"}, "x", "y"),
    },
    "acting": {"forces": forced},
}
"""What can be chosen, one of each kind."""


def robot_with(*names: str) -> dict:
    """The arm with these features."""
    out = arm()
    for slot in ("order", "upper", "fore", "damping", "tendons", "drive", "axis", "hand", "closing", "base", "acting"):
        for name in names:
            if name in SLOTS[slot]:
                SLOTS[slot][name](out)
    return out
