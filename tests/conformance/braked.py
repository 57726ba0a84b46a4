"""Brakes, apart from the product: flywheels on their axes that come to rest."""

from __future__ import annotations

from typing import NamedTuple


class Brake(NamedTuple):
    """One of an axis, by its number; it acts on the rate at a ``place``, of an elastic drive the rotor's."""

    axis: int
    place: int
    inertia: float
    time: float

    def effort(self, closed: float, acceleration: float, rate: float) -> float:
        """What it exerts: a flywheel that grows without bound as it closes, and stops over its time."""
        flywheel = self.inertia * (1.0 / (1.0 - closed) ** 2 - 1.0)
        return -flywheel * (acceleration + closed * rate / self.time)


def brakes_of(robot: dict, rotor: int) -> list[Brake]:
    """Those of a robot, of which the first ``rotor`` rates are those of base and joints."""
    out, axis, base = [], 0, 6 * ("base" in robot)
    for link in robot["links"]:
        joint = link["joint"]
        count = 3 if joint["axes"] == "ball" else len(joint["axes"])
        said = joint.get("brake", [])
        for k in range(count):
            elastic = "stiffness" in (joint.get("drives") or [{}] * count)[k]
            if said:
                own = said if isinstance(said, dict) else said[k]
                out.append(Brake(axis + k, rotor if elastic else base + axis + k, own["inertia"], own["time"]))
            rotor += elastic
        axis += count
    return out
