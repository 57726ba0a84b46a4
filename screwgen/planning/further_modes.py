"""The same arm with more modes per plane: what a law is held against that was sought on fewer."""

from __future__ import annotations

from ..robot_model import RobotModel
from ..spec.robot import Link

PLANES = ("bending_y", "bending_z")
FURTHER, MOST = 2, 32


def with_further_modes(model: RobotModel) -> RobotModel | None:
    """A model with the next two bending modes in each plane that has some; None where there is no such plane.

    Planes whose frequencies are measured keep theirs: there is nothing to know of further ones.
    """
    links = tuple(map(_extended, model.robot.links))
    if links == tuple(model.robot.links):
        return None
    further = lambda: type(model)(model.robot.model_copy(update={"links": links}))  # noqa: E731
    return model.once("with further modes", further)


def _extended(link: Link) -> Link:
    modes = link.modes
    counts = {x: getattr(modes, x) for x in PLANES if x not in modes.measured}
    update = {x: min(count + FURTHER, MOST) for x, count in counts.items() if count}
    return link.model_copy(update={"modes": modes.model_copy(update=update | {"points": None})}) if update else link
