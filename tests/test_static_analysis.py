"""The generated C under gcc's analyser, clang-tidy, cppcheck with MISRA rules, sanitizers and valgrind.

A choice of robots, layouts and precisions; `make analyse-c` runs them all.
"""

import pytest
from c_robots import FEW, SOME
from c_tools import clang_tidy, cppcheck, deviations, gcc_analyser, memchecked, misra, sanitized


def kinds(few):
    return pytest.mark.parametrize("kind", few, ids=str)


@kinds(FEW)
def test_gcc_analyser_finds_nothing(tmp_path, kind):
    assert gcc_analyser(kind, tmp_path) == []


@kinds(SOME)
def test_clang_tidy_finds_nothing(tmp_path, kind):
    assert clang_tidy(kind, tmp_path) == []


@kinds(FEW)
def test_cppcheck_finds_nothing_but_listed_deviations(tmp_path, kind):
    """Every MISRA rule and the file it was found in are argued in docs/misra.md."""
    findings = cppcheck(kind, tmp_path)
    assert [line for line in findings if ":misra-" not in line] == []
    assert misra(findings) - deviations() == set()
    assert len(misra(findings)) > 50  # the addon ran


@kinds(SOME)
def test_sanitizers_find_nothing(tmp_path, kind):
    """Addresses and undefined behaviour, over null pointers, wild numbers and wild arguments."""
    assert sanitized(kind, tmp_path) == []


@kinds(FEW)
def test_valgrind_finds_nothing(tmp_path, kind):
    """No result depends on what scratch held before a call, and nothing is leaked."""
    assert memchecked(kind, tmp_path) == []
