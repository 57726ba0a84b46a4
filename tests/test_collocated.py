"""What the points of exact rods leave out: a measure of states, in runs a warning, in analyses a line."""

import json
import warnings

import numpy as np
import pytest
import scipy.linalg
from helpers import arm, link, model_of, quick_batch
from robot_toml import to_toml

from screwgen import ModelValidityWarning, analyse, rollout, simulate, sweep
from screwgen.bodies.collocation import points
from screwgen.cli.main import main
from screwgen.simulation.collocated import INERTIA, TOLERANCE, left_out
from screwgen.simulation.motion import centrelines


def table(modes=1, count=None, section=None, **more) -> dict:
    counts = {"bending_y": modes, "bending_z": modes, "torsion": 1} | ({"points": count} if count else {})
    rod = link("rod", 1.5, [], modes=counts, section={"EIy": 1.0, "EIz": 1.0, "GJ": 1.0} | (section or {}), **more)
    return arm(rod, gravity=(0, 0, 0), order="exact")


def bend(model, slope: float) -> np.ndarray:
    """(1, nq): bent in both planes to this slope in rad, and twisted."""
    key = model.chain.keys[0]
    slopes = [key.shapes(d).tip_slope[0] / 1.5 for d in ("bending_y", "bending_z")]
    q = np.zeros(model.nq)
    for i, (direction, k) in enumerate(key.directions):
        if k == 0:
            q[i] = 0.5 * slope if direction == "torsion" else slope / slopes[direction == "bending_z"]
    return q[None]


def tip(model, q) -> np.ndarray:
    return centrelines(model, q[0], [1.0])[0, 0]


@pytest.mark.parametrize(
    ("modes", "slope", "past"), [(1, 0.2, False), (1, 2.0, True), (2, 0.2, False), (2, 0.8, True), (2, 3.0, True)]
)
def test_it_is_the_distance_to_a_rod_with_many_points(modes, slope, past):
    """And the number of points that it states is enough."""
    model = model_of(table(modes))
    q = bend(model, slope)
    (found,) = left_out(model, q)
    fine = tip(model_of(table(modes, 30)), q)
    assert found.link == "rod" and found.points == points(model.chain.keys[0]) == modes + 2
    assert abs(np.linalg.norm(tip(model, q) - fine) / 1.5 - found.error) < 0.2 * found.error
    better = model_of(table(modes, found.enough))
    assert np.linalg.norm(tip(better, q) - fine) / 1.5 < 1.2 * TOLERANCE and not left_out(better, q)[0].past
    assert found.past == (found.enough > found.points) == past == (found.error > TOLERANCE or found.inertia > INERTIA)


@pytest.mark.parametrize("slope", [0.2, 0.8, 2.0])
def test_inertia_is_off_as_the_mass_matrix_is(slope):
    """In the motion in which it is off most, beside that with many points; the link floats, so that all of it moves."""
    exact = [model_of(table(2, count, section={"rhoIp": 1e-7}) | {"base": "floating"}) for count in (None, 30)]
    q = np.append([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], bend(model_of(table(2)), slope)[0])
    (found,) = left_out(exact[0], q[None])
    coarse, fine = (np.delete(np.delete(m.numpy().mass_matrix(q), -1, 0), -1, 1) for m in exact)  # without the torsion
    off = np.abs(scipy.linalg.eigh(coarse - fine, fine, eigvals_only=True)).max()
    assert exact[0].q_names[-1] == "rod.eta.torsion[0]" and abs(off - found.inertia) < 0.1 * off
    assert (f"leave its inertia and accelerations off by {100 * found.inertia:.2g} %" in found.text()) == (slope > 0.5)


def test_other_links_have_none_and_segments_are_named_by_their_link():
    assert left_out(model_of(table() | {"order": 2}), np.zeros((2, 3))) == ()
    model = model_of(table(segments=2))
    q = np.zeros((1, 6))
    q[0, 3:] = 0.3
    (found,) = left_out(model, q)
    assert found.link == "rod" and found.past


