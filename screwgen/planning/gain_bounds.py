"""What a law of the joints has to do and may not exceed, checked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arguments import array
from ..errors import UsageError

ABOUT = {
    "decay": "the decay wanted, 1/s; gains are then as small as it allows",
    "damping": "the least damping ratio wanted",
    "kp": "the largest gains, N·m/rad (slides: N/m); 0 for a joint that no drive moves",
    "kd": "the largest gains, N·m·s/rad (slides: N·s/m)",
    "ki": "the largest gains, N·m/(rad·s) (slides: N/(m·s))",
    "jump": "a jump of all references, rad (slides: m), that efforts have to bear",
    "efforts": "the largest efforts after the jump, N·m (slides: N); without it those of the robot file",
    "noise_q": "standard deviations of measured coordinates, rad (slides: m)",
    "noise_v": "standard deviations of measured rates, rad/s (slides: m/s)",
    "noise_efforts": "the largest standard deviations of efforts that this noise may cause, N·m (slides: N)",
}
"""What each bound is; all but `SCALARS` have an entry for each joint."""
SCALARS, SIZES = ("decay", "damping"), ("kp", "kd", "ki", "jump", "noise_q", "noise_v")
UNSTATED = ("jump", "noise_q", "noise_v")


@dataclass(frozen=True, eq=False)
class GainBounds:
    """The bounds of a search for gains; arrays (n_joints,), infinite or zero where nothing is stated."""

    decay: float
    damping: float
    kp: np.ndarray
    kd: np.ndarray
    ki: np.ndarray
    jump: np.ndarray
    efforts: np.ndarray
    noise_q: np.ndarray
    noise_v: np.ndarray
    noise_efforts: np.ndarray

    @classmethod
    def of(cls, given: Mapping[str, Any], limits: np.ndarray) -> GainBounds:
        """Of what a caller states; `limits` (n_joints,): the efforts of the robot's drives. Raises UsageError."""
        for name in given:
            if name not in ABOUT:
                raise UsageError(f"bounds: there is no '{name}'; choose of {', '.join(ABOUT)}")
        found = {key: _checked(key, value, len(limits)) for key, value in given.items()}
        if "noise_efforts" in given and not ("noise_q" in given or "noise_v" in given):
            raise UsageError("bounds: noise_efforts is stated without noise; state noise_q, noise_v, or both")
        if "efforts" in given and "jump" not in given:
            raise UsageError("bounds: efforts is stated without jump, after which they act; state jump")
        unbounded: dict[str, Any] = dict.fromkeys(ABOUT, np.full(len(limits), np.inf)) | {"efforts": limits}
        unbounded |= dict.fromkeys(UNSTATED, np.zeros(len(limits))) | dict.fromkeys(SCALARS, 0.0)
        return cls(**(unbounded | found))

    @property
    def noise(self) -> np.ndarray:
        """(2, n_joints): standard deviations of coordinates and of rates."""
        return np.array([self.noise_q, self.noise_v])

    def largest(self, holding: np.ndarray, levers: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The largest `kp` and `kd` that leave efforts within bounds, as far as one gain alone says.

        `holding` (loops, n_joints): the efforts that hold the arm; `levers`: torques by a unit of effort. A half of the
        noise's variance is for each gain.
        """
        spare, lever = (self.efforts - holding).min(axis=0), levers.min(axis=0)
        if (short := np.flatnonzero((spare <= 0) & (self.jump > 0))).size:
            j = int(short[0])
            said = f"entry {j} is {self.efforts[j]:.4g}, and holding the arm takes {holding[:, j].max():.4g}"
            raise UsageError(f"bounds: efforts: {said}; allow more, or leave out the posture")
        with np.errstate(divide="ignore", invalid="ignore"):
            by_jump = np.where(self.jump > 0, ((self.efforts - holding) * levers).min(axis=0) / self.jump, np.inf)
            by_noise = np.where(self.noise > 0, lever * self.noise_efforts / np.sqrt(2) / self.noise, np.inf)
        return np.minimum(np.minimum(self.kp, by_jump), by_noise[0]), np.minimum(self.kd, by_noise[1])


def _checked(key: str, value: Any, m: int) -> Any:
    found = array(value, f"bounds: {key}:", () if key in SCALARS else (m,))
    if not ((found >= 0) if key in SIZES else (found > 0)).all():
        raise UsageError(f"bounds: {key}: must be {'>= 0' if key in SIZES else '> 0'}: {ABOUT[key]}")
    if key in ("kp", "kd") and not found.any():
        raise UsageError(f"bounds: {key}: all are 0; state {ABOUT[key]}")
    if key == "damping" and found >= 1:
        raise UsageError(f"bounds: damping is {found:g}; it must be less than 1")
    return found if found.ndim else found.item()
