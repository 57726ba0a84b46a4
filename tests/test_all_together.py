"""One robot with a tree, slides, a screw, segments, sections that vary, shear, both orders, and a body from a file."""

import re
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from divided import state
from helpers import casadi_forward, model_of, relative
from oracle import Oracle

from screwgen import simulate, write_sid
from screwgen.plotting import plot
from screwgen.spec import Link

BASE = {"rhoA": 2.0, "EA": 4e5, "EIy": 120.0, "EIz": 160.0, "GJ": 90.0, "rhoIp": 4e-4, "GAy": 9e4, "rhoIz": 5e-3}
TIP = {"rhoA": 1.0, "EA": 2e5, "EIy": 40.0, "EIz": 60.0, "GJ": 30.0, "rhoIp": 1e-4, "GAy": 4e4, "rhoIz": 2e-3}
UNIFORM = {"rhoA": 1.5, "EIy": 80.0, "EIz": 60.0, "rhoIp": 3e-4}
BODY = {"at": "tip", "mass": 0.7, "com": [0.05, 0.02, -0.03], "inertia": [2e-3, 3e-3, 4e-3, 0.0, 0.0, 0.0]}
TORSO = {
    "name": "torso", "length": 0.5, "section": {"rhoA": 8.0, "rhoIp": 0.05},
    "joint": {"axes": [{"slide": "z"}, "z"], "armature": [3.0, 0.2]},
}  # fmt: skip
SHEARED = {"axial": 1, "bending_y": 1, "torsion": 1, "shear_y": 1}
SCREW = {"axes": [{"screw": "x", "pitch": 0.02}], "armature": [0.02]}


def boom(segments: int, joint: dict, **more) -> dict:
    """The tapered boom, of order 2 and with shear, or one of its parts."""
    table = {"name": "boom", "length": 0.9, "modes": SHEARED, "order": 2, "joint": joint, "segments": segments}
    return table | {"section": [{"at": 0.0, **BASE}, {"at": 1.0, **TIP}]} | more


def jib(segments: int, joint: dict, **more) -> dict:
    """The uniform jib, of order 1, or one of its parts."""
    table = {"name": "jib", "length": 0.6, "section": UNIFORM, "modes": {"bending_y": 1, "bending_z": 1}}
    return table | {"joint": joint, "segments": segments, "damping": {"ratio": 0.02}} | more


BOOM = {"axes": ["y"], "mount": {"xyz": [0.0, 0.2, 0.0]}, "armature": [0.1]}
JIB = {"axes": ["z", "y"], "mount": {"xyz": [0.1, -0.2, 0.0], "rpy": [0.2, 0.0, -0.5]}, "armature": [0.1, 0.1]}
TOOL = {"name": "tool", "length": 0.2, "section": {"rhoA": 1.0, "rhoIp": 1e-3}, "parent": "boom", "joint": SCREW}


def robot(*links: dict) -> dict:
    return {"name": "machine", "gravity": [0.5, 0.0, -9.81], "links": list(links)}


def split() -> dict:
    """With segments."""
    links = boom(2, BOOM, parent="torso", bodies=[BODY]), jib(2, JIB, parent="torso")
    return robot(TORSO, *links, TOOL)


def by_hand() -> dict:
    """With a link of the file for each segment; what links of trees do in it is the oracle's to say."""
    middle = {key: (BASE[key] + TIP[key]) / 2 for key in BASE}
    weld = {"axes": []}
    halves = [[{"at": 0.0, **BASE}, {"at": 1.0, **middle}], [{"at": 0.0, **middle}, {"at": 1.0, **TIP}]]
    first = boom(1, BOOM, name="boom_a", length=0.45, section=halves[0], parent="torso")
    second = boom(1, weld, length=0.45, section=halves[1], parent="boom_a", bodies=[BODY])
    parts = jib(1, JIB, name="jib_a", length=0.3, parent="torso"), jib(1, weld, name="jib", length=0.3, parent="jib_a")
    return robot(TORSO, first, second, *parts, TOOL)


@cache
def with_body():
    """The same, whose tool is a rod from a file of standard input data, and bears a probe."""
    rod = Link.model_validate(jib(1, {"axes": []}, name="rod", length=0.3))
    with TemporaryDirectory() as folder:
        path = Path(folder) / "tool.SID_FEM"
        write_sid(rod, path)
        tool = {"name": "tool", "parent": "boom", "joint": SCREW, "body": {"sid": str(path)}}
        probe = {"name": "probe", "joint": {"axes": ["y"]}, "bodies": [BODY]}
        return model_of(robot(*split()["links"][:3], tool, probe))


def test_segments_of_a_tree_against_the_oracle():
    model, oracle = model_of(split()), Oracle(by_hand())
    given = state(model, 3, angle=1.0)
    expected = oracle.forward_dynamics(*given)
    numeric = model.numpy()
    for found in (
        numeric.forward_dynamics(*given),
        numeric.dae_forward_dynamics(*given),
        casadi_forward(model, *given),
    ):
        assert max(relative(a, b) for a, b in zip(found, expected, strict=True)) < 1e-10
    assert np.allclose(numeric.energy(*given[:2]), oracle.energy(*given[:2]), rtol=1e-11)


def test_the_header_says_what_carries_each_link(tmp_path):
    with_body().write(tmp_path / "machine", targets=("c",), layout="modular", derivatives=True)
    header = (tmp_path / "machine" / "c" / "machine.h").read_text()
    carriers = ("TORSO", "the base"), ("BOOM", "torso"), ("JIB", "torso"), ("TOOL", "boom"), ("PROBE", "tool")
    for k, (link, carrier) in enumerate(carriers):
        assert re.search(rf"MACHINE_LINK_{link} = {k},? /\* on {carrier} \*/", header)


@pytest.mark.long
def test_it_runs_and_is_drawn(tmp_path):
    model = with_body()
    run = simulate(model, duration=0.02, step=1e-4)
    shown = {panel.title: len(panel.lines) for panel in plot.panels(run, model=model)}
    assert shown["Deflection of tips in y"] == 3
    plot.save(run, tmp_path / "machine.png", model)
    assert np.isfinite(run.q).all() and (tmp_path / "machine.png").stat().st_size > 20_000
