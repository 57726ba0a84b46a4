"""Every command end to end: what it prints, what it writes, how it ends."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import require_tool
from helpers import ROOT, example_dict
from oracle import Oracle

from screwgen import __version__, derive, load
from screwgen.cli.commands import EVALUATIONS
from screwgen.cli.main import application, main
from screwgen.simulation.controllers import PD, Holding
from screwgen.simulation.simulate import FORMS, simulate
from screwgen.studies.assemble import assemble
from screwgen.studies.modes import natural_frequencies

ELLA = str(ROOT / "examples" / "ella_paper.toml")
STATE = {
    "q": [0.3, -0.4, 0.5, 1e-5, 0.01, -0.02, 2e-5, 0.01, 0.005],
    "v": [0.5, 0.2, -0.6, 0.0, 0.1, 0.2, 0.0, -0.1, 0.1],
    "tau": [1.0, -2.0, 3.0],
    "w_ext": [[0.1, 0.2, 0.3, 1.0, 2.0, 3.0], [-0.1, 0.0, 0.2, 0.0, 5.0, 0.0]],
}
GAINS = "kp = [40, 40, 20]\nkd = [8, 8, 3]\nq_des = [-0.4928, 0.6922, 0.4270]\nduration = 0.5\n"
ENVIRONMENT = os.environ | {"PYTHONPATH": str(ROOT)}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A working folder with a robot, a state and gains in it."""
    monkeypatch.chdir(tmp_path)
    shutil.copy(ELLA, "ella.toml")
    Path("state.json").write_text(json.dumps(STATE))
    Path("gains.toml").write_text(GAINS)
    return tmp_path


def run(capsys, *arguments: str) -> str:
    """The stdout of a command that succeeds and says on stderr no more than the model's limits, a lack of rotors, and
    that gravity is left out where joints are free."""
    status = main(arguments)
    out = capsys.readouterr()
    said = ("screwgen: warning: link '", "screwgen: note: ella.toml: upper_arm.joint[0], upper_arm.joint[1]: carry")
    said += ("screwgen: note: gravity is left out; with --loaded",) * ("free" in arguments)
    lines = [x for x in out.err.splitlines() if not x.startswith(said)]
    assert (status, lines) == (0, [])
    return out.out


def process(*arguments: str, **options) -> subprocess.Popen:
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True} | options
    return subprocess.Popen([sys.executable, "-m", "screwgen", *arguments], env=ENVIRONMENT, **pipes)


# -------- help

COMMANDS = ("generate", "simulate", "evaluate", "modes", "equilibrium", "analyse", "latex")


def test_help_lists_the_commands(capsys):
    text = run(capsys, "--help")
    assert all(name in text for name in (*COMMANDS, "paper", "Exit status"))
    assert "╭" not in text


def test_the_page_of_commands_has_them_all():
    page = (ROOT / "docs/commands.md").read_text()
    assert set(re.findall(r"^    screwgen (\w+)", page, re.M)) == set(application().commands)


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_has_help(capsys, command):
    text = run(capsys, command, "--help")
    assert text.startswith(f"Usage: screwgen {command}") and "ROBOT" in text and "Exit status" in text


def test_version(capsys):
    assert run(capsys, "--version") == f"screwgen {__version__}\n"


def test_module_runs_as_the_command_does():
    with process("--version") as p:
        out, err = p.communicate()
    assert (p.returncode, out, err) == (0, f"screwgen {__version__}\n", "")


# -------- evaluate


@pytest.mark.parametrize("cell", sorted(EVALUATIONS), ids="-".join)
def test_evaluate_agrees_with_the_oracle(capsys, folder, cell):
    backend, form = cell
    if backend == "c":
        require_tool("cc")
    options = ("--state", "state.json", "--backend", backend, "--form", form)
    found = json.loads(run(capsys, "evaluate", "ella.toml", *options))
    names = {"vdot", "links", "wrench", "tip_position", "tip_rotation", "kinetic", "potential", "power", "validity"}
    assert set(found) == names and found["links"] == ["upper_arm", "forearm"]
    oracle = Oracle(example_dict("ella"))
    assert max(oracle.errors(STATE, found["vdot"], found["wrench"]).values()) < oracle.tolerance(STATE["q"])
    R, position = oracle.tip_pose(STATE["q"])
    assert np.allclose(found["tip_rotation"], R, atol=1e-12)
    assert np.allclose(found["tip_position"], position, atol=1e-12)
    assert np.allclose([found["kinetic"], found["potential"]], oracle.energy(STATE["q"], STATE["v"]), rtol=1e-12)
    assert np.shape(found["wrench"]) == (2, 6)


