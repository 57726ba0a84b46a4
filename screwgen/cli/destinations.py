"""Where commands write: a file, or a folder of C with `--target c`."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

C = "c"
"""The target beside files."""


def check_destination(output: str, target: str | None, formats: tuple[str, ...], what: str) -> None:
    """Refuse, before any work is done, a file or a folder that cannot be written to; `what`: what is written, "a plan".

    `formats`: the suffixes that files may have, and folders may not.
    """
    from ..errors import UsageError
    from ..folder import check_folder
    from ..simulation.runs import check_output, suffix
    from ..spec.load import one_line

    if target is None:
        check_output(output, formats)
    elif target != C:
        raise UsageError(f"--target: there is no '{one_line(target)}'; {what} is written as {C}, or without --target")
    elif not output or suffix(output) in formats:
        raise UsageError(f"{one_line(output) or 'the output'}: is no name of a folder, which --target {C} writes")
    else:
        check_folder(Path(output))


def write_c(output: str, texts: Mapping[str, str]) -> list[str]:
    """Write sources into a folder; gives the paths of all its files."""
    from ..folder import MANIFEST, write_folder

    files = {name: text.encode() for name, text in texts.items()}
    write_folder(output, files, tuple(files))
    return [str(Path(output) / name) for name in (MANIFEST, *sorted(files))]
