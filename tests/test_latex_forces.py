"""Documents of forces between frames and of wrenches from outside: laws of one's own, energy, tables, sketch."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
from document_forces import Acting
from document_reader import reading
from document_robots import robot_with
from document_state import State
from helpers import model_of
from test_document_changes import variants
from test_document_reader import TOLERANCE, judged, state

from screwgen import Robot, UsageError
from screwgen.backends.equations.make import equations
from screwgen.backends.latex import document as latex
from screwgen.backends.latex import forces
from screwgen.backends.latex.content import Display, DocumentTable, parse
from screwgen.backends.latex.document import chain_of
from screwgen.backends.latex.layout import PAGE, width
from screwgen.backends.latex.parameter_symbols import with_symbols
from screwgen.backends.latex.robot_tables import besides
from screwgen.backends.latex.sketch import figure
from screwgen.backends.latex.tables import links, parameters
from screwgen.interactions import KINDS, Interaction, WrenchOnSecond, number


@dataclass(frozen=True)
class Rubber(Interaction):
    """A law that says nothing of itself in LaTeX: moments against a turn, a spring that stiffens beyond a length."""

    KIND = "rubber"
    WORDS = "rubber mounts"

    shifting: float = number("N/m", "stiffness against shifts", "k_s", sign="positive", least=1e-9)
    turning: tuple = number("N·m/rad", "stiffness against turns", r"\mathbf{k}_t", least=1e-9, entries=("x", "y", "z"))
    damping: float | None = number("N·s/m", "damping", "c_s", default=None, sign="non-negative", least=1e-9)

    @staticmethod
    def wrench(t, x, **keys):
        far = t.named("distance", t.call("sqrt", x.d[0] * x.d[0] + x.d[1] * x.d[1] + x.d[2] * x.d[2] + 0.0625))
        turn = [x.R[2][1] - x.R[1][2], x.R[0][2] - x.R[2][0], x.R[1][0] - x.R[0][1]]
        stiff = t.named("stiffness_there", keys["shifting"] * (1.0 + 3e-7 * far + t.call("on", far - 0.5)))
        tilt = sum(x.d[a] * x.R[a][b] * w[b] for a in range(3) for b in range(3) for w in (x.d, x.v))
        spins = zip(keys["turning"], turn, x.omega, strict=True)
        torque = [-0.5 * (k * (t.call("sin", a) + 0.1 * w)) * (1.0 + tilt * tilt) for k, a, w in spins]
        return WrenchOnSecond(torque, [-(stiff * a + keys["damping"] * b) for a, b in zip(x.d, x.v, strict=True)])

    @staticmethod
    def energy(t, x, **keys):
        return 0.5 * keys["shifting"] * (x.d[0] * x.d[0] + x.d[1] * x.d[1] + x.d[2] * x.d[2])


PLANE = {"radius": 1.1, "stiffness": 400.0, "width": 0.02, "normal": (0.3, -1.0, 0.8)}
LAWS: dict[str, list[dict]] = {
    "line": [
        {"stiffness": 12.0},
        {"stiffness": 9.0, "damping": 0.3, "slack": True},
        {"stiffness": 7.0, "rest": 9.0},
        {"stiffness": 5.0, "rest": 0.2, "slack": True, "relaxation": 6.0, "relaxation_time": 0.3},
        {"stiffness": 5.0, "rest": 0.2, "damping": 0.4, "slack": True, "winch": True},
    ],
    "bushing": [
        {"stiffness": (300.0, 500.0, 200.0, 7.0, 9.0, 4.0)},
        {"stiffness": (3.0, 5.0, 2.0, 7.0, 9.0, 4.0), "damping": (1.0, 2.0, 3.0, 0.4, 0.5, 0.6)},
    ],
    "contact": [
        PLANE,
        {"radius": 1.6, "stiffness": 400.0, "width": 0.8},
        {"radius": 1.0, "other": 0.6, "stiffness": 400.0, "width": 0.8, "friction": 0.4},
        PLANE | {"damping": 0.3, "friction": 0.7},
        PLANE | {"normal": (0.0, 0.0, 1.0), "friction": 0.7, "velocity": 0.2},
    ],
    "drag": [{"linear": (1.0, 2.0, 3.0), "quadratic": 4.0}, {"quadratic": 2.0}, {"linear": (0.0, 0.0, 1.0)}],
    "rubber": [{"shifting": 30.0, "turning": (7.0, 8.0, 9.0)}, {"shifting": 3.0, "turning": (1, 2, 3), "damping": 0.7}],
}
"""What files may state of each kind, and a kind that they do not know."""


@cache
def rigid() -> dict:
    """A small robot of rigid links with a spring, a rope, and pushes in both kinds of axes."""
    out = robot_with("forces")
    for link in out["links"]:
        link.pop("modes", None)
    return out


def with_laws(kind: str) -> dict:
    """The same with forces of one kind in place of these."""
    laws = [(KINDS | {"rubber": Rubber})[kind](**numbers) for numbers in LAWS[kind]]
    ends = ["upper.lug", "hand.tip"]
    return rigid() | {"forces": [{"name": f"f{k}", "between": ends, "law": law} for k, law in enumerate(laws)]}


def acting(model, given) -> Acting:
    """What a document says to act in a state."""
    q, v, tau, w_ext = (np.asarray(x, float) for x in given)
    read = reading(model)
    return Acting(read.document, State(read, q, v, tau, w_ext))


def potential(stated: dict, given) -> float:
    """What forces add to the energy of a robot."""
    bare = model_of({key: x for key, x in stated.items() if key != "forces"} | {"pushes": []})
    own = model_of(stated | {"pushes": []})
    q, v, tau, _ = given
    chosen = (tau,) * own.chain.chooses_forces
    return own.numpy().energy(q, v, *chosen)[1] - bare.numpy().energy(q, v[: bare.nv])[1]


@pytest.mark.parametrize("kind", [*KINDS, "rubber"])
def test_wrenches_and_potentials_follow_from_the_lines_and_tables_alone(kind):
    stated = with_laws(kind)
    model = model_of(stated)
    assert judged(model) < TOLERANCE
    assert acting(model, state(model)).energy == pytest.approx(potential(stated, state(model)), rel=1e-12)


def pendulum(**more) -> dict:
    """A single link with a spring from its tip to the base."""
    link = {"name": "rod", "length": 1.0, "section": {"rhoA": 0.5, "rhoIp": 1e-3}, "joint": {"axes": ["y"]}}
    spring = {"name": "spring", "between": ["rod.tip", "world"], "line": {"stiffness": 12.0, "rest": 0.3}}
    return {"name": "pendulum", "gravity": [0.0, 0.0, -9.81], "links": [link], "forces": [spring]} | more


def test_a_single_link_has_the_lines_that_a_force_at_its_tip_needs():
    assert judged(model_of(pendulum())) < TOLERANCE


def test_a_rope_that_hangs_slack_does_nothing_in_its_document():
    stated = rigid() | {"forces": [dict(x) for x in rigid()["forces"]]}
    stated["forces"][1]["line"] = stated["forces"][1]["line"] | {"rest": 9.0}
    model = model_of(stated)
    assert judged(model) < TOLERANCE
    assert acting(model, state(model)).energy == pytest.approx(potential(stated, state(model)), rel=1e-12)


def test_a_law_without_latex_names_its_values_and_what_is_wider_than_a_page():
    lines = forces.lines(chain_of(Robot.model_validate(with_laws("rubber"))))
    assert r"x_{2} &= k_s\,\left(1 + 3\times 10^{-7}\,x_{1} + \mathrm{H} (x_{1} - 0.5)\right)" in lines
    assert r"\cdots" not in lines
    assert all(
        width(" ".join(row)) <= PAGE for item in parse(lines) if isinstance(item, Display) for row in item.formula
    )
    names = {symbol[1] for symbol in forces.symbols(chain_of(Robot.model_validate(with_laws("rubber"))))}
    assert {"distance, a value of the program", "stiffness there, a value of the program"} <= names


def said(robot: Robot) -> list:
    """All that a document says of forces: tables and lines."""
    chain = chain_of(robot)
    return [*besides(chain), links(chain), parameters(with_symbols(chain)), *parse(forces.lines(chain))]


def test_any_other_end_number_or_axis_of_a_force_is_another_document():
    text = said(Robot.model_validate(rigid()))
    own = [(at, other) for at, other in variants(rigid()) if at[0] in ("forces", "pushes")]
    assert len(own) == 16
    for at, other in own:
        assert said(other) != text, at


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
    rows = [(re.findall(r"\d", row[1]), row[2], row[3]) for row in found["push"].rows]
    assert rows == [(["3"], "`upper.lug`", "the world"), (["6"], "`hand.tip`", "the marker's section")]
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
    with pytest.raises(UsageError, match=re.escape("forces act between its frames, whose distances are roots")):
        equations(chain_of(Robot.model_validate(pendulum())))
    pushed = pendulum(forces=[], pushes=[{"name": "hand", "at": "rod.tip"}])
    assert equations(chain_of(Robot.model_validate(pushed)))
