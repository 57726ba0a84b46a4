"""Reading and writing robot files (TOML). Every failure to load is one line that names the file."""

import json
import os
import re
import tomllib
from collections.abc import Callable
from typing import Any, TypeVar

from pydantic import ValidationError

from ..errors import RobotFileError, ScrewgenError, UsageError, one_line
from ..files import NotRegularError, open_regular
from ..joints.ball import BALL
from .axes import LETTERS, AxesOfKind
from .axis_elements import known_to_files
from .messages import explain, first_error, key_path, link_label, reason
from .part import Part
from .reduced import FOLDER, Reduced
from .robot import TABLES, Robot
from .values import Path

SCREWS = ("slide", "screw")
"""Keys whose value is an axis."""
MAX_BYTES = 4 * 2**20
FIVE_LEVELS = "a robot file needs five levels"
Table = TypeVar("Table", bound=Part)
DEEP_KEY = re.compile(r"""(?<![\w"'-])(?:[\w"'-]++[ \t]*+\.[ \t]*+){32}""")  # tomllib takes quadratic memory


def load(path: str | os.PathLike[str]) -> Robot:
    """The robot that the file at `path` describes.

    Raises RobotFileError, `<file>: <key path>: <what is wrong>; <what is allowed>`, on anything but a robot.
    """
    file = one_line(os.fsdecode(path))
    return loads(decode(read(path, file), file), file, os.path.dirname(os.fspath(path)))


def loads(text: str, file: str, folder: Any = "") -> Robot:
    """The robot that a text describes; `file`: what messages call it, `folder`: where the files lie that it names."""
    data = parse(text, file)
    try:
        return Robot.model_validate(data, context={FOLDER: folder})
    except ValidationError as error:
        raise RobotFileError(f"{file}: {explain(error, Robot, data)}") from None


def validated(data: dict[str, Any], folder: str, place: Callable[[Path], tuple[str, Path]]) -> Robot:
    """The robot of tables that come from other files; `place`: the file and the path there of a path in `data`.

    Raises RobotFileError as :func:`load`.
    """
    try:
        return Robot.model_validate(data, context={FOLDER: folder})
    except ValidationError as error:
        record = first_error(error)
        at = (*record["loc"], *record.get("ctx", {}).get("at", ()))
        file, there = place(at)
        raise RobotFileError(f"{file}: {key_path(there)}{link_label(at, data)}: {reason(record, Robot)}") from None


def load_table(
    kind: type[Table], path: str | os.PathLike[str], fault: type[ScrewgenError], depth: str = FIVE_LEVELS
) -> Table:
    """What the TOML file at `path` states, as a `kind`; raises as :func:`load`, `fault` for what the file says."""
    file = one_line(os.fsdecode(path))
    data = parse(decode(read(path, file), file), file, fault, depth)
    try:
        return kind.model_validate(data)
    except ValidationError as error:
        raise fault(f"{file}: {explain(error, kind, data)}") from None


def read(path: str | os.PathLike[str], file: str) -> bytes:
    """The bytes of the file at `path`."""
    try:
        with open_regular(path) as stream:
            content = stream.read(MAX_BYTES + 1)
    except FileNotFoundError:
        raise RobotFileError(f"{file}: there is no such file; check the path") from None
    except IsADirectoryError:
        raise RobotFileError(f"{file}: is a directory; name a TOML file in it") from None
    except NotRegularError as error:
        raise RobotFileError(f"{file}: {error}; name a TOML file") from None
    except PermissionError:
        raise RobotFileError(f"{file}: may not be read; check its permissions") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise RobotFileError(f"{file}: cannot be read: {reason}; check the path") from None
    if len(content) > MAX_BYTES:
        raise RobotFileError(f"{file}: is too large; a robot file has at most {MAX_BYTES} bytes")
    return content


def decode(content: bytes, file: str) -> str:
    """Text from UTF-8, with or without the byte order mark that some editors write."""
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise RobotFileError(f"{file}: line {line}: is not UTF-8 text; save it as TOML in UTF-8") from None


