"""Files of scheduled shapers, TOML."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..errors import UsageError
from ..files import sound
from ..spec.load import decode, one_line, parse, read
from .scheduled_shaper import MOST_DEGREE, MOST_MODES, MOST_TERMS, FittedMode, ScheduledShaper
from .shapers import KINDS, VIBRATES

TEXTS, LISTS, ROWS = ("robot", "kind", "vibrates"), ("joints", "variables"), ("lower", "upper")


def shaper_text(made: ScheduledShaper) -> str:
    """A shaper as TOML, with what it leaves in a comment."""
    lines = [f"# {made.line}", *(f"{name} = {_quoted(getattr(made, name))}" for name in TEXTS)]
    lines += [] if made.law is None else [f"law = {_quoted(made.law)}"]
    lines += [f"{name} = [{', '.join(map(_quoted, getattr(made, name)))}]" for name in LISTS]
    lines += [f"{name} = {getattr(made, name).tolist()}" for name in ROWS]
    lines += [f"powers = {made.powers.tolist()}"]
    for mode in made.modes:
        lines += ["", "[[modes]]", *(f"{name} = {getattr(mode, name).tolist()}" for name in ("frequency", "damping"))]
        lines += [f"{name} = {list(getattr(mode, name))}" for name in ("frequencies", "dampings")]
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def read_shaper(path: str | os.PathLike[str]) -> ScheduledShaper:
    """The shaper in a file; raises UsageError, one line."""
    file = one_line(os.fsdecode(path))
    data = parse(decode(read(path, file), file), file)
    try:
        return _shaper(data)
    except (KeyError, TypeError, ValueError) as error:
        said = f"'{error.args[0]}' is missing" if isinstance(error, KeyError) else one_line(str(error))
        raise UsageError(f"{file}: cannot be read as a shaper ({said}); write it with screwgen shape") from None


def _shaper(data: Mapping[str, Any]) -> ScheduledShaper:
    """A shaper of what a file states; raises KeyError, TypeError and ValueError."""
    robot, kind, vibrates = (str(data[name]) for name in TEXTS)
    joints, variables = (tuple(map(str, data[name])) for name in LISTS)
    lower, upper = (np.array(data[name], float) for name in ROWS)
    powers = _powers(data["powers"], len(variables))
    modes = tuple(_mode(x, len(powers)) for x in data["modes"])
    if kind not in KINDS:
        raise ValueError(f"there is no kind '{kind}'")
    if vibrates not in VIBRATES:
        raise ValueError(f"vibrates must be one of: {', '.join(VIBRATES)}")
    if len(modes) > MOST_MODES:
        raise ValueError(f"there are {len(modes)} modes; {MOST_MODES} are allowed")
    if lower.shape != (len(variables),) or upper.shape != lower.shape or not (lower < upper).all() or not modes:
        raise ValueError("lower and upper need a number for each variable, lower < upper, and a mode must be there")
    if not (sound(lower) and sound(upper)):
        raise ValueError("bounds must be finite numbers")
    law = data.get("law")
    law = None if law is None else str(law)
    return ScheduledShaper(robot, kind, vibrates, joints, variables, lower, upper, powers, modes, law)


def _powers(rows: Any, count: int) -> np.ndarray:
    """(terms, count): the powers of the variables; raises TypeError and ValueError."""
    found = np.array(rows).reshape(len(rows), count)
    if found.size and (found.dtype.kind != "i" or found.min() < 0 or found.max() > MOST_DEGREE):
        raise ValueError(f"powers must be whole numbers from 0 to {MOST_DEGREE}")
    if len(found) > MOST_TERMS:
        raise ValueError(f"there are {len(found)} rows of powers; {MOST_TERMS} are allowed")
    return found.astype(int)


def _mode(data: Mapping[str, Any], terms: int) -> FittedMode:
    f, z = (np.array(data[name], float) for name in ("frequency", "damping"))
    (least, most), (low, high) = (map(float, data[name]) for name in ("frequencies", "dampings"))
    if f.shape != (terms,) or z.shape != f.shape or not (sound(f) and sound(z)):
        raise ValueError("a mode needs a finite coefficient of frequency and damping for each row of powers")
    if not (0 < least <= most < np.inf and 0 <= low <= high < 1):
        raise ValueError("frequencies must be > 0, dampings from 0 to less than 1, ascending")
    return FittedMode(f, z, (least, most), (low, high))
