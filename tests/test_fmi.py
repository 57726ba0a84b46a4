"""Functional mock-up units: what fmpy says of them, and what they compute against the C and CasADi."""

import subprocess
import xml.etree.ElementTree as ElementTree
import zipfile

import casadi as ca
import numpy as np
import pytest
from conftest import require_tool
from fmi_units import FORMS, Unit, small, written
from fmpy import simulate_fmu
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import fmi2LastSuccessfulTime
from fmpy.validation import validate_fmu
from helpers import arm, link, model_of, quick, relative

from screwgen.algorithms import fused
from screwgen.algorithms.response import Response
from screwgen.algorithms.robot_functions import BY_NAME
from screwgen.backends.casadi.functions import coordinate_rates, expressions, side_by_side
from screwgen.backends.fmi import description
from screwgen.backends.fmi.units import exponents, spelled
from screwgen.backends.fmi.variables import variables
from screwgen.bodies.validity import MEASURES
from screwgen.errors import TargetWarning
from screwgen.integrators import METHODS

TARGETS = ("fmu2", "fmu3")
START = {"boom.joint[0]": 0.3, "boom.joint[1]": -0.4, "load.slide[0]": 0.1, "boom.joint_rate[1]": 0.5}
CHANGED = {"load.bodies[0].mass": 2.0, "gravity[2]": -1.6}
every_form = pytest.mark.parametrize(("target", "kind"), FORMS)
every_target = pytest.mark.parametrize("target", TARGETS)


def state_of(unit: Unit) -> tuple[np.ndarray, np.ndarray]:
    return unit.get(unit.model.q_names), unit.get(unit.model.v_names)


def pushed(unit: Unit, seed=0) -> Unit:
    """With all states, torques and wrenches at random values."""
    rng, m = np.random.default_rng(seed), unit.model
    scale = [0.1 if ".eta" in name else 1.0 for name in unit.states]
    unit.ready(**dict(zip(unit.states, scale * rng.normal(size=m.nq + m.nv), strict=True)))
    unit.set(dict(zip(unit.inputs, rng.normal(size=len(unit.inputs)), strict=True)))
    return unit


@every_target
@pytest.mark.parametrize("method", METHODS)
def test_a_step_is_that_of_the_c(target, method):
    """One internal step per communication step, and ten: bit for bit."""
    unit = pushed(Unit(target, "cs"))
    q, v = state_of(unit)
    u = unit.get(unit.inputs)
    unit.choose(list(METHODS).index(method) + 1)
    unit.set({"solver.step": 1e-3})
    m, c = unit.model, quick(unit.model)
    for k, (h, count) in enumerate(((1e-3, 1), (1e-2, 10))):
        unit.step(k * 1e-3, h)
        q, v = c.step(q, v, u[: m.n_tau], u[m.n_tau :].reshape(-1, 6), h / count, method, count)
        assert [x.tobytes() for x in state_of(unit)] == [q.tobytes(), v.tobytes()]


@every_form
def test_outputs_are_those_of_the_model(target, kind):
    unit = pushed(Unit(target, kind))
    m, c = unit.model, quick(unit.model)
    q, v = state_of(unit)
    u = unit.get(unit.inputs)
    vdot, wrench = c.forward_dynamics(q, v, u[: m.n_tau], u[m.n_tau :].reshape(-1, 6))
    kinetic, potential = c.energy(q, v)
    assert (unit.get([f"der({name})" for name in m.q_names]) == v).all()
    assert (unit.get([f"der({name})" for name in m.v_names]) == vdot).all()
    assert (unit.get(m.wrench_names) == wrench.ravel()).all()
    assert relative(unit.get(["energy.kinetic", "energy.potential"]), [kinetic, potential]) < 1e-13
    R, position = m.numpy().tip_pose(q)
    assert relative(unit.get([f"load.tip.position.{x}" for x in "xyz"]), position) < 1e-13
    assert relative(unit.get([f"load.tip.rotation[{i},{k}]" for i in range(3) for k in range(3)]), R.ravel()) < 1e-13
    measures = c.validity(q, v, u[: m.n_tau], u[m.n_tau :].reshape(-1, 6))
    assert (unit.get([f"boom.validity.{x}" for x in MEASURES]) == measures[0]).all()


