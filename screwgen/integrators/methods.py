"""The built-in time steps, and their look-up by name.

Torques and external wrenches are held over a step. A method of one's own is a :class:`.Method`, given wherever one of
these is named.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from ..arguments import choice
from ..errors import UsageError
from .method import Method, Move, Stage

BUILT_IN = (
    # Amplifies every undamped mode; for comparison.
    Method("euler", 1, (Stage(),), Move([1]), "forward Euler, explicit"),
    # Symplectic; stable below 2 / omega_max.
    Method("semi_implicit", 1, (Stage(),), Move([1], "new"), "rates first, then coordinates with the new rates"),
    # Stable for any stiffness and damping of modes and joints; damps what is stiff. The rest is taken at the step's
    # start: where joints turn at a rate r, slow swings gain up to about h r² / 2 per second.
    Method(
        "modal_implicit",
        1,
        (Stage(implicit=1),),
        Move([1], "new"),
        "semi_implicit with the elastic forces at the step's end, stable for stiff modes",
    ),
    # Stable for any stiffness and damping of modes and joints; damps nothing that has no damper. The rest is taken in
    # the middle of the step, as the start predicts it: turning, weight and torques must change little over a step.
    Method(
        "modal_midpoint",
        2,
        (Stage(implicit="1/2"), Stage(["1/2"], "new", implicit="1/2")),
        Move([0, 1], "mean"),
        "midpoint rule with implicit elastic forces, stable for stiff modes, two forward dynamics",
    ),
    # Stable below 2.8 / omega_max.
    Method(
        "rk4",
        4,
        (Stage(), Stage(["1/2"]), Stage([0, "1/2"]), Stage([0, 0, 1])),
        Move(["1/6", "1/3", "1/3", "1/6"]),
        "classical Runge-Kutta, four forward dynamics",
    ),
)

METHODS: Mapping[str, Method] = MappingProxyType({method.name: method for method in BUILT_IN})
"""The built-in methods by name."""


def with_built_in(more: Iterable[Method]) -> dict[str, Method]:
    """The built-in methods and others by name; raises UsageError where two share one."""
    out = dict(METHODS)
    for method in more:
        if not isinstance(method, Method):
            raise UsageError(f"methods: {method!r} is no Method; built-in ones are there without being named")
        if out.setdefault(method.name, method) != method:
            raise UsageError(f"methods: there is another integrator '{method.name}'; choose another name")
    return out


def method_of(
    given: str | Method, known: Mapping[str, Method] = METHODS, missing: str = "there is no integrator"
) -> Method:
    """The method of a name, or the one that is given; raises UsageError on unknown names."""
    if isinstance(given, Method):
        return given
    choice(given, known, missing)
    return known[given]
