"""The self-check of the generated C: what it must not pass, in which precision it says that it is of no use."""

import re
import subprocess
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from conftest import require_tool
from helpers import arm, example, link, model_of, quick, unfolded

from screwgen.backends.c.project import CProject
from screwgen.backends.numpy import reference
from screwgen.backends.numpy.reference import Rounding, assembly_error
from screwgen.backends.numpy.reference_sums import stiffer
from screwgen.cli.commands import run_generate
from screwgen.errors import PrecisionWarning, ScrewgenError, UsageError

SECTION = {"EIy": 40.0, "EIz": 60.0}
BENDS = arm(
    link("a", 0.5, "z", modes={"bending_y": 1}, section=SECTION, joint={"damping": [0.2]}),
    link("b", 0.4, "y", bodies=[{"at": "tip", "mass": 0.3}]),
)
LOST = r"\d+ %( or more)?"
SLENDER = {"EIy": 100.0, "EIz": 100.0, "rhoIp": 1e-4}


def overloaded(mass: float, rhoA: float) -> dict:
    """Two light flexible links of half a metre with a load at the tip."""
    flexible = {"rhoA": rhoA, "modes": {"bending_z": 2}, "section": SLENDER}
    load = [{"at": "tip", "mass": mass}]
    return arm(link("a", 0.5, "y", **flexible), link("b", 0.5, "y", bodies=load, **flexible))


@cache
def texts(layout: str) -> dict[str, str]:
    model = model_of(BENDS)
    return CProject(model.chain, model.version, "runtime", layout).files()


def compiled(folder: Path, *sources: str, real="double") -> None:
    define = ["-DARM_REAL_FLOAT"] if real == "float" else []
    subprocess.run([require_tool("gcc"), "-std=c99", *define, "-c", *sources], cwd=folder, check=True)


def outcome(folder: Path) -> tuple[int, str]:
    """Exit status and last line of the self-check of what is compiled in a folder."""
    objects = sorted(f.name for f in folder.glob("*.o"))
    subprocess.run([require_tool("gcc"), "-o", "check", *objects, "-lm"], cwd=folder, check=True)
    done = subprocess.run([folder / "check"], capture_output=True, text=True)
    return done.returncode, done.stdout


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """Folders with the objects of library and self-check, by layout and precision."""

    @cache
    def make(layout: str, real: str) -> Path:
        folder = tmp_path_factory.mktemp(f"{layout}-{real}")
        compiled(folder, "check.c", *unfolded(folder, texts(layout)), real=real)
        assert outcome(folder)[0] == 0, outcome(folder)
        return folder

    return make


def mutant(folder: Path, layout: str, real: str, file: str, old: str, new: str) -> tuple[int, str]:
    """The outcome with the last text in a file that matches a pattern replaced; the folder is then as it was."""
    found = list(re.finditer(old, texts(layout)[file]))
    assert found, f"{file} has no {old}"
    a, b = found[-1].span()
    text, right = texts(layout)[file], folder / f"{file[:-2]}.o"
    sound = right.read_bytes()
    try:
        (folder / file).write_text(text[:a] + found[-1].expand(new) + text[b:])
        compiled(folder, file, real=real)
        return outcome(folder)
    finally:
        right.write_bytes(sound)


WRONG = {
    "an acceleration of the other sign": ("arm_dynamics.c", r"(output->vdot\[\d\] = )(.*);", r"\1-(\2);"),
    "an acceleration off by 1e-8": (
        "arm_dynamics.c",
        r"(output->vdot\[\d\] = )(.*);",
        r"\1(\2) * ARM_REAL(1.00000001);",
    ),
    "no accelerations": ("arm_dynamics.c", r"(output->vdot\[\d\] = )(.*);", r"\1(\2) * 0;"),
    "a wrench of the other sign": ("arm_dynamics.c", r"(output->wrench\[0\]\[4\] = )(.*);", r"\1-(\2);"),
    "a constant off by 1e-8": ("arm_parameters.c", r"(M_eta\[0\] = )(.*);", r"\1(\2) * ARM_REAL(1.00000001);"),
    "a sine off by 1e-8": ("arm_real.c", r"y\.sine = s;", r"y.sine = s * ARM_REAL(1.00000001);"),
    "a matrix entry of the other sign": ("arm_links.c", r"(M\[place\[3\]\] = )(.*);", r"\1-(\2);"),
    "weights of Runge-Kutta": ("arm_step.c", "third = dt / 3, sixth = dt / 6;", "third = dt / 6, sixth = dt / 3;"),
    "reach of Runge-Kutta": ("arm_step.c", r"(advance\(state, )dt(, work->stage.v,)", r"\1half\2"),
    "weights of Runge-Kutta, DAE": ("arm_dae.c", "third = dt / 3, sixth = dt / 6;", "third = dt / 6, sixth = dt / 3;"),
    "half a way": ("arm_step.c", r"leap\(state, dt, half,", "leap(state, dt, 0,"),
    "half a way, DAE": ("arm_dae.c", r"leap\(state, dt, half, 0,", "leap(state, dt, dt, 0,"),
    "half a step in its middle evaluation": ("arm_step.c", r"leap\(state, half, half,", "leap(state, half, dt,"),
    "the same, DAE": ("arm_dae.c", r"leap\(state, half, half, half,", "leap(state, half, dt, half,"),
    "a step too long": ("arm_step.c", r"leap\(state, dt, dt,", "leap(state, 2 * dt, dt,"),
}


