"""What acts on the axes of joints, by the formulas of a document."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np
from document_symbols import Printed, plain
from latex_formula import value

KINDS = {
    "given": "A rotor whose motion is given",
    "elastic": "A drive whose gear is elastic",
    "geared": "with the gear's stiffness",
    "rigid": "A rigid gear adds",
    "stop": "A stop at the limit",
    "cylinder": "A cylinder of length",
    "four-bar linkage": "A four-bar linkage joins",
    "derivatives": "holds in every posture. Of its two",
    "ahead": "Where the gear of such a drive is elastic",
    r"\sigma_0": r"Dry friction with $\sigma_0$",
    r"\sigma_d": r"Dry friction with $\sigma_d$",
    "effort_rate": "Of the input of an axis with limits of the rate",
    "brake": "A brake whose input is",
    "braked": "The brake of an elastic drive",
}
"""By what the text of each kind begins."""
FRICTION = plain(r"\tau_f")
LETTERS = {"cylinder": ("l", "F"), "four-bar linkage": (r"\psi", r"\tau_c")}


@dataclass
class Axis:
    """An axis of a joint: what the document states of it, and its state."""

    name: str
    number: int
    numbers: dict[str, float]
    """By the symbols of the drive, of its limits and elements; `q_s` by `lower` and `upper`."""
    limits: dict[str, float]
    elements: dict[str, dict[str, float]]
    transmission: str
    side: float
    said: dict[str, list]
    words: dict[str, str]
    q: float = 0.0
    qdot: float = 0.0
    tau: float = 0.0
    added: float = 0.0
    added_rate: float = 0.0
    states: dict[str, float] = field(default_factory=dict)
    """Internal states, by the kind of what has them."""
    rates: dict[str, float] = field(default_factory=dict)
    brake: dict[str, float] = field(default_factory=dict)
    """The numbers of its brake and its input, by their symbols; none without a brake."""
    given: bool = False
    """Whether its motion is given, of an elastic drive that of its rotor."""
    known: dict[str, float] = field(default_factory=dict)

    @property
    def elastic(self) -> bool:
        return "k" in self.numbers

    @property
    def driven(self) -> bool:
        return bool(self.numbers) or bool(self.transmission)

    def read(self, text: str, more: dict[str, float]) -> float:
        """The value of a formula of scalars."""
        every = {"q": self.q, r"\dot{q}": self.qdot, r"\tau": self.tau, **self.numbers, **self.known, **more}

        def known(name: str):
            return np.full((1, 1), every[plain(name)])

        return float(value(text, known).item())

    def formula(self, kind: str, left: str, sign: str = "=") -> str:
        return next(right for x, s, right in self.said[kind] if x == plain(left) and s == sign)

    def prepare(self) -> None:
        """Travel and friction in the state."""
        drive = {"N": 1.0, "J_r": 0.0, "d": 0.0, "b": 0.0, "c": 0.0, "v_f": 1.0, "c_b": 0.0, "v_b": 1.0}
        self.known = {name: x for name, x in drive.items() if name not in self.numbers}
        if self.transmission:
            letter, _ = LETTERS[self.transmission]
            self.known |= {name: self.tau for _, name in LETTERS.values()}
            part = "derivatives" if letter == r"\psi" else self.transmission
            if letter == r"\psi":
                self._crank()
            else:
                self.known[letter] = self.read(self.formula(part, letter), {})
            for primes in ("'", "''"):
                self.known[letter + primes] = self.read(self.formula(part, letter + primes), {})
                self.known |= {other + primes: self.known[letter + primes] for other, _ in LETTERS.values()}
            if self.elastic:
                self.known |= {"e": self.added, r"\dot{e}": self.added_rate}
            w = self.read(self.formula("ahead" if self.elastic else part, "w"), {})
        elif self.elastic:
            self.known |= {r"\vartheta": self.added, r"\dot{\vartheta}": self.added_rate}
            w = self.added_rate
        else:
            w = self.qdot
        if self.driven:
            self.known["w"] = w
            kind = next((letter for letter in (r"\sigma_0", r"\sigma_d") if letter in self.numbers), "")
            own = {} if kind else self._size("elastic")
            self.known[FRICTION] = self._bristles(kind) if kind else self.read(self.formula("elastic", r"\tau_f"), own)
        if "effort_rate" in self.states:
            own = self.limits | {"z": self.states["effort_rate"]}
            self.rates["effort_rate"] = self.read(self.formula("effort_rate", r"\dot{z}"), own)

    def _size(self, kind: str) -> dict[str, float]:
        """The size of dry friction, where the text has a letter for it."""
        found = next((right for x, _, right in self.said[kind] if x == "F_w"), None)
        if found is None:
            return {}
        unstated = {"F_s": self.numbers.get("c", 0.0), "w_s": 1.0, plain(r"\mu_J"): 0.0}
        return {"F_w": self.read(found, unstated | {"k": 0.0, plain(r"\vartheta"): self.added} | self.numbers)}

    def _bristles(self, kind: str) -> float:
        """Friction that has an internal state, whose rate follows."""
        unstated = {r"\sigma_1": 0.0, r"\delta_d": 0.0}
        own = {"z": self.states["friction"]} | unstated | self.numbers | self._size(kind)
        own[r"\dot{z}"] = self.rates["friction"] = self.read(self.formula(kind, r"\dot{z}"), own)
        return self.read(self.formula(kind, r"\tau_f"), own)

    def _crank(self) -> None:
        self.known |= {"u": self.q + self.numbers[plain(r"\beta_0")], plain(r"\sigma"): self.side}
        found = re.findall(r"\$(\w_0) = ([^$]*)\$", self.words["derivatives"])
        for name, text in found:
            self.known[name] = self.read(text, {})
        for name in ("D", "W", "H"):
            self.known[name] = self.read(self.formula("derivatives", name), {})
        cosine, sine = (self.read(self.formula("derivatives", rf"a_0\,\{f}\psi"), {}) for f in ("cos", "sin"))
        self.known[r"\psi"] = float(np.arctan2(sine, cosine))

    def effort(self) -> tuple[float, float, float, float]:
        """What acts on the axis, and what is added to its armature, stiffness and damping."""
        total, inertia, stiffness, damping = self.tau, 0.0, 0.0, 0.0
        if self.transmission and self.elastic:
            force = self.read(self.formula("ahead", "F_g"), {})
            total = self.read(self.formula("ahead", r"\tau_q"), {"F_g": force})
        elif self.transmission:
            part = "derivatives" if self.transmission != "cylinder" else "cylinder"
            total = self.read(self.formula(part, r"\tau_q"), {})
            inertia = self.read(self.formula(part, "j_m", r"\leftarrow"), {"j_m": 0.0})
        elif self.elastic:
            total = self.read(self.formula("geared", r"\tau_q"), {})
            stiffness = self.read(self.formula("geared", "k_q", r"\leftarrow"), {"k_q": 0.0})
            damping = self.read(self.formula("geared", "d_q", r"\leftarrow"), {"d_q": 0.0})
        elif self.driven:
            total = self.read(self.formula("rigid", r"\tau_q"), {})
            inertia = self.read(self.formula("rigid", "j_m", r"\leftarrow"), {"j_m": 0.0})
        for side, name in ((1.0, "upper"), (-1.0, "lower")):
            if name in self.limits and "k_s" in self.limits:
                total = self._stopped(total, side, self.limits[name])
        for kind, numbers in self.elements.items():
            own = dict(numbers)
            if kind in self.states:
                own["z"] = self.states[kind]
                own[r"\dot{z}"] = self.rates[kind] = self.read(self.formula(kind, r"\dot{z}"), own)
            force = self.read(self.formula(kind, r"\tau_e"), own)
            total = self.read(self.formula(kind, r"\tau_q", r"\leftarrow"), {r"\tau_q": total, r"\tau_e": force})
        return total, inertia, stiffness, damping

    def _stopped(self, total: float, side: float, at: float) -> float:
        own = {"k_s": self.limits["k_s"], "d_s": self.limits.get("d_s", 0.0), "q_s": at, r"\sigma_s": side}
        own["p"] = self.read(self.formula("stop", "p"), own)
        own[r"\dot{p}"] = self.read(self.formula("stop", r"\dot{p}"), own)
        push = self.read(self.formula("stop", r"\tau_s"), own) if own["p"] > 0 else 0.0
        return self.read(self.formula("stop", r"\tau_q", r"\leftarrow"), own | {r"\tau_s": push, r"\tau_q": total})

    def rotor(self) -> float:
        """The acceleration of the rotor behind an elastic gear."""
        if self.given:
            return self.read(self.formula("given", r"\ddot{\vartheta}"), {})
        torque = self.read(self.formula("elastic", r"\tau_J"), {})
        right = self.read(self.formula("elastic", r"J_r\,\ddot{\vartheta}"), {r"\tau_J": torque})
        free = right / self.numbers["J_r"]
        if not self.brake:
            return free
        own = self._grip() | {r"\ddot{\vartheta}_o": free}
        own[r"\ddot{\vartheta}_b"] = self.read(self.formula("braked", r"\ddot{\vartheta}_b"), own)
        return self.read(self.formula("braked", r"\ddot{\vartheta}"), own)

    def _grip(self) -> dict[str, float]:
        """What its brake leaves of the balance, and with what inertia it holds."""
        own = dict(self.brake)
        for name in (r"\sigma_b", "j_b"):
            own[name] = self.read(self.formula("brake", name), own)
        return own

    def held(self) -> tuple[float, float, float]:
        """Share, inertia and stopping acceleration of the axis; where it is elastic the brake is the rotor's."""
        if not self.brake or self.elastic:
            return 1.0, 0.0, 0.0
        own = self._grip()
        return own[r"\sigma_b"], own["j_b"], self.read(self.formula("brake", r"\ddot{q}_b"), own)

    def ahead(self, qddot: float, eddot: float) -> float:
        """What is left of the equation of a rotor that is ahead of a travel."""
        force = self.read(self.formula("ahead", "F_g"), {})
        left, right = next((x, y) for x, s, y in self.said["ahead"] if x.startswith("J_r"))
        more = {r"\ddot{q}": qddot, r"\ddot{e}": eddot, "F_g": force}
        return self.read(left, more) - self.read(right, more)


