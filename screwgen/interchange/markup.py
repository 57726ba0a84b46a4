"""XML as elements that know their line, so that every fault of a file can be named.

The parser is expat, without namespaces: tags of extensions, `gazebo:…` or `drake:…`, are often used without being
declared, and are then names like any others.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

from ..errors import RobotFileError
from ..spec.load import one_line
from ..spec.ranges import RANGES, Range
from ..spec.values import number, quoted

MAX_DEPTH = 64
LATE_DECLARATION = re.compile(rb"\A(\xef\xbb\xbf)?(\s+)(<\?xml\s.*?\?>)", re.DOTALL)
"""An XML declaration behind blank lines, which expat refuses; put in front of them every line keeps its number."""
TO_EXPAND = ("${", "$(")
"""What only xacro understands in attributes."""
ALLOWED = RANGES | {"any limit": Range(number, 0.0, 1e300, "in SI units")}
"""The ranges of a robot file; limits of a URDF may be so far that they mean none."""


@dataclass
class Element:
    """A tag with its attributes, children and text, and the line of the file where it stands."""

    file: str
    line: int
    tag: str
    attributes: dict[str, str]
    children: list[Element] = field(default_factory=list)
    text: str = ""
    owner: str = ""
    """The link, joint or transmission to which the element belongs, as messages name it: `joint 'elbow'`."""

    def all(self, *tags: str) -> list[Element]:
        """The children with one of these tags."""
        return [child for child in self.children if child.tag in tags]

    def only(self, tag: str) -> Element | None:
        """The one child with this tag, if there is one; a second is refused."""
        found = self.all(tag)
        if len(found) > 1:
            raise found[1].fault("is stated twice; leave one of them out")
        return found[0] if found else None

    def needed(self, tag: str, remedy: str) -> Element:
        """The one child with this tag; its absence is refused."""
        found = self.only(tag)
        if found is None:
            raise self.fault(f"has no <{tag}>; {remedy}")
        return found

    def walk(self) -> Iterator[Element]:
        """The element and all below it."""
        yield self
        for child in self.children:
            yield from child.walk()

    def fault(self, what: str, attribute: str = "") -> RobotFileError:
        """The error of this element, or of its attribute: `<file>: line 12: joint 'elbow': axis xyz: <what>`."""
        place = " ".join(filter(None, ("" if self.heads else self.tag, attribute)))
        parts = (self.file, f"line {self.line}", self.owner or f"<{one_line(self.tag)}>", one_line(place), what)
        return RobotFileError(": ".join(filter(None, parts)))

    @property
    def heads(self) -> bool:
        """Whether the element is the link or joint itself."""
        return not self.owner or self.owner.startswith(f"{self.tag} ")

    def string(self, attribute: str) -> str:
        """An attribute that must be there and hold something."""
        value = self.attributes.get(attribute, "").strip()
        if not value:
            raise self.fault(f'is missing or empty; state {attribute}="…"', attribute)
        return value

    def numbers(self, attribute: str, size: int, quantity: str, default: str | None = None) -> list[float]:
        """Numbers of an attribute, each in the range of `quantity` of a robot file."""
        text = self.attributes.get(attribute, default)
        if text is None:
            raise self.fault(f'is missing; state {attribute}="…"', attribute)
        return self._read(text, attribute, size, quantity)

    def number(self, attribute: str, quantity: str, default: str | None = None) -> float:
        """A number of an attribute."""
        return self.numbers(attribute, 1, quantity, default)[0]

    def content(self, quantity: str) -> float:
        """The number that is the element's text, or its attribute `value`."""
        text = self.text.strip() or self.attributes.get("value", "")
        return self._read(text, "", 1, quantity)[0]

    def _read(self, text: str, attribute: str, size: int, quantity: str) -> list[float]:
        words = text.split()
        if len(words) != size:
            what = "a number" if size == 1 else f"{size} numbers"
            raise self.fault(f"is {quoted(text)}; it must be {what}, {ALLOWED[quantity].text}", attribute)
        return [self._one(word, attribute, quantity) for word in words]

    def _one(self, word: str, attribute: str, quantity: str) -> float:
        try:
            value = float(word) if "_" not in word else None
        except ValueError:
            value = None
        if value is None:
            raise self.fault(f"is {quoted(word)}; it must be a number, {ALLOWED[quantity].text}", attribute)
        try:
            return ALLOWED[quantity].check(value) + 0.0
        except ValueError as error:
            raise self.fault(str(error), attribute) from None


class _Builder:
    """Collects the events of the parser."""

    def __init__(self, file: str):
        self.file, self.root = file, Element(file, 1, "", {})
        self.open = [self.root]
        self.parser = expat.ParserCreate()
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = lambda tag: self.open.pop()
        self.parser.CharacterDataHandler = self.data
        self.parser.StartDoctypeDeclHandler = self.doctype

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        above = self.open[-1]
        element = Element(self.file, self.parser.CurrentLineNumber, tag, attributes, owner=above.owner)
        if above.tag == "robot" and tag in ("link", "joint", "transmission"):
            element.owner = f"{tag} '{one_line(attributes.get('name', ''))}'"
        if tag.startswith("xacro:") or any(mark in value for value in attributes.values() for mark in TO_EXPAND):
            raise element.fault(f"is to be expanded by xacro; run `xacro {self.file} > robot.urdf` and name its output")
        if len(self.open) > MAX_DEPTH:
            raise element.fault("is nested too deeply; a URDF needs five levels")
        above.children.append(element)
        self.open.append(element)

    def data(self, text: str) -> None:
        self.open[-1].text += text

    def doctype(self, *declared: object) -> None:
        line = self.parser.CurrentLineNumber
        raise RobotFileError(f"{self.file}: line {line}: <!DOCTYPE> is not read; leave it out, with its entities")


def read_xml(content: bytes, file: str) -> Element:
    """The root element of a file."""
    builder = _Builder(file)
    try:
        builder.parser.Parse(LATE_DECLARATION.sub(rb"\1\3\2", content), True)
    except expat.ExpatError as error:
        what = one_line(expat.ErrorString(error.code))
        raise RobotFileError(f"{file}: line {error.lineno}: is not valid XML ({what}); mend it there") from None
    except (ValueError, LookupError) as error:  # an encoding that nobody knows
        raise RobotFileError(f"{file}: cannot be read ({one_line(str(error))}); save it in UTF-8") from None
    return builder.root.children[0]
