"""The robot of a row: a plain dict in the robot file's format, in which every feature has numbers of its own.

Links that are too small to matter are avoided: stiffness is low and tips carry bodies, so that a term that is left out
shows in the first digits. A body from finite elements stands under the key `cloud` of its link, as points and modes.
"""

from __future__ import annotations

import copy

import flexible_robots as fr
import numpy as np

from conformance.features import Row

BOOM = {"rhoA": 1.2, "EIy": 40.0, "EIz": 55.0, "EA": 4e3, "GJ": 8.0, "rhoIp": 6e-3}
SHEAR = {"GAy": 900.0, "GAz": 1200.0, "rhoIy": 4e-3, "rhoIz": 5e-3}
FORE = {"rhoA": 0.9, "EIy": 12.0, "EIz": 15.0, "rhoIp": 4e-3}
REST = [
    {"at": 0.0, "bending_y": 0.9, "bending_z": -0.3, "torsion": 0.4},
    {"at": 0.3, "bending_y": 0.5, "bending_z": 0.4, "torsion": 0.4},
    {"at": 1.0, "bending_y": 0.7, "bending_z": 0.6, "torsion": -0.5},
]
"""Curvature and twist at rest, 1/m."""
PAYLOAD = {"at": "tip", "mass": 0.8, "com": [0.03, -0.02, 0.04], "inertia": [0.004, 0.005, 0.006, 3e-4, -2e-4, 1e-4]}
HULL_BODY = {"at": "base", "mass": 4.0, "com": [0.1, 0.05, -0.04], "inertia": [0.3, 0.4, 0.35, 0.02, 0.01, -0.03]}
TURNS: dict[str, dict] = {
    "hinge": {"axes": ["z"]},
    "ball": {"axes": "ball"},
    "slide": {"axes": [{"slide": "y"}]},
    "screw": {"axes": [{"screw": "z", "pitch": 0.07}, "y"]},
    "two axes": {"axes": ["z", [0.2, 1.0, 0.3]], "mount": {"xyz": [0.1, -0.05, 0.2], "rpy": [0.2, -0.4, 0.3]}},
    "three axes": {"axes": ["z", "y", "x"]},
}
TRANSMISSIONS = {
    "cylinder": {"base": 0.5, "crank": 0.2, "angle": 1.1},
    "four-bar": {
        "four_bar": {"ground": 0.4, "crank": 0.6, "coupler": 0.9, "rocker": 0.25, "angle": 1.4, "branch": "crossed"}
    },
}
TRANSMISSIONS["other branch"] = {"four_bar": TRANSMISSIONS["four-bar"]["four_bar"] | {"branch": "open"}}
GEAR = {"stiffness": 60.0, "damping": 0.4}
ROTOR = {"ratio": 8.0, "rotor_inertia": 2e-3}
FRICTION = {"coulomb": 0.6, "viscous": 0.07, "velocity": 0.3}
BRISTLES = {"coulomb": 1.5, "viscous": 0.3, "memory": {"stiffness": 45.0, "damping": 0.4}}
BRISTLES |= {"stribeck": {"static": 2.2, "velocity": 0.6}}
BEND = {"bend": {"friction": 0.5, "velocity": 0.8}}
FALLING = FRICTION | {"stribeck": {"static": 1.1, "velocity": 0.7}} | BEND
DRIVES: dict[str, dict] = {
    "rotor": ROTOR,
    "elastic gear": ROTOR | GEAR,
    "cylinder": {"ratio": 30.0, "rotor_inertia": 2e-3, "transmission": TRANSMISSIONS["cylinder"]},
    "four-bar": ROTOR | {"transmission": TRANSMISSIONS["four-bar"]},
    "elastic cylinder": {"ratio": 30.0, "rotor_inertia": 2e-3, "stiffness": 4e3, "damping": 9.0}
    | {"transmission": TRANSMISSIONS["cylinder"]},
    "elastic four-bar": ROTOR | GEAR | {"transmission": TRANSMISSIONS["other branch"]},
}
FRICTIONS: dict[str, dict] = {
    "friction": FALLING,
    "loaded friction": FALLING | {"load": 0.4},
    "bristles": BRISTLES | BEND,
    "Dahl": {"coulomb": 1.4, "viscous": 0.2, "dahl": {"stiffness": 50.0, "ductility": 0.6}},
}
EFFORT, ENOUGH = 6.0, 500.0
"""Limits of efforts: that of the fore's axis, which the judge's state is beyond, and one that nothing reaches."""
RATE = {"effort_rate": 50.0, "effort_time": 0.04}
"""That of the rate of the fore's."""
LOOPS: dict[str, list] = {
    "ball loop": ["x", "y", "z"],
    "hinge loop": ["y"],
    "slide loop": [{"slide": "x"}],
    "welded loop": [],
}
COMPLIANT = {"axes": [{"slide": [0.6, 0.0, 0.8]}, "y"], "stiffness": [35.0, 12.0], "damping": [1.2, 0.4]}
STRUT = {"stiffness": 60.0, "rest": 0.2, "damping": 3.0}
ROPE = {"stiffness": 9.0, "rest": 0.4, "damping": 1.5, "slack": True}
WINCH = {"stiffness": 40.0, "rest": 0.3, "damping": 2.0, "winch": True}
TAKEN_LATER = {"rest": 0.25, "slack": True, "implicit": True}
RELAXING = {"stiffness": 25.0, "rest": 0.3, "damping": 1.0, "relaxation": 35.0, "relaxation_time": 0.2}
BUSHING = {"stiffness": [40.0, 55.0, 30.0, 6.0, 9.0, 4.0], "damping": [2.0, 1.5, 3.0, 0.2, 0.3, 0.15]}
FLOOR = {"radius": 0.6, "stiffness": 40.0, "width": 0.2, "normal": [0.3, -0.2, 0.9]}
FLOOR |= {"damping": 0.3, "friction": 0.4, "velocity": 0.3}
BALL = {"radius": 1.1, "other": 0.9, "stiffness": 15.0, "width": 0.3, "damping": 0.2}
DRAG = {"linear": [1.5, 2.5, 0.8], "quadratic": 0.9}
FORCES: dict[str, dict] = {
    "line spring": {"forces": [{"name": "strut", "between": ["boom.eye", "fore.tip"], "line": STRUT}]},
    "rope": {"forces": [{"name": "rope", "between": [{"world": [0.3, -0.4, 2.6]}, "fore.tip"], "line": ROPE}]},
    "bushing": {"forces": [{"name": "mount", "between": ["boom.eye", "fore.tip"], "bushing": BUSHING}]},
    "winch": {
        "forces": [
            {"name": "hoist", "between": ["boom.eye", "fore.tip"], "line": WINCH},
            {"name": "strap", "between": ["fore.tip", "boom.eye"], "line": RELAXING},
            {"name": "mooring", "between": [{"world": [0.2, -0.5, -0.6]}, "boom.eye"], "line": WINCH | TAKEN_LATER},
        ]
    },
    "contact": {
        "forces": [
            {"name": "floor", "between": ["fore.tip", "boom.eye"], "contact": FLOOR},
            {"name": "ball", "between": [{"world": [0.4, -0.6, -0.9]}, "fore.tip"], "contact": BALL},
            {"name": "water", "between": ["fore.tip", "boom.eye"], "drag": DRAG},
        ]
    },
}
PUSHES: dict[str, dict] = {
    "push": {"pushes": [{"name": "shove", "at": "boom.eye"}]},
    "marker push": {"pushes": [{"name": "tool", "at": "fore.tip", "axes": "marker"}]},
}


