"""docs/notebook.ipynb, made of docs/notebook.md: prose and Python blocks as cells, with what the page says they print.

    python docs/tools/notebook.py      # writes it; a test compares it, and runs its cells

The page's blocks are run by pages.py. Here they run for what objects at the ends of cells show of themselves in
Markdown or LaTeX. Cells have no pictures and no players: running the notebook draws them.
"""

from __future__ import annotations

import ast
import io
import json
import os
import sys
from collections.abc import Iterator
from contextlib import redirect_stdout
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from pages import ROOT, blocks

PAGE = ROOT / "docs" / "notebook.md"
NOTEBOOK = PAGE.with_suffix(".ipynb")
SHOWN = {"text/latex": "_repr_latex_", "text/markdown": "_repr_markdown_"}
"""The formats that a notebook keeps, and the methods by which objects show themselves in them."""
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def notebook(page: Path) -> str:
    """The page as a notebook of format 4.4, whose cells need no identifiers."""
    content = {"cells": list(_cells(page)), "metadata": METADATA, "nbformat": 4, "nbformat_minor": 4}
    return json.dumps(content, ensure_ascii=False, indent=1) + "\n"


def _cells(page: Path) -> Iterator[dict]:
    """Prose between blocks, and each Python block with the text below it and what its last expression shows."""
    lines = page.read_text(encoding="utf-8").splitlines()
    found, last = blocks(page), 0
    namespace: dict = {}
    for k, block in enumerate(found):
        prose = "\n".join(lines[last : block.line - 2]).strip()
        last = block.line + block.text.count("\n")
        if prose:
            yield {"cell_type": "markdown", "metadata": {}, "source": _lines(prose)}
        if block.language == "python":
            printed = found[k + 1].text if found[k + 1 : k + 2] and found[k + 1].language == "text" else ""
            yield _code(block.text, printed, result(block.text, namespace))
        elif block.language != "text":
            raise SystemExit(f"{page.name}:{block.line}: a notebook has python and text alone, not {block.language}")


def result(text: str, namespace: dict) -> object:
    """What a kernel has of a cell that it runs: the value of its last line if that is an expression, else None."""
    tree = ast.parse(text)
    last = [tree.body.pop()] if isinstance(tree.body[-1], ast.Expr) else []
    with redirect_stdout(io.StringIO()):
        exec(compile(tree, "cell", "exec"), namespace)
        return eval(compile(ast.Expression(last[0].value), "cell", "eval"), namespace) if last else None


def _code(text: str, printed: str, value: object) -> dict:
    stream = {"name": "stdout", "output_type": "stream", "text": _lines(printed.rstrip("\n"))}
    data = {kind: _lines(getattr(value, name)()) for kind, name in SHOWN.items() if hasattr(value, name)}
    data |= {"text/plain": _lines(repr(value))} if data else {}
    shown = {"data": data, "execution_count": None, "metadata": {}, "output_type": "execute_result"}
    outputs = [stream] * bool(printed) + [shown] * bool(data)
    source = _lines(text.rstrip("\n"))
    return {"cell_type": "code", "execution_count": None, "metadata": {}, "outputs": outputs, "source": source}


def _lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)


if __name__ == "__main__":
    os.environ["MPLBACKEND"] = "Agg"
    NOTEBOOK.write_text(notebook(PAGE), encoding="utf-8")
