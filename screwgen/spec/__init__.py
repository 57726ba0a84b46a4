"""Robots as validated descriptions: classes, files, parameters."""

from screwgen.spec.equivalent import equivalent_stiffness
from screwgen.spec.frequencies import Frequencies
from screwgen.spec.load import dump, load
from screwgen.spec.parameters import Parameter, coordinate_names, parameters
from screwgen.spec.robot import DIRECTIONS, Body, Damping, Joint, Link, Modes, Mount, Robot, Section

__all__ = [
    "DIRECTIONS",
    "Body",
    "Damping",
    "Frequencies",
    "Joint",
    "Link",
    "Modes",
    "Mount",
    "Parameter",
    "Robot",
    "Section",
    "coordinate_names",
    "dump",
    "equivalent_stiffness",
    "load",
    "parameters",
]
