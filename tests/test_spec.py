"""What robot files say, that both spellings say it, and the names and order of what follows from it."""

import math
import pickle
from pathlib import Path

import numpy
import pytest
from hypothesis import given
from hypothesis import strategies as st
from spec_parts import link, reloaded, robot

from screwgen.errors import RobotFileError, ScrewgenError
from screwgen.spec import (
    Body,
    Damping,
    Frequencies,
    Joint,
    Link,
    Modes,
    Mount,
    Section,
    coordinate_names,
    load,
    parameters,
)

EXAMPLES = Path(__file__).parent.parent / "examples"
STEEL = {"density": 7800.0, "area": 2.09e-4, "E": 2.1e11, "Iy": 1.0095e-8, "Iz": 1.7476e-8}


# The examples


def test_ella_is_the_arm_of_the_paper_and_python_builds_the_same():
    modes = Modes(basis="clamped_free", axial=1, bending_y=1, bending_z=1)
    upper = Link(
        name="upper_arm",
        length=0.95,
        section=Section(rhoA=1.6302, EA=4.38e7, EIy=2.12e3, EIz=3.67e3, rhoIp=2.15e-4),
        modes=modes,
        joint=Joint(axes=["y", "z"]),
        bodies=[Body(at="tip", mass=3.3)],
    )
    payload = Body(at="tip", mass=2.1)
    fore = link(name="forearm", length=0.93, section=Section(**STEEL), modes=modes, bodies=[payload])
    assert load(EXAMPLES / "ella_paper.toml") == robot(upper, fore, name="ella")


def test_ellas_links_have_one_profile_in_two_spellings():
    line, material = (link.section for link in load(EXAMPLES / "ella_paper.toml").links)
    assert material.rhoA == pytest.approx(line.rhoA, rel=1e-12)
    assert material.EIy == pytest.approx(line.EIy, rel=1e-4)
    assert material.EIz == pytest.approx(line.EIz, rel=1e-4)
    assert material.rhoIp == pytest.approx(line.rhoIp, rel=1e-3)
    assert abs(material.EA / line.EA - 1) < 3e-3  # the paper's 4.38e7 is rounded down


def test_six_link_is_spatial_flexible_and_complete():
    arm = load(EXAMPLES / "six_link.toml")
    letters = {(1.0, 0.0, 0.0): "x", (0.0, 1.0, 0.0): "y", (0.0, 0.0, 1.0): "z"}
    assert "".join(letters[axis] for link in arm.links for axis in link.joint.axes) == "zyyxyx"
    assert [link.modes.total for link in arm.links] == [0, 5, 4, 0, 0, 0]
    assert all(link.joint.armature for link in arm.links)
    assert arm.links[-1].bodies[0].inertia and arm.links[-1].bodies[0].com


@pytest.mark.parametrize("name", ["ella", "ella_paper", "six_link"])
def test_examples_survive_dump_and_load(name, tmp_path):
    example = load(EXAMPLES / f"{name}.toml")
    again = reloaded(example, tmp_path)
    assert again == example and hash(again) == hash(example)
    assert parameters(again) == parameters(example)


# Contents


def test_defaults_are_absent_not_zero():
    plain = link()
    assert plain.modes == Modes() and plain.modes.total == 0 and plain.bodies == ()
    assert plain.frame_at is plain.damping is plain.section.EA is None
    assert plain.joint.mount is plain.joint.armature is plain.joint.damping is plain.joint.stiffness is None


def test_a_stated_zero_is_not_an_absent_value(tmp_path):
    stated = robot(link(frame_at=0, section=Section(rhoA=1, EA=0, rhoIp=0), joint=Joint(axes=["z"], stiffness=[0])))
    assert stated != robot()
    again = reloaded(stated, tmp_path).links[0]
    assert (again.frame_at, again.section.EA, again.section.rhoIp, again.joint.stiffness) == (0, 0, 0, (0,))


def test_axes_are_normalised():
    skew = Joint(axes=["y", [3, 0, -4]])
    assert skew.axes == ((0.0, 1.0, 0.0), (0.6, 0.0, -0.8))


@pytest.mark.parametrize("size", [1e-320, 1e-160, 1.0, 1e160, 1e308])
def test_axes_of_any_size_are_normalised(size):
    (axis,) = Joint(axes=[[size, size, 0]]).axes
    assert axis == pytest.approx((math.sqrt(0.5), math.sqrt(0.5), 0))


