"""Drives, limits and elements beside a ball joint, whose coordinates stand at other places in q than their rates in v.

Forces and their slopes are judged in `conformance/`, by pairs with every other feature.
"""

from dataclasses import dataclass

import numpy as np
import pytest
from floating_robots import rod
from helpers import model_of, quick, quick_batch, relative

from screwgen import LimitWarning, equilibrium, rollout, simulate
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.backends.numpy.travel_numbers import ahead_of_joints
from screwgen.elements import HeldLaw, key
from screwgen.simulation.simulate import stepper
from screwgen.studies.stiffness import pressed

GEAR = {"ratio": 8.0, "rotor_inertia": 2e-3, "stiffness": 60.0, "damping": 0.4}
STRUT = {"ratio": 30.0, "rotor_inertia": 2e-3, "stiffness": 4e3, "damping": 9.0}
STRUT |= {"transmission": {"base": 0.5, "crank": 0.2, "angle": 1.1}}
STOP = {"lower": -0.2, "upper": 0.1, "stiffness": 900.0, "damping": 3.0}
ARM = {
    "name": "arm",
    "gravity": [0.3, -0.4, -9.7],
    "links": [
        rod("boom", ["z"]),
        {**rod("hand", []), "joint": {"axes": "ball"}},
        {**rod("fore", ["y", "z"]), "joint": {"axes": ["y", "z"], "drives": [GEAR, STRUT], "limits": [STOP, {}]}},
    ],
}


@dataclass(frozen=True)
class EndSwitch(HeldLaw):
    """A drive that gives nothing beyond a coordinate."""

    KIND, WORDS, FORMULA, SAID = "switch", "end switches", r"\tau", "off at its end switch"
    end: float = key("rad", "m", "coordinate beyond which the drive gives nothing", "x_0")

    @staticmethod
    def held(t, tau, x, w, end):
        return tau * t.call("on", end - x)


@pytest.fixture(scope="module", params=[False, True], ids=["fixed", "floating"])
def model(request):
    """On a fixed base; on a floating one, whose first link has no axes."""
    hull = {**rod("hull", []), "joint": {"axes": []}}
    links = [hull, *ARM["links"]] if request.param else ARM["links"]
    return model_of(ARM | {"links": links} | ({"base": "floating"} if request.param else {}))


def test_coordinates_of_axes_rotors_and_modes_stand_where_their_names_do(model):
    chain, names = model.chain, dict(zip(model.q_names, range(model.nq), strict=True))
    rates = {name.replace("_rate", ""): k for k, name in enumerate(model.v_names) if "hand.joint" not in name}
    places = {name: k for name, k in rates.items() if k >= chain.base_v}
    assert places.keys() >= {"boom.joint[0]", "fore.joint[0]", "fore.joint[1]", "fore.theta[0]", "fore.stretch[1]"}
    for name, k in places.items():
        assert chain.place_in_q(k) == names[name], name
    turns = [f"hand.joint[{k}]" for k in range(3)]
    assert chain.axis_names == ["boom.joint[0]", *turns, "fore.joint[0]", "fore.joint[1]"]


def test_joints_alone_leave_gears_without_load(model):
    joints = [0.3, 0.5, 0.5, -0.5, 0.5, -0.2, 0.4]
    q = model.chain.complete(np.array(joints), model.parameter_values)
    at = dict(zip(model.q_names, q, strict=True))
    assert at["fore.theta[0]"] == 8.0 * at["fore.joint[0]"] == 8.0 * -0.2
    assert at["fore.stretch[1]"] == 0.0


def test_a_stop_presses_on_its_own_axis(model):
    joint = model.q_names.index("fore.joint[0]")
    q = np.array(model.chain.home)
    for depth, stiff in ((-0.01, 0.0), (0.01, 900.0)):
        q[joint] = 0.1 + depth
        found = pressed(model, q)
        assert found[model.v_names.index("fore.joint_rate[0]")] == stiff
        assert np.count_nonzero(found) == (stiff > 0)


def test_how_far_a_rotor_is_ahead_is_that_of_its_own_joint(model):
    """The travel at the joint where a rigid gear would have it is longer by the stretch; rates are its slope."""
    chain, p, rng = model.chain, model.parameter_values, np.random.default_rng(4)
    q, v = np.array(chain.home), rng.normal(size=model.nv)
    q[model.q_names.index("fore.joint[1]")], q[model.q_names.index("fore.stretch[1]")] = 0.4, 0.01
    length = lambda x: np.sqrt(0.5**2 + 0.2**2 - 2 * 0.5 * 0.2 * np.cos(1.1 + x))  # noqa: E731
    ahead, faster = ahead_of_joints(chain, q, v, p)
    assert length(0.4 + ahead[-1]) - length(0.4) == pytest.approx(0.01, abs=1e-14)
    assert not ahead[:-1].any() and not faster[:-1].any()
    moved = [ahead_of_joints(chain, chain.integrate(q, s * 1e-6 * v, SERIES), v, p)[0][-1] for s in (1, -1)]
    assert (moved[0] - moved[1]) / 2e-6 == pytest.approx(faster[-1], rel=1e-8)


