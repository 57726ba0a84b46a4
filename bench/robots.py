"""The robots that the benchmark runs."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import screwgen

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
GRAVITY = (0.0, 0.0, -9.81)
TUBE = {"rhoA": 1.6302, "EA": 4.38e7, "EIy": 2.12e3, "EIz": 3.67e3}
"""ELLA's section without spin inertia: kg/m, N, N·m²."""

PENDULUM = {"lengths": (0.95, 0.93), "rhoA": 1.6302, "EA": 4.38e7, "EI": 2.12e3}


def example(name: str) -> screwgen.Robot:
    """A robot as it was from the start, so that figures compare: the paper's ``ella``, ``six_link`` with one
    bending mode per plane, or ``three_link``: ELLA with a third link like its forearm that turns the other way."""
    if name == "six_link":
        return _few_modes(screwgen.load(EXAMPLES / "six_link.toml"))
    ella = screwgen.load(EXAMPLES / "ella_paper.toml")
    if name == "ella":
        return ella
    hand = ella.links[1].model_copy(update={"name": "hand", "joint": screwgen.Joint(axes=["y"])})
    return screwgen.Robot(name=name, gravity=ella.gravity, links=[*ella.links, hand])


def _few_modes(six_link: screwgen.Robot) -> screwgen.Robot:
    modes = {
        "upper_arm": screwgen.Modes(basis="clamped_free", bending_y=1, bending_z=1, torsion=1),
        "forearm": screwgen.Modes(basis="polynomial", bending_y=1, bending_z=1),
    }
    links = [link.model_copy(update={"modes": modes.get(link.name, link.modes)}) for link in six_link.links]
    return six_link.model_copy(update={"links": tuple(links)})


def build(name: str, links: Sequence[dict]) -> screwgen.Robot:
    return screwgen.Robot.model_validate({"name": name, "gravity": list(GRAVITY), "links": list(links)})


def flexible(name: str, count: int, axial: int, bending: int) -> screwgen.Robot:
    """Equal flexible links, a universal joint at the base and revolute joints; no bodies, no spin inertia."""
    modes = {"basis": "clamped_free", "axial": axial, "bending_y": bending, "bending_z": bending}
    base = {"length": 0.9, "section": TUBE, "modes": modes}
    joints = [["y", "z"]] + (count - 1) * [["z"]]
    return build(name, [base | {"name": f"link{i}", "joint": {"axes": a}} for i, a in enumerate(joints)])


def rigid(name: str, count: int) -> screwgen.Robot:
    """Equal rigid links on revolute joints about z and y by turns."""
    base = {"length": 0.3, "section": {"rhoA": 4.0, "rhoIp": 2e-3}}
    return build(name, [base | {"name": f"link{i}", "joint": {"axes": ["zy"[i % 2]]}} for i in range(count)])


def rigid_joints(robot: screwgen.Robot) -> list[list[float]]:
    """A rigid chain as others take it, a row per joint: number of the axis, offset along the parent's x (m), mass (kg),
    x of the centre of mass (m), moments of inertia about it (kg·m²)."""
    rows, offset = [], 0.0
    for link in robot.links:
        l, m, spin = link.length, link.section.rhoA * link.length, link.section.rhoIp * link.length
        axis = link.joint.axes[0].index(1.0)
        rows.append([float(axis), offset, m, l / 2, spin, m * l**2 / 12, m * l**2 / 12])
        offset = l
    return rows


def equal_chain(name: str, count: int) -> screwgen.Robot:
    """Equal links of one class, two bending modes each, on revolute joints."""
    modes = {"basis": "clamped_free", "bending_y": 1, "bending_z": 1}
    base = {"length": 0.3, "section": {**TUBE, "rhoIp": 2.15e-4}, "modes": modes}
    return build(name, [base | {"name": f"link{i}", "joint": {"axes": ["y"]}} for i in range(count)])


def many_modes(name: str, bending: int) -> screwgen.Robot:
    """Two links with so many bending modes per plane."""
    modes = {"basis": "clamped_free", "bending_y": bending, "bending_z": bending}
    base = {"length": 0.9, "section": TUBE, "modes": modes}
    return build(name, [base | {"name": f"link{i}", "joint": {"axes": [a]}} for i, a in enumerate("yz")])


def pendulum(modes: int, basis: str = "polynomial") -> screwgen.Robot:
    """Two flexible links that swing in the plane x, z; so many bending modes each, ``EA`` unused."""
    x = PENDULUM
    base = {"section": {"rhoA": x["rhoA"], "EIy": x["EI"]}, "modes": {"basis": basis, "bending_z": modes}}
    base["joint"] = {"axes": ["y"]}
    links = [base | {"name": name, "length": l} for name, l in zip(("upper", "lower"), x["lengths"], strict=True)]
    return build(f"pendulum{modes}", links)
