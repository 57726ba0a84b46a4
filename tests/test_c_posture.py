"""Torques that hold an arm against gravity by the generated C; and what it refuses of postures."""

import ctypes

import numpy as np
import pytest
from c_robots import strange
from helpers import example, model_of, quick
from varying_robots import tapered_arm

from screwgen.studies.equilibrium import equilibrium


def test_gravity_of_a_limp_arm_says_what_it_leaves():
    """Links that sag by a tenth of their length: the rounds do not converge, and the modal forces tell."""
    model = model_of(strange())
    force, _ = quick(model).gravity(np.zeros(model.nq))
    assert np.max(np.abs(force[model.n_joints :])) > 1.0


@pytest.mark.parametrize("name", ["ella", "tapered"])
def test_gravity_is_the_equilibrium_of_held_joints(name):
    """The torques and modal coordinates of the search for rest, in one call."""
    model = example("ella") if name == "ella" else model_of(tapered_arm(stiff=20.0, springs=False))
    m, w_ext = model.n_joints, np.zeros((model.n_links, 6))
    w_ext[-1] = [0.1, -0.2, 0.1, 1.0, -2.0, 0.5]
    q = np.append(np.linspace(0.4, 1.0, m), np.zeros(model.nq - m))
    for wrenches in (0 * w_ext, w_ext):
        force, at = quick(model).gravity(q, wrenches)
        rest = equilibrium(model, q[:m], w_ext=wrenches, hold=True)
        assert np.allclose(force[:m], rest.tau, rtol=0, atol=1e-6 * np.max(np.abs(rest.tau)))
        assert np.allclose(at, rest.q, rtol=0, atol=1e-6 * np.max(np.abs(rest.q[m:])))
        assert np.max(np.abs(force[m:])) < 1e-6 * np.max(np.abs(rest.wrench[:, 3:]))


def test_statuses():
    """Null pointers are bad arguments; what is not finite is said, and the state stays as it was."""
    model = example("ella")
    nv, n, library = model.nq, model.n_links, quick(model).library
    parameters, constants, chain = (ctypes.create_string_buffer(1 << 18) for _ in range(3))
    x, motion, force = np.zeros(2 * nv), np.zeros(30 * n), np.zeros(nv)
    u, J = np.zeros(model.n_joints + 6 * n), np.zeros(6 * nv)

    def call(function: str, *given) -> int:
        taken = [ctypes.c_void_p(x.ctypes.data) if isinstance(x, np.ndarray) else x for x in given]
        return getattr(library, f"ella_{function}")(*taken)

    call("parameters_default", parameters)
    assert call("prepare", parameters, constants) == 0
    for k in range(4):
        given = [constants, x, chain, motion]
        given[k] = None
        assert call("kinematics", *given) == call("tip_jacobian", *given, J) == 3
    x[0] = np.nan
    assert call("kinematics", constants, x, chain, motion) == 1
    assert call("tip_jacobian", constants, x, chain, motion, J) == 1
    assert call("gravity", constants, x, u, chain, force, x) == 1 and np.isnan(x[0])
    assert call("gravity", constants, x, u, chain, None, x) == 3
