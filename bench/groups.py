"""What is compared with what: the groups of the table, their rows and the bounds of their ratios."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

import lagrangian
import rigid
import robots
from contenders import (
    Contender,
    Library,
    Missing,
    accelerations,
    casadi_function,
    casadi_library,
    data_header,
    has_avx,
    ours,
    same_function,
    screwgen_library,
    theirs,
)

import screwgen
from screwgen.integrators import METHODS

PLAIN = ("-DBAKED", "-DPLAIN")
TIME_STEP = 1e-3
LINKS = (1, 2, 4, 8, 16, 32, 64)
FUSED_LINKS = 16
MODES = (1, 2, 4, 8, 16)
LAGRANGIAN = {2: (1, 3.0), 4: (0, 12.0), 6: (0, 20.0)}
"""Links: axial modes of each, and how many times slower the Lagrangian must be."""

RIGID = (8, 16, 32)
EXAMPLES = ("ella", "three_link", "six_link")
MORE = {
    "flexible2": partial(robots.flexible, "flexible2", 2, 1, 1),
    "flexible4": partial(robots.flexible, "flexible4", 4, 0, 1),
    "equal8": partial(robots.equal_chain, "equal8", 8),
    "rigid8": partial(robots.rigid, "rigid8", 8),
    "modes4": partial(robots.many_modes, "modes4", 4),
}
"""Robots of other groups that are compared with CasADi's C of the same function too."""


@dataclass
class Group:
    """Contenders that run in turns in one program. ``heading`` says what a ratio is; ``missing``: title and reason."""

    name: str
    heading: str
    contenders: list[Contender] = field(default_factory=list)
    data: dict[str, str] = field(default_factory=dict)
    missing: list[tuple[str, str]] = field(default_factory=list)

    def attempt(self, title: str, make: Callable[[], Contender]) -> None:
        """Add a contender that may be missing."""
        try:
            self.contenders.append(make())
        except Missing as reason:
            self.missing.append((title, str(reason)))


CONSTANTS = ("constants", "parameters", "baked")
"""Where CasADi has the constants from: they are inputs, it computes them from parameters at every call, numbers."""

FROM_PARAMETERS = "CasADi from parameters"
AVX = "CasADi, -mavx"
"""As screwgen's own C is compiled where the processor has it."""


def over(bound: float | None) -> tuple[float | None, float | None]:
    return bound, None


# -------------------------------------------------------------------------------------------- the groups


def lagrangians(links: int) -> Group:
    """Flexible arms with constants baked in against Lagrange's equations in CasADi."""
    axial, bound = LAGRANGIAN[links]
    model = screwgen.derive(robots.flexible(f"flexible{links}", links, axial, 1))
    r, first = model.robot.name, f"{model.robot.name}_auto"
    heading = f"{links} flexible links, modes ({axial},1,1), constants baked; ratio: time / the first row's"
    group = Group(f"lagrangian{links}", heading, data={r: data_header(model, loads=False)})
    runtime = screwgen_library(model, "auto", "runtime", f"{r}_runtime")
    group.contenders = [
        accelerations(model, screwgen_library(model, "auto", "baked", first), "baked", against=first),
        _lagrangian(model, "Lagrangian + ldl", f"lagrangian{links}", first, False, over(bound)),
        _lagrangian(model, "Lagrangian, tuned by hand", f"lagrangian{links}_tuned", first, True, over(None)),
        accelerations(model, runtime, "runtime", against=first),
    ]
    for layout in ("fused", "modular"):
        for single in (False, True):
            name = f"{r}_{layout}{'_float' * single}"
            title = f"screwgen {layout} with wrenches"
            group.attempt(title, partial(_variant, model, layout, "baked", name, first, single, " with wrenches"))
    return group