@every_form
def test_what_sensors_measure_is_an_output_of_units_that_are_asked_for_it(target, kind):
    assert validate_fmu(str(written(target, small, True)[1])) == []
    unit = pushed(Unit(target, kind, small, True))
    m, (q, v), u = unit.model, state_of(unit), unit.get(unit.inputs)
    R, position = m.numpy().marker_pose(q)
    expected = {
        "gyro.omega": m.numpy().gyro(q, v),
        "accelerometer.a": m.numpy().accelerometer(q, v, u[: m.n_tau], u[m.n_tau :].reshape(-1, 6)),
        "marker_velocity.twist": m.numpy().marker_velocity(q, v),
        "marker_pose.position": position,
        "marker_pose.R": R,
    }
    for what, values in expected.items():
        names = [x for x in unit.references if f".{what}" in x]
        assert [x.partition(f".{what}")[0] for x in names[:: values[0].size]] == m.marker_names
        assert relative(unit.get(names), values.ravel()) < 1e-12
    (strain,) = m.numpy().strain(q)
    assert relative(unit.get(m.strain_names), [strain]) < 1e-13
    assert not [x for x in Unit(target, kind).references if "gyro" in x]


def responses(model) -> ca.Function:
    """``(x, u) -> (J)`` by CasADi: the derivatives of all rates of states and outputs with states and inputs."""
    chain = model.chain
    sizes = {"q": (chain.nq, 1), "v": (chain.nv, 1), "tau": (chain.n_tau, 1), "w_ext": (6, chain.n)}
    given = {name: ca.SX.sym(name, *size) for name, size in sizes.items()} | {"p": ca.DM(model.parameter_values)}
    dynamics, poses = expressions(fused.forward_dynamics(chain), given), expressions(fused.poses(chain), given)
    energy, tips = expressions(fused.energy(chain), given), chain.lasts
    R = side_by_side(poses["tip_R"], 3, 3)
    strains = expressions(BY_NAME["strain"].program(chain), given)["strain"]
    parts = [coordinate_rates(chain, given["q"], given["v"], given["p"]), dynamics["vdot"], given["q"], given["v"]]
    parts += [poses["tip_position"][3 * i : 3 * i + 3] for i in tips]
    parts += [ca.vec(R[:, 3 * i : 3 * i + 3].T) for i in tips]
    parts += [dynamics["wrench"], strains, energy["kinetic"], energy["potential"]]
    parts.append(expressions(BY_NAME["drive_power"].program(chain), given)["power"])
    point = ca.vertcat(*(ca.vec(given[name]) for name in sizes))
    return ca.Function("responses", [point], [ca.jacobian(ca.vertcat(*parts), point)])


def by_rows(found, expected) -> float:
    """The worst row, each beside its own largest entry."""
    return max(map(relative, found, expected))


@every_target
def test_derivatives_are_those_of_casadi(target):
    """Along every direction, against every one (FMI 3.0), and nothing where the structure says so."""
    unit = pushed(Unit(target, "me"))
    knowns, unknowns = unit.of(unit.states + unit.inputs), unit.of(unit.unknowns)
    expected = np.array(responses(unit.model)(unit.get(unit.states + unit.inputs)))
    columns = [unit.fmu.getDirectionalDerivative(unknowns, [known], [1.0]) for known in knowns]
    assert by_rows(np.transpose(columns), expected) < 1e-12
    if target == "fmu3":
        rows = [unit.fmu.getAdjointDerivative([unknown], knowns, [1.0], len(knowns)) for unknown in unknowns]
        assert by_rows(rows, expected) < 1e-12
    listed = [*unit.description.derivatives, *unit.description.outputs]
    depends = [{x.valueReference for x in unknown.dependencies} for unknown in listed]
    stated = np.array([[known in own for known in knowns] for own in depends])
    assert not expected[~stated].any() and stated.sum() < 0.8 * stated.size


def small_ode(unit: Unit, times) -> np.ndarray:
    """The states at the times by CasADi's cvodes."""
    m = unit.model
    problem = m.casadi()["ode"]
    tools = {"abstol": 1e-10, "reltol": 1e-10}
    solver = ca.integrator("solver", "cvodes", problem, 0.0, list(times), tools)
    u = np.zeros(m.n_tau + 6 * m.n_links)
    start = unit.get(unit.states)
    return np.array(solver(x0=start, p=m.parameter_values, u=np.tile(u[:, None], len(times)))["xf"])


