"""What random robots of every kind are held against: the oracle, automatic differentiation, one back end another."""

import numpy as np
from helpers import Case, casadi_forward, quick
from oracle import part_error

from screwgen.runtime.compiled import Compiled


def casadi_dae(case: Case) -> dict[str, np.ndarray]:
    """The unknowns of the DAE form: M_sys of CasADi, solved densely, with a step of refinement.

    Wrenches are up to 1e5 times as large as accelerations, and the base of an arm does not accelerate: an LU alone
    leaves eps of the wrenches there.
    """
    functions, p, n = case.model.casadi(), case.model.parameter_values, case.model.n_links
    q, v, tau, w_ext = case.inputs
    x = functions["dae_state"](q, v, p)
    M, H, W = (np.array(a.full()) for a in functions["assemble"](x, tau, w_ext.T, p))
    z = np.linalg.solve(M, W - H)
    z = (z + np.linalg.solve(M, W - H - M @ z))[:, 0]
    links = z[: 12 * n].reshape(n, 12)
    return {"tau": links[:, :3], "F": links[:, 3:6], "alpha": links[:, 6:9], "a": links[:, 9:], "etadd": z[12 * n :]}


def dae_errors(case: Case) -> dict[str, float]:
    """Errors of wrenches, of the rates of the twists (angular, linear), and of the modal accelerations."""
    q, v, _, _ = case.inputs
    vdot, wrench = case.oracle.forward_dynamics(**case.state)
    rates = case.oracle.link_twist_rates(q, v, vdot)
    expected = {"tau": wrench[:, :3], "F": wrench[:, 3:], "alpha": rates[:, :3], "a": rates[:, 3:]}
    expected["etadd"] = case.oracle.parts(vdot, wrench)["etadd"]
    other = {"tau": "F", "F": "tau", "alpha": "a", "a": "alpha", "etadd": "alpha"}
    found = casadi_dae(case)
    return {k: part_error(expected[k], found[k], expected[other[k]]) for k in expected}


def check(case: Case, results: dict[str, dict[str, float]]) -> None:
    """Every part of every result is right to the tolerance of the robot's state."""
    wrong = {(who, part): e for who, parts in results.items() for part, e in parts.items() if not e <= case.tolerance}
    assert not wrong, f"tolerance {case.tolerance:.1e}"


def numpy_and_casadi(case: Case) -> None:
    """Forward dynamics and energy in both forms against the oracle."""
    numeric, (q, v, *_) = case.model.numpy(), case.inputs
    judge = lambda result: case.oracle.errors(case.state, *result)  # noqa: E731
    errors = {
        "NumPy": judge(numeric.forward_dynamics(*case.inputs)),
        "NumPy, DAE": judge(numeric.dae_forward_dynamics(*case.inputs)),
        "CasADi": judge(casadi_forward(case.model, *case.inputs)),
        "CasADi, DAE": dae_errors(case),
    }
    check(case, errors)
    assert np.allclose(numeric.energy(q, v), case.oracle.energy(q, v), rtol=1e-11)


def compiled_dynamics(case: Case, layout: str, derivatives: bool = False) -> Compiled:
    """Forward dynamics of the generated C, in both forms, against the oracle; returns the compiled C."""
    library = quick(case.model, layout=layout, derivatives=derivatives)
    results = {form: library.forward_dynamics(*case.inputs, form=form) for form in ("joint", "dae")}
    check(case, {form: case.oracle.errors(case.state, *result) for form, result in results.items()})
    return library
