"""What the benchmark says while it runs."""

from __future__ import annotations

import sys
import threading


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
