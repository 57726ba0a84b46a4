"""One link in a motion of one's choice: the judge of single effects, such as a weight or a steady flight."""

from __future__ import annotations

import numpy as np

from ..arguments import Numbers
from .jets import Jet, constant
from .moving_link import Z3, MovingLink
from .quantities import MODES

LENGTH, INSIDE, RHO_A = 1.0, 0.25, 2.0
EA, EI_Y, EI_Z = 80.0, 30.0, 60.0
TO_MASS_CENTRE = LENGTH / 2 - INSIDE
UNTURNED, STILL, STRAIGHT = constant(np.eye(3)), constant(Z3), constant(np.zeros((MODES, 1)))


class SingleLink:
    """A link of 1 m and 2 kg whose frame sits 0.25 m from its base; its external wrenches alone move it.

    ``R`` (3 x 3) and ``origin`` (m, inertial components) move the frame, ``eta`` (6 x 1, m√m) the modes; ``gravity``
    is of free fall, m/s².  It is evaluated as a motion, under the link index "i".
    """

    def __init__(self, R: Jet = UNTURNED, origin: Jet = STILL, eta: Jet = STRAIGHT, gravity: Numbers = (0.0, 0.0, 0.0)):
        link = _Line(np.random.default_rng(0), np.reshape(gravity, (3, 1)))
        link.joint, link.eta = np.zeros((2, 3)), eta
        r_b, r_xi = link.displaced(link.a)
        link.move(R, origin + R @ (r_b + r_xi))
        link.load(np.random.default_rng(0), isolated=True)
        self.values = {f"{name}:i": value for name, value in link.values.items()}
        self.values["g:i"] = link.gravity
        self.weights = {"i": link.weights}


class _Line(MovingLink):
    """The link of round numbers."""

    def _size(self, random: np.random.Generator) -> None:
        self._line(LENGTH, INSIDE, RHO_A, EA, EI_Y, EI_Z)


def shaped(*eta: float) -> Jet:
    """A deformation at rest: coordinates of the shapes in x, y, z of the first mode, then of the second."""
    return constant(np.reshape([*eta, *[0.0] * (MODES - len(eta))], (MODES, 1)))
