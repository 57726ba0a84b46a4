"""The cross-section of a link, given either by line properties or by material and geometry."""

from typing import Annotated, Any, ClassVar

from pydantic import model_validator

from .part import Part
from .ranges import within
from .stated import Stated
from .values import quoted, refuse

PRODUCTS = {  # line property: the two keys of the material spelling whose product it is
    "rhoA": ("density", "area"),
    "EA": ("E", "area"),
    "EIy": ("E", "Iy"),
    "EIz": ("E", "Iz"),
    "GJ": ("G", "J"),
}
SPIN = ("density", "Iy", "Iz")  # rhoIp = density (Iy + Iz), where it is not stated
TURNING = "; that of sections which turn with bending in {}"
MATERIAL = ("density", "area", "E", "Iy", "Iz", "G", "J")  # the keys of the material spelling


class LineProperties(Part):
    """Line properties of one cross-section; y and z are its principal axes. None: structurally zero.

    Also accepted: `density` (kg/m³), `area` (m²), `E` and `G` (Pa), `Iy`, `Iz` and `J` (m⁴). They are turned
    into line properties at once, so that both spellings give equal sections. What is said in both is refused.
    """

    other_keys: ClassVar = {
        "density": "density, kg/m³; with area it gives rhoA, with Iy and Iz also rhoIp",
        "area": "area of the section, m²",
        "E": "Young's modulus, Pa; with area it gives EA, with Iy EIy, with Iz EIz",
        "Iy": "second moment of area about y, m⁴",
        "Iz": "second moment of area about z, m⁴",
        "G": "shear modulus, Pa; with J it gives GJ",
        "J": "torsion constant, m⁴",
    }

    rhoA: Annotated[float, Stated("rhoA", "mass per length", " (or density and area)")]
    EA: Annotated[float, Stated("EA", "axial stiffness")] | None = None
    EIy: Annotated[float, Stated("EIy", "bending stiffness about y", ", for modes in z")] | None = None
    EIz: Annotated[float, Stated("EIz", "bending stiffness about z", ", for modes in y")] | None = None
    GJ: Annotated[float, Stated("GJ", "torsional stiffness")] | None = None
    rhoIp: Annotated[float, Stated("rhoIp", "spin inertia per length about the centreline")] | None = None
    GAy: Annotated[float, Stated("GAy", "shear stiffness along y", ", κGA, for modes of shear in y")] | None = None
    GAz: Annotated[float, Stated("GAz", "shear stiffness along z", ", κGA, for modes of shear in z")] | None = None
    rhoIy: Annotated[float, Stated("rhoIy", "rotary inertia per length about y", TURNING.format("z"))] | None = None
    rhoIz: Annotated[float, Stated("rhoIz", "rotary inertia per length about z", TURNING.format("y"))] | None = None

    @model_validator(mode="before")
    @classmethod
    def _line_properties(cls, data: Any) -> Any:
        if not isinstance(data, dict):
            return data
        stated = {key: value for key, value in data.items() if value is not None}
        material = {key: within(key)(stated.pop(key), at=(key,)) for key in MATERIAL if key in stated}
        if set(stated) <= set(cls.model_fields):  # an unknown key is reported before what it leads to
            refuse_idle(material)
        return stated | from_material(material, stated)


class Section(LineProperties):
    """The section of a uniform rod; see `LineProperties`."""

    places: ClassVar[tuple[float, ...]] = ()
    between: ClassVar = "linear"

    def states(self, name: str) -> bool:
        """Whether a line property is stated."""
        return getattr(self, name) is not None

    def least(self, name: str) -> float | None:
        """The smallest value of a line property along the rod; None where it is not stated."""
        return getattr(self, name)


def from_material(material: dict[str, float], stated: dict[str, Any]) -> dict[str, float]:
    """The line properties that `material` amounts to."""
    line = {}
    for name, factors in PRODUCTS.items():
        if complete(factors, material):
            refuse_twice(name, factors, stated)
            line[name] = material[factors[0]] * material[factors[1]]
    if complete(SPIN, material) and "rhoIp" not in stated:
        line["rhoIp"] = material["density"] * (material["Iy"] + material["Iz"])
    return line


def complete(factors: tuple[str, ...], material: dict[str, float]) -> bool:
    """Whether all the factors are stated."""
    return all(factor in material for factor in factors)


def refuse_twice(name: str, factors: tuple[str, str], stated: dict[str, Any]) -> None:
    """Refuse a line property that is stated beside the two factors that give it."""
    if name in stated:
        both = " and ".join(map(quoted, factors))
        raise refuse(f"is stated twice, here and by {both}; state it one way", at=(name,))


def refuse_idle(material: dict[str, float]) -> None:
    """Refuse a key of the material spelling that lacks the partner that would give it an effect."""
    used = {key for group in (*PRODUCTS.values(), SPIN) if complete(group, material) for key in group}
    for key in material:
        if key not in used:
            partners = [quoted(p) for pair in PRODUCTS.values() if key in pair for p in pair if p != key]
            raise refuse(f"has no effect alone; state {' or '.join(partners)} with it", at=(key,))
