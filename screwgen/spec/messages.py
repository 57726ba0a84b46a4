"""From pydantic's error records to one line: `<key path>: <what is wrong>; <what is allowed>`."""

import difflib
import re
import typing
from typing import Any

from pydantic import BaseModel, ValidationError

from .names import IDENTIFIER, MAX_LENGTH
from .values import Path, quoted, shown

BARE_KEY = re.compile(r"[A-Za-z0-9_-]{1,40}")


def explain(error: ValidationError, root: type[BaseModel], data: Any) -> str:
    """The first error in words; `root` is the class that refused `data`.

    Unknown keys come first: a misspelt key is why another one is missing.
    """
    count = error.error_count()
    more = f"; {count - 1} more {'fault' if count == 2 else 'faults'} in the file" if count > 1 else ""
    return sentence(first_error(error), root, data) + more


def first_error(error: ValidationError) -> Any:
    """The record of the first error; unknown keys come first."""
    return min(error.errors(include_url=False), key=lambda record: record["type"] != "extra_forbidden")


def sentence(record: Any, root: type[BaseModel], data: Any) -> str:
    """One error record as `<key path>: <what>; <remedy>`."""
    path = (*record["loc"], *record.get("ctx", {}).get("at", ()))
    where = key_path(path) + link_label(path, data)
    return f"{where}: {reason(record, root)}" if where else reason(record, root)


def key_path(path: Path) -> str:
    """`path` as one would write it in the file: `links[1].joint.axes[0]`."""
    text = "".join(f"[{part}]" if isinstance(part, int) else f".{key(part)}" for part in path)
    return text.removeprefix(".")


def key(name: str) -> str:
    """A key, in quotes where TOML needs them."""
    return name if BARE_KEY.fullmatch(name) else quoted(name)


def link_label(path: Path, data: Any) -> str:
    """` (link forearm)` where `path` leads into a link whose name is known and sound."""
    match path, data:
        case ("links", int(i), *_), {"links": [*links]}:
            link = links[i]
            name = link.get("name") if isinstance(link, dict) else getattr(link, "name", None)
            return f" (link {name})" if sound(name) else ""
    return ""


def sound(name: Any) -> bool:
    """Whether `name` is fit to be shown without quotes."""
    return isinstance(name, str) and len(name) <= MAX_LENGTH and IDENTIFIER.fullmatch(name) is not None


def reason(record: Any, root: type[BaseModel]) -> str:
    """What is wrong and what is allowed: our own checks say it, pydantic's are put in words here."""
    *above, last = record["loc"] or ("",)
    match record["type"]:
        case "refused":
            return record["ctx"]["what"]
        case "missing":
            field = model_at(root, above).model_fields[last]
            return f"is missing; state {field.description}"
        case "extra_forbidden":
            known, inner = known_keys(model := model_at(root, above)), inner_keys(model)
            return outside(str(last), known, root, tuple(above)) or unknown(str(last), known, inner)
        case "model_type":
            keys = ", ".join(known_keys(model_at(root, record["loc"])))
            return f"is {shown(record['input'])}; it must be a table of {keys}"
        case "tuple_type":
            return f"is {shown(record['input'])}; it must be an array of tables"
    return f"is {shown(record['input'])}; {record['msg'].splitlines()[0]}"


def unknown(name: str, known: tuple[str, ...], inner: dict[str, str] | None = None) -> str:
    """What to say of a key that nobody reads; `inner` has the keys of the tables below, with the names of these."""
    if inner and name in inner:
        return f"is an unknown key here; it belongs in {inner[name]}; known here: {', '.join(known)}"
    lowered = {k.lower(): k for k in known}
    near = difflib.get_close_matches(name.lower()[:MAX_LENGTH], lowered, n=1)
    suggestion = f"did you mean {lowered[near[0]]}? " if near else ""
    return f"is an unknown key; {suggestion}known here: {', '.join(known)}"


def outside(name: str, known: tuple[str, ...], root: type[BaseModel], above: Path) -> str:
    """What to say of a key of one of the tables around, behind whose sub-table it stands in a TOML file; else ""."""
    for i in reversed([i for i, part in enumerate(above) if isinstance(part, str)]):
        if name in known_keys(model_at(root, above[:i])):
            where = f"in {key_path(above[:i])}, above its table {above[i]}" if i else f"at the top, above {above[i]}"
            return f"is an unknown key here; it belongs {where}; known here: {', '.join(known)}"
    return ""


def known_keys(model: type[BaseModel]) -> tuple[str, ...]:
    """The keys that `model` reads, in the order of its fields, then other spellings."""
    fields = (field.alias or name for name, field in model.model_fields.items() if not field.exclude)
    return (*fields, *getattr(model, "other_keys", ()))


def inner_keys(model: type[BaseModel]) -> dict[str, str]:
    """The keys of the tables that stand directly below, with the first table that has each."""
    tables = [(name, model_in(field.annotation)) for name, field in model.model_fields.items()]
    return {key: name for name, inner in reversed(tables) if inner for key in known_keys(inner)}


def model_at(root: type[BaseModel], path: typing.Iterable[str | int]) -> type[BaseModel]:
    """The class whose keys stand at `path` below `root`."""
    for part in path:
        if isinstance(part, str):
            inner = model_in(root.model_fields[part].annotation)
            if inner is None:
                raise TypeError(f"{part} of {root.__name__} has no keys")
            root = inner
    return root


def model_in(annotation: Any) -> type[BaseModel] | None:
    """The model class inside an annotation such as `tuple[Link, ...]` or `Mount | None`."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    return next(filter(None, map(model_in, typing.get_args(annotation))), None)
