"""A URDF with visuals of every kind, small mesh files beside it, and the arm that it makes, one link of which bends."""

import struct
import warnings
from pathlib import Path

import numpy as np

import screwgen

CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
TRIANGLES = np.reshape(
    [0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3],
    (12, 3),
)
PLATE, BLOCK, HOOK, KNOB = (0.12, 0.08, 0.002), (0.05, 0.1, 0.2), (0.04, 0.06, 0.02), (0.1, 0.05, 0.03)
"""Edges of boxes, m: at the tip of the link that bends, on the next link, on the one that is merged, and at its end."""
LENGTH = 0.8

LINK = """<link name="{name}"><inertial><mass value="1"/><inertia ixx=".01" iyy=".01" izz=".01" ixy="0" ixz="0" iyz="0"
/></inertial>{visuals}</link>"""
JOINT = """<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/><origin xyz="{at}"/>
<axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>"""
DAE = """<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>
<created>2000-01-01T00:00:00</created><modified>2000-01-01T00:00:00</modified><unit name="millimeter" meter="0.001"/>
<up_axis>Z_UP</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p">
<float_array id="f" count="24">{points}</float_array><technique_common><accessor source="#f" count="8" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common>
</source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="12">
<input semantic="VERTEX" source="#v" offset="0"/><p>{triangles}</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>"""


def visual(shape: str, color: str = "", at: str = "0 0 0", turn: str = "0 0 0") -> str:
    return f'<visual><origin xyz="{at}" rpy="{turn}"/><geometry>{shape}</geometry>{color}</visual>'


def paint(rgb: str) -> str:
    return f'<material name="m{rgb}"><color rgba="{rgb} 1"/></material>'