@pytest.mark.parametrize("state", ["[0.3, -0.4, 0.5]", '{"q": [0.3, -0.4, 0.5]}', "[0.3, -0.4, 0.5, 0, 0, 0, 0, 0, 0]"])
def test_joint_coordinates_alone_leave_the_rest_at_zero(capsys, folder, state):
    Path("s.json").write_text(state)
    Path("full.json").write_text(json.dumps({"q": [0.3, -0.4, 0.5] + [0.0] * 6, "v": [0.0] * 9, "tau": [0, 0, 0]}))
    assert run(capsys, "evaluate", "ella.toml", "--state", "s.json") == run(
        capsys, "evaluate", "ella.toml", "--state", "full.json"
    )


def test_evaluate_names_the_rows_of_its_wrenches(capsys, folder):
    """Of a link with segments, and of a marker between base and tip, where the loop's wrenches balance."""
    section, modes = "section = { rhoA = 1.0, EIy = 500.0 }", "modes = { bending_z = 1 }"
    links = (
        'name = "crank"\nlength = 0.3\nsection = { rhoA = 2.0 }\njoint = { axes = ["y"] }',
        f'name = "rod"\nlength = 0.9\nsegments = 2\n{section}\n{modes}\njoint = {{ axes = ["y"] }}\n'
        'markers = [ { name = "lug", at = 0.9 } ]',
        'name = "rocker"\nparent = "world"\nlength = 0.6\nsection = { rhoA = 2.0 }\n'
        'joint = { axes = ["y"], mount = { xyz = [0.8, 0.0, 0.0] } }',
    )
    tables = "".join(f"[[links]]\n{link}\n" for link in links)
    loop = '[[loops]]\nbetween = ["rod.lug", "rocker.tip"]\njoint = { axes = ["y"] }\n'
    Path("linked.toml").write_text(f'name = "linked"\ngravity = [0.0, 0.0, -9.81]\n{tables}{loop}')
    q = assemble(derive(load("linked.toml")), [0.3, -0.4, -1.5])
    Path("closed.json").write_text(json.dumps({"q": q.tolist()}))
    found = json.loads(run(capsys, "evaluate", "linked.toml", "--state", "closed.json"))
    assert found["links"] == ["crank", "rod", "rocker"] and len(found["wrench"]) == 3
    assert [loop["between"] for loop in found["loops"]] == [["rod.lug", "rocker.tip"]]
    rows, wrenches = found["loops"][0]["rows"], np.array(found["loop_wrenches"])
    names = derive(load("linked.toml")).chain.names
    assert [names[k] for k in rows] == ["rod.lug", "rocker"]
    first, second = np.linalg.norm(wrenches[rows][:, 3:], axis=1)
    assert first == pytest.approx(second, rel=1e-9) and first > 1.0
    assert not np.delete(wrenches, rows, axis=0).any()


def test_evaluate_without_state_is_at_zero(capsys, folder):
    Path("zero.json").write_text("{}")
    assert run(capsys, "evaluate", "ella.toml") == run(capsys, "evaluate", "ella.toml", "--state", "zero.json")


# -------- modes


def test_modes_prints_hertz(capsys, folder):
    Path("posture.json").write_text("[-0.4928, 0.6922, 0.4270]")
    expected = natural_frequencies(derive(load("ella.toml")), [-0.4928, 0.6922, 0.4270] + [0.0] * 6)
    found = json.loads(run(capsys, "modes", "ella.toml", "--posture", "posture.json", "--json"))
    assert list(found) == ["frequencies_hz", "growth_per_s", "one_more_mode", "short_of", "validity"]
    assert np.allclose(found["frequencies_hz"], expected, rtol=1e-12)
    loaded = json.loads(run(capsys, "modes", "ella.toml", "--rates", "0,3,0", "--loaded", "--json"))["frequencies_hz"]
    assert np.allclose(loaded, natural_frequencies(derive(load("ella.toml")), rates=[0, 3, 0], loaded=True))
    lines = run(capsys, "modes", "ella.toml", "--posture", "posture.json").splitlines()
    assert [float(line.split()[0]) for line in lines[1:]] == pytest.approx(expected, rel=1e-5)


