"""The results of an analysis: the numbers, state by state, and their JSON."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass
from typing import Any

from ...simulation.collocated import LeftOut
from .regularity import LinkRegularity, Regularity, Structure
from .spectrum import LinearMotion
from .step_limits import StepLimit


@dataclass(frozen=True)
class StateAnalysis:
    """What was found at one state.

    `system`: M_sys with completed joint rows; `projectors`: with P alone (E17); `blocks`: (Msys_diff), link by link;
    `acceleration`: the largest entry of dv/dt, SI; `turning`: the norm of the joints' rates, rad/s; `motions`: the
    spectrum, slowest first; `limits`: one per integrator. `singular`: why there is no unique solution, "" where there
    is one; then parts are None or empty.
    """

    label: str
    singular: str
    system: Regularity | None
    projectors: Regularity | None
    blocks: tuple[LinkRegularity, ...]
    acceleration: float | None
    turning: float
    motions: tuple[LinearMotion, ...]
    limits: tuple[StepLimit, ...]
    measures: tuple[tuple[float, ...], ...] = ()
    """How far every link is from the limits of the model: `derive.validity.MEASURES`, link by link."""
    left_out: tuple[LeftOut, ...] = ()
    """What the points of links of order "exact" leave out of their tips' places."""
    loops: Regularity | None = None
    """The matrix `J M⁻¹ Jᵀ` of the loops' rows, whose forces are unique where it is regular; None without loops."""

    @property
    def well_posed(self) -> bool:
        return not self.singular


@dataclass(frozen=True)
class Findings:
    """The well-posedness of a robot's equations at a set of states; `to_json()` gives the numbers.

    `step`: the asked step, s; `paper_bound`: (stability) as printed, s, which does not hold (E19), None where no
    link bends; `axes`: the number of joint axes; `closed_loop`: whether a controller's gains are in the spectrum.
    """

    robot: str
    links: tuple[str, ...]
    coordinates: int
    axes: int
    step: float
    closed_loop: bool
    paper_bound: float | None
    structure: Structure
    states: tuple[StateAnalysis, ...]

    @property
    def well_posed(self) -> bool:
        """Whether the accelerations and wrenches are unique in every state."""
        return all(state.well_posed for state in self.states)

    def to_json(self) -> str:
        """The numbers as JSON, SI units; null if infinite or not computed."""
        return json.dumps(_plain(self._document()), allow_nan=False, ensure_ascii=False, indent=1)

    def _document(self) -> dict[str, Any]:
        s = self.structure
        shape = {name: getattr(s, name) for name in ("size", "nonzeros", "fill", "block_bandwidth", "bandwidth")}
        head = {name: getattr(self, name) for name in ("robot", "links", "coordinates", "axes", "step", "closed_loop")}
        states = [{"well_posed": state.well_posed, **asdict(state)} for state in self.states]
        return head | {
            "well_posed": self.well_posed,
            "structure": shape | {"labels": s.labels, "starts": s.starts},
            "paper_bound": self.paper_bound,
            "states": states,
        }


def _plain(value: Any) -> Any:
    """What JSON knows: no tuples, complex numbers or infinities."""
    if isinstance(value, dict):
        return {key: _plain(x) for key, x in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(x) for x in value]
    if isinstance(value, complex):
        return [value.real, value.imag]
    return None if isinstance(value, float) and not math.isfinite(value) else value
