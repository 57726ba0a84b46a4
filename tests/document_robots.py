"""Small robots for the reader of documents: a three-link arm in which every feature of the robot file can be chosen."""

from __future__ import annotations

import copy
from collections.abc import Callable
from pathlib import Path

import flexible_robots as fr
import numpy as np
from pydantic import ValidationError

from screwgen import Robot

Change = Callable[[dict], None]
BODY = {"mass": 0.7, "com": [0.05, 0.02, -0.03], "inertia": [0.02, 0.03, 0.025, 0.001, -0.002, 0.0015]}
SECTION = {"rhoA": 1.3, "EA": 4e3, "EIy": 11.0, "EIz": 17.0, "GJ": 7.0, "rhoIp": 2e-3}
FRICTION = {"coulomb": 0.4, "viscous": 0.3, "velocity": 0.2}
FOUR_BAR = {"ground": 0.42, "crank": 0.24, "coupler": 0.46, "rocker": 0.27, "angle": -1.4, "branch": "crossed"}
UPPER, FORE, HAND = range(3)


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


def section(link: int, **keys) -> Change:
    return lambda robot: robot["links"][link]["section"].update(keys)


def modes(link: int, **keys) -> Change:
    return lambda robot: robot["links"][link]["modes"].update(keys)


def varying(robot: dict) -> None:
    own = robot["links"][UPPER]["section"]
    half = {name: 0.5 * x for name, x in own.items()}
    robot["links"][UPPER]["section"] = [{"at": 0.0, **own}, {"at": 0.4, **half}, {"at": 1.0, **half}]


def sheared(robot: dict) -> None:
    robot["links"][UPPER]["section"] |= {"GAy": 300.0, "GAz": 400.0}
    robot["links"][UPPER]["modes"] |= {"shear_y": 1, "shear_z": 1}


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


def branched(robot: dict) -> None:
    robot["links"][HAND]["parent"] = "upper"
    robot["links"][HAND]["at"] = {"s": 0.45}


def from_file(robot: dict) -> None:
    kept = {key: robot["links"][FORE][key] for key in ("name", "joint")}
    robot["links"][FORE] = kept | {"cloud": fr.random_cloud(np.random.default_rng(5), 2)}


def measured(robot: dict) -> None:
    robot["links"][FORE]["modes"] = {"bending_z": 2, "frequencies": {"bending_z": [4.0, 27.0]}}
    del robot["links"][FORE]["section"]["EIy"]


def elastic(transmission: dict | None) -> Change:
    drive = {"ratio": 30.0, "rotor_inertia": 1e-3, "stiffness": 60.0, "damping": 0.2, "friction": FRICTION}
    return joint(FORE, drives=[drive | ({"transmission": transmission} if transmission else {})])


CYLINDER = {"crank": 0.1, "base": 0.3, "angle": 1.1}
SLOTS: dict[str, dict[str, Change]] = {
    "order": {
        "order 2": lambda robot: robot.update(order=2),
        "exact": lambda robot: robot.update(order="exact"),
        "one exact": of(UPPER, order="exact"),
    },
    "upper": {
        "varying": varying,
        "sheared": sheared,
        "rotary": section(UPPER, rhoIy=1e-3, rhoIz=2e-3),
        "clamped free": modes(UPPER, basis="clamped_free"),
        "segments": of(UPPER, segments=2),
        "frame off": of(UPPER, frame_at=0.1),
    },
    "fore": {
        "from a file": from_file,
        "measured": measured,
        "carried": of(FORE, at={"s": 0.6}),
        "mounted": joint(FORE, mount={"xyz": [0.02, -0.03, 0.04], "rpy": [0.2, -0.3, 0.4]}),
    },
    "damping": {"ratio": of(UPPER, damping={"ratio": 0.02}), "time": of(UPPER, damping={"time": 0.01})},
    "base": {"floating": floating},
    "tendons": {"tendons": tendons},
    "drive": {
        "elastic": elastic(None),
        "rigid": joint(FORE, drives=[{"ratio": 30.0, "rotor_inertia": 1e-3, "friction": FRICTION}]),
        "cylinder": joint(FORE, drives=[{"transmission": CYLINDER, "rotor_inertia": 2.0, "friction": FRICTION}]),
        "four-bar": joint(FORE, drives=[{"transmission": {"four_bar": FOUR_BAR}, "rotor_inertia": 0.1, "ratio": 3.0}]),
        "elastic cylinder": elastic(CYLINDER),
        "elastic four-bar": elastic({"four_bar": FOUR_BAR}),
    },
    "axis": {
        "stops": joint(FORE, limits=[{"lower": 0.35, "upper": 0.5, "stiffness": 40.0, "damping": 0.3}]),
        "spring": joint(FORE, elements=[{"spring": {"stiffness": 3.0, "rest": 0.4}}]),
        "passive": joint(FORE, stiffness=[2.0], damping=[0.3]),
    },
    "hand": {
        "ball": joint(HAND, axes="ball"),
        "skew": joint(HAND, axes=[[0.3, -0.4, 0.866], "y"], armature=[0.01, 0.02]),
        "slide": joint(HAND, axes=[{"slide": [0.6, 0.0, 0.8]}, "y"], damping=[0.1, 0.2]),
        "screw": joint(HAND, axes=[{"screw": "z", "pitch": -0.07}]),
        "branched": branched,
    },
    "closing": {
        "coupling": coupled,
        "ball loop": looped("hand.tip", "x", "y", "z"),
        "hinge loop": looped("fore.tip", [0.6, 0.8, 0.0]),
        "weld loop": looped("fore.eye"),
        "sliding loop": looped("fore.eye", {"slide": "x"}, "x", "y"),
    },
}
"""What can be chosen, one of each kind."""
CHOICES = {name: change for own in SLOTS.values() for name, change in own.items()}


def robot_with(*names: str, folder: Path | None = None) -> dict:
    """The arm with these features."""
    out = arm()
    for slot in ("order", "upper", "fore", "damping", "tendons", "drive", "axis", "hand", "closing", "base"):
        for name in names:
            if name in SLOTS[slot]:
                SLOTS[slot][name](out)
    return fr.with_files(out, folder) if folder is not None else out


def drawn(seed: int, folder: Path) -> dict:
    """A robot with features of all kinds; what a robot file refuses is drawn again."""
    for attempt in range(100):
        robot = robot_with(*mixed(seed, attempt), folder=folder)
        try:
            Robot.model_validate(robot)
        except ValidationError:
            continue
        return robot
    raise RuntimeError("no robot in 100 draws")


def mixed(seed: int, attempt: int = 0) -> list[str]:
    """Features of all kinds together, by chance."""
    rng, out = np.random.default_rng([7, seed, attempt]), []
    for own in SLOTS.values():
        name = [None, *own][rng.integers(len(own) + 1)]
        if name:
            out.append(name)
    return out
