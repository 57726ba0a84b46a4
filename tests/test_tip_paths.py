"""Files of tip paths and the command that follows them: shapes by closed forms, tables by what they sample."""

import numpy as np
import pytest
from helpers import arm, example, link, model_of
from test_plan_report import rows
from test_tracking import LENGTH, TIME, eased, rod, sweep

import screwgen
from screwgen import ScrewgenError
from screwgen.cli.main import main

ROWS = 121
LAW = "kp = [100.0]\nkd = [30.0]\nq_des = [0.0]\n"


def table(rows=ROWS, path=sweep, digits=12, head="t,x,y,z", begin=0.0):
    """The text of a table of a path."""
    t = np.linspace(0.0, TIME, rows)
    text = "\n".join(",".join(f"{x:.{digits}f}" for x in row) for row in np.column_stack([begin + t, path(t)]))
    return f"{head}\n{text}\n"


@pytest.fixture
def folder(tmp_path):
    """Files of a robot, a law and paths."""
    (tmp_path / "rod.toml").write_text(screwgen.dump(rod().robot))
    (tmp_path / "law.toml").write_text(LAW)
    (tmp_path / "path.csv").write_text(table())
    circle = f"start = [{LENGTH}, 0, 0], centre = [0, 0, 0], angle = 1.0"
    (tmp_path / "path.toml").write_text(f"time = {TIME}\ncircle = {{ {circle} }}\n")
    return tmp_path


def test_shapes_are_their_closed_forms(folder):
    t = np.linspace(-0.1, TIME + 0.1, 50)
    assert np.abs(screwgen.read_path(folder / "path.toml")(t) - sweep(np.clip(t, 0.0, TIME))).max() < 1e-15
    (folder / "line.toml").write_text("time = 2.0\nline = { start = [1, 2, 3], goal = [2, 2, 1] }\n")
    line = screwgen.read_path(folder / "line.toml")
    assert line.time == 2.0 and np.allclose(line(t), [1, 2, 3] + eased(np.clip(t, 0, 2) / 2)[:, None] * [1, 0, -2])
    tilted = "start = [1.0, 0.0, 0.5], centre = [0.0, 0.0, 0.5], axis = [0.0, 3.0, 3.0]"
    (folder / "tilted.toml").write_text(f"time = 1.0\ncircle = {{ {tilted} }}\n")
    ring = screwgen.read_path(folder / "tilted.toml")(np.linspace(0, 1, 30))
    assert np.allclose(np.linalg.norm(ring - [0, 0, 0.5], axis=1), 1.0) and np.allclose(ring[0], ring[-1])
    assert np.allclose(ring @ [0, 1, 1], 0.5) and ring[4, 1] > 0 > ring[4, 2] - 0.5


@pytest.mark.parametrize("rows", [31, 121])
def test_a_table_is_what_it_samples(folder, rows):
    """Between its rows, whose clock may begin anywhere; the spline of order 7 is near to what is smooth."""
    (folder / "path.csv").write_text(table(rows, begin=5.0))
    found, t = screwgen.read_path(folder / "path.csv"), np.linspace(0.0, TIME, 1001)
    assert found.time == pytest.approx(TIME) and np.abs(found(t) - sweep(t)).max() < (1e-5 if rows < 40 else 1e-7)


def test_the_report_measures_the_run_against_the_path(folder, capsys, monkeypatch):
    """As planned the tip of the run is off as the test measures it; a stiffness that is off takes it farther off."""
    monkeypatch.chdir(folder)
    asked = ["track", "rod.toml", "path.toml", "--gains", "law.toml", "-o", "plan.npz"]
    assert main([*asked, "--report", "page.txt"]) == 2 and not (folder / "plan.npz").exists()
    capsys.readouterr()
    assert main([*asked, "--report", "page.html"]) == 0
    assert "plan.npz\npage.html\n" in capsys.readouterr().out
    page = (folder / "page.html").read_text()
    run, table = screwgen.play(rod(), screwgen.read_plan("plan.npz")).run, rows(page)
    off = np.linalg.norm(run.tip_position - screwgen.read_path("path.toml")(run.t - 0.1), axis=1)
    followed = page.partition("off its path</h2>")[2].partition("</section>")[0]
    largest, mean, at = map(float, rows(followed)["as planned"])
    assert largest == pytest.approx(1e3 * off.max(), rel=0.01) and at == pytest.approx(run.t[off.argmax()], abs=1e-3)
    assert mean == pytest.approx(1e3 * np.sqrt(np.mean(off**2)), rel=0.01)
    softer, *_, nominal, _, _, _ = map(float, table["stiffness"])
    assert nominal == pytest.approx(largest, rel=0.01) and softer > 10 * nominal


