"""Random URDFs: trees of all joint types that Pinocchio reads as we do, with turned inertials and fixed joints."""

import numpy as np

KINDS = ("revolute", "continuous", "prismatic", "fixed")


def row(values) -> str:
    return " ".join(repr(float(x)) for x in np.ravel(values))


def inertial(rng, scale: float = 1.0) -> str:
    """A body whose tensor is that of eight random points, in axes that are turned."""
    points = rng.normal(scale=0.1, size=(8, 3))
    spread = points.T @ points * scale / 8
    J = np.trace(spread) * np.eye(3) - spread
    entries = {"ixx": J[0, 0], "ixy": J[0, 1], "ixz": J[0, 2], "iyy": J[1, 1], "iyz": J[1, 2], "izz": J[2, 2]}
    tensor = " ".join(f'{key}="{row(x)}"' for key, x in entries.items())
    where = f'<origin xyz="{row(rng.normal(scale=0.2, size=3))}" rpy="{row(rng.uniform(-3, 3, 3))}"/>'
    return f'<inertial>{where}<mass value="{scale!r}"/><inertia {tensor}/></inertial>'


def joint(rng, i: int, parent: int, kind: str) -> str:
    origin = f'<origin xyz="{row(rng.normal(scale=0.4, size=3))}" rpy="{row(rng.uniform(-3, 3, 3))}"/>'
    ends = f'<parent link="part {parent}"/><child link="part {i}"/>'
    axis = f'<axis xyz="{row(rng.normal(size=3))}"/>'
    limit = '<limit lower="-1.5" upper="2" effort="10" velocity="3"/>' if kind in ("revolute", "prismatic") else ""
    dynamics = f'<dynamics damping="{rng.uniform()!r}" friction="{rng.uniform()!r}"/>' if rng.uniform() < 0.5 else ""
    return f'<joint name="j{i}" type="{kind}">{origin}{ends}{axis if kind != "fixed" else ""}{limit}{dynamics}</joint>'


def random_urdf(seed: int, links: int = 9) -> str:
    """A tree of links; the first joint moves, every link has a body."""
    rng = np.random.default_rng([16, seed])
    parts = [f'<link name="part {i}">{inertial(rng, rng.uniform(0.2, 3.0))}</link>' for i in range(links)]
    for i in range(1, links):
        kind = "revolute" if i == 1 else KINDS[rng.integers(len(KINDS))]
        parts.append(joint(rng, i, int(rng.integers(max(0, i - 3), i)), kind))
    return f'<?xml version="1.0"?>\n<robot name="random {seed}">\n' + "\n".join(parts) + "\n</robot>\n"
