"""The C of a feedforward: that of the robot whose axes all move as given, and the efforts of its motion."""

from __future__ import annotations

from functools import cached_property

from ..templates import FEATURES
from .code import literal
from .fields import fused_place
from .project import CProject

FILES = {"efforts.h": "feedforward.h", "efforts.c": "feedforward.c"}
"""The files that it has beside those of every robot, without the robot's name, with their templates."""


class FeedforwardProject(CProject):
    """The files of a robot all of whose axes have their motion given, and of their efforts."""

    @property
    def library(self) -> dict[str, str]:
        """The files of the library, with the templates that they are made from."""
        return super().library | {f"{self.name}_{file}": template for file, template in FILES.items()}

    @cached_property
    def labels(self) -> list[tuple[str, ...]]:
        """The constants that the code of every link reads, ratios of elastic gears among them."""
        own = [{*labels} for labels in super().labels]
        for i, label in self._stated_ratios.values():
            own[i].add(label)
        return [tuple(sorted(labels)) for labels in own]

    @cached_property
    def context(self) -> dict:
        """The templates' context, with the ratio of every drive as C has it; of none where all are rigid."""
        found = {joint: self._ratio(i, label) for joint, (i, label) in self._stated_ratios.items()}
        ratios = [found.get(joint, "1") for joint in range(self.chain.n_joints)]
        mine, twisting = super().context, bool(self.chain.n_added)
        return mine | {"ratios": ratios * twisting, FEATURES: mine[FEATURES] + ("elastic_efforts",) * twisting}

    @property
    def _stated_ratios(self) -> dict[int, tuple[int, str]]:
        """By joints behind elastic gears: the link, and the label of the parameter."""
        chain = self.chain
        axes = [(i, f"drive_ratio_{axis + 1}") for i, key in enumerate(chain.keys) for axis in key.added_axes]
        pairs = zip(chain.added_joints, axes, strict=True)
        return {joint: (i, label) for joint, (i, label) in pairs if label in chain.parameter_labels[i]}

    def _ratio(self, i: int, label: str) -> str:
        if self.baked is None:
            return fused_place(f"{i}:c.{label}", 0)
        return literal(float(self.chain.parameters.values[self.chain.parameter_labels[i][label]]))
