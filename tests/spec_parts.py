"""Parts of robots built in Python, and a robot by way of a file."""

from screwgen.spec import Joint, Link, Robot, Section, dump, load

STIFFNESS_OF = {"axial": "EA", "bending_y": "EIz", "bending_z": "EIy", "torsion": "GJ"}


def link(**changed):
    """A rigid link on a z joint."""
    return Link(**({"name": "arm", "length": 1.0, "section": Section(rhoA=1.0), "joint": Joint(axes=["z"])} | changed))


def robot(*links, **changed):
    """A robot of the given links."""
    return Robot(**({"name": "bot", "gravity": (0, 0, -9.81), "links": links or [link()]} | changed))


def reloaded(robot, folder):
    """`robot` by way of a file."""
    path = folder / "robot.toml"
    path.write_text(dump(robot), encoding="utf-8")
    return load(path)
