"""Shapes of cross-sections: tubes, rods and boxes of one material, uniform or tapered, as line properties."""

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from typing import Annotated, Any, Self

from pydantic import Field, PlainValidator, model_validator
from pydantic_core import PydanticCustomError

from ..bases.weighted import POLYNOMIAL
from .part import Part
from .ranges import RANGES, within
from .section import Section
from .stations import Station, Stations, checked
from .values import array, refuse, shown

PLACES = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Stations of a tapered profile: the areas are quadratic in s, the second moments of area quartic."""


def dimension(value: Any) -> tuple[float, float]:
    """A dimension at base and tip: one number, or two."""
    if not isinstance(value, list | tuple):
        both = within("dimension")(value)
        return both, both
    ends = array(value, "a number, or two: at the base and at the tip")
    if len(ends) != 2:
        raise refuse(f"is {shown(value)}; it must be a number, or two: at the base and at the tip")
    base, tip = (within("dimension")(end, at=(k,)) for k, end in enumerate(ends))
    return base, tip


Dimension = Annotated[tuple[float, float], PlainValidator(dimension)]


class Shape(Part, ABC):
    """A cross-section whose dimensions are linear in s; y and z are its axes of symmetry."""

    def at(self, s: float) -> dict[str, float]:
        """The dimensions (m) at s."""
        ends = ((name, getattr(self, name)) for name in type(self).model_fields)
        return {name: (1 - s) * both[0] + s * both[1] for name, both in ends if both is not None}

    @property
    def tapered(self) -> bool:
        """Whether a dimension differs from base to tip."""
        return self.at(0.0) != self.at(1.0)

    @abstractmethod
    def moments(self, s: float) -> tuple[float, float, float, float]:
        """Area (m²), second moments of area about y and z, and torsion constant (m⁴) at s."""

    @abstractmethod
    def shear(self, s: float, nu: float) -> tuple[float, float]:
        """Cowper's shear coefficients κ along y and z at s, for Poisson's ratio `nu`."""


class Rod(Shape):
    """A solid round bar."""

    diameter: Dimension = Field(description="the diameter, m; or [at the base, at the tip]")

    def moments(self, s: float) -> tuple[float, float, float, float]:
        return ring(self.at(s)["diameter"], 0.0)

    def shear(self, s: float, nu: float) -> tuple[float, float]:
        return (ring_shear(0.0, nu),) * 2


class Tube(Shape):
    """A round tube."""

    outer: Dimension = Field(description="the outer diameter, m; or [at the base, at the tip]")
    wall: Dimension = Field(description="the thickness of the wall, m; or [at the base, at the tip]")

    def moments(self, s: float) -> tuple[float, float, float, float]:
        d = self.at(s)
        return ring(d["outer"], d["outer"] - 2 * d["wall"])

    def shear(self, s: float, nu: float) -> tuple[float, float]:
        d = self.at(s)
        return (ring_shear(1 - 2 * d["wall"] / d["outer"], nu),) * 2

    @model_validator(mode="after")
    def _hollow(self) -> Self:
        refuse_thick(self.wall, self.outer, "outer diameter")
        return self


class Box(Shape):
    """A rectangle, `height` along z and `breadth` along y; with a `wall` it is hollow."""

    height: Dimension = Field(description="the size along z, m; or [at the base, at the tip]")
    breadth: Dimension = Field(description="the size along y, m; or [at the base, at the tip]")
    wall: Dimension | None = Field(None, description="the thickness of the walls, m; without it the box is solid")

    def moments(self, s: float) -> tuple[float, float, float, float]:
        d = self.at(s)
        h, b, t = d["height"], d["breadth"], d.get("wall")
        if t is None:
            return b * h, b * h**3 / 12, h * b**3 / 12, solid_torsion(max(h, b), min(h, b))
        x, y = h - 2 * t, b - 2 * t
        bredt = 2 * t * ((h - t) * (b - t)) ** 2 / (h + b - 2 * t)
        return b * h - x * y, (b * h**3 - y * x**3) / 12, (h * b**3 - x * y**3) / 12, bredt

    def shear(self, s: float, nu: float) -> tuple[float, float]:
        d = self.at(s)
        if (t := d.get("wall")) is None:
            return (10 * (1 + nu) / (12 + 11 * nu),) * 2
        h, b = d["height"] - t, d["breadth"] - t
        return box_shear(h / b, nu), box_shear(b / h, nu)

    @model_validator(mode="after")
    def _hollow(self) -> Self:
        if self.wall is not None:
            for name in ("height", "breadth"):
                refuse_thick(self.wall, getattr(self, name), name)
        return self


def refuse_thick(wall: Sequence[float], size: Sequence[float], what: str) -> None:
    """Refuse walls that meet."""
    for k in range(2):
        if 2 * wall[k] >= size[k]:
            end = ("base", "tip")[k]
            raise refuse(
                f"is {wall[k]} at the {end}; it must be below half of the {what}, {size[k] / 2:g}", at=("wall",)
            )


def ring(outer: float, inner: float) -> tuple[float, float, float, float]:
    """The moments of a circular ring."""
    I = math.pi * (outer**4 - inner**4) / 64
    return math.pi * (outer**2 - inner**2) / 4, I, I, 2 * I


def ring_shear(m: float, nu: float) -> float:
    """Cowper's κ of a circular ring whose inner diameter is `m` of the outer one."""
    square = (1 + m * m) ** 2
    return 6 * (1 + nu) * square / ((7 + 6 * nu) * square + (20 + 12 * nu) * m * m)


