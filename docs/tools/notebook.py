"""docs/notebook.ipynb, made of docs/notebook.md: prose and Python blocks as cells, with what the page says they print.

    python docs/tools/notebook.py      # writes it; a test compares it, and runs its cells

The page's blocks are run by pages.py. Cells have no pictures: running the notebook draws them.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from pages import ROOT, blocks

PAGE = ROOT / "docs" / "notebook.md"
NOTEBOOK = PAGE.with_suffix(".ipynb")
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def notebook(page: Path) -> str:
    """The page as a notebook of format 4.4, whose cells need no identifiers."""
    content = {"cells": list(_cells(page)), "metadata": METADATA, "nbformat": 4, "nbformat_minor": 4}
    return json.dumps(content, ensure_ascii=False, indent=1) + "\n"


def _cells(page: Path) -> Iterator[dict]:
    """Prose between blocks, and each Python block with the text below it."""
    lines = page.read_text(encoding="utf-8").splitlines()
    found, last = blocks(page), 0
    for k, block in enumerate(found):
        prose = "\n".join(lines[last : block.line - 2]).strip()
        last = block.line + block.text.count("\n")
        if prose:
            yield {"cell_type": "markdown", "metadata": {}, "source": _lines(prose)}
        if block.language == "python":
            printed = found[k + 1].text if found[k + 1 : k + 2] and found[k + 1].language == "text" else ""
            yield _code(block.text, printed)
        elif block.language != "text":
            raise SystemExit(f"{page.name}:{block.line}: a notebook has python and text alone, not {block.language}")


def _code(text: str, printed: str) -> dict:
    output = {"name": "stdout", "output_type": "stream", "text": _lines(printed.rstrip("\n"))}
    source = _lines(text.rstrip("\n"))
    outputs = [output] if printed else []
    return {"cell_type": "code", "execution_count": None, "metadata": {}, "outputs": outputs, "source": source}


def _lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)


if __name__ == "__main__":
    NOTEBOOK.write_text(notebook(PAGE), encoding="utf-8")
