"""Arms with bodies from finite elements against the oracle, whose bodies are points, in both forms."""

import re
import subprocess
from pathlib import Path

import flexible_robots as fr
import numpy as np
from helpers import arm, link, model_of, relative, rotation_of

import screwgen
from screwgen.algorithms.functions import FORWARD
from screwgen.algorithms.schedule import trace
from screwgen.simulation.motion import centrelines


def test_the_state_of_the_dae_form_follows_a_tip_with_axes_of_its_own(tmp_path):
    body = {"name": "body", "joint": {"axes": ["z"]}, "cloud": fr.random_cloud(np.random.default_rng(1), 1, axes=True)}
    model = model_of(fr.with_files(arm(body, link("next", 0.5, "y")), tmp_path))
    q, numeric = [0.3, -0.4, 0.02], model.numpy()
    x = numeric.dae_state(q, np.zeros(3))
    assert relative(rotation_of(x[7:11]), numeric.link_pose(q)[0][1]) < 1e-14


# -------- one body: damping, energy of a motion, watch, drawing, documents


def arm_of(folder: Path, cloud, text=None, **more) -> dict:
    path = folder / "body.SID_FEM"
    path.write_text(text or fr.sid_text(cloud), encoding="ascii")
    link = {"name": "boom", "joint": {"axes": ["y", "z"]}, "body": {"sid": str(path)}, **more}
    return {"name": "arm", "gravity": [0.0, 0.0, -9.81], "links": [link]}


def free_cloud(seed: int, modes: int = 2, second: bool = False):
    cloud = fr.random_cloud(np.random.default_rng(seed), modes, second)
    return type(cloud)(**{**vars(cloud), "damping": None})


def test_the_whole_damping_matrix_acts(tmp_path):
    cloud, D = free_cloud(3), np.array([[3.0, -1.0], [-1.0, 2.0]])
    plain = model_of(arm_of(tmp_path, cloud))
    text = re.sub(r" De\n.* end De\n", fr.taylor("De", D, None, 2), fr.sid_text(cloud), flags=re.DOTALL)
    damped = model_of(arm_of(tmp_path, cloud, text))
    q, v, w = np.array([0.3, -0.2, 0.01, 0.02]), np.array([0.5, 1.0, 0.2, -0.3]), np.zeros((1, 6))
    force, bare = (m.numpy().inverse_dynamics(q, v, v, w) for m in (damped, plain))
    assert np.allclose(force - bare, [0, 0, *(D @ v[2:])], atol=1e-12)
    dae = damped.numpy().dae_forward_dynamics(q, v, np.zeros(2), w)[0]
    assert np.allclose(dae, damped.numpy().forward_dynamics(q, v, np.zeros(2), w)[0], rtol=1e-9)


def test_the_watch_measures_deflection_and_slope_of_the_tip(tmp_path):
    cloud = free_cloud(5)
    model = model_of(arm_of(tmp_path, cloud))
    eta = np.array([0.01, -0.02])
    found = model.validity(np.append([0.0, 0.0], eta)).values[0]
    line = cloud.tip / np.linalg.norm(cloud.tip)
    across = np.eye(3) - np.outer(line, line)
    expected = np.linalg.norm(across @ cloud.tip_shapes @ eta) / np.linalg.norm(cloud.tip)
    assert np.allclose(found, [expected, np.linalg.norm(across @ cloud.tip_turns @ eta), 0, 0], rtol=1e-12)


def test_the_line_drawn_ends_at_the_tip(tmp_path):
    cloud = free_cloud(6)
    model = model_of(arm_of(tmp_path, cloud))
    q = np.array([0.3, -0.4, 0.02, 0.01])
    line = centrelines(model, q, np.linspace(0, 1, 5))[0]
    _, place = model.casadi()["tip_pose"](q, model.parameter_values)
    assert np.allclose(line[0], 0, atol=1e-15) and np.allclose(line[-1], np.ravel(place), atol=1e-12)


def test_studies_and_documents_take_such_a_body(tmp_path):
    model = model_of(arm_of(tmp_path, free_cloud(7, 2, True), damping={"ratio": 0.02}))
    assert "boom.damping.ratio" in model.parameter_names
    q = np.zeros(4)
    found = screwgen.equilibrium(model, q[:2])
    assert np.abs(model.numpy().inverse_dynamics(found.q, 0 * q, 0 * q, np.zeros((1, 6)))[2:]).max() < 1e-8
    assert len(screwgen.natural_frequencies(model)) == 2
    assert screwgen.convergence(model).total.tolist() == [0.0, 0.0]
    assert model.linearise(q).A.shape == (8, 8)
    assert screwgen.analyse(model, step=1e-4)
    names = model.write(tmp_path / "out")
    tex = (tmp_path / "out" / next(n for n in names if n.endswith(".tex"))).read_text()
    assert "standard input data" in tex and r"\mathbf{M}_e" in tex


def test_operations_follow_from_the_number_of_modes_alone(tmp_path):
    def operations(cloud) -> int:
        key = model_of(arm_of(tmp_path, cloud)).chain.keys[0]
        return sum(program.operation_count for program in trace(key, FORWARD))

    few, many = (operations(free_cloud(8, n)) for n in (2, 4))
    other = free_cloud(9, 2)
    dense = type(other)(**{**vars(other), "masses": np.ones(fr.POINTS), "places": 2 * other.places})
    assert abs(operations(dense) / few - 1) < 0.01 and few < many < 4 * few


def test_the_self_check_of_a_robot_without_other_parameters(tmp_path):
    """Neither parameters of a link nor constants that depend on them; modes at rest by the whole stiffness."""
    model_of(arm_of(tmp_path, free_cloud(4))).write(tmp_path / "out", targets=("c",))
    done = subprocess.run(["make", "check"], cwd=tmp_path / "out" / "c", capture_output=True, text=True)
    assert done.returncode == 0 and "warning" not in done.stderr, done.stdout + done.stderr
