"""Small robots, each with one feature, all named "robot": the least code in which what the feature adds stands."""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path

from four_bar_robots import LINKAGE
from helpers import arm, link, model_of, unfolded

from screwgen import Model, write_sid
from screwgen.spec import Link

SOFT = {"EIy": 30.0, "EIz": 50.0}
FULL = SOFT | {"EA": 5e3, "GJ": 20.0}
BENT = {"modes": {"bending_z": 1}, "section": SOFT}
EXACT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": SOFT, "order": "exact"}
TIP = {"at": "tip", "mass": 0.5, "com": [0.05, 0.0, 0.02], "inertia": [0.01, 0.02, 0.02, 0.0, 0.0, 0.0]}
FRICTION = {"coulomb": 0.3, "viscous": 0.02, "velocity": 0.2}
FALLING = {"stribeck": {"static": 0.5, "velocity": 0.6}, "bend": {"friction": 0.2, "velocity": 0.4}}
BRISTLES = {"coulomb": 0.5, "viscous": 0.1, "memory": {"stiffness": 500.0, "damping": 1.0}}
ELASTIC = {"ratio": 30.0, "rotor_inertia": 2e-4, "stiffness": 900.0, "damping": 2.0, "friction": FRICTION}
STOP = {"lower": -0.4, "upper": 0.3, "stiffness": 2000.0, "damping": 8.0}
CYLINDER = {"transmission": {"crank": 0.4, "base": 1.2, "angle": -1.5}, "ratio": 30.0, "rotor_inertia": 0.02}
FOUR_BAR = {"transmission": {"four_bar": LINKAGE}, "ratio": 50.0, "rotor_inertia": 1e-3}
OFFSETS = [[0.0, 0.02, 0.01], [0.0, 0.01, 0.0]]
SPRING = {"elements": {"spring": {"stiffness": 30.0, "rest": -0.65}}}
ROPE = {
    "name": "rope",
    "between": [{"world": [0.0, 0.0, 3.0]}, "a.tip"],
    "line": {"stiffness": 1e5, "rest": 2.0, "damping": 9.0, "slack": True, "implicit": True},
}
STATIONS = [{"at": s, "rhoA": 2.0 - s, **SOFT} for s in (0.0, 1.0)]


def joined(*axes: str, soft: dict | None = None, **drive: object) -> dict:
    """A parallelogram of three links, of which the last is joined to the world."""
    post = {"name": "post", "parent": "world", "bodies": [{"at": "base", "mass": 0.0}]}
    post["joint"] = {"axes": [], "mount": {"xyz": [1.0, 0.0, 0.0]}}
    joint = {"drives": [drive]} if drive else {}
    links = link("a", 1.0, "y", joint=joint), link("b", 1.0, "y", 1.0), link("c", 1.0, "y", bodies=[TIP])
    return arm(*links, post, loops=[{"between": ["c.tip", "post.base"], "joint": {"axes": list(axes)} | (soft or {})}])


def body_of_finite_elements() -> dict:
    """A rod from a file of standard input data."""
    rod = Link.model_validate(link("rod", 0.5, [], modes={"bending_y": 1, "bending_z": 1}, section=SOFT))
    path = Path(tempfile.mkdtemp()) / "rod.SID_FEM"
    write_sid(rod, path)
    return arm({"name": "rod", "joint": {"axes": ["y"]}, "body": {"sid": str(path)}, "bodies": [TIP]})


def _one(**more: object) -> dict:
    """A link on an axis about y."""
    return arm(link("a", axes="y", **more))


