"""The base class of all parts of a robot: frozen, no unknown keys, readable errors."""

from typing import Any

from pydantic import BaseModel, ConfigDict, ValidationError

from ..errors import RobotFileError
from .messages import explain, sound
from .stated import stated_numbers


class Part(BaseModel):
    """A frozen, validated piece of a robot; equal parts compare and hash equal.

    Raises RobotFileError, one line, where the arguments are wrong.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    def __init__(self, /, **data: Any) -> None:
        try:
            super().__init__(**data)
        except ValidationError as error:
            raise RobotFileError(f"{self._title(data)}: {explain(error, type(self), data)}") from None

    # Nested parts are then validated in place, not by this constructor: an error keeps its whole path.
    setattr(__init__, "__pydantic_base_init__", True)  # noqa: B010

    @classmethod
    def __pydantic_init_subclass__(cls, **kwargs: Any) -> None:
        """The numbers of a table say what they are."""
        for name, number in stated_numbers(cls):
            cls.model_fields[name].description = number.text

    @classmethod
    def _title(cls, data: dict[str, Any]) -> str:
        """`Link forearm`: which part was being built."""
        name = data.get("name")
        return f"{cls.__name__} {name}" if sound(name) else cls.__name__
