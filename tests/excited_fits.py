"""Simulated fits of the motion that `excite` finds and of a random one: are intervals as much narrower as is said?

By hand, `python tests/excited_fits.py 100`: so many fits of each motion, with other noise each, begin 30 % off.
"""

from __future__ import annotations

import sys

import numpy as np
from identified_arms import TRUE, elsewhere, fits_of, pendulum
from test_excite import excited


def main(fits: int) -> None:
    """Of each number what was said, the median interval of the fits, and how far fitted values scatter."""
    found = excited()
    names = [one.name for one in found.unknowns]
    own, other = (fits_of(found, plan, pendulum(), elsewhere(), TRUE, fits) for plan in (found.plan, found.random))
    print("| number | said | interval | scatter | random: said | interval | scatter | held | random: held |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|---:|")
    wide = []
    for k, name in enumerate(names):
        row = []
        for fit, said in ((own, found.deviation), (other, found.deviation_of_random)):
            row += [said[k], np.median(fit.half[:, k]) / 1.96, fit.error[:, k].std(ddof=1)]
        held = [np.mean(np.abs(fit.error[:, k]) <= fit.half[:, k]) for fit in (own, other)]
        print(
            f"| {name} |", " | ".join(f"{100 * x:.3g} %" for x in row), "|", " | ".join(f"{x:.0%}" for x in held), "|"
        )
        wide.append(row)
    worst = np.max(wide, axis=0)
    for what, k in (("said", 0), ("intervals", 1), ("scatter", 2)):
        print(f"{what}: the widest is {worst[3 + k] / worst[k]:.2f} times narrower")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
