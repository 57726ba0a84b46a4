"""Linear models against finite differences of an independent Lagrangian, frequencies, SciPy and python-control."""

from __future__ import annotations

from xml.etree import ElementTree

import control
import numpy as np
import pytest
from helpers import G, arm, example, link, model_of

from screwgen import SingularError, UsageError, equilibrium, simulate
from screwgen.studies.modes import natural_frequencies

SETPOINTS = [-0.4928, 0.6922, 0.4270]


def test_a_pendulum_is_the_textbooks():
    """A thin rod about its end: `3 g / 2 l`, damping and torque over `m l² / 3`."""
    model = model_of(arm(link("rod", 2.0, "y", rhoA=0.7, joint={"damping": [0.3]})))
    linear = model.linearise([np.pi / 2], outputs=("joint_angles", "tip_acceleration"))
    inertia = 0.7 * 2.0 * 2.0**2 / 3
    assert np.allclose(linear.A, [[0, 1], [-1.5 * G / 2.0, -0.3 / inertia]], rtol=1e-12)
    assert np.allclose(linear.B, [[0], [1 / inertia]], rtol=1e-12)
    assert np.allclose(linear.D, [[0], [-2 / inertia], [0], [0]], atol=1e-12)
    assert linear.output_units == ("rad", "m/s²", "m/s²", "m/s²") and linear.input_units == ("N·m",)


def test_scipy_and_python_control_take_it():
    model = example("ella")
    linear = model.linearise(SETPOINTS, outputs="tip_acceleration")
    frequencies = np.array([0.3, 2.0, 7.0, 40.0])
    expected = linear.response(frequencies)
    system = control.ss(*linear, **linear.labels())
    answer = control.frequency_response(system, 2 * np.pi * frequencies)
    assert np.allclose(np.moveaxis(answer.complex, 2, 0), expected, rtol=1e-9, atol=1e-12)
    assert system.input_labels == [name.replace(".", "/") for name in model.tau_names]
    assert system.state_labels[0] == "upper_arm/joint[0]" and system.output_labels[2] == "tip_acceleration/z"
    by_scipy = linear.scipy()
    shifted = [2j * np.pi * f * np.eye(18) - by_scipy.A for f in frequencies]
    again = np.array([by_scipy.C @ np.linalg.inv(s) @ by_scipy.B + by_scipy.D for s in shifted])
    assert np.allclose(again, expected, rtol=1e-9, atol=1e-12)
    assert all(
        np.array_equal(a, b) for a, b in zip((by_scipy.A, by_scipy.B, by_scipy.C, by_scipy.D), linear, strict=True)
    )


def test_parameters_take_the_place_of_the_files():
    model = example("ella")
    p = np.array(model.parameter_values)
    p[:3] = 0.0
    weightless = model.linearise(SETPOINTS, parameters=p)
    assert not weightless.vdot.any() and model.linearise(SETPOINTS).vdot.any()
    frequencies = natural_frequencies(model, [*SETPOINTS, *[0.0] * 6], "free")
    poles = weightless.eigenvalues().imag[9:] / (2 * np.pi)
    assert np.allclose(poles[3:], frequencies[3:], rtol=1e-8)


def test_names_choose_groups_and_entries():
    linear = example("ella").linearise(
        SETPOINTS, outputs=("tip_velocity.y", "forearm.F_x", "joint_rates", "tip_velocity.y"), inputs="tip_wrench"
    )
    assert linear.output_names == ("tip_velocity.y", "forearm.F_x", "upper_arm.joint_rate[0]",
                                   "upper_arm.joint_rate[1]", "forearm.joint_rate[0]")  # fmt: skip
    assert linear.output_units == ("m/s", "N", "rad/s", "rad/s", "rad/s")
    assert linear.input_names[3:] == ("forearm.w_ext.F_x", "forearm.w_ext.F_y", "forearm.w_ext.F_z")
    assert linear.input_units == ("N·m",) * 3 + ("N",) * 3 and linear.state_units[2:5] == ("rad", "m", "m")
    assert not example("ella").linearise(SETPOINTS, outputs=()).C.size


@pytest.mark.parametrize(
    ("inputs", "expected"),
    [
        (["forearm.tau"], ("forearm.torque[0]",)),
        ("upper_arm.tau[1]", ("upper_arm.torque[1]",)),
        ("tau", ("upper_arm.torque[0]", "upper_arm.torque[1]", "forearm.torque[0]")),
        ("upper_arm.w_ext", tuple(f"upper_arm.w_ext.{x}" for x in ("tau_x", "tau_y", "tau_z", "F_x", "F_y", "F_z"))),
    ],
)
def test_short_names_of_inputs(inputs, expected):
    assert example("ella").linearise(SETPOINTS, inputs=inputs).input_names == expected


