"""Drives in robot files: names, units and parameters, and ten kinds of wrong tables, each refused in one line."""

import pytest
from bad_robot_files import GOOD, refused
from drive_robots import ELASTIC, MIXED, mixed
from helpers import example, link, model_of

from screwgen import Robot, UsageError, derive, load
from screwgen.backends.latex import document as latex
from screwgen.elements import BEND, FALLING, FRICTION
from screwgen.plugins import plugins
from screwgen.spec import dump
from screwgen.spec.inputs import input_units
from screwgen.spec.parameters import coordinate_units, parameters

UPPER = "links[0].joint.drives"
BARE = link("bare", joint={"armature": [0.1]})
CHAIN = MIXED | {"links": MIXED["links"][:2]}
FULL = "ratio = 100.0, rotor_inertia = 1e-4, stiffness = 2e4, damping = 5.0"
DRY = "friction = { coulomb = 0.4, viscous = 0.1, velocity = 0.01 }"
WRONG = [
    ("[ {} ]", UPPER, "has length 1; it must hold one table per axis, 2; an empty one is no drive"),
    ("[ 100.0, {} ]", f"{UPPER}[0]", "is 100.0; it must be a table of ratio, rotor_inertia, stiffness, damping"),
    ("[ { ratio = 0.0, rotor_inertia = 1e-4 }, {} ]", f"{UPPER}[0].ratio", "is 0.0; it must be > 0"),
    ("[ { ratio = 50.0 }, {} ]", f"{UPPER}[0].ratio", "is stated without rotor_inertia, which it acts on"),
    ("[ { ratio = 50.0, stiffness = 1e4 }, {} ]", f"{UPPER}[0].rotor_inertia", "is missing; the rotor of an elastic"),
    ("[ { rotor_inertia = 1e-4, stiffness = -1.0 }, {} ]", f"{UPPER}[0].stiffness", "is -1.0; it must be > 0"),
    ("[ { rotor_inertia = 1e-4, damping = 1.0 }, {} ]", f"{UPPER}[0].damping", "is stated without stiffness"),
    ("[ { ratio = 9.0, rotor_inertia = 1e-4 }, {} ]", f"{UPPER}[0].rotor_inertia", "beside armature[0] = 0.1, which"),
    ("[ { friction = { coulomb = 0.4 } }, {} ]", f"{UPPER}[0].friction.velocity", "is missing; dry friction needs"),
    ("[ { friction = { viscous = 0.4, velocity = 1.0 } }, {} ]", f"{UPPER}[0].friction.velocity", "without coulomb"),
    ("[ { friction = {} }, {} ]", f"{UPPER}[0].friction", "states no friction; give { coulomb"),
    ("[ { friction = { coulomb = 1.0, velocity = 0 } }, {} ]", f"{UPPER}[0].friction.velocity", "it must be > 0"),
    ("[ { gear_ratio = 9.0 }, {} ]", f"{UPPER}[0].gear_ratio", "is an unknown key; did you mean ratio?"),
    ("[ { rotor_inertia = 1e20 }, {} ]", f"{UPPER}[0].rotor_inertia", "it must be from 1e-12 to 1e+12 kg·m²"),
    ("{}", UPPER, "is a table; it must be an array of tables"),
    ("[]", UPPER, "has length 0; it must hold one table per axis, 2"),
    ("[ {}, {}, {} ]", UPPER, "has length 3; it must hold one table per axis, 2"),
    ('[ {}, "harmonic" ]', f"{UPPER}[1]", 'is "harmonic"; it must be a table of ratio'),
    ('[ { ratio = "100:1", rotor_inertia = 1e-4 }, {} ]', f"{UPPER}[0].ratio", 'is "100:1"; it must be a number'),
    ("[ { ratio = -50.0, rotor_inertia = 1e-4 }, {} ]", f"{UPPER}[0].ratio", "is -50.0; it must be > 0"),
    ("[ { rotor_inertia = true }, {} ]", f"{UPPER}[0].rotor_inertia", "is true; it must be a number"),
    ("[ { friction = 0.4 }, {} ]", f"{UPPER}[0].friction", "is 0.4; it must be a table of coulomb, viscous, velocity"),
    ("[ { friction = { velocity = 0.1 } }, {} ]", f"{UPPER}[0].friction", "states no friction; give { coulomb"),
    ("[ { friction = { viscous = nan } }, {} ]", f"{UPPER}[0].friction.viscous", "is nan; it must be a finite number"),
    ("[ { backlash = 0.1 }, {} ]", f"{UPPER}[0].backlash", "is an unknown key; known here: ratio, rotor_inertia"),
]


