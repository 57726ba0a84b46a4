"""Inputs that a predictive controller chooses, and those that are given to it: what its templates need of them."""

from __future__ import annotations

from typing import Any

from ...spec.parameters import coordinate_names
from ...topology.chain import Chain


def features(chain: Chain) -> tuple[str, ...]:
    """What they write, as :class:`..template_places.TemplatePlaces` finds it."""
    return ("chosen",) * _apart(chain) + ("planned_base",) * chain.moving


def content(chain: Chain) -> dict[str, Any]:
    """The templates' context.

    Names of sizes: `chosen` of the inputs of the program, `inputs` of all, `axes` of joints, `changes` and
    `coordinates` of a state. What writes an index: `of_tau` that of a chosen input among all, `of_joint` that of the
    joint whose coordinate is at a place among changes.
    """
    apart, chosen, given = _apart(chain), chain.chosen_inputs, chain.given_inputs
    names, held = coordinate_names(chain.robot).tau, dict(enumerate(chain.held_places))
    return {
        "chosen": "$$_MPC_CHOSEN" if apart else "$$_NTAU",
        "inputs": "$$_NTAU" if apart else "NU",
        "axes": "$$_NAXES" if chain.other_inputs else "$$_NTAU",
        "changes": "$$_NV" if chain.moving else "$$_NQ",
        "coordinates": "$$_NQ" if chain.moving else "NQ",
        "n_changes": chain.nv,
        "n_chosen": len(chosen),
        "of_tau": lambda i: f"CHOSEN[{i}]" if apart else i,
        "of_joint": lambda place: f"{place} - {chain.base_v}" if chain.base_v else place,
        "force": "force_held(m, i)" if apart else "m->force[i]",
        "found": "found" if apart else "input.tau",
        "chosen_places": chosen,
        "given_places": given,
        "chosen_names": [names[k] for k in chosen],
        "given_names": [names[k] for k in given],
        "held_places": [held.get(k, -1) for k in chosen],
    }


def _apart(chain: Chain) -> bool:
    """Whether its inputs are other ones than the torques of all joints."""
    return bool(chain.other_inputs or chain.given_inputs)
