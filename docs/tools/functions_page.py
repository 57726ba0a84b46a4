"""The table of docs/functions.md: the functions of a robot with inputs, results and units, as they are stated.

python docs/tools/functions_page.py      # writes the rows anew; a test compares them
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from screwgen.algorithms.robot_function import RobotFunction  # noqa: E402
from screwgen.algorithms.robot_functions import FUNCTIONS, OUTPUTS  # noqa: E402

PAGE = ROOT / "docs" / "functions.md"
ROWS = re.compile(r"(?:^\| `.*\n)+", re.MULTILINE)
SIZES = {"NQ": "nq", "NV": "nv", "NVZ": "nvz", "NTAU": "n_tau", "NAXES": "n_joints", "NLINKS": "n"}
SIZES |= {"NMARKERS": "m", "NSTRAINS": "n_strains", "NCYLINDERS": "n_cylinders"}
SIZES |= {"NQUANTITIES": "n_quantities", "NTENDONS": "n_tendons"}


def table(text: str) -> str:
    """The page with the rows of its table as the functions state them."""
    return ROWS.sub(lambda _: "".join(map(_row, FUNCTIONS)), text, count=1)


def _row(function: RobotFunction) -> str:
    told = [
        f"`{name}` ({', '.join(str(SIZES.get(str(n), n)) for n in of.shape) or 'a number'}), {of.unit}"
        for name, of in function.results.items()
    ]
    units = ", units" * (function.c_file == OUTPUTS or function.sensor)
    about = f"also in C, runs, rollouts{units}. " * bool(function.c_file) + function.about
    return f"| `{function.name}` | {', '.join(function.names)} | {'; '.join(told)} | {about} |\n"


if __name__ == "__main__":
    PAGE.write_text(table(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
