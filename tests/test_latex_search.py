"""The search of the page of equations: what readers type leads where they mean."""

import re
from collections.abc import Iterator
from xml.etree import ElementTree

import pytest
from browsers import every_browser, started
from conftest import swept
from helpers import arm, link
from latex_documents import PLUGINS
from test_document_reader import EXAMPLES
from test_latex_links import body, first_class, shown

from screwgen import Robot
from screwgen.backends.latex import document as latex

SEARCHES = {
    "third mode": ("mode-upper_arm-3", "mode-forearm-3"),
    "second link third mode": ("mode-forearm-3",),
    "inertia of the 2nd link's third mode": ("mode-forearm-3",),
    "elbow torque": ("torque-forearm",),
    "equation for the elbow's torque": ("torque-forearm",),
    "shoulder": ("torque-upper_arm",),
    "forearm torque": ("torque-forearm",),
    "tau_3": ("torque-forearm",),
    "torque of joint 2": ("torque-forearm",),
    "joint bias": ("{bias upper_arm}", "{bias forearm}"),
    "bias of joint 2": ("{bias forearm}",),
    "rudder torque of the forearm": ("torque-forearm",),
    "M_D": ("{first}-M_D",),
    "eta": ("{eta}",),
    "M_12": ("M-1-2",),
    "joint 3 mode 1 of link 2": ("M-3-7-is",),
    "coupling of elbow and first bending in y": ("M-3-5", "M-3-8-is"),
    "mass matrix": ("{matrix}",),
    "gravity": ("{gravity}",),
    "where does gravity enter": ("{gravity}",),
    "payload": ("{payload}",),
    "payload mass matrix": ("{payload}",),
    "payload in M": ("{payload}",),
    "shape of the second mode": ("{shape}",),
    "second mode shape": ("{shape}",),
}
"""What readers type, and where the first hits lead; that the forearm's joint is an elbow no file says."""
ENTRIES = {
    "M-6-1": ("M_16 = ", "kg", "mode 3 of link 1", "row 1, column 3 of the block Mq1 η1, with j\u00a0=\u00a01 in", "⊤"),
    "M-3-7": ("M_37 = 0 kg m", "joint 3", "first axial", "0.958641"),
    "M-7-8": ("M_78 = 0 kg", "zero in every posture"),
}
"""What the cards of entries of the mass matrix say."""


def test_a_search_knows_joints_of_links_without_telling_names():
    """The word is looked for and not shown: it is a guess from the row of links."""
    text = latex.html(Robot(**arm(link("one", axes="z"), link("two", axes="z"), name="plain")), PLUGINS)
    assert re.findall(r'<tr id="guide-(\w+)" data-find="(\w*)"', text) == [("one", "shoulder"), ("two", "elbow")]
    assert "elbow:" not in text and ": the elbow" not in text


@pytest.mark.examples
@every_browser
def test_what_readers_type_is_found(program, tmp_path):
    """Ordinals, names of links and letters by name are known; a word that is nowhere is said and left out."""
    file = tmp_path / "page.html"
    file.write_text(shown("ella"), encoding="utf-8")
    guide = re.findall(r'<tr id="guide-(\w+)"[^>]*>(.*?)</tr>', body("ella"))
    links = {name: re.findall(r'href="#([^"]+)"', cells) for name, cells in guide}
    places = {f"{{bias {name}}}": found[2] for name, found in links.items()}
    places["{matrix}"] = re.search(r'<h2 id="(s\d+)">\d+\. Mass matrix', body("ella"))[1]
    places["{gravity}"] = re.search(r'id="([^"]+)" data-find="gravity', body("ella"))[1]
    places["{payload}"] = re.search(r'id="([^"]+)" data-find="payload', body("ella"))[1]
    places["{shape}"] = re.search(r'id="([^"]+)" data-find="[^"]*shape of mode 2\b', body("ella"))[1]
    places["{first}-M_D"] = f"{first_class()}-M_D"
    places["{eta}"] = re.search(r'<tr id="(y\d+)"><td><math><msub[^>]*><mi>\U0001d73c<', body("ella"))[1]
    with started(program, tmp_path) as browser:
        browser.open(file)
        for words, expected in SEARCHES.items():
            browser.run(f"find.value = {words!r}; search()")
            hits = browser.run("[...document.querySelectorAll('#found a')].map(a => a.getAttribute('href').slice(1))")
            assert tuple(hits[: len(expected)]) == tuple(places.get(place, place) for place in expected), words
            said = browser.run("$('#found .none').filter(x => x.offsetHeight).map(x => x.textContent).join()")
            assert said == ("nowhere: rudder" if "rudder" in words else ""), words
        browser.run("find.value = 'elbow torque'; search(); document.querySelector('#found a').click()")
        assert browser.run("byId('torque-forearm').getBoundingClientRect().height") > 5
        browser.run("tell(document.querySelector('#torque-forearm [data-l]'))")
        assert "of link forearm" in browser.run("words(card)")
        browser.run(
            f"go('{first_class()}-M_D'); tell(document.querySelector('#{first_class()}-M_D .formula [data-s]'))"
        )
        told = browser.run("words(card)")
        assert all(part in told for part in ("unit kg, kg\u00a0m", "frame \u2131i", "shape 6\u00d7")), told
        for place, said in ENTRIES.items():
            browser.run(f"tellEntry(byId('{place}'))")
            assert all(part in browser.run("words(card)") for part in said), place


BOLD = "\U0001d400"
"""The first of the letters that are bold."""
LARGE = ("soft_gripper", "tentacle")
INDICES = {"i", "j", "k", "c", ";", "…"}
FORMULA = r'<div class="formula[^"]*" id="[^"]*">(<math>.*?</math>)</div>\s*(?:<p[^>]*>(.*?)</p>)?'


@pytest.mark.parametrize("name", swept(EXAMPLES, *(name for name in EXAMPLES if name not in LARGE)))
def test_every_symbol_of_the_first_formulas_has_a_card(name):
    """Of the first five, but for indices, and for plain letters of a law, which the text beside it or the table has."""
    shown = body(name)
    table = {
        x.strip() for row in re.findall(r'<tr id="y\d+"><td>(.*?)</td>', shown) for x in re.findall(r"<mi>(.*?)</", row)
    }
    formulas = [*re.finditer(FORMULA, shown, re.DOTALL)][:5]
    assert len(formulas) == 5
    for formula in formulas:
        before = shown[: formula.start()].rpartition("<p")[2]
        said = {x.strip() for x in re.findall(r"<mi>([^<]*)</mi>", before + (formula[2] or ""))}
        assert set(unmarked(ElementTree.fromstring(formula[1]))) - INDICES <= {
            x for x in said | table if len(x) == 1 and x.islower() and x < BOLD
        }


def unmarked(element: ElementTree.Element) -> Iterator[str]:
    """The letters below an element that point to no row of the table of symbols."""
    if element.get("data-s") is None:
        if element.tag == "mi":
            yield element.text.strip()
        scripted = element.tag in ("msub", "msup", "msubsup", "munder", "munderover")
        for part in list(element)[:1] if scripted else element:
            yield from unmarked(part)
