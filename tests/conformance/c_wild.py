"""A C program that calls every public function of a folder in turn, in any order, with ordinary and with wild numbers.

It is written from the prototypes in the headers, so that no function is forgotten. What is asked of each call: a status
that the header lists; finite results where it is OK; a state of a step that is as it was where it is not.
"""

from __future__ import annotations

import re
from pathlib import Path

from conformance.c_prototypes import Argument, Prototype, _preprocessed, prototypes

SCRATCH = ("work", "chain", "mpc", "acting")
"""The ends of the names of types that are memory of a function, not its result."""
OTHERS = ("batch",)
"""Those whose members point elsewhere."""
USELESS = ("loop_directions",)
"""Functions whose header says that what they leave in the structs of their results is of no use."""
DRIVER = Path(__file__).parents[1] / "c" / "wild.h"


BATCH = """
static real batch_q[@@_NQ + 1][SCENARIOS], batch_v[@@_RATES + 1][SCENARIOS], batch_tau[@@_NTAU + 1][SCENARIOS];
static int batch_status[SCENARIOS], batch_fault[SCENARIOS];

static void set_batch(@_batch *b)
{
    memset(b, 0, sizeof *b);
    memset(batch_status, 0, sizeof batch_status);
    mix(batch_q, sizeof batch_q, 1);
    mix(batch_v, sizeof batch_v, 1);
    mix(batch_tau, sizeof batch_tau, 1);
    b->count = b->stride = SCENARIOS;
    b->q = &batch_q[0][0];
    b->v = &batch_v[0][0];
    b->tau = &batch_tau[0][0];
    b->status = batch_status;
    b->fault = batch_fault;
}

/* The states of scenarios that went well. */
static void see_batch(int status)
{
    int i, k;
    for (i = 0; i < SCENARIOS; ++i) {
        for (k = 0; k < @@_NQ + @@_RATES; ++k) {
            const real x = k < @@_NQ ? batch_q[k][i] : batch_v[k - @@_NQ][i];
            expect(status != 0 || last_whole == 0 || batch_status[i] != 0 || isfinite(x), "scenario not finite", i);
        }
    }
}
"""
"""How batches are set up and looked at: `@` is the robot's name."""


def program(folder: Path, name: str) -> str:
    """The source; its arguments are the number of calls and a seed."""
    found = prototypes(folder, name)
    texts = "\n".join(_preprocessed(folder, header) for header in dict.fromkeys(f.header for f in found))
    kinds = dict.fromkeys(a.kind for f in found for a in f.arguments if a.pointer and a.kind != f"{name}_real")
    lines = [f'#include "{header}"' for header in dict.fromkeys(f.header for f in found)]
    lines += [f"typedef {name}_real real;", f"enum {{ LAST_STATUS = {name.upper()}_BAD_ARGUMENT }};"]
    lines += [f'#include "{DRIVER}"', ""]
    lines += [f"static {kind} *{_variable(kind, name)};" for kind in kinds]
    lines += ["", *_reset(name, kinds, texts), "", *_vary(name, kinds, texts), ""]
    if f"{name}_batch" in kinds:
        rates = "NVZ" if re.search(rf"\b{name.upper()}_NVZ\b", texts) else "NV"  # internal states stand behind them
        batch = BATCH.replace("RATES", rates).replace("@@", name.upper()).replace("@", name)
        lines += batch.splitlines()
    for number, function in enumerate(found):
        lines += _call(number, function, name)
    lines += ["static void (*const CALLS[])(void) = {", *(f"    call_{k}," for k in range(len(found))), "};", ""]
    said = "\n".join(f'    "{f.name}",' for f in found)
    lines += ["static const char *const NAMES[] = {", said, "};", "", "int main(int argc, char **argv)", "{"]
    lines += [f"    {_variable(kind, name)} = block(sizeof({kind}));" for kind in kinds]
    lines += ["    return campaign(CALLS, NAMES, (int)(sizeof CALLS / sizeof CALLS[0]), argc, argv);", "}", ""]
    return "\n".join(lines)


