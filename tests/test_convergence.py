"""What one more mode per direction changes, and the note on a single polynomial."""

import json

import numpy as np
import pytest
from helpers import arm, drawn, example, link, model_of
from random_robots import to_toml

from screwgen import derive, natural_frequencies
from screwgen.backends.numpy.closing import closed
from screwgen.cli.main import main
from screwgen.spec.advice import advice
from screwgen.studies.convergence import convergence, enriched
from screwgen.studies.modes import mode_shapes

SECTION = {"EIy": 60.0, "EIz": 90.0, "GJ": 40.0, "rhoIp": 1e-3}
TIP = [{"at": "tip", "mass": 0.5, "com": [0.02, 0.01, 0.03], "inertia": [2e-3, 3e-3, 3e-3, 0.0, 0.0, 0.0]}]


def two(**modes) -> dict:
    given = {"modes": modes, "section": SECTION, "bodies": TIP}
    return arm(link("upper", 0.8, "z", **given), link("fore", 0.8, "y", **given))


def elastic(model, joints) -> np.ndarray:
    return natural_frequencies(model, None, joints)[model.n_joints if joints == "free" else 0 :]


@pytest.mark.parametrize("basis", ["polynomial", "clamped_free"])
@pytest.mark.parametrize("joints", ["locked", "free"])
def test_changes_are_those_of_the_models_with_more_modes(basis, joints):
    """Each against a model of its own, derived with the counts in the file."""
    counts = {"bending_y": 1, "bending_z": 2, "torsion": 1}
    model = model_of(two(basis=basis, **counts))
    found, now = convergence(model, None, joints), elastic(model, joints)
    more = derive(enriched(model.robot))
    assert more.robot.links[0].modes.counts == (1, 2, 3, 2)  # axial: no mode, but EA is stated
    assert found.total == pytest.approx(elastic(more, joints)[: len(now)] / now - 1, abs=1e-9)
    for direction in ("bending_y", "bending_z", "torsion"):
        alone = elastic(model_of(two(basis=basis, **counts | {direction: counts[direction] + 1})), joints)
        assert found.alone[direction] == pytest.approx(alone[: len(now)] / now - 1, abs=1e-9)
        assert (found.alone[direction] <= 1e-9).all() and (found.total <= found.alone[direction] + 1e-9).all()
    assert found.short(0) == min(found.alone, key=lambda d: found.alone[d][0])


@pytest.mark.parametrize("seed", [3, 4])
def test_a_deflected_posture_of_a_random_arm_is_the_same_in_more_modes(seed):
    case = drawn(seed, 2, rigid=0.0)
    q = case.state["q"]
    found, now = convergence(case.model, q), natural_frequencies(case.model, q)
    assert len(found.total) == len(now) and (found.total < 1e-9).all()


def test_what_cannot_have_more_modes_stays():
    measured = arm(link(modes={"bending_y": 1, "frequencies": {"bending_y": [3.0]}}, section={"EIz": None, "EA": None}))
    measured["links"][0]["section"] = {"rhoA": 1.0}
    found = convergence(model_of(measured))
    assert found.alone == {} and found.total == pytest.approx([0.0], abs=1e-12) and found.short(0) is None
    rigid = convergence(model_of(arm(link())))
    assert not rigid.total.size and not rigid.alone


MARKED = {"markers": [{"name": "pin", "at": 0.5}], "joint": {"mount": {"xyz": [0.7, 0.0, 0.0]}}, "parent": "world"}
BENDING = {"modes": {"bending_z": 1}, "section": SECTION}


def test_links_that_a_loop_joins_at_a_marker():
    """A marker has no modes of its own."""
    robot = arm(link("crank", 0.3, "y"), link("coupler", 0.8, "y", **BENDING), link("rocker", 0.6, **BENDING, **MARKED))
    robot["links"][2]["joint"]["axes"] = ["y"]
    ball = {"between": ["coupler.tip", "rocker.pin"], "joint": {"axes": ["x", "y", "z"]}}
    model = model_of(robot | {"loops": [ball]})
    q = closed(model.numpy(), [0.9, -0.5, 0.4, 0.0, 0.0])
    found, now = convergence(model, q, "free"), mode_shapes(model, q, "free").frequencies
    assert len(found.total) == len(now) > 0 and (found.total <= found.alone["bending_z"] + 1e-9).all()


