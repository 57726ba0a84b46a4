"""What a kind of input is: the contract of all entries of `tau`.

An example: a winch that moves the base of a robot. It has three accelerations as inputs. A class says their names and
units, and what they add to the acceleration of free fall. From that every back end has them, with derivatives, and
documents, figures and the viewer show them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

from .values import objects, quoted, refuse

if TYPE_CHECKING:
    from .robot import Robot


class InputLine(NamedTuple):
    """A line of a document's table of inputs."""

    symbol: str
    """Their letter in formulas, LaTeX."""
    about: str
    """What they act on."""
    entries: int = 1
    """How many entries share the line."""


class Input:
    """A kind of input: entries of `tau` that act on a robot in one way.

    A robot has it where :meth:`names` has any. Torques of axes come first in `tau`, tensions of tendons follow, then
    kinds that a `Robot` of Python holds in `inputs`. Studies that find torques alone leave all others at zero.

    The entries reach the equations through a signal of links (``signal``, :meth:`of_links`), or with
    :attr:`free_fall`. Their power is linear in rates and entries; derivatives by entries follow from it.
    """

    words: ClassVar[str] = ""
    """What they are, as in "robot 'arm' has tendons"."""
    kinds: ClassVar[tuple[str, ...]] = ()
    """The words behind the owner in the names of the product's own, as `torque` in `arm.torque[0]`."""
    apart: ClassVar[bool] = False
    """Whether these words tell the entries of one owner apart, as `acceleration_x`, so that names of what belongs to an
    entry keep them, as `base.acceleration_x.power`; elsewhere owner and number do, as in `arm.power[0]`."""
    own: ClassVar[str] = ""
    """What the names of what belongs to them begin with, where something else of the axis is called so, as `brake_`."""
    signal: ClassVar[str] = ""
    """The signal of links that holds their own entries, one of ``algorithms.signals.CALL``."""
    quantity: ClassVar[str] = "tau"
    """The key of `ranges.RANGES` with the sizes and signs that files may state."""
    chosen: ClassVar[bool] = False
    """Whether a controller chooses them; else they are given, as the command of a brake: predictive control knows them
    ahead and chooses the others."""
    title: ClassVar[str] = ""
    """What the panel of a run that shows them is headed with, in place of `words`; kinds made in Python share one."""
    letter: ClassVar[str] = "u"
    """Their letter in figures."""
    said: ClassVar[str] = ""
    """What documents say of how they act, LaTeX in sentences; that of free fall they derive themselves."""
    free_fall: Callable[[Sequence], Sequence] | None = None
    """``(entries) -> (x, y, z)``: what they add to the acceleration of free fall, m/s², inertial axes; linear."""

    def names(self, robot: Robot) -> Sequence[str]:
        """The names of the entries in a robot, none where it has no such input."""
        raise NotImplementedError

    def units(self, robot: Robot) -> Sequence[str]:
        """The unit of each."""
        raise NotImplementedError

    def efforts(self, robot: Robot) -> Sequence[tuple[str, str]]:
        """Name and unit of what each entry exerts; of a force that is the entry itself."""
        return list(zip(self.names(robot), self.units(robot), strict=True))

    def lines(self, chain: Any, first: int) -> Sequence[InputLine]:
        """Their lines in a document's table; ``first`` is the number of the first entry in `tau`, from one."""
        return [InputLine(f"u_{{{k}}}", self.words) for k, _ in enumerate(self.names(chain.robot), first)]

    def of_links(self, chain: Any) -> list[list[int]]:
        """For every link the numbers of the entries that it reads, among those of this kind."""
        return [[]] * chain.n


def made_in_python(value: Any) -> tuple[Input, ...]:
    """The check of `inputs`: objects of subclasses of :class:`Input`, of which equal ones are refused."""
    own = objects(value, Input, "an object of a subclass of screwgen.Input")
    for k, one in enumerate(own):
        if one in own[:k]:
            raise refuse(f"is {quoted(one.words)} again; leave one of them out", (k,))
    return own
