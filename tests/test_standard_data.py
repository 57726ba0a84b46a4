"""Standard input data: read, written and read again; rods as files; files with faults."""

import copy
import re

import flexible_robots as fr
import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from helpers import disagreement, model_of

from screwgen import Link, Robot, RobotFileError, UsageError, dump, load, write_sid
from screwgen.reduction.invariants import Invariants
from screwgen.reduction.sid import read_sid, sid_text
from screwgen.reduction.standard import load_sid, sid_of

JOINT = {"axes": ["y"]}
ARRAYS = ("gram", "inertia", "stiffness", "damping", "sag", "swing")
NODE_ARRAYS = ("origin", "phi", "psi", "axes", "phi2", "psi2")


def body_of(path) -> Link:
    return Link(name="part", joint=JOINT, body={"sid": str(path)})


def same(a: Invariants, b: Invariants, tolerance: float) -> bool:
    """Whether two bodies have the same numbers, each array to `tolerance` of its largest entry."""
    pairs = [(getattr(a, name), getattr(b, name)) for name in ARRAYS]
    pairs += [
        (getattr(n, name), getattr(m, name)) for n, m in zip(a.nodes, b.nodes, strict=True) for name in NODE_ARRAYS
    ]
    return all(np.abs(x - y).max(initial=0.0) <= tolerance * np.abs(x).max(initial=0.0) for x, y in pairs)


@pytest.fixture(params=[False, True], ids=["linear", "geometric"])
def file(request, tmp_path):
    path = tmp_path / "body.SID_FEM"
    cloud = fr.random_cloud(np.random.default_rng(7), 3, second=request.param, axes=True)
    path.write_text(fr.sid_text(cloud), encoding="ascii")
    return path


def test_a_file_holds_the_same_numbers_after_it_is_read_and_written(file, tmp_path):
    first = read_sid(file)
    again = tmp_path / "again.SID_FEM"
    again.write_text(sid_text(first), encoding="ascii")
    second = read_sid(again)
    assert (second.mass, second.names, list(second.parts)) == (first.mass, first.names, list(first.parts))
    nodes = [(a.parts, b.parts) for a, b in zip(first.nodes, second.nodes, strict=True)]
    for one, other in (*nodes, (first.parts, second.parts)):
        assert list(one) == list(other)
        for name, x in one.items():
            y = other[name]
            assert np.array_equal(x.m0, y.m0) and x.order == y.order, name
            assert x.m1 is None or np.array_equal(x.m1, y.m1), name


def test_a_body_holds_the_same_numbers_after_it_is_written_and_read(file, tmp_path):
    link, again = body_of(file), tmp_path / "again.SID_FEM"
    write_sid(link, again)
    assert same(link.body.data, load_sid(again), 1e-14)
    third = tmp_path / "third.SID_FEM"
    write_sid(body_of(again), third)
    assert same(load_sid(again), load_sid(third), 1e-15)


def test_every_matrix_written_is_that_of_the_definitions(tmp_path):
    """What is not read, such as Ge, mdCM's slope and Gr, is right for other programs."""
    path, cloud = tmp_path / "body.SID_FEM", fr.random_cloud(np.random.default_rng(8), 3, second=True)
    path.write_text(fr.sid_text(cloud), encoding="ascii")
    written = sid_of(load_sid(path)).parts
    for name, (m0, m1) in fr.matrices(cloud).items():
        assert np.allclose(written[name].m0, m0, rtol=0, atol=1e-13 * np.abs(m0).max(initial=1e-9)), name
        if m1 is not None:
            assert np.allclose(written[name].m1, m1, rtol=0, atol=1e-13 * np.abs(m1).max()), name


