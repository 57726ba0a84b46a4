"""Bad command lines, state files and gains: one line on stderr, exit status 2, nothing written."""

import os
import shutil
from pathlib import Path

import pytest

from screwgen.cli.main import main

EXAMPLE = Path(__file__).resolve().parents[1] / "examples" / "ella_paper.toml"
RUN = "simulate ella.toml --duration 0.01 --step 1e-3 -o run.npz"
GAINS = "kp = [1, 1, 1]\nkd = [1, 1, 1]\nq_des = [0, 0, 0]\n"
WAYS = "kp = [1, 1, 1]\nkd = [1, 1, 1]\n"

LINES = {
    "": "missing command",
    "simulat ella.toml": "no such command 'simulat'",
    "--quie": "no such option: --quie",
    "paper 4711": "the paper has no equation '4711'",
    # robots
    "modes": "missing argument 'ROBOT'",
    "modes none.toml": "none.toml: there is no such file",
    "modes folder": "folder: is a directory",
    "modes bad.toml": "bad.toml: line 1: is not valid TOML",
    "evaluate massless.toml": "links[0].section.rhoA",
    "simulate massless.toml --duration 1 --step 1 -o run.npz": "links[0].section.rhoA",
    "generate massless.toml -o out": "links[0].section.rhoA",
    "latex massless.toml -o x.tex": "links[0].section.rhoA",
    "modes ella.toml ella.toml": "unexpected extra argument",
    # simulate
    "simulate ella.toml --step 1e-3 -o run.npz": "missing option '--duration'",
    "simulate ella.toml --duration 1 -o run.npz": "missing option '--step'",
    "simulate ella.toml --duration 1 --step 1e-3": "missing option",
    "simulate ella.toml --duration 1 --step 1e-3 -o": "option '-o' requires an argument",
    "simulate ella.toml --duration one --step 1e-3 -o run.npz": "--duration",
    "simulate ella.toml --duration -1 --step 1e-3 -o run.npz": "the duration is -1 s",
    "simulate ella.toml --duration 0 --step 1e-3 -o run.npz": "the duration is 0 s",
    "simulate ella.toml --duration nan --step 1e-3 -o run.npz": "the duration is nan s",
    "simulate ella.toml --duration inf --step 1e-3 -o run.npz": "the duration is inf s",
    "simulate ella.toml --duration 1 --step 0 -o run.npz": "the step is 0 s",
    "simulate ella.toml --duration 1 --step -1e-3 -o run.npz": "the step is -0.001 s",
    "simulate ella.toml --duration 1 --step nan -o run.npz": "the step is nan s",
    "simulate ella.toml --duration 1e6 --step 1e-3 -o run.npz": "over 1e+08 steps",
    "simulate ella.toml --duration 1e300 --step 1e-300 -o run.npz": "over 1e+08 steps",
    "simulate rigid.toml --duration 1e5 --step 1e-3 -o run.npz": "GB",
    "simulate ella.toml --duration 1 --step 1e-3 -o run.txt": "run.txt: has an unknown suffix",
    "simulate ella.toml --duration 1 --step 1e-3 -o run": "it must end in .npz or .csv",
    "simulate ella.toml --duration 1 --step 1e-3 -o none/run.npz": "its folder does not exist",
    "simulate ella.toml --duration 1 --step 1e-3 -o ella.toml/run.npz": "its folder does not exist",
    "simulate ella.toml --duration 1 --step 1e-3 -o folder.npz": "is a directory",
    "simulate ella.toml --duration 1 --step 1e-3 -o pipe.csv": "is not a regular file",
    f"simulate ella.toml --duration 1 --step 1e-3 -o {'x' * 300}.npz": "File name too long",
    f"{RUN} --plot run.jpg": "run.jpg: has an unknown suffix",
    f"{RUN} --plot none/run.png": "its folder does not exist",
    f"{RUN} --integrator heun": "choose euler",
    f"{RUN} --form lagrange": "--form: there is no 'lagrange'",
    f"{RUN} --controller pid:gains.toml": "there is no controller 'pid'",
    f"{RUN} --controller pd": "names no file",
    f"{RUN} --controller pd:": "names no file",
    f"{RUN} --controller pd:none.toml": "none.toml: there is no such file",
    f"{RUN} --controller pd:folder": "folder: is a directory",
    f"{RUN} --controller pd:gains.toml --state torque.json": "torque.json: tau: is given beside --controller",
    f"{RUN} --state none.json": "none.json: there is no such file",
    f"{RUN} --verbose": "no such option: --verbose",
    # evaluate, modes, latex, generate
    "evaluate ella.toml --backend fortran": "--backend: there is no 'fortran'",
    "evaluate ella.toml --form lagrange": "--form: there is no 'lagrange'",
    "evaluate ella.toml --state none.json": "none.json: there is no such file",
    "evaluate ella.toml --state binary.json": "binary.json: line 1: is not UTF-8 text",
    "modes ella.toml --joints welded": "locked or free",
    "modes ella.toml --posture folder": "folder: is a directory",
    "modes ella.toml --plot m.jpg": "m.jpg: has an unknown suffix",
    "modes ella.toml --plot none/m.png": "its folder does not exist",
    "modes rigid.toml --plot m.png": "there are no modes to draw",
    # equilibrium
    "equilibrium": "missing argument 'ROBOT'",
    "equilibrium none.toml": "none.toml: there is no such file",
    "equilibrium massless.toml": "links[0].section.rhoA",
    "equilibrium ella.toml -o x.json": "no such option: -o",
    "equilibrium ella.toml --q 1,2": "--q: has 2 numbers; it must have 3 finite joint angles",
    "equilibrium ella.toml --q 1,2,nan": "--q: 1,2,nan is not finite; it must have 3 finite joint angles",
    "equilibrium ella.toml --q 1,2,up": "--q: '1,2,up' is no list of numbers",
    "equilibrium ella.toml --q": "option '--q' requires an argument",
    "equilibrium ella.toml --tau 1": "--tau: has 1 numbers; it must have 3 finite joint torques",
    "equilibrium ella.toml --tau 1e999,0,0": "it must have 3 finite joint torques",
    "equilibrium ella.toml --hold --tau 1,0,0": "tau: upper_arm.torque[0] is found, as its joint is held; leave it at",
    "equilibrium ella.toml --tensions 1": "--tensions: robot 'ella' has no tendons; leave it out",
    "equilibrium ella.toml --hold --hold-only forearm": "--hold-only and --hold both say which joints are held",
    "equilibrium ella.toml --state none.json": "none.json: there is no such file",
    "equilibrium ella.toml --tau -200,0,0": "upper_arm.joint[0]: no posture found balances its torque of -200 N·m",
    "latex ella.toml": "missing option",
    "latex ella.toml -o x.docx": "it must end in .tex or .pdf or .html",
    "latex ella.toml -o none/x.tex": "its folder does not exist",
    "latex ella.toml --scalar -o x.tex": "ella' in scalars are too large|robot 'ella' has no equations in scalars: ",
    "latex ella.toml --about 0,0,0 -o x.tex": "--about: only equations in scalars are linearised; give --scalar too",
    "latex ella.toml --scalar --about 0,0 -o x.tex": "equations in scalars|in scalars are too large",
    "analyse": "missing argument 'ROBOT'",
    "analyse ella.toml --fast": "no such option: --fast",
    "analyse massless.toml": "links[0].section.rhoA",
    "analyse ella.toml --state none.json": "none.json: there is no such file",
    "analyse ella.toml --state folder": "folder: is a directory",
    "analyse ella.toml --samples -1": "--samples",
    "analyse ella.toml --samples many": "--samples",
    "analyse ella.toml --seed -1": "--seed",
    "analyse ella.toml --step 0": "the step is 0 s",
    "analyse ella.toml --step nan": "the step is nan s",
    "analyse ella.toml --plot m.jpg": "m.jpg: has an unknown suffix",
    "analyse ella.toml --plot none/m.png": "its folder does not exist",
    "analyse ella.toml --controller pid:gains.toml": "there is no controller 'pid'",
    "analyse ella.toml --controller pd:none.toml": "none.toml: there is no such file",
    "analyse ella.toml --controller pd:gains.toml --state torque.json": "torque.json: tau: is given beside",
    "generate ella.toml": "missing option",
    "generate ella.toml -o ella.toml": "ella.toml",
    "generate ella.toml -o .": ".",
    "generate ella.toml -o out --target fortran": "--target: there is no 'fortran'",
    "generate ella.toml -o out --parameters cooked": "--parameters: there is no 'cooked'",
    "generate ella.toml -o out --layout loose": "--layout: there is no 'loose'",
}

