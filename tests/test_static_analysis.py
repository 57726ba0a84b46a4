"""The generated C under gcc's analyser, clang-tidy, cppcheck with MISRA rules, sanitizers and valgrind.

Of a small robot, fused in double or modular in float, in `make lint`; `make analyse-c` takes three larger robots in all
combinations.
"""

import pytest
from c_robots import FEW
from c_tools import clang_tidy, cppcheck, deviations, gcc_analyser, memchecked, misra, sanitized
from conftest import swept

pytestmark = pytest.mark.analysis
one_kind = pytest.mark.parametrize("kind", FEW[1:], ids=str)
fused = pytest.mark.parametrize("kind", swept(FEW, FEW[0]), ids=str)
modular = pytest.mark.parametrize("kind", swept(FEW, FEW[1]), ids=str)


@one_kind
def test_gcc_analyser_finds_nothing(tmp_path, kind):
    assert gcc_analyser(kind, tmp_path) == []


@modular
def test_clang_tidy_finds_nothing(tmp_path, kind):
    assert clang_tidy(kind, tmp_path) == []


@one_kind
def test_cppcheck_finds_nothing_but_listed_deviations(tmp_path, kind):
    """Every MISRA rule and the file it was found in are argued in docs/misra.md."""
    findings = cppcheck(kind, tmp_path)
    assert [line for line in findings if ":misra-" not in line] == []
    assert misra(findings) - deviations() == set()
    assert len(misra(findings)) > 50  # the addon ran


@modular
def test_sanitizers_find_nothing(tmp_path, kind):
    """Addresses and undefined behaviour, over null pointers, wild numbers and wild arguments."""
    assert sanitized(kind, tmp_path) == []


@fused
def test_valgrind_finds_nothing(tmp_path, kind):
    """No result depends on what scratch held before a call, and nothing is leaked."""
    assert memchecked(kind, tmp_path) == []