@every_target
def test_model_exchange_with_cvode_is_casadi_with_cvodes(target):
    unit = Unit(target, "me").ready(**START)
    times = np.linspace(0.05, 0.5, 10)
    expected = small_ode(unit, times)
    run = simulate_fmu(
        str(written(target)[1]), fmi_type="ModelExchange", stop_time=0.5, output_interval=0.05, start_values=START,
        relative_tolerance=1e-9, output=unit.states, solver="CVode",
    )  # fmt: skip
    found = np.array([run[name] for name in unit.states])
    assert relative(found[:, 1:], expected) < 1e-5


@every_target
def test_a_serialised_state_begins_the_same_run(target):
    """In another instance too, with parameters and inputs."""
    unit = pushed(Unit(target, "cs"))
    unit.set({"load.bodies[0].mass": 1.3})
    unit.step(0.0, 0.01)
    states = "FMUstate" if target == "fmu2" else "FMUState"
    call = lambda instance, what: getattr(instance.fmu, f"{what}{states}")  # noqa: E731
    kept = call(unit, "get")()
    data = call(unit, "serialize")(kept)
    ends = []
    for instance in (unit, Unit(target, "cs").ready()):
        state = call(instance, "deSerialize" if target == "fmu2" else "deserialize")(data)
        call(instance, "set")(state)
        instance.step(0.01, 0.02)
        ends.append([*(x.tobytes() for x in state_of(instance)), instance.get(["load.bodies[0].mass"])[0]])
    unit.step(0.03, 0.01)
    call(unit, "set")(kept)
    unit.step(0.01, 0.02)
    ends.append([*(x.tobytes() for x in state_of(unit)), 1.3])
    assert ends[0] == ends[1] == ends[2]


@every_target
def test_parameters_are_tunable(target):
    """What is set counts from the next evaluation, as with the C; values that no robot has are refused."""
    unit = Unit(target, "cs").ready(**START)
    unit.set(CHANGED)
    m = unit.model
    p = dict(zip(m.parameter_names, m.parameter_values, strict=True)) | CHANGED
    q, v = state_of(unit)
    vdot, _ = m.numpy(list(p.values())).forward_dynamics(q, v, np.zeros(m.n_tau), np.zeros((m.n_links, 6)))
    assert relative(unit.get([f"der({name})" for name in m.v_names]), vdot) < 1e-12
    unit.set({"load.bodies[0].mass": -2.0})
    with pytest.raises(FMICallException):
        unit.step(0.0, 1e-3)
    assert [x.tobytes() for x in state_of(unit)] == [q.tobytes(), v.tobytes()]
    unit.set({"load.bodies[0].mass": 0.7})
    unit.step(0.0, 1e-3)


def wrist() -> dict:
    """Three axes x, z, x in line at q = 0, where the middle one is turned through zero by its rate."""
    return arm(link("wrist", 0.4, "xzx"), link("hand", 0.3, "y")) | {"name": "wrist"}


@every_target
def test_a_singular_posture_is_discarded(target):
    """The state is that before the step, and the message names the joint."""
    unit = Unit(target, "cs", wrist).ready()
    before = [x.tobytes() for x in state_of(unit)]
    for _ in range(2):
        with pytest.raises(FMICallException):
            unit.step(0.0, 1e-2)
        assert [x.tobytes() for x in state_of(unit)] == before
    with pytest.raises(FMICallException):
        unit.get(["der(wrist.joint_rate[0])"])
    if target == "fmu2":
        assert unit.fmu.getRealStatus(fmi2LastSuccessfulTime) == 0.0
    unit = Unit(target, "cs", wrist).ready(**{"wrist.joint[1]": 0.5})
    unit.step(0.0, 1e-2)


def test_a_step_into_a_singular_posture_ends_early():
    """With early return: at the last internal step that succeeded, with an event, and then terminated."""
    start = {"wrist.joint[1]": -0.01, "wrist.joint_rate[1]": 1.0, "solver.step": 1e-3, "gravity[2]": 0.0}
    unit = Unit("fmu3", "cs", wrist).ready(early=True, events=True, **start)
    unit.choose(list(METHODS).index("euler") + 1)
    event, terminate, early, last = unit.step(0.0, 0.1)
    assert early and event and not terminate and 0.005 < last < 0.02
    unit.fmu.enterEventMode()
    assert unit.fmu.updateDiscreteStates()[1]


