"""What is analysed, and what of it is shown: samples, report, picture, command."""

import json
from pathlib import Path

import numpy as np
import pytest
from conftest import swept
from helpers import equal_links, example, flat, model_of

import screwgen
from screwgen.cli.main import main
from screwgen.integrators import METHODS
from screwgen.plotting.structure import png
from screwgen.studies.analysis import sample_states
from screwgen.studies.analysis.regularity import structure

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"


def test_samples_are_reproducible_and_small():
    model = example("six_link")
    one, again, other = (sample_states(model, 3, seed) for seed in (4, 4, 5))
    for label, s in one.items():
        assert np.array_equal(s.q, again[label].q) and not np.array_equal(s.q, other[label].q)
        assert np.abs(s.q[:6]).max() <= np.pi and np.abs(s.q[6:]).max() <= 0.05 * 1.2
    s = one["sample 1"]
    straight = np.append(s.q[:6], np.zeros(9))
    rigid = flat(model.casadi()["bias"](straight, np.zeros(15), np.zeros((6, 6)), model.parameter_values))
    assert np.allclose(s.tau, rigid[:6], rtol=1e-10)


def test_the_command_prints_a_report_and_json(capsys, tmp_path):
    ella = str(EXAMPLES / "ella_paper.toml")
    picture = tmp_path / "m.png"
    assert main(["analyse", ella, "--samples", "2", "--plot", str(picture)]) == 0
    out = capsys.readouterr().out
    verdict = " ".join(out.partition("\n\n")[0].split())
    assert verdict.startswith("STABLE (torques held): at 'zero', no equilibrium, no motion grows; ")
    assert verdict.endswith("modal_midpoint bears 1 ms; 3 coordinates free")
    assert "\nWELL POSED" in out and "(E17)" in out and "(E19)" in out
    assert max(map(len, out.splitlines())) <= 100
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert main(["analyse", ella, "--samples", "2", "--json", "--step", "2e-4"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert [s["label"] for s in data["states"]] == ["zero", "sample 1", "sample 2"]
    assert data["well_posed"] and data["step"] == 2e-4 and data["structure"]["labels"][:2] == ["w_1", "V_1"]
    names = {"label", "well_posed", "singular", "system", "projectors", "blocks", "acceleration", "motions", "limits"}
    names |= {"turning", "measures", "loops", "left_out"}
    assert all(set(s) == names for s in data["states"])
    borne = {x["method"]: x["borne"] for x in data["states"][0]["limits"]}
    assert borne["rk4"] and not borne["euler"] and list(borne) == list(METHODS)


def test_the_report_opens_with_whether_it_is_stable(capsys, tmp_path):
    """A rod that stands on its joint falls; gains too high for the step are a matter of the step."""
    far = tmp_path / ("deep" * 30)  # names of files are not broken
    far.mkdir()
    robot, up, gains = tmp_path / "rod.toml", far / "up.json", tmp_path / "gains.toml"
    link = 'section = { rhoA = 0.5 }\nlength = 1.0\njoint = { axes = ["y"] }\nbodies = [ { at = "tip", mass = 0.2 } ]'
    robot.write_text(f'name = "rod"\ngravity = [0.0, 0.0, -9.81]\n[[links]]\nname = "pole"\n{link}\n')
    up.write_text("[-1.5707963267948966]")
    asked = ["analyse", str(robot), "--state", str(up)]
    assert main(asked) == 0
    falls = " ".join(capsys.readouterr().out.partition("\n\n")[0].split())
    assert falls.startswith(f"UNSTABLE (torques held): at '{up}' pole.joint[0] falls away, +")
    for kd, opening in ((2.0, "STABLE (controller's loop closed): "), (2e4, "UNSTABLE in steps of 1 ms (controller's")):
        gains.write_text(f"kp = [100]\nkd = [{kd}]\nq_des = [-1.5707963267948966]\n")
        assert main([*asked, "--controller", f"pd:{gains}"]) == 0
        assert capsys.readouterr().out.startswith(opening)


def test_the_command_takes_states_and_a_controller(capsys, tmp_path):
    ella, state, gains = str(EXAMPLES / "ella_paper.toml"), tmp_path / "s.json", tmp_path / "gains.toml"
    state.write_text("[0.1, 0.2, 0.3]")
    gains.write_text("kp = [900, 900, 300]\nkd = [60, 60, 20]\nq_des = [0.1, 0.2, 0.3]\n")
    assert main(["analyse", ella, "--state", str(state), "--controller", f"pd:{gains}", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert [s["label"] for s in data["states"]] == [str(state)] and data["closed_loop"]
    assert max(m["eigenvalue"][0] for m in data["states"][0]["motions"]) < 1


@pytest.mark.parametrize("count", swept([2, 32], 2))
def test_the_picture_is_the_same_twice(count):
    model = model_of(equal_links(count, 3))
    s = structure(model)
    assert png(s, "arm") == png(s, "arm")


@pytest.mark.parametrize("bad", [[], [[1.0, 2.0]], [{"Q": [1.0]}], [{"q": [float("nan")] * 9}]])
def test_bad_states_are_refused(bad):
    with pytest.raises(screwgen.UsageError):
        screwgen.analyse(example("ella"), bad)
