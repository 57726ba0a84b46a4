"""Visuals of URDFs on robots that came from them: where they are, what is said of those that cannot be read."""

import dataclasses
import sys

import numpy as np
import pytest
from conftest import package
from dressed_arm import LENGTH, corners, dressed, posture, still
from scipy.spatial.transform import Rotation

import screwgen
from screwgen.cli.main import main
from screwgen.errors import RobotFileError, UsageError
from screwgen.viewer.film import Actor
from screwgen.viewer.meshes import read_looks
from screwgen.viewer.shapes import sections
from screwgen.viewer.view import read_run

package("trimesh")


@pytest.fixture(scope="module")
def arm(tmp_path_factory):
    folder = tmp_path_factory.mktemp("robots") / "arm_description"
    folder.mkdir()
    return dressed(folder)


def faces(model, urdf, q) -> dict[str, np.ndarray]:
    """The corners of all faces of each colour, inertial frame."""
    actor = Actor(still(model, q), model, "run", 1.0, read_looks(urdf))
    colors = np.rint(255 * actor.colors).astype(int)
    found = actor.faces(q)
    names = np.array([f"#{r:02x}{g:02x}{b:02x}" for r, g, b in colors])
    return {str(name): found[names == name].reshape(-1, 3) for name in np.unique(names)}


@pytest.mark.parametrize("segments", [1, 3])
def test_visuals_are_where_the_links_are(tmp_path, segments):
    """Boxes of ASCII and binary STL, OBJ with a scale, DAE in millimetres: at the tip of what bends, and behind."""
    urdf, model = dressed(tmp_path, segments)
    (tmp_path / "arm_description").symlink_to(tmp_path)
    q = posture(model)
    found, bends = faces(model, urdf, q), faces(model, urdf, np.where(np.arange(model.nq) < model.chain.eta_q, q, 0))
    for color, expected in corners(model, q).items():
        away = np.linalg.norm(found[color][:, None] - expected, axis=2)
        assert away.min(axis=0).max() < 1e-7, color
        assert away.min(axis=1).max() < 1e-7 or color == "#ff0000", color  # edges of what bends are cut
        assert np.linalg.norm(found[color].mean(axis=0) - bends[color].mean(axis=0)) > 0.02
    center = found["#ff00ff"].mean(axis=0)
    assert center == pytest.approx(np.zeros(3), abs=1e-3)  # the stand
    assert np.linalg.norm(found["#ff00ff"] - center, axis=1) == pytest.approx(0.06, abs=1e-3)


def test_box_bends_with_its_sections(arm):
    """Every point of a long box is where the section says in which it lies; long edges are cut."""
    urdf, model = arm
    q = posture(model)
    R, r = model.numpy().link_pose(q)
    own = (faces(model, urdf, q)["#00ffff"] - r[0]) @ R[0]
    R, r = model.numpy().link_pose(0 * q)
    straight = (faces(model, urdf, 0 * q)["#00ffff"] - r[0]) @ R[0]
    assert len(own) > 500 and np.ptp(straight, axis=0) == pytest.approx([LENGTH, 0.04, 0.04], abs=1e-9)
    s = straight[:, 0] / LENGTH
    eta = q[model.chain.eta_q :][: model.chain.keys[0].modes]
    places, inverse = np.unique(s.round(12).clip(0, 1), return_inverse=True)
    moved = np.einsum("k,skc->sc", eta, sections(model.chain.keys[0], LENGTH, places).columns)[inverse]
    offsets = Rotation.from_rotvec(moved[:, 3:]).apply(straight * [0, 1, 1])
    expected = moved[:, :3] + offsets + straight * [1, 0, 0]
    assert np.abs(own - expected).max() < 5e-4 and np.abs(own - straight).max() > 0.03


