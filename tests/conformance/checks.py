"""The checks of the matrix, by name: what is done with a robot, in one function each."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from conformance import commands, filtered, folders, measured, numbers, planned, predicted, slopes, uses
from conformance.cases import Case
from conformance.refusals import refusals_of
from screwgen import ScrewgenError


class Check(NamedTuple):
    """``run`` raises AssertionError where a robot does not hold; ``about``: a sentence for the table."""

    run: Callable[[Case], None]
    about: str


CHECKS: dict[str, Check] = {
    "judge": Check(numbers.judge, "motion, wrenches, poses, energy, inverse dynamics of an independent Lagrangian"),
    "DAE form": Check(numbers.numpy_dae, "the DAE form equals it, by elimination and by dense solving"),
    "CasADi": Check(numbers.casadi, "every function equals NumPy's"),
    "acados": Check(numbers.acados, "implicit and explicit rows agree, forces of loops among the unknowns"),
    "acados, DAE form": Check(numbers.acados_dae, "its rows vanish at NumPy's rates; their unknowns are the judge's"),
    "JAX": Check(numbers.jax_functions, "dynamics both ways, energy and a step equal NumPy's"),
    "JAX, gradients": Check(numbers.jax_gradients, "gradients equal CasADi's; every other function"),
    "C, fused": Check(partial(numbers.c_functions, layout="fused"), "every function and every step, both forms"),
    "C, modular": Check(partial(numbers.c_functions, layout="modular"), "every function and every step, both forms"),
    "C, baked": Check(partial(numbers.c_functions, layout="auto", parameters="baked"), "with parameters as numbers"),
    "parameters": Check(numbers.parameters, "other numbers at run time make the robot whose file has them"),
    "C, float": Check(numbers.c_float, "accelerations in single precision"),
    "sensors": Check(measured.sensors, "what markers read equals the judge's sections, their rates and strains"),
    "validity": Check(measured.validity, "how far links are from the model's limits, by the judge's loads"),
    "lanes": Check(numbers.lanes, "a step of many scenarios at once, in double precision"),
    "lanes, float": Check(partial(numbers.lanes, single=True), "the same in single precision"),
    "C folder": Check(folders.folder, "compiles without a warning and passes its self-check, in double and float"),
    "derivatives": Check(slopes.dynamics, "exact slopes of accelerations, in C and NumPy, equal differences"),
    "derivatives of wrenches": Check(slopes.wrenches, "exact slopes of joint wrenches equal differences"),
    "derivatives of steps": Check(slopes.steps, "exact slopes of every step equal differences"),
    "derivatives by parameters": Check(
        slopes.by_parameters,
        "exact slopes with numbers of the file, in NumPy, CasADi and C, equal differences in 40 digits",
    ),
    "linear model": Check(slopes.linear, "A, B, C and D are these slopes, by coordinates that loops leave free"),
    "runs": Check(uses.runs, "a run by C equals one by CasADi and a rollout, with what they report"),
    "DAE runs": Check(uses.dae_runs, "a run of the DAE form equals one of the joint form by the same method"),
    "energy balance": Check(
        uses.energy, "a step gains what inputs do less what dampers take, and drives what they give"
    ),
    "estimator": Check(
        filtered.estimator, "the filter in C equals that in Python with every sensor, a prediction equals a step"
    ),
    "estimator of parameters": Check(
        filtered.parameters, "the filter in C that also finds numbers of the file equals that in Python"
    ),
    "identification": Check(uses.identification, "a mass is found again from what a run records"),
    "equilibrium": Check(uses.equilibrium, "where it is found nothing accelerates"),
    "plan": Check(
        planned.plan,
        "a planned motion is played as planned, by a law so weak that torques ahead must be right; poles under it are "
        "those of exact slopes",
    ),
    "predictive control": Check(
        predicted.program, "the program of the controller in C is the dense one of CasADi's functions, inputs given too"
    ),
    "modes": Check(uses.modes, "frequencies and shapes with the joints locked and free"),
    "document": Check(uses.document, "a program that reads its steps alone computes accelerations and wrenches"),
    "commands": Check(commands.every_command, "every command ends well"),
    "mock-up unit": Check(commands.units, "a unit of FMI 2 or 3 steps as the C does, with its slopes"),
    "URDF": Check(commands.urdf, "exported and imported again"),
    "robot file": Check(uses.toml, "written and read again it is the same robot"),
}


def outcome(name: str, case: Case) -> str:
    """Runs a check on a robot: "holds", or the reason of its refusal; fails on anything else.

    Where a feature is refused the rest of the robot is tried without it, so that no pair goes untried.
    """
    refused = refusals_of(name, case.features)
    try:
        CHECKS[name].run(case)
    except ScrewgenError as error:
        met = [x for x in refused if x.words in str(error)]
        if not met:
            raise
    else:
        expected = [x for x in refused if not x.large]
        assert not expected, f"is not refused: {expected}"
        return "holds"
    if plain := {x.features[0] for x in refused if x.features}:
        CHECKS[name].run(case.without(plain))
    return "; ".join(dict.fromkeys(x.why for x in met))
