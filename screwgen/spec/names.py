"""Names of robots and links: they become parts of C identifiers and names of files."""

import re
from typing import Any

from .values import quoted, refuse, shown

MAX_LENGTH = 40
IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*")

# C99, C11 and C23, and `asm`, which every compiler reserves.
KEYWORDS = """
    auto break case char const continue default do double else enum extern float for goto if inline int
    long register restrict return short signed sizeof static struct switch typedef union unsigned void
    volatile while alignas alignof asm bool constexpr false nullptr static_assert thread_local true typeof
    typeof_unqual
"""

# The generated main.c and check.c, targets of make and those that CMake keeps for itself, files that make looks for,
# libraries, and the C headers, or what C libraries' headers include, that a generated <name>.h
# would hide; flt, whose FLT_ROUNDS is one of <float.h>.
FILE_NAMES = """
    main check all clean test install help package m c shim
    all_build zero_check run_tests preinstall edit_cache rebuild_cache makefile gnumakefile
    features alloca endian newlib flt
    assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign
    stdarg stdatomic stdbool stdckdint stdbit stddef stdint stdio stdlib stdnoreturn string tgmath threads
    time uchar wchar wctype
"""


def link_name(value: Any) -> str:
    """A C identifier that is no keyword and does not start with an underscore."""
    if not isinstance(value, str):
        raise refuse(f"is {shown(value)}; it must be a string")
    if not IDENTIFIER.fullmatch(value):
        allowed = "it must be a C identifier: a letter, then letters a-z, digits and underscores"
        raise refuse(f"is {quoted(value)}; {allowed}")
    if len(value) > MAX_LENGTH:
        raise refuse(f"has {len(value)} characters; at most {MAX_LENGTH} are allowed")
    if value in KEYWORDS.split():
        raise refuse(f"is {quoted(value)}, a C keyword; choose another C identifier")
    return value


def robot_name(value: Any) -> str:
    """As a link's name, and not the name of a file that the generated C needs for something else."""
    name = link_name(value)
    if name.lower() in FILE_NAMES.split():
        taken = "but the generated folder or C has something of that name already; choose another name"
        raise refuse(f"is {quoted(name)}, {taken}")
    return name


def distinct(names: list[str]) -> None:
    """Refuse a name that repeats an earlier one, be it in other letter case: C macros are upper case."""
    first: dict[str, int] = {}
    for i, name in enumerate(names):
        earlier = first.setdefault(name.upper(), i)
        if earlier == i:
            continue
        only_in_case = "" if name == names[earlier] else " but for the case of its letters"
        what = f"is {quoted(name)}, the name of links[{earlier}]{only_in_case}; every link needs its own name"
        raise refuse(what, at=("links", i, "name"))
