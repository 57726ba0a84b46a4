"""Warnings on robots that are legal but probably not what the user meant."""

from .robot import Robot

SINGLE = (
    "a single polynomial bends as a parabola: the bare link's first frequency comes out 27 % high, a tip force bends it"
    ' by a quarter too little; state 2 (or basis = "clamped_free" for the bare link\'s first mode)'
)


def advice(robot: Robot) -> list[str]:
    """One line per finding: the keys, the consequence, and the remedy."""
    single = [
        f"{link.name}.modes.{direction}"
        for link in robot.links
        for direction in ("bending_y", "bending_z")
        if getattr(link.modes, direction) == 1 == link.pieces and link.modes.basis_of(direction) == "polynomial"
    ]
    damped = [
        f"{link.name}.damping.ratio: is that of its {link.pieces} segments' own modes, so the first modes of the link"
        f" have about 1/{link.pieces**2} of it; state it so much larger where it is meant for them"
        for link in robot.links
        if link.damping and link.damping.ratio and link.pieces > 1
    ]
    return damped + ([f"{', '.join(single)}: is 1, and {SINGLE}"] if single else [])
