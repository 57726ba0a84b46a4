"""The C back end: a folder of standalone C99 from a robot."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence
from functools import cached_property

from ...algorithms import functions, fused
from ...algorithms.dae_functions import state_size, unknown_size
from ...algorithms.measurement import Measurement
from ...algorithms.measurement_names import chosen
from ...algorithms.robot_functions import OUTPUTS, SENSORS, in_file
from ...algorithms.schedule import Algorithm, constant_labels, seen_by
from ...bodies.validity import BOUNDS
from ...errors import UsageError
from ...integrators.method import Method
from ...integrators.methods import with_built_in
from ...ir.program import Program
from ...spec.parameters import coordinate_names, coordinate_units, parameters
from ...topology.chain import Chain
from ..numpy.reference import Case
from ..templates import FEATURES
from . import batch, check, curved, derivatives, estimator, features, files, laws, levers, outputs, preparation, steps
from .by_p import algorithms as differentiated
from .by_p import asked as asked_by_p
from .by_p import content as by_parameters
from .check import Recorded
from .code import Writer, by_kind, literal, singular, sizes, with_unused
from .columns import rendered
from .fields import (
    StructMember,
    constant_fields,
    fused_place,
    given_coordinates,
    index_type,
    node_fields,
    rows,
    scratch,
    store_fields,
    structs,
    stumpff_terms,
    topology,
)
from .links import WATCHED, WITHIN, links_of, sparsity
from .parameters import bodies, changing_parameter, comments, defaults, limits, parameter_structs, place
from .runs import RUNS
from .written import once

PARTS = (OUTPUTS, SENSORS)
"""The files of functions that report something, with the option of that name."""

FUSED_BEST = 2600
"""Up to this many operations ``auto`` writes the joint form in one piece: at about 11 bytes each they stay in a
first-level cache of 32 KiB."""
SHARED = 0.75
"""Beyond FUSED_BEST it writes modular code if the distinct functions have less than this fraction of all operations."""
FUSED_MOST = 14_000
"""The largest function that is written: compilers need more than twice the time for twice the length."""

ASKED = {"wrench": "WRENCHES", "motion": "MOTION", "tip_rotation": "TIP_POSE", "tip_position": "TIP_POSE"}
"""Outputs of the forward dynamics that a caller may leave out, and the conditions that request them."""

ROUNDS = 4
"""Iterations of the modes' equilibrium in ``<robot>_gravity``."""

MASK_BITS = 32


