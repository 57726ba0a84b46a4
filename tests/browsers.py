"""The browsers in which the page of equations is looked at, by the names of their programs."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import Browser
from conftest import require_tool
from firefox import Firefox

BROWSERS = {"chromium": Browser, "firefox-esr": Firefox}
every_browser = pytest.mark.parametrize("program", BROWSERS)


def started(program: str, folder: Path, size: tuple[int, int] = (1280, 900)) -> Browser | Firefox:
    """A browser with a profile of its own; where it is not installed the test is skipped, or fails in CI."""
    return BROWSERS[program](require_tool(program), folder / "profile", size)