@pytest.mark.parametrize("seed", swept(range(4), 0, 1))
def test_a_rod_as_a_file_moves_as_the_rod(seed, tmp_path):
    rng = np.random.default_rng([seed, 12])
    limits = {"stations": 0.5, "rigid": 0.0, "no_section_rotation": 0.0}
    second = {"order": 2} if seed > 1 else {}
    drawn = lambda rng, n, **limits: rr.random_robot(rng, n, **limits) | second  # noqa: E731
    robot, state, oracle = rr.draw_regular(rng, 2, robots=drawn, **limits)
    model, twin = model_of(robot), copy.deepcopy(robot)
    for i, key in enumerate(model.chain.keys):
        if key.modes:
            rod, path = model.robot.links[i].model_copy(update={"order": key.order}), tmp_path / f"{i}.SID_FEM"
            write_sid(rod, path)
            kept = {name: twin["links"][i][name] for name in ("name", "joint", "bodies") if name in twin["links"][i]}
            twin["links"][i] = kept | {"body": {"sid": str(path)}}
    given = [np.array(state[name]) for name in ("q", "v", "tau", "w_ext")]
    found, expected = model_of(twin).numpy(), model.numpy()
    tolerance = max(1e-12, 10 * np.finfo(float).eps * oracle.condition(state["q"]))
    assert disagreement(oracle, expected.forward_dynamics(*given), found.forward_dynamics(*given)) < tolerance
    assert np.allclose(found.energy(*given[:2]), expected.energy(*given[:2]), rtol=1e-12)


def test_a_rigid_link_has_no_standard_data(tmp_path):
    link = Link.model_validate({"name": "post", "length": 1.0, "section": {"rhoA": 1.0}, "joint": JOINT})
    with pytest.raises(UsageError, match="link 'post' has no modes; state modes"):
        write_sid(link, tmp_path / "post.SID_FEM")


# -------- bodies whose base is elsewhere


def test_a_body_is_seen_from_its_base(tmp_path):
    """A clamped body described in a frame that is moved and turned has the same invariants about its base."""
    cloud = fr.random_cloud(np.random.default_rng(9), 2, second=True)
    turn, shift = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0], np.array([0.3, -0.2, 0.1])
    turn = turn * np.sign(np.linalg.det(turn))
    moved = moved_cloud(cloud, turn, shift)
    here, there = tmp_path / "here.SID_FEM", tmp_path / "there.SID_FEM"
    here.write_text(fr.sid_text(cloud), encoding="ascii")
    text = fr.sid_text(moved)
    base = fr.node("base", shift, np.zeros((3, 2)), np.zeros((3, 2)), turn)
    text = re.sub(r" new node = base\n.*? end node\n", lambda _: base, text, count=1, flags=re.DOTALL)
    there.write_text(text, encoding="ascii")
    assert same(load_sid(here), load_sid(there), 1e-12)


def moved_cloud(c, turn, shift):
    spun = lambda x: None if x is None else np.einsum("ab,...bkl->...akl", turn, x)  # noqa: E731
    second = {name: spun(getattr(c, name)) for name in ("second", "tip_second", "tip_turn_second")}
    return type(c)(
        masses=c.masses,
        places=c.places @ turn.T + shift,
        shapes=np.einsum("ab,nbk->nak", turn, c.shapes),
        stiffness=c.stiffness,
        tip=turn @ c.tip + shift,
        tip_shapes=turn @ c.tip_shapes,
        tip_turns=turn @ c.tip_turns,
        tip_axes=turn @ c.tip_axes,
        damping=c.damping,
        **second,
    )


def test_modes_that_move_the_base_are_taken_relative_to_it(tmp_path):
    """A body whose modes are those of a body that floats: the same points, less the rigid motion of the base."""
    cloud, rng = fr.random_cloud(np.random.default_rng(10), 2), np.random.default_rng(2)
    phi, psi = 0.3 * rng.normal(size=(3, 2)), 0.5 * rng.normal(size=(3, 2))
    rigid = lambda r: phi + np.cross(psi.T, r).T  # noqa: E731
    parts = {name: getattr(cloud, name) for name in ("masses", "places", "stiffness", "tip", "damping")}
    floating = type(cloud)(
        **parts,
        shapes=cloud.shapes + np.array([rigid(r) for r in cloud.places]),
        tip_shapes=cloud.tip_shapes + rigid(cloud.tip),
        tip_turns=cloud.tip_turns + psi,
    )
    here, there = tmp_path / "here.SID_FEM", tmp_path / "there.SID_FEM"
    here.write_text(fr.sid_text(cloud), encoding="ascii")
    base = fr.node("base", np.zeros(3), phi, psi, np.eye(3))
    text = re.sub(r" new node = base\n.*? end node\n", lambda _: base, fr.sid_text(floating), count=1, flags=re.DOTALL)
    there.write_text(text, encoding="ascii")
    assert same(load_sid(here), load_sid(there), 1e-12)