def test_what_cannot_be_read_is_said(arm, tmp_path, capsys):
    """One line each, the page is drawn without; sizes are stated."""
    urdf, model = arm
    (urdf.parent / "meshes" / "broken.stl").write_text("nothing")
    text = urdf.read_text().replace("meshes/hook.obj", "meshes/broken.stl")
    other = urdf.with_name("other.urdf")
    other.write_text(text)
    still(model, posture(model)).save(tmp_path / "run.npz")
    run, page = str(tmp_path / "run.npz"), str(tmp_path / "run.html")
    assert main(["view", run, "--meshes", str(other), "-o", page]) == 0
    said = capsys.readouterr()
    assert said.out == f"{page}\n" and "triangles of 6 visuals" in said.err and " MB" in said.err
    missing = "there is no file package://nowhere/none.stl; it is drawn without; set ROS_PACKAGE_PATH to the folder"
    assert f"link 'fore': {missing} that holds the folder 'nowhere'\n" in said.err
    assert "broken.stl cannot be read" in said.err and said.err.count("\n") == 4
    line = "solid s facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 2 0 0 endloop endfacet endsolid"
    (urdf.parent / "meshes" / "broken.stl").write_text(line.replace(" ver", "\nver").replace(" end", "\nend"))
    other.write_text(text.replace("package://nowhere/none.stl", 300 * "x" + ".stl"))
    assert sum("xxx.stl; it is drawn without" in x for x in read_looks(other).notes) == 1
    assert sum("it holds no triangles that have an area" in x for x in read_looks(other).notes) == 1
    with pytest.warns(screwgen.ImportNote, match="there is no file"):
        html = screwgen.view(still(model, posture(model)), meshes=urdf).html
    assert html.count('"color":"#0000ff"') == 1


def test_colours_of_a_visual_are_those_of_its_name_elsewhere(arm):
    urdf, _ = arm
    other = urdf.with_name("other.urdf")
    other.write_text(urdf.read_text().replace('<material name="named"/>', '<material name="m0 0 1"/>'))
    colors = [{part.color for part in read_looks(path).parts if part.link == "upper"} for path in (urdf, other)]
    assert colors == [{"#00ffff", "#ff0000"}, {"#0000ff", "#ff0000"}]


def test_meshes_are_found_by_the_package_path(arm, tmp_path, monkeypatch):
    """Where they do not lie above the URDF."""
    urdf, _ = arm
    moved = tmp_path / "arm.urdf"
    moved.write_text(urdf.read_text().replace('"meshes/', '"package://arm_description/meshes/'))
    assert sum("there is no file" in note for note in read_looks(moved).notes) == 5
    monkeypatch.setenv("ROS_PACKAGE_PATH", f"/nowhere:{urdf.parents[1]}")
    assert sum("there is no file" in note for note in read_looks(moved).notes) == 1


def test_refusals(arm, tmp_path, capsys, monkeypatch):
    """One line each, and nothing is written."""
    urdf, model = arm
    still(model, posture(model)).save(tmp_path / "run.npz")
    run, page, text = tmp_path / "run.npz", tmp_path / "run.html", urdf.read_text()
    for old, new, said in [
        (f"0 0 {LENGTH}", "0 0 .7", "'fore' of run.npz is 0.1 m away from it at zero coordinates; name the URDF"),
        ('"upper"', '"x"', None),
        ('<sphere radius=".06"/>', "<cone/>", "link 'stand': geometry: must have one of <mesh>"),
        ('rgba="0 1 1 1"', 'rgba="0 2 1 1"', "each of the four must be from 0 to 1"),
        ('<sphere radius=".06"/>', '<sphere radius="-"/>', "must be a number"),
        ('<sphere radius=".06"/>', '<sphere radius="0"/>', "lengths must be > 0"),
        ('scale=".5 .5 .5"', 'scale=".5 0 .5"', 'mesh scale: is ".5 0 .5"; factors must not be 0'),
        (f'size=".04 .04 {LENGTH}"', 'size="40 40 800"', "a visual is 1e+03 times as long as the link"),
    ]:
        other = tmp_path / "other.urdf"
        other.write_text(text.replace(old, new))
        assert main(["view", str(run), "--meshes", str(other), "-o", str(page), "-q"]) == (2 if said else 0)
        error = capsys.readouterr().err
        assert error.count("\n") == bool(said) and (not said or (said in error and "other.urdf" in error))
        assert page.exists() == (not said)
        page.unlink(missing_ok=True)
    longer = {"parameters": model.chain.parameters.vector({"upper.length": 0.9})}
    with pytest.raises(UsageError, match=r"'fore' of run 1 is .* m away"):
        screwgen.view(dataclasses.replace(read_run(run), **longer), meshes=read_looks(urdf))
    foreign = text.replace("upper", "a").replace("fore", "b")
    (tmp_path / "foreign.urdf").write_text(foreign)
    with pytest.raises(UsageError, match="none of its links is one of 'dressed'"):
        screwgen.view(read_run(run), meshes=read_looks(tmp_path / "foreign.urdf"))
    with pytest.raises(RobotFileError, match="there is no such file"):
        read_looks(tmp_path / "none.urdf")
    monkeypatch.setitem(sys.modules, "trimesh", None)
    assert main(["view", str(run), "--meshes", str(urdf), "-o", str(page)]) == 2
    assert "meshes need trimesh, which is not there; pip install 'screwgen[meshes]'" in capsys.readouterr().err
