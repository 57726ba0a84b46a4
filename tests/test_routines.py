"""What recurs in programs becomes routines: the same results, each printed once."""

import re

import pytest
from helpers import link, model_of

from screwgen.backends.c.copies import array, copied
from screwgen.backends.c.project import CProject
from screwgen.backends.latex.code_lines import _functions
from screwgen.ir.program import Program, Tracer
from screwgen.ir.replay import bind, inline, run
from screwgen.ir.routines import CALL, FOUND, GIVEN, RESULT, SHORTEST, outlined


def polynomial(tracer, x, y, factor, more=0):
    """Many operations of two values, marked as recurring."""
    with tracer.routine("horner"):
        total = x
        for k in range(SHORTEST // 2 + more):
            total = total * y + factor * (k + 2)
        return total, total * total


def program(factors, more=(0, 0), guarded=False):
    """Two calls, one after the other."""
    tracer = Tracer()
    x = tracer.input("x", 2)
    first, square = polynomial(tracer, x[0], x[1], factors[0], more[0])
    second, other = polynomial(tracer, first + 1.0, square, factors[1], more[1])
    if guarded:
        tracer.guard(second)
    return tracer.program("two", {"x": 2}, {"y": [second, other * x[0], first]})


def evaluated(p: Program, x):
    """The outputs of a program with calls."""
    values = {}
    pick = lambda v: values[v.id] if hasattr(v, "op") else v  # noqa: E731
    for n in p.nodes:
        if n.op == "input":
            values[n.id] = x[n.args[1]]
        elif n.op == CALL:
            routine, *given = n.args
            values[n.id] = run(routine.program, {GIVEN: [pick(v) for v in given]}, None)[0][FOUND]
        elif n.op == RESULT:
            values[n.id] = values[n.args[0].id][n.args[1]]
        else:
            a, b = map(pick, n.args)
            values[n.id] = {"add": a + b, "sub": a - b, "mul": a * b}[n.op]
    return [pick(v) for v in p.outputs["y"]]


@pytest.mark.parametrize("factors", [(0.5, 0.5), (0.5, 0.25)])
def test_calls_give_the_same_values(factors):
    """To the bit; numbers that differ from call to call are arguments, others stay in the routine."""
    whole, x = program(factors), [0.3, 0.1]
    (calling,), (routine,) = outlined([whole])
    assert evaluated(calling, x) == run(whole, {"x": x}, None)[0]["y"]
    assert calling.operations[CALL] == 2 and routine.calls == 2
    numbers = routine.reads.count("number")
    assert numbers == (0 if factors[0] == factors[1] else SHORTEST // 2)
    assert routine.program.inputs[GIVEN] == 2 + numbers


def test_programs_share_routines_after_specialisation():
    """Marks survive inlining and binding; a part that became shorter is another routine, or none if it stands alone."""
    whole = program((0.5, 0.5))
    calling, (routine,) = outlined([whole, bind(whole, {"x": [2.0, None]})])
    assert routine.calls == 3
    assert [p.operations[CALL] for p in calling] == [2, 1]
    x = [2.0, 0.1]
    assert evaluated(calling[1], x) == pytest.approx(run(whole, {"x": x}, None)[0]["y"], rel=1e-15)
    tracer = Tracer()
    doubled = tracer.program("doubled", {"x": 2}, inline(whole, {"x": tracer.input("x", 2)}, tracer, "arm"))
    assert outlined([doubled])[1][0].calls == 2


def test_what_is_no_routine():
    """Parts that differ, parts with guards, and short ones stay where they are."""
    for whole in (program((0.5, 0.5), (0, 1)), program((0.5, 0.5), guarded=True)):
        (same,), routines = outlined([whole])
        assert same is whole and not routines


def test_copies_of_consecutive_entries_are_loops():
    """Single values first, as an initialiser; runs of entries by loops."""
    values = ["t1", "2", *(f"link->W[{k}]" for k in range(3, 8)), "x[9]"]
    lines = array("real given", values, 90)
    assert lines[0] == "real given[8] = { t1, 2 };"
    assert lines[1:] == ["for (int k = 0; k < 5; ++k) {", "    given[k + 2] = link->W[k + 3];", "}", "given[7] = x[9];"]
    assert array("real given", ["long", "longer"], 24) == ["real given[2] = {", "    long, longer", "};"]
    assert copied([("a[0]", "b[1]"), ("a[1]", "b[0]")], "+=") == ["a[0] += b[1];", "a[1] += b[0];"]


@pytest.fixture(scope="module")
def soft_arm():
    """Two exact links of one class of rod on different joints."""
    modes = {"bending_y": 2, "bending_z": 2, "torsion": 1}
    section = {"rhoA": 1.0, "EIy": 2.0, "EIz": 3.0, "GJ": 2.0, "rhoIp": 1e-3}
    links = [link(f"rod_{axis}", modes=modes, section=section, joint={"axes": [axis]}) for axis in "yz"]
    return model_of({"name": "soft", "gravity": [0.0, 0.0, -9.81], "order": "exact", "links": links})


def test_the_sections_of_a_rod_are_written_once(soft_arm):
    """Half of the text of modular C, and every function that is called is there."""
    text = CProject(soft_arm.chain, "0", layout="modular").text("links.c")
    defined = re.findall(r"void (compute_\w+)\(const", text)
    called = re.findall(r"^ +(compute_\w+)\(", text, re.M)
    assert len(defined) == len(set(defined)) and set(called) == set(defined)
    assert {"compute_rod_section", "compute_rod_mass", "compute_rod_load"} <= set(defined)
    assert len(called) > 3 * len(defined)


def test_other_links_have_no_routines():
    """Links that are no exact rods have no routines."""
    rigid = model_of({"name": "stiff", "gravity": [0.0, 0.0, -9.81], "links": [link("bar", joint={"axes": ["z"]})]})
    assert "compute_" not in CProject(rigid.chain, "0", layout="modular").text("links.c")


def test_the_page_looks_into_what_phases_call(soft_arm):
    """The steps of an exact rod stand in functions that phases call; the page of equations finds lines there, too."""
    looked_into = {name for name, run in _functions(CProject(soft_arm.chain, "0", layout="modular"), 0)}
    assert {"compute_rod_section", "compute_rod_mass", "compute_rod_load", "eliminate_rod_y"} <= looked_into
