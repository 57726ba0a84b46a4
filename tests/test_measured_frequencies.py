"""Measured frequencies in place of stiffness: against stiffness, the oracle, and the frequencies themselves.

`K_kk = M_kk (2π f_k)²`, the paper's wavenumber identification mode by mode.
"""

from __future__ import annotations

import copy
import re
import subprocess
import tomllib

import numpy as np
import oracle as judge
import pytest
import random_robots as rr
from conftest import require_tool
from helpers import ROOT, arm, casadi_forward, disagreement, example, example_dict, link, model_of, quick, relative
from oracle import DIRECTIONS, Oracle

from screwgen import Robot, ScrewgenError, derive, dump, load, natural_frequencies
from screwgen.chain.chain import Chain
from screwgen.emit import latex
from screwgen.spec import Link, equivalent_stiffness, parameters

BARE = {"rhoA": 1.2, "rhoIp": 3e-3}
FOUND = {"axial": [900.0, 2500.0], "bending_y": [20.0, 131.0, 340.0], "bending_z": [27.0], "torsion": [310.0]}


def counted(frequencies: dict, **more) -> dict:
    """A `modes` table whose stiffness is all measured."""
    return {d: len(f) for d, f in frequencies.items()} | {"frequencies": frequencies, **more}


def rod(frequencies=FOUND, **more) -> dict:
    """A robot of one clamped link without bodies and without any stiffness in its section."""
    table = {"name": "rod", "length": 0.8, "section": BARE, "modes": counted(frequencies), "joint": {"axes": []}}
    return arm(table | more)


def two_links() -> dict:
    """The first link measured in every direction, the second in one; bodies, damping, skew axes."""
    first = {
        "name": "first", "length": 0.7, "section": BARE, "frame_at": 0.1, "damping": {"ratio": 0.02},
        "modes": counted({"axial": [60.0], "bending_y": [3.0, 22.0], "bending_z": [4.0], "torsion": [9.0, 31.0]}),
        "joint": {"axes": ["y", [0.1, 0.3, 1.0]]},
        "bodies": [{"at": "tip", "mass": 1.3, "com": [0.02, 0.0, -0.03], "inertia": [0.01, 0.02, 0.02, 0, 0, 0]}],
    }  # fmt: skip
    second = {
        "name": "second", "length": 0.5, "section": {"rhoA": 0.8, "EIy": 7.0, "rhoIp": 2e-3},
        "modes": {"bending_y": 2, "bending_z": 2, "frequencies": {"bending_y": [5.0, 40.0]}},
        "damping": {"ratio": 0.1}, "joint": {"axes": ["z"]}, "bodies": [{"at": "tip", "mass": 0.4}],
    }  # fmt: skip
    return arm(first, second)


# -------- a file with frequencies and the file with the stiffness that they amount to


def clamped(table: dict) -> dict:
    """The natural frequencies (Hz) of a link's directions, by the oracle's quadrature of its own shapes."""
    line, modes = judge.line_properties(table["section"]), table.get("modes", {})
    out = {}
    for d in DIRECTIONS:
        if modes.get(d, 0):
            shapes = judge.shapes_of(d, "clamped_free", modes[d], 160)
            inertia = line["rhoIp" if d == "torsion" else "rhoA"]
            power = 4 if d.startswith("bending") else 2
            squares = line[judge.STIFFNESS_OF[d]] / inertia * np.diag(shapes.stiffness) / table["length"] ** power
            out[d] = [float(f) for f in np.sqrt(squares) / (2 * np.pi)]
    return out


def by_frequencies(robot: dict, directions=DIRECTIONS) -> dict:
    """The same robot, its stiffness in these directions stated by frequencies."""
    robot = copy.deepcopy(robot)
    for table in robot["links"]:
        found = {d: f for d, f in clamped(table).items() if d in directions}
        line = judge.line_properties(table["section"])
        dropped = {judge.STIFFNESS_OF[d] for d in found}
        table["section"] = {name: x for name, x in line.items() if x and name not in dropped}
        if found:
            table["modes"]["frequencies"] = found
    return robot