@every_target
def test_terminals_and_units(target):
    """Every unit has its exponents, every terminal's member is a variable."""
    _, path = written(target)
    with zipfile.ZipFile(path) as archive:
        description = ElementTree.fromstring(archive.read("modelDescription.xml"))
        units = {x.get("name"): x.find("BaseUnit").attrib for x in description.find("UnitDefinitions")}
        assert units["N.m.s/rad"] == {"kg": "1", "m": "2", "s": "-1", "rad": "-1"}
        assert units["N.m2"] == {"kg": "1", "m": "3", "s": "-2"} and units["1"] == {}
        assert any(name.startswith("binaries/") for name in archive.namelist())
        if target == "fmu3":
            terminals = ElementTree.fromstring(archive.read("terminalsAndIcons/terminalsAndIcons.xml"))
            named = {x.get("variableName") for x in terminals.iter("TerminalMemberVariable")}
            known = {x.get("name") for x in description.find("ModelVariables")}
            names = [x.get("name") for x in terminals.iter("Terminal")]
            assert named <= known and names[:2] == ["boom.joint[0]", "boom.joint[1]"] and names[-1] == "load.tip"


def test_a_unit_that_the_si_has_not_is_known_by_its_name():
    """A force of one's own may state what it likes, and electric units are taken to pieces."""
    assert exponents("bar") is None and exponents("N/bar") is None and exponents("1") == {}
    assert exponents("Pa") == exponents("N/m²") and exponents("V·A") == exponents("W") and spelled("Ω·m") == "Ohm.m"


def test_axes_behind_ball_joints_and_tendons_are_terminals():
    """A member is a coordinate of the axis, also where a quaternion precedes it; a tendon has all that it reports."""
    tendon = {"name": "flexor", "at": [[0.0, 0.03, 0.0], [0.0, 0.02, 0.0]]}
    soft = {"modes": {"bending_y": 1}, "tendons": [tendon]}
    chain = model_of(arm(link("a", joint={"axes": "ball"}), link("b", 0.5, "yz", **soft))).chain
    answers = Response(chain)
    found = variables(answers, list(METHODS), False)
    listed = ElementTree.fromstring(description.terminals(answers, found)).iter("Terminal")
    members = {x.get("name"): {m.get("memberName"): m.get("variableName") for m in x} for x in listed}
    assert members["b.joint[0]"] == dict(coordinate="b.joint[0]", rate="b.joint_rate[0]", force="b.torque[0]")
    assert members["flexor"] == {what: f"flexor.{what}" for what in ("tension", "length", "power")}


@every_target
def test_what_cannot_be_set_is_refused(target):
    unit = Unit(target, "cs").ready()
    for name in ("energy.kinetic", "der(boom.joint[0])", "boom.joint[0]", *(["time"] if target == "fmu3" else [])):
        with pytest.raises(FMICallException):
            unit.set({name: 1.0})
    with pytest.raises(FMICallException):
        unit.set({"solver.step": 0.0})
    with pytest.raises(FMICallException):
        unit.choose(len(METHODS) + 1)
    with pytest.raises(FMICallException):
        unit.fmu.enterInitializationMode()
    unit.step(0.0, 1e-3)
    other = Unit(target, "cs")
    other.fmu.guid = "{other}"
    with pytest.raises(Exception, match=r"[Ff]ail"):
        other.fmu.instantiate()


@every_target
def test_sources_compile_without_warnings(target, tmp_path):
    """For this machine and for a microcontroller; the unit's own sources alone, with those of the standard."""
    with zipfile.ZipFile(written(target)[1]) as archive:
        archive.extractall(tmp_path)
    files = [f"fmu{target[-1]}.c", "small_response.c"]
    for compiler, more in (("gcc", ()), ("arm-none-eabi-gcc", ("-mcpu=cortex-m7",))):
        command = [require_tool(compiler), *more, "-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", *files]
        done = subprocess.run(command, cwd=tmp_path / "sources", capture_output=True, text=True)
        assert done.returncode == 0, done.stderr


def test_units_are_the_same_every_time(tmp_path, monkeypatch):
    """Descriptions and sources, byte by byte; what is compiled of them is left out here."""
    _, path = written("fmu3")
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.warns(TargetWarning, match="sources alone"):
        model_of(small()).write(tmp_path / "again", targets=("fmu3",))
    with zipfile.ZipFile(path) as first, zipfile.ZipFile(tmp_path / "again" / "fmu3" / "small.fmu") as second:
        names = [name for name in first.namelist() if not name.startswith("binaries/")]
        assert names == second.namelist() and len(names) > 10
        assert all(first.read(name) == second.read(name) for name in names)
        assert {first.getinfo(name).date_time for name in names} == {(1980, 1, 1, 0, 0, 0)}
