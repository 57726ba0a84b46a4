"""Random robots and states for tests, as plain dicts in the robot file's format; no package code.

Every draw takes a `numpy.random.Generator`. Magnitudes are such that M is mostly regular.
"""

from __future__ import annotations

import numpy as np
from oracle import Oracle
from random_linkages import replace_cylinders
from random_sections import add_shear, chance, log_uniform, random_modes, random_section, soften, varied
from robot_toml import to_toml as to_toml

LETTERS = ("x", "y", "z")
LIMITS = {
    "max_links": 5,
    "max_modes": 2,  # per direction; one link in ten gets up to two more
    "max_axes": 3,
    "rigid": 0.15,  # chances
    "welded": 0.12,
    "torsion": 0.35,
    "rhoIp": 0.85,
    "material": 0.3,
    "frame_at": 0.25,
    "mount": 0.5,
    "branching": 0.0,  # of a link: any earlier link, or the world, carries it
    "sliding": 0.0,  # of an axis: a slide or a screw
    "bodies": 0.5,  # of each of: a base body, a tip body
    "armature": 0.4,
    "drives": 0.0,  # of a joint: gears with rotors, some of them elastic or with friction
    "stops": 0.0,  # of an axis: limits, most of them with stops
    "cylinders": 0.0,  # of a drive of an axis that turns: a cylinder in place of a gear
    "linkages": 0.0,  # of a cylinder: a four-bar linkage in its place, drawn from a stream of its own
    "soft": 0.7,  # of a robot: stiffness so low that inertia forces are not drowned by elastic ones
    "no_section_rotation": 0.15,
    "no_gravity": 0.15,
    "second_order": 0.0,  # of a link, or of a robot
    "exact": 0.0,  # of a link: order "exact", drawn from a stream of its own
    "curved": 0.0,  # of an exact link whose frame is at its base: curvature at rest, from a stream of its own
    "time": 0.0,  # of a flexible link: Kelvin–Voigt damping, drawn from a stream of its own
    "stations": 0.0,  # of a link: a section that varies
    "shear": 0.0,  # of each of: modes of shear in a plane, rotary inertia about an axis
    "basis": None,  # 'clamped_free' or 'polynomial'; None: drawn per link
}


def numbers(array) -> list[float]:
    return [float(x) for x in np.ravel(array)]


# -------- robots


def random_robot(rng, n_links: int | None = None, **limits) -> dict:
    """A robot with any of the file's features; `limits` override `LIMITS`."""
    limits = {**LIMITS, **_known(limits)}
    count = int(rng.integers(1, limits["max_links"] + 1)) if n_links is None else n_links
    robot = {"name": f"robot{int(rng.integers(10**6))}", "gravity": _gravity(rng, limits)}
    if chance(rng, limits["no_section_rotation"]):
        robot["section_rotation"] = False
    elif chance(rng, 0.2):
        robot["section_rotation"] = True
    soft = chance(rng, limits["soft"])
    robot["links"] = [random_link(rng, i, limits, soft) for i in range(count)]
    for i in range(1, count if limits["branching"] else 1):
        if chance(rng, limits["branching"]):
            robot["links"][i]["parent"] = str(rng.choice(["world", *(x["name"] for x in robot["links"][:i])]))
    if limits["second_order"]:
        for part in (robot, *robot["links"]):
            if chance(rng, limits["second_order"]):
                part["order"] = int(rng.integers(1, 3))
    if limits["exact"]:
        own = np.random.default_rng(int(robot["name"][5:]))
        robot.pop("section_rotation", None)
        for link in robot["links"]:
            if chance(own, limits["exact"]) and any(n for d, n in link.get("modes", {}).items() if d != "basis"):
                link["order"] = "exact"
    if limits["curved"]:
        own = np.random.default_rng([int(robot["name"][5:]), 2])
        for link in robot["links"]:
            if link.get("order") == "exact" and "frame_at" not in link and chance(own, limits["curved"]):
                link["rest"] = curvature(own, link["length"])
    if limits["time"]:
        own = np.random.default_rng([int(robot["name"][5:]), 1])
        for link in robot["links"]:
            if link.get("modes") and chance(own, limits["time"]):
                link["damping"] = {**link.get("damping", {}), "time": float(own.uniform(0.0, 0.01))}
    return robot if any(link["joint"]["axes"] for link in robot["links"]) else _unweld(rng, robot, limits)


