"""Listed: numbers whose names the C++ side lists."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, ClassVar, TypeVar

__all__ = ["Listed"]

Number = TypeVar("Number", bound=float)


class Listed(tuple[Number, ...]):
    """A named tuple with the fields of a list: name, unit and meaning of each."""

    __slots__ = ()

    _fields: ClassVar[tuple[str, ...]]

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Number: ...

    def __init_subclass__(cls, *, fields: list[tuple[str, str, str]]) -> None:
        cls._fields = tuple(name for name, _, _ in fields)
        for place, (name, unit, meaning) in enumerate(fields):
            text = f"{meaning[0].upper()}{meaning[1:]}{', in ' + unit if unit else ''}."
            setattr(cls, name, property(operator.itemgetter(place), doc=text))

    def __new__(cls, *numbers: Number) -> Listed[Number]:
        return super().__new__(cls, numbers)

    def __getnewargs__(self) -> tuple[Number, ...]:
        return tuple(self)

    def _asdict(self) -> dict[str, Number]:
        return dict(zip(self._fields, self, strict=True))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value}' for name, value in self._asdict().items())})"
