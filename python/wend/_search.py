"""The common interface of planners: search(), PlannerBase, and compare()."""

from __future__ import annotations

import abc
import time
from collections.abc import Iterable, Sequence
from typing import Any, Literal, NamedTuple, SupportsIndex, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import text_of
from ._errors import InvalidArgument
from ._progress import progress_bar
from ._types import named_types

__all__ = ["Comparison", "PlannerBase", "compare", "search"]

Index2 = Union[Sequence[SupportsIndex], npt.NDArray[np.integer[Any]]]
PathOrNone = Union[list[tuple[int, int]], None]


@named_types
def search(
    world_state: npt.ArrayLike,
    robot_pose: Index2,
    goal_pose: Index2,
    planner: str | PlannerBase = "astar",
    *,
    order: Literal["xy", "rc"] = "xy",
    connectivity: Literal[4, 8] = 4,
    escape: float = 0,
    closest: bool = False,
    **options: object,
) -> PathOrNone:
    """A path from a robot to a goal through a world of 0 (free) and 1 (obstacle), or None.

    :param world_state: any array-like of two dimensions; row 0 is y = 0. It is not changed. -1, unknown, is an
            obstacle too.
    :param robot_pose: (x, y): x is the column, y the row; the cell is ``world_state[y][x]``.
    :param goal_pose: the same.
    :param planner: "random", a walk whose memory is floor(sqrt(max_steps)) steps; a planner on cells from
        ``wend.planners()``; or a ``PlannerBase``. `options` are the planner's, such as `max_steps`.
    :param order: "rc": poses are (row, column), also in the result.
    :param connectivity: 4: orthogonal steps; 8: diagonal ones too, where they cut no corner.
    :param escape: if the robot is in an obstacle, the path begins with the shortest way out, at most this many cells
        long.
    :param closest: if no path reaches the goal, the path ends in the reachable cell nearest to it.
    :returns: the cells from robot to goal, both included; None if there is no path, if an end is an obstacle, or if
        the walk has used up its steps.
    :raises ValueError: a pose outside of the world, a value that is not 0, 1 or -1, an unknown planner or option.

    >>> import wend
    >>> world = [[0, 0, 0],
    ...          [1, 1, 0],
    ...          [0, 0, 0]]
    >>> wend.search(world, (0, 0), (1, 2))
    [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2)]
    >>> wend.search(world, (0, 0), (0, 1)) is None
    True
    """
    if isinstance(planner, PlannerBase):
        return planner.search(world_state, robot_pose, goal_pose)
    if order not in ("xy", "rc"):
        raise InvalidArgument(f"order is {order!r}: use 'xy' or 'rc'", "invalid_option", "order")
    if connectivity not in (4, 8):
        raise InvalidArgument(f"connectivity is {connectivity!r}: use 4 or 8", "invalid_option", "connectivity")
    settings = text_of(options) if options else {}
    return _core.search(
        world_state, robot_pose, goal_pose, planner, order == "rc", connectivity, escape, closest, settings
    )


class PlannerBase(abc.ABC):
    """A planner of your own: derive from this and implement ``search()``.

    It then takes part in ``wend.compare()``, and ``wend.testing.check_planner()`` tests it.

    >>> import wend
    >>> class Borrowed(wend.PlannerBase):
    ...     def search(self, world_state, robot_pose, goal_pose):
    ...         return wend.search(world_state, robot_pose, goal_pose, "bfs")
    >>> Borrowed().search([[0, 0]], (0, 0), (1, 0))
    [(0, 0), (1, 0)]
    """

    @abc.abstractmethod
    def search(self, world_state: Any, robot_pose: Any, goal_pose: Any) -> PathOrNone:
        """The cells (x, y) from the robot to the goal, both included, by orthogonal steps through cells that are 0; or
        None."""


class Comparison(NamedTuple):
    """What one planner made of a query."""

    planner: str
    path: PathOrNone
    steps: int | None
    """One fewer than cells; None without a path."""
    seconds: float
    """The shortest time of all repetitions."""


@named_types
def compare(
    world_state: npt.ArrayLike,
    robot_pose: Index2,
    goal_pose: Index2,
    planners: Iterable[str | PlannerBase] = ("astar", "dijkstra", "greedy", "bfs", "dfs", "random"),
    *,
    repetitions: int = 1,
    connectivity: Literal[4, 8] = 4,
    escape: float = 0,
    closest: bool = False,
    progress: bool = False,
) -> list[Comparison]:
    """Asks several planners the same query, those of wend by name and your own as objects.

    :param planners: names as for ``wend.search()``, and objects.
    :param repetitions: how often each planner is asked; at least 1.
    :param connectivity: 4 or 8, for the planners of wend.
    :param escape: as in ``wend.search()``, for the planners of wend; so is `closest`.
    :param progress: show a progress bar of tqdm, where that is installed.
    :raises ValueError: as ``wend.search()``, and for fewer than one repetition.

    >>> import wend
    >>> for row in wend.compare([[0, 0, 0]], (0, 0), (2, 0), ["astar", "bfs"]):
    ...     print(row.planner, row.steps)
    astar 2
    bfs 2
    """
    if repetitions < 1:
        raise InvalidArgument("repetitions must be at least 1", "invalid_option", "repetitions")
    rows = []
    asked = list(planners)
    with progress_bar(progress, len(asked) * repetitions, " searches") as tell:
        for i, planner in enumerate(asked):
            seconds = float("inf")
            path: PathOrNone = None
            for repetition in range(repetitions):
                begin = time.perf_counter()
                path = search(
                    world_state, robot_pose, goal_pose, planner,
                    connectivity=connectivity, escape=escape, closest=closest,
                )
                seconds = min(seconds, time.perf_counter() - begin)
                if tell is not None:
                    tell((i + (repetition + 1) / repetitions) / len(asked))
            name = planner if isinstance(planner, str) else type(planner).__name__
            rows.append(Comparison(name, path, None if path is None else len(path) - 1, seconds))
    return rows
