"""The viewer's pages in headless Chromium: where things are drawn, that nothing is asked for, what a picture takes."""

import itertools

import numpy as np
import pytest
from browser import Browser
from conftest import package, require_tool
from dressed_arm import corners, dressed, posture, still
from force_robots import sprung_model, state, touching
from helpers import ROOT, arm, link, model_of
from scipy.spatial.transform import Rotation

import screwgen
from screwgen.simulation.controllers import PD
from screwgen.viewer import lines
from screwgen.viewer.film import Actor
from screwgen.viewer.view import view

pytestmark = pytest.mark.examples
SIZE, LARGE = (800, 600), (1200, 1100)
NEAR = 2.0
"""Pixels between the middle of the drawn end of a tube and its computed place."""
COLORS = ((255, 0, 0), (0, 255, 0))
END = 0.025
"""How far before the end of a link, over its length, the middle of what is coloured lies."""


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    with Browser(require_tool("chromium"), tmp_path_factory.mktemp("chromium"), SIZE) as found:
        yield found


@pytest.fixture(scope="module")
def ella():
    model = screwgen.derive(screwgen.load(ROOT / "examples" / "ella.toml"))
    law = PD((400.0, 400.0, 120.0), (28.0, 28.0, 12.0), (-0.5, 0.7, 0.4), duration=0.8, q_start=(0.0,) * 3)
    robot = model.robot
    joints = [x.joint.model_copy(update={"armature": (0.2,) * len(x.joint.axes)}) for x in robot.links]
    links = [x.model_copy(update={"joint": j}) for x, j in zip(robot.links, joints, strict=True)]
    model = screwgen.derive(robot.model_copy(update={"links": tuple(links)}))
    return model, screwgen.simulate(model, 1.0, 1e-3, controller=law)


def opened(browser, tmp_path, page) -> None:
    browser.events.clear()
    page.save(tmp_path / "page.html")
    browser.open(tmp_path / "page.html")


def quiet(browser) -> None:
    """Nothing but the page itself was asked for, and nothing complained."""
    assert len(browser.requests) == 1 and browser.requests[0].startswith("file:")
    assert browser.complaints == []


def magnified(model, q: np.ndarray, factor: float) -> np.ndarray:
    return np.append(q[: model.chain.eta_q], factor * q[model.chain.eta_q :])


def pixels(browser, points: np.ndarray) -> np.ndarray:
    """Where points (n, 3) are by the page's camera, computed here."""
    box = browser.run("(({left, top, width, height}) => [left, top, width, height])"
                      "(document.getElementById('space').getBoundingClientRect())")  # fmt: skip
    matrix = np.array(browser.run("screwgen.camera().matrix")).reshape(4, 4)
    clip = np.column_stack([points, np.ones(len(points))]) @ matrix.T
    flat = clip[:, :2] / clip[:, 3:]
    return np.array(box[:2]) + (flat * [1, -1] + 1) / 2 * box[2:]


def drawn(picture: np.ndarray, color) -> np.ndarray:
    """The middle of the pixels of a colour; a pixel's place is its middle."""
    wanted = np.array(color) > 0
    near = (picture[:, :, wanted] > 150).all(axis=2) & (picture[:, :, ~wanted] < 60).all(axis=2)
    rows, columns = np.nonzero(near)
    assert len(rows) > 3, f"nothing has the colour {color}"
    return np.array([columns.mean() + 0.5, rows.mean() + 0.5])


def marked(browser, k: int, color, time: float) -> np.ndarray:
    """The middle of the end of link k's tube, which alone is drawn."""
    browser.run(f"screwgen.mark({k}, 'rgb{color}'), screwgen.seek({time}), screwgen.settled()")
    return drawn(browser.picture(), color)


def ends(model, q: np.ndarray) -> np.ndarray:
    """The middles (2, 3) of what is coloured, at elbow and tip."""
    R, r = model.numpy().tip_poses(q)
    return r - END * np.array([x.length for x in model.robot.links])[:, None] * R[:, :, 0]