@pytest.mark.parametrize("what", WRONG)
def test_a_wrong_line_is_found(built, what):
    """One line of the library changed, in double."""
    status, said = mutant(built("fused", "double"), "fused", "double", *WRONG[what])
    assert status == 1 and "FAILED" in said


def test_a_wrong_line_is_found_in_float(built):
    for change in (r"\1-(\2);", r"\1(\2) * ARM_REAL(1.001);"):
        line = ("arm_dynamics.c", r"(output->vdot\[\d\] = )(.*);", change)
        assert mutant(built("fused", "float"), "fused", "float", *line)[0] == 1


def test_the_tolerances_are_the_usual_where_rounding_is_small():
    project = CProject(model_of(BENDS).chain, "")
    check, extents = project.check, [x for case in project._cases for x in case["extent"]]
    assert check.pop("extent") == repr(float(f"{max(extents):.6g}"))
    assert check == {"tolerance": {"single": "1e-04", "double": "1e-10"}, "inverse": {}, "lost": "", "assembly": ""}


# -------- where a precision is of no use


def test_float_that_does_not_fit_is_said(tmp_path, capsys):
    """Light links under a heavy load: one line when generating, in make check, and from a float self-check."""
    import random_robots as rr

    (tmp_path / "arm.toml").write_text(rr.to_toml(overloaded(100.0, 0.1)))
    out = tmp_path / "out"
    run_generate(str(tmp_path / "arm.toml"), str(out), ["c"], "runtime", "auto", True)
    said = capsys.readouterr().err.splitlines()
    assert len(said) == 1 and re.search(rf"warning: .*'arm': the C is of no use in float: .* {LOST}; comp", said[0])
    make = [require_tool("make"), "-s", "CFLAGS=-O0"]
    done = subprocess.run([*make, "check"], cwd=out / "c", capture_output=True, text=True)
    assert done.returncode == 0 and "all checks passed" in done.stdout and "not checked in float" in done.stdout
    subprocess.run([*make, "build/arm_check_float"], cwd=out / "c", check=True)
    done = subprocess.run([out / "c" / "build" / "arm_check_float"], capture_output=True, text=True)
    assert done.returncode == 1 and re.fullmatch(rf"arm: FAILED, float is of no use .* {LOST}\n", done.stdout)


def test_no_tolerance_is_loose():
    """However much rounding a precision loses, its self-check allows a hundredth at most."""
    with pytest.warns(PrecisionWarning, match="no use in float"):
        files = model_of(overloaded(100.0, 0.1)).c_files()
    allowed = re.search(r"TOLERANCE = .*\? ARM_REAL\((.*?)\) : ARM_REAL\((.*?)\);", files["check.c"].decode())
    assert float(allowed[1]) <= 1e-2 and float(allowed[2]) <= 1e-6


def test_an_arm_beyond_double_is_refused():
    """Loads of a million tonnes on links of half a gram: nothing is generated that is a per cent off."""
    with pytest.raises(UsageError, match=r"robot 'arm': rounding in double .* give light links .* more mass"):
        model_of(overloaded(1e9, 1e-3)).c_files()


def test_a_posture_that_rounding_makes_singular_has_no_error_but_infinity():
    project = CProject(model_of(overloaded(1e9, 1e-3)).chain, "")
    rounding = Rounding(project.chain)
    assert max(rounding.errors(case, 24)[0] for case in project._cases) > 1


# -------- the folder that make builds in


def test_make_leaves_a_folder_that_can_be_generated_again(tmp_path):
    model = model_of(BENDS)
    model.write(tmp_path / "out", ("c",))
    subprocess.run(["make", "-s", "CFLAGS=-O0", "all"], cwd=tmp_path / "out" / "c", check=True)
    assert (tmp_path / "out" / "c" / "build" / "libarm.a").is_file()
    model.write(tmp_path / "out", ("c",))
    assert not (tmp_path / "out" / "c" / "build").exists()
    (tmp_path / "out" / "c" / "build").mkdir()
    (tmp_path / "out" / "c" / "build" / "notes.txt").write_text("mine")
    with pytest.raises(UsageError, match=r"holds 'c/build/notes\.txt', which screwgen did not write"):
        model.write(tmp_path / "out", ("c",))


# -------- the states that it records

