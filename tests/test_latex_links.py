"""The page of equations as something to move about in: every link leads somewhere, every line of C is what it says."""

from __future__ import annotations

import html
import json
import re
from functools import cache
from itertools import combinations
from xml.etree import ElementTree

import pytest
from browsers import every_browser, started
from helpers import arm, example_file, link
from latex_documents import PLUGINS, page

from screwgen import Robot, derive, load, natural_frequencies
from screwgen.backends.c.project import CProject
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.code_lines import CodeLines, found
from screwgen.backends.latex.content import Document
from screwgen.backends.latex.diagram import diagram
from screwgen.backends.latex.marks import Marks
from screwgen.backends.latex.page import Extras, symbols_of
from screwgen.topology.chain import Chain
from screwgen.version import __version__

ROD = link("rod", axes="z", modes={"bending_y": 1})
PENDULUM = Robot(**arm(ROD | {"bodies": [{"at": "tip", "mass": 0.2}]}, name="pendulum"))
ROBOTS = ("ella", "pendulum", "parallelogram")
every_robot = pytest.mark.parametrize("name", ROBOTS)


@cache
def chain(name: str) -> Chain:
    return Chain(PENDULUM if name == "pendulum" else load(example_file(name)))


@cache
def extras(name: str) -> Extras:
    return latex.extras(chain(name))


@cache
def content(name: str) -> Document:
    return latex.content(chain(name).robot, PLUGINS)


@cache
def shown(name: str) -> str:
    return page("ella") if name == "ella" else latex.page(content(name), extras(name))


def body(name: str) -> str:
    return shown(name).partition("<script>//")[0]


# -------- anchors, symbols, numbers


@every_robot
def test_every_link_leads_to_one_place(name):
    tree = ElementTree.fromstring(shown(name))
    ids = [e.get("id") for e in tree.iter() if e.get("id")]
    assert len(ids) == len(set(ids))
    goals = [e.get("href") for e in tree.iter("a")]
    assert len(goals) > 15 and all(goal[0] == "#" and goal[1:] in ids for goal in goals)
    data = json.loads(re.search(r"const DATA = (.*);\n", shown(name))[1])
    assert {goal for goals in data["defined"].values() for goal in goals} <= set(ids)
    marked = {e.get("data-s") for e in tree.iter() if e.get("data-s")}
    assert len(marked) > 40 and {f"y{number}" for number in marked} <= set(ids)


CHILDREN = {"msub": 2, "msup": 2, "mover": 2, "munder": 2, "mfrac": 2, "mroot": 2, "msubsup": 3, "munderover": 3}


@every_robot
def test_scripts_accents_and_fractions_have_what_they_need(name):
    elements = [e for e in ElementTree.fromstring(shown(name)).iter() if e.tag in CHILDREN]
    assert len(elements) > 500
    assert [ElementTree.tostring(e) for e in elements if len(e) != CHILDREN[e.tag]] == []


def test_what_the_lines_compute_is_defined_by_them():
    """Twist, inertia and bias of a link; what a step of a class defines is found in its section."""
    data = json.loads(re.search(r"const DATA = (.*);\n", shown("ella"))[1])["defined"]
    number = {row: k for k, row in enumerate(symbols_of(content("ella")))}
    title = {f"s{k}": section.title for k, section in enumerate(content("ella").sections, 1)}
    for symbol in (r"\mathbf{V}_i", r"\mathbf{M}_i", r"\mathbf{h}_i", r"\mathbf{M}_T", r"\mathbf{g}_i"):
        place = data[str(number[symbol])][0]
        assert title[place.partition("-")[0]] == "Algorithm", (symbol, place)
    assert title[data[str(number[r"\mathbf{s}_0"])][0].partition("-")[0]] == "Link class 1"


def test_numbers_are_those_of_the_robot():
    """The second link's third mode, and a product that stands in no file."""
    [row] = re.findall(r'<tr id="mode-forearm-3">(.*?)</tr>', body("ella"))
    assert "bending in z" in row and "1.5161" in "".join(ElementTree.fromstring(f"<tr>{row}</tr>").itertext())
    known = extras("ella").numbers
    assert known[r"\mathbf{s}_0"]["upper_arm"][0] == [f"{0.95**2 * 1.6302 / 2:.5g}"]
    assert known["l_i"] == {"upper_arm": [["0.95"]], "forearm": [["0.93"]]}