class CProject:
    """The files of a robot's C, as a mapping from name to text."""

    further: tuple[Algorithm, ...] = ()
    """Algorithms beside those of the C itself for which its constants are prepared."""

    def __init__(
        self,
        chain: Chain,
        version: str,
        binding: str = "runtime",
        layout: str = "auto",
        batch: bool = False,
        derivatives: bool = False,
        estimator: bool | Sequence[str | Measurement] = False,
        methods: Sequence[Method] = (),
        outputs: bool | Collection[str] = False,
        by_p: str | Sequence[str] = (),
        estimate: str | Sequence[str] = (),
    ):
        self.chain, self.version, self.binding, self.with_batch = chain, version, binding, batch
        self.with_estimator = estimator is not False or bool(estimate)
        self.measurements = chosen(chain, self.with_estimator if isinstance(estimator, bool) else estimator)
        self.with_derivatives = derivatives or self.with_estimator
        self.reports = PARTS if outputs is True else tuple(outputs or ())
        self.name, self.methods = chain.robot.name, with_built_in(methods)
        self.by_p = asked_by_p(chain, by_p, estimate, self.measurements, binding == "baked")
        self.baked = once(fused.baked, chain) if binding == "baked" else None
        self.asked, self.layout = layout, self._layout(layout)
        self.links = once(links_of, chain, binding == "baked", self.layout == "modular")

    def _layout(self, asked: str) -> str:
        """``fused`` or ``modular``; ``auto`` chooses the faster one."""
        links = once(links_of, self.chain, self.binding == "baked", True)
        passages = links.passages("joint_dynamics", WATCHED)
        size = sizes(p.program for p in passages)
        if asked == "fused" and size > FUSED_MOST:
            said = f"robot '{self.name}': layout 'fused' would be one function of {size} operations"
            raise UsageError(f"{said}, and compilers take long over more than {FUSED_MOST}; choose 'modular' or 'auto'")
        if asked != "auto":
            return asked
        written = sizes({id(p.program): p.program for p in passages}.values())
        modular = size > FUSED_BEST and written < SHARED * size
        return "modular" if modular or size > FUSED_MOST else "fused"

    def files(self) -> dict[str, str]:
        """Every file of the folder."""
        sources = self.library | {file: file for file in files.BESIDE}
        return {file: self.text(template) for file, template in sources.items()}

    def text(self, template: str, **more: object) -> str:
        """The text of a file of the library; what sensors measure is derived where it is asked for."""
        return rendered(template, **self.context | (self.sensors if template.startswith(SENSORS) else {}), **more)

    @property
    def library(self) -> dict[str, str]:
        """The files of the library, with the templates that they are made from."""
        options = self.with_derivatives, self.with_estimator, self.with_batch, bool(self.by_p.chosen)
        return files.library(self.name, features.files(self.chain), options, self.reports)

    def shim(self, template: str, views: Sequence[str] = ()) -> str:
        """A source for callers in other languages, not part of the folder; ``views`` are the members that they see."""
        return rendered(template, **self.context, views=views)

    @cached_property
    def context(self) -> dict:
        """The templates' context."""
        chain, robot, baked, methods = self.chain, self.chain.robot, self.baked is not None, self.methods
        m_row, m_column, m_place, m_offset = sparsity(self.links)
        return {
            "name": self.name,
            "NAME": self.name.upper(),
            "version": self.version,
            "estimator": self.with_estimator
            and estimator.content(chain, self.measurements, baked, fused_place, self.by_p),
            "derivatives": self.with_derivatives
            and derivatives.content(chain, self.baked, fused_place, methods, self.asked),
            "sources": [file for file in self.library if file.endswith(".c")],
            "headers": [file for file in self.library if file.endswith(".h")],
            "layout": self.layout,
            "binding": self.binding,
            **{name: getattr(chain, name) for name in ("n", "n_modes", "nq", "nv", "n_tau")},
            **{name: getattr(chain, name) for name in ("slides", "sliding")},
            "axis_forces": chain.has_axis_forces,
            "rates_first": chain.needs_rates_first,
            **given_coordinates(chain),
            "acting": laws.content(chain),
            "spring": laws.spring,
            "springs": laws.springs,
            "nx": state_size(chain),
            "nz": unknown_size(chain),
            "nnz": len(m_row),
            **steps.content(self.methods),
            "rounds": ROUNDS,
            "example": changing_parameter(robot),
            "assumptions": chain.assumptions(),
            "link_names": [link.name for link in robot.links],
            "names": chain.names,
            "segments": chain.segments if chain.n > len(robot.links) else (),
            "parameter_links": "$$_NLINKS" if chain.n == len(robot.links) else "$$_NPARTS",
            "q_names": coordinate_names(robot).q,
            "units": coordinate_units(robot),
            "structs": structs(chain),
            "parameters": self.parameters,
            "measures": {name: literal(bound) for name, bound in BOUNDS.items()},
            **bodies(robot),
            "constants": self.constants,
            "node": node_fields(self._programs),
            "store": store_fields(self._programs, self.chain),
            "operations": self.operations,
            "bytes": self.bytes,
            "lines": self.fused_lines,
            "masked": self.masked,
            "check": self.check,
            "limits": limits(robot),
            "frequencies": [f for f in self.parameters["link"] if f.name.startswith(("frequencies_", "section_"))],
            "defaults": defaults(robot),
            "places": [place(p) for p in parameters(robot)],
            **(preparation.content(self.seen, self.labels) if self.baked is None else preparation.NONE),
            "baked": preparation.tables(chain, self.baked),
            **topology(chain),
            "q_offset": chain.q_offset[:-1],
            **curved.content(chain),
            "eta_offset": chain.eta_offset[:-1],
            "programs": list(self.links.functions.values()),
            "routines": self.links.routines.functions,
            "phases": self._phases,
            "algorithms": self._algorithms,
            "index": index_type(unknown_size(chain)),
            "m_row": rows(m_row),
            "m_column": rows(m_column),
            "m_place": rows(m_place),
            "m_offset": m_offset,
            "accelerating": any(a["accelerating"] for a in self._algorithms),
            "cases": self.reference,
            "sums": check.sums(chain, self._cases, self.methods.values()),
            "stumpff": {order: stumpff_terms(order) for order in (4, 5)},
            **self._features,
            FEATURES: self.by_p.features + self._features[FEATURES],
            "outputs": self._told(OUTPUTS) if OUTPUTS in self.reports else None,
            "sensing": [row.name for part in self.reports if part == SENSORS for row in in_file(part, chain)],
            "levers": once(levers.content, chain, baked, fused_place),
            "batch": self._batch if self.with_batch else None,
            "by_p": by_parameters(chain, self.by_p, fused_place, self.methods),
        }

    @cached_property
    def sensors(self) -> dict:
        """What the templates of sensors need besides."""
        return {"sensors": self._told(SENSORS), "sensor_names": outputs.sensor_names(self.chain)}

    def _told(self, part: str) -> dict:
        return once(outputs.content, self.chain, part, self.baked is not None, fused_place)

    # programs ---------------------------------------------------------------------------------

    @cached_property
    def _algorithms(self) -> list[dict]:
        """The C functions that run phases over the chain."""
        return [part for name in self.links.runs for part in self.links.parts(name)]

    @property
    def _phases(self) -> list[dict]:
        return [phase for a in self._algorithms for phase in a["phases"]]

    @property
    def _programs(self) -> list[Program]:
        return [c.program for phase in self._phases for c in phase["classes"]]

    @cached_property
    def fused(self) -> Program:
        """The joint form in one program."""
        return once(fused.complete_dynamics, self.chain, "baked" if self.baked is not None else "constants")

    @property
    def fused_lines(self) -> list[str]:
        return once(_fused_lines, self.chain, self.binding == "baked") if self.layout == "fused" else []

    @property
    def _batch(self) -> dict:
        constants = sum(f.reals() for f in self.constants)
        states = 2 + len(steps.registers(self.methods))
        return batch.content(self.chain, self.baked is not None, constants, states, fused_place)

    @property
    def masked(self) -> bool:
        """Whether one word has a bit for every link."""
        return self.chain.n <= MASK_BITS

    @cached_property
    def operations(self) -> dict[str, int]:
        """The number of operations of one call of the forward dynamics."""
        if self.layout == "fused":
            whole = self.fused
            asked = {name: values for name, values in whole.outputs.items() if name != "motion"}
            counts = Program(whole.name, whole.inputs, asked, whole.guards, whole.sections, whole.origins).operations
        else:
            counts = Counter()
            for passage in self.links.passages("joint_dynamics", WATCHED):
                counts += passage.program.operations
        return by_kind(counts)

    # parameters and constants -----------------------------------------------------------------

    @cached_property
    def labels(self) -> list[tuple[str, ...]]:
        """The constants that the code of every link reads."""
        return [constant_labels(self.chain, i, self._run) for i in range(self.chain.n)]

    @cached_property
    def _run(self) -> tuple[Algorithm, ...]:
        """The algorithms that the C runs."""
        told = (a for part in self.reports for row in in_file(part, self.chain) for a in row.algorithms)
        measured = (a for row in self.measurements for a in row.algorithms)
        more = (*told, *measured, functions.HOLD, *differentiated(self.chain, self.by_p), *self.further)
        return *(run.algorithm for run in RUNS.values()), *more

    @property
    def seen(self) -> Chain:
        """The chain whose constants are prepared."""
        return seen_by(self.chain, *self._run)

    @property
    def constants(self) -> list[StructMember]:
        if self.baked is not None:
            return []
        fields = constant_fields(self.seen, {x for labels in self.labels for x in labels}, comments(self.chain.robot))
        return fields or [StructMember("none", (), "no constant depends on parameters")]

    @cached_property
    def parameters(self) -> dict[str, list[StructMember]]:
        """The members of the parameters' structs."""
        names: list[set[str]] = [set() for _ in self.chain.robot.links]
        for segment, key, labels in zip(self.chain.segments, self.seen.keys, self.labels, strict=True):
            names[segment.link] |= {n[2:] for n in fused.preparation(key, labels).inputs}
        return parameter_structs(self.chain.robot, [frozenset(n) for n in names])

    @property
    def bytes(self) -> dict[str, int]:
        """The scratch in double precision."""
        parts = node_fields(self._programs), store_fields(self._programs, self.chain)
        states, modular = 1 + len(steps.registers(self.methods)), self.layout == "modular"
        return scratch(self.chain, *parts, states, modular, self._features["scratch"])

    @cached_property
    def _features(self) -> dict:
        return once(features.content, self.chain, self.baked is not None, fused_place)

    @cached_property
    def check(self) -> dict[str, object]:
        """The tolerances of the self-check, and the error of float if it is too large: see :mod:`.check`."""
        return check.content(self.chain, self._recorded)

    @cached_property
    def _recorded(self) -> Sequence[Recorded]:
        return check.recorded(self.chain)

    @property
    def _cases(self) -> list[Case]:
        return [state.case for state in self._recorded]

    @property
    def reference(self) -> list[dict[str, list[str]]]:
        """States with their results, computed with 40 digits: the same on every machine."""
        return [{name: [literal(x) for x in entries] for name, entries in case.items()} for case in self._cases]


def _fused_lines(chain: Chain, baked: bool) -> list[str]:
    """The body of the fused function. Failures of guards are collected: early returns cost more than comparisons."""
    program = once(fused.complete_dynamics, chain, "baked" if baked else "constants")
    collected = lambda test, link: f"bad |= (unsigned long)({test}) << {link};"  # noqa: E731
    fail = collected if chain.n <= MASK_BITS else singular
    taken = {"c", "state", "input", "m_eta", "work", "wanted", "output", "bad", "link"}
    asked = {name: f"wanted & $$_{part}" for name, part in ASKED.items()}
    within = {asked[name]: asked[outer] for name, outer in WITHIN.items()}
    lines = Writer(program, fused_place, fail, taken, True, asked, within).lines()
    own = ("gravity", fused.OF_FORCES)
    used = {name.partition(":")[2][:1] == "c" or name.startswith(own) for name in program.inputs}
    ignored = [] if True in used else ["(void)c;"]
    return ignored + with_unused(("state", "input", "work", "m_eta"), lines)
