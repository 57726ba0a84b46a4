"""Mode shapes against the oracle, and their picture."""

from itertools import combinations

import numpy as np
import pytest
import random_robots as rr
from figures import collisions, laid_out, outside
from helpers import arm, example, link, model_of

from screwgen import UsageError
from screwgen.cli.main import main
from screwgen.plotting.look import view
from screwgen.plotting.mode_plot import STATIONS, TURN, amplified, field, figure, meaning, png, sections
from screwgen.simulation.motion import centrelines
from screwgen.studies.modes import mode_shapes

SETPOINTS = [-0.4928, 0.6922, 0.4270]


def posture(model, joints=SETPOINTS):
    return np.append(joints, np.zeros(model.nq - len(joints)))


def test_centrelines_run_from_joint_to_tip():
    model = example("six_link")
    q = np.random.default_rng(0).uniform(-0.5, 0.5, model.nq) * np.where(np.arange(model.nq) < 6, 1.0, 0.02)
    lines, tips = centrelines(model, q, STATIONS), model.numpy().tip_poses(q)[1]
    assert lines.shape == (6, len(STATIONS), 3) and np.allclose(lines[:, -1], tips, atol=1e-12)
    straight = centrelines(model, posture(model, [0.3] * 6), STATIONS)
    lengths = np.linalg.norm(np.diff(straight, axis=1), axis=2).sum(axis=1)
    assert np.allclose(lengths, [x.length for x in model.robot.links])