def test_hits_of_a_stop_are_those_of_its_axis(model):
    """Those that the loop in C finds are those that Python finds, and as deep as the axis goes in the samples."""
    q0 = np.array(model.chain.home)
    q0[model.q_names.index("fore.joint[0]")] = 0.05
    v0 = np.zeros(model.nv)
    v0[model.v_names.index("fore.joint_rate[0]")], v0[model.v_names.index("fore.theta_rate[0]")] = 2.0, 8.0 * 2.0
    compiled, plain = (
        simulate(model, 0.06, 1e-3, q0, v0, None, None, "modal_implicit", backend=backend) for backend in ("c", "numpy")
    )
    assert compiled.hits and relative(compiled.q, plain.q) < 1e-9
    for found in (compiled, plain):
        assert {(hit.axis, hit.side) for hit in found.hits} == {("fore.joint[0]", "upper")}
        deep = found.q[:, model.q_names.index("fore.joint[0]")].max() - 0.1
        assert found.hits[0].depth == pytest.approx(deep, rel=1e-12)


@pytest.mark.parametrize("method", ["rk4", "modal_implicit"])
@pytest.mark.parametrize("base", ["fixed", "floating"])
def test_what_a_step_holds_reads_the_coordinate_of_its_axis(base, method):
    """Of two equal drives that which is beyond its end is off: a step equals that of the robot without switches."""

    def robot(*ends):
        hull = [{**rod("hull", []), "joint": {"axes": []}}] * (base == "floating")
        own = {"elements": [EndSwitch(end) for end in ends]} if ends else {}
        links = [*hull, *ARM["links"][:2], {**rod("fore", []), "joint": {"axes": ["y", "z"]} | own}]
        return model_of(ARM | {"links": links, "base": base})

    model, bare, h = robot(0.1, 0.1), robot(), 1e-3
    q, v, w_ext = np.array(model.chain.home), np.zeros(model.nv), np.zeros((model.n_links, 6))
    for name, x in (("boom.joint[0]", 0.05), ("fore.joint[0]", -0.3), ("fore.joint[1]", 0.3)):
        q[model.q_names.index(name)] = x
    tau = np.array([0.5, 0.2, -0.1, 0.3, 2.0, 2.0])
    given, plain = tau * [1, 1, 1, 1, 1, 0], stepper(bare, method)
    want = np.concatenate(plain.step(plain.initial(q, v), given, w_ext, h))
    own, c = stepper(model, method), quick(model)
    assert relative(np.concatenate(own.step(own.initial(q, v), tau, w_ext, h)), want) < 1e-13
    assert relative(np.concatenate(c.step(q, v, tau, w_ext, h, method)), want) < 1e-13
    quick_batch(model)
    with pytest.warns(LimitWarning, match=r"fore\.torque\[1\] was held off at its end switch"):
        found = rollout(model, np.r_[q, v], tau, step=h, steps=1, integrator=method)
    assert relative(found.x[0, 1], want) < 1e-13
    own, plain = stepper(model, method, "dae"), stepper(bare, method, "dae")
    want = plain.step(plain.initial(q, v), given, w_ext, h)
    for x in (own.step(own.initial(q, v), tau, w_ext, h), c.dae_step(c.dae_state(q, v), tau, w_ext, h, method)):
        assert relative(x, want) < 1e-13


def test_c_and_python_find_the_same_rest_in_which_nothing_accelerates():
    """The gears of a rotor and of a cylinder are wound by what holds their joints; links are so stiff that C's few
    rounds, each of which takes the forces of the one before, end in digits that all agree."""
    stiff = {"rhoA": 1.5, "EIy": 6e5, "EIz": 8e5, "rhoIp": 1e-3}
    model = model_of(ARM | {"links": [link | {"section": stiff} for link in ARM["links"]]})
    joints = [0.3, *np.array([0.9, 0.3, -0.2, 0.1]) / np.sqrt(0.95), -0.15, 0.4]
    q = model.chain.complete(np.array(joints), model.parameter_values)
    efforts, rest = quick(model).gravity(q)
    found, still = equilibrium(model, joints, hold=True), np.zeros(model.nv)
    assert relative(rest, found.q) < 1e-8 and relative(efforts[: model.n_joints], found.tau) < 1e-8
    assert np.abs(rest - q)[model.q_names.index("fore.theta[0]")] > 1e-3 < np.abs(found.tau[-1])
    assert rest[model.q_names.index("fore.stretch[1]")] == pytest.approx(found.tau[-1] / STRUT["stiffness"], rel=1e-9)
    vdot, _ = model.numpy().forward_dynamics(found.q, still, found.tau, None)
    falling, _ = model.numpy().forward_dynamics(found.q, still, None, None)
    assert np.abs(vdot).max() < 1e-8 * np.abs(falling).max()
