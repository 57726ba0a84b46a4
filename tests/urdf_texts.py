"""URDFs in a few words: bodies of 2 kg, joints, and an arm of two."""

TENSOR = '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>'
BODY = f'<inertial><origin xyz="0.1 0 0"/><mass value="2"/>{TENSOR}</inertial>'
RANGE = '<limit lower="-1" upper="1" effort="5" velocity="2"/>'


def joint(name, parent, child, kind="revolute", inside="", xyz="0 0 0.5", axis="0 1 0") -> str:
    ends = f'<parent link="{parent}"/><child link="{child}"/><origin xyz="{xyz}"/><axis xyz="{axis}"/>'
    limit = RANGE if kind in ("revolute", "prismatic") else ""
    return f'<joint name="{name}" type="{kind}">{ends}{limit}{inside}</joint>'


def robot(*parts: str, links="base upper fore", name="bot") -> str:
    bodies = "".join(f'<link name="{link}">{BODY}</link>' for link in links.split())
    return f'<robot name="{name}">{bodies}{"".join(parts)}</robot>'


ARM = robot(joint("shoulder", "base", "upper"), joint("elbow", "upper", "fore", xyz="0 0.3 0.4"))