def test_the_field_is_the_clamped_beams():
    """One beam, bending in y: its first mode is the basis's first shape, however large; at mid-length 0.3395."""
    soft = link("beam", 2.0, [], modes={"bending_y": 3}, section={"EIz": 50.0})
    model = model_of(arm(soft, gravity=(0, 0, 0)))
    q, found = np.zeros(model.nq), mode_shapes(model)
    motion = field(model, q, found.shapes[:, 0]).motion[0]
    assert not motion[:, [0, 2]].any() and not motion[0].any()
    share = motion[:, 1] / motion[-1, 1]
    assert abs(share[len(STATIONS) // 2] - 0.3395) < 1e-4 and (np.diff(share) > 0).all()
    drawn = amplified(centrelines(model, q, STATIONS), field(model, q, -7 * found.shapes[:, 0])).motion
    assert np.allclose(drawn[0, -1], [0, 0.15 * 2.0, 0], atol=1e-9)


def test_the_view_shows_the_motion():
    line = np.linspace([0, 0, 0], [1, 0, 0], 9)[None]
    up, sideways = (np.linspace(0, 1, 9)[None, :, None] * np.eye(3)[k] for k in (2, 1))
    assert view(line, up)[0] < 30 < view(line, sideways)[0]


def test_words_say_where_the_energy_is():
    model = example("ella")
    found = mode_shapes(model, posture(model))
    assert meaning(model, found.shapes[:, 0]).startswith("bending in z of upper_arm, 9")
    sprung = model_of(arm(link("rod", axes="z", joint={"stiffness": [5.0]})))
    assert meaning(sprung, np.ones(1)) == "joint spring of rod, 100 % of its energy"


def shaft():
    """A straight link that twists alone."""
    return model_of(arm(link("shaft", 2.0, "x", modes={"torsion": 2}, section={"GJ": 50.0, "rhoIp": 1e-3})))


def test_torsion_turns_sections_and_leaves_a_straight_centreline_straight():
    model = shaft()
    q, found = np.zeros(model.nq), mode_shapes(model)
    drawn = amplified(centrelines(model, q, STATIONS), field(model, q, -found.shapes[:, 0]))
    assert not drawn.motion.any() and list(drawn.turns) == [0]
    assert drawn.turns[0][0] == 0 and abs(drawn.turns[0][-1] - TURN) < 1e-9 and (np.diff(drawn.turns[0]) > 0).all()
    assert png(model, q, found) == png(model, q, found)
    picture = figure(model, q, found)
    edges = [np.array(line.get_data_3d()).T for line in picture.axes[0].lines if len(line.get_xdata()) == 5]
    tip = [square[:4] - square[:4].mean(axis=0) for square in edges if np.allclose(square[:, 0], 2.0)]
    assert len(tip) == 2, "at rest and turned"
    between = np.arccos(np.clip(tip[0][0] @ tip[1][0] / (tip[0][0] @ tip[0][0]), -1, 1))
    assert abs(between - TURN) < 1e-6


def test_torsion_of_one_link_turns_what_it_carries():
    """The upper arm's section at the elbow turns by as much as the forearm's base tilts; in all modes of the arm."""
    model = example("six_link")
    q, found = np.zeros(model.nq), mode_shapes(model)
    R, step = model.numpy().link_pose(q)[0], 1e-6
    for shape in found.shapes.T:
        moved = field(model, q, shape)
        turned = (model.numpy().link_pose(q + step * shape)[0][2] - R[2]) @ R[2].T / step * np.abs(shape).max() ** -1
        about = np.array([turned[2, 1], turned[0, 2], turned[1, 0]]) @ R[1][:, 0]
        assert list(moved.turns) == [1] and np.isclose(moved.turns[1][-1], about, atol=1e-4)


def test_sections_are_squares_across_the_line():
    line = np.column_stack([STATIONS, 0.2 * STATIONS**2, 0 * STATIONS])
    corners = sections(line, np.eye(3), np.linspace(0, 1, len(STATIONS)), 0.1)
    assert np.allclose(corners[:, :4].mean(axis=1), line) and np.allclose(corners[:, 0], corners[:, 4])
    sides = np.linalg.norm(np.diff(corners, axis=1), axis=2)
    assert np.allclose(sides, 0.2)
    tangent = np.gradient(line, axis=0)
    assert np.allclose(np.einsum("sk,sck->sc", tangent, corners - line[:, None]), 0, atol=1e-12)


@pytest.mark.parametrize("make", [lambda: example("six_link"), shaft], ids=["six_link", "shaft"])
def test_nothing_collides(make):
    model = make()
    picture = laid_out(figure(model, np.zeros(model.nq), mode_shapes(model)))
    assert not collisions(picture) and not outside(picture)


@pytest.mark.parametrize("joints", ["locked", "free"])
def test_picture(joints):
    model = example("ella")
    q = posture(model)
    found = mode_shapes(model, q, joints)
    picture = figure(model, q, found)
    titles = [text.get_text() for text in picture.texts if text.get_text().endswith(" Hz")]
    assert titles == [f"{k + 1}: {f:.4g} Hz" for k, f in enumerate(found.frequencies[:6])]
    assert len(picture.axes) == len(titles)


def test_command_draws_and_prints(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "rod.toml").write_text(rr.to_toml(arm(link("rod", modes={"basis": "clamped_free", "bending_y": 1}))))
    assert main(["modes", "rod.toml", "--plot", "rod.png"]) == 0
    out = capsys.readouterr()
    assert out.err == "" and out.out.count(" Hz") == 1 and (tmp_path / "rod.png").read_bytes().startswith(b"\x89PNG")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["rod.png", "rod.toml"]


def test_without_modes_there_is_nothing_to_draw():
    model = model_of(arm(link("rod")))
    with pytest.raises(UsageError, match="no modes to draw"):
        figure(model, np.zeros(1), mode_shapes(model))


def test_words_on_modes_stay_in_their_panel():
    name = "the_second_link_of_the_machines_left_arm"
    model = model_of(arm(link(name, 1.0, [], modes={"bending_y": 3}), gravity=(0, 0, 0)))
    picture = laid_out(figure(model, np.zeros(model.nq), mode_shapes(model)))
    assert len(picture.axes) == 3 and not collisions(picture) and not outside(picture)
    words = [text.get_window_extent() for text in picture.texts if text.get_text()]
    assert all(box.width < picture.bbox.width / 3 for box in words)


def test_the_height_is_named_beside_its_numbers():
    """And not midway to the next panel."""
    model = example("gantry")
    picture = laid_out(figure(model, np.zeros(model.nq), mode_shapes(model)))
    renderer = picture.canvas.get_renderer()
    for axis in (axes.zaxis for axes in picture.axes):
        word, both = axis.label.get_window_extent().width, axis.get_tightbbox(renderer).width
        axis.label.set_text("")
        assert word < both - axis.get_tightbbox(renderer).width < 3 * word


def test_numbers_along_short_axes_do_not_cover_each_other():
    """Of an upright arm two axes are short, and their numbers stand side by side."""
    upright = {"mount": {"rpy": [0.0, -np.pi / 2, 0.0]}}
    model = model_of(arm(link("pole", 1.0, [], modes={"bending_y": 1, "bending_z": 1}, joint=upright)))
    picture = laid_out(figure(model, np.zeros(model.nq), mode_shapes(model)))
    for axes in picture.axes:
        boxes = []
        for name in "xyz":
            axis, (low, high) = getattr(axes, f"{name}axis"), getattr(axes, f"get_{name}lim")()
            pairs = zip(axis.get_majorticklocs(), axis.get_major_ticks(), strict=True)
            ticks = [tick for x, tick in pairs if low <= x <= high]
            assert len(ticks) > 2 * (name == "z")
            boxes += [tick.label1.get_window_extent() for tick in ticks]
        assert not any(a.overlaps(b) for a, b in combinations(boxes, 2))
