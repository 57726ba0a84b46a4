"""What features of some robots add to generated C: files, programs, scratch; all empty for a robot without any."""

from __future__ import annotations

from collections import Counter

from ...spec.parameters import per_internal
from ...topology.chain import Chain
from ..templates import FEATURES
from . import brakes, closing, compliant, force_states, forces, held, inputs, laws, prescribed
from .code import Place
from .fields import has_axis_terms

CURVED = ("curved", "curved_in_derivatives", "curved_in_estimator")
"""What joints write whose coordinates do not add up, as :class:`..template_places.TemplatePlaces` finds it."""


def files(chain: Chain) -> tuple[str, ...]:
    """The files that they add, without the robot's name; their templates have the same names."""
    compliance = (compliant.FILE,) * bool(chain.compliant)
    return forces.files(chain) + ("loops.c",) * bool(chain.closing.rows) + compliance


def content(chain: Chain, baked: bool, place: Place) -> dict[str, object]:
    """The templates' context; ``place`` is that of the fused function.

    ``scratch``: how many structs of a name they keep during a call, and of numbers under an empty name; ``switches``
    and ``exponential``: whether a law calls `on` or `exp`; ``internal``: names and units of internal states, and
    ``NVZ`` the length of v.
    """
    written = prescribed.PRESCRIBED * bool(chain.given)
    written += closing.features(chain) + ("internal",) * bool(chain.n_internal)
    written += ("law_states",) * bool(chain.z_offset[-1]) + ("force_states",) * bool(chain.n_force_states)
    written += inputs.features(chain) + held.features(chain) + brakes.BRAKES * bool(chain.braked)
    acting = forces.content(chain, baked, place)
    compliance = compliant.content(chain, baked, place)
    first = compliant.COMPLIANT * bool(chain.compliant)  # what their rows bear acts before loops and forces are asked
    first = of_motion(chain) + first + forces.features(chain)
    out: dict[str, object] = {FEATURES: first + written, **acting, **compliance}
    kept = Counter(forces.scratch(chain, acting)) + Counter(compliant.scratch(chain, compliance))
    if chain.closing.rows:
        loops = closing.loops(chain, baked, place)
        kept, out = kept + Counter({"input": 1, "state": 2, "": 1 + loops["kept"]}), out | {"loops": loops}
    out |= {"internal": list(per_internal(chain.robot).items()), "NVZ": "$$_NVZ" if chain.n_internal else "$$_NV"}
    pairs = (zip(at, chain.laws[law], strict=True) for law, at in chain.internal.items())
    rates = dict(sorted((z, chain.nv - chain.n_given + acted.coordinate) for own in pairs for z, acted in own))
    out |= {"internal_rates_of_laws": list(rates.values()), "law_states": bool(rates)}
    out |= {"z_offset": chain.z_offset[:-1], "N_CHANGES": "$$_NV + $$_NVZ" if chain.n_internal else "2 * $$_NV"}
    out |= {"prescribed": prescribed.content(chain) if chain.given else None}
    out |= {"brakes": brakes.content(chain)}
    out |= {"held": held.content(chain, baked, place) if chain.holds else None}
    out |= force_states.content(chain, baked, place)
    out["switches"] = laws.calls(chain, "on") or forces.switches(chain) or held.switches(chain) or bool(chain.braked)
    out["exponential"] = laws.calls(chain, "exp")
    out["scratch"] = kept + Counter(input=int(chain.holds))
    return out | ({"idle": closing.idle_rows(chain, place)} if chain.closing.idle else {})


def of_motion(chain: Chain) -> tuple[str, ...]:
    """What coordinates write, and what acts on single ones; gears are named before laws."""
    balls = any(not part.joint.in_space for part in chain.curved)
    return (
        *("axis_forces",) * chain.has_axis_forces,
        *("rotors",) * bool(chain.n_added),
        *CURVED * bool(chain.curved),
        *("floating",) * bool(chain.base_v),
        *("own_places",) * (balls and chain.has_axis_forces),
        *("balls",) * balls,
        *("coupled_modes",) * any(key.coupled for key in chain.keys),
        *("drives",) * has_axis_terms(chain),
    )
