"""The rows of one joint and its link among those of the judge's arm: (58) of the second link, measured."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .modal_rows import joint_bias
from .moving_link import MovingLink


def add_joint_values(values: dict[str, np.ndarray], links: Sequence[MovingLink]) -> None:
    """Add ``H_p`` to the values of both links, and to those of the second the matrices of (58).

    ``values`` holds the measured system of the arm, index "all", columns [W_0; Vdot_1; W_1; Vdot_2]; those of (58) are
    [W_1; Vdot_1; W_2; Vdot_2], with W_2 what a third link would exert on the second.
    """
    for link, bias in zip(links, joint_bias(*links), strict=True):
        link.values["H_p"] = bias
    own, I6 = slice(12, 24), np.eye(6)
    W_1, Vdot_1, Vdot_2 = (values["M_s:all"][own, k : k + 6] for k in (12, 6, 18))
    links[1].values |= {
        "M_c": np.hstack([W_1, Vdot_1, np.vstack([0 * I6, -I6]), Vdot_2]),
        "D_c": values["D_s:all"][own],
        "H_c": values["h_s:all"][own],
        "W_c": values["W_s:all"][own],
    }
