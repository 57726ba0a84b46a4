"""The keys of transmissions as fields of a robot file: their meanings and units are those that their kinds state."""

from typing import Annotated, Any

from pydantic import Field, PlainValidator

from ..elements import Key
from .ranges import within

Length = Annotated[float, PlainValidator(within("length"))]
Turn = Annotated[float, PlainValidator(within("turn"))]


def stated(key: Key, more: str = "", **given: Any) -> Any:
    """A field; ``more`` is added to its description."""
    positive = ", > 0" if key.sign == "positive" else ""
    return Field(description=f"{key.meaning}, {key.unit}{positive}{more}", **given)
