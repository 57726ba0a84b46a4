"""Accelerations and joint wrenches of random robots against the oracle: an independent Lagrangian.

Every back end, both forms, and every function: NumPy, CasADi and the compiled C. Each of the parts joint accelerations,
modal accelerations, joint moments and joint forces is measured against its own largest entry and must be right to
max(1e-10, 50 eps cond M).
"""

import pytest
from conftest import swept
from helpers import EPS32, disagreement, drawn, quick
from mixed_arms import case_of, judged

SEEDS = range(50)
"""Ten robots of each number of links, from one to five."""


@pytest.mark.parametrize("seed", swept(SEEDS, *SEEDS[:5], 6, 7))
def test_accelerations_and_wrenches(seed):
    case = drawn(seed, 1 + seed % 5)
    judged(case_of(case.robot, case.state), ("fused", "modular")[seed % 2])


@pytest.mark.parametrize("seed", swept(range(4), 0, 1))
def test_single_precision(seed):
    """Float C is right to 50 eps32 cond M, on robots where that leaves digits."""
    case = drawn(200 + seed, 1 + seed, limit=2e3)
    compiled = quick(case.model, layout=("fused", "modular")[seed % 2], single=True)
    expected = case.oracle.forward_dynamics(**case.state)
    tolerance = 50 * EPS32 * case.oracle.condition(case.state["q"])
    assert tolerance < 0.02
    for form in ("joint", "dae"):
        assert disagreement(case.oracle, expected, compiled.forward_dynamics(*case.inputs, form=form)) <= tolerance
