"""What the scripts share: how one ends, its CSV, the lines of what is beyond a limit."""

from __future__ import annotations

import csv
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NoReturn

from cross import FirmwareError
from targets import HERE

from screwgen.errors import ScrewgenError

ROOT = HERE.parent
OUT = ROOT / "build"


def ended(main: Callable[[], int]) -> NoReturn:
    """Run a script; what it cannot measure is one line, and the exit status 2."""
    try:
        sys.exit(main())
    except (FirmwareError, ScrewgenError) as error:
        print(f"firmware: error: {error}", file=sys.stderr)
        sys.exit(2)


def judged(text: str, name: str, row: Mapping[str, object], failures: list[str]) -> int:
    """Print a table, write its row to build/`name`.csv, and say what is beyond its limit; the exit status."""
    OUT.mkdir(exist_ok=True)
    with (OUT / f"{name}.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, row, lineterminator="\n")
        writer.writeheader()
        writer.writerow(row)
    print(text, *failures, sep="\n")
    return int(bool(failures))


def write_section(table: Path, title: str, head: str, rows: Sequence[tuple[str, str]]) -> None:
    """Write a section of the committed table, in place of the one that it has under this title."""
    before, *parts = re.split(r"^(?=## )", table.read_text(encoding="utf-8"), flags=re.MULTILINE)
    others = [part.rstrip("\n") for part in (before, *parts) if not part.startswith(f"## {title}\n")]
    lines = [f"## {title}", "", head + ".", "", "| figure | value |", "|---|---|"]
    own = "\n".join([*lines, *(f"| {name} | {value} |" for name, value in rows)])
    table.write_text("\n\n".join([*others, own]) + "\n", encoding="utf-8")


def beyond(taken: Mapping[str, tuple[int, int]]) -> list[str]:
    """The figures that are not below their limits."""
    return [f"{name}: {x:,}, the limit is {most:,}" for name, (x, most) in taken.items() if not 0 < x < most]