@pytest.mark.parametrize(("drives", "where", "fragment"), WRONG)
def test_wrong_drives_are_refused_in_one_line(tmp_path, drives, where, fragment):
    refused(tmp_path, GOOD.replace("[0.1, 0.2]", f"[0.1, 0.2]\ndrives = {drives}"), where, fragment)


def test_a_single_axis_needs_no_brackets_and_files_are_written_as_read(tmp_path):
    path = tmp_path / "bot.toml"
    path.write_text(GOOD.replace('axes = ["z"] }', f'axes = ["z"], drives = {{ {FULL}, {DRY} }} }}'), "utf-8")
    robot = load(path)
    (drive,) = robot.links[1].joint.drives
    assert (drive.ratio, drive.friction.velocity) == (100.0, 0.01) and drive.elastic
    path.write_text(dump(robot), "utf-8")
    assert load(path) == robot


def test_no_drive_costs_nothing():
    bare = {**MIXED, "links": [dict(x, joint={"axes": x["joint"]["axes"]}) for x in MIXED["links"]]}
    none = lambda axes: {"axes": axes, "drives": [{}] * len(axes)}  # noqa: E731
    empty = {**bare, "links": [x | {"joint": none(x["joint"]["axes"])} for x in bare["links"]]}
    assert [k.drives for k in model_of(empty).chain.keys] == [()] * 4
    assert model_of(empty).chain.classes == model_of(bare).chain.classes


def test_names_and_units():
    model = mixed()
    rotors = ["cart.theta[0]", "boom.theta[1]", "hand.theta[0]"]
    assert model.q_names[7:10] == rotors and model.v_names[8] == "boom.theta_rate[1]"
    assert model.tau_names[0] == "cart.torque[0]" and model.tau_names[-1] == "tool.force[0]"
    assert coordinate_units(model.robot)[:10] == ["m", *["rad"] * 5, "m", *["rad"] * 3]
    assert input_units(model.robot) == [*["N·m"] * 6, "N"]
    acted = {law: [x.coordinate for x in model.chain.acted(law)] for law in (FRICTION, FALLING, BEND)}
    assert acted == {FRICTION: [1, 8, 9], FALLING: [6], BEND: [5, 6]}
    assert model.chain.effort_places == [7, 1, 8, 9, 4, 5, 6]
    assert [name for name in model.dae_names["x"] if ".theta[" in name] == rotors
    assert not [name for name in model.dae_names["z"] if "theta" in name]


def test_parameters_have_names_units_and_limits():
    model = mixed()
    of = {x.name: x for x in parameters(model.robot)}
    assert of["cart.joint.drives[0].ratio"].unit == "rad/m" and of["cart.joint.drives[0].stiffness"].unit == "N/m"
    assert of["boom.joint.drives[1].friction.coulomb"].unit == "N·m"
    assert of["tool.joint.drives[0].friction.coulomb"].unit == "N"
    for name, value in (("cart.joint.drives[0].ratio", 0.0), ("tool.joint.drives[0].friction.velocity", -1.0)):
        with pytest.raises(UsageError, match="must be > 0"):
            model.numpy({name: value})


def test_documents_have_the_equations_of_drives():
    shown = latex.content(mixed().robot, plugins())
    text = latex.tex(shown)
    assert text.count(r"\ddot{\vartheta}") == 1 and "angle of the rotor of an elastic drive" in text
    assert "elastic drives; rigid gears; friction" in text and "3 of rotors" in text
    assert r"\vartheta" not in latex.tex(latex.content(model_of(MIXED | {"links": [BARE]}).robot, plugins()))


def test_the_z_form_and_the_printed_system_refuse_rotors():
    with pytest.raises(UsageError, match="the Z-form has no rotors; leave out the stiffness of drives"):
        model_of(CHAIN).cauchy_names  # noqa: B018
    assert "assemble_z" not in model_of(CHAIN).casadi()
    rigid = MIXED | {"links": [link("a", joint={"drives": [ELASTIC]})]}
    with pytest.raises(UsageError, match="the paper has neither gears nor friction nor stops"):
        derive(Robot.model_validate(rigid), formulation="printed")


def test_the_readme_of_casadi_knows_where_the_states_of_the_dae_stand():
    readme = mixed().casadi_files(["assemble", "dae"])["README.md"].decode()
    assert "rotors' angles" in readme and "rate of rotors' rates" in readme


def test_the_example_has_seven_axes_and_six_rotors():
    chain = example("elastic_joint").chain
    assert (chain.n_tau, chain.n_added, chain.nq) == (7, 6, 23) and len(chain.acted(FRICTION)) == 6
