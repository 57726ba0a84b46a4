"""What is not known beside ball joints."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .values import refuse

if TYPE_CHECKING:
    from .robot import Robot


def refuse_beside_balls(robot: Robot) -> None:
    """Refuses what closes the tree of a robot with ball joints, which is not known in one robot yet."""
    ball = next((link for link in robot.links if link.joint.kind.curved), None)
    if ball is None:
        return
    joint = f"a {ball.joint.kind.name} joint, that of link '{ball.name}'"
    beside = f"is stated of a robot with {joint}, beside which it is not known yet"
    axes = '["y", "z"], or ["x", "y", "z"] where something resists its spin'
    beside += f"; leave it out, or give '{ball.name}' axes in place of \"ball\": {axes}"
    for name, stated in (("loops", robot.rigid_loops), ("couplings", robot.couplings)):
        if stated:
            raise refuse(beside, at=(name,))