def test_the_command_writes_a_plan_whose_tip_is_on_the_path(folder, capsys, monkeypatch):
    monkeypatch.chdir(folder)
    asked = ["track", "rod.toml", "path.csv", "--gains", "law.toml"]
    assert main([*asked, "-o", "plan.npz"]) == 0
    said = capsys.readouterr().out.splitlines()
    plan = screwgen.read_plan("plan.npz")
    assert said[0] == "plan.npz" and said[1].startswith("1.4 s, 0.1 s of it before the tip moves and as much after")
    assert said[2].startswith("tip off its path by 0.000") and "without gains" not in said[1]
    name, *sizes, limit = said[-1].split()
    reached = plan.q.min(), plan.q.max(), np.abs(plan.v).max(), plan.effort[0]
    assert name == plan.joints[0] and limit == "none" and np.allclose([float(x) for x in sizes], reached, rtol=1e-3)
    run = screwgen.play(rod(), plan).run
    goal = sweep(np.clip(run.t - 0.1, 0.0, TIME))
    ahead = np.stack([-goal[:, 1], goal[:, 0], 0 * goal[:, 0]], axis=1) / LENGTH
    assert np.abs(((run.tip_position - goal) * ahead).sum(axis=1)).max() < 2e-5
    simulate = [
        "simulate",
        "rod.toml",
        "--controller",
        "plan:plan.npz",
        "--duration",
        "0.1",
        "--step",
        "1e-3",
        "--quiet",
    ]
    assert main([*simulate, "-o", "run.npz"]) == 0
    assert main(["track", "rod.toml", "path.toml", "-o", "plan.csv", "--step", "0.01", "--quiet"]) == 0
    head, *rows = (folder / "plan.csv").read_text().splitlines()
    assert head == "t,rod.joint[0],rod.joint[0].rate,rod.joint[0].torque" and len(rows) == 141
    assert main([*asked, "-o", "c", "--target", "c", "--spacing", "1e-2", "--quiet"]) == 0
    assert sorted(x.name for x in (folder / "c").iterdir()) == ["MANIFEST.sha256", "arm_plan.c", "arm_plan.h"]


def jumping(t):
    return np.where(t[:, None] > 0.5, sweep(t + 0.1), sweep(t))


FAULTS = {
    "is out of reach": (table(path=lambda t: 1.1 * sweep(t)), []),
    "column 'w' is an unknown key": (table(head="t,x,y,w"), []),
    "has no column 'z'": ("t,x,y\n0,1,2\n1,1,2\n", []),
    "z is 'nan'; it must be a finite number": (table().replace("0.000000000000\n", "nan\n", 1), []),
    "has 5 rows; a path needs 8 or more": (table(5), []),
    "is sampled too coarsely": (table(11), []),
    "goes by 0.02 s after 0.38 s": ("".join(x for k, x in enumerate(table().splitlines(True)) if k != 40), []),
    "it must be later than in the row before": (table() + "0.1,1,1,1\n", []),
    "jumps, or its rate does, at 0.5": (table(path=jumping), []),
    "begin and end at rest": (table(path=lambda t: sweep(TIME / 2 + t / 2)), []),
    "with all their digits": (table(1201, digits=4), []),
    "stays at one place": (table(path=lambda t: sweep(0 * t)), []),
    "--near: has 2 numbers": (table(), ["--near", "0,0"]),
    "preview: 0.02 s leaves out": (table(), ["--preview", "0.02"]),
    "the step is -1": (table(), ["--spacing=-1"]),
    "whose limit is 3; take more time": (table(), ["--gains", "weak.toml"]),
}