def _variable(kind: str, name: str) -> str:
    return f"the_{kind.removeprefix(name + '_')}"


def _members(texts: str, kind: str, pattern: str) -> list[str]:
    """The members of a struct whose declarations match: their names."""
    body = next((b for b, own in re.findall(r"typedef struct \{([^{}]*)\} (\w+);", texts) if own == kind), "")
    declared = [(m[0], part) for m in re.findall(r"(\w+) ([^;]+);", body) for part in m[1].split(",")]
    names = [(real, re.match(r"\s*\*?\s*(\w+)", part)[1]) for real, part in declared]
    return [own for real, own in names if re.fullmatch(pattern, f"{real} {own}")]


def _reset(name: str, kinds: dict[str, None], texts: str) -> list[str]:
    """Ordinary contents of all that is handed on from call to call; parameters are the file's, or now and then wild."""
    lines = ["static void reset(void)", "{", f"    {name}_parameters_default(the_parameters);"]
    lines += ["    if (one_in(3)) {", "        spoil(the_parameters, sizeof *the_parameters, 1);", "    }"]
    lines += [f"    if ({name}_prepare(the_parameters, the_constants) != 0) {{"]
    lines += [f"        {name}_parameters_default(the_parameters);"]
    lines += [f'        expect({name}_prepare(the_parameters, the_constants) == 0, "defaults", 0);', "    }"]
    lines += ["    ordinary(the_state, sizeof *the_state);", "    ordinary(the_input, sizeof *the_input);"]
    if f"{name}_dae_state" in kinds:
        lines += [f"    (void){name}_dae_from_state(the_constants, the_state, the_dae_work, the_dae_state);"]
    if f"{name}_estimator" in kinds:
        deviation = f"{name}_deviation" if f"{name}_deviation" in kinds else f"{name}_state"
        chain = ", the_chain" if "chain" in _last(texts, f"{name}_estimator_init") else ""
        lines += ["    {", f"        {deviation} deviation;", "        fill(&deviation, sizeof deviation, 0.01);"]
        given = _given(texts, f"{name}_estimator_init", name, {"deviation": "&deviation"})
        lines += [f"        (void){name}_estimator_init({given});", "    }"] if not chain or given else []
        for own in _members(texts, f"{name}_estimator", rf"{name}_real (density_\w+|\w+_variance|fibre)"):
            lines.append(f"    fill(the_estimator->{own}, sizeof the_estimator->{own}, 1e-4);")
    if f"{name}_mpc" in kinds:
        lines += [f"    {name}_mpc_default(the_mpc_options);", "    the_mpc_options->qp_iterations = 20;"]
        lines += [f"    (void){name}_mpc_initialise(the_mpc, the_mpc_options, the_constants, the_state, 0);"]
    return [*lines, "}"]


def _last(texts: str, function: str) -> str:
    match = re.search(rf"\b{function}\s*\(([^;]*)\);", texts)
    return match[1] if match else ""


def _given(texts: str, function: str, name: str, own: dict[str, str]) -> str:
    """The arguments of a call out of what is kept."""
    found = re.findall(r"(\w+) \*(\w+)", _last(texts, function))
    return ", ".join(own.get(argument, _variable(kind, name)) for kind, argument in found)


def _vary(name: str, kinds: dict[str, None], texts: str) -> list[str]:
    """Changes of what is read: new ordinary numbers, single wild ones, or all of any size."""
    lines = ["static void vary(void)", "{"]
    for kind in ("state", "input", "dae_state", "estimator", "measurement", "mpc_options"):
        if f"{name}_{kind}" not in kinds:
            continue
        real = f"the_{kind}"
        whole = f"    mix({real}, sizeof *{real}, {int(kind in ('state', 'input', 'measurement'))});"
        integers = _members(texts, f"{name}_{kind}", r"int \w+")
        lines += [f"    if (one_in({2 if kind in ('state', 'input', 'measurement') else 12})) {{", f"    {whole}"]
        lines += [f"        choose(&{real}->{own}, sizeof {real}->{own});" for own in integers]
        lines += ["    }"]
    places = {"state": "the_state->", "dae_state": "the_dae_state->"}
    places |= {"state ": "the_estimator->state."} if f"{name}_estimator" in kinds else {}
    for kind, place in places.items():
        lines += _without_absent(texts, f"{name}_{kind.strip()}", place) if f"{name}_{kind.strip()}" in kinds else []
    return [*lines, "}"]


