"""screwgen: symbolic code generation for flexible robot arms.

One derivation in screw theory gives CasADi functions, standalone C and LaTeX. Names are imported when they are first
asked for, so that the command line's help and small scripts start quickly; `__init__.pyi` has them for type checkers.
"""

from importlib import import_module
from importlib.util import find_spec

from .version import __version__

HOMES = {
    "backends.numpy.closing": ("OpenLoopError",),
    "errors": ("RobotFileError", "ScrewgenError", "SingularError", "UsageError"),
    "interchange.load": ("ImportNote", "load"),
    "model": ("Model", "derive"),
    "simulation.control_loop": ("ControlLoopWarning",),
    "simulation.controllers": ("PD", "Holding"),
    "simulation.hits": ("Hit", "LimitWarning"),
    "simulation.integrate": ("DivergedError",),
    "simulation.loop_watch": ("LoopWarning", "OpenedError"),
    "simulation.rollout": ("Rollout", "rollout"),
    "simulation.runs": ("Run",),
    "simulation.simulate": ("simulate",),
    "simulation.sweep": ("Sweep", "sweep"),
    "simulation.validity": ("ModelLeftError", "ModelValidityWarning", "Validity"),
    "spec.frequencies": ("Frequencies",),
    "spec.load": ("dump",),
    "spec.drive": ("Drive", "Friction"),
    "spec.joint": ("Joint", "Mount"),
    "spec.four_bar": ("FourBar",),
    "spec.limit": ("Limit",),
    "spec.robot": ("Body", "Damping", "Link", "Modes", "Robot"),
    "joints.screw": ("Screw",),
    "spec.section": ("Section",),
    "spec.transmission": ("Transmission",),
    "studies.analysis": ("Analysis", "analyse"),
    "studies.assemble": ("assemble",),
    "studies.convergence": ("Convergence", "convergence"),
    "studies.equilibrium": ("Equilibrium", "NoEquilibriumError", "equilibrium"),
    "studies.linear": ("LinearModel",),
    "studies.modes": ("natural_frequencies",),
    "studies.standard_data": ("write_sid",),
    "viewer.frames": ("film",),
    "viewer.page": ("View",),
    "viewer.view": ("view",),
}
"""The public names by the module that defines them."""

__all__ = ["__version__", *(name for names in HOMES.values() for name in names)]


def __getattr__(name: str):
    """A public name, or a module of the package."""
    home = next((module for module, names in HOMES.items() if name in names), None)
    if home is not None:
        value = getattr(import_module(f"{__name__}.{home}"), name)
        globals()[name] = value
        return value
    if not name.startswith("_") and find_spec(f"{__name__}.{name}"):
        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'", name=name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
