"""The paper's equations: each label once, each standing judged by numbers, each difference a formula that is one."""

import numpy as np
import pytest

import screwgen
from screwgen.algebra.expression import Negative, Sum, add
from screwgen.algebra.rewrite import substitute
from screwgen.paper.equation import SEEDS, TOLERANCE, Equality, Standing
from screwgen.paper.erratum import WRONG
from screwgen.paper.evaluate import evaluate
from screwgen.paper.quantities import QUANTITIES
from screwgen.paper.random_motion import instant
from screwgen.paper.register import SECTIONS, equations, errata

LABELS = """
1 2 twist Ad 5 8 10 11
26 27 28 29 30 Iibi 32 33 34 35 36 37 38 39
46 47 45 43 48 49 50 accconst1 accconst1b accconst2 accconst4 accconst5
58 59 60 61 62 63 65 66 67 68 69 70 71
twist_coords 72 73 74 75 76 77 78 79 vxi_modal vxidot_modal 81 82 83 84 zi_def 85 86 88 89
95 MsPsi HMs 97 98 100 jacobian
103 cross 2T Msys_diff DAESOL 109 110 111
phi_x phi_y phi_z stability
14 15 16 17 18 19 20 21 22 23 24 25 Vdot_coord dvi dvxi dvb
B1 B2 B3
""".split()
"""Every label of the paper's displayed equations."""

ALL = equations()
JUDGED = [e for e in ALL if all(isinstance(s, Equality) for s in (*e.printed, *e.derived)) and not e.judge]
ids = lambda e: getattr(e, "label", None) or e.number  # noqa: E731


def test_every_label_is_there_once():
    found = [e.label for e in ALL]
    assert len(set(found)) == len(found)
    assert not set(LABELS) - set(found)
    assert "Table 1" in found


@pytest.mark.parametrize("e", ALL, ids=ids)
def test_the_standing_is_what_the_numbers_say(e):
    for seed in SEEDS:
        printed, derived = e.misfits(seed)
        assert derived <= TOLERANCE
        assert (printed > WRONG) if e.standing is Standing.FAILS else (printed <= TOLERANCE)


@pytest.mark.parametrize("e", [e for e in ALL if e.reading], ids=ids)
def test_without_the_reading_the_printed_formula_fails(e):
    if e.judge:
        pytest.fail("an equation with a reading must be judged on a motion")
    motion = instant(SEEDS[0], e.isolated)
    assert max(s.read(e.where).misfit(motion) for s in e.printed) > WRONG


@pytest.mark.parametrize("e", [e for e in JUDGED if e.derived], ids=ids)
def test_the_difference_is_printed_minus_derived(e):
    motion = instant(SEEDS[0], e.isolated)
    shown = iter(e.differences())
    for printed, derived in zip(e.printed, e.derived, strict=True):
        printed, derived = printed.read(e.reading), derived
        values = [substitute(r, e.where) for r in (printed.left, printed.right, derived.left, derived.right)]
        left_p, right_p, left_d, right_d = (evaluate(x, motion) for x in values)
        gap = right_p - right_d if printed.left == derived.left else (left_p - right_p) - (left_d - right_d)
        if np.abs(gap).max() > 1e-12 * np.abs(right_p).max():
            formula = evaluate(substitute(next(shown), e.where), motion)
            assert np.allclose(formula, gap, rtol=1e-10, atol=1e-12 * max(1.0, np.abs(gap).max()))


@pytest.mark.parametrize("e", [e for e in ALL if e.derived], ids=ids)
def test_a_failing_equation_shows_its_difference(e):
    assert e.gaps()


@pytest.mark.parametrize("e", [e for e in JUDGED if e.standing is not Standing.FAILS], ids=ids)
def test_the_judge_sees_a_wrong_sign(e):
    """Every term of every line of a formula that holds: with the other sign it holds no more."""
    motion = instant(SEEDS[0], e.isolated)
    for s in e.printed:
        s = s.read(e.reading).read(e.where)
        for wrong in flipped(s.right):
            if np.abs(evaluate(s.right, motion) - evaluate(wrong, motion)).max() > 1e-9:
                assert Equality(s.left, wrong).misfit(motion) > 1e-4


def flipped(e):
    """The expression with one of its terms negated, for each term."""
    terms = e.terms if isinstance(e, Sum) else (e,)
    for k in range(len(terms)):
        yield add(*(Negative(t) if i == k else t for i, t in enumerate(terms)))


@pytest.mark.parametrize("e", errata(), ids=ids)
def test_an_erratum_is_shown_by_its_figures(e):
    figures = e.evidence()
    assert any(f.printed_fails for f in figures)
    assert all(f.derived_holds for f in figures)


def test_the_errata_are_numbered_without_gap():
    numbers = [int(e.number[1:]) for e in errata()]
    assert numbers == list(range(1, len(numbers) + 1))
    assert len(numbers) >= 34


def test_equations_and_errata_name_each_other():
    labels, numbers = {e.label for e in ALL}, {e.number for e in errata()}
    assert not {label for e in errata() for label in e.where} - labels
    assert not {number for e in ALL for number in e.errata} - numbers
    assert {number for e in ALL for number in e.errata} == numbers, "an erratum that no equation names"
    failing = {e.label for e in ALL if e.standing is Standing.FAILS}
    assert not {e.label for e in ALL if e.label in failing and not e.errata}


def test_every_equation_says_where_it_stands():
    assert all(e.section in SECTIONS and e.title and e.printed for e in ALL)
    assert all(s.name.partition(":")[0] in QUANTITIES or e.judge for e in ALL for s in e.symbols)


def test_the_blocks_that_are_named_exist(model):
    blocks = model.blocks(1)
    named = [name.strip() for e in ALL for name in e.block.split(",") if name.strip()]
    assert named
    for name in named:
        block, _, step = name.partition(".")
        known = blocks[block].values
        assert step in known, name


@pytest.fixture(scope="module")
def model():
    return screwgen.derive(screwgen.load("examples/ella_paper.toml"))
