"""Robots on which the oracle is judged, and Pinocchio's model of the rigid ones; no package code."""

import numpy as np
import random_robots as rr
from oracle import parents_of
from oracle_link import read_axis
from oracle_stations import place_of
from scipy.spatial.transform import Rotation

G = 9.81
SEEDS = range(12)


def beam(axes=(), tip=None, gravity=(0.0, 0.0, 0.0), **link) -> dict:
    """One link of length 1 m and rhoA = 1 kg/m, all stiffnesses 1; `link` overrides."""
    section = {"rhoA": 1.0, "EA": 1.0, "EIy": 1.0, "EIz": 1.0, "GJ": 1.0, "rhoIp": 1.0}
    table = {"name": "beam", "length": 1.0, "section": section, "joint": {"axes": list(axes)}, **link}
    if tip:
        table["bodies"] = [{"at": "tip", **tip}]
    return {"name": "test", "gravity": list(gravity), "links": [table]}


def rod(length, rhoA, axes, rhoIp=None, **link) -> dict:
    """A rigid link."""
    section = {"rhoA": rhoA} if rhoIp is None else {"rhoA": rhoA, "rhoIp": rhoIp}
    return {"name": f"rod{rhoA}", "length": length, "section": section, "joint": {"axes": axes}, **link}


def arm(*links, gravity=(0.0, -G, 0.0)) -> dict:
    return {"name": "arm", "gravity": list(gravity), "links": list(links)}


def relative(value, reference) -> float:
    """Largest error over the reference's own largest entry."""
    reference = np.asarray(reference, dtype=float)
    scale = np.max(np.abs(reference), initial=0.0)
    return float(np.max(np.abs(np.asarray(value) - reference), initial=0.0) / (scale or 1.0))


def regular(seed, **limits):
    return rr.draw_regular(np.random.default_rng(seed), **limits)


def modes(basis="polynomial", **counts):
    return {"basis": basis, **counts}


def pinocchio_model(robot):
    """Pinocchio's rigid model, the joint index of each link and the placement of its joint point there."""
    import pinocchio as pin

    model, found = pin.Model(), []
    frames = {-1: (0, pin.SE3.Identity())}
    for i, (link, carrier) in enumerate(zip(robot["links"], parents_of(robot["links"]), strict=True)):
        parent, place = frames[carrier]
        if carrier >= 0:
            along = place_of(robot, i, carrier) * robot["links"][carrier]["length"]
            place = place * pin.SE3(np.eye(3), np.array([along, 0, 0]))
        mount = link["joint"].get("mount", {})
        turn = Rotation.from_euler("xyz", mount.get("rpy", [0, 0, 0])).as_matrix()
        place = place * pin.SE3(turn, np.array(mount.get("xyz", [0.0, 0, 0])))
        if i == 0 and robot.get("base") == "floating":
            parent, place = model.addJoint(parent, pin.JointModelFreeFlyer(), place, "base"), pin.SE3.Identity()
        for k, axis in enumerate(link["joint"]["axes"]):
            joint = pinocchio_joint(pin, *read_axis(axis))
            parent, place = model.addJoint(parent, joint, place, f"{i}_{k}"), pin.SE3.Identity()
        for inertia in pinocchio_inertias(pin, link):
            model.appendBodyToJoint(parent, inertia, place)
        found.append((parent, place))
        frames[i] = parent, place
    return pin, model, found


def pinocchio_joint(pin, direction, turns, travel):
    if not turns:
        return pin.JointModelPrismaticUnaligned(direction)
    if travel:
        return pin.JointModelHelicalUnaligned(direction, travel)
    return pin.JointModelRevoluteUnaligned(direction)


def pinocchio_inertias(pin, link):
    length, section = link["length"], link["section"]
    mass = section["rhoA"] * length
    bar = mass * length**2 / 12
    spin = section.get("rhoIp", 0.0) * length
    yield pin.Inertia(mass, np.array([length / 2, 0, 0]), np.diag([spin, bar, bar]))
    for body in link.get("bodies", []):
        xx, yy, zz, xy, xz, yz = body.get("inertia", [0.0] * 6)
        start = np.array([length if body["at"] == "tip" else 0.0, 0, 0])
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        yield pin.Inertia(body["mass"], start + np.array(body.get("com", [0.0] * 3)), tensor)