# -------- robot files


def robot_file(folder, body: str, more: str = "") -> str:
    path = folder / "arm.toml"
    joint = 'joint = { axes = ["y"] }'
    path.write_text(f'name = "arm"\ngravity = [0.0, 0.0, -9.81]\n{more}[[links]]\nname = "boom"\n{joint}\n{body}\n')
    return str(path)


def test_the_path_is_relative_to_the_robot_file_and_stays_in_it(file, monkeypatch):
    (file.parent / "elsewhere").mkdir()
    monkeypatch.chdir(file.parent / "elsewhere")
    robot = load(robot_file(file.parent, 'body = { sid = "body.SID_FEM" }'))
    assert robot.links[0].body.data.modes == 3
    assert 'body = { sid = "body.SID_FEM" }' in dump(robot)
    (file.parent / "again.toml").write_text(dump(robot))
    assert load(file.parent / "again.toml") == robot


FAULTS = {
    "sid or npz": ("{ }", "must state one of sid and npz"),
    "both": ('{ sid = "body.SID_FEM", npz = "x.npz" }', "must state one of sid and npz"),
    "no file": (
        '{ sid = "none.SID_FEM" }',
        r"none.SID_FEM: there is no such file; paths are relative to the robot file",
    ),
    "modes of a SID": ('{ sid = "body.SID_FEM", modes = 2 }', "body.modes .*stated beside sid, whose modes are given"),
    "no such node": (
        '{ sid = "body.SID_FEM", tip = "x" }',
        "there is no node 'x', which is to be the tip; it has base, tip",
    ),
    "one node": ('{ sid = "body.SID_FEM", tip = "base" }', "node 'base' is to be both base and tip"),
    "unknown key": ('{ sid = "body.SID_FEM", node = "x" }', "is an unknown key; .*known here: sid, npz, modes"),
    "a number": ("3", "is 3; it must be a table with sid or npz"),
}


@pytest.mark.parametrize(("body", "message"), FAULTS.values(), ids=FAULTS)
def test_a_fault_in_the_robot_file_has_one_line(body, message, file):
    with pytest.raises(RobotFileError, match=message) as caught:
        load(robot_file(file.parent, f"body = {body}"))
    assert "\n" not in str(caught.value) and "links[0].body" in str(caught.value)


BESIDE = {
    "length": ("length = 1.0", "links.0..length .*is stated beside body, whose file gives it; leave it out"),
    "rest": ("rest = { bending_y = 1.0 }", "links.0..rest .*is stated beside body, whose file gives it; leave it out"),
    "section": ("length = 1.0\nsection = { rhoA = 1.0 }", "stated beside body"),
    "modes": ("modes = { bending_y = 2 }", "links.0..modes .*is stated beside body, which has modes of its own"),
    "damping": ("damping = { ratio = 0.01 }", "links.0..damping .*is stated beside body, whose file has De"),
}


@pytest.mark.parametrize(("key", "message"), BESIDE.values(), ids=BESIDE)
def test_what_the_file_gives_is_not_stated_twice(key, message, tmp_path):
    cloud = fr.random_cloud(np.random.default_rng(12), 2)
    damped = type(cloud)(**{**vars(cloud), "damping": np.ones(2)})
    (tmp_path / "body.SID_FEM").write_text(fr.sid_text(damped), encoding="ascii")
    with pytest.raises(RobotFileError, match=message):
        load(robot_file(tmp_path, f'body = {{ sid = "body.SID_FEM" }}\n{key}'))


