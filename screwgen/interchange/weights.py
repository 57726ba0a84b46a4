"""Masses of links whose inertial a URDF leaves out: their shapes, filled with one density."""

from __future__ import annotations

import os
from math import pi
from typing import Any

import numpy as np

from ..errors import UsageError, one_line
from ..spec.ranges import within
from .flexible import SideFile
from .geometry import dimensions, meshes_of, placed_shape
from .markup import Element
from .rigid import Inertial, possible, together
from .urdf import Urdf, UrdfLink

WEIGHED = ("bodies", "section", "profile", "body")
"""Keys of a side file that say what a link weighs."""


def weigh(
    urdf: Urdf, side: SideFile, path: str | os.PathLike[str], density: float | None, total_mass: float | None
) -> None:
    """Give each link without an inertial the mass and inertia of its shapes, in place; notes say what it weighs.

    A link's shapes are its collisions, or where it has none its visuals; each counts whole, also where two overlap.
    `density`, kg/m³; or `total_mass`, kg, of all links of the URDF, with those that state an inertial. A link that the
    side file gives a mass gets none here. Raises RobotFileError where a shape cannot be read, and UsageError.
    """
    if density is None and total_mass is None:
        return
    if density is not None and total_mass is not None:
        raise UsageError("density: is stated beside total-mass; either gives the masses, leave one of them out")
    wanted = _checked("density", density) if density is not None else _checked("mass", total_mass)
    bare = [x for x in urdf.links.values() if not ((x.body and x.body.something) or _states_mass(side, x.name))]
    filled = {x.name: body for x in bare if (body := _filled(x, os.fsdecode(path))) is not None}
    if not filled:
        what = "has no link that lacks an inertial and has a shape"
        raise urdf.element.fault(f"{what}; leave --density and --total-mass out")
    if density is None:
        stated = sum(x.body.mass for x in urdf.links.values() if x.body is not None)
        if wanted <= stated:
            raise UsageError(f"total-mass: is {wanted:g}; the links that state an inertial weigh {stated:g} kg alone")
        wanted = (wanted - stated) / sum(body.mass for body in filled.values())
    for name, body in filled.items():
        urdf.links[name].body = Inertial(wanted * body.mass, body.com, wanted * body.tensor)
    weights = ", ".join(f"{name} {wanted * body.mass:.4g}" for name, body in filled.items())
    urdf.notes.append(f"masses from shapes of {wanted:.4g} kg/m³, kg: {weights}")
    if empty := [x.name for x in bare if x.name not in filled]:
        urdf.notes.append(f"without shape and mass: {', '.join(empty)}")


def _checked(quantity: str, value: Any) -> float:
    try:
        return within(quantity)(value)
    except ValueError as error:
        raise UsageError(f"{'total-mass' if quantity == 'mass' else quantity}: {error}") from None


def _states_mass(side: SideFile, link: str) -> bool:
    return not side.links.get(link, {}).keys().isdisjoint(WEIGHED)


def _filled(link: UrdfLink, file: str) -> Inertial | None:
    """The shapes of a link, with a density of 1 kg/m³; None where it has none."""
    parts = [
        body.seen(at)
        for element in link.element.all("collision") or link.element.all("visual")
        for at, shape in [placed_shape(element)]
        for body in _solid(shape, file)
    ]
    return together(parts) if parts else None


def _solid(shape: Element, file: str) -> list[Inertial]:
    """A shape of 1 kg/m³ about its own origin."""
    if shape.tag == "mesh":
        try:
            return [_closed(mesh) for mesh in meshes_of(shape, file, "state the link's bodies in a side file")]
        except ValueError as error:  # also of a flat mesh, which has no hull
            raise shape.fault(one_line(str(error).partition("\n")[0])) from None
    given = dimensions(shape)
    if shape.tag == "box":
        return [box(*given["size"])]
    (r,) = given["radius"]
    return [sphere(r) if shape.tag == "sphere" else cylinder(r, *given["length"])]


def box(x: float, y: float, z: float) -> Inertial:
    """A box of 1 kg/m³."""
    return _solid_of(x * y * z, ((y * y + z * z) / 12, (z * z + x * x) / 12, (x * x + y * y) / 12))


def sphere(r: float) -> Inertial:
    """A sphere of 1 kg/m³."""
    return _solid_of(4 / 3 * pi * r**3, (0.4 * r * r,) * 3)


def cylinder(r: float, length: float) -> Inertial:
    """A cylinder of 1 kg/m³ along z."""
    across = r * r / 4 + length**2 / 12
    return _solid_of(pi * r * r * length, (across, across, r * r / 2))


def _solid_of(mass: float, moments: tuple[float, float, float]) -> Inertial:
    """A body about its centre, with the moments of 1 kg of it."""
    return Inertial(mass, np.zeros(3), mass * np.diag(moments))


def _closed(mesh: Any) -> Inertial:
    """The body of 1 kg/m³ inside a surface of triangles; inside its convex hull where the surface is open."""
    inside = _enclosed(mesh) if mesh.is_watertight and mesh.volume else None
    return inside if inside is not None and possible(inside) else _enclosed(mesh.convex_hull)


def _enclosed(mesh: Any) -> Inertial:
    found, sign = mesh.mass_properties, np.sign(mesh.volume)  # a surface that is inside out encloses less than nothing
    return Inertial(float(sign * found.volume), np.array(found.center_mass), sign * np.array(found.inertia))