def test_frequencies_are_those_of_modes():
    """One of the bare rod for its mode, and one of the rod with the body at its tip."""
    bare, held = (natural_frequencies(derive(robot))[0] for robot in (Robot(**arm(ROD)), PENDULUM))
    assert extras("pendulum").modes.rows[0][-1] == f"{bare:.4g} Hz" != f"{held:.4g} Hz"
    assert extras("pendulum").held.rows == (("`rod`", f"{held:.4g} Hz"),)
    text = body("pendulum")
    assert text.count(f"{bare:.4g} Hz") == text.count(f"{held:.4g} Hz") == 1 and "without its bodies" in text


def test_symbols_are_found_below_accents_and_beside_scripts():
    marks = Marks([r"\mathbf{r}_T", r"\rho_i A_i", r"\mathbf{M}^*_i", "x"], {r"r_{T,x}": (r"\mathbf{r}_T", (0, 0))})
    shows = {
        r"\tilde{\mathbf{r}}_T": ["0"],
        r"\mathbf{r}_T^{\top}\,\mathbf{r}_T": ["0", "0"],
        r"\frac{\rho_i A_i\,l_i}{2}": ["1"],
        r"\mathbf{M}^*_i\,\dot{x}": ["2", "3"],
        r"S_x": [],
        r"r_{T,x}\,c": ["0"],
    }
    for formula, expected in shows.items():
        marked = marks(str(latex.text.in_html(f"${formula}$")))
        assert re.findall(r'data-s="(\d+)"', marked) == expected, formula


@every_robot
def test_the_table_of_symbols_has_those_of_the_page(name):
    """Every row is pointed at from elsewhere; what the text names without a step has a row too."""
    tree = ElementTree.fromstring(shown(name))
    rows = {e.get("id"): e for e in tree.iter("tr") if re.fullmatch(r"y\d+", e.get("id") or "")}
    own = {id(x) for row in rows.values() for x in row.iter()}
    used = {f"y{x.get('data-s')}" for x in tree.iter() if x.get("data-s") and id(x) not in own}
    assert used == rows.keys(), [content(name).name, *("".join(rows[y][0].itertext()) for y in rows.keys() - used)]
    letters = {"".join(row[0].itertext()) for row in rows.values()}
    assert {"\U0001d40d", "\U0001d415T", "\U0001d42bT"} <= letters  # N, V_T, r_T


def test_the_page_is_the_same_every_time_and_small():
    again = latex.html(PENDULUM, PLUGINS)
    assert again == shown("pendulum")
    assert max(len(page(name).encode()) for name in ("ella", "space_arm")) < 1_500_000


def test_levels_grow():
    """What is essential is little; every step is at the last level."""
    counts = [len(re.findall(rf'class="(?:one|formula) l{level}"', body("ella"))) for level in (1, 2, 3)]
    assert 8 <= counts[0] <= 14 < counts[1] and counts[2] > 60, counts


# -------- the diagram


@every_robot
def test_the_diagram_is_drawn_from_the_model(name):
    drawn = re.search(r'<figure class="diagram">.*?</figure>', shown(name), re.S)[0]
    assert drawn.count('<g class="box">') == drawn.count('<g class="flow">') == chain(name).n
    assert drawn.count('<path class="loop"') == len(chain(name).closing.junctions)
    assert drawn.count('class="modes"') == sum(key.modes > 0 for key in chain(name).keys)


def test_the_diagram_of_a_long_arm_goes_on_in_a_further_line():
    svg = next(
        e for e in ElementTree.fromstring(diagram(Chain(load(example_file("six_link"))))).iter() if e.get("viewBox")
    )
    width, height = (float(svg.get(side)) for side in ("width", "height"))
    boxes = [[float(e.get(k)) for k in ("x", "y", "width", "height")] for e in svg.iter() if e.tag.endswith("rect")]
    assert width <= 928 and len(boxes) == 7 and len({y for _, y, *_ in boxes}) == 2
    for (x, y, w, h), (a, b, c, d) in combinations(boxes, 2):
        assert x + w < a or a + c < x or y + h < b or b + d < y
    paths = [e.get("d") for e in svg.iter() if (e.get("class") or "") in ("p1", "p2", "p3") and e.get("d")]
    places = [(float(x), float(y)) for path in paths for x, y in re.findall(r"([\d.]+) ([\d.]+)", path)]
    assert len(paths) == 18 and all(0 <= x <= width and 0 <= y <= height for x, y in places)
    assert ">1 axis, 1 mode<" in body("pendulum")


