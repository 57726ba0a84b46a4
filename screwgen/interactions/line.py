"""A spring and a damper along the line between two points; with `slack` a rope, which pulls alone.

With the length ``l`` between the points it pulls both together with ``T = k (l - rest) + c dl/dt``. A rope of that
stiffness pulls where it is longer than its rest length, and never pushes. With `winch` a controller chooses how much
line is paid out: ``T = k (l - rest - paid_out) + c (dl/dt - speed)``. The speed is an input of its own, for between two
samples nobody knows the rate of a length, and both the damping and the power of the winch need it.

A stiff line limits the step; with `implicit` steps by implicit methods take its pull at their end.

With a `relaxation` a second spring lies beside the first, in series with a damper: what plastics and ropes do that are
held stretched. Its stretch is a state, ``dz/dt = dl/dt - z/relaxation_time``, its pull ``relaxation z``.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from .interaction import (
    FORCE,
    POTENTIAL,
    ROWS,
    ForceInput,
    ForceState,
    Interaction,
    InteractionClass,
    LawEquation,
    Relative,
    ReportedQuantity,
    SoftRow,
    StateRate,
    Value,
    WrenchOnSecond,
    choice,
    number,
)
from .vectors import dot

SHORTEST = 1e-24
"""m²: added to the square of the length, so that the direction of a line between points that coincide is no 0/0."""


@dataclass(frozen=True)
class Length:
    """The distance of two points, the gap of a line that implicit steps take at their end."""


@dataclass(frozen=True)
class SpringLine(Interaction):
    """A spring with a damper between two points."""

    KIND = "line"
    WORDS = "springs and dampers along lines"
    QUANTITIES: ClassVar = {
        "length": ReportedQuantity("m", "distance of the ends"),
        "pull": ReportedQuantity("N", "force that pulls the ends together"),
    }
    INPUTS: ClassVar = {
        "paid_out": ForceInput("m", "line that the winch has paid out, beyond the rest length", "s_w", adds_to="rest"),
        "speed": ForceInput("m/s", "rate at which the winch pays out", r"\dot{s}_w"),
    }
    STATES: ClassVar = {"relaxed": ForceState("m", "stretch of the spring that relaxes", "z_r", 1e-2)}

    stiffness: float = number("N/m", "stiffness of the line", r"k_\ell", sign="positive", least=1e-9, most=1e18)
    rest: float | None = number(
        "m", "length at which it is relaxed", r"\ell_0", default=None, sign="non-negative", least=1e-9, most=1e6
    )
    damping: float | None = number(
        "N·s/m", "damping along the line", r"c_\ell", default=None, sign="non-negative", least=1e-12, most=1e18
    )
    relaxation: float | None = number(
        *("N/m", "stiffness of the spring that relaxes, beside the other", "k_r"),
        default=None,
        sign="positive",
        least=1e-9,
        most=1e18,
    )
    relaxation_time: float | None = number(
        *("s", "time constant of its relaxation", r"T_r"), default=None, sign="positive", least=1e-9, most=1e9
    )
    slack: bool = choice("whether it hangs slack where it is shorter than its rest length, as a rope")
    winch: bool = choice("whether a winch changes its rest length, by two inputs: the line paid out and its rate")
    implicit: bool = choice("whether implicit steps take it at their end, as a stiff one needs")

    @property
    def shape(self) -> InteractionClass:
        own = super().shape
        return replace(own, structure=((ROWS, (Length(),)),)) if self.implicit else own

    @staticmethod
    def has_states(has: Collection[str]) -> bool:
        return "relaxation" in has

    @staticmethod
    def has_inputs(has: Collection[str]) -> bool:
        return "winch" in has

    @property
    def fault(self) -> tuple[str, str] | None:
        if self.winch and self.rest is None:
            return "winch", "is stated without rest, the length without any line paid out; state that, or leave it out"
        if (self.relaxation is None) != (self.relaxation_time is None):
            other = "relaxation_time" if self.relaxation_time is None else "relaxation"
            return other, "is missing beside the other of relaxation, N/m, and relaxation_time, s; state both or none"
        if self.winch and self.relaxation is not None:
            return "winch", "is stated beside relaxation; a line that relaxes has no winch yet; leave one of them out"
        if self.implicit and self.relaxation is not None:
            return "implicit", "is stated beside relaxation; a line that relaxes is not taken so; leave one of them out"
        return None

    @staticmethod
    def soft_row(row: Any, **keys: Any) -> SoftRow:
        return SoftRow(*(keys[name] for name in ("stiffness", "damping", "rest", "speed", "slack")))

    @staticmethod
    def wrench(t: Any, x: Relative, **keys: Any) -> WrenchOnSecond:
        length, pull = _pulled(t, x, keys)
        share = t.named("pull_over_length", pull / length)
        return WrenchOnSecond((0.0, 0.0, 0.0), tuple(-(share * y) for y in x.d))

    @staticmethod
    def power(t: Any, x: Relative, **keys: Any) -> Mapping[str, Value]:
        return {"paid_out": 0.0, "speed": -(_pulled(t, x, keys)[1] * keys["speed"])}

    @staticmethod
    def energy(t: Any, x: Relative, **keys: Any) -> Value:
        stretch = _length(t, x) - keys["rest"]
        stored = 0.5 * keys["stiffness"] * (stretch * stretch)
        relaxing = 0.5 * keys["relaxation"] * (keys["relaxed"] * keys["relaxed"])
        return (t.call("on", stretch) * stored if keys["slack"] else stored) + relaxing

    @staticmethod
    def rates(t: Any, x: Relative, **keys: Any) -> Mapping[str, StateRate]:
        length = _length(t, x)
        rate = dot(x.d, x.v) / length
        stretching = t.call("on", length - keys["rest"]) * rate if keys["slack"] else rate
        return {"relaxed": StateRate(stretching, 1.0 / keys["relaxation_time"])}

    @staticmethod
    def equations(has: Collection[str]) -> tuple[LawEquation, ...]:
        rest, speed = (r"\ell_0 - s_w", r"(\dot{\ell} - \dot{s}_w)") if "winch" in has else (r"\ell_0", r"\dot{\ell}")
        stretch = rf"(\ell - {rest})" if "rest" in has else r"\ell"
        pull = rf"k_\ell\,{stretch}" + rf" + c_\ell\,{speed}" * ("damping" in has)
        pull += r" + k_r\,z_r" * ("relaxation" in has)
        relaxing = r" + \tfrac{1}{2}\,k_r\,z_r^2" * ("relaxation" in has)
        taut = rf"\mathrm{{H}}(\ell - {rest})\," * ("rest" in has)
        pull, taut = (rf"{taut}\max\left( 0,\ {pull} \right)", taut) if "slack" in has else (pull, "")
        rate = LawEquation(r"\dot{\ell}", r"\frac{\mathbf{d}_{AB}^{\top}\,\mathbf{v}_{AB}}{\ell}", "m/s", "its rate")
        return (
            LawEquation.smallest(SHORTEST, "m^2", "the direction of a line without length"),
            LawEquation(
                r"\ell", r"\sqrt{\mathbf{d}_{AB}^{\top}\,\mathbf{d}_{AB} + \varepsilon}", "m", "length of the line"
            ),
            *[rate] * ("damping" in has or "relaxation" in has),
            LawEquation("T", pull, "N", "pull of the line"),
            LawEquation(FORCE, r"-\frac{T}{\ell}\,\mathbf{d}_{AB}"),
            LawEquation(POTENTIAL, rf"\tfrac{{1}}{{2}}\,k_\ell\,{taut}{stretch}^2" + relaxing),
            *[LawEquation(r"\dot{z}_r", rf"{taut}\dot{{\ell}} - \frac{{1}}{{T_r}}\,z_r", "m/s", "rate of $z_r$")]
            * ("relaxation" in has),
        )

    @staticmethod
    def drawn(has: Collection[str]) -> str:
        if "winch" in has:  # its length at rest is known to who chooses it, not to pictures
            return "line"
        return "rope" if "slack" in has else "spring"

    @staticmethod
    def outputs(t: Any, x: Relative, **keys: Any) -> Mapping[str, Value]:
        return dict(zip(("length", "pull"), _pulled(t, x, keys), strict=True))


def _pulled(t: Any, x: Relative, keys: Mapping[str, Any]) -> tuple[Value, Value]:
    """The length, and the force that pulls both ends together."""
    length = _length(t, x)
    rate = dot(x.d, x.v) / length - keys["speed"]
    stretch = length - keys["rest"]
    pull = keys["stiffness"] * stretch + keys["damping"] * rate + keys["relaxation"] * keys["relaxed"]
    return length, t.call("on", stretch) * t.call("on", pull) * pull if keys["slack"] else pull


def _length(t: Any, x: Relative) -> Value:
    return t.named("length", t.call("sqrt", dot(x.d, x.d) + SHORTEST))
