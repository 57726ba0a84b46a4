"""Files of paths of the tip: a shape, or a table of places over time."""

from __future__ import annotations

import os

import numpy as np

from ..errors import UsageError
from ..planning.tip_path import TipPath, shaped, through_rows
from ..spec.load import one_line
from ..spec.tip_path import read_shape
from .input_table import read_table

PLACES = ("x", "y", "z")


def read_path(path: str | os.PathLike[str]) -> TipPath:
    """The path of the tip in a file, m, in inertial axes: TOML states a shape, a .csv has rows of t, x, y and z.

    What goes through the rows is a spline of order 7 from rest to rest, whose first row is at its time 0. Raises
    UsageError, one line: places that jump, clocks that do, rows too far apart, unknown columns, no numbers.
    """
    file = one_line(os.fsdecode(path))
    if not os.fsdecode(path).lower().endswith(".csv"):
        return shaped(read_shape(path))
    t, columns = read_table(path, PLACES)
    if missing := [name for name in PLACES if name not in columns]:
        raise UsageError(f"{file}: has no column '{missing[0]}'; the head is t,{','.join(PLACES)}, places in m")
    try:
        return through_rows(t, np.transpose([columns[name] for name in PLACES]))
    except UsageError as error:
        raise UsageError(f"{file}: {error}") from None
