"""Commands, called in this process as a user would call them, and `make check` of the folders of C that they write."""

from __future__ import annotations

import contextlib
import io
import shutil
import signal
import subprocess
import traceback
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from screwgen.cli.main import main as screwgen

LONGEST = 300
"""s: what takes longer has died."""
GCC = str(Path(__file__).parent / "tools" / "cc")
TCC = shutil.which("tcc") or GCC
"""The compilers of units and of all else; neither optimises."""
DONE, REFUSED, DIED, WRONG = "done", "refused", "died", "check failed"


class Outcome(NamedTuple):
    """What came of a command: one of DONE, REFUSED, DIED and WRONG, and its reason."""

    said: str
    why: str = ""


def called(line: list[str]) -> Outcome:
    """What came of a command line in this process."""
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(said), limited():
            status = screwgen([*line])
    except Exception as error:  # the sweep goes on; what was raised is what a user would see as a traceback
        frame = traceback.extract_tb(error.__traceback__)[-1]
        return Outcome(DIED, f"{type(error).__name__} in {Path(frame.filename).name}, {frame.name}: {error}")
    errors = [text for text in said.getvalue().splitlines() if text.startswith("screwgen: error: ")]
    if status == 0:
        return Outcome(DONE)
    if len(errors) != 1 or "Traceback" in said.getvalue():
        return Outcome(DIED, f"status {status}: {said.getvalue()}")
    return Outcome(REFUSED, f"status {status}: {errors[0].removeprefix('screwgen: error: ')}")


@contextlib.contextmanager
def limited() -> Iterator[None]:
    """Raises TimeoutError in what takes longer than LONGEST."""

    def late(*_) -> None:
        raise TimeoutError(f"takes more than {LONGEST} s")

    before = signal.signal(signal.SIGALRM, late)
    signal.alarm(LONGEST)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def checked(folder: Path, compiler: str = "gcc", flags: Sequence[str] = ("-O0",)) -> Outcome:
    """`make check`, in double and, unless the folder says that it is of no use, in float; it compiles every source."""
    make = ["make", "-s", f"CC={compiler}", f"CFLAGS={' '.join(flags)}", "check"]
    done = subprocess.run(make, cwd=folder, capture_output=True, text=True, timeout=LONGEST)
    failed = [x for x in (*done.stdout.splitlines(), *done.stderr.splitlines()) if "FAILED" in x or "error" in x]
    if done.returncode == 0 and not failed and "all checks passed" in done.stdout:
        return Outcome(DONE)
    return Outcome(WRONG, "; ".join(failed) or done.stderr)
