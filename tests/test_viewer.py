"""The viewer's pages without a browser: shapes against the model's poses, numbers within their bounds, refusals."""

import json
import re
from base64 import b64decode

import numpy as np
import pytest
from dressed_arm import still
from force_robots import ends, sprung_model, state, touching
from helpers import ROOT, arm, link, model_of
from scipy.spatial.transform import Rotation

import screwgen
from screwgen.cli.main import main
from screwgen.plotting.demands import set_points
from screwgen.simulation.controllers import PD
from screwgen.viewer import lines, pack
from screwgen.viewer.actuators import eyes
from screwgen.viewer.film import Actor
from screwgen.viewer.meshes import packed
from screwgen.viewer.panels import panels
from screwgen.viewer.scene import scene
from screwgen.viewer.shapes import sections
from screwgen.viewer.solids import THREAD, Bend, Solid, solids
from screwgen.viewer.view import read_run, view

MODES = {"axial": 1, "bending_y": 2, "bending_z": 2, "torsion": 1}


def bent(order: int):
    """An arm of two links of that order, the second carried in the middle of the first."""
    first = link("first", modes=MODES)
    second = link("second", modes=MODES, parent="first", at={"s": 0.4})
    return model_of(arm(first, second) | {"order": order})


@pytest.mark.parametrize("order", [1, 2])
def test_sections_are_those_of_the_model(order):
    """At the tip and at a station, of an arm that bends far."""
    model = bent(order)
    q = np.zeros(model.nq)
    q[model.chain.eta_q :] = np.random.default_rng(order).normal(size=model.chain.n_modes) * 0.1
    (R, r), (R_tip, r_tip) = model.numpy().link_pose(q), model.numpy().tip_poses(q)
    key, eta = model.chain.keys[0], q[model.chain.eta_q :][: model.chain.keys[0].modes]
    length = model.robot.links[0].length
    found = sections(key, length, np.array([0.4, 1.0]))
    coordinates = np.concatenate([eta, *(eta[a : a + 1] * eta[b] for a, b in found.pairs)])
    moved = np.einsum("k,ski->si", coordinates, found.columns)
    assert (len(found.pairs) > 0) == (order == 2)
    for row, (s, turn, place) in enumerate(((0.4, R[1], r[1]), (1.0, R_tip[0], r_tip[0]))):
        assert r[0] + R[0] @ ([s * length, 0, 0] + moved[row, :3]) == pytest.approx(place, abs=1e-6)
        assert R[0] @ Rotation.from_rotvec(moved[row, 3:]).as_matrix() == pytest.approx(turn, abs=1e-6)


def test_numbers_are_within_their_bounds():
    t = np.linspace(0, 3, 3001)
    values = np.column_stack([np.sin(5 * t), 1e3 * t, np.full_like(t, 2.0)])
    tolerance = np.array([1e-3, 1e-3, 1e-6])
    rows, error = pack.kept(t, values, tolerance, 6)
    assert 10 < len(rows) < 400 and rows[0] == 0 and rows[-1] == 3000 and error <= 1
    straight = np.array([np.interp(t, t[rows], x) for x in values[rows].T]).T
    assert (np.abs(straight - values) <= tolerance).all()
    block = pack.rounded(values, tolerance)
    assert block["wide"] == [False, True, False]
    assert (np.array(block["step"])[:2] / 2 <= tolerance[:2]).all()


@pytest.mark.parametrize(("count", "wide"), [(65_535, False), (65_536, True), (65_537, True)])
def test_indices_are_as_wide_as_they_must_be(count, wide):
    """The index 65535 of 16 bits would end a strip of triangles."""
    points, faces = np.zeros((count, 3)), np.array([[0, 1, count - 1, count - 1]])
    block = packed(0, Solid(points, faces, "#000000", "frame", np.empty(0)), 1.0)
    index = np.frombuffer(b64decode(block["index"]), "<u4" if wide else "<u2")
    assert block["wide"] == wide and index.tolist() == [0, 1, count - 1]


def run_of(model, duration=0.05):
    start = np.full(model.nq, 1e-3)
    return screwgen.simulate(model, duration, 1e-3, q0=start)


def test_page_needs_nothing_else(tmp_path):
    """It names no address, says so to the browser, holds the licence, and its data is JSON."""
    run = run_of(bent(1))
    html = view(run, run, labels=["<one>", "two"]).html
    data = re.search(r'<script type="application/json" id="data">(.*?)</script>', html, re.DOTALL)[1]
    assert [clip["label"] for clip in json.loads(data)["clips"]] == ["<one>", "two"]
    assert "default-src 'none'" in html and "The MIT License" in html
    outside = html.replace((ROOT / "templates/view/three/three.min.js").read_text(), "")
    assert not re.search(r"https?://|<link|src=|@import|url\(", outside)


