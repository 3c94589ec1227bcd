"""What planners, smoothers and controllers there are, and their options."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from . import _core

__all__ = ["ControllerInfo", "OptionInfo", "PlannerInfo", "SmootherInfo", "controllers", "planners", "smoothers"]


class OptionInfo(NamedTuple):
    """An option of a planner, a smoother or a controller."""

    name: str
    kind: str
    """"flag", "integer", "number" or "choice"."""
    default: str
    choices: tuple[str, ...]
    """Of a choice."""
    least: float
    greatest: float
    """The range of an integer or a number."""
    help: str
    """One line, with the unit."""


class PlannerInfo(NamedTuple):
    """A planner: how it works, what it guarantees, and its options."""

    name: str
    summary: str
    idea: str
    paper: str
    guarantee: str
    """"none", "complete", "fewest steps", "bounded" or "optimal"."""
    guarantee_text: str
    time: str
    memory: str
    when: str
    """When to choose it."""
    terrain: bool
    """Does it take the costs of cells into account?"""
    any_angle: bool
    """Are its paths lines at any angle, not steps between neighbours?"""
    headings: bool
    """Do its states have headings?"""
    preprocessing: str
    """"none", "quick" (seconds) or "slow" (minutes), before the first query."""
    needs_index: bool
    """Does it need an ``Index``?"""
    options: tuple[OptionInfo, ...]


class SmootherInfo(NamedTuple):
    """A smoother, see ``Plan.smooth()``."""

    name: str
    summary: str
    paper: str
    options: tuple[OptionInfo, ...]


class ControllerInfo(NamedTuple):
    """A controller, see ``wend.follow()``."""

    name: str
    summary: str
    idea: str
    paper: str
    options: tuple[OptionInfo, ...]


def _with_options(entry: Mapping[str, Any]) -> dict[str, Any]:
    return {**entry, "options": tuple(OptionInfo(**option) for option in entry["options"])}


def planners() -> tuple[PlannerInfo, ...]:
    """All planners.

    >>> import wend
    >>> [planner.name for planner in wend.planners()][:2]
    ['astar', 'dijkstra']
    """
    return tuple(PlannerInfo(**_with_options(entry)) for entry in _core.planners())


def smoothers() -> tuple[SmootherInfo, ...]:
    """All smoothers.

    >>> import wend
    >>> [smoother.name for smoother in wend.smoothers()]
    ['gradient', 'curvature', 'drive']
    """
    return tuple(SmootherInfo(**_with_options(entry)) for entry in _core.smoothers())


def controllers() -> tuple[ControllerInfo, ...]:
    """All controllers.

    >>> import wend
    >>> "pid" in [controller.name for controller in wend.controllers()]
    True
    """
    return tuple(ControllerInfo(**_with_options(entry)) for entry in _core.controllers())