@pytest.mark.parametrize("directions", [DIRECTIONS, ("bending_y",), ("axial", "torsion")])
@pytest.mark.parametrize("seed", range(4))
def test_frequencies_that_follow_from_the_stiffness_give_the_same_dynamics(seed, directions):
    robot, state, oracle = rr.draw_regular(
        np.random.default_rng(seed), 2, limit=1e6, basis="clamped_free", rigid=0.0, torsion=1.0
    )
    given = [np.array(state[name]) for name in ("q", "v", "tau", "w_ext")]
    stiff, measured = model_of(robot), model_of(by_frequencies(robot, directions))
    expected = stiff.numpy().forward_dynamics(*given)
    tolerance = oracle.tolerance(state["q"])
    assert disagreement(oracle, expected, measured.numpy().forward_dynamics(*given)) < tolerance
    assert disagreement(oracle, expected, measured.numpy().dae_forward_dynamics(*given)) < tolerance
    assert disagreement(oracle, expected, casadi_forward(measured, *given)) < tolerance
    assert disagreement(oracle, expected, quick(measured).forward_dynamics(*given)) < tolerance
    for stiff_link, measured_link in zip(stiff.numpy().constants, measured.numpy().constants, strict=True):
        assert np.allclose(stiff_link["K"], measured_link["K"], rtol=1e-13, atol=0)
        assert np.allclose(stiff_link["D"], measured_link["D"], rtol=1e-13, atol=0)
    energies = [m.numpy().energy(*given[:2]) for m in (stiff, measured)]
    assert np.allclose(*energies, rtol=1e-12)


# -------- frequencies of no uniform beam, against the oracle


def replace_stiffness(oracle: Oracle, robot: dict) -> Oracle:
    """The oracle with the stiffness and damping of measured modes put in, from the robot's dict alone."""
    for table, part in zip(robot["links"], oracle.modal_slices, strict=True):
        k, ratio = part.start, table.get("damping", {}).get("ratio", 0.0)
        for d in DIRECTIONS:
            inertia = table["section"].get("rhoIp" if d == "torsion" else "rhoA", 0.0) * table["length"]
            for f in table.get("modes", {}).get("frequencies", {}).get(d, [None] * table.get("modes", {}).get(d, 0)):
                if f is not None:
                    oracle.K[k, k] = inertia * (2 * np.pi * f) ** 2
                    oracle.damping[k] = 2 * ratio * inertia * 2 * np.pi * f
                k += 1
        assert k == part.stop
    return oracle


def perturbed(robot: dict, rng) -> dict:
    """Its frequencies, each off by up to a third, still ascending: no uniform beam has them."""
    robot = by_frequencies(robot)
    for table in robot["links"]:
        for values in table.get("modes", {}).get("frequencies", {}).values():
            values[:] = sorted(f * float(rng.uniform(0.67, 1.33)) for f in values)
    return robot


def random_case(seed: int) -> tuple[dict, dict]:
    rng = np.random.default_rng(seed)
    robot, state, _ = rr.draw_regular(rng, 2, limit=1e6, basis="clamped_free", rigid=0.0, torsion=1.0)
    return perturbed(robot, rng), state


def own_case(seed: int) -> tuple[dict, dict]:
    return two_links(), rr.random_state(np.random.default_rng(seed), two_links())


@pytest.mark.parametrize(("case", "seed"), [*((random_case, 20 + s) for s in range(6)), (own_case, 0), (own_case, 1)])
def test_forward_dynamics_equal_the_oracle_with_its_stiffness_replaced(case, seed):
    robot, state = case(seed)
    oracle = replace_stiffness(Oracle(robot), robot)
    given = [np.array(state[name]) for name in ("q", "v", "tau", "w_ext")]
    errors = oracle.errors(state, *model_of(robot).numpy().forward_dynamics(*given))
    assert max(errors.values()) < oracle.tolerance(state["q"]), errors


