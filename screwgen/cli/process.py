"""The process of a command: its signals, streams and exit status, and the one-line error message."""

from __future__ import annotations

import gc
import io
import os
import signal
import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import typer

from ..errors import ScrewgenError, SingularError, StoppedError, one_line

ClickException: Any = typer.BadParameter.__mro__[2]
"""Whatever is wrong with a command line; typer has it under names that change with its version."""


YOUNG = 200_000
"""Objects beyond which Python looks for garbage: a derived robot has millions, which live as long as the process."""


def prepare() -> None:
    """Make this process one of a command."""
    gc.set_threshold(YOUNG, 50, 50)
    _tidy_when_told_to_end()
    _open_streams()


def _tidy_when_told_to_end() -> None:
    """Let a closed terminal or a plain `kill` end the process as an exception does: temporary files go."""
    for name in ("SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), lambda number, _: sys.exit(128 + number))


def _open_streams() -> None:
    """Make output robust: discarded if the stream is closed, escaped if its encoding lacks a letter."""
    for name in ("stdin", "stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "r" if name == "stdin" else "w"))  # noqa: SIM115
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")


@contextmanager
def warnings_as_lines() -> Iterator[None]:
    """Show warnings for users on one line, as errors are; deprecations are told to the packages that they concern."""
    with warnings.catch_warnings():
        default = warnings.showwarning

        def show(message: Warning | str, category: type[Warning], *place: Any, **more: Any) -> None:
            if issubclass(category, UserWarning):
                _say("warning", str(message))
            else:
                default(message, category, *place, **more)

        warnings.simplefilter("always", UserWarning)
        warnings.simplefilter("ignore", DeprecationWarning)  # some packages' are warnings for users as well
        warnings.showwarning = show
        yield


def guarded(work: Callable[[], int]) -> int:
    """The exit status of `work`; an error becomes one line on stderr."""
    try:
        with warnings_as_lines():
            return work()
    except ClickException as error:
        return _fail(_sentence(error))
    except ScrewgenError as error:
        from ..simulation.integrate import DivergedError

        failed = isinstance(error, SingularError | DivergedError)
        return _fail(str(error), status=130 if isinstance(error, StoppedError) else 1 if failed else 2)
    except KeyboardInterrupt:
        return _fail("interrupted; nothing was written", status=130)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except MemoryError:
        return _fail("the memory is full; take a shorter run, a longer step or a smaller robot", status=1)
    except OSError as error:
        return _fail(f"the system refuses: {error.strerror or error}; check files, disk and permissions", status=1)


def _sentence(error: Any) -> str:
    """An error of the command line in screwgen's format: what is wrong; where to find help."""
    context = getattr(error, "ctx", None)
    path = context.command_path if context else "screwgen"
    message = error.format_message()
    return f"{message[:1].lower()}{message[1:].rstrip('.')}; see '{path} --help'"


def _fail(message: str, status: int = 2) -> int:
    """Say it on stderr, on one line."""
    _say("error", message)
    return status


def _say(kind: str, message: str) -> None:
    typer.echo(f"screwgen: {kind}: {one_line(' '.join(message.split()))}", err=True)
