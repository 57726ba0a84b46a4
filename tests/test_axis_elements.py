"""Elements of joint axes: preloaded springs in robot files, at rest, in vibrations, in motion, in documents."""

from dataclasses import dataclass

import numpy as np
import pytest
from bad_robot_files import refused
from helpers import arm, link, model_of, quick, relative

from screwgen import Robot, RobotFileError, UsageError, dump, equilibrium, natural_frequencies, simulate
from screwgen.backends.latex import document as latex
from screwgen.elements import KINDS, AxisElement, key
from screwgen.interchange.urdf_write import export_urdf
from screwgen.spec.load import loads
from screwgen.spec.parameters import parameters

SPRING = {"spring": {"stiffness": 80.0, "rest": 0.4}}


@dataclass(frozen=True)
class Detent(AxisElement):
    """A force that falls where the axis is half way to the next of the postures in which it is held."""

    KIND = "detent"
    WORDS = "detents"
    FORMULA = r"T\,\sin(n\,q)"

    torque: float = key("N·m", "N", "largest torque", "T", sign="positive")
    count: float = key("1/rad", "1/m", "number in 2π", "n", sign="positive")

    @staticmethod
    def force(t, x, w, torque, count):
        return torque * t.call("sin", count * x)


def sprung(elements=SPRING, **more):
    joint = {"elements": elements, "damping": [0.5]} | more
    return arm(link("boom", 0.8, ("y",), modes={"bending_z": 1}, section={"EIy": 900.0}, joint=joint))


def test_rest_and_vibrations_know_it():
    model, bare = model_of(sprung()), model_of(sprung({}, stiffness=[80.0]))
    held = equilibrium(model)
    same = equilibrium(bare, tau=[32.0])
    assert relative(held.q, same.q) < 1e-9
    assert relative(natural_frequencies(model, held.q), natural_frequencies(bare, same.q)) < 1e-9
    assert natural_frequencies(model, held.q)[0] > 0.5


def test_a_file_states_it_and_it_reads_back():
    robot = Robot(**sprung())
    assert "elements = [{ spring = { stiffness = 80.0, rest = 0.4 } }]" in dump(robot)
    assert loads(dump(robot), "robot.toml") == robot
    own = {p.name: (p.value, p.unit) for p in parameters(robot) if ".elements[" in p.name}
    assert own == {
        "boom.joint.elements[0].spring.stiffness": (80.0, "N·m/rad"),
        "boom.joint.elements[0].spring.rest": (0.4, "rad"),
    }


def test_a_spring_may_be_relaxed_on_either_side_and_numbers_are_checked_as_in_a_file():
    model = model_of(sprung({"spring": {"stiffness": 80.0, "rest": -0.4}}))
    name = "boom.joint.elements[0].spring."
    other = {f"{name}rest": 0.4}
    found = simulate(model, 0.01, 1e-3, parameters=other).q[-1]
    assert relative(found, simulate(model_of(sprung()), 0.01, 1e-3).q[-1]) < 1e-12
    with pytest.raises(UsageError, match=r"spring.stiffness is 0; it must be > 0"):
        simulate(model, 0.01, 1e-3, parameters={f"{name}stiffness": 0.0})


def test_on_an_axis_that_slides_it_has_units_of_length():
    robot = Robot(**arm(link("cart", 0.5, [{"slide": "x"}], joint={"elements": SPRING})))
    assert [p.unit for p in parameters(robot) if ".elements[" in p.name] == ["N/m", "m"]


@pytest.mark.parametrize(
    ("elements", "said"),
    [
        (3.0, "elements .link boom.: is 3.0; it must be an array with a table for each axis"),
        ([{}, {}], "elements .link boom.: has length 2; it must hold one table per axis, 1; an empty"),
        ({"sprung": {}}, r"elements\[0\].sprung .link boom.: is an unknown key; did you mean spring"),
        ({"spring": 2.0}, r"elements\[0\].spring .link boom.: is 2.0; it must be a table of stiffness, rest"),
        ({"spring": {"rest": 0.1}}, r"spring.stiffness .link boom.: is missing; state the stiffness of the spring"),
        ({"spring": {"stiffness": 0.0, "rest": 0.1}}, "spring.stiffness .link boom.: is 0.0; it must be > 0"),
        ({"spring": {"stiffness": 1.0, "rest": "x"}}, "spring.rest .link boom.: is .x.; it must be a number"),
        ({"spring": {"stiffness": 1.0, "rest": 0.0, "k": 1}}, "spring.k .link boom.: is an unknown key"),
    ],
)
def test_what_is_wrong_is_said_with_its_key(elements, said):
    with pytest.raises(RobotFileError, match=said):
        Robot(**sprung(elements))


def test_documents_show_each_kind():
    page = latex.page(latex.content(Robot(**sprung())))
    assert KINDS["spring"].WORDS in page


def test_a_damaged_file_is_refused_in_a_line(tmp_path):
    text = dump(Robot(**sprung())).replace("stiffness = 80.0", "stiffness = nan")
    refused(tmp_path, text, "links[0].joint.elements[0].spring.stiffness (link boom)", "it must be a finite number")


def test_a_urdf_says_that_it_lacks_them():
    assert "boom.joint.elements: are left out; URDF has no such elements" in export_urdf(Robot(**sprung())).notes


@pytest.mark.parametrize("name", ["modal_implicit", "modal_midpoint"])
@pytest.mark.parametrize("step", [1e-3, 5e-3, 2e-2])
def test_a_long_step_moves_the_right_way_where_a_force_falls(name, step):
    """From beside the top it falls back, with much less inertia than the tangent would take from it."""
    model = model_of(sprung([Detent(2000.0, 12.0)]))
    given = [0.99 * np.pi / 12, 0.0], [0.0, 0.0], [0.0]
    found = quick(model).step(*given, None, step, name)[1]
    expected = model.casadi()[f"step_{name}"](*given, np.zeros((6, 1)), model.parameter_values, step)[1]
    assert found[0] < 0 and relative(found, expected.full().ravel()) < 1e-12