def _without_absent(texts: str, kind: str, place: str) -> list[str]:
    """Members that have an entry for C's sake alone, where the robot has none, are zero: no function looks at them."""
    body = next((b for b, own in re.findall(r"typedef struct \{([^{}]*)\} (\w+);", texts) if own == kind), "")
    found = re.findall(r"(\w+)\[\(\(([^()]+)\) > 0 \? \(\2\) : 1\)\]", body)
    return [f"    if (!(({n}) > 0)) {{ memset({place}{own}, 0, sizeof {place}{own}); }}" for own, n in found]


def _call(number: int, function: Prototype, name: str) -> list[str]:
    """A function that makes one call and looks at what comes of it."""
    lines, given, results, kept = [f"static void call_{number}(void)", "{"], [], [], []
    for k, argument in enumerate(function.arguments):
        short = argument.kind.removeprefix(f"{name}_")
        if not argument.pointer:
            given.append({"real": "wild_step()", "int": "whole_number()"}.get(short, "0"))
        elif short == "real":
            size = f"{_count(argument)} * sizeof(real)"
            lines.append(f"    real *const a{k} = block({size});")
            if argument.constant:
                lines.append(f"    mix(a{k}, {size}, 1);")
            else:
                results.append((f"a{k}", size))
            given.append(_cast(argument, f"a{k}"))
        elif short in OTHERS:
            lines.append(f"    set_{short}(the_{short});")
            given.append(f"the_{short}")
        else:
            given.append(f"the_{short}")
            if argument.constant or short.endswith(SCRATCH):
                continue
            if short in ("state", "dae_state", "estimator") and "_step_" in function.name + "_step_" * (
                short != "state"
            ):
                kept.append(short)
            elif not short.startswith(("constants", "mpc", "parameters")):
                lines.append(f"    memset(the_{short}, 0, sizeof *the_{short});")
            if short == "estimator":  # its other members are the caller's, and perhaps of no measurement
                results += [(f"&the_estimator->{own}", f"sizeof the_estimator->{own}") for own in ("state", "P")]
            elif not short.startswith(("parameters", "mpc")) and not function.name.endswith(USELESS):
                results.append((f"the_{short}", f"sizeof *the_{short}"))
    for own in kept:
        lines.append(f"    void *const before_{own} = copy(the_{own}, sizeof *the_{own});")
    call = f"{function.name}({', '.join(given)})"
    if not function.result.endswith("_status"):
        lines.append(f"    (void){call};" if function.result != "void" else f"    {call};")
    else:
        lines.append(f"    const int status = (int){call};")
        lines.append("    seen(status);")
        if any(a.kind == f"{name}_batch" for a in function.arguments):
            lines.append("    see_batch(status);")
        for text, size in results:
            lines.append(f'    expect(status != 0 || all_finite({text}, {size}), "not finite", 0);')
        for own in kept:
            lines.append(
                f'    expect(status == 0 || !memcmp(before_{own}, the_{own}, sizeof *the_{own}), "changed", 0);'
            )
    lines += [f"    free(before_{own});" for own in kept]
    lines += [f"    free(a{k});" for k, a in enumerate(function.arguments) if a.pointer and a.kind == f"{name}_real"]
    return [*lines, "}", ""]


def _count(argument: Argument) -> str:
    """How many reals an array has, so that whoever writes past its end is seen; ARRAY where the header does not say."""
    lengths = re.findall(r"\[([^]]*)\]", argument.lengths)
    return " * ".join(f"(size_t)({x})" for x in lengths) if lengths and all(lengths) else "ARRAY"


def _cast(argument: Argument, text: str) -> str:
    """An array of reals as the type of the argument."""
    rest = argument.lengths.partition("]")[2]
    return f"({'const ' * argument.constant}real (*){rest}){text}" if rest else text
