"""Inputs besides torques in generated C: what they write in the files of every robot; empty where there are none."""

from __future__ import annotations

from ...algorithms.robot_programs import free_fall
from ...algorithms.signals import CALL, Signal
from ...spec.base import BASE_MOTION
from ...spec.brake import BRAKES
from ...topology.chain import Chain
from . import brakes, tendons
from .code import Place, entries
from .pieces import piece_place, pieces

INPUTS = ("inputs",)
"""What they write, as :class:`..template_places.TemplatePlaces` finds it."""


def features(chain: Chain) -> tuple[str, ...]:
    """Those of a robot."""
    return INPUTS * bool(chain.other_inputs) + tendons.TENDONS * bool(chain.n_tensions)


def content(chain: Chain, place: Place) -> dict[str, object] | None:
    """The templates' context: how many ``others`` there are than ``axes``; the statements that find the free fall that
    inputs change, None where none does; whether inputs are ``loading`` links; whether no loops close the ``tree``;
    which inputs, of those behind torques, are no forces and are ``kept`` where these are judged."""
    if not chain.other_inputs:
        return None
    own = {"tau": entries("tau"), "free_fall": entries("free_fall")}
    placed = piece_place(chain, "kept", own, place)
    lines = pieces(free_fall(chain), placed, ("c", "tau"))["pieces"][0] if chain.falls else None
    others = chain.n_tau - chain.n_joints
    kept = [chain.inputs[row] for row in (BRAKES, BASE_MOTION) if row in chain.inputs]
    told: dict[str, object] = {"kept": f"k >= {kept[0].start} && k < {kept[-1].stop}" if kept else ""}
    told |= {"free_fall": lines, "loading": chain.inputs_load_links, "tree": not chain.closing.rows}
    return {"axes": chain.n_joints, "others": others, **told}


def scratch(chain: Chain) -> dict[str, Signal]:
    """The members of a call's scratch that inputs need."""
    falling = {"free_fall": CALL["gravity"]._replace(meaning="acceleration of free fall with that of inputs")}
    return tendons.gathered(chain) | (falling if chain.falls else {})


def note(chain: Chain) -> str:
    """What is added to the comment of ``tau``."""
    rows = (row for row in chain.other_inputs if not row.signal)
    made = "".join(f"; then {row.words}{', m/s^2' * (row.free_fall is not None)}" for row in rows)
    base = "; then the rate of the base's twist, which is given" if chain.moving else ""
    return tendons.note(chain) + brakes.note(chain) + base + made
