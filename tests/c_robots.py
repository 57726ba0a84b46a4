"""The robots whose generated C is analysed, all named "robot" so that the drivers in tests/c fit each of them."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import NamedTuple

from helpers import arm, example_dict, link, model_of, unfolded

from screwgen import Model
from screwgen.backends.c.project import CProject
from screwgen.integrators import METHODS

DRIVERS = Path(__file__).parent / "c"
SOFT = {"EA": 5e3, "EIy": 30.0, "EIz": 50.0, "GJ": 20.0}
BODY = {"mass": 1.0, "com": [0.1, 0.0, 0.02], "inertia": [0.01, 0.02, 0.02, 0.0, 0.0, 0.0]}


def strange() -> dict:
    """A welded mast that twists, a rigid hub on skew axes, a boom with two torsion modes, a plate welded to its tip."""
    return arm(
        link("mast", axes=[], modes={"bending_y": 1, "bending_z": 1, "torsion": 1}, section=SOFT, frame_at=0.4),
        link("hub", 0.1, axes=["z", [1, 2, 3]], bodies=[{"at": "tip"} | BODY]),
        link(
            "boom", axes="y", modes={"axial": 1, "torsion": 2, "bending_y": 2}, section=SOFT, joint={"damping": [0.1]}
        ),
        link("plate", 0.2, axes=[], bodies=[{"at": "base"} | BODY]),
    )


def small() -> dict:
    """A boom on skew axes that bends and twists, with a plate welded to its tip: little code of every sort."""
    joint = {"damping": [0.1, 0.1]}
    return arm(
        link("boom", 0.8, axes=["z", [1, 2, 3]], modes={"bending_y": 1, "torsion": 1}, section=SOFT, joint=joint),
        link("plate", 0.2, axes=[], bodies=[{"at": "base"} | BODY]),
    )


class Kind(NamedTuple):
    """One build of one robot's C."""

    robot: str
    layout: str
    real: str

    def __str__(self) -> str:
        return "-".join(self)

    @property
    def defines(self) -> list[str]:
        return ["-DROBOT_REAL_FLOAT"] if self.real == "float" else []


OWN = {"strange": strange, "small": small}
ROBOTS = ("ella", "six_link", "strange")
ALL = tuple(Kind(r, layout, real) for r in ROBOTS for layout in ("fused", "modular") for real in ("double", "float"))
FEW = (Kind("small", "fused", "double"), Kind("small", "modular", "float"))
EACH_METHOD = "-DEACH_METHOD(X)=" + " ".join(f"X({m})" for m in METHODS)
"""The integrators for a driver's tables."""


@cache
def robot_model(name: str) -> Model:
    return model_of((OWN[name]() if name in OWN else example_dict(name)) | {"name": "robot"})


@cache
def _texts(name: str, layout: str, whole: bool) -> dict[str, str]:
    model = robot_model(name)
    return CProject(model.chain, model.version, "runtime", layout, batch=whole, derivatives=whole).files()


def write_robot(kind: Kind, folder: Path, whole=True) -> list[str]:
    """The generated files of a robot in a folder; returns the names of the library's sources.

    ``whole``: with derivatives and batch.
    """
    return unfolded(folder, _texts(kind.robot, kind.layout, whole))
