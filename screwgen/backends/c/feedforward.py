"""The C of a feedforward: that of the robot whose axes all move as given, and the efforts of its motion."""

from __future__ import annotations

from .project import CProject

FILES = {"efforts.h": "feedforward.h", "efforts.c": "feedforward.c"}
"""The files that it has beside those of every robot, without the robot's name, with their templates."""


class FeedforwardProject(CProject):
    """The files of a robot all of whose axes have their motion given, and of their efforts."""

    @property
    def library(self) -> dict[str, str]:
        """The files of the library, with the templates that they are made from."""
        return super().library | {f"{self.name}_{file}": template for file, template in FILES.items()}