def test_run_knows_its_robot(tmp_path):
    """Through its file, with the parameters that it was made with; the page is the same."""
    model = bent(2)
    p = np.array(model.parameter_values)
    p[model.parameter_names.index("first.length")] *= 1.25
    run = screwgen.simulate(model, 0.02, 1e-3, q0=np.full(model.nq, 1e-3), parameters=p)
    run.save(tmp_path / "run.npz")
    found = read_run(tmp_path / "run.npz")
    assert found.robot == model.robot and (found.parameters == p).all()
    assert view(found).html == view(run).html
    assert view(found).html != view(screwgen.simulate(model, 0.02, 1e-3, q0=np.full(model.nq, 1e-3))).html
    assert "<iframe" in run._repr_html_()


def refusal(capsys, *arguments) -> str:
    assert main([str(x) for x in arguments]) == 2
    return capsys.readouterr().err


def test_refusals(tmp_path, capsys):
    """One line each, and nothing written."""
    model = bent(1)
    run_of(model).save(tmp_path / "run.npz")
    with np.load(tmp_path / "run.npz") as data:
        arrays = dict(data)
    np.savez(tmp_path / "old.npz", **{k: x for k, x in arrays.items() if k not in ("robot", "parameters")})
    np.savez(tmp_path / "bad.npz", **arrays | {"q": np.full_like(arrays["q"], np.nan)})
    np.savez(tmp_path / "falls.npz", **arrays | {"t": arrays["t"][::-1]})
    np.savez(tmp_path / "cut.npz", **arrays | {"wrench": arrays["wrench"][:-1]})
    np.savez(tmp_path / "one.npz", **arrays | {"parameters": np.array(1.0)})
    np.savez(tmp_path / "pushed.npz", **arrays | {"w_ext": np.zeros((2, 6))})
    np.savez(tmp_path / "text.npz", **arrays | {"robot": np.array("name = ")})
    (tmp_path / "none.npz").write_text("nothing")
    page, good = tmp_path / "run.html", tmp_path / "run.npz"
    ella = ROOT / "examples" / "ella.toml"
    for arguments, said in [
        ((tmp_path / "old.npz",), "old.npz: does not know its robot; name the robot's file by --robot"),
        ((tmp_path / "bad.npz",), "bad.npz: q holds numbers that are not finite"),
        ((tmp_path / "falls.npz",), "falls.npz: t falls; times must rise"),
        ((tmp_path / "cut.npz",), "cut.npz: wrench has the shape"),
        ((tmp_path / "one.npz",), "one.npz: parameters has the shape ()"),
        ((tmp_path / "pushed.npz",), "pushed.npz: w_ext has the shape (2, 6)"),
        ((tmp_path / "text.npz",), "name the robot's file by --robot"),
        ((tmp_path / "none.npz",), "none.npz: cannot be read as a run"),
        ((good, "--robot", ella), "is a run of another robot"),
        ((good, good, good), "there are 3 runs to view"),
    ]:
        error = refusal(capsys, "view", *arguments, "-o", page)
        assert said in error and error.count("\n") == 1
    assert "unknown suffix" in refusal(capsys, "view", good, "-o", tmp_path / "run.png")
    assert not page.exists()


def test_panels_tell_links_axes_and_set_points():
    """Colours of links are for what is of a link; axes of one link have dashes and names of their own."""
    model = model_of(arm(link("base_arm", axes=("z", "y"), modes=MODES), link("fore")))
    law = PD((9.0,) * 3, (2.0,) * 3, (0.1, 0.2, 0.3), duration=0.02, q_start=(0.0,) * 3)
    run = screwgen.simulate(model, 0.02, 1e-3, controller=law)
    shown = {x["title"]: x["curves"] for x in panels(run, model, set_points(run, model, law))}
    named = [f"Deflection of tips in {axis}" for axis in "yz"]
    drives = ["Joint angles", "Joint torques", "Power of drives"]
    assert list(shown) == [*drives, *named, "Elongation", "Twist of tips", "Energy", "Tip, inertial frame"]
    styles = [(c["label"], c["color"], c["dash"]) for c in shown["Joint torques"]]
    assert styles == [("base arm z", "c0", 0), ("base arm y", "c0", 1), ("fore", "c1", 0)]
    goals = [np.frombuffer(b64decode(c["y"]), "<f4")[-1] for c in shown["Joint angles"] if c["goal"]]
    assert goals == pytest.approx([0.1, 0.2, 0.3], rel=1e-6) and len(shown["Joint angles"]) == 6
    assert {c["color"] for title in ("Tip, inertial frame", "Energy") for c in shown[title]}.isdisjoint({"c0", "c1"})
    tip = [np.frombuffer(b64decode(shown[name][0]["y"]), "<f4")[-1] for name in named]
    (R, r), (_, end) = model.numpy().link_pose(run.q[-1]), model.numpy().tip_poses(run.q[-1])
    moved = R[0].T @ (end[0] - r[0])
    assert tip == pytest.approx(moved[1:], rel=1e-5)
    assert [c["label"] for name in named for c in shown[name]] == ["base arm"] * 2


