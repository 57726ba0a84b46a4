"""The parameters of the robot file as inputs of the links' programs."""

from __future__ import annotations

from ..spec.axis_laws import element_label
from ..spec.drive import FRICTION_TABLES
from ..spec.parameters import Parameter, parameters
from ..spec.robot import Robot
from ..spec.tendons import offset_label


def label(parameter: Parameter) -> str:
    """The label under which the blocks know a parameter of a link."""
    index = parameter.index
    match parameter.field:
        case "damping.ratio" | "damping.time" | "rest.bending_y" | "rest.bending_z" | "rest.torsion":
            return parameter.field.replace(".", "_")
        case "joint.mount.xyz" | "joint.mount.rpy":
            return f"mount_{parameter.field[-3:]}_{_component(parameter)}"
        case "joint.armature":
            return f"armature_{index[0] + 1}"
        case "frequencies.axial" | "frequencies.bending_y" | "frequencies.bending_z" | "frequencies.torsion":
            return f"{parameter.field.replace('.', '_')}_{index[0] + 1}"
        case "joint.damping" | "joint.stiffness":
            return f"{parameter.field.replace('.', '_')}_{index[0] + 1}"
        case field if field.startswith("joint.elements."):
            kind, key = field.split(".")[2:]
            return element_label(kind, key, index[0])
        case field if field.startswith("joint.drives.friction.") and field.split(".")[3] in FRICTION_TABLES:
            return f"drive_{'_'.join(field.split('.')[3:])}_{index[0] + 1}"
        case field if field.startswith("joint."):
            table, *_, key = field.split(".")[1:]
            return f"{table.removesuffix('s')}_{key}_{index[0] + 1}"
        case "tendons.at":
            return offset_label(index[0], index[1], "xyz"[index[2]])
        case "bodies.mass":
            return f"body{index[0]}_mass"
        case "bodies.com":
            return f"body{index[0]}_com_{'xyz'[index[1]]}"
        case "bodies.inertia":
            return f"body{index[0]}_inertia_{index[1] + 1}"
        case field if field.startswith(("section.", "rest_at.")):
            return f"{field.replace('.', '_')}_{index[0] + 1}"
    return parameter.field


def _component(parameter: Parameter) -> str:
    return "xyz"[parameter.index[0]]


def labels(robot: Robot) -> list[dict[str, int]]:
    """For every link, the index of each of its parameters in the parameter vector, by label."""
    out: list[dict[str, int]] = [{} for _ in robot.links]
    for place, parameter in enumerate(parameters(robot)):
        if parameter.link is not None:
            out[parameter.link][label(parameter)] = place
    return out