def test_back_ends_agree_with_baked_parameters_and_in_both_layouts():
    robot = two_links()
    model, oracle = model_of(robot), replace_stiffness(Oracle(robot), robot)
    state = rr.random_state(np.random.default_rng(3), robot)
    given = [np.array(state[name]) for name in ("q", "v", "tau", "w_ext")]
    expected = model.numpy().forward_dynamics(*given)
    for options in ({"layout": "fused"}, {"layout": "modular"}, {"parameters": "baked"}):
        found = quick(model, **options).forward_dynamics(*given)
        assert disagreement(oracle, expected, found) < oracle.tolerance(state["q"]), options


# -------- the clamped bare link has the frequencies that the file states


def flat(frequencies: dict) -> np.ndarray:
    return np.sort([f for values in frequencies.values() for f in values])


def bare_frequencies(frequencies: dict) -> np.ndarray:
    return natural_frequencies(model_of(rod(frequencies)))


def test_the_clamped_bare_link_has_the_stated_frequencies():
    assert np.allclose(bare_frequencies(FOUND), flat(FOUND), rtol=1e-12, atol=0)


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_32_modes_in_a_direction(direction):
    ratio = np.random.default_rng(1).uniform(1.05, 1.4, 32)
    frequencies = {direction: [float(f) for f in np.cumprod(ratio)]}
    assert np.allclose(bare_frequencies(frequencies), flat(frequencies), rtol=1e-12, atol=0)


def test_32_modes_in_all_back_ends():
    """Parameters beyond the ninth find their places."""
    frequencies = {"bending_y": [float(f) for f in 20 * np.cumprod(np.random.default_rng(2).uniform(1.05, 1.3, 32))]}
    model, rng = model_of(rod(frequencies)), np.random.default_rng(3)
    q, v = (size * rng.normal(size=32) / np.arange(1, 33) ** 2 for size in (1e-4, 1e-3))
    expected = 1.2 * 0.8 * (2 * np.pi * np.array(frequencies["bending_y"])) ** 2
    assert np.allclose(model.numpy().constants[0]["K"], expected, rtol=1e-14, atol=0)
    state = (q, v, [], np.zeros((1, 6)))
    vdot, wrench = model.numpy().forward_dynamics(*state)
    for found in (casadi_forward(model, *state), quick(model).forward_dynamics(*state)):
        assert relative(found[0], vdot) < 1e-12 and relative(found[1], wrench) < 1e-12


@pytest.mark.parametrize("basis", ["clamped_free", "polynomial"])
def test_axial_and_torsion_may_be_measured_with_either_basis(basis):
    frequencies = {"axial": [700.0], "torsion": [210.0, 640.0]}
    modes = counted(frequencies, basis=basis, bending_y=2)
    robot = rod(modes=modes, section=BARE | {"EIz": 50.0})
    robot["links"][0]["modes"] = modes
    found = natural_frequencies(model_of(robot))
    assert all(np.isclose(found, f, rtol=1e-12).any() for f in flat(frequencies))


def test_another_second_frequency_moves_the_second_mode_alone():
    moved = copy.deepcopy(FOUND)
    moved["bending_y"][1] *= 1.1
    assert np.allclose(bare_frequencies(moved), flat(moved), rtol=1e-12, atol=0)
    first, second = (model_of(rod(f)).numpy().constants[0]["K"] for f in (FOUND, moved))
    ratio = np.divide(second, first)
    assert np.isclose(ratio[3], 1.21, rtol=1e-13)
    assert np.array_equal(np.delete(ratio, 3), np.ones(6))


def test_a_payload_lowers_the_frequencies_by_itself():
    """What is measured with the payload on is lower: it is not what the file asks for."""
    robot = rod({"bending_y": [20.0, 131.0]}, bodies=[{"at": "tip", "mass": 2.0}])
    assert natural_frequencies(model_of(robot))[0] < 0.5 * 20.0


# -------- frequencies are runtime parameters


