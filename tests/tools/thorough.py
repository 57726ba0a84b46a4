"""Writes `tests/thorough.txt`: what `make test` leaves to `make test-all`, by the times that tests took.

    .venv/bin/python -m pytest -n 2 --dist worksteal -q --durations=0 -vv > build/times.txt
    python tests/tools/thorough.py build/times.txt

`first`: of a function whose cases take over LONG together the first case runs; `none`: a case takes over SLOW, and
other functions of its file run, or takes over ALONE. The slice of the matrix stays whole.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

LONG, SLOW, ALONE = 0.3, 0.4, 1.5
"""s"""
WHOLE = "test_every_feature_meets_every_check"
LINE = re.compile(r"([\d.]+)s (?:call|setup|teardown)\s+(tests/\S+?)::(\w+)(\[.*)?$")


def main(times: str) -> None:
    cases: dict[tuple[str, str], dict[str, float]] = defaultdict(lambda: defaultdict(float))
    for line in Path(times).read_text(encoding="utf-8").splitlines():
        if found := LINE.match(line.strip()):
            seconds, file, function, case = found.groups()
            cases[file, function][case or ""] += float(seconds)
    total = sum(sum(own.values()) for own in cases.values())
    said, left = {}, 0.0
    for (file, function), own in cases.items():
        one = sum(own.values()) / len(own)
        others = [name for path, name in cases if path == file and said.get((path, name)) != "none"]
        if function == WHOLE:
            left += sum(own.values())
        elif one > SLOW and (len(others) > 1 or one > ALONE):
            said[file, function] = "none"
        elif len(own) > 1 and sum(own.values()) > LONG:
            said[file, function] = "first"
            left += one
        else:
            left += sum(own.values())
    text = "".join(f"{how} {file}::{function}\n" for (file, function), how in sorted(said.items()))
    Path(__file__).parents[1].joinpath("thorough.txt").write_text(text, encoding="utf-8")
    print(f"{len(said)} of {len(cases)} functions; about {left:.0f} of {total:.0f} s are left")


if __name__ == "__main__":
    main(sys.argv[1])
