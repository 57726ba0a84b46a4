"""A predictive controller's sample beside acados: the published arm with two flexible links, in its short form."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from contenders import Missing
from table import Row

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
PACKAGE = "comma-deps-acados"
ACADOS = (
    "a sample of model-predictive control, {states} states, {N} intervals of 5 ms, one iteration each, the same arm\n"
    "and loop for both: {acados} with HPIPM; screwgen's C holds torques over {blocks} blocks"
)


def acados() -> list[Row]:
    """Medians of the samples of a closed loop, and what the slowest took; raises Missing."""
    with TemporaryDirectory() as folder:
        command = [sys.executable, EXAMPLES / "nmpc_acados.py", "flexible_arm", "--short", "-o", folder]
        done = subprocess.run(command, capture_output=True, text=True)
        results = Path(folder) / "results.json"
        if not results.exists():
            said = (done.stderr.strip().splitlines() or ["it ended without a word"])[-1]
            raise Missing(f"acados: {said}")
        found = json.loads(results.read_text())["flexible_arm"]
    ((blocks, own),) = found["generated"].items()
    heading = ACADOS.format(states=found["states"], N=found["N"], acados=_version(), blocks=blocks)
    rows = []
    for what in ("median", "max"):
        mine, theirs = (1e-3 * side["times_ms"]["sample"][what] for side in (own, found))
        said = "median" if what == "median" else "slowest sample"
        rows += [Row(heading, f"screwgen, {said}", mine, 1.0), Row(heading, f"acados, {said}", theirs, theirs / mine)]
    return rows


def _version() -> str:
    """The name and version of the package that acados comes in."""
    lines = (EXAMPLES / "with_acados" / "requirements.txt").read_text(encoding="utf-8").splitlines()
    return next(line.partition(" --")[0].replace("==", " ") for line in lines if line.startswith(PACKAGE))
