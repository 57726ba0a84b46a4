"""`python -m screwgen` is the command `screwgen`, which this module starts."""

import os
import signal
import sys
from types import FrameType


def main() -> int:
    """Run the command line of this process and return its exit status."""
    if guarded := signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _interrupted)
    from .cli.main import main as command

    if guarded:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    return command()


def _interrupted(number: int, frame: FrameType | None) -> None:
    """End the process in one line: while it imports packages there is nothing to tidy, and they may hide exceptions."""
    os.write(2, b"screwgen: error: interrupted; nothing was written\n")
    os._exit(130)


if __name__ == "__main__":
    sys.exit(main())