STATES = {
    "": "line 1: is not valid JSON",
    "{": "is not valid JSON",
    "[1, 2": "is not valid JSON",
    "1.0": "is 1.0; it must be a table",
    '"q"': "it must be a table",
    "null": "it must be a table",
    "[1, 2]": "q: has length 2; it must have 9 numbers, or the 3",
    "[1, 2, NaN]": "NaN is not a number",
    "[1, 2, 1e999]": "q[2]: is inf; it must be a finite number",
    '[1, 2, "3"]': 'q[2]: is "3"; it must be a number',
    "[1, 2, true]": "q[2]: is true; it must be a number",
    '{"q": 1}': "q: is 1; it must be an array",
    '{"q": [[1, 2, 3]]}': "q: has length 1",
    '{"v": [1, 2, 3, 4]}': "v: has length 4; it must have 9 numbers",
    '{"tau": [1]}': "tau: has length 1; it must have 3 torques",
    '{"tau": [1, 2, null]}': "tau[2]: ",
    '{"w_ext": [1, 2]}': "w_ext[0]: is 1; it must be an array of 6",
    '{"w_ext": [[0, 0, 0, 0, 0, 0]]}': "w_ext: has length 1; it must have 2",
    '{"w_ext": [[0, 0, 0, 0, 0, 0], [0, 0]]}': "w_ext[1]: has length 2; it must have 6 numbers",
    '{"w_ext": [[0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, -Infinity]]}': "-Infinity is not a number",
    '{"torque": [1, 2, 3]}': "torque: is an unknown key; known here: q, v, tau, w_ext",
    '{"Q": [1, 2, 3]}': "did you mean q?",
    '{"q": [1, 2, 3], "q": [1, 2, 3]}': '"q" is given 2 times',
    "[" * 100_000: "nested too deeply",
    "[1, 2, " + "9" * 5000 + "]": "digits",
}