def curvature(rng, length: float) -> dict | list[dict]:
    """What a link is bent by at rest, up to a radian in each direction, the same all along or by three stations."""
    names = rng.permutation(["bending_y", "bending_z", "torsion"])[: rng.integers(1, 4)]
    drawn = lambda: {str(name): float(rng.uniform(-1, 1) / length) for name in names}  # noqa: E731
    return drawn() if rng.random() < 0.5 else [{"at": s, **drawn()} for s in (0.0, float(rng.uniform(0.2, 0.8)), 1.0)]


def _known(limits: dict) -> dict:
    if unknown := set(limits) - set(LIMITS):
        raise TypeError(f"unknown limits {sorted(unknown)}; known: {sorted(LIMITS)}")
    return limits


def _unweld(rng, robot: dict, limits: dict) -> dict:
    robot["links"][0]["joint"] = random_joint(rng, {**limits, "welded": 0.0})
    return robot


def _gravity(rng, limits) -> list[float]:
    if chance(rng, limits["no_gravity"]):
        return [0.0, 0.0, 0.0]
    return [0.0, 0.0, -9.81] if chance(rng, 0.4) else numbers(rng.uniform(-10, 10, 3))


def random_link(rng, index: int, limits: dict, soft: bool) -> dict:
    length, modes = float(rng.uniform(0.3, 1.2)), random_modes(rng, limits)
    link = {"name": f"link_{index}", "length": length, "section": random_section(rng, modes, limits)}
    add_shear(rng, link["section"], modes, limits)
    if soft:
        soften(link["section"])
    if limits["stations"] and chance(rng, limits["stations"]):
        link["section"] = varied(rng, link["section"])
    if modes or chance(rng, 0.2):
        link["modes"] = modes
    if modes and chance(rng, 0.5):
        link["damping"] = {"ratio": float(rng.uniform(0.0, 0.05))}
    link["joint"] = random_joint(rng, limits)
    if chance(rng, limits["frame_at"]):
        link["frame_at"] = float(rng.choice([0.5, 1.0, rng.uniform(0.0, 1.0)])) * length
    if bodies := random_bodies(rng, limits):
        link["bodies"] = bodies
    return link


def random_joint(rng, limits: dict) -> dict:
    count = 0 if chance(rng, limits["welded"]) else int(rng.integers(1, limits["max_axes"] + 1))
    joint: dict = {"axes": mixed(rng, random_axes(rng, count), limits["sliding"])}
    if chance(rng, limits["mount"]):
        parts = {"xyz": numbers(rng.uniform(-0.2, 0.2, 3)), "rpy": numbers(rng.uniform(-np.pi, np.pi, 3))}
        keys = [["xyz"], ["rpy"], ["xyz", "rpy"]][int(rng.integers(3))]
        joint["mount"] = {key: parts[key] for key in keys}
    for key, probability, high in (
        ("armature", limits["armature"], 0.2),
        ("damping", 0.4, 1.0),
        ("stiffness", 0.3, 50.0),
    ):
        if count and chance(rng, probability):
            joint[key] = numbers(rng.uniform(0, high, count))
    if count and limits["drives"] and chance(rng, limits["drives"]):
        joint["drives"] = [random_drive(rng) for _ in range(count)]
        if any("rotor_inertia" in drive for drive in joint["drives"]):
            joint.pop("armature", None)
    if limits["cylinders"]:
        with_cylinders(rng, joint, limits["cylinders"])
    if limits["linkages"]:
        replace_cylinders(joint, limits["linkages"])
    if count and limits["stops"]:
        joint["limits"] = [random_limits(rng) if chance(rng, limits["stops"]) else {} for _ in range(count)]
    return joint


def with_cylinders(rng, joint: dict, probability: float) -> None:
    """Some axes that turn get a cylinder on a rigid gear, whose rotor is about as heavy as an armature."""
    drives = joint.get("drives", [{}] * len(joint["axes"]))
    for k, axis in enumerate(joint["axes"]):
        if not isinstance(axis, dict) and chance(rng, probability):
            drive = {name: value for name, value in drives[k].items() if name not in ("stiffness", "damping")}
            base = float(rng.uniform(0.3, 1.5))
            lever = {"base": base, "crank": base * float(rng.choice([rng.uniform(0.2, 0.8), rng.uniform(1.2, 2.0)]))}
            drive["transmission"] = lever | {"angle": float(rng.uniform(-np.pi, np.pi))}
            drives = [*drives[:k], drive, *drives[k + 1 :]]
    if any("transmission" in drive for drive in drives):
        joint["drives"] = drives


