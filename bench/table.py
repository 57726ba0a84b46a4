"""The table: its rows, and how they are printed and written."""

from __future__ import annotations

import csv
import statistics
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

Bounds = tuple[float | None, float | None]
HEAD = ("", "ops", "instr", "KiB", "time", "±", "ratio", "target", "met", "peak")
FIELDS = (
    "group", "contender", "operations", "instructions", "bytes", "seconds", "spread", "ratio", "at least", "at most",
    "met", "share of peak", "instruction ratio",
)  # fmt: skip


@dataclass
class Row:
    """One line: seconds (of a call, a step, a derivation), their relative spread, and their ratio to another row's.

    ``spread``: half the distance between the quartiles over the median. ``target``: bounds of the ratio; ``met`` is
    None where there are none. ``peak``: operations per second over the machine's.
    """

    group: str
    title: str
    seconds: float
    ratio: float
    spread: float | None = None
    target: Bounds = (None, None)
    operations: int | None = None
    instructions: float | None = None
    instruction_ratio: float | None = None
    bytes: int | None = None
    peak: float | None = None

    @property
    def met(self) -> bool | None:
        low, high = self.target
        if low is None and high is None:
            return None
        return (low is None or self.ratio >= low) and (high is None or self.ratio <= high)

    def cells(self) -> list[str]:
        """What is printed, in the order of ``HEAD``."""
        return [
            " " + self.title,
            grouped(self.operations),
            grouped(self.instructions),
            "" if self.bytes is None else f"{self.bytes / 1024:.0f}",
            duration(self.seconds),
            "" if self.spread is None else f"{100 * self.spread:.0f}%",
            significant(self.ratio),
            bounds(self.target),
            {None: "", True: "yes", False: "NO"}[self.met],
            "" if self.peak is None else f"{100 * self.peak:.0f}%",
        ]


def spread(values: Sequence[float]) -> float:
    """Half the distance between the quartiles over the median."""
    low, middle, high = statistics.quantiles(values, n=4)
    return (high - low) / 2 / middle


# ---------------------------------------------------------------------------------------------- numbers


def grouped(x: float | None) -> str:
    """A count with commas."""
    return "" if x is None else f"{x:,.0f}"


def duration(seconds: float) -> str:
    """Three digits with a unit."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{significant(seconds / size)} {unit}"
    return f"{significant(seconds * 1e9)} ns"


def significant(x: float) -> str:
    """Three digits, never an exponent."""
    return f"{x:.0f}" if x >= 100 else f"{x:.1f}" if x >= 10 else f"{x:.2f}"


def bounds(target: Bounds) -> str:
    low, high = target
    return f"≥ {low:g}" if low is not None else f"≤ {high:g}" if high is not None else ""


# ---------------------------------------------------------------------------------------------- formats


def printed(rows: Sequence[Row]) -> str:
    """Aligned columns, a heading per group, within 100 columns."""
    cells = [row.cells() for row in rows]
    widths = [max(len(line[i]) for line in [HEAD, *cells]) for i in range(len(HEAD))]
    out = [aligned(HEAD, widths), "-" * (sum(widths) + len(widths) - 1)]
    for heading, members in groupby(zip(rows, cells, strict=True), key=lambda pair: pair[0].group):
        out += ["", heading, *(aligned(line, widths) for _, line in members)]
    return "\n".join(out)


def aligned(cells: Sequence[str], widths: Sequence[int]) -> str:
    """The first column flush left, the others right."""
    pairs = zip(cells, widths, strict=True)
    return " ".join(x.rjust(w) if i else x.ljust(w) for i, (x, w) in enumerate(pairs)).rstrip()


def markdown(rows: Sequence[Row]) -> str:
    """The same as Markdown, a table per group."""
    out = []
    for heading, members in groupby(rows, key=lambda row: row.group):
        out += [f"### {heading}", "", "| " + " | ".join(HEAD) + " |", "|---" + "|--:" * (len(HEAD) - 1) + "|"]
        out += ["| " + " | ".join(cell.strip() for cell in row.cells()) + " |" for row in members]
        out.append("")
    return "\n".join(out)


def write_csv(rows: Sequence[Row], path: Path) -> None:
    """All rows in full precision, seconds and shares as plain numbers."""
    with open(path, "w", newline="", encoding="utf-8") as stream:
        out = csv.writer(stream)
        out.writerow(FIELDS)
        for r in rows:
            values = [r.group, r.title, r.operations, r.instructions, r.bytes, f"{r.seconds:.6g}", _full(r.spread)]
            values += [_full(r.ratio), *r.target, r.met, _full(r.peak), _full(r.instruction_ratio)]
            out.writerow(values)


def _full(x: float | None) -> str:
    return "" if x is None else f"{x:.6g}"
