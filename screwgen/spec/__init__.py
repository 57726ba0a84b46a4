"""Robots as validated descriptions: classes, files, parameters."""

from .drive import Drive, Friction
from .equivalent import equivalent_stiffness
from .four_bar import FourBar
from .frequencies import Frequencies
from .joint import Joint, Mount
from .limit import Limit
from .load import dump, load
from .modes import DIRECTIONS, Modes
from .parameters import Parameter, coordinate_names, parameters
from .rest import RestCurvature, RestStation, RestStations
from .robot import Body, Damping, Link, Robot
from .section import Section
from .stations import Station, Stations
from .transmission import Transmission

__all__ = [
    "DIRECTIONS",
    "Body",
    "Damping",
    "Drive",
    "FourBar",
    "Frequencies",
    "Friction",
    "Joint",
    "Limit",
    "Link",
    "Modes",
    "Mount",
    "Parameter",
    "RestCurvature",
    "RestStation",
    "RestStations",
    "Robot",
    "Section",
    "Station",
    "Stations",
    "Transmission",
    "coordinate_names",
    "dump",
    "equivalent_stiffness",
    "load",
    "parameters",
]