def test_welded_joint_takes_empty_arrays():
    assert Joint(axes=[], armature=[]).armature == ()


def test_whole_numbers_are_numbers():
    assert type(link(length=2).length) is float


def test_arrays_of_numpy_are_arrays():
    body = Body(at="tip", mass=numpy.float32(2), com=numpy.array([0.0, 0.5, 0.0]))
    assert body == Body(at="tip", mass=2.0, com=(0.0, 0.5, 0.0))


@pytest.mark.parametrize(
    "inertia",
    [
        (0, 0, 0, 0, 0, 0),
        (1, 1, 1, 0, 0, 0),
        (0, 1, 1, 0, 0, 0),  # a rod
        (1, 1, 2, 0, 0, 0),  # a plate
        (0.5, 0.5, 1, -0.5, 0, 0),  # a rod askew
        (0.3333333, 0.6666667, 0.9999999, 0, 0, 0),  # a plate, to seven digits
        (1e-300, 1e-300, 1e-300, 0, 0, 0),
        (1e18, 1e18, 1e18, 0, 0, 0),
    ],
)
def test_inertias_that_a_body_has(inertia):
    body = Body(at="base", mass=1, inertia=inertia)
    assert body.inertia == inertia


def test_parts_are_frozen_and_hashable():
    bot = robot()
    with pytest.raises(ValueError, match="frozen"):
        bot.name = "other"
    assert {bot: 1}[robot()] == 1 and pickle.loads(pickle.dumps(bot)) == bot


# The two spellings of a section


def test_stated_spin_inertia_accompanies_either_spelling():
    assert Section(**STEEL, rhoIp=1e-3).rhoIp == Section(rhoA=1, rhoIp=1e-3).rhoIp == 1e-3


def test_spellings_mix_where_no_quantity_is_said_twice():
    assert Section(rhoA=2, E=2e11, Iy=1e-8) == Section(rhoA=2, EIy=2e11 * 1e-8)


def test_material_without_second_moments_has_no_spin_inertia():
    assert Section(density=7800, area=1e-4).rhoIp is None
    assert Section(density=7800, area=1e-4, E=2e11, Iy=1e-8).rhoIp is None


@given(st.floats(1e-3, 1e5), st.floats(1e-3, 1e3), *[st.floats(1e-3, 1e6)] * 5)
def test_both_spellings_are_equal(density, area, E, Iy, Iz, G, J):
    material = Section(density=density, area=area, E=E, Iy=Iy, Iz=Iz, G=G, J=J)
    line = Section(rhoA=density * area, EA=E * area, EIy=E * Iy, EIz=E * Iz, GJ=G * J, rhoIp=density * (Iy + Iz))
    assert material == line


# Building in Python


def test_link_count_comes_from_a_loop():
    arm = robot(*(link(name=f"link{i}") for i in range(40)))
    assert len(arm.links) == 40 and coordinate_names(arm).q[39] == "link39.joint[0]"


@pytest.mark.parametrize(
    ("build", "message"),
    [
        (lambda: link(length=-1), "Link arm: length: is -1; it must be > 0"),
        (lambda: link(frame_at="0"), 'Link arm: frame_at: is "0"; it must be a number'),
        (
            lambda: Modes(bending_y=1, frequencies={"bending_y": (3, 4)}),
            "Modes: frequencies.bending_y: has length 2; it must hold one frequency per mode, modes.bending_y = 1",
        ),
        (lambda: Frequencies(axial=[2, 1]), "Frequencies: axial[1]: is 1; it must be greater than the frequency"),
        (lambda: Modes(axial=True), "Modes: axial: is true; it must be a whole number from 0 to 32"),
        (lambda: Section(), "Section: rhoA: is missing; state mass per length, kg/m, > 0 (or density and area)"),
        (
            lambda: robot(link(), link()),
            'Robot bot: links[1].name (link arm): is "arm", the name of links[0]',
        ),
        (
            lambda: robot(links=iter([{"name": "a"}])),
            "Robot bot: links[0].joint: is missing; state the joint",
        ),
        (lambda: robot({"name": "a"}), "Robot bot: links[0].joint (link a): is missing; state the joint"),
    ],
)
def test_python_refuses_in_the_words_of_files(build, message):
    with pytest.raises(RobotFileError) as caught:
        build()
    assert str(caught.value).startswith(message) and "\n" not in str(caught.value)
    assert isinstance(caught.value, ScrewgenError)


