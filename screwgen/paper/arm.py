"""The arm of the paper's Section 7, ELLA, as a robot: two flexible links, a universal joint at the base, an elbow."""

from __future__ import annotations

from typing import NamedTuple

from scipy.spatial.transform import Rotation

from ..spec.joint import Joint, Mount
from ..spec.robot import Body, Link, Modes, Robot
from ..spec.section import Section


class SectionNumbers(NamedTuple):
    """The numbers of a section, as the robot file names them."""

    rhoA: float
    EA: float
    EIy: float
    EIz: float
    rhoIp: float


NAMES = ("upper_arm", "forearm")
LENGTHS = (0.95, 0.93)
"""m."""
MASSES = (3.3, 2.1)
"""kg: the motor of the elbow at the tip of link 1, the payload at the tip of link 2."""
AXES = ("yz", "z")
SET_POINTS = (-0.4928, 0.6922, 0.4270)
"""rad: theta_y1, theta_z1, theta_z2 at the end of the paper's motion."""
ROD = SectionNumbers(rhoA=1.6302, EA=4.38e7, EIy=2.12e3, EIz=3.67e3, rhoIp=2.15e-4)
SECTION = Section(**ROD._asdict())
FREE_FALL = (0.0, 0.0, -9.81)
STILL = (0.0, 0.0, 0.0)
STUB = Link(name="stub", length=1e-3, section=Section(rhoA=1e-9), joint=Joint(axes=()))


def ella(
    bending: int = 1,
    basis: str = "clamped_free",
    *,
    axial: int = 1,
    locked: bool = False,
    section_rotation: bool = True,
    gravity: tuple[float, float, float] = FREE_FALL,
    bodies_beyond: bool = False,
) -> Robot:
    """The arm with `axial` modes per link and `bending` modes per link and plane.

    `locked`: its joints welded in the posture of the set points, without coordinates.  `gravity`: of free fall, m/s².
    `bodies_beyond`: each point mass on the far side of the joint at its place, the payload on a massless stub, so that
    it reaches the modes of the link before through the joint's wrench alone, as all that the paper's link carries.
    """
    modes = Modes(basis=basis, axial=axial, bending_y=bending, bending_z=bending)
    joints = _welds() if locked else [Joint(axes=tuple(axes)) for axes in AXES]
    at_base, at_tip = ((None, *MASSES), (None, None)) if bodies_beyond else ((None,) * 3, MASSES)
    links = [
        Link(
            name=name,
            length=length,
            section=SECTION,
            modes=modes,
            joint=joint,
            bodies=[Body(at=at, mass=mass) for at, mass in (("base", base), ("tip", tip)) if mass],
        )
        for name, length, joint, base, tip in zip(NAMES, LENGTHS, joints, at_base[:2], at_tip, strict=True)
    ]
    if bodies_beyond:
        links.append(STUB.model_copy(update={"bodies": (Body(at="base", mass=at_base[2]),)}))
    return Robot(name="ella", gravity=gravity, section_rotation=section_rotation, links=links)


def turn(axes: str, angles: list[float]) -> Rotation:
    """One rotation about axes in order; of a list with one angle older SciPy makes a stack of one rotation."""
    return Rotation.from_euler(axes.upper(), angles if len(angles) > 1 else angles[0])


def _welds() -> list[Joint]:
    """The joints as mounts turned by the set points."""
    angles, joints = list(SET_POINTS), []
    for axes in AXES:
        yaw, pitch, roll = turn(axes, [angles.pop(0) for _ in axes]).as_euler("ZYX")
        joints.append(Joint(axes=(), mount=Mount(rpy=(roll, pitch, yaw))))
    return joints