def arm_of(row: Row) -> dict:
    """The robot of a row, but for what closes a loop, which depends on a posture: see `conformance.judge`."""
    robot = {"name": "arm", "gravity": [0.7, -1.1, -9.6], "links": [_boom(row), _fore(row)]}
    boom = robot["links"][0]
    if row["base"] in ("floating", "moving"):
        hull = {"name": "hull", "length": 0.3, "section": {"rhoA": 5.0, "rhoIp": 0.05}, "joint": {"axes": []}}
        boom["parent"] = "hull"
        robot["links"].insert(0, hull | {"bodies": [HULL_BODY]})
    if row["base"] == "accelerated":
        robot["base_acceleration"] = True
    elif row["base"] != "fixed":
        robot["base"] = "moving" if row["base"] == "moving" else "floating"
    if row["base"] == "afloat":
        boom["joint"] = {"axes": []}
        boom["bodies"] = [*boom.get("bodies", []), HULL_BODY]
    if row["turn"] == "ball" and row["order"] != "second order":
        robot["links"].insert(-2, _mast(boom.pop("parent", "world"), robot["links"][-1]["joint"]))
        boom["parent"] = "mast"
    if row["more"] == "flat":
        robot["section_rotation"] = False
    if row["closing"] == "coupling":
        robot["links"].append(_hand())
        robot["couplings"] = [{"axis": "hand.joint[1]", "of": _leader(row), "ratio": -0.7, "offset": 0.2}]
    if row["closing"] in (*LOOPS, "compliant loop"):
        robot["links"].append(_post(row))
    if row["closing"] == "compliant loop":
        robot["loops"] = [{"between": ["fore.tip", "post.tip"], "joint": copy.deepcopy(COMPLIANT)}]
    return robot | copy.deepcopy(FORCES.get(row["force"], {}) | PUSHES.get(row["push"], {}))