def test_a_file_of_an_earlier_version_is_read_and_one_without_energies_is_not(tmp_path):
    run = screwgen.simulate(model_of(arm(link("arm", modes=MODES))), 0.01, 1e-3)
    run.save(tmp_path / "run.npz")
    with np.load(tmp_path / "run.npz") as stored:
        kept = {name: stored[name] for name in stored.files}
    power = kept.pop("drive_power")
    np.savez(tmp_path / "old.npz", **kept)
    old = read_run(tmp_path / "old.npz")
    assert old.drive_power is None and power.shape == (11, 1) and np.array_equal(old.energy, run.energy)
    assert len(view(old).html) > 1000
    del kept["energy"]
    np.savez(tmp_path / "worse.npz", **kept)
    with pytest.raises(screwgen.UsageError, match=r"worse.npz: cannot be read as a run .it has no .energy."):
        read_run(tmp_path / "worse.npz")


# -------- tendons and cylinders


@pytest.mark.parametrize(("order", "size"), [(1, 1e-3), ("exact", 1.0)])
def test_a_tendon_is_drawn_as_long_as_the_model_has_it(order, size):
    """Of a link that bends a little, or far, beside the tube; one that runs inside the tube is drawn on it."""
    outside = [{"name": "a", "from": 0.1, "to": 0.9, "at": [[0.0, 0.05, 0.02], [0.0, 0.02, 0.06]]}]
    inside = [{"name": "b", "at": [[0.0, 0.0, 0.001], [0.0, 0.0, 0.0]]}]
    one = link("one", modes={"bending_y": 2, "bending_z": 1}, tendons=outside + inside)
    model = model_of(arm(one) | {"order": order})
    q = np.append(np.zeros(model.chain.eta_q), np.array([0.05, -0.01, 0.03]) * size)
    drawn = scene(model)
    tendons = [x for x in solids(drawn, 0) if x.color == THREAD]
    lines = [Bend(drawn["links"][0]).moved(x, tendons[0]).reshape(-1, 5, 3).mean(axis=1) for x in (0 * q, q)]
    before, after = (np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in lines)
    change = model.numpy().tendon_length(q)[0] - model.numpy().tendon_length(0 * q)[0]
    assert abs(change) > 1e-3 * size and after - before == pytest.approx(change, rel=0.02)
    assert np.linalg.norm(drawn["links"][0]["tendons"][1]["offsets"], axis=1).min() > drawn["links"][0]["radius"]


@pytest.mark.parametrize("axes", [["y"], ["z", "y"], ["y", {"slide": "x"}]])
def test_a_cylinder_is_drawn_as_long_as_the_law_of_cosines_has_it(axes):
    k = axes.index("y")
    drives = [{"transmission": {"crank": 0.3, "base": 0.5, "angle": 0.9}} if x == "y" else {} for x in axes]
    first = link("first", axes=["z"])
    joint = {"axes": axes, "drives": drives, "mount": {"xyz": [0.1, 0.2, 0.3], "rpy": [0.3, -0.4, 0.5]}}
    model = model_of(arm(first, link("boom") | {"joint": joint}))
    q = np.array([0.4, 0.3, -0.5, *[0.0] * 9])[: model.nq]
    drawn, (R, r) = scene(model)["links"][1], model.numpy().link_pose(q)
    (found,) = drawn["cylinders"]
    near, far = eyes(drawn, found, R[1], r[1], q)
    expected = np.sqrt(0.3**2 + 0.5**2 - 2 * 0.3 * 0.5 * np.cos(q[1 + k] + 0.9))
    assert np.linalg.norm(far - near) == pytest.approx(expected, rel=1e-12)
    still = q.copy()
    still[1 + k :] = 0.0
    unmoved, _ = eyes(drawn, found, *(x[1] for x in model.numpy().link_pose(still)), still)
    assert unmoved == pytest.approx(near, abs=1e-12)