@pytest.mark.parametrize("factor", [1, 10])
def test_elbow_and_tip_are_drawn_where_they_are(browser, ella, tmp_path, factor):
    """At ten times, against the model's own poses; and the links are seen to bend."""
    model, run = ella
    browser.resize(*LARGE)
    opened(browser, tmp_path, view(run))
    browser.run(f"screwgen.play(false), screwgen.magnify({factor}), screwgen.look()")
    bends = 0.0
    for row in np.linspace(0, len(run.t) - 1, 10).round().astype(int):
        found = np.array([marked(browser, k, color, run.t[row]) for k, color in enumerate(COLORS)])
        expected = pixels(browser, ends(model, magnified(model, run.q[row], factor)))
        straight = pixels(browser, ends(model, magnified(model, run.q[row], 0)))
        assert np.linalg.norm(found - expected, axis=1).max() < NEAR, (row, found, expected)
        bends = max(bends, float(np.linalg.norm(found - straight, axis=1).max()))
    browser.resize(*SIZE)
    assert bends > (6 if factor == 1 else 40)
    quiet(browser)


def test_the_picture_has_room_for_bodies_and_is_filled(browser, tmp_path):
    """The gantry's counterweights and payload: inside, beside the title, above the floor, and not small."""
    model = screwgen.derive(screwgen.load(ROOT / "examples" / "gantry.toml"))
    run = still(model, np.zeros(model.nq))
    browser.resize(*LARGE)
    opened(browser, tmp_path, view(run))
    (R, r), scene = model.numpy().link_pose(run.q[0]), browser.run("screwgen.data.scenes[0]")
    points = []
    for i, each in enumerate(scene["links"]):
        for body in each["bodies"]:
            half = np.full(3, body["ball"] / np.sqrt(3)) if "ball" in body else np.array(body["box"]) / 2
            turn = Rotation.from_quat(body.get("turn", [0, 0, 0, 1])).as_matrix()
            signs = np.array(list(itertools.product((-1, 1), repeat=3)))
            points.append(r[i] + (np.array(body["at"]) + (signs * half) @ turn.T) @ R[i].T)
    found = pixels(browser, np.concatenate(points))
    width, height = browser.run(
        "[...['width', 'height']].map(x => document.getElementById('stage').getBoundingClientRect()[x])"
    )
    assert found[:, 0].min() > 20 and found[:, 0].max() < width - 20
    assert found[:, 1].min() > 60 and found[:, 1].max() < height - 40
    assert np.ptp(found[:, 1]) > 0.8 * (height - 106)
    assert browser.run("screwgen.ground") < min(x[:, 2].min() for x in points)
    browser.resize(*SIZE)
    quiet(browser)


def carried():
    """Order 2, a link carried in the middle of another, a frame along the centreline, and segments."""
    modes = {"axial": 1, "bending_y": 1, "bending_z": 2, "torsion": 1}
    first = link("first", modes=modes, frame_at=0.2)
    return model_of(
        arm(first, link("side", modes=modes, parent="first", at={"s": 0.3}), link("last", modes=modes, segments=3))
        | {"order": 2}
    )


def hooked():
    """A link in segments that is curved at rest carries another; the model has points enough to be the page's curve."""
    rest = [{"at": 0.0, "bending_y": 0.8, "torsion": 0.5}, {"at": 1.0, "bending_y": 1.5, "torsion": -0.5}]
    modes = {"bending_y": 2, "bending_z": 1, "torsion": 1, "points": 20}
    first = link("first", modes=modes, rest=rest, segments=2)
    return model_of(
        arm(first, link("side", modes=modes, parent="first", at={"s": 0.3}, rest=rest)) | {"order": "exact"}
    )


MADE = {"carried": carried, "hooked": hooked}


POSED = ("space_arm", "gantry", "crane", "parallelogram", "finger_on_wall", "ship_crane")


