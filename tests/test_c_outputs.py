"""The generated C's partial outputs against NumPy, and what the places of a chain fold away."""

import re
from functools import cache

import pytest
from helpers import arm, equal_links, example, link, model_of

from screwgen.algorithms import functions as alg
from screwgen.algorithms.modal_elimination import WAYS
from screwgen.algorithms.schedule import _traced, trace
from screwgen.algorithms.structure import passages, specialised_phases
from screwgen.backends.c.project import FUSED_BEST, FUSED_MOST, CProject
from screwgen.errors import UsageError

SOFT = {"rhoA": 1.5, "EA": 5e3, "EIy": 30.0, "EIz": 50.0, "GJ": 20.0, "rhoIp": 0.02}


def bending(count: int, links: int = 2) -> dict:
    """Equal links with ``count`` modes per plane."""
    modes = {"bending_y": count, "bending_z": count}
    return arm(*(link(f"l{i}", axes="y", modes=modes, section=SOFT) for i in range(links)))


@cache
def of_ella(layout: str) -> dict[str, str]:
    return CProject(example("ella").chain, "x", "runtime", layout).files()


def test_steps_compute_neither_wrenches_nor_pose():
    """Fused: both stand behind their conditions, and no operation of a wrench runs without one."""
    text = of_ella("fused")["ella_dynamics.c"]
    for asked, written in (
        ("ELLA_WRENCHES", "wrench"),
        ("ELLA_TIP_POSE", "tip_rotation"),
        ("ELLA_TIP_POSE", "tip_position"),
    ):
        before, _, block = text.partition(f"if (wanted & {asked}) {{")
        assert f"output->{written}[" not in before and f"output->{written}[" in block


def test_ends_of_a_chain_cost_less():
    """The base is at rest and the last tip is free: their links run fewer operations than one between."""
    chain = model_of(equal_links(6)).chain
    run = passages(chain, specialised_phases(chain, alg.FORWARD, None), ("qddot", "etaddot", "wrench"))
    of = lambda link: sum(p.program.operation_count for p in run if p.link == link)  # noqa: E731
    assert of(2) == of(3) == of(4)
    assert of(0) < 0.8 * of(2) and of(5) < 0.8 * of(2)
    fused = CProject(chain, "x", "runtime", "fused").operations["total"]
    modular = CProject(chain, "x", "runtime", "modular").operations["total"]
    assert fused <= modular <= 1.06 * fused


@pytest.mark.parametrize("count", [1, 2, 4, 6])
def test_modes_are_eliminated_the_cheaper_way(count):
    """The programs of a class are those of the way with the fewest operations."""
    key = model_of(bending(count)).chain.keys[0]
    size = lambda programs: sum(p.operation_count for p in programs)  # noqa: E731
    assert size(trace(key, alg.FORWARD)) == min(size(_traced(key, alg.FORWARD, way)[0]) for way in WAYS)


def test_cost_is_linear_in_modes():
    """From 4 to 16 modes in a plane every further mode costs the same operations, within 5 %."""
    plane = lambda count: arm(link("a", axes="y", modes={"bending_y": count}, section=SOFT))  # noqa: E731
    size = lambda count: sum(p.operation_count for p in trace(model_of(plane(count)).chain.keys[0], alg.FORWARD))  # noqa: E731
    at = {count: size(count) for count in (4, 8, 16)}
    first, second = (at[8] - at[4]) / 4, (at[16] - at[8]) / 8
    assert abs(first - second) <= 0.05 * first


def test_auto_takes_the_layout_by_size():
    """One piece while it fits an instruction cache, a function per phase and class beyond."""
    layout = lambda robot, asked="auto": CProject(model_of(robot).chain, "x", "runtime", asked)  # noqa: E731
    small, large = layout(bending(1, 1)), layout(bending(1, 6))
    assert small.layout == "fused" and small.operations["total"] <= FUSED_BEST
    assert large.layout == "modular" and large.operations["total"] > FUSED_BEST


def test_a_function_too_long_for_compilers_is_refused():
    with pytest.raises(UsageError, match=rf"robot 'arm': .* more than {FUSED_MOST}; choose 'modular' or 'auto'"):
        CProject(model_of(bending(1, 16)).chain, "x", "runtime", "fused")


def test_sources_of_both_layouts_declare_what_they_promise():
    """The header names the functions for parts of the result once each."""
    for layout in ("fused", "modular"):
        header = of_ella(layout)["ella.h"]
        for function in ("accelerations", "inverse_dynamics", "mass_matrix"):
            assert len(re.findall(rf"\bella_{function}\(", header)) == 1


def test_parameters_without_effect_are_marked():
    """A stiffness that no mode feels is in the struct, since the robot file states it, and marked."""
    plane = link("a", axes="z", modes={"bending_z": 1}, section={"EIz": 3.0})
    header = CProject(model_of(arm(plane)).chain, "x").files()["arm.h"]
    marked = re.findall(r"arm_real (\w+)\S*; /\* .*; this model does not use it \*/", header)
    assert marked == ["EA", "EIz", "GJ"]


def test_links_have_names_in_c():
    header = of_ella("fused")["ella.h"]
    assert re.search(r"ELLA_LINK_UPPER_ARM = 0,\n +ELLA_LINK_FOREARM = 1\n", header)


def test_macros_have_the_robots_prefix():
    options = {"batch": True, "estimator": True}
    for name, text in CProject(example("ella").chain, "x", **options).files().items():
        if name.endswith((".h", ".c")):
            macros = re.findall(r"^ *# *define +(\w+)", text, re.MULTILINE)
            assert all(macro.lower().startswith("ella_") for macro in macros), name


def test_components_are_named_by_their_parts():
    """Six components of wrenches, twists and accelerations have letters; numbers stay for matrices and modes."""
    text = CProject(example("ella").chain, "x", layout="modular").files()["ella_links.c"]
    names = set(re.findall(r"const ella_real (\w+) =", text))
    assert {"wrench_tau_x", "wrench_f_z", "acc_0_a_x", "h_V_tau_y"} <= names
    six = [n for n in names if re.fullmatch(r"(minus_)?(wrench|acc_0|delta|h_V|H_star|p_i|p_T)_\d", n)]
    assert not six