LINKAGE = {"ground": 1.0, "crank": 0.4, "coupler": 0.7, "rocker": 0.5, "angle": 1.4, "branch": "open"}
DRIVEN = {"drives": [{"transmission": {"four_bar": LINKAGE}}]}
ABROAD = {"parent": "world", "joint": {"mount": {"xyz": [0.7, 0.0, 0.0]}}}
QUADRANGLE = arm(link("crank", 0.3, "y", joint=DRIVEN), link("coupler", 0.8, "y"), link("rocker", 0.6, "y", **ABROAD))
QUADRANGLE["loops"] = [{"between": ["coupler.tip", "rocker.tip"], "joint": {"axes": ["x", "y", "z"]}}]
"""A mechanism of four bars, whose crank is driven by a linkage that reaches little of its turn."""
TWISTING = {"basis": "polynomial", "bending_y": 2, "bending_z": 1, "torsion": 1}
LIMP = {"EIy": 32.0, "EIz": 1500.0, "GJ": 12.0, "rhoIp": 1.5e-3}
SECOND_ORDER = arm(link("a", 1.1, "z", order=2, modes=TWISTING, section=LIMP, rhoA=2.2))
"""A link that what 20 N bend it would leave without a definite mass matrix in most states."""


@pytest.mark.parametrize("name", ["quadrangle", "second order", "parallelogram"])
def test_recorded_states_are_those_that_the_robot_can_be_in(name):
    """Loops are closed, linkages reach their links, the mass matrix is definite, and float can tell."""
    of = {"quadrangle": QUADRANGLE, "second order": SECOND_ORDER}
    model = model_of(of[name]) if name in of else example(name)
    project, numeric = CProject(model.chain, ""), model.numpy()
    assert len(project._cases) == 3
    for case in project._cases:
        q, (lower, upper) = np.array(case["q"]), model.chain.reach.T
        assert np.abs(numeric.gaps(q, None)[0]).max(initial=0.0) < 1e-5
        assert np.linalg.eigvalsh(numeric.mass_matrix(q))[0] > 0
        assert (lower < q[: model.n_joints]).all() and (q[: model.n_joints] < upper).all()
        assert np.isfinite([x for values in case.values() for x in values]).all()
        assert Rounding(model.chain).errors(case, 24)[0] < 1e-2
    assert project.check["lost"] == "" and project.check["inverse"] == {}


@pytest.mark.parametrize("robot", [QUADRANGLE, SECOND_ORDER], ids=["quadrangle", "second order"])
def test_it_passes_where_not_every_state_is_possible(tmp_path, robot):
    sources = ["check.c", *unfolded(tmp_path, CProject(model_of(robot).chain, "").files())]
    for real in ("double", "float"):
        compiled(tmp_path, *sources, real=real)
        assert outcome(tmp_path)[0] == 0, outcome(tmp_path)


def test_a_robot_without_a_possible_state_is_refused(monkeypatch):
    """A loop that no posture closes."""
    monkeypatch.setattr(reference, "TRIES", 2)
    apart = QUADRANGLE | {"links": [*QUADRANGLE["links"][:2], link("rocker", 0.1, "y", **ABROAD)]}
    apart["links"][2] = apart["links"][2] | {"joint": {"axes": ["y"], "mount": {"xyz": [9.0, 0.0, 0.0]}}}
    with pytest.raises(ScrewgenError, match="stays open by"):
        model_of(apart).c_files()


def test_near_gimbal_lock_float_may_miss_the_assembled_system():
    """A milliradian from it the rows of three axes depend on each other but for a thousandth."""
    chain = model_of(arm(link("a", 0.4, ["z", "y", "x"]), link("b", 0.3, "y"))).chain
    case = CProject(chain, "")._cases[1]
    near = case | {"q": [0.3, np.pi / 2 - 1e-3, 0.2, 0.5]}
    assert assembly_error(chain, [case]) < 1e-5 < assembly_error(chain, [near])


# -------- the search for rest


def moored(factor: float) -> dict:
    """BENDS with this multiple of its stiffness, and a line that bends it by half a metre, were it not so long."""
    section = {name: factor * stiffness for name, stiffness in SECTION.items()}
    boom = BENDS["links"][0] | {"modes": {"bending_y": 1, "bending_z": 1}}
    robot = arm(boom | {"section": boom["section"] | section}, BENDS["links"][1])
    line = {"line": {"stiffness": 2000.0, "rest": 0.2}}
    return robot | {"forces": [line | {"name": "mooring", "between": [{"world": [0.3, 2.0, -1.0]}, "a.tip"]}]}


def test_rest_is_sought_where_the_search_comes_near_it():
    """What lines do to modes of their own stiffness leads it astray, and every round multiplies the rounding of the
    last; its self-check would hold one precision's wanderings beside another's."""
    chain = model_of(moored(1.0)).chain
    project = CProject(chain, "")
    case, factor = project._cases[-1], stiffer(chain, project._cases[-1])
    assert f"stiff.K[k] *= {factor:.0f};" in project.files()["check.c"] and 10 < factor < 100
    q, w_ext = [*case["q"][: chain.eta_q], *[0.0] * chain.n_modes], np.reshape(case["w_ext"], (-1, 6))
    left = [np.abs(quick(model_of(moored(x))).gravity(q, w_ext)[0][chain.eta_v :]).max() for x in (1.0, factor)]
    assert left[1] < 1.0 and left[0] > 1e3
    assert "&stiff" not in texts("fused")["check.c"]