GAIN_FILES = {
    "kp = [1, 1, 1": "is not valid TOML",
    "kd = [1, 1, 1]\nq_des = [0, 0, 0]": "kp: is missing",
    "kp = [1, 1, 1]\nkd = [1, 1, 1]": "q_des: is missing",
    GAINS.replace("kp = [1, 1, 1]", "kp = [1, 1]"): "kp: has length 2; it must have 3 numbers, one per joint",
    GAINS.replace("kp = [1, 1, 1]", "kp = 1"): "kp: is 1; it must be an array of 3",
    GAINS.replace("kp = [1, 1, 1]", "kp = [1, 1, -1]"): "kp[2]: is -1; it must be >= 0",
    GAINS.replace("kd = [1, 1, 1]", "kd = [1, 1, nan]"): "kd[2]: is nan; it must be a finite number",
    GAINS.replace("q_des = [0, 0, 0]", 'q_des = [0, 0, "home"]'): 'q_des[2]: is "home"',
    GAINS + "duration = 0": "duration: is 0; it must be > 0",
    GAINS + 'duration = "1 s"': "duration: ",
    GAINS + "tau_max = [1, 1, 0]": "tau_max[2]: is 0; it must be > 0",
    GAINS + "gravity = 1": "gravity: is 1; it must be true or false",
    GAINS + "waypoints = []": "q_des: is given beside waypoints",
    GAINS.replace("q_des", "waypoints"): "waypoints[0]: is 0; it must be a table of t and q",
    WAYS + "waypoints = []": "waypoints: is empty",
    WAYS + "waypoints = [{ t = 1, q = [0, 0] }]": "waypoints[0].q: has length 2; it must have 3 numbers",
    WAYS + "waypoints = [{ t = 0, q = [0, 0, 0] }]": "waypoints[0].t: is 0; it must be > 0",
    WAYS
    + "waypoints = [{ t = 1, q = [0, 0, 0] }, { t = 1, q = [0, 0, 0] }]": "waypoints[1].t: is 1.0; it must be later",
    WAYS + "waypoints = [{ t = 1, q = [0, 0, 0], v = 1 }]": "waypoints[0]: is a table; it must be a table of t and q",
    GAINS + "kj = [1, 1, 1]": "kj: is an unknown key; known here: kp, kd",
    GAINS + "ki = [1, -1, 1]": "ki[1]: is -1; it must be >= 0",
    GAINS + "tau_limit = [1, 1, 1]": "tau_limit: is an unknown key",
    GAINS + "start = 2024-02-31": "is not valid TOML|cannot be read",
}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copy(EXAMPLE, "ella.toml")
    for name in ("folder", "folder.npz"):
        Path(name).mkdir()
    os.mkfifo("pipe.csv")
    Path("bad.toml").write_text("name = \n")
    Path("massless.toml").write_text(EXAMPLE.read_text().replace("rhoA = 1.6302", "rhoA = 0.0"))
    Path("gains.toml").write_text(GAINS)
    Path("rigid.toml").write_text("\n".join(x for x in EXAMPLE.read_text().splitlines() if not x.startswith("modes")))
    Path("torque.json").write_text('{"tau": [1, 0, 0]}')
    Path("binary.json").write_bytes(b"\xff\xfe\x00")
    return tmp_path


