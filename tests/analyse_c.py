"""Every analyser over every robot, layout and precision of c_robots: a table; exit status 1 if anything was found."""

import shutil
import sys
import tempfile
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from c_robots import ALL, Kind
from c_tools import clang_tidy, cppcheck, deviations, gcc_analyser, memchecked, misra, sanitized

TOOLS = {
    "gcc -fanalyzer": partial(gcc_analyser, whole=True),
    "clang-tidy": partial(clang_tidy, whole=True),
    "cppcheck": cppcheck,
    "sanitizers": sanitized,
    "valgrind": memchecked,
}
WORKERS = 2
PROGRAMS = ("gcc", "clang-tidy", "cppcheck", "valgrind")


def findings(tool: Callable[[Kind, Path], list[str]], kind: Kind) -> list[str]:
    with tempfile.TemporaryDirectory(prefix="screwgen-") as folder:
        return tool(kind, Path(folder))


def main() -> int:
    missing = [name for name in PROGRAMS if not shutil.which(name)]
    if missing:
        print(f"analyse-c: not installed: {', '.join(missing)}", file=sys.stderr)
        return 2
    seen, failed = set(), False
    width = max(len(str(kind)) for kind in ALL)
    print(f"{'':{width}}  {'  '.join(TOOLS)}")
    with ThreadPoolExecutor(WORKERS) as pool:
        pending = {kind: [pool.submit(findings, tool, kind) for tool in TOOLS.values()] for kind in ALL}
        for kind, row in pending.items():
            results = [job.result() for job in row]
            rules = misra(results[list(TOOLS).index("cppcheck")])
            seen |= rules
            left = [[line for line in found if ":misra-" not in line] for found in results]
            cells = (f"{len(found) or 'clean':>{len(name)}}" for name, found in zip(TOOLS, left, strict=True))
            print(f"{kind!s:{width}}  {'  '.join(cells)}", flush=True)
            new = [f"MISRA rule {rule} in {file}: not in docs/misra.md" for rule, file in sorted(rules - deviations())]
            for line in (*new, *(line for found in left for line in found)):
                print("   ", line)
                failed = True
    for rule, file in sorted(deviations() - seen):
        print(f"docs/misra.md lists rule {rule} in {file}, which was not found")
        failed = True
    rules = len({rule for rule, _ in seen})
    print("FAILED" if failed else f"clean; MISRA deviates from {rules} rules, all argued in docs/misra.md")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
