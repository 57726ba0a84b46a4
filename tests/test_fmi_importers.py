"""Units in a second importer: Ecos, whose reader and loader of units, fmi4c, shares nothing with fmpy's."""

import json
import os
import platform
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import numpy as np
import pytest
from conftest import lacking
from fmi_units import written
from helpers import example_dict, quick, relative

H, COUNT = 1e-3, 100
BUILT = sys.platform == "linux" and platform.machine() == "x86_64"
START = {"upper_arm.joint[0]": 0.3, "forearm.joint[0]": -0.4, "forearm.joint_rate[0]": 0.5}
CHANGED = {"gravity[2]": -1.6, "forearm.bodies[0].mass": 2.4}
TORQUES = {"upper_arm.torque[0]": 2.0, "forearm.torque[0]": -1.0}


def converged() -> dict:
    return example_dict("converged")


def by_ecos(path, **task) -> list[float]:
    """What the unit answers; Ecos' wheel leaves out libtbb, which has one of its own."""
    found = {}
    for name in ("ecospy", "tbb"):
        try:
            found[name] = metadata.files(name)
        except metadata.PackageNotFoundError:
            lacking(name)
    libraries = next(file for file in found["tbb"] if file.name == "libtbb.so.12").locate().resolve().parent
    command = [sys.executable, str(Path(__file__).with_name("ecos_run.py")), str(path)]
    environment = os.environ | {"LD_LIBRARY_PATH": str(libraries)}
    done = subprocess.run(command, input=json.dumps(task), capture_output=True, text=True, env=environment)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


@pytest.mark.skipif(not BUILT, reason="the extra 'test' has ecospy on Linux x86_64 alone")
@pytest.mark.examples
@pytest.mark.parametrize("target", ("fmu2", "fmu3"))
def test_ella_in_ecos_is_ella_in_c(target):
    """A hundred steps from a start, with other parameters and held torques: the states bit for bit, and outputs."""
    model, path = written(target, converged)
    tip = [f"forearm.tip.position.{x}" for x in "xyz"]
    names = [*model.q_names, *model.v_names, *tip]
    found = by_ecos(path, start=START | CHANGED, inputs=TORQUES, step=H, count=COUNT, names=names)
    p = dict(zip(model.parameter_names, model.parameter_values, strict=True)) | CHANGED
    given = START | TORQUES
    q, v, tau = (np.array([given.get(x, 0.0) for x in own]) for own in (model.q_names, model.v_names, model.tau_names))
    c = quick(model)
    try:
        c.prepare(list(p.values()))
        q, v = c.step(q, v, tau, None, H, "modal_implicit", COUNT)
    finally:
        c.prepare(None)
    states = found[: len(q) + len(v)]
    assert np.array(states).tobytes() == np.concatenate([q, v]).tobytes()
    assert relative(found[len(states) :], model.numpy(list(p.values())).tip_pose(q)[1]) < 1e-13
