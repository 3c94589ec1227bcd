"""Arguments as the C++ side takes them: arrays of numbers, options as text, lists of goals."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from ._errors import InvalidArgument

Pose = Union[Sequence[float], npt.NDArray[Any]]
"""(x, y) or (x, y, heading): metres and radians in the frame of the map."""


MOST_THREADS = 256


def numbers_of(array: npt.ArrayLike, name: str) -> npt.NDArray[Any]:
    """The array itself if C++ can read it, which is the case for bool, int, uint, float32 and float64 of any strides.

    Others become float64 (float16, foreign byte order), or are refused with `name`, the argument's.
    """
    if isinstance(array, np.ma.MaskedArray):
        message = f"{name} is a masked array, whose mask would be lost: fill it first, for example {name}.filled(-1)"
        raise InvalidArgument(message, "invalid_map", name)
    try:
        numbers = np.asarray(array)
    except (TypeError, ValueError) as error:
        raise InvalidArgument(f"{name} is not an array: {error}", "invalid_map", name) from error
    if numbers.dtype.kind not in "biuf":
        raise InvalidArgument(
            f"{name} has the type {numbers.dtype}: it must have numbers or booleans", "invalid_map", name
        )
    exotic = not numbers.dtype.isnative or (numbers.dtype.kind == "f" and numbers.dtype.itemsize not in (4, 8))
    return numbers.astype(np.float64) if exotic else numbers


def text_of(options: Mapping[str, object]) -> dict[str, str]:
    """Options as C++ reads them."""
    text = {}
    for name, value in options.items():
        if not isinstance(name, str):
            raise InvalidArgument(f"names of options are strings, not {type(name).__name__}")
        if isinstance(value, (bool, np.bool_)):
            text[name] = "true" if value else "false"
        elif isinstance(value, str):
            text[name] = value
        elif isinstance(value, (int, np.integer)):
            text[name] = str(int(value))
        elif isinstance(value, (float, np.floating)):
            text[name] = repr(float(value))
        else:
            raise InvalidArgument(
                f"{name} must be a number, a boolean or a string, not {type(value).__name__}", "invalid_option", name
            )
    return text


def goals_of(goal: Pose | Iterable[Pose]) -> list[Any]:
    """A list of goals from one or more."""
    if isinstance(goal, tuple) and goal and isinstance(goal[0], (int, float)):
        return [goal]
    try:
        goals = list(goal)
    except TypeError as error:
        message = "goal must be (x, y), (x, y, heading) or a list of them"
        raise InvalidArgument(message, "invalid_option", "goal") from error
    return goals if goals and not np.isscalar(goals[0]) else [goals]


def checked_threads(threads: int) -> int:
    """A number of threads; 0 is as many as the machine runs at once."""
    if not 0 <= threads <= MOST_THREADS:
        raise InvalidArgument(f"threads must be from 0 to {MOST_THREADS}", "invalid_option", "threads")
    return threads