def test_modes_with_free_joints(capsys, folder):
    found = json.loads(run(capsys, "modes", "ella.toml", "--joints", "free", "--json"))["frequencies_hz"]
    assert found[:3] == [0.0, 0.0, 0.0] and len(found) == 9 and found == sorted(found)


# -------- simulate


SHORT = ("--duration", "0.02", "--step", "1e-3")


@pytest.mark.parametrize("form", sorted(FORMS))
def test_simulate_stores_the_run(capsys, folder, form):
    arguments = ("--state", "state.json", "--form", form, "--plot", "run.png")
    assert run(capsys, "simulate", "ella.toml", *SHORT, "-o", "run.npz", *arguments) == "run.npz\nrun.png\n"
    expected = simulate(
        derive(load("ella.toml")), 0.02, 1e-3, STATE["q"], STATE["v"], STATE["tau"], STATE["w_ext"], form=form
    )
    with np.load("run.npz") as stored:
        for name in ("t", "q", "v", "tau", "wrench", "tip_position", "energy"):
            assert np.array_equal(stored[name], getattr(expected, name))
    assert Path("run.png").read_bytes().startswith(b"\x89PNG")
    assert sorted(os.listdir()) == ["ella.toml", "gains.toml", "run.npz", "run.png", "state.json"]


def test_simulate_with_a_controller_and_a_method(capsys, folder):
    Path("start.json").write_text("[0.1, 0.2, 0.3]")
    options = ("--state", "start.json", "--controller", "pd:gains.toml", "--integrator", "modal_implicit")
    run(capsys, "simulate", "ella.toml", *SHORT, "-o", "run.csv", *options)
    names = Path("run.csv").read_text().split("\n", 1)[0].split(",")
    table = np.loadtxt("run.csv", delimiter=",", skiprows=1)
    assert len(table) == 21 and table[0, names.index("forearm.joint[0]")] == 0.3
    assert table[:, names.index("upper_arm.torque[0]")].any()


def test_simulate_with_gravity_compensation_along_way_points(capsys, folder):
    ways = "waypoints = [{ t = 0.01, q = [0.1, 0, 0] }, { t = 0.02, q = [0, 0, 0] }]\ngravity = true\n"
    Path("gains.toml").write_text("".join(GAINS.splitlines(True)[:2]) + ways)
    run(capsys, "simulate", "ella.toml", *SHORT, "-o", "run.npz", "--controller", "pd:gains.toml")
    model = derive(load("ella.toml"))
    points = ((0.01, (0.1, 0.0, 0.0)), (0.02, (0.0,) * 3))
    law = PD((40.0, 40.0, 20.0), (8.0, 8.0, 3.0), points[1][1], 0.02, waypoints=points, gravity=Holding(model))
    with np.load("run.npz") as stored:
        assert np.array_equal(stored["tau"], simulate(model, 0.02, 1e-3, controller=law).tau)
        assert np.allclose(stored["tau"][0], Holding(model)([0.0] * 3), rtol=1e-12)


def test_quiet_says_nothing(capsys, folder):
    assert run(capsys, "--quiet", "simulate", "ella.toml", *SHORT, "-o", "a.npz") == ""
    assert run(capsys, "simulate", "ella.toml", *SHORT, "-o", "b.npz", "--quiet") == ""
    assert Path("a.npz").read_bytes() == Path("b.npz").read_bytes()


def test_a_run_that_diverges_leaves_the_old_files(capsys, folder):
    Path("run.npz").write_text("old")
    longer = ("--duration", "1", "--step", "1e-3", "--integrator", "euler")
    status = main(["simulate", "ella.toml", *longer, "-o", "run.npz"])
    err = capsys.readouterr().err
    assert status == 1 and err.count("\n") == 1 and err.startswith("screwgen: error: t = 0.0")
    assert Path("run.npz").read_text() == "old" and "; run.failed.npz: the run until then" in err
    assert sorted(os.listdir()) == ["ella.toml", "gains.toml", "run.failed.npz", "run.npz", "state.json"]
    with np.load("run.failed.npz") as kept:
        assert 1 < len(kept["t"]) < 1000 and "diverged" in str(kept["ended"]) and np.isfinite(kept["q"]).all()