@pytest.mark.parametrize("rest", [0.3, 3.0], ids=["taut", "slack"])
def test_springs_and_ropes_are_drawn_from_end_to_end_and_ropes_as_long_as_they_are(rest):
    """With the modes magnified: the ends follow these, and what a rope is longer than its way does not."""
    model = sprung_model(rest)
    q, v = state(model)
    actor = Actor(still(model, q), model, "", 10.0)
    seen = actor.at(np.zeros(1))[0]
    at, magnified = ends(model, q, v), ends(model, seen, v)
    _, r = model.numpy().tip_poses(seen)
    for line, (a, b) in zip(actor.scene["lines"], (("upper.eye", "lower.tip"), ("world", "lower.tip")), strict=True):
        spare = line["rest"] - np.linalg.norm(at[b][0] - at[a][0])
        found = lines.path(line, *lines.ends(line, r), actor.down, spare)
        assert found[[0, -1]] == pytest.approx(np.array([magnified[a][0], magnified[b][0]]), abs=1e-12)
        way, long = np.linalg.norm(found[-1] - found[0]), np.linalg.norm(np.diff(found, axis=0), axis=1).sum()
        aside = np.linalg.norm(np.cross(found - found[0], (found[-1] - found[0]) / way), axis=1).max()
        if line["drawn"] == "spring":
            assert aside == pytest.approx(line["wide"], rel=0.01)
        else:
            assert long == pytest.approx(way + max(spare, 0.0), rel=1e-9) and (spare > 0.5) == (rest == 3.0)
    faces = actor.faces(seen)
    assert len(faces) == len(actor.colors)
    whole = len(lines.faces(line, *lines.ends(line, r), actor.down, spare)[0])
    wire = faces[-whole:][: lines.SIDES * (len(found) - 1)].reshape(len(found) - 1, lines.SIDES, 4, 3).mean(axis=1)
    assert np.linalg.norm(wire[:, 3] - wire[:, 0], axis=1).sum() == pytest.approx(long, rel=1e-6)


def test_what_touches_is_drawn_where_the_law_has_it():
    """Spheres are as far from a plane, which a link carries, and from each other as their depths say."""
    model, law = touching(), {"radius": 0.12, "other": 0.3}
    (q, v), names = state(model), list(model.force_quantities)
    found, (R, r) = scene(model)["surfaces"], model.numpy().tip_poses(q)
    poses = [(np.eye(3), np.zeros(3)) if x["link"] < 0 else (R[x["link"]], r[x["link"]]) for x in found]
    centres = [at + turn @ x["at"] for x, (turn, at) in zip(found, poses, strict=True)]
    assert [x.get("ball") for x in found] == [0.12, *[None] * 5, 0.12, 0.3]
    depth = dict(zip(names, model.numpy().force_quantities(q, v), strict=True))
    wall = found[1]
    normal = poses[1][0] @ Rotation.from_quat(wall["turn"]).as_matrix()[:, 0]
    gap = (centres[0] - centres[1]) @ normal - wall["box"][0] / 2 - law["radius"]
    assert gap == pytest.approx(-depth["wall.depth"], abs=1e-12)
    gap = np.linalg.norm(centres[6] - centres[7]) - law["radius"] - law["other"]
    assert gap == pytest.approx(-depth["ball.depth"], abs=1e-12)
    actor = Actor(still(model, q), model, "", 1.0)
    assert len(actor.faces(q)) == len(actor.colors)
    drawn = actor.faces(q).reshape(-1, 3)
    for k in (0, 7):
        from_centre = np.linalg.norm(drawn - centres[k], axis=1)
        assert (np.abs(from_centre - found[k]["ball"]) < 1e-9).sum() > 500


@pytest.mark.parametrize(("q", "hangs"), [(0.0, False), (1.3, True), (-1.3, False)])
def test_the_foot_is_above_a_robot_that_hangs(q, hangs):
    model = model_of(arm(link("one", axes=["y"])))
    drawn = scene(model, None, np.array([q]))
    assert drawn["links"][0]["hangs"] == hangs
    (foot,) = [x for x in solids(drawn, 0) if x.to == "world"]
    assert (foot.points[:, 2].mean() > 0) == hangs
