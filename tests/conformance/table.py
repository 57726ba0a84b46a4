"""What works with what, for people: the last part of `docs/features.md`, made from the tables."""

from __future__ import annotations

from conformance.arrays import covering
from conformance.checks import CHECKS
from conformance.features import BUILT_OTHERWISE, FEATURES, IMPOSSIBLE, possible_pairs
from conformance.refusals import REFUSALS

HEADING = "## What works with what"
HEAD = f"""{HEADING}

An example: a floating base whose arm has a tendon and a loop. Do the filter, the derivatives of a step and the mock-up
unit know all three? The tables below say so, feature by feature. They are made from those in `tests/conformance`, which
the tests run: {len(covering())} small robots hold each of the {len(possible_pairs())} pairs of features that can stand
together, and every robot goes through {len(CHECKS)} checks. A check *holds*, or the tool *refuses* in one line, for a
reason that stands here. Nothing else passes the tests.

"""


def page(text: str) -> str:
    """A page whose last part is what works with what, that part written anew."""
    return text.partition(HEADING)[0] + HEAD + checks() + matrix() + refused() + impossible()


def checks() -> str:
    """What is tried."""
    lines = [f"| {name} | {check.about} |\n" for name, check in CHECKS.items()]
    return "### Checks\n\n| check | what holds |\n|---|---|\n" + "".join(lines) + "\n"


def matrix() -> str:
    """Features with what each refuses."""
    lines = []
    for name, words in FEATURES.items():
        own = [x.check for x in REFUSALS if x.features == (name,)]
        beside = sorted(b if a == name else a for a, b in IMPOSSIBLE if name in (a, b))
        count = sum(name in pair for pair in possible_pairs())
        cells = (words, str(count), ", ".join(dict.fromkeys(own)) or "–", ", ".join(beside) or "–")
        lines.append(f"| {name} | {' | '.join(cells)} |\n")
    head = (
        "### Features\n\nThe third column counts the features of other kinds with which it is tried in one robot.\n\n"
    )
    head += "| feature | what it is | pairs | refused by the checks | cannot stand beside |\n|---|---|---|---|---|\n"
    return head + "".join(lines) + "\n"


def refused() -> str:
    """Refusals with their reasons."""
    lines = [f"| {x.check} | {', '.join(x.features) or 'some robots'} | {x.why} |\n" for x in REFUSALS]
    return "### Refused, and why\n\n| check | feature | why |\n|---|---|---|\n" + "".join(lines) + "\n"


def impossible() -> str:
    """Pairs that a robot file cannot state, or that no robot of the matrix has, by reason."""
    by_reason: dict[str, list[str]] = {}
    for pair, why in {**IMPOSSIBLE, **BUILT_OTHERWISE}.items():
        by_reason.setdefault(why, []).append(" × ".join(pair))
    lines = [f"| {', '.join(found)} | {why} |\n" for why, found in by_reason.items()]
    return "### Cannot stand together, or are not tried\n\n| features | why |\n|---|---|\n" + "".join(lines)