def test_parts_of_a_linear_model():
    linear = example("ella").linearise(SETPOINTS, outputs=("joint_angles", "tip_velocity"))
    A, B, *_ = linear
    assert linear[0] is A and linear[-1] is linear.D and len(linear) == 4 and linear[:2][1] is B
    part = linear[["tip_velocity.z", 0], "forearm.torque[0]"]
    assert part.output_names == ("tip_velocity.z", "upper_arm.joint[0]") and part.output_units == ("m/s", "rad")
    assert part.input_names == ("forearm.torque[0]",) and part.A is A
    f = [0.7, 3.0]
    assert np.allclose(part.response(f), linear.response(f)[:, [5, 0]][:, :, [2]], rtol=1e-12, atol=1e-12)
    assert linear[:, 1:].B.shape == (18, 2) and linear[:, 1:].u.shape == (2,)
    for key, message in (
        (("tip_velocity.zz", 0), "outputs: .* did you mean 'tip_velocity.z'"),
        ((0, 9), "inputs: 9 is none of 3"),
        ((0, 0, 0), "no 3 axes"),
    ):
        with pytest.raises(UsageError, match=message):
            linear[key]


def test_results_show_themselves():
    """In a console one line, in a notebook a table."""
    model = example("ella")
    linear, rest = model.linearise(SETPOINTS), equilibrium(model, SETPOINTS, hold=True)
    run = simulate(model, 0.01, 1e-3, SETPOINTS)
    assert repr(run) == "<Run of ella: 11 samples to 0.01 s, 3 joints, 6 modes>"
    sag = 1e3 * np.linalg.norm(rest.tip_deflection)
    assert repr(rest) == f"<Equilibrium: stable, joints held; the tip is deflected by {sag:.4g} mm>"
    assert repr(linear).startswith("<LinearModel: 18 states, 3 inputs, 6 outputs; upper_arm.torque[0], ")
    for shown, parts in (
        (run, ("<td>forearm.joint[0]</td>", "<td>-0.4928</td>", "tip_position.z")),
        (rest, ("<td>0.427</td>", "N·m")),
        (linear, ("<td>upper_arm.joint[1]</td>", "<td>N·m</td>", "poles")),
    ):
        ElementTree.fromstring(f"<div>{shown._repr_html_()}</div>")
        assert all(part in shown._repr_html_() for part in parts)


def test_unknown_functions_are_named_with_the_nearest():
    functions = example("ella").casadi()
    with pytest.raises(UsageError, match="there is no function 'forward_dynamic'; did you mean 'forward_dynamics'"):
        functions["forward_dynamic"]
    assert "forward_dynamic" not in functions and functions.get("forward_dynamic") is None
    with pytest.raises(UsageError, match=r"parameters: there is no 'forearm.rhoa'; did you mean 'forearm.rhoA'\?"):
        simulate(example("ella"), 0.01, 1e-3, parameters={"forearm.rhoa": 1.0})


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"q": [0.0] * 4}, "q: has 4 numbers; it must have 9"),
        ({"q": "straight"}, "q: is not an array of numbers"),
        ({"v": [np.nan] * 9}, "v: holds a number that is not finite"),
        ({"tau": [1.0]}, "tau: has 1 numbers; it must have 3"),
        ({"w_ext": [0.0] * 6}, "w_ext: has 6 numbers; it must have 12"),
        ({"parameters": [1.0]}, "parameters: has 1 numbers"),
        ({"outputs": "tip_posiition"}, "outputs: there is no 'tip_posiition'.* did you mean 'tip_position'"),
        ({"inputs": ["voltage"]}, "inputs: there is no 'voltage'; choose of torques"),
    ],
)
def test_bad_requests_are_one_line(options, message):
    with pytest.raises(UsageError, match=message) as error:
        example("ella").linearise(**({"q": SETPOINTS} | options))
    assert "\n" not in str(error.value)


def test_a_singular_posture_names_the_link():
    ball = model_of(arm(link("wrist", 0.5, "xzx")))
    with pytest.raises(SingularError, match="wrist"):
        ball.linearise([0.0] * 3)


def test_a_pole_at_the_frequency_is_refused():
    rod = model_of(arm(link("rod", 1.0, "z"), gravity=(0, 0, 0))).linearise([0.0])
    with pytest.raises(UsageError, match="pole"):
        rod.response([0.0])
    with pytest.raises(UsageError, match="one of each"):
        model_of(arm(link("rod", 1.0, "z"))).linearise([0.0], inputs=()).scipy()
