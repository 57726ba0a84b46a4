"""Functional mock-up units under test: written without optimisation, unpacked, and called function by function."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave
from helpers import QUICK, arm, link, model_of

from screwgen import Model
from screwgen.runtime import fmu

KINDS = {("fmu2", "cs"): FMU2Slave, ("fmu2", "me"): FMU2Model, ("fmu3", "cs"): FMU3Slave, ("fmu3", "me"): FMU3Model}
FORMS = tuple(KINDS)


def small() -> dict:
    """A boom that bends, on two sprung axes, with a slide that carries a load: little code of every sort."""
    stiff = {"EIy": 30.0, "EIz": 50.0}
    boom = link("boom", 0.8, "yz", modes={"bending_y": 1}, section=stiff, joint={"damping": [0.1, 0.1]})
    load = link("load", 0.2, [{"slide": "x"}], bodies=[{"at": "tip", "mass": 0.7}])
    return arm(boom, load) | {"name": "small"}


@cache
def written(target: str, make=small, outputs=False):
    """Model and path of a unit. ``make`` gives a robot or its model; ``outputs``: with what sensors measure."""
    fmu.FLAGS = (*QUICK, "-fvisibility=hidden")
    made = make()
    model = made if isinstance(made, Model) else model_of(made)
    folder = Path(mkdtemp(prefix="screwgen-fmi-"))
    model.write(folder / "out", targets=(target,), outputs=outputs)
    return model, folder / "out" / target / f"{model.robot.name}.fmu"


class Unit:
    """An instance of a unit in a form of `KINDS`; variables are known by their names."""

    def __init__(self, target: str, kind: str, make=small, outputs=False):
        self.target, self.kind = target, kind
        self.model, path = written(target, make, outputs)
        self.description = read_model_description(str(path))
        self.references = {x.name: x.valueReference for x in self.description.modelVariables}
        folder, name = extract(str(path)), self.model.robot.name
        token = self.description.guid if target == "fmu2" else self.description.instantiationToken
        self.fmu = KINDS[target, kind](guid=token, unzipDirectory=folder, modelIdentifier=name, instanceName="one")

    def ready(self, early=False, events=False, **start) -> Unit:
        """Instantiated and initialised with start values."""
        if self.target == "fmu2":
            self.fmu.instantiate()
            self.fmu.setupExperiment(startTime=0.0)
        elif self.kind == "cs":
            self.fmu.instantiate(earlyReturnAllowed=early, eventModeUsed=events)
        else:
            self.fmu.instantiate()
        self.fmu.enterInitializationMode()
        self.set(start)
        self.fmu.exitInitializationMode()
        if self.kind == "me" or events:
            self.fmu.enterContinuousTimeMode() if self.kind == "me" else self.fmu.enterStepMode()
        return self

    def of(self, names) -> list[int]:
        return [self.references[name] for name in names]

    def get(self, names) -> np.ndarray:
        read = self.fmu.getReal if self.target == "fmu2" else self.fmu.getFloat64
        return np.array(read(self.of(names)))

    def set(self, values: dict) -> None:
        write = self.fmu.setReal if self.target == "fmu2" else self.fmu.setFloat64
        if values:
            write(self.of(values), [float(x) for x in values.values()])

    def choose(self, method: int) -> None:
        write = self.fmu.setInteger if self.target == "fmu2" else self.fmu.setInt64
        write([self.references["solver.method"]], [method])

    def step(self, t: float, h: float):
        return self.fmu.doStep(t, h)

    @property
    def states(self) -> list[str]:
        return [*self.model.q_names, *self.model.v_names]

    @property
    def inputs(self) -> list[str]:
        return [x.name for x in self.description.modelVariables if x.causality == "input"]

    @property
    def unknowns(self) -> list[str]:
        """All rates of states and outputs."""
        rates = [x.variable.name for x in self.description.derivatives]
        return rates + [x.variable.name for x in self.description.outputs]
