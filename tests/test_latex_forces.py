"""Documents of forces between frames and of wrenches from outside: laws of one's own, energy, tables, sketch."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
from document_forces import Acting
from document_reader import reading
from document_robots import arm, robot_with
from document_state import State
from helpers import model_of
from test_document_changes import variants
from test_document_reader import TOLERANCE, judged, state

from screwgen import Robot, UsageError
from screwgen.backends.equations.make import equations
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.content import DocumentTable
from screwgen.backends.latex.document import chain_of
from screwgen.backends.latex.sketch import figure
from screwgen.interactions import Interaction, Wrench, number


@dataclass(frozen=True)
class Bushing(Interaction):
    """A law that says nothing of itself in LaTeX: moments against a turn, a spring that stiffens, one that is slack."""

    KIND = "bushing"
    WORDS = "rubber bushings"

    turning: float = number("N·m/rad", "stiffness against turns", "k_t", sign="positive", least=1e-9)
    shifting: float = number("N/m", "stiffness against shifts", "k_s", sign="positive", least=1e-9)
    damping: float | None = number("N·s/m", "damping", "d_s", default=None, sign="non-negative", least=1e-9)

    @staticmethod
    def wrench(t, x, **keys):
        far = t.named("distance", t.call("sqrt", x.d[0] * x.d[0] + x.d[1] * x.d[1] + x.d[2] * x.d[2] + 0.0625))
        turn = [x.R[2][1] - x.R[1][2], x.R[0][2] - x.R[2][0], x.R[1][0] - x.R[0][1]]
        stiff = t.named("stiffness_there", keys["shifting"] * (1.0 + 1e-3 * far + t.call("on", far - 0.5)))
        torque = [-0.5 * keys["turning"] * (t.call("sin", a) + 0.1 * w) for a, w in zip(turn, x.omega, strict=True)]
        return Wrench(torque, [-(stiff * a + keys["damping"] * b) for a, b in zip(x.d, x.v, strict=True)])

    @staticmethod
    def energy(t, x, **keys):
        return 0.5 * keys["shifting"] * (x.d[0] * x.d[0] + x.d[1] * x.d[1] + x.d[2] * x.d[2])


@cache
def rigid() -> dict:
    """A small robot of rigid links with every kind of force and push, at places that all have."""
    out = robot_with("forces")
    for link in out["links"]:
        link.pop("modes", None)
    return out


def bushed(**numbers: float) -> Robot:
    """The arm with a bushing between two tips."""
    force = {"name": "rubber", "between": ["upper.tip", "hand.tip"], "law": Bushing(7.0, 30.0, **numbers)}
    return Robot.model_validate(arm() | {"forces": [force]})


@pytest.mark.parametrize("numbers", [{"damping": 0.7}, {}], ids=["damped", "undamped"])
def test_a_law_without_latex_is_written_entry_by_entry_as_its_program_computes_it(numbers):
    robot = bushed(**numbers)
    assert judged(model_of(robot)) < TOLERANCE
    text = latex.document(robot)
    assert r"\mathrm{H}" in text and "stiffness there, a value of the program" in text
    assert ("d_s" in text) == bool(numbers)


def acting(model, given) -> Acting:
    """What a document says to act in a state."""
    q, v, tau, w_ext = (np.asarray(x, float) for x in given)
    read = reading(model)
    return Acting(read.document, State(read, q, v, tau, w_ext).scopes, w_ext)


@pytest.mark.parametrize("world", [2.0, 0.9], ids=["taut", "slack"])
def test_the_potential_of_a_document_is_that_of_the_robot(world):
    stated = rigid() | {"forces": [dict(x) for x in rigid()["forces"]]}
    stated["forces"][1]["line"] = stated["forces"][1]["line"] | {"rest": 1.1}
    stated["forces"][1]["between"] = [{"world": [0.1, 0.2, world]}, "fore.tip"]
    model, bare = model_of(stated), model_of({k: x for k, x in stated.items() if k not in ("forces", "pushes")})
    given = state(model)
    found, q, v = acting(model, given), *given[:2]
    wanted = model.numpy().energy(q, v)[1] - bare.numpy().energy(q, v)[1]
    assert found.energy == pytest.approx(wanted, rel=1e-12)
    assert judged(model) < TOLERANCE


def test_any_other_end_number_or_axis_of_a_force_is_another_document():
    text, robot = latex.document(Robot.model_validate(rigid())), rigid()
    own = [(at, other) for at, other in variants(robot) if at[0] in ("forces", "pushes")]
    assert len(own) == 16
    for at, other in own:
        assert latex.document(other) != text, at


def tables(robot: Robot) -> dict[str, DocumentTable]:
    """The tables of a document by the first word of their heads."""
    shown = latex.content(robot)
    return {x.head[0]: x for s in shown.sections for x in s.items if isinstance(x, DocumentTable)}


def test_tables_have_all_ends_numbers_and_axes():
    found = tables(Robot.model_validate(rigid()))
    spring, rope = found["acting"].rows
    assert spring[1:4] == ("`upper.lug`, link 2", "`hand.tip`, link 5", "line")
    assert rope[1].startswith(r"`world`, $\mathbf{r}_w =$") and rope[3] == "line, slack"
    assert r"$\ell_0 =$ $0.3$ $\mathrm{m}$" in rope[4]
    rows = [(row[1][-7:-3].strip("{},"), row[2], row[3]) for row in found["push"].rows]
    assert rows == [("xt,3", "`upper.lug`", "the world"), ("xt,6", "`hand.tip`", "the marker's section")]
    named = {row[0].strip("`"): row[1] for row in found["parameter"].rows}
    assert named["spring.damping"] == r"$c_\ell$" and named["rope.world[2]"] == "$r_{w,z}$"
    remarks = [row[6] for row in found["link"].rows]
    assert remarks[1].startswith("marker at which forces act, on `upper`") and "marker of the push `wind`" in remarks[2]


def test_a_sketch_has_springs_lines_and_pushes_with_their_names():
    found = figure(chain_of(Robot.model_validate(rigid())))
    texts = {label.text for label in found.drawing.labels}
    assert {"`spring`", "`rope`", "`wind`", "`grip`"} <= texts
    zigzags = [s for s in found.drawing.strokes if s.look == "drive" and len(s.points) > 6]
    assert len(zigzags) == 1
    assert "a line with a gap is longer than it is drawn" in found.caption
    bare = figure(chain_of(Robot.model_validate({**rigid(), "forces": [], "pushes": []})))
    assert not {"`spring`", "`wind`"} & {label.text for label in bare.drawing.labels} and "gap" not in bare.caption


def test_no_equations_in_scalars_of_springs_between_frames():
    link = {"name": "rod", "length": 1.0, "section": {"rhoA": 0.5, "rhoIp": 1e-3}, "joint": {"axes": ["y"]}}
    spring = {"name": "spring", "between": ["rod.tip", "world"], "line": {"stiffness": 12.0}}
    robot = {"name": "pendulum", "gravity": [0.0, 0.0, -9.81], "links": [link], "forces": [spring]}
    with pytest.raises(UsageError, match=re.escape("forces act between its frames, whose distances are roots")):
        equations(chain_of(Robot.model_validate(robot)))
    robot |= {"forces": [], "pushes": [{"name": "hand", "at": "rod.tip"}]}
    assert equations(chain_of(Robot.model_validate(robot)))
