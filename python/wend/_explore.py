"""explore(): a simulated robot drives over a map that it does not know."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from ._arrays import Pose, text_of
from ._map import Map
from ._space import FreeSpace
from ._types import named_types

__all__ = ["Exploration", "explore"]


class Exploration(NamedTuple):
    """A drive over a map that the robot did not know. ``explore()`` makes it."""

    status: str
    """"found" if the robot arrived, else why its last plan failed: "unreachable", "goal_blocked", ..."""
    reason: str
    """The same in words; empty if it arrived."""
    cells: npt.NDArray[np.int32]
    """The cells that it drove over: shape (n, 2), columns x and y."""
    cost: float
    """What the drive cost on the true map, in cells times terrain."""
    plans: int
    """How often it planned."""
    expanded: int
    """The states that all searches expanded."""
    first_seconds: float
    """CPU time of the first plan, with making the planner."""
    planning_seconds: float
    """CPU time of all plans."""
    worst_seconds: float
    """CPU time of the longest plan but the first."""
    known: Map
    """The map as the robot knows it in the end; what it has not seen is unknown."""

    @property
    def arrived(self) -> bool:
        """Did the robot reach the goal?"""
        return self.status == "found"


@named_types
def explore(
    space: FreeSpace,
    start: Pose,
    goal: Pose,
    planner: str = "replanner",
    *,
    sensor_range: float | None = None,
    known: Map | None = None,
    replan: Literal["path", "discovery"] = "path",
    keep: float = 0,
    **options: object,
) -> Exploration:
    """Drives the robot of a space from start to goal without knowing the map. It takes what it has not seen for free,
    looks around with a laser scanner before each step, and plans again where it has to. Ctrl-C stops it. The space does
    not change.

    :param planner: a name from ``wend.planners()`` that steps from cell to cell; `options` are its options.
    :param sensor_range: of the scanner in metres; None: 5 m, or 30 cells if the map has no resolution.
    :param known: what the robot believes at first, of the same size; None: it knows nothing.
    :param replan: when it plans again: "path", if its path is blocked or costs more; "discovery", after every discovery
        that is not as it believed.
    :param keep: when it plans again: by which share another path must be cheaper than what is left of the last one.
    :raises ValueError: an end is outside of the map, or an argument has a wrong value.
    :raises wend.Error: the start is blocked.

    >>> import wend
    >>> space = wend.Map([[0, 0, 0], [1, 1, 0], [0, 0, 0]]).free_space()
    >>> drive = wend.explore(space, (0, 0), (0, 2), sensor_range=1)
    >>> drive.arrived, drive.plans, drive.cells.tolist()[-1]
    (True, 2, [0, 2])
    """
    core = None if known is None else known._inner
    result = space._inner.explore(start, goal, planner, text_of(options), sensor_range, core, replan, keep)
    result["known"] = Map._of(result["known"])
    return Exploration(**result)
