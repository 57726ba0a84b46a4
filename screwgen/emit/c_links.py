"""The chain in C: one function per phase and class of links, and how each finds its arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from ..chain import algorithms as alg
from ..chain.chain import OUTWARD, Algorithm, Chain, trace
from ..chain.dae_functions import block_places
from ..derive.link_class import LinkClass
from ..lower.program import Program
from ..lower.replay import specialise
from .c_code import Writer

JOINT = {"q", "qdot", "tau", "qddot", "new_q"}
MODAL = {"eta", "etadot", "m_eta", "f_eta", "etaddot"}
STRIDE = {
    "w_ext": 6,
    "wrench": 6,
    "twist": 6,
    "alpha": 6,
    "Vdot": 6,
    "quaternion": 4,
    "new_twist": 6,
    "new_quaternion": 4,
    "new_position": 3,
}
WRITTEN = {"qdot": "new_qdot"}
READ = {"alpha": "given_alpha"}
MATRIX = set("joint_w joint_V V_w V_V V_eta eta_V eta_eta next_V next_eta V_next eta_next".split())
ROWS = {"joint_H": ("H", 0), "V_H": ("H", 6), "joint_W": ("W", 0), "V_W": ("W", 6)}


@dataclass(frozen=True)
class Run:
    """An algorithm that is a C function of its own, and the signals for which it is called."""

    algorithm: Algorithm
    comment: str
    results: frozenset[str]

    def wants(self, name: str, key: LinkClass) -> bool:
        """Whether a signal is a result or read by a phase; base and tip are two names of one node."""
        reads = {n for program in trace(key, self.algorithm) for n in program.inputs}
        short = name.partition(".")[2]
        return name in self.results or name in reads or f"base.{short}" in reads or f"tip.{short}" in reads


def _run(algorithm: Algorithm, comment: str, results: str) -> Run:
    return Run(algorithm, comment, frozenset(results.split()))


RUNS: dict[str, Run] = {
    "joint_dynamics": _run(
        (*alg.FORWARD, alg.POSES),
        "Joint form: accelerations, wrenches and poses by block elimination.",
        "qddot etaddot wrench tip.R tip.r",
    ),
    "dae_dynamics": _run(
        alg.DAE_FORWARD,
        "DAE form: rates of the twists, wrenches, joint rates, by the same elimination.",
        "qdot qddot etaddot wrench Vdot",
    ),
    "projection": _run(
        alg.PROJECTION,
        "The state of the DAE form taken back onto the joints.",
        "new_q new_quaternion new_position new_twist",
    ),
    "placement": _run(
        alg.PLACEMENT,
        "Poses and twists of the DAE form from coordinates and rates.",
        "new_quaternion new_position new_twist tip.R tip.r",
    ),
    "assembly": _run(alg.ASSEMBLY, "M_sys, H_sys and W_sys.", " ".join([*sorted(MATRIX), *ROWS, "eta_H", "eta_W"])),
}


@dataclass(frozen=True)
class Variant:
    """A class of links as the code distinguishes it: baked numbers and the last link's missing child count."""

    key: LinkClass
    name: str
    numbers: tuple[tuple[str, float], ...] = ()
    last: bool = False


@dataclass
class Function:
    """One C function: a phase of a class."""

    name: str
    comment: str
    signature: str
    lines: list[str]
    call: str
    program: Program


