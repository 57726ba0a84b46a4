"""Every folder of generated C compiles without a warning: each feature, in every option, by two compilers."""

from itertools import cycle, product

import pytest
from conformance.c_warnings import COMPILERS, LEVELS, compile_cleanly
from conftest import swept
from feature_robots import FEATURES, model_with

WITHOUT_CONTROL = ("welded", "modes", "shear", "tendons", "coupling", "ball", "floating", "loop", "elastic gear")
WITHOUT_CONTROL += ("cylinder", "elastic cylinder", "four-bar")
"""Robots of which no predictive controller is made: no joints, no cost-to-go, or refused."""
CONTROL = """
[horizon]
intervals = 3
step = 0.02
[goal]
joints = 0.1
[cost]
tip_position = 100.0
tip_orientation = 1.0
tip_velocity = 1.0
joints = 10.0
joint_rates = 1.0
modes = 1.0
mode_rates = 1.0
torques = 1e-4
terminal = { riccati = true }
[bounds]
torques = 60.0
joints = { lower = -2.0, upper = 2.0 }
joint_rates = 3.0
torque_rates = 3000.0
"""
KINDS = tuple(product(("fused", "modular"), ("runtime", "baked")))
BUILDS = tuple(product(COMPILERS, LEVELS, ("double", "float")))
CASES = [(feature, *kind, *build) for feature, kind, build in zip(FEATURES, cycle(KINDS), cycle(BUILDS), strict=False)]
"""By turns: what a feature adds stands in every layout and binding."""
WARNED = (
    ("rigid", "fused", "runtime", "gcc", "-O0", "double"),
    ("slide", "fused", "runtime", "gcc", "-O0", "double"),
    ("ball", "modular", "runtime", "clang", "-O0", "double"),
    ("spring", "fused", "baked", "clang", "-O0", "double"),
    ("elastic gear", "fused", "runtime", "gcc", "-O0", "float"),
)
"""Each of these failed once, for a reason of its own."""


def write(folder, feature: str, binding: str, layout: str, control: str | None) -> None:
    """The C of a robot in a folder, with all options, and with a predictive controller if its file is given."""
    mpc = None if control is None else folder / "control.toml"
    if mpc is not None:
        mpc.write_text(control)
    files = model_with(feature).c_files(binding, layout, mpc, batch=True, estimator=True, outputs=True)
    for name, data in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(data)


@pytest.mark.parametrize("case", swept([*WARNED, *CASES], *WARNED), ids="-".join)
def test_compiles_without_a_warning(tmp_path, case):
    """With batch, derivatives, estimator, outputs, sensors and, where it can be, the predictive controller."""
    feature, layout, binding, compiler, level, precision = case
    write(tmp_path, feature, binding, layout, None if feature in WITHOUT_CONTROL or case in WARNED else CONTROL)
    assert compile_cleanly(tmp_path, compiler, level, ["-DROBOT_REAL_FLOAT"] * (precision == "float")) == []