def same(name: str) -> Group:
    """One robot: every form of the generated C, and CasADi's C of the same function with the same inputs."""
    model = screwgen.derive(robots.example(name))
    given, own, baked = (same_function(model, how) for how in CONSTANTS)
    auto = screwgen_library(model, "auto", "runtime", f"{name}_auto")
    other = {"fused": "modular", "modular": "fused"}[auto.layout]
    single = screwgen_library(model, "auto", "runtime", f"{name}_float", single=True)
    bound = over(1.0)
    heading = f"{name}, auto layout, and the same function in CasADi's C; ratio: time / first row or row named"
    group = Group(name, heading, data={name: data_header(model)})
    group.contenders = [
        ours(model, "auto", f"{auto.layout}, runtime", auto, against="auto"),
        _same(model, given, "casadi", "CasADi", "auto", bound),
        _same(model, given, "casadi_cse", "CasADi, cse", "auto", bound, cse=True),
        *_with_avx(model, given, "casadi_avx", "auto"),
        _variant(model, other, "runtime", "other", "auto"),
        ours(model, "prepare", f"prepare + {auto.layout}", auto, "-DWITH_PREPARE", against="auto"),
        _same(model, own, "casadi_p", FROM_PARAMETERS, "auto", bound),
        _variant(model, auto.layout, "baked", "baked", "auto"),
        _same(model, baked, "casadi_baked", "CasADi, baked / baked", "baked", over(None)),
        _same(model, baked, "casadi_baked_cse", "CasADi, baked, cse / baked", "baked", over(None), cse=True),
        ours(model, "float", f"{auto.layout}, runtime, float", single, against="auto", exact=False),
        _same(model, given, "casadi_float", "CasADi, float / float", "float", over(None), real="float"),
    ]
    return group


def more() -> Group:
    """Other robots in auto layout, and CasADi's C of the same function."""
    heading = "more robots, auto layout, and the same function in CasADi's C; ratio: time / the row above of that robot"
    group = Group("more", heading)
    for r, make in MORE.items():
        model = screwgen.derive(make())
        group.data[r] = data_header(model)
        given, own = (same_function(model, how) for how in CONSTANTS[:2])
        auto = screwgen_library(model, "auto", "runtime", f"{r}_auto")
        group.contenders += [
            ours(model, f"{r}_auto", f"{auto.layout}, {r}", auto, against=f"{r}_auto"),
            _same(model, given, f"{r}_casadi", f"CasADi, {r}", f"{r}_auto", over(1.0), extra="-DEXTRA=data_c"),
            _same(model, own, f"{r}_p", f"{FROM_PARAMETERS}, {r}", f"{r}_auto", over(1.0), extra="-DEXTRA=data_p"),
            *_with_avx(model, given, f"{r}_avx", f"{r}_auto", f", {r}"),
        ]
    return group


def steps() -> Group:
    """A step of every integrator of ELLA, joint and DAE form, over the forward dynamics it is made of."""
    model = screwgen.derive(robots.example("ella"))
    heading = f"ella: one step of {TIME_STEP * 1e3:g} ms, runtime parameters; ratio: time / forward dynamics"
    group = Group("steps", heading, data={"ella": data_header(model)})
    library = screwgen_library(model, "auto", "runtime", "steps", extra=("dae", "links"))
    group.contenders = [ours(model, "forward", "forward dynamics", library, against="forward")]
    for form, infix in (("STEP", "step"), ("DAE_STEP", "dae_step")):
        for method in METHODS:
            defines = (f"-D{form}=ella_{infix}_{method}", f"-DTIME_STEP={TIME_STEP}")
            title = f"{form[:-5].lower() or 'joint'} {method}"
            one = ours(model, f"{infix}_{method}", title, library, *defines, against="forward", exact=False)
            group.contenders.append(one)
    return group


def rigid_chain(n: int, store: Path, level: str) -> Group:
    """A rigid chain with constants baked in against articulated-body algorithms."""
    model = screwgen.derive(robots.rigid(f"rigid{n}", n))
    r, robot, auto = model.robot.name, model.robot, f"rigid{n}_auto"
    heading = f"rigid chain of {n} revolute joints, constants baked; ratio: time / the first row's"
    group = Group(r, heading, data={r: data_header(model, robots.rigid_joints(robot), loads=False)})
    library = screwgen_library(model, "auto", "baked", auto)
    group.contenders = [accelerations(model, library, "baked", against=auto)]
    for layout in ("fused", "modular"):
        make = partial(_variant, model, layout, "baked", f"{r}_{layout}", auto, False, " with wrenches")
        group.attempt(f"screwgen {layout} with wrenches", make)
    plain = {"against": auto}

    def on_casadi(make: Callable[[], Library], title: str, **more) -> Callable[[], Contender]:
        return lambda: theirs(model, title, make(), *PLAIN, **plain, **more)

    def compiled() -> Contender:
        library = rigid.pinocchio_library(store, level)
        defines = ("-I", str(rigid.HERE))
        more = plain | {"target": over(3.0)}
        return Contender(f"pinocchio{n}", "Pinocchio C++ ABA", library, "adapter_pinocchio.c", r, defines, **more)

    bound = over(0.77)
    title = "Pinocchio ABA on CasADi"
    group.attempt(title, on_casadi(lambda: rigid.pinocchio_casadi(store, robot), title, target=bound))
    title = "urdf2casadi ABA"
    group.attempt(title, on_casadi(lambda: rigid.urdf2casadi(robot), title))
    group.attempt("Pinocchio C++ ABA", compiled)
    return group


