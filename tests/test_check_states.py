"""The state whose accelerations a document prints shows every term of its steps: one that is left out is seen."""

from dataclasses import replace

import document_symbols
import numpy as np
import pytest
import sympy as sp
from conftest import swept
from document_reader import accelerations_from_document, reading
from document_steps import integrates
from test_latex_essence import model

from screwgen.algebra import expression as ex
from screwgen.backends.latex.check_value import state

SEEN, NOTHING = 1e-6, 1e-12
"""What a term changes, over the entry that it changes most; a term that this robot does not feel changes nothing."""
STEP = document_symbols.Scope.step
UNFELT = {"pendulum": 33, "ella": 8}
"""How many terms a robot does not feel at most, as those of moments at a tip that carries a point mass."""


def variants(definition):
    """A step without each of its terms: those of its equation, or of its entries where they are its content."""
    if isinstance(definition.right, ex.Sum) and not integrates(definition.right):
        terms = definition.right.terms
        for k in range(len(terms)):
            rest = terms[:k] + terms[k + 1 :]
            yield replace(definition, right=rest[0] if len(rest) == 1 else ex.Sum(rest))
    elif integrates(definition.right):
        for index, entry in np.ndenumerate(definition.entries):
            for term in sp.Add.make_args(sp.sympify(entry)) if entry != 0 else ():
                entries = definition.entries.copy()
                entries[index] = sp.sympify(entry) - term
                yield replace(definition, entries=entries)


def changed(before, after):
    """The largest relative change of an entry."""
    sizes = [np.abs(np.ravel(x) - np.ravel(y)) / np.abs(np.ravel(x)) for x, y in zip(before, after, strict=True)]
    return max(np.nanmax(size) for size in sizes)


@pytest.mark.parametrize("name", swept(UNFELT, "pendulum"))
def test_the_state_of_a_document_shows_every_term(name, monkeypatch):
    own = model(name)
    given = state(own.chain, 1.0)
    before = accelerations_from_document(own, *given)
    parts = [part for own_parts in reading(own).document.classes.values() for part in own_parts]
    known = {id(d): (symbol, d) for part in parts for symbol, d in part.steps.items()}
    changes = []
    for symbol, definition in known.values():
        for other in variants(definition):
            step = lambda s, d, local=None, was=definition, now=other: STEP(s, now if d is was else d, local)  # noqa: E731
            monkeypatch.setattr(document_symbols.Scope, "step", step)
            changes.append((changed(before, accelerations_from_document(own, *given)), symbol))
    assert [found for found in changes if NOTHING < found[0] < SEEN] == []
    assert sum(size <= NOTHING for size, _ in changes) <= UNFELT[name] < len(changes) / 3
