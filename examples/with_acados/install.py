"""acados for the examples: into build/acados, from PyPI, without a trace elsewhere.

    python examples/with_acados/install.py

Whoever has an acados with its Python interface sets ACADOS_SOURCE_DIR; it is then taken instead. Nothing is set in the
user's shell: `acados_template` sets what acados asks for in this process alone.
"""

from __future__ import annotations

import ctypes
import importlib
import os
import shutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "build" / "acados"
SITE = FOLDER / "site"
SOURCE = SITE / "acados" / "install"
PINNED = Path(__file__).with_name("requirements.txt")
READY = SITE / "ready"
LIBRARIES = ("blasfeo", "hpipm", "qpOASES_e", "acados")
"""In the order in which they need each other."""


class Missing(Exception):
    """acados is not there; the message says what to do."""


def install() -> None:
    """Put the pinned package into build/acados/site; one that is there stays."""
    wanted = PINNED.read_bytes()
    if READY.is_file() and READY.read_bytes() == wanted:
        return
    shutil.rmtree(SITE, ignore_errors=True)
    SITE.mkdir(parents=True)
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps"]
    done = subprocess.run([*pip, "--require-hashes", "--target", SITE, "-r", PINNED], capture_output=True, text=True)
    if done.returncode:
        lines = done.stderr.strip().splitlines() or ["pip failed"]
        raise Missing(
            f"acados could not be had from PyPI ({lines[-1]}); it is packed for Linux on x86-64: with network access "
            "run `make acados` again, or build acados and set ACADOS_SOURCE_DIR"
        )
    shutil.rmtree(SITE / "casadi", ignore_errors=True)  # a cut-down copy, which would hide the real one
    templates = SOURCE / "interfaces" / "acados_template"
    templates.mkdir(parents=True)
    (templates / "acados_template").symlink_to(Path("..", "..", "..", "acados_template"))
    READY.write_bytes(wanted)


def acados_template() -> ModuleType:
    """The Python interface of acados, ready for use; raises `Missing`."""
    source = Path(os.environ.get("ACADOS_SOURCE_DIR") or SOURCE)
    if source == SOURCE and not READY.is_file():
        raise Missing(f"acados is not in {FOLDER.relative_to(ROOT)}: run `make acados`, or set ACADOS_SOURCE_DIR")
    if shutil.which("make") is None or shutil.which("cc") is None:
        raise Missing("acados compiles what it generates: install a C compiler and make")
    os.environ["ACADOS_SOURCE_DIR"] = str(source)
    os.environ.setdefault("TERA_PATH", str(source / "bin" / "t_renderer"))
    place = str(source / "interfaces" / "acados_template")
    if place not in sys.path:
        sys.path.append(place)
    try:
        for name in LIBRARIES:  # loaded by their paths, so that no LD_LIBRARY_PATH is needed
            ctypes.CDLL(str(source / "lib" / f"lib{name}.so"), ctypes.RTLD_GLOBAL)
        return importlib.import_module("acados_template")
    except (OSError, ImportError) as error:
        raise Missing(f"the acados in {source} cannot be loaded ({error}); make it anew with `make acados`") from error


def main() -> int:
    try:
        install()
        acados_template()
    except Missing as error:
        print(f"install.py: error: {error}", file=sys.stderr)
        return 1
    print(f"acados is in {FOLDER.relative_to(ROOT)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