def test_singular_posture_names_the_link(capsys, folder):
    Path("ball.toml").write_text(
        'name = "ball"\ngravity = [0, 0, -9.81]\n[[links]]\nname = "wrist"\nlength = 0.5\n'
        'section = { rhoA = 1.0, rhoIp = 0.01 }\njoint = { axes = ["x", "z", "x"] }\n'
    )
    before = sorted(os.listdir())
    for arguments in (("evaluate", "ball.toml"), ("simulate", "ball.toml", *SHORT, "-o", "run.npz")):
        assert main(arguments) == 1
        out, err = capsys.readouterr()
        assert out == "" and err.startswith("screwgen: error: ") and "wrist" in err and err.count("\n") == 1
    assert sorted(os.listdir()) == before


@pytest.mark.parametrize(
    ("number", "status", "message"),
    [
        (signal.SIGINT, 130, "screwgen: error: interrupted; nothing was written\n"),
        (signal.SIGTERM, 143, ""),
        (signal.SIGHUP, 129, ""),
    ],
)
def test_interrupted_work_leaves_nothing(folder, number, status, message):
    with process(
        "simulate", "ella.toml", "--duration", "0.01", "--step", "1e-3", "-o", "short.npz"
    ) as p:  # the C is compiled
        assert p.wait() == 0
    before = sorted(os.listdir())
    with process("simulate", "ella.toml", "--duration", "2000", "--step", "1e-3", "-o", "run.npz") as p:
        for _ in range(200):
            if any(name.endswith(".part") for name in os.listdir()):
                break
            time.sleep(0.05)
        time.sleep(0.3)
        p.send_signal(number)
        out, err = p.communicate(timeout=20)
    assert (p.returncode, out, err) == (status, "", message)
    assert sorted(os.listdir()) == before


def test_full_disk_is_one_line(folder):
    with open("/dev/full", "w") as full, process("evaluate", "ella.toml", stdout=full) as p:
        err = p.communicate()[1]
    assert p.returncode == 1 and err.startswith("screwgen: error: ") and err.count("\n") == 1


def test_closed_pipe_is_no_traceback(folder):
    reader, writer = os.pipe()
    os.close(reader)
    with process("evaluate", "ella.toml", stdout=writer) as p:
        os.close(writer)
        err = p.communicate()[1]
    assert p.returncode == 1 and err == ""


# -------- generate, latex


def test_generate_writes_what_it_lists(capsys, folder):
    listed = run(capsys, "generate", "ella.toml", "-o", "out", "--target", "c").split()
    written = {str(path) for path in Path("out").rglob("*") if path.is_file()}
    assert listed and set(listed) <= written and any(name.endswith("/ella.h") for name in listed)
    run(capsys, "generate", "ella.toml", "-o", "out", "--target", "c", "--quiet")  # over its own files
    Path("out/mine.txt").write_text("precious")
    assert main(["generate", "ella.toml", "-o", "out"]) == 2
    assert capsys.readouterr().err.count("\n") == 1 and Path("out/mine.txt").read_text() == "precious"


@pytest.mark.parametrize("name", ["equations.tex", "equations.html"])
def test_latex_writes_the_document(capsys, folder, name):
    assert run(capsys, "latex", "ella.toml", "-o", name) == f"{name}\n"
    assert "forearm" in Path(name).read_text()


@pytest.mark.parametrize("name", ["equations.tex", "equations.html"])
def test_latex_writes_equations_in_scalars(capsys, folder, name):
    links = '[[links]]\nname = "rod"\nlength = 1.0\njoint = { axes = ["y"] }\nbodies = [{ at = "tip", mass = 1.0 }]\n'
    Path("swing.toml").write_text(f'name = "swing"\ngravity = [0.0, 0.0, -9.81]\n\n{links}')
    assert run(capsys, "latex", "swing.toml", "--scalar", "--about", "pi/2", "-o", name) == f"{name}\n"
    text = Path(name).read_text()
    assert "Small motions about rest" in text and "rod.bodies[0].mass" in text.replace(r"\cut{}", "")