PLACES = ("at", "from", "to", "axes", "length", "frame_at", "mount", "transmission", "couplings", "loops")
"""Keys whose numbers say where things are: others can change without opening a loop or leaving a linkage's reach."""


def varied(robot: dict, rng: np.random.Generator, kept: tuple[str, ...] = PLACES) -> dict:
    """The robot with other numbers, up to a tenth more or less, but for those under the keys that are `kept`."""

    def other(x):
        match x:
            case dict():
                return {key: value if key in kept else other(value) for key, value in x.items()}
            case list():
                return [other(value) for value in x]
            case float():
                return x * rng.uniform(0.9, 1.1)
        return x

    return other(robot)


def _boom(row: Row) -> dict:
    """The first flexible link."""
    boom: dict = {"name": "boom", "length": 0.8, "joint": copy.deepcopy(TURNS[row["turn"]])}
    modes = {"bending_y": 1, "bending_z": 1}
    match row["modes"]:
        case "stretch and twist":
            modes |= {"axial": 1, "torsion": 1}
        case "shear":
            modes |= {"shear_y": 1, "shear_z": 1}
        case "clamped_free":
            modes |= {"basis": "clamped_free", "bending_y": 2}
        case "frequencies":
            modes["frequencies"] = {"bending_y": [3.1], "bending_z": [2.3]}
    section = BOOM | (SHEAR if row["modes"] == "shear" else {})
    if row["modes"] == "frequencies":
        section = {key: section[key] for key in ("rhoA", "rhoIp")}
    match row["section"]:
        case "stations":
            ends = ((0.0, 1.15, 1.3), (0.6, 1.0, 0.9), (1.0, 0.7, 0.75))
            boom["section"] = [
                {"at": s, **{k: v * (mass if k.startswith("rho") else stiff) for k, v in section.items()}}
                for s, mass, stiff in ends
            ]
        case "profile":
            boom["profile"] = {"rod": {"diameter": 0.03}, "E": 1.1e9, "density": 1700.0, "nu": 0.35}
        case _:
            boom["section"] = section
    boom["modes"] = modes
    boom["order"] = {"first order": 1, "second order": 2, "exact rod": "exact"}[row["order"]]
    if row["pieces"] == "segments":
        boom["segments"] = 2
    if row["damping"] != "undamped":
        fast = row["modes"] == "shear"  # which no explicit step of the checks would bear with much of it
        boom["damping"] = {"ratio": 0.04} if row["damping"] == "ratio" else {"time": 1e-5 if fast else 0.006}
    if row["tendon"] != "none":
        offsets = [[0.0, 0.03, -0.02], [0.0, 0.015, 0.01]]
        boom["tendons"] = [{"name": "flexor", "from": 0.1, "to": 0.85, "at": offsets}]
    if row["tendon"] == "tendon":
        boom["tendons"].insert(0, {"name": "extensor", "at": [[0.0, -0.02, 0.03]] * 2, "actuated": False})
    if row["more"] == "frame":
        boom["frame_at"] = 0.3
    if row["more"] == "bodies":
        boom["bodies"] = [{"at": "base", "mass": 0.7, "com": [0.02, 0.05, -0.03]}, copy.deepcopy(PAYLOAD)]
    if row["axis"] in ("limited", "limited rate") and row["base"] != "afloat" and row["turn"] != "ball":
        boom["joint"]["limits"] = [{"effort": ENOUGH} for _ in boom["joint"]["axes"]]
    if (
        row["axis"] == "given motion"
        and row["base"] != "afloat"
        and row["turn"] != "ball"
        and row["closing"] not in LOOPS
    ):
        boom["joint"]["actuation"] = ["motion", *["torque"] * (len(boom["joint"]["axes"]) - 1)]
    if row["axis"] == "brakes" and row["base"] != "afloat" and row["turn"] != "ball":
        boom["joint"]["brake"] = [{"inertia": 0.4, "time": 0.06} for _ in boom["joint"]["axes"]]
    if row["more"] == "markers":
        boom["markers"] = [{"name": "lug", "at": 0.45}]
    if "boom.eye" in str([FORCES.get(row["force"]), PUSHES.get(row["push"])]):
        boom["markers"] = [*boom.get("markers", []), {"name": "eye", "at": 0.6}]
    return boom


