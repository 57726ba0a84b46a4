"""How often a stiffness is called told that only noise seems to tell, and how often one that a vibration tells.

By hand, `python tests/told_directions.py 60`: so many logs with other noise of a pendulum that also bends across its
swing, where a gauge reads noise alone, or a vibration some times as large as the noise of a window makes one.
"""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np
from identified_arms import SENSORS, logged, pendulum, torque
from test_identify_honesty import SIDE

import screwgen
from screwgen.spec.columns import Columns

WINDOW, STEP, SECONDS = 0.5, 2e-3, 2.0
TRUE, BENT = 30.0, 1e-3
COLUMNS = Columns(columns=(*SENSORS.columns, SIDE))


def main(logs: int) -> None:
    model = pendulum(across={"EIy": TRUE})
    clean = logged(model, torque, SECONDS, STEP, 0.0, q0=(-1.5, 0.0, 0.0, BENT))
    run = screwgen.simulate(model, SECONDS, STEP, q0=[-1.5, 0.0, 0.0, BENT], controller=torque)
    vibration = run.strain[:, model.strain_names.index("rod.base_strain.bending_z")]
    vibration = (
        vibration / vibration.std() * np.sqrt(2.0) * np.sqrt(2 * STEP / WINDOW)
    )  # as large as noise of 1 makes it
    print("| vibration, over that of noise | told | of these the interval holds the number |", flush=True)
    print("|---:|---:|---:|", flush=True)
    for size in (0.0, 2.0, 4.0):
        told, held = 0, 0
        for seed in range(1000, 1000 + logs):
            rng = np.random.default_rng(seed)
            own = {name: clean.columns[name] for name in ("angle", "gauge")}
            own = {name: x + 0.01 * x.std() * rng.standard_normal(len(x)) for name, x in own.items()}
            side = size * vibration + rng.standard_normal(len(clean))
            log = replace(clean, columns=clean.columns | own | {"side": side})
            found = screwgen.identify(model, log, free=["*.EIy", "*.EIz"], sensors=COLUMNS, window=WINDOW)
            one = found["rod.EIy"]
            told += one.determined
            held += one.determined and one.low <= TRUE <= one.high
        print(f"| {size:g} | {told} of {logs} | {held} |", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 60)
