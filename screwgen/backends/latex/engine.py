"""A TeX engine that this machine has, and what it makes of a document."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from pathlib import Path

from ...errors import ScrewgenError

ENGINES = ("pdflatex", "tectonic", "lualatex")
"""The programs that make a PDF, the preferred one first."""
TEX = ("-interaction=nonstopmode", "-halt-on-error")


def engine() -> str:
    """The program that makes a PDF; raises ScrewgenError if there is none, which is to be asked before long work."""
    for name in ENGINES:
        if (program := shutil.which(name)) is not None:
            return program
    missing = ", ".join(ENGINES[1:])
    raise ScrewgenError(
        f"pdflatex was not found; install TeX Live (or one of {missing}), or write .tex or .html instead"
    )


def pdf(tex: str) -> bytes:
    """``tex`` compiled.  Raises ScrewgenError if there is no engine, or if it fails."""
    program = engine()
    name = Path(program).name
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "equations.tex").write_text(tex, encoding="utf-8")
        for _ in range(1 if name == "tectonic" else 2):  # the second run knows the table of contents
            _run(program, name, folder)
        return (Path(folder) / "equations.pdf").read_bytes()


def _run(program: str, name: str, folder: str) -> None:
    command = [program, *(() if name == "tectonic" else TEX), "equations.tex"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace")
    if done.returncode:
        lines = (done.stdout + done.stderr).splitlines()
        wrong = next((line for line in lines if line.startswith(("!", "error:"))), "no message")
        raise ScrewgenError(f"{name} failed: {wrong.removeprefix('error:').lstrip('! ')}")
