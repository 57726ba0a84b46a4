"""Text that the benchmark prints: aligned columns, progress."""

from __future__ import annotations

import sys
import threading
from collections.abc import Sequence


def number(value: float | None, digits: int) -> str:
    """A number with so many decimals; nothing for None."""
    return "" if value is None else f"{value:.{digits}f}"


def aligned(lines: Sequence[Sequence[str]], left: int) -> str:
    """Columns of equal width, the first ``left`` of them flush left, the others right; the first line is the head."""
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    out = []
    for line in lines:
        cells = zip(line, widths, strict=True)
        out.append("  ".join(x.ljust(w) if i < left else x.rjust(w) for i, (x, w) in enumerate(cells)).rstrip())
    out.insert(1, "  ".join("-" * w for w in widths))
    return "\n".join(out)


class Progress:
    """Stages with counters on the standard error: rewritten in place on a terminal, a line per stage elsewhere."""

    def __init__(self):
        self._live = sys.stderr.isatty()
        self._lock = threading.Lock()
        self._title, self._total, self._done = "", 0, 0

    def stage(self, title: str, total: int = 0) -> None:
        """Begin a stage of ``total`` steps; no title clears the line."""
        self._title, self._total, self._done = title, total, 0
        if self._live:
            self._show(title)
        elif title:
            print(title + (f", {total} steps" if total else ""), file=sys.stderr, flush=True)

    def step(self, what: str) -> None:
        """One step done."""
        with self._lock:
            self._done += 1
            if self._live:
                self._show(f"{self._title} {self._done}/{self._total}  {what}")

    def _show(self, text: str) -> None:
        print(f"\r\x1b[K{text[:100]}", end="", file=sys.stderr, flush=True)
