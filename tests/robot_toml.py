"""Robot files of robots that are plain dicts."""

from __future__ import annotations


def to_toml(robot: dict) -> str:
    """The robot file of a robot; numbers are written so that they read back bit for bit."""
    head = [f"{key} = {_value(value)}" for key, value in robot.items() if key != "links"]
    tables = [
        "\n".join(["", "[[links]]", *(f"{key} = {_value(value)}" for key, value in link.items())])
        for link in robot["links"]
    ]
    return "\n".join([*head, *tables]) + "\n"


def _value(value) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{k} = {_value(v)}" for k, v in value.items()) + " }"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(_value(v) for v in value) + "]"
    return repr(float(value)) if isinstance(value, float) else repr(value)