# Parameters


def test_parameters_of_a_robot_that_states_everything():
    full = robot(
        link(
            name="a",
            frame_at=0.25,
            section=Section(rhoA=1, EA=2, EIy=3, EIz=4, GJ=5, rhoIp=6),
            damping=Damping(ratio=0.01),
            joint=Joint(
                axes=["y", "z"],
                mount=Mount(xyz=(1, 2, 3), rpy=(4, 5, 6)),
                armature=(0.1, 0.2),
                damping=(0.3, 0.4),
                stiffness=(0.0, 0.5),
            ),
            bodies=[
                Body(at="base", mass=7),
                Body(at="tip", mass=8, com=(1, 2, 3), inertia=(4, 4, 4, 0, 0, 1)),
            ],
        ),
        link(name="b"),
    )
    found = parameters(full)
    assert [p.name for p in found] == [
        *(f"gravity[{k}]" for k in range(3)),
        *(f"a.{name}" for name in ("length", "frame_at", "rhoA", "EA", "EIy", "EIz", "GJ", "rhoIp")),
        "a.damping.ratio",
        *(f"a.joint.mount.{name}[{k}]" for name in ("xyz", "rpy") for k in range(3)),
        *(f"a.joint.{name}[{j}]" for name in ("armature", "damping", "stiffness") for j in range(2)),
        "a.bodies[0].mass",
        "a.bodies[1].mass",
        *(f"a.bodies[1].com[{k}]" for k in range(3)),
        *(f"a.bodies[1].inertia[{k}]" for k in range(6)),
        "b.length",
        "b.rhoA",
    ]
    by_name = {p.name: p for p in found}
    assert by_name["a.joint.stiffness[0]"].value == 0.0
    last = by_name["a.bodies[1].inertia[5]"]
    assert (last.value, last.unit, last.link, last.field, last.index) == (
        1,
        "kg·m²",
        0,
        "bodies.inertia",
        (1, 5),
    )
    assert "yz" in last.description and "tip" in last.description
    assert by_name["gravity[2]"].link is None and by_name["b.rhoA"].link == 1
    assert all(p.unit and p.description for p in found)


def test_measured_frequencies_are_parameters_in_place_of_the_stiffness():
    frequencies = Frequencies(torsion=[300], bending_y=[20, 130.5])
    modes = Modes(bending_y=2, bending_z=1, torsion=1, frequencies=frequencies)
    measured = robot(link(section=Section(rhoA=1, EIy=3, rhoIp=6), modes=modes, damping=Damping(ratio=0)))
    found = parameters(measured)[3:]
    names = ("length", "rhoA", "EIy", "rhoIp", "bending_y[0]", "bending_y[1]", "torsion[0]", "damping.ratio")
    assert [p.name for p in found] == [f"arm.{'frequencies.' if '[' in n else ''}{n}" for n in names]
    assert [(p.value, p.unit, p.index) for p in found[4:7]] == [
        (20.0, "Hz", (0,)),
        (130.5, "Hz", (1,)),
        (300.0, "Hz", (0,)),
    ]
    assert modes.measured == ("bending_y", "torsion") and Modes(bending_y=2).measured == ()


def test_coordinates_are_joints_then_modes_link_by_link():
    stiff = Section(rhoA=1, EA=1, EIy=1, EIz=1, GJ=1, rhoIp=1)
    a = link(name="a", section=stiff, joint=Joint(axes=["y", "z"]), modes=Modes(axial=1, torsion=1))
    b = link(name="b", section=stiff, modes=Modes(bending_y=2, bending_z=1))
    names = coordinate_names(robot(a, b))
    joints = ("a.joint[0]", "a.joint[1]", "b.joint[0]")
    modes = ("a.axial[0]", "a.torsion[0]", "b.bending_y[0]", "b.bending_y[1]", "b.bending_z[0]")
    assert names.q == (*joints, *(name.replace(".", ".eta.") for name in modes))
    assert names.v == tuple(n.replace("joint", "joint_rate").replace("eta", "eta_rate") for n in names.q)
    assert names.tau == tuple(name.replace("joint", "torque") for name in joints)
    assert names.wrench[6:] == ("b.tau_x", "b.tau_y", "b.tau_z", "b.F_x", "b.F_y", "b.F_z")