def random_limits(rng) -> dict:
    """One limit or both, so near that many random states are beyond one; with stops, but for one in eight."""
    lower, upper = numbers(np.sort(rng.uniform(-2, 2, 2)))
    ends = {"lower": lower, "upper": upper}
    table = [ends, {"lower": upper}, {"upper": lower}][int(rng.integers(3))]
    if chance(rng, 7 / 8):
        table |= {"stiffness": log_uniform(rng, 10.0, 1000.0)}
        table |= {"damping": float(rng.uniform(0.0, 20.0))} if chance(rng, 0.7) else {}
    return table


def random_drive(rng) -> dict:
    """None, a rigid gear or an elastic one; the rotor at the joint is about as heavy as an armature."""
    if chance(rng, 0.25):
        return {}
    ratio = log_uniform(rng, 1.0, 100.0)
    drive = {"ratio": ratio, "rotor_inertia": log_uniform(rng, 0.01, 0.3) / ratio**2}
    if chance(rng, 0.2):
        drive = {"rotor_inertia": log_uniform(rng, 0.01, 0.3)}
    if chance(rng, 0.7):
        drive["stiffness"] = log_uniform(rng, 30.0, 3000.0)
        if chance(rng, 0.6):
            drive["damping"] = float(rng.uniform(0.1, 2.0))
    if chance(rng, 0.5):
        dry = {"coulomb": float(rng.uniform(0.0, 1.0)), "velocity": float(rng.uniform(0.05, 1.0))}
        wet = {"viscous": float(rng.uniform(0.0, 0.1))}
        drive["friction"] = [dry, wet, dry | wet][int(rng.integers(3))]
    return drive


def ratios(robot: dict) -> dict[int, float]:
    """The ratio of every elastic drive, by its axis among all axes of the robot; of transmissions that of a stretch."""
    drives = [d for link in robot["links"] for d in link["joint"].get("drives", [{}] * len(link["joint"]["axes"]))]
    ratio = lambda drive: 0.02 if "transmission" in drive else drive.get("ratio", 1.0)  # noqa: E731
    return {axis: ratio(drive) for axis, drive in enumerate(drives) if "stiffness" in drive}


def mixed(rng, axes: list, sliding: float) -> list:
    """The axes, some of which became slides and screws; two in a row may be one cylindrical joint."""
    if not sliding:
        return axes
    pitch = float(rng.uniform(0.01, 0.2) * rng.choice([-1, 1]))
    screw = lambda axis: {"slide": axis} if chance(rng, 0.5) else {"screw": axis, "pitch": pitch}  # noqa: E731
    out = [screw(axis) if chance(rng, sliding) else axis for axis in axes]
    return [axes[0], {"slide": axes[0]}] if len(axes) == 2 and chance(rng, sliding / 3) else out


def random_axes(rng, count: int) -> list:
    """Letters or vectors (not normalised); no axis close to parallel to the one before it."""
    axes: list = []
    while len(axes) < count:
        vector = numbers(rng.normal(size=3) * rng.uniform(0.3, 3))
        axis = str(rng.choice(LETTERS)) if chance(rng, 0.5) else vector
        if not axes or abs(_unit(axes[-1]) @ _unit(axis)) < 0.8:
            axes.append(axis)
    return axes


def _unit(axis) -> np.ndarray:
    vector = np.eye(3)[LETTERS.index(axis)] if isinstance(axis, str) else np.array(axis)
    return vector / np.linalg.norm(vector)


def random_bodies(rng, limits: dict) -> list[dict]:
    return [random_body(rng, at) for at in ("base", "tip") if chance(rng, limits["bodies"])]


def random_body(rng, at: str, mass: float | None = None, size: float = 0.08) -> dict:
    """A cloud of six point masses: its inertia is always that of a real body."""
    mass = log_uniform(rng, 0.2, 4.0) if mass is None else mass
    body = {"at": at, "mass": mass}
    if chance(rng, 0.7):
        body["com"] = numbers(rng.uniform(-size, size, 3))
    if chance(rng, 0.7):
        body["inertia"] = cloud_inertia(rng, mass, size)
    return body


def cloud_inertia(rng, mass: float, size: float) -> list[float]:
    """[xx, yy, zz, xy, xz, yz] about the centre of mass, products as entries of the tensor."""
    points = rng.uniform(-size, size, (6, 3))
    points -= points.mean(axis=0)
    tensor = mass / 6 * sum((p @ p) * np.eye(3) - np.outer(p, p) for p in points)
    return numbers([tensor[0, 0], tensor[1, 1], tensor[2, 2], tensor[0, 1], tensor[0, 2], tensor[1, 2]])


