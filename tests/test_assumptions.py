"""What documents and generated C say of the model follows from the classes of the links."""

import re

import pytest
from helpers import arm, link, model_of

from screwgen.target_files import latex_files

WORDS = {
    1: ("must stay small against the length", "has no foreshortening"),
    2: ("foreshortening, centrifugal stiffening", "must stay moderate"),
    "exact": ("follow from them without expansion", "may be large"),
}
"""What is said of a link that bends, by its order: MODEL 7 and 11."""
CURVED = "without loads is curved or twisted"
SHEARS, NORMAL = "shear (Timoshenko)", "stay at right angles to the centreline (Euler-Bernoulli)"


def texts(robot: dict) -> dict[str, str]:
    """What a reader meets: the document in both forms, the header and the README of the C, in one line each."""
    model = model_of(robot)
    files = latex_files(model.robot, ()) | model.c_files()
    chosen = {name: files[name].decode() for name in ("robot.tex", "robot.html", "robot.h", "README.md")}
    return {name: " ".join(re.sub(r"\n \*", " ", text).split()) for name, text in chosen.items()}


@pytest.mark.parametrize(
    ("order", "shears", "rest"), [(1, True, 0), (2, False, 0), ("exact", True, 0), ("exact", False, 1)]
)
def test_every_text_says_what_the_links_leave_out_and_nothing_else(order, shears, rest):
    modes = {"bending_y": 1} | ({"shear_y": 1} if shears else {})
    section = {"EIz": 20.0} | ({"GAy": 900.0, "rhoIz": 1e-3} if shears else {})
    curved = {"rest": {"bending_y": 0.5}} if rest else {}
    robot = arm(link("boom", modes=modes, section=section, order=order, **curved)) | {"name": "robot"}
    of_others = [words for other, said in WORDS.items() if other != order for words in said]
    for name, text in texts(robot).items():
        missing = [words for words in (*WORDS[order], (NORMAL, SHEARS)[shears], *[CURVED] * rest) if words not in text]
        wrong = [words for words in (*of_others, (SHEARS, NORMAL)[shears], *[CURVED] * (not rest)) if words in text]
        assert (missing, wrong) == ([], []), name