def axes_of(document: Printed, link: str, count: int) -> list[Axis]:
    """The axes of a link's joint."""
    acting = [said for p in document.sections["Algorithm"] for said in p.said]
    said: dict[str, list] = {}
    words: dict[str, str] = {}
    for kind, start in KINDS.items():
        for text, found in acting:
            if text.startswith(start):
                said[kind], words[kind] = found, text
    chosen = {row[0].split("`")[1]: row for row in document.table("axis")}
    out = []
    for k in range(count):
        numbers, limits, elements, brake = {}, {}, {}, {}
        for name, (symbol, x) in document.parameters.items():
            rest = name.removeprefix(f"{link}.joint.")
            if rest == name:
                continue
            if rest.startswith(f"drives[{k}]"):
                numbers[symbol] = x
            elif rest.startswith(f"limits[{k}]"):
                limits[rest.rpartition(".")[2] if symbol == "q_s" else symbol] = x
            elif rest.startswith(f"brake[{k}]"):
                brake[symbol] = x
            elif rest.startswith(f"elements[{k}]"):
                elements.setdefault(rest.split(".")[1], {})[symbol] = x
        for kind in elements:
            said[kind] = next(found for text, found in acting if "From what acts on an axis with" in text)
        row = next((row for name, row in chosen.items() if name in (f"{link}.joint[{k}]", f"{link}.slide[{k}]")), None)
        transmission, side = (row[2], "".join(row[3:]).strip("$") or "–") if row else ("", "–")
        if row:
            numbers.setdefault("J_r", 0.0)
        sign = 0.0 if side == "–" else float(side)
        out.append(Axis(link, k, numbers, limits, elements, transmission, sign, said, words))
        out[-1].brake = brake
        out[-1].given = any(x[2] == f"`{link}.acceleration[{k}]`" for x in document.table("in $\\mathbf{u}$"))
    return out
