"""Run a functional mock-up unit by Ecos: `python tests/ecos_run.py UNIT`, with the task as JSON at the standard input.

`start`: values of variables before the run; `inputs`: those held during it; `step`, s, and `count`; `names`: the
variables whose values are printed, as JSON. A process of its own, so that the loader finds the library of threads.
"""

import json
import sys

from ecospy import EcosLib, EcosSimulation, EcosSimulationStructure

task = json.load(sys.stdin)
EcosLib.set_log_level("warning")
with EcosSimulationStructure() as structure:
    structure.add_model("unit", sys.argv[1])
    structure.add_parameter_set("start", {f"unit::{name}": float(x) for name, x in task["start"].items()})
    run = EcosSimulation(step_size=task["step"], structure=structure)
run.init(parameter_set="start")
for name, value in task["inputs"].items():
    run.set_real(f"unit::{name}", value)
run.step(task["count"])
print(json.dumps([run.get_real(f"unit::{name}") for name in task["names"]]))
run.terminate()
run.free()
