"""The paper's Section 7 run again: the short form, its tables against known numbers, its parts alone."""

import json
import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from conftest import require_tool
from helpers import ROOT

SCRIPT = ROOT / "examples" / "ella_paper.py"
sys.path.insert(0, str(ROOT / "examples"))

from ella import arm, document, frequencies, growth, motions, numbers  # noqa: E402

from screwgen import natural_frequencies  # noqa: E402
from screwgen.simulation.motion import displacements, tip_deformation, tip_position  # noqa: E402

pytestmark = pytest.mark.examples

PAPER = "03_joint_angles 04_coordinates 06_twists 07_end_point 08_deformation 08_spectrum 09_field_link1"
PAPER += " 10_field_link2 11_modal 12_torques 13_base_wrench 14_joint_wrench"
FIGURES = [f"fig{name}.png" for name in PAPER.split()]


@cache
def ella() -> arm.Arm:
    return arm.load()


def short_run(folder: Path, seed: str) -> str:
    """What the short form says that writes to a folder, with an order of hashing."""
    require_tool("cc")
    command = [sys.executable, str(SCRIPT), "--quick", "-o", str(folder)]
    done = subprocess.run(command, env=os.environ | {"PYTHONHASHSEED": seed}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def written(tmp_path_factory) -> tuple[Path, str]:
    """The folder of a short run, and what it said."""
    folder = tmp_path_factory.mktemp("paper") / "out"
    return folder, short_run(folder, "0")


@pytest.fixture(scope="module")
def results(written) -> dict:
    return json.loads((written[0] / "results.json").read_text())


# ------------------------------------------------------------------------------ what is written


def test_every_figure_is_written(written):
    expected = {*FIGURES, "divergence.png", "report.md", "report.html", "results.json", "run.csv", "MANIFEST.sha256"}
    found = {f.name: f.read_bytes() for f in written[0].iterdir()}
    assert set(found) == expected
    assert all(found[name].startswith(b"\x89PNG") and len(found[name]) > 5000 for name in FIGURES)


@pytest.mark.long
def test_two_runs_write_the_same_bytes(written, tmp_path):
    short_run(tmp_path / "out", "1")
    first, second = ({f.name: f.read_bytes() for f in folder.iterdir()} for folder in (written[0], tmp_path / "out"))
    assert first == second


def test_the_report_shows_every_figure_and_no_place_or_empty_number(written):
    page, text = ((written[0] / f"report.{kind}").read_text() for kind in ("html", "md"))
    for name in (*FIGURES, "divergence.png"):
        assert f'src="{name}"' in page and f"({name})" in text
    assert str(ROOT) not in page and "nan" not in text.lower().split() and "inf" not in text.lower().split()
    assert "nothing here is compared with a measurement" in text


def test_the_summary_leads_to_the_report(written):
    assert "predicted" in written[1] and "report.html" in written[1]


def test_a_folder_with_other_files_is_refused(tmp_path):
    (tmp_path / "mine.txt").write_text("keep")
    done = subprocess.run([sys.executable, str(SCRIPT), "-o", str(tmp_path)], capture_output=True, text=True)
    assert done.returncode == 2 and "mine.txt" in done.stderr
    assert [f.name for f in tmp_path.iterdir()] == ["mine.txt"]


# ------------------------------------------------------------------------------ growth


def test_predicted_growth_is_observed_in_every_row(results):
    for row in results["growth"]:
        assert np.isclose(row["observed"], row["predicted"], rtol=1e-3 if row["joints"] != "PD, the task" else 1e-2)
        if row["by_size"] is not None:
            assert np.isclose(row["by_size"], row["predicted"], rtol=0.02)
    assert sum(row["by_size"] is not None for row in results["growth"]) >= 4


def test_forward_euler_grows_and_the_others_do_not(results):
    rows = {(row["name"], row["joints"]): row["observed"] for row in results["growth"]}
    assert rows["forward Euler, 1 ms", "PD"] > 1000
    assert rows["forward Euler, 0.1 ms", "PD"] > 1000
    assert rows["forward Euler, 1 ms, no axial modes", "PD"] > 10
    assert rows["forward Euler, 0.1 ms, no axial modes", "PD"] < 0
    others = [x for (name, joints), x in rows.items() if not name.startswith("forward") and joints == "PD"]
    assert len(others) == 5 and max(others) <= 0


def test_growth_of_the_locked_arm_is_eulers_on_its_highest_frequency(results):
    """ln √(1 + (ωh)²) / h of the undamped arm, whose frequencies gravity hardly moves."""
    row = next(row for row in results["growth"] if row["joints"] == "locked")
    q = np.append(arm.SET_POINTS, np.zeros(4))
    omega = 2 * np.pi * natural_frequencies(ella().bending, q)[-1]
    assert np.isclose(row["observed"], np.log1p((omega * 1e-3) ** 2) / 2e-3, rtol=5e-3)


def test_the_task_is_lost_by_forward_euler_alone(results):
    rows = {row["name"]: row for row in results["comparisons"]}
    assert {name for name, row in rows.items() if not row["complete"]} == {
        "forward Euler, 1 ms",
        "forward Euler, 1 ms, no axial modes",
    }
    assert rows["forward Euler, 1 ms"]["end"] < 0.02
    assert max(row["deviation"] for row in rows.values() if row["complete"]) < 0.01
    assert rows["modal midpoint, 1 ms"]["deviation"] < 1e-3


def test_step_limits_agree_with_the_spectrum_of_the_modes(results):
    limits = {method: (kept, dropped) for method, kept, dropped in results["limits"]}
    highest = 2 * np.pi * natural_frequencies(ella().axial, np.append(arm.SET_POINTS, np.zeros(6)))[-1]
    assert np.isclose(limits["semi_implicit"][0], 2 / highest, rtol=2e-2)
    assert np.isclose(limits["rk4"][0], 2 * np.sqrt(2) / highest, rtol=2e-2)
    assert limits["euler"][0] < 1e-6 and limits["euler"][1] < 1e-3
    assert min(limits["modal_midpoint"]) > 1e-3


# ------------------------------------------------------------------------------ frequencies


def test_frequencies_are_the_known_ones(results):
    rows = {row["name"]: row["frequencies"] for row in results["frequencies"]}
    known = {"derived, with section rotation": (2.8807, 3.6956), "derived, without section rotation": (4.7341, 6.2905)}
    for name, expected in known.items():
        assert np.allclose(rows[name][-1][:2], expected, rtol=2e-4)
    dropped = rows["wrench columns of the modal rows dropped"][0]
    assert np.allclose(dropped, [22.4, 23.3, 29.4, 30.7], atol=0.05)


def test_dropped_columns_leave_bare_clamped_beams():
    """lambda_1² / (2π l²) √(EI / ρA) of each link and plane."""
    x = 1.8751040687119611
    links = [(link.length, EI, link.section.rhoA) for link in ella().robot.links for EI in section_stiffness(link)]
    bare = sorted(x**2 / (2 * np.pi * l**2) * np.sqrt(EI / rhoA) for l, EI, rhoA in links)
    assert np.allclose(frequencies.dropped(ella().robot, "clamped_free", 1), bare, rtol=1e-8)


def section_stiffness(link):
    return link.section.EIy, link.section.EIz


def test_the_assembled_system_with_its_columns_kept_is_the_arm():
    """Welding, and moving the bodies across the joints, change nothing."""
    found = frequencies.assembled(frequencies.welded_chain(ella().robot, "clamped_free", 1), drop=False)
    expected = natural_frequencies(ella().axial, np.append(arm.SET_POINTS, np.zeros(6)))
    assert np.allclose(found, expected, rtol=1e-7)


def test_stiffer_joints_lead_to_locked_ones(results):
    loops = results["loops"]
    chosen = [row["frequencies"][0] for row in loops if row["name"].startswith("PD") and "q = 0" not in row["name"]]
    assert chosen == sorted(chosen) and chosen[-1] < loops[-1]["frequencies"][0]


# ------------------------------------------------------------------------------ the start, the numbers, the page


@pytest.mark.parametrize("axial", [False, True])
def test_the_start_has_the_papers_tip_displacement(axial):
    model = ella().axial
    q = arm.start(model, axial)
    expected = np.array(arm.TIP_DISPLACEMENT) * [axial, 1, 1]
    assert np.allclose(displacements(model, q[None], 1, [1.0])[0, 0], expected, atol=1e-15)
    assert np.allclose(tip_deformation(model, q[None])[0], expected, atol=1e-15)
    assert not displacements(model, q[None], 0, [0.5, 1.0]).any()


def test_numbers_by_hand():
    n = numbers.compute(ella())
    EA, l = ella().robot.links[1].section.EA, 0.93
    assert np.isclose(n.axial_energy, EA * (np.pi / 4) ** 2 * 0.02**2 / l) and 1e4 < n.axial_energy < 1.3e4
    assert np.isclose(n.axial_force, EA * np.pi / 2 * 0.02 / l) and np.isclose(n.uniform_force, EA * 0.02 / l)
    assert np.isclose(n.ratio_roots, 6.26689, atol=1e-5) and np.isclose(n.ratio_model, n.ratio_roots, rtol=1e-9)
    assert np.isclose(n.bound, 10.37e-3, atol=5e-6) and np.isclose(n.axial_bound, 0.228e-3, atol=5e-7)


def test_the_welded_arm_is_the_arm_in_its_posture():
    tip = tip_position(ella().locked, np.zeros((1, 4)))
    assert np.allclose(tip, tip_position(ella().bending, np.append(arm.SET_POINTS, np.zeros(4))[None]), atol=1e-14)


def test_the_arm_rests_where_growth_is_measured():
    law = ella().law(moving=False)
    q = growth.equilibrium(ella().bending, law)
    tau = law(0.0, q, np.zeros(7))
    vdot, _ = ella().bending.numpy().forward_dynamics(q, np.zeros(7), tau, np.zeros((2, 6)))
    assert np.abs(vdot).max() < 1e-8


def test_the_held_map_is_the_power_of_one_step_where_no_torque_acts():
    """With kp = kd = 0 holding the torque over substeps makes no difference."""
    law = ella().law(moving=False)
    still = type(law)((0.0,) * 3, (0.0,) * 3, law.q_des)
    q = np.append(arm.SET_POINTS, np.zeros(4))
    one, five = (motions.Way("", "bending", "rk4", 1e-3, k) for k in (1, 5))
    S, T = (growth.sampled_map(ella().bending, way, still, q) for way in (one, five))
    assert np.allclose(T, np.linalg.matrix_power(S, 5), rtol=1e-10, atol=1e-10 * np.abs(T).max())


def test_a_page_escapes_and_aligns():
    page = document.Document("a < b")
    page.text("**bold** and `x < y`")
    page.text("**not `a*b`.** *PD, as designed*: 2 * 3 * 4")
    page.table(("name", "value"), [("first", "1.5 mm"), ("second", "–")])
    assert "<b>bold</b> and <code>x &lt; y</code>" in page.html() and "<title>a &lt; b</title>" in page.html()
    assert "<b>not <code>a*b</code>.</b> <i>PD, as designed</i>: 2 * 3 * 4" in page.html()
    assert "| --- | ---: |" in page.markdown() and "<td class=n>1.5 mm" in page.html()
