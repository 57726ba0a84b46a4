"""Derivatives in C by recursion over links: against the same in straight lines, and against differences."""

import numpy as np
import pytest
from floating_robots import SATELLITE
from helpers import equal_links, example, model_of, quick, relative
from step_judges import point
from test_derivatives import MIXED, UNTURNED
from test_tree import FORK

from screwgen.backends.c.project import CProject
from screwgen.backends.c.recursive_slopes import is_chosen

ROBOTS = {"mixed": MIXED, "unturned": UNTURNED, "tree": FORK, "floating": SATELLITE, "classes": equal_links(4, 3)}


@pytest.mark.parametrize("robot", ROBOTS)
def test_recursion_equals_straight_lines(robot):
    model, found = model_of(ROBOTS[robot]), []
    given = point(model)
    for layout in ("fused", "modular"):
        c = quick(model, layout=layout, derivatives=True)
        step = c.step_derivatives(*given, 1e-3, "modal_implicit")
        found.append([*c.linearise(*given), *c.linearise_wrenches(*given), *step])
    for straight, recursive in zip(*found, strict=True):
        assert relative(recursive, straight) <= 1e-12


def test_a_long_chain_by_differences():
    """Accelerations and wrenches along directions of coordinates, rates and torques; many coordinates, two classes."""
    model, h = model_of(equal_links(24, 2)), 1e-5
    c, (*x, w_ext) = quick(model, derivatives=True), point(model, angle=0.3)
    slopes = [c.linearise(*x, w_ext)[1:], c.linearise_wrenches(*x, w_ext)[1:]]
    for k, own in enumerate(x):
        way = np.random.default_rng(k).normal(size=len(own))
        moved = lambda t, k=k, way=way: [y + t * way if j == k else y for j, y in enumerate(x)]  # noqa: E731
        ends = [c.forward_dynamics(*moved(t * h), w_ext) for t in (-2, -1, 1, 2)]
        for number, values in enumerate(zip(*(map(np.copy, end) for end in ends), strict=True)):
            there = (values[0] - 8 * values[1] + 8 * values[2] - values[3]) / (12 * h)
            exact = slopes[number][k]
            assert relative(np.reshape(exact, (-1, len(own))) @ way, there.ravel()) <= 1e-6


def test_the_text_does_not_grow_with_the_chain():
    """Further links of a class are further entries of tables."""
    few, many = (CProject(model_of(equal_links(n)).chain, "0", derivatives=True) for n in (18, 36))
    for template in ("derivatives.c", "wrench_derivatives.c", "derivatives.h"):
        assert len(many.text(template)) - len(few.text(template)) < 3000


def test_a_long_chain_that_a_spring_bends():
    """From its first tip to its last: text that hardly grows, and what straight lines have."""
    robots = [sprung(n) for n in (17, 34)]
    few, many = (CProject(model_of(robot).chain, "0", derivatives=True) for robot in robots)
    for template in ("derivatives.c", "wrench_derivatives.c"):
        assert len(many.text(template)) < 1.6 * len(few.text(template))
    found = [quick(model_of(sprung(6)), layout=layout, derivatives=True) for layout in ("fused", "modular")]
    given = point(model_of(sprung(6)))
    for straight, recursive in zip(*(c.linearise_wrenches(*given) for c in found), strict=True):
        assert relative(recursive, straight) <= 1e-12


def sprung(count: int) -> dict:
    """A chain with a spring and damper between its first tip and its last."""
    line = {"stiffness": 100.0, "damping": 1.0, "rest": 0.2}
    ends = ["link0.tip", f"link{count - 1}.tip"]
    return equal_links(count) | {"forces": [{"name": "spring", "between": ends, "line": line}]}


def test_what_is_written_so():
    """Many pairs of coordinates; of few whoever asks for modular code, with loops as without; none with brakes."""
    small, long, loop = (r.chain for r in (example("ella"), model_of(equal_links(17)), example("crane_loop")))
    layouts = "auto", "modular", "fused"
    for chain in (small, loop):
        assert [is_chosen(chain, layout) for layout in layouts] == [False, True, False]
    assert [is_chosen(long, layout) for layout in layouts] == [True, True, False]
    braked = equal_links(17)
    braked["links"][0]["joint"]["brake"] = True
    assert not any(is_chosen(model_of(braked).chain, layout) for layout in layouts)