def snapshot(folder: Path) -> dict:
    return {path: path.read_bytes() if path.is_file() else None for path in sorted(folder.rglob("*"))}


def refused(capsys, folder: Path, arguments: list[str], message: str) -> None:
    """The arguments are refused in one line that holds the message (or one of several)."""
    before = snapshot(folder)
    status = main(arguments)
    out, err = capsys.readouterr()
    assert (status, out) == (2, ""), err
    assert err.startswith("screwgen: error: ") and err.endswith("\n") and err[:-1].isprintable()
    assert any(part in err for part in message.split("|")), err
    assert ";" in err, "an error says what is allowed"
    assert len(err) < 700 and "Traceback" not in err
    assert snapshot(folder) == before


@pytest.mark.parametrize("line", LINES)
def test_bad_command_line(capsys, folder, line):
    refused(capsys, folder, line.split(), LINES[line])


@pytest.mark.parametrize("text", STATES, ids=lambda text: text[:40])
@pytest.mark.parametrize(
    "command",
    [
        *(f"{name} ella.toml --state" for name in ("evaluate", "analyse", "equilibrium")),
        "modes ella.toml --posture",
        f"{RUN} --state",
    ],
)
def test_bad_state(capsys, folder, command, text):
    Path("state.json").write_text(text)
    refused(capsys, folder, [*command.split(), "state.json"], STATES[text])


@pytest.mark.parametrize("text", GAIN_FILES, ids=lambda text: text[-40:])
def test_bad_gains(capsys, folder, text):
    Path("gains.toml").write_text(text)
    refused(capsys, folder, [*RUN.split(), "--controller", "pd:gains.toml"], GAIN_FILES[text])


@pytest.mark.parametrize("name", ["", "nul\0.npz", "new\nline.jpg", "\x1b[31m.jpg", "\udcff.jpg"])
def test_strange_names_stay_on_one_line(capsys, folder, name):
    arguments = ["simulate", "ella.toml", "--duration", "0.01", "--step", "1e-3", "-o", name]
    refused(capsys, folder, arguments, "")
    assert "\x1b" not in capsys.readouterr().err


def test_output_below_a_file(capsys, folder):
    """A place where nobody may write, root included."""
    refused(capsys, folder, [*RUN.replace("run.npz", "ella.toml/run.npz").split()], "")
