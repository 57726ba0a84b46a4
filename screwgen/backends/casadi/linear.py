"""Exact first derivatives as CasADi functions: of dynamics and outputs, of loops, of the statics."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from ...algorithms import linear_model as programs
from ...algorithms.robot_function import RobotFunction
from ...algorithms.robot_functions import BY_NAME
from ...topology.chain import Chain
from .expressions import expressions
from .functions import function, symbols


def linear_model(chain: Chain, sensors: Sequence[RobotFunction] = ()) -> ca.Function:
    """The program :func:`..algorithms.linear_model.changes`; where directions have columns the results have them."""
    program = programs.changes(chain, sensors)
    given = symbols(chain, "q v tau w_ext p") | {n: ca.SX.sym(n, k) for n, k in program.inputs.items() if n[:2] == "d_"}
    return function("linear_model", given, **expressions(program, given))


def closing(chain: Chain) -> ca.Function:
    """The program :func:`..algorithms.linear_model.closing`; ``wrench`` is (6, n)."""
    rows, nv = len(chain.closing.rows), chain.nv
    given = symbols(chain, "q v") | {"forces": ca.SX.sym("forces", rows)} | symbols(chain, "p")
    shapes = {"gap": (rows, 1), "J": (rows, nv), "J_v": (rows, nv), "bend": (nv, nv), "wrench": (6, chain.n)}
    found = expressions(programs.closing(chain), given)
    return function("closing", given, **{name: ca.reshape(found[name], *shape) for name, shape in shapes.items()})


def tendon_work(chain: Chain) -> ca.Function:
    """``(q, others, p) -> (work, force, slope)``: what tensions do from straight tendons of no length to ``q``, J, its
    derivative along the rates (nv), which is their generalised force, and the derivative of that (nv, nv).

    ``others``: the inputs behind torques of axes, tensions among them.
    """
    given = symbols(chain, "q p")
    others = ca.SX.sym("others", chain.n_tau - chain.n_joints)
    work = -ca.dot(others[: chain.n_tensions], expressions(BY_NAME["tendon_length"].program(chain), given)["length"])
    slope, force = ca.hessian(work, given["q"])
    along, bend = ca.SX.zeros(chain.nv), ca.SX.zeros(chain.nv, chain.nv)
    along[chain.flat_v.tolist()] = force[chain.flat_q.tolist()]  # tendons bend links, and turn no ball joint
    bend[chain.flat_v.tolist(), chain.flat_v.tolist()] = slope[chain.flat_q.tolist(), chain.flat_q.tolist()]
    return ca.Function("tendon_work", [given["q"], others, given["p"]], [work, along, bend])


def statics(chain: Chain) -> ca.Function:
    """The program :func:`..algorithms.linear_model.statics`; ``wrench`` is (6, n)."""
    chain.refuse_floating_base("equilibrium", "simulate it with dampers, or with PD control")
    nv, given = chain.nv, symbols(chain, "q w_ext p")
    shapes = {"stiffness": (nv, nv), "weight": (nv, 3), "wrench": (6, chain.n)}
    found = expressions(programs.statics(chain), given)
    return function("statics", given, **found | {name: ca.reshape(found[name], *of) for name, of in shapes.items()})