def heavy_payload_robot(rng, n_links: int = 3, mass: float = 60.0) -> dict:
    """Every link's tip carries some ten times the link's own mass."""
    robot = random_robot(rng, n_links, bodies=0.0)
    for link in robot["links"]:
        link["bodies"] = [random_body(rng, "tip", mass=float(mass * rng.uniform(0.5, 1.5)), size=0.15)]
    return robot


def slender_robot(rng, n_links: int = 3) -> dict:
    """Links of 4 to 8 m, light and soft."""
    robot = random_robot(rng, n_links, material=0.0, frame_at=0.0)
    for link in robot["links"]:
        link["length"] = float(rng.uniform(4.0, 8.0))
        link["section"]["rhoA"] = log_uniform(rng, 0.1, 0.5)
    return robot


# -------- states


def mode_order(robot: dict) -> list[tuple[int, str, int]]:
    """(link, direction, mode number from 1) of every modal coordinate, in the order of q."""
    directions = ("axial", "bending_y", "bending_z", "torsion", "shear_y", "shear_z")
    counts = [link.get("modes", {}) for link in robot["links"]]
    return [(i, d, k + 1) for i, c in enumerate(counts) for d in directions for k in range(c.get(d, 0))]


def joint_count(robot: dict) -> int:
    return sum(len(link["joint"]["axes"]) for link in robot["links"])


def modal_scale(robot: dict) -> np.ndarray:
    """Largest modal coordinates: deflections of about 0.1 l and tip rotations below about 0.5 rad in all."""
    size = {"axial": 1e-3, "bending_y": 0.025, "bending_z": 0.025, "torsion": 0.1, "shear_y": 5e-3, "shear_z": 5e-3}
    order = mode_order(robot)
    reach = [1.0 if d == "torsion" else robot["links"][i]["length"] for i, d, _ in order]
    return np.array([size[d] * r / k**2 for r, (_, d, k) in zip(reach, order, strict=True)])


def random_state(rng, robot: dict, angle: float = np.pi, rate: float = 2.0, modal: float = 1.0) -> dict:
    """q, v, tau, w_ext as lists: joint angles within ±angle, rates within ±rate, modal part times `modal`."""
    joints, scale, n = joint_count(robot), modal * modal_scale(robot), len(robot["links"])
    q, eta = rng.uniform(-angle, angle, joints), scale * rng.uniform(-1, 1, len(scale))
    v, etadot = rng.uniform(-rate, rate, joints), 10 * scale * rng.uniform(-1, 1, len(scale))
    geared = lambda x: [ratio * x[axis] * (1 + 0.02 * rng.uniform(-1, 1)) for axis, ratio in ratios(robot).items()]  # noqa: E731
    return {
        "q": numbers([*q, *geared(q), *eta]),
        "v": numbers([*v, *geared(v), *etadot]),
        "tau": numbers(rng.uniform(-20, 20, joints)),
        "w_ext": [numbers([*rng.uniform(-3, 3, 3), *rng.uniform(-10, 10, 3)]) for _ in range(n)],
    }


def rest_state(robot: dict) -> dict:
    """Everything exactly zero."""
    size = joint_count(robot) + len(ratios(robot)) + len(mode_order(robot))
    zero_wrenches = [[0.0] * 6 for _ in robot["links"]]
    return {"q": [0.0] * size, "v": [0.0] * size, "tau": [0.0] * joint_count(robot), "w_ext": zero_wrenches}


def undeformed_state(rng, robot: dict) -> dict:
    """Random joints; modal coordinates and rates exactly zero."""
    return random_state(rng, robot, modal=0.0)


def tiny_state(rng, robot: dict, size: float = 1e-9) -> dict:
    """Angles, rates and modal coordinates of the order of `size`: series and closed forms meet here."""
    return random_state(rng, robot, angle=size, rate=size, modal=size)


def huge_angle_state(rng, robot: dict, angle: float = 1e3) -> dict:
    """Joint angles of many turns."""
    return random_state(rng, robot, angle=angle)


def draw_regular(rng, n_links=None, limit=1e8, robots=random_robot, states=random_state, **limits):
    """(robot, state, oracle) with cond(M) at the state's q no more than `limit`; redraws until it holds.

    `robots(rng, [n_links], **limits)` and `states(rng, robot)` draw; any of this module's may be given.
    """
    for _ in range(200):
        robot = robots(rng, n_links, **limits) if n_links is not None else robots(rng, **limits)
        state, oracle = states(rng, robot), Oracle(robot)
        if oracle.condition(state["q"]) <= limit:
            return robot, state, oracle
    raise RuntimeError(f"no robot with cond(M) <= {limit:g} in 200 draws")
