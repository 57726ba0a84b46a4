"""What drives give of their inputs, beside the product: limits of efforts and of their rates, by the robot file."""

from __future__ import annotations

import numpy as np


class DriveLimits:
    """``tables``: what the file states of each torque; ``places``: the torques whose rate is limited.

    ``z``: the efforts that follow what acts there, internal states.
    """

    def __init__(self, robot: dict):
        self.tables = []
        for link in robot["links"]:
            joint = link["joint"]
            count = 3 if joint["axes"] == "ball" else len(joint["axes"])
            self.tables += joint.get("limits", [{}] * count)
        self.places = [k for k, table in enumerate(self.tables) if "effort_rate" in table]
        self.z = np.zeros(len(self.places))

    def held(self, tau: np.ndarray, z: np.ndarray | None = None) -> np.ndarray:
        """What a step holds of inputs, of others than these states where they are given."""
        most = np.array([table.get("effort", np.inf) for table in self.tables])
        most = np.append(most, np.full(len(tau) - len(most), np.inf))
        out = np.clip(tau, -most, most)
        for k, x in zip(self.places, self.z if z is None else z, strict=True):
            band = self.tables[k]["effort_rate"] * self.tables[k]["effort_time"]
            out[k] = np.clip(out[k], x - band, x + band)
        return out

    def rates(self, tau: np.ndarray) -> np.ndarray:
        """The rates of the states while the inputs act as they are."""
        return np.array(
            [(tau[k] - z) / self.tables[k]["effort_time"] for k, z in zip(self.places, self.z, strict=True)]
        )
