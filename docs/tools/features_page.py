"""The last part of docs/features.md: what works with what, as the tables of the conformance tests have it.

python docs/tools/features_page.py      # writes it anew; a test compares
"""

from __future__ import annotations

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]

from conformance.table import page  # noqa: E402

PAGE = ROOT / "docs" / "features.md"

if __name__ == "__main__":
    PAGE.write_text(page(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
