"""State files in JSON: a robot's state and inputs at an instant."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
from pydantic_core import PydanticCustomError

from ..errors import UsageError
from ..files import NotRegularError, open_regular
from ..robot_model import RobotModel
from ..spec.inputs import quantities
from ..spec.load import one_line
from ..spec.messages import key_path, unknown
from ..spec.ranges import within
from ..spec.values import array, refuse, shown

KEYS = ("q", "v", "tau", "w_ext")
AT_REST = "stability"
"""A key of what `equilibrium --json` prints: a state, and what else is known of it."""
MAX_BYTES = 16 * 2**20


@dataclass(frozen=True, eq=False)
class State:
    """The state and the inputs of a robot at an instant; SI units, radians.

    `q`, `v` (nq,): coordinates, joints then modes, and their rates; `tau` (n_tau,): joint torques, N·m (slides: N);
    `w_ext` (n, 6): external wrench [τ; F] on each link's tip section, tip-frame components.
    """

    q: np.ndarray
    v: np.ndarray
    tau: np.ndarray
    w_ext: np.ndarray

    def __iter__(self) -> Iterator[np.ndarray]:
        return iter((self.q, self.v, self.tau, self.w_ext))


def state_in(path: str | None, model: RobotModel) -> State:
    """The state in a file, all zero without."""
    return state_of({}, model) if path is None else read_state(path, model)


def read_state(path: str | os.PathLike[str], model: RobotModel) -> State:
    """The state in the JSON file at `path`: `{"q": […], "v": […], "tau": […], "w_ext": [[6 numbers] per link]}`.

    What is left out is zero; a bare list is `q`; `q` and `v` may give the joints alone. What `equilibrium --json`
    prints is the state at rest. Raises UsageError,
    `<file>: <key>: <what is wrong>; <what is allowed>`.
    """
    file = one_line(os.fsdecode(path))
    return state_of(parse(read_text(path, "a JSON file"), file), model, file)


def state_of(data: Any, model: RobotModel, file: str = "state") -> State:
    """The state that `data` (a list, or a dict of lists) describes; `file` is what errors call it."""
    given = data if isinstance(data, dict) else {"q": data}
    if AT_REST in given:
        given = {key: given[key] for key in KEYS if key in given}
    with refusals(file):
        if not isinstance(data, dict | list):
            raise refuse(f"is {shown(data)}; it must be a table of {', '.join(KEYS)}, or the array q")
        for key in given:
            if key not in KEYS:
                raise refuse(unknown(key, KEYS), (key,))
        coordinates = {key: motion(given.get(key, []), key, model) for key in ("q", "v")}
        named = quantities(model.robot)
        check = lambda x, at: within(named[at[-1]])(x, at=at)  # noqa: E731
        tau = sized(given.get("tau", [0.0] * model.n_tau), ("tau",), model.n_tau, "torques", check)
        w_ext = wrenches(given["w_ext"], model) if "w_ext" in given else np.zeros((model.n_links, 6))
        return State(**coordinates, tau=np.array(tau, float), w_ext=w_ext)


def motion(value: Any, key: str, model: RobotModel) -> np.ndarray:
    """`q` (nq,) or `v` (nv,); an array of the joints alone leaves the modes at zero and gears without load, an empty
    one leaves everything at zero.
    """
    entries = array(value, "an array of numbers", at=(key,))
    right = len(entries) in (0, *((model.n_joints, model.nv) if key == "v" else (model.chain.n_redundant, model.nq)))
    numbers = [within(key)(x, at=(key, i)) for i, x in enumerate(entries)] if right else [0.0] * len(entries)
    found = model.chain.complete(np.array(numbers, float), model.parameter_values, rates=key == "v")
    if isinstance(found, str):
        raise refuse(found, (key,))
    return found


def wrenches(value: Any, model: RobotModel) -> np.ndarray:
    """`w_ext` (n, 6), of all segments, from that of the links, or from a table by the names of links and pushes."""
    n, known = len(model.robot.links), model.chain.wrench_rows
    what, check = "numbers τx, τy, τz, Fx, Fy, Fz", within("w_ext")
    out = np.zeros((model.n_links, 6))
    if isinstance(value, dict):
        for name, row in value.items():
            if name not in known:
                raise refuse(unknown(name, tuple(known)), ("w_ext", name))
            out[known[name]] = sized(row, ("w_ext", name), 6, what, check)
        return out
    rows = array(value, f"an array of {n} wrenches of 6 numbers", at=("w_ext",))
    if len(rows) != n:
        raise refuse(f"has length {len(rows)}; it must have {n}, a wrench of 6 numbers for each link", ("w_ext",))
    out[model.chain.lasts] = [sized(row, ("w_ext", i), 6, what, check) for i, row in enumerate(rows)]
    return out


def sized(value: Any, at: tuple, size: int, what: str, check: Callable) -> list[float]:
    """`size` numbers that pass `check`."""
    entries = array(value, f"an array of {size} {what}", at=at)
    if len(entries) != size:
        raise refuse(f"has length {len(entries)}; it must have {size} {what}", at)
    return [check(x, at=(*at, i)) for i, x in enumerate(entries)]


@contextmanager
def refusals(file: str) -> Iterator[None]:
    """Turns the refusals of checks into a UsageError that names the file and the key."""
    try:
        yield
    except PydanticCustomError as error:
        where = key_path((error.context or {}).get("at", ()))
        raise UsageError(": ".join(filter(None, (file, where, error.message())))) from None


def parse(text: str, file: str) -> Any:
    """The value of a JSON text; keys may not repeat, NaN and Infinity are refused."""
    try:
        return json.loads(text, parse_constant=_constant, object_pairs_hook=_table)
    except json.JSONDecodeError as error:
        reason = error.msg[:1].lower() + error.msg[1:]
        raise UsageError(f"{file}: line {error.lineno}: is not valid JSON ({reason}); see https://json.org") from None
    except RecursionError:
        raise UsageError(f"{file}: is nested too deeply; arrays of arrays of numbers will do") from None
    except ValueError as error:
        raise UsageError(f"{file}: {one_line(str(error))}; use finite numbers and each key once") from None


def _constant(name: str) -> Any:
    raise ValueError(f"{name} is not a number that JSON knows")


def _table(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    for name, count in Counter(name for name, _ in pairs).items():
        if count > 1:
            raise ValueError(f"{shown(name)} is given {count} times")
    return dict(pairs)


def read_text(path: str | os.PathLike[str], kind: str) -> str:
    """The UTF-8 text of the file at `path`, which should be `kind`; raises UsageError, one line."""
    file = one_line(os.fsdecode(path))
    try:
        with open_regular(path) as stream:
            content = stream.read(MAX_BYTES + 1)
    except FileNotFoundError:
        raise UsageError(f"{file}: there is no such file; check the path") from None
    except IsADirectoryError:
        raise UsageError(f"{file}: is a directory; name {kind} in it") from None
    except NotRegularError as error:
        raise UsageError(f"{file}: {error}; name {kind}") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise UsageError(f"{file}: cannot be read ({one_line(reason)}); check path and permissions") from None
    if len(content) > MAX_BYTES:
        raise UsageError(f"{file}: is too large; {kind} has at most {MAX_BYTES} bytes")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise UsageError(f"{file}: line {line}: is not UTF-8 text; save it as {kind} in UTF-8") from None