def parse(
    text: str, file: str, fault: type[ScrewgenError] = RobotFileError, depth: str = FIVE_LEVELS
) -> dict[str, Any]:
    """The tables and values of a TOML text; raises `fault`, where tables nest too deeply with the remedy `depth`."""
    try:
        if DEEP_KEY.search(text):
            raise RecursionError
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise fault(f"{file}: {syntax_error(str(error), text)}") from None
    except RecursionError:
        raise fault(f"{file}: is nested too deeply; {depth}") from None
    except ValueError as error:  # an integer of thousands of digits, a date such as 2024-02-31
        raise fault(f"{file}: a value cannot be read ({one_line(str(error))}); use TOML 1.0") from None


def syntax_error(message: str, text: str) -> str:
    """tomllib's message with its place in front: `line 3: is not valid TOML (expected …); …`."""
    place = re.search(r" \(at (?:line (\d+), column \d+|end of document)\)$", message)
    what = one_line(message[: place.start()] if place else message)
    line = place[1] if place and place[1] else text.rstrip().count("\n") + 1
    return f"line {line}: is not valid TOML ({what[:1].lower()}{what[1:]}); see https://toml.io/en/v1.0.0"


def dump(robot: Robot) -> str:
    """TOML text, in line properties, that loads to a robot equal to `robot`.

    Raises UsageError where a part is an object made in Python, which a file cannot state.
    """
    for link in robot.links:
        own = {
            "modes.basis": callable(link.modes.basis),
            "body": not isinstance(link.body, Reduced | None),
            "joint.elements": not known_to_files(link.joint.elements),
            "joint.axes": isinstance(link.joint.axes, AxesOfKind) and link.joint.kind != BALL,
        }
        if made := next((key for key, is_object in own.items() if is_object), None):
            raise UsageError(f"link '{link.name}': {made} holds an object made in Python; a robot file cannot state it")
    if laws := [k for k, force in enumerate(robot.forces) if not force.known_to_files]:
        raise UsageError(f"forces[{laws[0]}]: law is an object made in Python; a robot file cannot state it")
    related = [k for k, coupling in enumerate(robot.couplings) if coupling.relation is not None]
    if related:
        raise UsageError(f"couplings[{related[0]}]: relation is an object made in Python; a robot file cannot state it")
    if robot.inputs:
        raise UsageError("inputs are objects made in Python; a robot file cannot state them")
    if robot.sensors:
        raise UsageError("sensors are objects made in Python; a robot file cannot state them")
    stated = robot.model_dump(exclude_none=True, exclude_defaults=True, by_alias=True)
    tables = [(key, table) for key in TABLES for table in stated.pop(key, ())]
    return "\n".join([assignments(stated), *(f"[[{key}]]\n{assignments(table)}" for key, table in tables)])


def assignments(table: dict[str, Any]) -> str:
    """`key = value`, one a line."""
    return "".join(f"{key} = {entry(key, _shortest(value))}\n" for key, value in table.items())


def _shortest(value: Any) -> Any:
    """The stations of a section that is linear between them as the array that they may stand in for."""
    return value["stations"] if isinstance(value, dict) and value.keys() == {"stations"} else value


def entry(key: str, value: Any) -> str:
    """The value of `key`, on one line; axes in letters where there is one."""
    match value:
        case dict():
            inner = ", ".join(f"{k} = {entry(k, v)}" for k, v in value.items())
            return f"{{ {inner} }}" if inner else "{}"
        case tuple() | list():
            return axis(value) if key in SCREWS else f"[{', '.join(map(axis if key == 'axes' else item, value))}]"
        case bool() | str():
            return json.dumps(value)
    return repr(value)


def item(value: Any) -> str:
    """An entry of an array."""
    return entry("", value)


def axis(value: Any) -> str:
    """A letter for an axis of the frame, else the vector or the table of a screw."""
    letter = next((name for name, unit in LETTERS.items() if unit == value), None)
    return json.dumps(letter) if letter else item(value)