@pytest.mark.parametrize("said", FAULTS)
def test_what_no_tip_can_follow_is_one_line_and_no_file(folder, capsys, monkeypatch, said):
    monkeypatch.chdir(folder)
    text, more = FAULTS[said]
    (folder / "bad.csv").write_text(text)
    (folder / "weak.toml").write_text(LAW + "tau_max = [3.0]\n")
    assert main(["track", "rod.toml", "bad.csv", "-o", "plan.npz", *more]) == 2
    error = capsys.readouterr().err
    assert said in error and error.count("\n") == 1 and not (folder / "plan.npz").exists()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("time = 1.0", "circle, line: state one of them"),
        ("time = 0.0\nline = { start = [0, 0, 0], goal = [1, 0, 0] }", "time: is 0.0; it must be > 0"),
        ("time = 1.0\nline = { start = [0, 0, 0], goal = [0, 0, 0] }", "line: goal is the start"),
        ("time = 1.0\nline = { start = [0, 0], goal = [0, 0, 0] }", "line.start: has length 2"),
        ("time = 1.0\ncircle = { start = [1, 0, 0], centre = [1, 0, 0] }", "circle: start is the centre"),
        ("time = 1.0\ncircle = { start = [1, 0, 1], centre = [0, 0, 0] }", "start is 1 m along the axis"),
        ("time = 1.0\ncircle = { start = [1, 0, 0], centre = [0, 0, 0], axis = [0, 0, 0] }", "circle.axis: is zero"),
        ("time = 1.0\ncircle = { start = [1, 0, 0], center = [0, 0, 0] }", "did you mean centre?"),
    ],
)
def test_shapes_that_are_none_are_one_line(tmp_path, text, said):
    (tmp_path / "path.toml").write_text(text)
    with pytest.raises(ScrewgenError) as caught:
        screwgen.read_path(tmp_path / "path.toml")
    assert said in str(caught.value) and "\n" not in str(caught.value)


def chain(count, order=2):
    """Links that turn about z, of 0.5 m each."""
    section, own = {"rhoA": 0.6, "EIy": 90.0, "EIz": 90.0}, {"length": 0.5, "axes": "z", "joint": {"armature": [0.2]}}
    rows = [link(f"l{k}", section=section, modes={"bending_y": 1}, **own) for k in range(count)]
    return model_of(arm(*rows, order=order, gravity=[0.0, 0.0, 0.0]))


@pytest.mark.parametrize("count", [3, 4])
def test_an_arm_with_more_joints_than_it_needs_goes_the_least_way(count):
    """No joints of the same tip, bent or not, go less at first: the way is square to what leaves the tip."""
    model, begin = chain(count), np.array([-0.4, 0.9, 0.5, 0.3])[:count]
    place = model.numpy().tip_pose(np.append(begin, np.zeros(count)))[1]
    path = lambda t: place + 0.1 * np.stack([-eased(t), eased(t), 0 * t], axis=-1)  # noqa: E731
    law = screwgen.PD((100.0,) * count, (30.0,) * count, (0.0,) * count)
    plan = screwgen.track(model, path, 1.0, near=begin, gains=law, step=2e-3, preview=0.2)
    run = screwgen.play(model, plan).run
    assert np.linalg.norm(run.tip_position - path(np.clip(run.t - 0.2, 0.0, 1.0)), axis=1).max() < 5e-5
    tip = lambda q: model.numpy().tip_pose(np.append(q, np.zeros(count)))[1][:2]  # noqa: E731
    J = np.array([(tip(begin + e) - tip(begin - e)) / 2e-5 for e in 1e-5 * np.eye(count)]).T
    way = plan.q[-1] - plan.q[0]
    moved = way - np.linalg.pinv(J) @ (J @ way)
    assert np.linalg.norm(moved) < 0.1 * np.linalg.norm(way)


def test_the_posture_of_the_start_is_sought_within_limits():
    """Zero is a singular posture of two links in a row."""
    section, own = {"rhoA": 0.6, "EIy": 90.0, "EIz": 90.0}, {"length": 0.5, "axes": "z"}
    for low, high, sign in ((-2.5, -0.1, -1), (0.1, 2.5, 1)):
        joints = (
            {"armature": [0.2], "limits": [{"lower": -3.0, "upper": 3.0}]},
            {
                "armature": [0.2],
                "limits": [{"lower": low, "upper": high}],
            },
        )
        rows = [link(f"l{k}", section=section, modes={"bending_y": 1}, joint=x, **own) for k, x in enumerate(joints)]
        model = model_of(arm(*rows, order=2, gravity=[0.0, 0.0, 0.0]))
        path = lambda t: np.stack([0.7 - 0.05 * eased(t), 0.1 + 0 * t, 0 * t], axis=-1)  # noqa: E731
        plan = screwgen.track(model, path, 1.0, step=5e-3, preview=0.2)
        assert (np.sign(plan.q[:, 1]) == sign).all()


def test_modes_without_damping_leave_vibrations_that_matter_to_nobody():
    """The search for the motion ends where they alone are left over; the tip is on its path to micrometres."""
    design = example("converged")

    def drawn(t):
        angle = 2 * np.pi * eased(t / 3.0)
        return np.stack([0.9 + 0.1 * np.cos(angle), 0 * angle, 0.3 + 0.1 * np.sin(angle)], axis=-1)

    plan = screwgen.track(design, drawn, 3.0, near=[0.0, 0.5, -1.0], step=6e-3)
    assert plan.said["iterations"] < 8 and plan.said["off"] < 1e-6
