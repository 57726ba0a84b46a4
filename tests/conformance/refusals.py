"""What is refused: by check, the features of which a robot makes it refuse, and the words that it then says.

A refusal is part of the product: it has one line, and stands here with its reason. A check that refuses without an
entry fails, and so does an entry whose check does not refuse.
"""

from __future__ import annotations

from typing import NamedTuple


class Refusal(NamedTuple):
    """``check`` refuses robots with all of ``features`` and says ``words``; ``why``: the reason, for the table.

    ``large``: it depends on the size of the robot, so that some are not refused.
    """

    check: str
    features: tuple[str, ...]
    words: str
    why: str
    large: bool = False


LOOPED = ("ball loop", "hinge loop", "slide loop", "welded loop", "coupling")
TWISTED = ("elastic cylinder", "elastic four-bar")
NOT_PLANNED = ("floating", "afloat", "moving", "accelerated", "ball", "bristles", "Dahl", "limited rate", *LOOPED)
NOT_PLANNED += ("winch",)
NOT_PREDICTED = (
    "floating",
    "afloat",
    "ball",
    "elastic gear",
    "loaded friction",
    "cylinder",
    "four-bar",
    "limited rate",
    *TWISTED,
    *LOOPED,
)
REFUSALS: tuple[Refusal, ...] = (
    Refusal("C, fused", (), "would be one function of", "compilers take long over one function so large", large=True),
    *(
        refusal
        for check in ("acados", "acados, DAE form")
        for refusal in (
            Refusal(check, ("ball",), "there is no acados model", "its states add up, quaternions do not"),
            Refusal(check, (), "whose unknowns must be unique", "rows of loops share forces", large=True),
        )
    ),
    *(
        Refusal("acados, DAE form", (x,), "the DAE has no differential equations", "rates of such rotors need the rows")
        for x in ("elastic cylinder", "elastic four-bar")
    ),
    Refusal("URDF", ("screw",), "URDF has no joint that turns and travels at once", "URDF has no screws"),
    Refusal("URDF", ("ball",), "is a ball joint, which URDF does not have", "URDF has no ball joints"),
    *(
        Refusal(check, (line, base), words, "a line to the world pulls a base that floats")
        for line in ("rope", "winch")
        for base in ("floating", "afloat")
        for check, words in (("equilibrium", "on the floating base"), ("modes", "forces between it and the world pull"))
    ),
    *(
        Refusal(check, ("contact", base), words, "what touches the world pushes a base that floats", large=True)
        for base in ("floating", "afloat")
        for check, words in (("equilibrium", "on the floating base"), ("modes", "forces between it and the world pull"))
    ),
    Refusal(
        *("modes", ("second order", "rope"), "is not positive definite"),
        why="without gravity the rope bends a link of second order farther than its model goes",
        large=True,
    ),
    *(
        Refusal(
            check,
            ("four-bar", "rope"),
            "no posture found balances its load",
            why="a rope pulls it to its end",
            large=True,
        )
        for check in ("equilibrium", "modes")
    ),
    *(
        Refusal(
            "predictive control",
            (x,),
            "predictive control in C is not made for them",
            "its plan has no rows of loops, balls or gears that twist",
        )
        for x in NOT_PREDICTED
    ),
    Refusal(
        *("plan", ("limited",), "to rest there takes"),
        why="a drive whose limit does not hold the weight of its arm has no plan",
        large=True,
    ),
    Refusal(
        *("plan", ("loaded friction", "three axes"), "brings the arm to no rest"),
        why="the fast search does not settle where friction by load of several axes acts",
        large=True,
    ),
    *(Refusal("plan", (x,), "for which there is no plan", "plans are of arms with a drive each") for x in NOT_PLANNED),
)


def refusals_of(check: str, features: tuple[str, ...]) -> list[Refusal]:
    """The refusals that a robot with these features meets in a check."""
    return [x for x in REFUSALS if x.check == check and set(x.features) <= set(features)]
