"""named_types(): arguments of a wrong type become errors that name them."""

from __future__ import annotations

import functools
import inspect
import os
import sys
from collections.abc import Callable, Iterable, Mapping
from typing import Any, ParamSpec, TypeVar

import numpy as np

from ._errors import InvalidArgument

__all__ = ["named_types"]

P = ParamSpec("P")
R = TypeVar("R")

# What annotations accept, and how to say it.
_TYPES: dict[str, tuple[Any, str]] = {
    "None": (type(None), "None"),
    "bool": (bool, "True or False"),
    "int": ((int, np.integer), "an integer"),
    "float": ((int, float, np.integer, np.floating), "a number"),
    "str": (str, "a string"),
    "Literal['": (str, "a string"),
    "CornerRule": (str, "a string"),
    "os.PathLike": (os.PathLike, "a path"),
    "Mapping": (Mapping, "a mapping"),
    "Sequence": (Iterable, "a sequence"),
    "Iterable": (Iterable, "a sequence"),
}
_LARGEST = 2**63


def named_types(function: Callable[P, R]) -> Callable[P, R]:
    """Costs nothing but a call: types are looked at when something has already failed because of them."""

    @functools.wraps(function)
    def checked(*args: P.args, **kwargs: P.kwargs) -> R:
        try:
            return function(*args, **kwargs)
        except InvalidArgument:
            raise
        except (TypeError, AttributeError, ValueError):
            refuse_types(function, args, kwargs)
            raise

    return checked


def refuse_types(function: Callable[..., Any], args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
    """Raises InvalidArgument for the first argument that is not what its annotation says. Annotations that
    are not in the table are not checked."""
    signature = inspect.signature(function)
    try:
        arguments = signature.bind(*args, **kwargs).arguments
    except TypeError:
        return  # missing, or one too many: Python has said it
    for name, value in arguments.items():
        annotation = signature.parameters[name].annotation
        accepted = [_accepted(choice) for choice in str(annotation).split(" | ")]
        if None in accepted:
            continue
        known = [choice for choice in accepted if choice is not None]
        if not any(isinstance(value, types) for types, _ in known):
            wanted = " or ".join(dict.fromkeys(words for _, words in known))
            raise InvalidArgument(f"{name} must be {wanted}, not {type(value).__name__}", "invalid_option", name)
        if isinstance(value, int) and abs(value) >= _LARGEST:
            raise InvalidArgument(f"{name} is {value}: too large", "invalid_option", name)


def _accepted(annotation: str) -> tuple[Any, str] | None:
    if annotation.startswith("Literal["):
        return _TYPES.get(annotation[:9].replace('"', "'"))
    name = annotation.partition("[")[0]
    public = getattr(sys.modules[__package__], name, None)
    return (public, f"a wend.{name}") if isinstance(public, type) else _TYPES.get(name)