def test_frequencies_are_parameters_after_the_section():
    found = [p for p in parameters(Robot.model_validate(rod())) if p.unit == "Hz"]
    assert [p.name for p in found] == [f"rod.frequencies.{d}[{k}]" for d in FOUND for k in range(len(FOUND[d]))]
    assert [p.value for p in found] == [f for values in FOUND.values() for f in values]
    assert (found[3].field, found[3].index, found[3].link) == ("frequencies.bending_y", (1,), 0)
    assert all("bare link" in p.description for p in found)


def changed(model, **values) -> list[float]:
    """The parameters with some frequencies of the rod changed: `bending_y_1=25.0`."""
    p = list(model.parameter_values)
    for name, value in values.items():
        direction, _, k = name.rpartition("_")
        p[model.parameter_names.index(f"rod.frequencies.{direction}[{k}]")] = value
    return p


def test_a_parameter_moves_its_frequency():
    model = model_of(rod())
    expected = copy.deepcopy(FOUND)
    expected["bending_y"][0], expected["torsion"][0] = 24.0, 333.0
    found = natural_frequencies(model, p=changed(model, bending_y_0=24.0, torsion_0=333.0))
    assert np.allclose(found, flat(expected), rtol=1e-12, atol=0)


def test_all_back_ends_take_frequencies_at_run_time():
    """Changed parameters give the dynamics of a file that states the changed values."""
    model, other = model_of(rod()), copy.deepcopy(FOUND)
    other["bending_y"][2], other["axial"][0] = 400.0, 1000.0
    p = changed(model, bending_y_2=400.0, axial_0=1000.0)
    rng = np.random.default_rng(4)
    q, v, w_ext = 1e-3 * rng.normal(size=7), 0.1 * rng.normal(size=7), rng.normal(size=(1, 6))
    expected = model_of(rod(other)).numpy().forward_dynamics(q, v, [], w_ext)[0]
    assert relative(model.numpy().forward_dynamics(q, v, [], w_ext)[0], expected) > 1e-3
    assert relative(model.numpy(p).forward_dynamics(q, v, [], w_ext)[0], expected) < 1e-12
    by_casadi = model.casadi()["forward_dynamics"](q, v, [], w_ext.T, p)[0]
    assert relative(by_casadi.full().ravel(), expected) < 1e-12
    compiled = quick(model)
    compiled.prepare(p)
    assert relative(compiled.forward_dynamics(q, v, [], w_ext)[0], expected) < 1e-12


@pytest.mark.parametrize(
    ("value", "message"),
    [(0.0, "bad argument"), (-20.0, "bad argument"), (float("nan"), "non-finite"), (1e300, "non-finite")],
)
def test_c_refuses_frequencies_that_are_none(value, message):
    model = model_of(rod())
    compiled = quick(model)
    for name in ("axial_1", "bending_y_0", "bending_z_0", "torsion_0"):
        with pytest.raises(ScrewgenError, match=message):
            compiled.prepare(changed(model, **{name: value}))
    compiled.prepare(None)


# -------- structure


def test_which_directions_are_measured_is_structure_and_their_values_are_not():
    tables = [
        link("a", section=BARE, modes=None) | {"modes": counted({"bending_y": [20.0]})},
        link("b", section=BARE, modes=None) | {"modes": counted({"bending_y": [31.0]})},
        link("c", section=BARE | {"EIz": 30.0}, modes=None) | {"modes": {"bending_y": 1}},
    ]
    first, second, third = Chain(Robot.model_validate(arm(*tables))).keys
    assert first == second != third and first.measured == ("bending_y",) and third.measured == ()


def test_a_section_without_any_stiffness_is_enough():
    """Mass alone: by line property, or by density and area."""
    frequencies = {"axial": [900.0], "bending_y": [20.0], "bending_z": [27.0]}
    for section in ({"rhoA": 0.78}, {"density": 7800.0, "area": 1e-4}):
        found = natural_frequencies(model_of(rod(frequencies, section=section)))
        assert np.allclose(found, flat(frequencies), rtol=1e-12, atol=0)