# -------- lines of C


@cache
def files(name: str) -> dict[str, list[str]]:
    project = CProject(chain(name), __version__)
    return {file: text.split("\n") for file, text in project.files().items() if file.endswith(".c")}


def check(name: str, lines: CodeLines) -> None:
    """The lines are those of the file, and within the function of that name."""
    text = files(name)[lines.file]
    assert tuple(text[lines.first - 1 : lines.last]) == lines.text
    starts = [
        k for k, line in enumerate(text) if re.match(rf"[A-Za-z_].*\b{lines.function}\(", line) and line[-1] != ";"
    ]
    assert any(k < lines.first <= lines.last <= text.index("}", k) for k in starts), lines


@every_robot
def test_every_step_names_lines_of_c_that_have_its_name(name):
    """Of all steps that the page shows, most have lines; the others are names for entries of others."""
    steps = linked = 0
    for section in content(name).sections:
        for item in section.items:
            if item.kind != "equation" or not section.link_class:
                continue
            steps += 1
            lines = extras(name).code.of_step(extras(name).firsts[section.link_class - 1], item.step)
            if lines is not None:
                linked += 1
                check(name, lines)
                assert re.search(rf"\b(?:minus_)?{re.escape(item.step.name)}(?![a-z])", "\n".join(lines.text)), lines
                assert item.step.name in lines.title or not lines.text[0].lstrip().startswith("/*")
    assert linked > 0.45 * steps


@every_robot
def test_the_page_shows_these_lines(name):
    summaries = re.findall(
        r"<details class=\"code[^>]*><summary>C: (.*?)</summary>\n<pre>(.*?)</pre>", shown(name), re.S
    )
    assert len(summaries) > 25
    for said, code in summaries:
        function, file, first, last = re.search(
            r"<code>(\w+)</code> <span class=\"of\">([\w.]+):(\d+)(?:–(\d+))?", said
        ).groups()
        text = files(name)[file][int(first) - 1 : int(last or first)]
        shown_lines = html.unescape(code).split("\n")
        assert [line.removeprefix("    ") for line in text][: len(shown_lines) - 1] == shown_lines[: len(text)][:-1]
        assert any(f"{function}(" in line for line in files(name)[file])


def test_the_line_that_takes_the_bias_from_the_torque_is_named():
    named = re.findall(r"([\w.]+):(\d+)–(\d+), taken from τ in line (\d+)", body("ella"))
    assert len(named) == chain("ella").n
    for file, first, last, line in named:
        assert int(first) <= int(line) <= int(last)
        assert re.search(r"input->tau\[\d\]", files("ella")[file][int(line) - 1])


def test_headings_of_several_lines_are_read():
    text = "int f(int a)\n{\n    /* S: a long\n     * title (3)\n     */\n    b = 1;\n    c = 2;\n\n    d = 3;\n}\n"
    [lines] = found("f.c", text)
    assert (lines.function, lines.title, lines.first, lines.last) == ("f", "S: a long title (3)", 3, 7)


# -------- in a browser


def first_class() -> str:
    """The anchor of the section of ELLA's first class."""
    return re.search(r'id="(s\d+)-M_D"', body("ella"))[1]


CARDS_OUTSIDE = """(() => {
  const seen = new Set(), out = [];
  for (const e of $("main [data-s]")) {
    if (seen.has(e.dataset.s) || !e.getClientRects().length) continue;
    seen.add(e.dataset.s);
    e.scrollIntoView({ block: "center" });
    tell(e);
    const r = card.getBoundingClientRect();
    const inside = r.left >= 0 && r.top >= 0 && r.right <= root.clientWidth + 1 && r.bottom <= innerHeight + 1;
    if (!inside) out.push(e.textContent);
  }
  hide();
  return seen.size > 50 ? out : ["too few symbols"];
})()"""
"""The symbols whose cards are not within the window."""
SQUEEZED = """(() => {
  document.querySelectorAll("details.reference").forEach(x => x.open = true);
  const out = [], wide = document.documentElement.clientWidth, cells = document.querySelectorAll(".prose td");
  for (const cell of cells) {
    const at = cell.getBoundingClientRect();
    if (at.right > wide || (at.height > 50 && at.width < wide / 2)) out.push(cell.textContent);
  }
  return cells.length > 200 ? out : ["too few cells"];
})()"""
"""The cells with words that are cut by the edge of a narrow window, or have a word in a line."""
COVERING = "getComputedStyle(hint).position !== 'static'"
GAPS = """Math.max(...[...document.querySelectorAll("p msqrt")].filter(x => x.nextElementSibling).map(x =>
  x.nextElementSibling.getBoundingClientRect().left - x.lastElementChild.getBoundingClientRect().right))"""
