"""Whatever stands in a robot file, the answer is a robot or one line."""

import copy
import datetime
import json
import tomllib

import pytest
from bad_robot_files import FORCES, GOOD, refusal
from hypothesis import given, settings
from hypothesis import strategies as st

from screwgen.errors import RobotFileError
from screwgen.spec import Robot, load


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return tmp_path_factory.mktemp("robots") / "bot.toml"


def toml(value):
    """`value` as TOML on one line."""
    match value:
        case bool() | str():
            return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
        case dict():
            return "{" + ", ".join(f"{toml(str(k))} = {toml(v)}" for k, v in value.items()) + "}"
        case list():
            return f"[{', '.join(map(toml, value))}]"
        case datetime.datetime() | datetime.date() | datetime.time():
            return value.isoformat()
    return repr(value)


texts = st.text(st.characters(codec="utf-8"), max_size=50)
keys = texts | st.sampled_from(["name", "length", "rhoA", "E", "area", "axes", "mass", "links", "torsion"])
values = st.recursive(
    st.integers()
    | st.floats()
    | st.booleans()
    | texts
    | st.dates()
    | st.times()
    | st.datetimes()
    | st.sampled_from([0, 1, 1e-9, "x", "tip", [], {}, ["x", "y"], [0, 0, 1], 16**400]),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(keys, inner, max_size=4),
    max_leaves=6,
)


def places(value):
    """Every container in `value`, with each of its keys."""
    if isinstance(value, dict | list):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield value, key
            yield from places(inner)


def mutate(data, draw):
    """Replace, delete, rename or add one entry somewhere in `data`."""
    container, key = draw(st.sampled_from(list(places(data))))
    how = draw(st.sampled_from(["replace", "delete", "rename", "add"]))
    value = copy.deepcopy(draw(values)) if how in ("replace", "add") else container[key]
    if how in ("delete", "rename"):
        del container[key]
    if how != "delete" and isinstance(container, dict):
        container[key if how == "replace" else draw(keys)] = value
    elif how != "delete":
        container.insert(draw(st.integers(0, 3)), value)


@st.composite
def mutants(draw):
    """The good file, wrong in one to three places."""
    data = tomllib.loads(GOOD + FORCES)
    for _ in range(draw(st.integers(1, 3))):
        if data:
            mutate(data, draw)
    return "\n".join(f"{toml(key)} = {toml(value)}" for key, value in data.items())


@st.composite
def splices(draw):
    """The good file with some bytes replaced by others."""
    content = GOOD.encode()
    start = draw(st.integers(0, len(content)))
    return content[:start] + draw(st.binary(max_size=8)) + content[start + draw(st.integers(0, 8)) :]


def robot_or_one_line(path, content):
    path.write_bytes(content)
    try:
        assert isinstance(load(path), Robot)
    except RobotFileError:
        refusal(path)


@pytest.mark.parametrize("count", [200, pytest.param(2000, marks=pytest.mark.long)])
def test_mutants_give_a_robot_or_one_line(path, count):
    @settings(max_examples=count)
    @given(text=mutants())
    def each(text):
        tomllib.loads(text)
        robot_or_one_line(path, text.encode())

    each()


@pytest.mark.parametrize("count", [200, pytest.param(2000, marks=pytest.mark.long)])
def test_bytes_give_a_robot_or_one_line(path, count):
    @settings(max_examples=count)
    @given(content=splices() | st.binary(max_size=200) | texts.map(str.encode))
    def each(content):
        robot_or_one_line(path, content)

    each()