def _fore(row: Row) -> dict:
    """The link that the boom carries."""
    fore: dict = {"name": "fore", "parent": "boom", "bodies": [copy.deepcopy(PAYLOAD)]}
    if row["fore"] == "elements":
        fore["cloud"] = fr.random_cloud(np.random.default_rng(5), 2, second=True)
    else:
        fore |= {"length": 0.5, "section": copy.deepcopy(FORE)}
    if row["fore"] == "rod":
        fore["modes"] = {"bending_y": 1, "bending_z": 1}
    if row["fore"] == "curved fore":
        fore |= {"modes": {"bending_y": 2, "bending_z": 1}, "order": "exact", "rest": copy.deepcopy(REST)}
    if row["at"] == "station":
        fore["at"] = {"s": 0.4}
    if row["tendon"] == "shared tendon":
        fore["tendons"] = [{"name": "flexor", "to": 0.6, "at": [[0.0, -0.02, 0.01], [0.0, 0.02, 0.01]]}]
    joint: dict = {"axes": ["y"], "mount": {"xyz": [0.02, 0.03, -0.05], "rpy": [0.3, 0.1, -0.2]}}
    drive = copy.deepcopy(DRIVES.get(row["drive"], {}))
    if row["friction"] in FRICTIONS:
        drive["friction"] = copy.deepcopy(FRICTIONS[row["friction"]])
    if drive:
        joint["drives"] = [drive]
    match row["axis"]:
        case "spring":
            joint["elements"] = [{"spring": {"stiffness": 25.0, "rest": 0.3}}]
        case "stops":
            joint["limits"] = [{"lower": -0.1, "upper": 0.15, "stiffness": 90.0, "damping": 3.0}]
        case "limited" | "limited rate":
            joint["limits"] = [{"effort": EFFORT} | (RATE if row["axis"] == "limited rate" else {})]
        case "given motion":
            joint["actuation"] = "motion"
        case "brakes":
            joint["brake"] = {"inertia": 4e-3 if "stiffness" in drive else 0.3, "time": 0.05}
        case "passive":
            joint |= {"damping": [0.3], "stiffness": [12.0]}
            joint |= {} if "rotor_inertia" in drive else {"armature": [0.06]}
    return fore | {"joint": joint}


def _mast(carrier: str, fore: dict) -> dict:
    """What carries a ball joint: a link with an axis, and on it what the fore's has, since places in q and v differ
    behind a quaternion by another number than before it."""
    own = {
        key: fore[key] for key in ("drives", "elements", "limits", "damping", "stiffness", "armature") if key in fore
    }
    joint = {"axes": ["y"], "mount": {"xyz": [0.05, 0.02, 0.1]}} | varied(copy.deepcopy(own), np.random.default_rng(7))
    body = {"at": "tip", "mass": 3.0, "inertia": [0.9, 1.1, 1.0, 0.0, 0.0, 0.0]}
    section = {"rhoA": 2.2, "rhoIp": 0.02}
    return {"name": "mast", "parent": carrier, "length": 0.25, "section": section, "joint": joint, "bodies": [body]}


def _hand() -> dict:
    """What the fore carries, an axis of which follows another."""
    joint = {"axes": ["x", "z"], "mount": {"xyz": [0.01, 0.02, 0.0]}}
    return {"name": "hand", "parent": "fore", "length": 0.2, "section": {"rhoA": 1.5, "rhoIp": 6e-3}, "joint": joint}


def _leader(row: Row) -> str:
    """The axis that the hand's follows: the boom's where it has one, else the hand's own first."""
    if row["base"] == "afloat" or row["turn"] == "ball":
        return "hand.joint[0]"
    return f"boom.{'slide' if row['turn'] == 'slide' else 'joint'}[0]"


def _post(row: Row) -> dict:
    """What a loop joins to the tip of the fore: a link of three axes beside the boom."""
    joint = {"axes": ["z", "y", "x"], "mount": {"xyz": [0.1, 0.3, 0.1]}}
    carrier = {"floating": {"parent": "hull"}, "moving": {"parent": "hull"}, "afloat": {"parent": "boom", "at": "base"}}
    post = {"name": "post", "length": 0.4, "section": {"rhoA": 1.4, "rhoIp": 8e-3}, "joint": joint}
    return post | carrier.get(row["base"], {"parent": "world"})
