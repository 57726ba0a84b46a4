"""The contract of a law of what a step holds: what every step makes of the input of an axis at its beginning.

An example: a motor gives 50 N·m at most. A controller asks for 80 N·m at the beginning of a step, and the step holds
50 N·m. Such a law is an element of an axis that states :meth:`HeldLaw.held` in place of a force. All laws of a robot
are one traced program, which every step of every integrator runs first, as recorders do and the derivatives of steps,
whose slopes the tracer derives (:mod:`..algorithms.held`).
"""

from __future__ import annotations

from typing import Any, ClassVar, NamedTuple

from .axis_element import AxisElement
from .law import Value


class MemoryRate(NamedTuple):
    """How the internal state z of a held law changes: ``zdot = gain - decay z``, with a decay that is not negative.

    Implicit steps of length h take ``(z + h gain)/(1 + h decay)``, which is stable for any of them.
    """

    gain: Value
    decay: Value


class HeldLaw(AxisElement):
    """A law of what a step holds, to be inherited as :class:`.axis_element.AxisElement` is, with keys in its manner.

    ``FORMULA``: what is held of the input ``\\tau``, in LaTeX; ``SAID``: what a person reads where it acts, behind
    "an input was held ".

    A law with a ``state`` remembers, as a limit of the rate of an input does: what is held depends on its internal
    state z, which changes as :meth:`rate` says, in LaTeX ``RATE``.
    """

    SAID: ClassVar[str]

    @staticmethod
    def held(t: Any, tau: Value, x: Value, w: Value, *values: Value) -> Value:
        """What is held of the input ``tau``, N·m or N where the drive acts, with the ``values`` of the keys.

        Of a law with a state z this is the first of the ``values``.

        ``x``: the coordinate of the joint, of an elastic gear that of its rotor; ``w``: the rate whose product with
        the input is the power of the drive. Both are those at the beginning of the step.

        An input within the law is returned as it is, to the bit: one that differs counts as limited. Functions
        of ``t`` are those that :mod:`.law` names; a divisor that may vanish, as a rate, must be kept away from 0.
        """
        raise NotImplementedError

    @staticmethod
    def rate(t: Any, tau: Value, x: Value, w: Value, z: Value, *values: Value) -> MemoryRate:
        """How the state changes while ``tau`` acts: what a step holds, behind all laws of the axis."""
        raise NotImplementedError

    @classmethod
    def equations(cls) -> str:
        """Its section of text in documents."""
        symbols = ", ".join(f"{one.meaning} ${one.symbol}$" for one in cls.table().values())
        said = f"Of the input of an axis with {cls.WORDS} a step holds"
        if cls.state is None:
            return f"{said}\n\n$$\n\\tau &\\leftarrow {cls.FORMULA}\n$$\n\nwith {symbols}."
        letter = cls.state.symbol
        taken = rf"\tau &\leftarrow {cls.FORMULA}, & \quad \dot{{{letter}}} &= {cls.RATE}"
        symbols = f"the internal state ${letter}$, {cls.state.meaning}, whose rate has the $\\tau$ held, and {symbols}"
        return f"{said}\n\n$$\n{taken}\n$$\n\nwith {symbols}."