def test_order_says_whether_geometric_stiffness_is_used(tmp_path):
    plain, stiff = tmp_path / "plain.SID_FEM", tmp_path / "stiff.SID_FEM"
    rng = np.random.default_rng(13)
    plain.write_text(fr.sid_text(fr.random_cloud(rng, 2)), encoding="ascii")
    stiff.write_text(fr.sid_text(fr.random_cloud(rng, 2, second=True)), encoding="ascii")
    table = lambda path, **more: {"name": "a", "joint": JOINT, "body": {"sid": str(path)}, **more}  # noqa: E731
    orders = [
        model_of({"name": "arm", "gravity": [0, 0, 0], "links": [table(path, **more)]}).chain.keys[0].order
        for path, more in ((plain, {}), (stiff, {}), (stiff, {"order": 1}), (stiff, {"order": 2}))
    ]
    assert orders == [1, 2, 1, 2]
    with pytest.raises(RobotFileError, match=r"order.*is 2, but the body's file has no geometric stiffness"):
        Link(**table(plain, order=2))


def test_tips_with_axes_of_their_own_need_section_rotation(file):
    with pytest.raises(RobotFileError, match=r"section_rotation.*the tip of link 'boom' has axes of its own"):
        load(robot_file(file.parent, 'body = { sid = "body.SID_FEM" }', "section_rotation = false\n"))


# -------- faults in the file: (what is replaced, by what, message); a line is counted from 1

TEXT_FAULTS = {
    "no part": ("part\n", "piece\n", r"line \d+: there is no 'part'"),
    "cut off": (r"end modal\nend part\n", "", r"line \d+: the file ends within 'new modal' of line 3; add 'end modal'"),
    "unknown object": ("end frame\n", "end frame\n extra\n", r"line \d+: 'extra' is unknown here; known are refmod"),
    "no number": (r"mass = \S+", "mass = heavy", "line 5: 'heavy' is no number"),
    "infinite": (r"mass = \S+", "mass = inf", "line 5: 'inf' is no number; state a finite one"),
    "index": (r"m0\( 3, 1\)", "m0( 4, 1)", r"line \d+: 'm0\( 4, 1\)' must have the indices \(1 to 3, 1 to 1\)"),
    "order": (r"order = 1\n  nrow = 3\n  ncol = 1", "order = 2\n  nrow = 3\n  ncol = 1", "has order 2; orders 0 and 1"),
    "no nrow": (r"  nrow = 3\n  ncol = 1", "  ncol = 1", "does not state nrow"),
    "count": ("nelastq = 2", "nelastq = two", "nelastq must be a whole number"),
    "shape": (r" Me\n  order = 0\n  nrow = 2", " Me\n  order = 0\n  nrow = 3", "Me is 3 x 2; it must be 2 x 2"),
    "missing": (r" Ke\n.* end Ke\n", "", "there is no 'Ke'"),
    "twice": (r"( Ke\n.* end Ke\n)", r"\1\1", "'Ke' occurs twice"),
    "mass": (r"mass = \S+", "mass = -1.0", "the mass of the body is -1 kg; it must be > 0"),
    "soft": (r"( Ke\n.*?m0\( 1, 1\) = )\S+", r"\g<1>0.0", "the stiffness Ke of the modes is not positive definite"),
    "contradiction": (r"( Me\n.*?m0\( 1, 1\) = )\S+", r"\g<1>0.001", "Me|kinetic energy of the body is not positive"),
    "asymmetric": (r"( Ke\n.*?m0\( 1, 2\) = )\S+", r"\g<1>9e9", r"line \d+: Ke is not symmetric in its modes"),
    "axes": (r"(AP\n.*?m0\( 1, 1\) = )\S+", r"\g<1>2.0", r"line \d+: AP is no rotation"),
}


@pytest.mark.parametrize(("old", "new", "message"), TEXT_FAULTS.values(), ids=TEXT_FAULTS)
def test_a_fault_in_the_file_has_one_line_with_its_place(old, new, message, tmp_path):
    text = fr.sid_text(fr.random_cloud(np.random.default_rng(14), 2))
    faulty = re.sub(old, new, text, count=1, flags=re.DOTALL)
    assert faulty != text
    path = tmp_path / "faulty.SID_FEM"
    path.write_text(faulty, encoding="ascii")
    with pytest.raises(RobotFileError, match=message) as caught:
        body_of(path)
    assert "\n" not in str(caught.value)


def test_a_robot_made_in_python_takes_a_body(file):
    robot = Robot(name="arm", gravity=(0, 0, 0), links=[Link(name="a", joint={"axes": ["y"]}, body={"sid": str(file)})])
    assert robot.links[0].body.data == robot.model_copy().links[0].body.data
