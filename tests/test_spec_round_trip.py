"""Any robot survives a file, and its parameters and names have the sizes they should."""

import itertools

import pytest
from hypothesis import given
from hypothesis import strategies as st
from spec_parts import STIFFNESS_OF, reloaded, robot

from screwgen.spec import Body, Damping, Frequencies, Joint, Link, Modes, Mount, Section, coordinate_names, parameters

numbers = st.floats(-1e6, 1e6)
amounts = st.just(0.0) | st.floats(1e-12, 1e6)
vectors = st.tuples(numbers, numbers, numbers)
maybe = st.none


def per_axis(n):
    """One amount for each of `n` axes, or nothing."""
    return maybe() | st.tuples(*[amounts] * n)


@st.composite
def joints(draw):
    first = draw(st.sampled_from(["x", "y", (1.0, 2.0, 3.0), (0.3, -0.1, 0.7)]))
    screw = draw(st.sampled_from([{"slide": "x"}, {"slide": (0.6, 0.0, 0.8)}, {"screw": "y", "pitch": -0.002}]))
    stated = [(), (first,), (first, "z"), (first, "z", "x"), (screw,), (first, screw), (screw, (1.0, 2.0, -3.0), "z")]
    axes = draw(st.sampled_from(stated))
    mount = maybe() | st.builds(Mount, xyz=maybe() | vectors, rpy=maybe() | vectors)
    losses = {name: draw(per_axis(len(axes))) for name in ("armature", "damping", "stiffness")}
    return Joint(axes=axes, mount=draw(mount), **losses)


bodies = st.builds(
    Body,
    at=st.sampled_from(["base", "tip"]),
    mass=amounts,
    com=maybe() | vectors,
    inertia=st.sampled_from([None, (1, 2, 2.5, 0.1, -0.2, 0.3), (0, 0, 0, 0, 0, 0)]),
)


@st.composite
def flexible(draw):
    """Section and modes; each direction's stiffness by the section or by frequencies."""
    counts = {direction: draw(st.integers(0, 32)) for direction in STIFFNESS_OF}
    measured = {d: draw(ascending(n)) for d, n in counts.items() if draw(st.integers(0, 3)) == 0}
    basis = draw(st.sampled_from(["clamped_free", "polynomial"]))
    basis = "clamped_free" if any(measured.values()) else basis
    frequencies = draw(maybe() | st.just(Frequencies())) if not measured else Frequencies(**measured)
    names = ["rhoA", "rhoIp", *(STIFFNESS_OF[d] for d in counts if not measured.get(d))]
    section = Section(**{name: draw(st.floats(1e-3, 1e9)) for name in names})
    return {"section": section, "modes": Modes(basis=basis, frequencies=frequencies, **counts)}


def ascending(count):
    """So many frequencies."""
    steps = st.lists(st.floats(0.01, 1e4), min_size=count, max_size=count)
    return steps.map(lambda gaps: tuple(itertools.accumulate(gaps)))


@st.composite
def robots(draw):
    links = [
        Link(
            name=f"link{i}",
            length=draw(st.floats(0.5, 10)),
            frame_at=draw(maybe() | st.floats(0, 0.5)),
            **draw(flexible()),
            damping=draw(maybe() | st.builds(Damping, ratio=amounts, time=maybe() | amounts)),
            joint=draw(joints()),
            bodies=draw(st.lists(bodies, max_size=2)),
        )
        for i in range(draw(st.integers(1, 3)))
    ]
    return robot(*links, gravity=draw(vectors), section_rotation=draw(st.booleans()))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("robots")


@given(original=robots())
def test_any_robot_survives_dump_and_load(folder, original):
    assert reloaded(original, folder) == original


@given(original=robots())
def test_parameters_and_names_have_the_sizes_they_should(original):
    names = coordinate_names(original)
    axes = sum(len(link.joint.axes) for link in original.links)
    assert len(names.tau) == axes and len(names.wrench) == 6 * len(original.links)
    assert len(names.q) == len(names.v) == axes + sum(link.modes.total for link in original.links)
    every = [*sum(names, ()), *(p.name for p in parameters(original))]
    assert len(set(every)) == len(every)
