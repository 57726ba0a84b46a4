"""Functions of a robot by name, each made when it is first asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

from ..algorithms.robot_functions import BY_NAME
from ..arguments import choice
from ..notebook import code, markdown_table, plain


class LazyFunctions(Mapping):
    """Values by name, each made when it is first asked for."""

    def __init__(self, makers: Mapping[str, Callable[[], object]]):
        self._makers = makers
        self._made: dict[str, Any] = {}

    def joined(self, makers: Mapping[str, Callable[[], object]]) -> LazyFunctions:
        """These values, which are not made again, and others."""
        return LazyFunctions({name: partial(self.__getitem__, name) for name in self} | dict(makers))

    def __getitem__(self, name: str) -> Any:
        if name not in self._made:
            choice(name, self._makers, "there is no function")
            self._made[name] = self._makers[name]()
        return self._made[name]

    def __contains__(self, name: object) -> bool:
        return name in self._makers

    def __iter__(self) -> Iterator[str]:
        return iter(self._makers)

    def __len__(self) -> int:
        return len(self._makers)

    def __repr__(self) -> str:
        return f"Functions({', '.join(self)})"

    def _repr_markdown_(self) -> str:
        """What the functions take and return; the parameters `p` come last."""
        known = (BY_NAME[name] for name in self if name in BY_NAME)
        rows = [
            (code(f"{row.name}({', '.join(row.names)}, p)"), ", ".join(map(code, row.results)), plain(row.about))
            for row in known
        ]
        others = ", ".join(code(name) for name in self if name not in BY_NAME)
        return f"{markdown_table(('function', 'results', 'what'), rows)}\nOthers: {others}\n"
