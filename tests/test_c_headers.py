"""The public headers of generated C: each stands alone, C++ programs link with all that they declare."""

import pytest
from conformance.c_prototypes import called_from_cpp, prototypes
from feature_robots import CONTROL, model_with, write

from screwgen.algorithms.robot_functions import OUTPUTS, SENSORS, in_file
from screwgen.backends.c.project import CProject


@pytest.mark.parametrize("feature", ["spring", "cylinder"])
def test_cpp_includes_every_header_and_calls_every_function(tmp_path, feature):
    """With and without the predictive controller; each function answers a null pointer with a status."""
    control = CONTROL if feature == "spring" else None
    write(tmp_path, feature, "runtime", "fused", control)
    found = {function.name for function in prototypes(tmp_path, "robot")}
    reported = {f"robot_{row.name}" for part in (OUTPUTS, SENSORS) for row in in_file(part, model_with(feature).chain)}
    assert reported | {"robot_mass_matrix", "robot_tip_jacobian", "robot_estimator_update"} <= found
    assert ("robot_mpc_feedback" in found) == bool(control)
    assert called_from_cpp(tmp_path, "robot") == []


@pytest.mark.parametrize("feature", ["elastic gear", "elastic cylinder", "four-bar", "stop", "friction", "spring"])
def test_every_constant_has_a_unit_and_a_meaning(feature):
    """Those of joints and drives too, for which there is no step."""
    project = CProject(model_with(feature).chain, "")
    said = {member.name: member.comment for member in project.constants}
    assert all(": " in comment and "SI units" not in comment for comment in said.values()), said
    limits = {"limit_lower_1": "rad: least coordinate", "drive_coulomb_1": "N*m: dry friction"}
    assert all(said[name].startswith(text) for name, text in limits.items() if name in said), said