def test_a_stop_that_is_pressed_is_a_spring():
    stop = {"limits": [{"lower": -0.2, "upper": 0.2, "stiffness": 300.0}]}
    model = model_of(arm(link("a", 0.8, "y", **BENDING, joint=stop)))
    q = np.array([0.3, 0.0])
    found, now = convergence(model, q, "free"), natural_frequencies(model, q, "free")
    more = derive(enriched(model.robot))
    at = np.append(q[0], np.zeros(more.nq - 1))
    assert found.total == pytest.approx(natural_frequencies(more, at, "free")[: len(now)] / now - 1, abs=1e-9)


def test_frequencies_are_printed_where_one_more_mode_has_no_answer(capsys, tmp_path):
    """A link of order 2 that is bent so far that with more modes its mass matrix is not definite."""
    limp = {"EIy": 32.0, "EIz": 1500.0, "GJ": 12.0, "rhoIp": 1.5e-3}
    tip = [{"at": "tip", "mass": 0.5, "com": [0.0, 0.05, 0.03]}]
    modes = {"basis": "polynomial", "bending_y": 1, "torsion": 1}
    robot = arm(link("a", 1.0, "z", order=2, modes=modes, section=limp, rhoA=2.2, bodies=tip))
    (tmp_path / "arm.toml").write_text(to_toml(robot))
    (tmp_path / "bent.json").write_text("[0.3, 0.1, 0.1]")
    line = ["modes", str(tmp_path / "arm.toml"), "--joints", "free", "--posture", str(tmp_path / "bent.json")]
    expected = natural_frequencies(model_of(robot), [0.3, 0.1, 0.1], "free")
    assert main([*line, "--json"]) == 0
    said, noted = capsys.readouterr()
    record = json.loads(said)
    assert record["frequencies_hz"] == pytest.approx(expected)
    assert record["one_more_mode"] is record["short_of"] is None
    assert "one more mode would move them is not known" in noted and "a link of order 2 bends so far" in noted
    assert main(line) == 0
    lines = capsys.readouterr().out.splitlines()[1:]
    assert [x.split()[-1] for x in lines if not x.startswith("0 ")] == ["?", "?"]


def test_converged_ella_and_the_papers():
    found = convergence(example("converged"), [-0.4928, 0.6922, 0.4270])
    assert (found.total[:7] > -3e-3).all() and found.short(0) is None
    papers = convergence(example("ella"), [-0.4928, 0.6922, 0.4270])
    assert papers.total[0] < -0.03 and papers.short(0) == "bending_z"


def test_modes_shows_it(capsys, tmp_path):
    file = tmp_path / "arm.toml"
    file.write_text(
        'name = "arm"\ngravity = [0, 0, -9.81]\n[[links]]\nname = "rod"\nlength = 1.0\njoint = { axes = ["y"] }\n'
        "section = { rhoA = 0.5, EIy = 20.0, rhoIp = 1e-4 }\nmodes = { bending_z = 1 }\n"
    )
    assert main(["modes", str(file)]) == 0
    said = capsys.readouterr()
    line = said.out.splitlines()[1]
    hertz, change, direction = line.split()[0], " ".join(line.split()[2:4]), line.split()[4]
    assert (float(hertz), change, direction) == (pytest.approx(4.5016, rel=1e-4), "−21 %", "bending_z")
    assert "arm.toml: rod.modes.bending_z: is 1, and a single polynomial" in said.err and said.err.count("\n") == 1
    assert main(["modes", str(file), "--joints", "free", "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["frequencies_hz"][0] == record["one_more_mode"][0] == 0.0
    assert record["short_of"] == [None, "bending_z"]
    assert main(["evaluate", str(file)]) == 0 and "note" in capsys.readouterr().err
    assert main(["--quiet", "generate", str(file), "-o", str(tmp_path / "out"), "--target", "c"]) == 0
    assert capsys.readouterr().err == ""


def test_two_polynomials_or_other_shapes_are_not_noted():
    said = lambda **modes: advice(model_of(two(**modes)).robot)  # noqa: E731
    assert said(bending_y=2, torsion=1) == said(basis="clamped_free", bending_y=1) == said(axial=1) == []
    assert len(said(bending_y=1, bending_z=1)) == 1