def test_sections_between_the_ends_are_asked_and_named():
    """There the polynomial through the tangents is integrated, at the tip Gauss's quadrature is exact to twice its
    degree: a bend that the tip hardly feels is past the bound at a marker, and where the rod carries another."""
    bare = model_of(table(2))
    q = bend(bare, 0.8)
    (tip_alone,) = left_out(bare, q)
    marked = table(2, markers=[{"name": "mid", "at": 0.3}])
    (found,) = left_out(model_of(marked), q)
    fine = model_of(table(2, 30))
    off = [centrelines(m, q[0], [0.3])[0, 0] for m in (bare, fine)]
    assert found.section == "marker 'mid'" and tip_alone.section == "tip" and tip_alone.error < TOLERANCE
    assert found.error > max(2 * tip_alone.error, TOLERANCE)
    assert abs(np.linalg.norm(off[0] - off[1]) / 1.5 - found.error) < 0.2 * found.error
    assert f"put its marker 'mid' {found.error:.1g} of its length beside its place" in found.text()
    better = model_of(table(2, found.enough, markers=marked["links"][0]["markers"]))
    assert found.enough > found.points and not left_out(better, q)[0].past
    carrying = table(2)
    carrying["links"].append({**link("twig", 0.1, "y"), "parent": "rod", "at": {"s": 0.3}})
    model = model_of(carrying)
    (same,) = left_out(model, np.insert(q, 0, 0.0, axis=1))
    assert same.section == "section at s = 0.3" and same.error == found.error


def test_rollouts_warn_as_runs_do():
    """Once, of the states in which some scenario bends most; not of one that stopped."""
    model = model_of(table())
    quick_batch(model)
    starts = np.vstack([0.1 * bend(model, 2.0), bend(model, 2.0), np.full((1, model.nq), np.nan)])
    x0 = np.hstack([starts, 0 * np.nan_to_num(starts)])
    with pytest.warns(ModelValidityWarning) as said:
        run = rollout(model, x0, step=1e-3, steps=5)
    (line,) = [str(w.message) for w in said if "points along it" in str(w.message)]
    assert line == left_out(model, run.q[1])[0].text() and not run.ok[2]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        rollout(model, x0, step=1e-3, steps=5)
        rollout(model_of(table()), x0[:1], step=1e-3, steps=5)


def bent_starts(rng, n):
    """Scenarios of which one is bent far."""
    x0 = np.zeros((n, 2 * model_of(table()).nq))
    x0[:1, : x0.shape[1] // 2] = bend(model_of(table()), 2.0)[:1]
    return {"x0": x0}


def test_a_sweep_warns_of_its_worst_scenario(tmp_path):
    """Of whichever chunk, once."""
    with pytest.warns(ModelValidityWarning) as said:
        sweep(model_of(table()), bent_starts, 4, tmp_path / "s.npy", step=1e-3, steps=2, chunk=2)
    (line,) = [str(w.message) for w in said if "points along it" in str(w.message)]
    assert "the 3 points along it put its tip" in line


def test_a_run_warns_once_with_a_number_and_a_remedy():
    model = model_of(table())
    start = bend(model, 2.0)[0]
    with pytest.warns(ModelValidityWarning) as said:
        run = simulate(model, 0.02, 1e-3, q0=start)
    (line,) = [str(w.message) for w in said]
    (found,) = left_out(model, run.q)
    assert line == found.text() and line.startswith("link 'rod': the 3 points along it put its tip ")
    assert line.endswith(f"; state modes.points = {found.enough}") and "\n" not in line
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        simulate(model, 0.02, 1e-3, q0=start)
        simulate(model_of(table(count=found.enough)), 0.02, 1e-3, q0=start)
        simulate(model_of(table()), 0.02, 1e-3, q0=bend(model, 0.1)[0])


def test_analyses_of_states_and_runs_report_it(capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    model = model_of(table())
    q = bend(model, 2.0)
    found = analyse(model, {"bent": q[0], "straight": 0 * q[0]}, 1e-3)
    (bent,) = found.states[0].left_out
    assert bent == left_out(model, q)[0] and not found.states[1].left_out[0].past
    text = " ".join(found.text().split())
    assert bent.text() in text and f"over the length: rod {bent.error:.1g} (tip, 3 points)" in text
    assert json.loads(found.to_json())["states"][0]["left_out"][0]["enough"] == bent.enough
    (tmp_path / "robot.toml").write_text(to_toml(table()))
    (tmp_path / "state.json").write_text(json.dumps({"q": q[0].tolist()}))
    line = "simulate robot.toml --state state.json --duration 0.01 --step 0.001 -o run.npz"
    assert main(line.split()) == 0
    assert "screwgen: warning: link 'rod': the 3 points along it" in capsys.readouterr().err
    assert main(["analyse", "robot.toml", "--state", "run.npz"]) == 0
    assert "state modes.points = " in " ".join(capsys.readouterr().out.split())
    assert main(["analyse", "robot.toml", "--state", "run.npz", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["run.npz"]["left_out"][0]["link"] == "rod"