@dataclass
class Links:
    """All functions of the chain for a robot."""

    chain: Chain
    prefix: str
    baked: Sequence[dict] | None
    joint_form: bool
    functions: dict[tuple, Function] = field(default_factory=dict)
    names: set[str] = field(default_factory=set)

    @property
    def runs(self) -> dict[str, Run]:
        return {n: r for n, r in RUNS.items() if self.joint_form or n != "joint_dynamics"}

    def variant(self, i: int, last_matters: bool) -> Variant:
        key = self.chain.keys[i]
        numbers = ()
        if self.baked is not None:
            numbers = tuple(sorted((n, v[0]) for n, v in self.baked[i].items() if n.startswith("c.")))
        last = last_matters and i == self.chain.n - 1
        return Variant(key, self._first_name(key, numbers), numbers, last)

    def _first_name(self, key: LinkClass, numbers: tuple) -> str:
        """A class is called after its first link."""
        for i, other in enumerate(self.chain.keys):
            same = self.baked is None or numbers == tuple(
                sorted((n, v[0]) for n, v in self.baked[i].items() if n.startswith("c."))
            )
            if other == key and same:
                return self.chain.robot.links[i].name
        raise KeyError(key)

    def program(self, variant: Variant, run: str, number: int) -> Program:
        """The program of a phase: specialised to the variant, without outputs that nobody asks for."""
        program = trace(variant.key, self.runs[run].algorithm)[number]
        known = {n: [v] for n, v in variant.numbers if n in program.inputs}
        if variant.last and "tip.X" in program.inputs:
            known |= {"tip.X": [0.0] * 36, "tip.PX": [0.0] * 36}
        if known:
            program = specialise(program, known)
        wanted = {
            n: v
            for n, v in program.outputs.items()
            if self.runs[run].wants(n, variant.key) and not (variant.last and "next" in n)
        }
        used = Program(program.name, program.inputs, wanted, program.guards, program.sections, program.origins)
        read = {n.args[0] for n in used.nodes if n.op == "input"}
        used.inputs = {n: size for n, size in program.inputs.items() if n in read}
        return used

    def phases(self, run: str) -> list[dict]:
        """The phases of a run, each with its classes and the class of every link."""
        out = []
        for number, phase in enumerate(self.runs[run].algorithm):
            variants = [self.variant(i, run == "assembly") for i in range(self.chain.n)]
            distinct = list(dict.fromkeys(variants))
            classes = [self.function(v, run, number, phase.name) for v in distinct]
            out.append(
                {
                    "name": f"{run}_{phase.name}",
                    "outward": phase.direction == OUTWARD,
                    "classes": classes,
                    "of_link": [distinct.index(v) for v in variants],
                }
            )
        return out

    def function(self, variant: Variant, run: str, number: int, phase: str) -> Function:
        """The C function of a phase; equal texts are one function."""
        program = self.program(variant, run, number)
        places = Places(self, variant, run, program)
        fail = lambda test, _: f"if ({test}) {{ return {self.prefix.upper()}_SINGULAR; }}"  # noqa: E731
        lines = Writer(program, self.prefix, places.place, fail, places.names()).lines()
        arguments, values = places.arguments()
        signature = _wrapped(arguments)
        key = (phase, signature, tuple(lines))
        if key not in self.functions:
            name = self._unique(f"{phase}_{variant.name}{'_last' if variant.last else ''}")
            title = f"{phase.replace('_', ' ')}, links like {variant.name}: {program.operation_count} operations"
            self.functions[key] = Function(name, title, signature, lines, f"{name}({', '.join(values)})", program)
        return self.functions[key]

    def _unique(self, name: str) -> str:
        number, out = 1, name
        while out in self.names:
            number += 1
            out = f"{name}_{number}"
        self.names.add(out)
        return out


def _wrapped(arguments: list[str], width: int = 100) -> str:
    """A parameter list over several lines."""
    lines, line = [], ""
    for argument in arguments or ["void"]:
        if line and len(line) + len(argument) > width:
            lines.append(line)
            line = ""
        line += f"{', ' if line else ''}{argument}"
    return ",\n    ".join([*lines, line])