@pytest.mark.parametrize("name", [*MADE, *POSED])
def test_poses_are_those_of_the_model(browser, tmp_path, name):
    """Trees, loops, bases that float or move, slides, stations, segments, order 2, curved rods: frames and tips."""
    model = MADE[name]() if name in MADE else screwgen.derive(screwgen.load(ROOT / "examples" / f"{name}.toml"))
    random = np.random.default_rng(1)
    base, eta = model.chain.base_q, model.chain.eta_q
    q = np.concatenate(
        [model.chain.home[:base], random.normal(size=eta - base), 0.05 * random.normal(size=model.nq - eta)]
    )
    if base:
        q[:7] = [0.3, -0.2, 0.5, 0.5, -0.5, 0.1, np.sqrt(1 - 0.51)]
    opened(browser, tmp_path, view(still(model, q)))
    for factor in (1, 2):
        browser.run(f"screwgen.magnify({factor}), screwgen.seek(0.5)")
        for key, poses in (("frame", "link_pose"), ("tip", "tip_poses")):
            place = browser.run(f"screwgen.poses().map((x) => x.{key}.at)")
            _, expected = getattr(model.numpy(), poses)(magnified(model, q, factor))
            assert np.array(place) == pytest.approx(expected, abs=2e-5)
    quiet(browser)


@pytest.mark.parametrize("factor", [1, 4])
def test_meshes_are_drawn_where_they_are(browser, tmp_path, factor):
    """Boxes of four kinds of files, by the pixels that their corners span; that at the tip bends with its link."""
    package("trimesh")
    (tmp_path / "arm_description").mkdir()
    urdf, model = dressed(tmp_path / "arm_description")
    q = posture(model, 0.02)
    browser.resize(*LARGE)
    with pytest.warns(screwgen.ImportNote, match="none.stl"):
        opened(browser, tmp_path, view(still(model, q), meshes=urdf))
    browser.run(f"screwgen.play(false), screwgen.magnify({factor}), screwgen.look(), screwgen.settled()")
    assert "Meshes" in browser.run("document.getElementById('switches').textContent")
    colors = browser.run("screwgen.data.scenes[0].meshes.map((x) => x.color)")
    straight = corners(model, magnified(model, q, 0))
    for color, expected in corners(model, magnified(model, q, factor)).items():
        browser.run(f"screwgen.markMesh({colors.index(color)}, 'rgb(255, 0, 0)'), screwgen.settled()")
        picture = browser.picture()
        rows, columns = np.nonzero((picture[:, :, 0] > 120) & (picture[:, :, 1:] < 60).all(axis=2))
        found = np.array([columns.min(), rows.min(), columns.max() + 1, rows.max() + 1])
        flat = pixels(browser, expected)
        assert np.abs(found - np.append(flat.min(axis=0), flat.max(axis=0))).max() < NEAR, color
        assert np.linalg.norm(pixels(browser, straight[color]) - flat, axis=1).min() > (2 if factor == 1 else 15)
    browser.resize(*SIZE)
    quiet(browser)


def test_page_is_small_and_its_pictures_ask_little(browser, ella, tmp_path):
    """Calls and triangles of a picture, of which a slow machine has as many as a fast one."""
    _, run = ella
    size = len(view(run).html) - len((ROOT / "templates/view/three/three.min.js").read_text())
    assert size < 4e5
    opened(browser, tmp_path, view(run))
    browser.run("screwgen.settled()")
    cost = browser.run("screwgen.cost()")
    print(f"{cost}, first picture after {browser.run('screwgen.ready'):.0f} ms")
    assert 0 < cost["calls"] < 30 and 0 < cost["triangles"] < 15_000
    quiet(browser)