def test_files_survive_dump_and_load(tmp_path):
    robot = Robot.model_validate(two_links())
    path = tmp_path / "arm.toml"
    path.write_text(dump(robot), encoding="utf-8")
    assert load(path) == robot and parameters(load(path)) == parameters(robot)


def test_generated_c_checks_itself(tmp_path):
    """`make check`, in double and in float."""
    model = model_of(two_links())
    model.write(tmp_path / "out", targets=("c",))
    done = subprocess.run([require_tool("make"), "check"], cwd=tmp_path / "out" / "c", capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.count("all checks passed") == 2, done.stdout + done.stderr
    header = (tmp_path / "out" / "c" / "arm.h").read_text()
    assert "frequencies_torsion[2]; /* Hz: " in header and "a negative mass or frequency" in header


def test_the_document_shows_the_wavenumber_identification():
    text = latex.document(Robot.model_validate(two_links()))
    assert r"\boldsymbol{\omega}_n & = 2 \pi\,\mathbf{f}_n" in text
    assert r"\mathbf{K}_i\,\mathbf{1} + \operatorname{diag}\left(\boldsymbol{\omega}_n\right)^{2}" in text
    assert text.count("{(wavenumber)}") == 2
    assert r"$\mathbf{f}_{y,i}$" in text and "measured frequencies" in text
    assert "wavenumber" not in latex.document(example("ella").robot)


# -------- what the frequencies amount to, and what they are not


@pytest.mark.parametrize("name", ["ella", "six_link"])
def test_equivalent_stiffness_gives_the_stiffness_back(name):
    robot = example_dict(name)
    for table in robot["links"]:
        table.get("modes", {}).pop("basis", None)
    measured = Robot.model_validate(by_frequencies(robot))
    for table, part in zip(robot["links"], measured.links, strict=True):
        line = judge.line_properties(table["section"])
        for d, values in equivalent_stiffness(part).items():
            assert np.allclose(values, line[judge.STIFFNESS_OF[d]], rtol=1e-13)
    assert any(map(equivalent_stiffness, measured.links))


def test_equivalent_stiffness_of_a_link_that_is_no_uniform_beam():
    """Mode by mode: by the square of the frequency's ratio to the uniform beam's."""
    table = rod({"bending_z": [10.0, 10.0 * (4.694091132974175 / 1.8751040687119611) ** 2 * 1.1]})["links"][0]
    first, second = equivalent_stiffness(Link(**table))["bending_z"]
    assert np.isclose(second / first, 1.21, rtol=1e-12)
    assert equivalent_stiffness(example("ella").robot.links[0]) == {}


def test_the_equivalent_stiffness_of_the_readmes_link():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    table = tomllib.loads(re.search(r"```toml\n(section = .*?frequencies.*?)```", text, re.DOTALL)[1])
    found = equivalent_stiffness(Link(name="upper_arm", length=0.95, joint={"axes": ["y", "z"]}, **table))
    first, second = found["bending_y"]
    assert f"gives the EI that each mode amounts to, above {first:.0f} and\n  {second:.0f} N·m² in y" in text


def test_the_frequency_of_an_arm_is_not_the_frequency_of_its_links():
    """ELLA: its bare upper arm has 22.4 and 29.4 Hz, the whole arm 3.0 Hz at q = 0. From 2 Hz, EI is 17 N·m²."""
    upper = example_dict("ella")["links"][0]
    assert np.allclose([*clamped(upper)["bending_z"], *clamped(upper)["bending_y"]], [22.360, 29.420], atol=5e-4)
    robot = by_frequencies(example_dict("ella"))
    assert np.isclose(natural_frequencies(model_of(robot))[0], 2.997, atol=5e-4)
    for table in robot["links"]:
        table["modes"]["frequencies"] |= {"bending_y": [2.0], "bending_z": [2.0]}
    wrong = derive(Robot.model_validate(robot))
    assert np.isclose(equivalent_stiffness(wrong.robot.links[0])["bending_z"][0], 16.96, atol=5e-3)
    assert natural_frequencies(wrong)[0] < 0.27