HULL = {"name": "hull", "joint": {"axes": []}, "bodies": [TIP | {"at": "base"}]}
FEATURES = {
    "rigid": lambda: _one(),
    "welded": lambda: arm(link("a", axes=[], **BENT)),
    "slide": lambda: arm(link("a", axes=[{"slide": "y"}])),
    "screw": lambda: arm(link("a", axes=[{"screw": "z", "pitch": 0.05}])),
    "modes": lambda: _one(modes={"axial": 1, "bending_y": 1, "bending_z": 1, "torsion": 1}, section=FULL),
    "order two": lambda: _one(**BENT, order=2),
    "exact": lambda: _one(**EXACT),
    "exact station": lambda: arm(
        link("a", axes="y", **EXACT, markers=[{"name": "m", "at": 0.4}]), link("b", 0.3, "y", parent="a", at="m")
    ),
    "station": lambda: arm(link("a", axes="y", **BENT), link("b", 0.3, "y", parent="a", at={"s": 0.4}, bodies=[TIP])),
    "segments": lambda: _one(**BENT, segments=2),
    "varying": lambda: arm(link("a", axes="y", modes={"bending_z": 1}) | {"section": STATIONS}),
    "shear": lambda: _one(modes={"bending_y": 1, "shear_y": 1}, section=SOFT | {"GAy": 9e2, "rhoIz": 5e-3}),
    "tendons": lambda: _one(**BENT | {"modes": {"bending_y": 1}}, tendons=[{"name": "t", "at": OFFSETS}]),
    "coupling": lambda: arm(
        link("a", axes="y"), link("b", axes="y"),
        couplings=[{"axis": "b.joint[0]", "of": "a.joint[0]", "ratio": -0.5, "offset": 0.1}],
    ),
    "ball": lambda: arm(link("a", axes="y"), link("b", joint={"axes": "ball"}, bodies=[TIP])),
    "floating": lambda: arm(HULL, link("a", axes="y", **BENT), base="floating"),
    "loop": lambda: joined("y"),
    "stiff rows": lambda: joined("y", soft={"stiffness": 1e6, "damping": 30.0}) | {"forces": [ROPE]},
    "elastic gear": lambda: _one(joint={"drives": [ELASTIC]}),
    "friction": lambda: _one(joint={"drives": [{"friction": FRICTION | FALLING}]}),
    "bristles": lambda: _one(joint={"drives": [{"friction": BRISTLES}]}),
    "stop": lambda: _one(joint={"limits": [STOP]}),
    "cylinder": lambda: _one(joint={"drives": [CYLINDER]}),
    "elastic cylinder": lambda: _one(joint={"drives": [CYLINDER | {"stiffness": 4e4}]}),
    "four-bar": lambda: _one(joint={"drives": [FOUR_BAR]}),
    "spring": lambda: _one(joint=SPRING),
    "springs and dampers": lambda: _one(joint={"stiffness": [3.0], "damping": [0.2], "armature": [0.1]}),
    "finite elements": body_of_finite_elements,
    "marker": lambda: _one(**BENT, markers=[{"name": "m", "at": 0.5}]),
    "damping ratio": lambda: _one(**BENT, damping={"ratio": 0.01}),
    "damping time": lambda: _one(**BENT, damping={"time": 0.01}),
    "still sections": lambda: arm(link("a", axes="y", **BENT), link("b", axes="y"), section_rotation=False),
}  # fmt: skip
"""The robots, by the feature that each has."""


@cache
def robot_with(feature: str) -> dict:
    return FEATURES[feature]() | {"name": "robot"}


@cache
def model_with(feature: str) -> Model:
    return model_of(robot_with(feature))


WITHOUT_CONTROL = ("welded", "modes", "shear", "tendons", "coupling", "ball", "floating", "loop", "elastic gear")
WITHOUT_CONTROL += ("cylinder", "elastic cylinder", "four-bar", "stiff rows")
"""Robots of which no predictive controller is made: no joints, no cost-to-go, or refused."""
CONTROL = """
[horizon]
intervals = 3
step = 0.02
[goal]
joints = 0.1
[cost]
tip_position = 100.0
tip_orientation = 1.0
tip_velocity = 1.0
joints = 10.0
joint_rates = 1.0
modes = 1.0
mode_rates = 1.0
torques = 1e-4
terminal = { riccati = true }
[bounds]
torques = 60.0
joints = { lower = -2.0, upper = 2.0 }
joint_rates = 3.0
torque_rates = 3000.0
"""


def write(folder, feature: str, binding: str, layout: str, control: str | None) -> None:
    """The C of a robot in a folder, with all options, and with a predictive controller if its file is given."""
    mpc = None if control is None else folder / "control.toml"
    if mpc is not None:
        mpc.write_text(control)
    unfolded(folder, model_with(feature).c_files(binding, layout, mpc, batch=True, estimator=True, outputs=True))