def test_ghost_themes_and_widths(browser, ella, tmp_path):
    """Both runs are drawn; a dark page is dark; on a telephone nothing is wider than the page."""
    _, run = ella
    opened(browser, tmp_path, view(run, run, labels=["one", "two"]))
    assert "two" in browser.run("document.getElementById('legend').textContent")
    browser.run("screwgen.theme(true), screwgen.seek(0.5), screwgen.settled()")
    assert browser.picture(tmp_path / "dark.png")[:300].mean() < 60
    browser.run("screwgen.theme(false), screwgen.seek(0.5), screwgen.settled()")
    assert browser.picture()[:300].mean() > 200
    browser.resize(390, 844, mobile=True)
    assert browser.run("document.documentElement.scrollWidth") <= 390
    browser.resize(*SIZE)
    quiet(browser)


def test_cylinders_are_as_long_as_in_the_model_and_small_bending_is_magnified(browser, tmp_path):
    """Of the crane that sags by millimetres; a linkage, which magnified modes would open, is drawn as it is."""
    model = screwgen.derive(screwgen.load(ROOT / "examples" / "crane.toml"))
    q = np.append([0.3, -0.2, 0.4], np.full(model.nq - 3, 1e-3))
    opened(browser, tmp_path, view(still(model, q)))
    factor = browser.run("screwgen.state.magnified")
    assert factor > 1 and f"bending drawn × {factor}" in browser.run("document.getElementById('legend').textContent")
    for name in ("heel", "jib"):
        k = model.chain.names.index(name)
        place = model.parameter_names.index(f"{name}.joint.drives[0].transmission.crank")
        a, b, angle = model.parameter_values[place : place + 3]
        u = angle + q[model.chain.q_offset[k]]
        ((near, far),) = browser.run(f"screwgen.eyes({k})")
        assert np.linalg.norm(np.subtract(far, near)) == pytest.approx(np.sqrt(a * a + b * b - 2 * a * b * np.cos(u)))
    closed = screwgen.derive(screwgen.load(ROOT / "examples" / "parallelogram.toml"))
    opened(browser, tmp_path, view(still(closed, np.array(closed.chain.home, float))))
    assert browser.run("screwgen.state.magnified") == 1
    quiet(browser)


@pytest.mark.parametrize("factor", [1, 10])
def test_lines_of_forces_are_those_of_films(browser, tmp_path, factor):
    """A coil, whose turn about its axis is free, and a rope that hangs."""
    model = sprung_model(3.0)
    q, _ = state(model)
    opened(browser, tmp_path, view(still(model, q)))
    browser.run(f"screwgen.magnify({factor}), screwgen.seek(0.5)")
    actor = Actor(still(model, q), model, "", factor)
    _, tips = model.numpy().tip_poses(actor.at(np.zeros(1))[0])
    for line, points in zip(actor.scene["lines"], map(np.array, browser.run("screwgen.lines()")), strict=True):
        real = np.subtract(*lines.ends(line, model.numpy().tip_poses(q)[1]))
        near, far = lines.ends(line, tips)
        expected = lines.path(line, near, far, actor.down, line["rest"] - np.linalg.norm(real))
        assert points[[0, -1]] == pytest.approx(expected[[0, -1]], abs=2e-5)
        if line["drawn"] == "rope":
            assert points == pytest.approx(expected, abs=1e-4) and np.ptp(points[:, 2]) > 0.5
        else:
            from_axis = [np.linalg.norm(np.cross(x - near, far - near), axis=1) for x in (points, expected)]
            assert from_axis[0] == pytest.approx(from_axis[1], abs=1e-4) and from_axis[0].max() > 5e-3
    quiet(browser)


def test_what_touches_is_where_films_have_it(browser, tmp_path):
    model = touching()
    q, _ = state(model)
    opened(browser, tmp_path, view(still(model, q)))
    browser.run("screwgen.seek(0.5)")
    (R, r), found = model.numpy().tip_poses(q), Actor(still(model, q), model, "", 1.0).scene["surfaces"]
    expected = [x["at"] if x["link"] < 0 else r[x["link"]] + R[x["link"]] @ x["at"] for x in found]
    assert np.array(browser.run("screwgen.touching()")) == pytest.approx(np.array(expected), abs=2e-5)
    quiet(browser)