def box_shear(m: float, nu: float) -> float:
    """Cowper's κ of a thin-walled box with equal walls, `m` times as wide across the force as along it."""
    own = 12 + 72 * m + 150 * m**2 + 90 * m**3 + nu * (11 + 66 * m + 135 * m**2 + 90 * m**3)
    return 10 * (1 + nu) * (1 + 3 * m) ** 2 / (own + 10 * m**2 * ((3 + nu) * m + 3 * m**2))


def solid_torsion(long: float, short: float) -> float:
    """The torsion constant of a solid rectangle, by Saint-Venant's series."""
    series = math.fsum(math.tanh(n * math.pi * long / (2 * short)) / n**5 for n in range(1, 60, 2))
    return long * short**3 * (1 / 3 - 64 / math.pi**5 * (short / long) * series)


SHAPES: dict[str, Callable] = {"tube": Tube, "rod": Rod, "box": Box}


class Profile(Part):
    """Shape and material of a link's cross-section: one of `tube`, `rod` and `box`; `E`, `density`, `nu` or `G`.

    It is turned into line properties at once: `rhoA`, `EA`, `EIy`, `EIz`, `rhoIp`, and `GJ` where `nu` or `G` is
    stated. For a link with modes of shear also `rhoIy`, `rhoIz` and, with Cowper's coefficients, `GAy` and `GAz`.
    Dimensions of two values taper linearly from base to tip. The properties of a tapered shape are polynomials of s up
    to the fourth degree, so five stations state them exactly; only the torsion constant of a box and the shear
    stiffness of tubes and hollow boxes are quotients, which the polynomial through their five values approximates.
    """

    tube: Tube | None = Field(None, description="a round tube, as { outer = 0.1, wall = 0.004 }")
    rod: Rod | None = Field(None, description="a solid round bar, as { diameter = 0.02 }")
    box: Box | None = Field(None, description="a rectangle, as { height = 0.1, breadth = 0.05, wall = 0.003 }")
    E: Annotated[float, PlainValidator(within("E"))] = Field(description="Young's modulus, Pa")
    density: Annotated[float, PlainValidator(within("density"))] = Field(description="density, kg/m³")
    nu: Annotated[float, PlainValidator(within("nu"))] | None = Field(
        None, description="Poisson's ratio; with it G = E / (2 (1 + nu))"
    )
    G: Annotated[float, PlainValidator(within("G"))] | None = Field(None, description="shear modulus, Pa")

    @property
    def shape(self) -> Shape:
        """The one that is stated."""
        return next(shape for name in SHAPES if (shape := getattr(self, name)) is not None)

    @model_validator(mode="after")
    def _one_shape(self) -> Self:
        stated = [name for name in SHAPES if getattr(self, name) is not None]
        if len(stated) != 1:
            raise refuse(f"states {' and '.join(stated) or 'no shape'}; state one of tube, rod and box")
        if self.nu is not None and self.G is not None:
            raise refuse("is stated beside nu; either gives the shear modulus, leave one of them out", at=("G",))
        return self

    def section(self, sheared: bool = False) -> Section | Stations:
        """The line properties, at five stations where the shape is tapered; `sheared`: with those of Timoshenko.

        Refuses a property that is out of its range, such as the inertia of a section of a few micrometres.
        """
        for s in PLACES if self.shape.tapered else PLACES[:1]:
            for name, value in self.line(s, sheared).items():
                _refuse_out_of_range(name, value)
        if not self.shape.tapered:
            return Section(**self.line(0.0, sheared))
        return Stations(stations=tuple(Station(at=s, **self.line(s, sheared)) for s in PLACES), between=POLYNOMIAL)

    def line(self, s: float, sheared: bool = False) -> dict[str, float]:
        """The line properties at s."""
        area, Iy, Iz, J = self.shape.moments(s)
        line = {"rhoA": self.density * area, "EA": self.E * area, "EIy": self.E * Iy, "EIz": self.E * Iz}
        G = self.E / (2 * (1 + self.nu)) if self.nu is not None else self.G
        line |= ({} if G is None else {"GJ": G * J}) | {"rhoIp": self.density * (Iy + Iz)}
        if sheared and G is not None:
            nu = self.E / (2 * G) - 1 if self.nu is None else self.nu
            line |= {f"GA{axis}": k * G * area for axis, k in zip("yz", self.shape.shear(s, nu), strict=True)}
        return line | ({"rhoIy": self.density * Iy, "rhoIz": self.density * Iz} if sheared else {})


def _refuse_out_of_range(name: str, value: float) -> None:
    try:
        within(name)(value)
    except ValueError:
        what = f"gives {name} = {value:.4g}, which is not {RANGES[name].text}"
        raise refuse(f"{what}; check the dimensions, or state the section by line properties, without {name}") from None


def profiled(data: Any) -> Any:
    """A link's table with the `section` that its `profile` amounts to."""
    if not (isinstance(data, dict) and "profile" in data):
        return data
    if data["profile"] is None:
        return {key: value for key, value in data.items() if key != "profile"}
    if data.get("section") is not None:
        raise refuse("is stated beside section; either gives the section, leave one of them out", at=("profile",))
    given, modes = data["profile"], data.get("modes")
    profile = given if isinstance(given, Profile) else checked(Profile, given, ("profile",))
    counts = modes if isinstance(modes, dict) else dict(modes) if isinstance(modes, Part) else {}
    try:
        section = profile.section(any(counts.get(name) for name in ("shear_y", "shear_z")))
    except PydanticCustomError as error:
        raise refuse(str(error), at=("profile",)) from None
    return {key: value for key, value in data.items() if key != "profile"} | {"section": section}
