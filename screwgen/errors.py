"""The errors that users see, each with a text of one line."""

from typing import Any


class ScrewgenError(Exception):
    """Base of every error that screwgen raises on purpose; `str(error)` is one line meant for a user.

    `run`: of a run that failed the :class:`~screwgen.simulation.runs.Run` until then, `at` the time, s; else None.
    """

    run: Any = None
    at: float | None = None


class RobotFileError(ScrewgenError):
    """A robot, from a file or built in Python, that is unreadable, contradictory or non-physical."""


class UsageError(ScrewgenError):
    """A request that cannot be met as stated: a wrong option, argument, state file or output folder."""


class TargetWarning(UserWarning):
    """What a generated target lacks; the text is one line meant for a user."""


class PrecisionWarning(TargetWarning):
    """Generated C that is of no use in single precision; the text is one line meant for a user."""


class StoppedError(ScrewgenError):
    """Work that was interrupted; the text names the results that remain."""


class DivergedError(ScrewgenError):
    """A run that left the numbers that a robot's motion can have."""


class SingularError(ScrewgenError):
    """A posture or robot whose mass matrix cannot be inverted; the text names the joint."""


class UnknownNameError(UsageError, KeyError):
    """A name that nothing has; the text says which there are, or the nearest. Also a KeyError, as of a mapping."""

    __str__ = Exception.__str__