def links() -> Group:
    """Time per link from 1 to 64 equal links."""
    heading = "equal links, modes (0,1,1), runtime parameters; ratio: time per link / that of 8 links, modular"
    group = Group("links", heading)
    for n in LINKS:
        model = screwgen.derive(robots.equal_chain(f"equal{n}", n))
        group.data[model.robot.name] = data_header(model)
        for layout in ("modular", "fused") if n <= FUSED_LINKS else ("modular",):
            name, title = f"links{n}_{layout}", f"{n} link{'s' * (n > 1)}, {layout}"
            target = (None, 1.15) if layout == "modular" and n > 8 else over(None)
            more = {"against": "links8_modular", "target": target, "per": n}
            group.attempt(title, partial(_chain, model, layout, name, title, more))
    return group


def modes() -> Group:
    """Time per mode from 1 to 16 modes per plane."""
    heading = "two links, r modes per plane, runtime parameters; ratio: time per mode / that of 4 modes per plane"
    group = Group("modes", heading)
    for r in MODES:
        model = screwgen.derive(robots.many_modes(f"modes{r}", r))
        group.data[model.robot.name] = data_header(model)
        library = screwgen_library(model, "auto", "runtime", f"modes{r}_auto")
        target = (None, 1.25) if r > 4 else over(None)
        title = f"{r} mode{'s' * (r > 1)} per plane, auto"
        group.contenders.append(
            ours(model, f"modes{r}_auto", title, library, against="modes4_auto", target=target, per=4 * r)
        )
    return group


def groups(quick: bool, store: Path, level: str) -> Iterator[tuple[str, Callable[[], Group]]]:
    """The names of all groups, each with what makes it."""
    for n in (2,) if quick else LAGRANGIAN:
        yield f"lagrangian{n}", partial(lagrangians, n)
    for name in ("ella",) if quick else EXAMPLES:
        yield name, partial(same, name)
    if not quick:
        for n in RIGID:
            yield f"rigid{n}", partial(rigid_chain, n, store, level)
        yield from (("more", more), ("links", links), ("modes", modes), ("steps", steps))


# --------------------------------------------------------------------------------------------- contenders


def _variant(model, layout: str, binding: str, name: str, against: str, single=False, more="") -> Contender:
    library = screwgen_library(model, layout, binding, name, single=single)
    words = [layout + (more or f", {binding}"), *(["float"] if single else [])]
    return ours(model, name, ", ".join(words), library, against=against, exact=not single)


def _chain(model, layout: str, name: str, title: str, more: dict) -> Contender:
    return ours(model, name, title, screwgen_library(model, layout, "runtime", name), **more)


def _lagrangian(model, title: str, name: str, against: str, tuned: bool, target) -> Contender:
    library = casadi_library(lagrangian.forward_dynamics(model.robot, name, tuned))
    return theirs(model, f"CasADi {title}", library, *PLAIN, against=against, target=target)


def _with_avx(model, program, name: str, against: str, more="") -> list[Contender]:
    """CasADi's C for processors with AVX; nothing where the machine is none."""
    if not has_avx():
        return []
    return [_same(model, program, name, AVX + more, against, over(None), extra="-DEXTRA=data_c", flags=("-mavx",))]


def _same(model, program, name, title, against, target, cse=False, real="double", extra="", flags=()) -> Contender:
    options = {"casadi_real": real} if real != "double" else None
    library = casadi_library(casadi_function(program, name, cse), options)
    library = replace(library, defines=(*library.defines, *flags))
    extra = extra or {"casadi_p": "-DEXTRA=data_p"}.get(name, "-DBAKED" if "baked" in name else "-DEXTRA=data_c")
    defines = (extra, *([f"-Dcasadi_real={real}"] if options else []))
    return theirs(model, title, library, *defines, against=against, target=target, exact=not options)