"""How far what follows a root is from it."""


@pytest.mark.examples
@every_browser
def test_a_reader_finds_a_way(program, tmp_path):
    """Levels, the hash, search, what is known of a symbol, numbers, C beside formulas, contents."""
    file = tmp_path / "page.html"
    file.write_text(shown("ella"), encoding="utf-8")
    with started(program, tmp_path) as browser:
        browser.open(file)
        assert browser.run("hint.offsetHeight") > 20 and not browser.run(COVERING)
        assert browser.run(GAPS) < 3.0
        high = "document.documentElement.scrollHeight"
        assert browser.run(high) < 8000
        for level, least in ((2, 10_000), (3, 15_000)):
            browser.run(f"document.querySelector('button[data-level=\"{level}\"]').click()")
            assert browser.run(high) > least and browser.run("location.hash").startswith(f"#{level}")
        browser.run("find.value = 'M_D'; search(); find.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter'}))")
        first = first_class()
        assert browser.run("location.hash") == f"#3/{first}-M_D"
        browser.until("document.querySelector('.contents .here').textContent === 'Link'")
        place = f"document.querySelector('#{first}-M_D .formula [data-s]').getBoundingClientRect()"
        browser.until(f"Math.abs({place}.top - innerHeight / 2) < innerHeight / 4")
        seen = f"window.was === (window.was = {place}.top)"
        stays = f"({seen} ? window.still = (window.still || 0) + 1 : window.still = 0) > 9"
        browser.until(stays)
        browser.point(*browser.run(f"[{place}.left + 4, {place}.top + {place}.height / 2]"))
        browser.until("!card.hidden")
        assert "wrench that modal accelerations need" in browser.run("card.textContent")
        assert browser.run("hint.offsetHeight") == 0
        assert browser.run(CARDS_OUTSIDE) == []
        browser.run(f"tell(document.querySelector('#{first}-S_0 .formula [data-s]'))")
        assert f"{0.95**2 * 1.6302 / 2:.5g}" in browser.run("card.textContent")
        for words, place in (("inertia forearm mode 3", "mode-forearm-3"), ("forearm", f"s{int(first[1:]) + 1}")):
            browser.run(f"find.value = '{words}'; search()")
            assert browser.run("document.querySelector('#found a').getAttribute('href')") == f"#{place}"
        browser.run("document.querySelector('[data-switch=n]').click()")
        assert browser.run("document.querySelectorAll('.numbers').length") > 20
        browser.run("document.querySelector('[data-switch=c]').click()")
        assert browser.run(f"document.querySelector('#{first}-S_0 pre').offsetHeight") > 20
        browser.go("about:blank")
        browser.go(f"{file.as_uri()}#2n/{first}-S")
        browser.until("window.screwgen")
        assert browser.run("document.documentElement.dataset.level + state.n + state.c") == "2truefalse"
        browser.run("matchMedia = () => ({ matches: false }); one = document.querySelector('main .formula [data-s]')")
        for shown_card, there in ((True, False), (False, True)):  # the first tap tells, the second leads on
            browser.run("one.dispatchEvent(new MouseEvent('click', { bubbles: true }))")
            assert browser.run("!card.hidden") is shown_card
            assert (browser.run("location.hash") != f"#2n/{first}-S") is there
        for wide in (1000, 390):
            browser.resize(wide, 844, True)
            assert browser.run("document.documentElement.scrollWidth") <= wide
        browser.run("document.documentElement.dataset.level = 3")
        assert browser.run(SQUEEZED) == []
        assert browser.run(CARDS_OUTSIDE) == []
        assert not browser.complaints
        assert all(url in ("about:blank",) or url.startswith(file.as_uri()) for url in browser.requests)