def dressed(folder: Path, segments: int = 1) -> tuple[Path, screwgen.Model]:
    """The URDF in `folder`, and the model of the robot."""
    (folder / "meshes").mkdir(exist_ok=True)
    plate, block, hook, knob = (CORNERS * edges for edges in (PLATE, BLOCK, HOOK, KNOB))
    (folder / "meshes/plate.stl").write_text(ascii_stl(plate))
    (folder / "meshes/block.stl").write_bytes(binary_stl(block))
    lines = [*("v " + numbers(2 * x) for x in hook), *("f " + numbers(np.add(t, 1)) for t in TRIANGLES)]
    (folder / "meshes/hook.obj").write_text("\n".join(lines) + "\n")
    flat = numbers(np.ravel(TRIANGLES))
    (folder / "meshes/knob.dae").write_text(DAE.format(points=numbers(1000 * knob.ravel()), triangles=flat))
    mesh = lambda name, more="": f'<mesh filename="{name}" {more}/>'  # noqa: E731
    upper = visual(f'<box size=".04 .04 {LENGTH}"/>', '<material name="named"/>', f"0 0 {LENGTH / 2}")
    upper += visual(mesh("meshes/plate.stl"), paint("1 0 0"), f"0 0 {LENGTH + PLATE[2] / 2}")
    fore = visual(mesh("package://arm_description/meshes/block.stl"), paint("0 1 0"), ".1 0 .3", ".3 .2 .1")
    fore += visual(mesh("package://nowhere/none.stl"))
    fore += visual('<cylinder radius=".02" length=".3"/>', "", "0 0 .15")
    end = visual(mesh("meshes/hook.obj", 'scale=".5 .5 .5"'), paint("0 0 1"), "0 .1 0")
    end += visual(mesh("meshes/knob.dae"), paint("1 1 0"), "0 -.1 0")
    parts = {"stand": visual('<sphere radius=".06"/>', paint("1 0 1")), "upper": upper, "fore": fore, "end": end}
    joints = [
        ("shoulder", "revolute", "stand", "upper", "0 0 .1"),
        ("elbow", "revolute", "upper", "fore", f"0 0 {LENGTH}"),
    ]
    joints.append(("grip", "fixed", "fore", "end", ".05 0 .35"))
    text = '<robot name="dressed"><material name="named"><color rgba="0 1 1 1"/></material>'
    text += "".join(LINK.format(name=name, visuals=own) for name, own in parts.items())
    keys = ("name", "kind", "parent", "child", "at")
    text += "".join(JOINT.format(**dict(zip(keys, joint, strict=True))) for joint in joints) + "</robot>"
    (folder / "arm.urdf").write_text(text)
    (folder / "side.toml").write_text(
        f'[[links]]\nname = "upper"\nsegments = {segments}\nsection = {{ EIy = 20.0, EIz = 20.0, EA = 1e5 }}\n'
        "modes = { bending_y = 2, bending_z = 2 }\n"
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", screwgen.ImportNote)
        return folder / "arm.urdf", screwgen.derive(screwgen.load(folder / "arm.urdf", folder / "side.toml"))


def numbers(values) -> str:
    return " ".join(f"{x:.9g}" for x in values)


def ascii_stl(points: np.ndarray) -> str:
    facet = "facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n"
    rows = (facet.format("".join(f"vertex {numbers(points[k])}\n" for k in t)) for t in TRIANGLES)
    return f"solid plate\n{''.join(rows)}endsolid plate\n"


def binary_stl(points: np.ndarray) -> bytes:
    rows = (struct.pack("<12fH", 0, 0, 0, *points[list(t)].ravel(), 0) for t in TRIANGLES)
    return bytes(80) + struct.pack("<I", len(TRIANGLES)) + b"".join(rows)


def rpy(roll: float, pitch: float, yaw: float) -> np.ndarray:
    from scipy.spatial.transform import Rotation

    return Rotation.from_euler("xyz", [roll, pitch, yaw]).as_matrix()


def corners(model: screwgen.Model, q: np.ndarray) -> dict[str, np.ndarray]:
    """The corners (8, 3) of the boxes by their colours, in the inertial frame.

    The frame of `fore` is that of the URDF; x of the tip of `upper` is z of the URDF, y is y.
    """
    (R, r), (R_tip, r_tip) = model.numpy().link_pose(q), model.numpy().tip_poses(q)
    tip, fore = model.chain.lasts[0], model.chain.firsts[1]
    plate = np.add(CORNERS, [0, 0, 0.5]) * PLATE @ np.array([[0, 0, -1.0], [0, 1, 0], [1, 0, 0]])
    held = {
        "#00ff00": [0.1, 0, 0.3] + CORNERS * BLOCK @ rpy(0.3, 0.2, 0.1).T,
        "#0000ff": np.array([0.05, 0.1, 0.35]) + CORNERS * HOOK,
        "#ffff00": np.array([0.05, -0.1, 0.35]) + CORNERS * KNOB,
    }
    return {"#ff0000": r_tip[tip] + plate @ R_tip[tip].T} | {c: r[fore] + x @ R[fore].T for c, x in held.items()}


def posture(model: screwgen.Model, size: float = 0.05) -> np.ndarray:
    q = np.zeros(model.nq)
    q[: model.chain.eta_q] = [0.4, 0.7]
    q[model.chain.eta_q :] = (
        size / model.robot.links[0].pieces ** 2 * np.random.default_rng(3).uniform(-1, 1, model.nq - model.chain.eta_q)
    )
    return q


def run_of(model: screwgen.Model, t: np.ndarray, q: np.ndarray) -> screwgen.Run:
    """A run of which coordinates alone matter."""
    sizes = {"v": model.nv, "tau": model.n_tau, "wrench": (model.n_links, 6), "tip_position": 3, "energy": 2}
    arrays = {key: np.zeros((len(t), *np.atleast_1d(size))) for key, size in sizes.items()}
    names = {f"{kind}_names": tuple(getattr(model, f"{kind}_names")) for kind in ("q", "v", "tau", "wrench")}
    more = dict(robot=model.robot, parameters=np.array(model.parameter_values))
    return screwgen.Run(model.robot.name, t, q, **arrays, **names, **more)


def still(model: screwgen.Model, q: np.ndarray) -> screwgen.Run:
    """A run that stays where it is for a second."""
    return run_of(model, np.array([0.0, 1.0]), np.array([q, q]))