@dataclass
class Places:
    """How a phase's function addresses its signals, and the arguments that this needs."""

    links: Links
    variant: Variant
    run: str
    program: Program
    matrix: dict[tuple[str, int], int] = field(init=False)

    def __post_init__(self):
        entries = matrix_entries(self.links, self.variant) if self.run == "assembly" else []
        self.matrix = {place: k for k, place in enumerate(entries)}

    def place(self, name: str, k: int) -> str | None:
        """The C expression of entry k of a signal; None for what is not kept."""
        where, _, what = name.partition(".")
        if where == "c" and what:
            return f"c->{what}"
        if where in ("base", "tip", "w"):
            return f"{'link' if where == 'w' else where}->{what}[{k}]"
        if name in MATRIX:
            return f"M[place[{self.matrix[name, k]}]]" if (name, k) in self.matrix else None
        if name in ROWS:
            array, offset = ROWS[name]
            return f"{array}[{offset + k}]"
        if name in ("eta_H", "eta_W"):
            return f"{name}[{k}]"
        return f"{name}[{k}]"

    def names(self) -> set[str]:
        """The names that the function's parameters and file take."""
        signals = {n for n in (*self.program.inputs, *self.program.outputs) if "." not in n}
        return signals | {"c", "link", "base", "tip", "place", "M", "H", "W", "M_PLACE", "M_OFFSET", "Q_OFFSET"}

    def arguments(self) -> tuple[list[str], list[str]]:
        """Parameters of the function and what a call passes for them."""
        real, out = f"{self.links.prefix}_real", []
        reads = [n for n, size in self.program.inputs.items() if size]
        writes = [n for n, v in self.program.outputs.items() if v]
        out += self._structs(reads, writes)
        for name in reads:
            if "." not in name:
                out.append(
                    (f"const {real} {name}[{self.program.inputs[name]}]", self._address(READ.get(name, name), name))
                )
        for name in writes:
            if "." not in name and name not in MATRIX and name not in ROWS:
                size = len(self.program.outputs[name])
                out.append((f"{real} {name}[{size}]", self._address(WRITTEN.get(name, name), name)))
        out += self._assembly(writes, real)
        return [a for a, _ in out], [b for _, b in out]

    def _structs(self, reads: list[str], writes: list[str]) -> list[tuple[str, str]]:
        prefix, out = self.links.prefix, []
        if any(n.startswith("c.") for n in reads):
            out.append((f"const {prefix}_link_constants *c", "&c->links[i]"))
        for where, type_, value in (
            ("w", "link_store", "&chain->links[i]"),
            ("base", "node", "&chain->nodes[i]"),
            ("tip", "node", "&chain->nodes[i + 1]"),
        ):
            if any(n.startswith(f"{where}.") for n in reads + writes):
                const = "" if any(n.startswith(f"{where}.") for n in writes) else "const "
                out.append((f"{const}{prefix}_{type_} *{'link' if where == 'w' else where}", value))
        return out

    def _address(self, member: str, name: str) -> str:
        if name in JOINT:
            return f"call->{member} + q"
        if name in MODAL:
            return f"call->{member} + e"
        if name in ("eta_H", "eta_W"):
            return f"call->{name[-1]} + {12 * self.links.chain.n} + e"
        return f"call->{member} + {STRIDE[name]} * i" if name in STRIDE else f"call->{member}"

    def _assembly(self, writes: list[str], real: str) -> list[tuple[str, str]]:
        out = []
        if any(n in MATRIX for n in writes):
            out += [("const int *place", "M_PLACE + M_OFFSET[i]"), (f"{real} *M", "call->M")]
        if any(n in ROWS for n in writes):
            out += [(f"{real} H[12]", "call->H + 12 * i"), (f"{real} W[12]", "call->W + 12 * i")]
        return out


def matrix_entries(links: Links, variant: Variant) -> list[tuple[str, int]]:
    """The structural nonzeros of M_sys that a link contributes, in the order of its programs."""
    entries = []
    for number in range(len(alg.ASSEMBLY)):
        for name, values in links.program(variant, "assembly", number).outputs.items():
            if name in MATRIX:
                entries += [(name, k) for k, v in enumerate(values) if not (isinstance(v, float) and v == 0.0)]
    return entries


def sparsity(links: Links) -> tuple[list[int], list[int], list[int], list[int]]:
    """Row indices and column starts of M_sys by columns, and where each link's entries go: places and offsets."""
    entries: list[tuple[int, int]] = []
    offsets = []
    for i in range(links.chain.n):
        offsets.append(len(entries))
        blocks = block_places(links.chain, i)
        for name, k in matrix_entries(links, links.variant(i, True)):
            row, col, _, cols = blocks[name]
            entries.append((col + k % cols, row + k // cols))
    order = sorted(entries)
    place = {entry: k for k, entry in enumerate(order)}
    size = 12 * links.chain.n + links.chain.n_modes
    starts = [sum(col < j for col, _ in order) for j in range(size + 1)]
    return [row for _, row in order], starts, [place[e] for e in entries], offsets
