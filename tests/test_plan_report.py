"""The report of a plan: its numbers are those of `play`, its sentences those of its numbers."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from helpers import example
from test_planning import LAW, one_mode

import screwgen
from screwgen import UsageError
from screwgen.cli.main import main
from screwgen.simulation.robustness import payload, stiffness

MASS, LIGHT = "rod.bodies[0].mass", {"*.mass": 0.8}


@pytest.fixture(scope="module")
def planned():
    model = one_mode()
    return model, screwgen.plan(model, [0.0], [1.0], 0.9, gains=LAW, models=[LIGHT], limits={"efforts": [40.0]})


def rows(page: str) -> dict[str, list[str]]:
    """The tables of a page: cells by the first one of their row."""
    found = [re.findall(r"<td[^>]*>([^<]*)</td>", row) for row in re.findall(r"<tr>(.*?)</tr>", page, re.DOTALL)]
    return {cells[0]: cells[1:] for cells in found if cells}


def test_the_numbers_of_the_page_are_those_of_play(planned):
    model, plan = planned
    report = screwgen.plan_report(model, plan, models=[LIGHT], factors=(0.7, 1.0, 1.3), limits={"rates": [9.0]})
    table = rows(report.html())
    whole = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    millimetres = lambda p: f"{1e3 * screwgen.play(model, plan, parameters=p).residual:.3g}"  # noqa: E731
    own = screwgen.play(model, plan)
    assert table["as planned"][0] == millimetres({}) and table["as planned"][3] == str(own.saturated)
    assert table["*.mass × 0.8"][0] == millimetres({MASS: 0.8 * whole[MASS]})
    assert table["payload"] == [millimetres({MASS: x * whole[MASS]}) for x in (0.7, 1.0, 1.3)]
    stiff = ("rod.EIy", "rod.EIz")
    assert table["stiffness"] == [millimetres({name: x * whole[name] for name in stiff}) for x in (0.7, 1.0, 1.3)]
    rate, share = np.abs(own.run.v[:, 0]).max(), own.effort[0] / 40.0
    expected = ["0", "1", rate, 9.0, plan.effort[0], own.effort[0], 40.0]
    assert table["rod.joint[0]"] == [
        "rad, N·m",
        *(x if isinstance(x, str) else f"{x:.4g}" for x in expected),
        f"{100 * share:.0f} %",
    ]
    strain = max(abs(model.numpy().strain(q)[0]) for q in own.run.q)
    assert float(table[model.strain_names[0]][0]) == pytest.approx(strain, rel=1e-3)


def test_the_page_says_what_is_passed_and_what_does_not_arrive(planned):
    """A drive with less than the plan takes, a limit below what is reached, a rotor too light for the clock."""
    model, plan = planned
    weak = replace(plan, tau_max=0.8 * plan.effort)
    light = {"rotor": ["rod.joint.armature[0]"]}
    report = screwgen.plan_report(model, weak, limits={"rates": [0.5], "upper": [0.9]}, vary=light, factors=(1e-5, 1.0))
    page = report.html()
    assert report.first.saturated and np.isnan(report.robustness["rotor"].residuals).tolist() == [True, False]
    assert rows(page)["rotor"][0] == "–"
    assert re.search(r'class="open">The arm does not arrive with its rotor multiplied by 1e-05: ', page)
    assert re.search(rf'class="open">as planned: {report.first.saturated} samples are saturated', page)
    assert re.search(r'class="open">The rate of rod\.joint\[0\] reaches [\d.]+; its limit is 0\.5', page)
    assert re.search(r'class="open">rod\.joint\[0\] goes to 1[.\d]*; its limit is 0\.9', page)
    assert "100 % of its limit" in page and any(x.startswith("rotor: ") for x in report.notes)


def test_what_counts_as_payload_and_as_stiffness():
    assert payload(example("gantry"))[0] == "swivel.bodies[0].mass"
    arm = example("elastic_joint")
    assert payload(arm) == ["hand.bodies[1].mass", *(f"hand.bodies[1].inertia[{k}]" for k in range(6))]
    assert {"upper_arm.EIy", "forearm.GJ", "hand.joint.drives[0].stiffness"} <= set(stiffness(arm))


ROBOT = """
name = "boom"
gravity = [0.0, 0.0, 0.0]
[[links]]
name = "boom"
length = 1.0
section = { rhoA = 0.6, EIy = 60.0, EIz = 60.0 }
modes = { bending_y = 1 }
joint = { axes = ["z"], armature = [0.3] }
"""
TASK = "start = [0.0]\ngoal = [1.0]\ntime = 1.0\nintervals = 8\n"


def test_the_command_writes_a_page_that_needs_nothing_else(tmp_path, monkeypatch, capsys):
    """An arm without a payload has no such curve; a bad name is refused before the search, and nothing is written."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "boom.toml").write_text(ROBOT)
    (tmp_path / "plan.toml").write_text(TASK)
    assert main(["plan", "boom.toml", "plan.toml", "-o", "plan.npz", "--report", "page.txt"]) == 2
    assert "page.txt" in (said := capsys.readouterr().err) and ".html" in said and said.count("\n") == 1
    assert not (tmp_path / "plan.npz").exists()
    assert main(["plan", "boom.toml", "plan.toml", "-o", "plan.npz", "--report", "page.html"]) == 0
    assert "page.html\n" in capsys.readouterr().out
    page = (tmp_path / "page.html").read_text()
    assert page.count("<section>") == 6 and page.count("data:image/png") == 3 and "://" not in page
    table = rows(page)
    assert len(table["stiffness"]) == 7 and "payload" not in table and table["models"] == ["1"]
    assert "Without gains nothing corrects" in page


def test_the_plan_is_kept_where_its_report_fails(tmp_path, monkeypatch, capsys):
    def fails(*args, **more):
        raise UsageError("its runs diverge")

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("screwgen.plotting.plan_report.plan_report", fails)
    Path("boom.toml").write_text(ROBOT)
    Path("plan.toml").write_text(TASK)
    assert main(["plan", "boom.toml", "plan.toml", "-o", "plan.npz", "--report", "page.html", "--fast", "-q"])
    assert "its runs diverge" in capsys.readouterr().err
    assert Path("plan.npz").is_file() and not Path("page.html").exists()
