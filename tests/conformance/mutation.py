"""What a mutant is: a small change of one place of one text of the product."""

from __future__ import annotations

from typing import NamedTuple

ALGORITHMS, C, BODIES = "screwgen/algorithms/", "templates/c/", "screwgen/bodies/"
INTERACTIONS = "screwgen/interactions/"
HELD, INTERNAL, LOOPED, PRESCRIBED, BRAKED, COMPLIANT, PARAMETERS = (
    f"templates/c/features/{name}.jinja"
    for name in ("held", "internal", "loops_in_estimator", "prescribed", "brakes", "compliant", "parameter_states")
)


class Mutant(NamedTuple):
    """``old`` occurs once in the file, and ``new`` takes its place."""

    feature: str
    consumer: str
    file: str
    old: str
    new: str

    def __str__(self) -> str:
        return f"{self.feature} × {self.consumer} ({self.file.rpartition('/')[2]})"

    def applied(self, text: str) -> str:
        assert text.count(self.old) == 1, f"{self}: {self.old!r} occurs {text.count(self.old)} times"
        return text.replace(self.old, self.new)
