"""One keyword for parameters, wherever a function of the model takes them."""

import numpy as np
import pytest
from helpers import arm, link, model_of

import screwgen
from screwgen import UsageError
from screwgen.studies.analysis.spectrum import Linearised, jacobian, step_map
from screwgen.studies.modes import mode_shapes

MODEL = model_of(arm(link("beam", modes={"bending_y": 1}, joint={"axes": ["z"], "armature": [0.1]})))
X = np.array([0.1, 0.001])
ROWS = X[None]
ANSWERS = {
    "numpy": lambda **given: MODEL.numpy(**given).mass_matrix(X),
    "fresh": lambda **given: _compiled().fresh(**given).mass_matrix(X),
    "prepare": lambda **given: _prepared(**given).mass_matrix(X),
    "equilibrium": lambda **given: screwgen.equilibrium(MODEL, hold=True, **given).q,
    "natural_frequencies": lambda **given: screwgen.natural_frequencies(MODEL, **given),
    "mode_shapes": lambda **given: mode_shapes(MODEL, **given).frequencies,
    "convergence": lambda **given: screwgen.convergence(MODEL, **given).alone["bending_y"],
    "jacobian": lambda **given: jacobian(MODEL, X, X, **given),
    "step_map": lambda **given: step_map(MODEL, "rk4", X, X, 1e-3, **given),
    "Linearised": lambda **given: Linearised(MODEL, X, X, **given).vdot,
}
"""What a function says of the model with other parameters."""


def _compiled():
    return MODEL.once("test", lambda: MODEL.compile(flags=("-O0",)))


def _prepared(**given):
    out = _compiled().fresh()
    out.prepare(**given)
    return out


@pytest.mark.parametrize("name", ANSWERS)
def test_parameters_by_name_are_those_in_their_order(name):
    values = np.array(MODEL.parameter_values) * 1.02
    values[: len(MODEL.robot.gravity)] = 1.0, 0.0, -5.0
    by_name = dict(zip(MODEL.chain.parameters.names, values, strict=True))
    assert np.array_equal(ANSWERS[name](parameters=by_name), ANSWERS[name](parameters=values))


def test_parameters_in_their_place_are_those_by_name():
    values = np.array(MODEL.parameter_values) * 1.02
    named = screwgen.natural_frequencies(MODEL, X, parameters=values)
    assert np.array_equal(screwgen.natural_frequencies(MODEL, X, "locked", values), named)
    assert np.array_equal(MODEL.numpy(values).p, values)


@pytest.mark.parametrize(
    ("mass", "said"), [(np.nan, "is nan; it must be finite"), (np.inf, "is inf; it must be finite"), (-1.0, ">= 0")]
)
def test_a_robot_whose_parts_were_edited_without_validation_is_refused_in_a_line(mass, said):
    robot = model_of(arm(link(bodies=[{"at": "tip", "mass": 1.0}]))).robot
    body = robot.links[0].bodies[0].model_copy(update={"mass": mass})
    edited = robot.model_copy(update={"links": (robot.links[0].model_copy(update={"bodies": (body,)}),)})
    with pytest.raises(UsageError, match=rf"^parameters: arm\.bodies\[0\]\.mass .*{said}$"):
        screwgen.equilibrium(screwgen.derive(edited))
