"""FreeSpace: a map with a robot; it plans, and says what is known of both."""

from __future__ import annotations

import operator
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Pose, checked_threads, goals_of, numbers_of, text_of
from ._errors import Error, InvalidArgument, NoPath
from ._map import Map
from ._plan import Plan
from ._progress import progress_bar
from ._trace import Trace
from ._types import named_types

if TYPE_CHECKING:
    from ._index import Index

__all__ = ["DriveExplanation", "Explanation", "FreeSpace", "Way"]

Connectivity = Literal[4, 8]
CornerRule = Literal["none", "one", "both"]

_FIELDS = {name for first, others, *_ in _core.request_fields() for name in (first, *others)}  # of a request

_LEAST_PART = 50  # queries that plan_many() plans between two looks at its progress


def _fields_of(arguments: dict[str, Any]) -> dict[str, Any]:
    """The arguments of a function that are fields of a request."""
    return {name: value for name, value in arguments.items() if name in _FIELDS}


class Way(NamedTuple):
    """Changes that open a path; without any of them there is none."""

    unknown_free: bool
    """Unknown cells have to count as free."""
    squeeze: bool
    """The robot has to squeeze between two obstacles that touch at a corner."""
    smaller_robot: bool
    """The robot has to be smaller."""
    radius: float
    """The largest radius that fits, in metres."""
    narrowest: tuple[float, float]
    """The narrowest place, in metres."""


class Explanation(NamedTuple):
    """Why no path joins a start and a goal, or that one does."""

    text: str
    """One or more sentences."""
    path_exists: bool
    """Is there a path after all?"""
    start_component: int
    """The number of cells that can be reached from the start; 0 if the robot cannot stand there."""
    goal_component: int
    """The same for the goal."""
    ways: tuple[Way, ...]
    """What would open a path, fewest changes first; empty if nothing does."""


class DriveExplanation(NamedTuple):
    """Why ``hybrid_astar`` finds no drive, or that it finds one; what would help was found by planning."""

    text: str
    """One or more sentences; the coordinates of its reason are in cells."""
    drive_exists: bool
    """Is there a drive after all?"""
    footprint_scale: float | None
    """Below 1: the largest scale of the footprint for which there is a drive; None if no scale was found."""
    turning_radius: float | None
    """The largest turning radius below the asked one with which there is a drive, in metres; None if none was found."""
    reverse_helps: bool | None
    """Is there a drive in reverse? None if the robot may reverse already, or if an end is blocked."""
    narrowest: tuple[float, float] | None
    """The narrowest place of the widest path of a disc, in metres; None if not even a point gets through."""
    narrowest_radius: float | None
    """The radius of the largest disc that gets through there, in metres."""


class FreeSpace:
    """Where one robot may be on a map. ``Map.free_space()`` makes it; the robot does not change, and the map only by
    ``edit()`` and ``edit_cells()``.

    Points and poses are in metres of the map's frame (in cells, if the map has no resolution); x is to the right in an
    array, y is down its rows. All threads may call everything; planning does not hold the interpreter lock.

    >>> import wend
    >>> space = wend.Map([[0, 0, 0], [1, 1, 0], [0, 0, 0]]).free_space()
    >>> space.plan((0.5, 0.5), (0.5, 2.5)).cells.tolist()
    [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2]]
    """

    __slots__ = ("_inner", "_map")

    _inner: _core.Space
    _map: tuple[int, Map] | None  # the map of a version

    def __init__(self, map: Map, core: _core.Space) -> None:
        self._map = (core.version, map)
        self._inner = core

    @property
    def map(self) -> Map:
        """The map as it is now."""
        kept = self._map
        if kept is None or kept[0] != self._inner.version:
            version, core = self._inner.map()
            kept = self._map = (version, Map._of(core))
        return kept[1]

    @named_types
    def plan(
        self,
        start: Pose,
        goal: Pose | Iterable[Pose],
        planner: str = "astar",
        *,
        time_limit: float | None = None,
        expansions: int | None = None,
        nearest: bool = False,
        nearest_limit: float | None = None,
        escape: float = 0,
        closest: bool = False,
        tolerance: float = 0,
        heading_tolerance: float = 0,
        **options: object,
    ) -> Plan:
        """Plans a path. Ctrl-C stops it; the space stays usable.

        :param start: (x, y) or (x, y, heading); planners on cells ignore the heading.
        :param goal: the same, or a list of goals, of which the cheapest is found. Without a heading, any will do.
        :param planner: a name from ``wend.planners()``; `options` are its options.
        :param time_limit: seconds.
        :param expansions: the most states to expand.
        :param nearest: if an end is blocked, or no path reaches the goal, plan from or to the nearest free cell;
            ``Plan.notes`` says so.
        :param nearest_limit: metres: how far `nearest` moves an end at most. None: 1, on a map without a resolution
            any distance.
        :param escape: metres: if the robot does not fit at the start, the path begins with the shortest way out, at most
            this long, along which it never overlaps more of what blocks it; see ``Plan.lead_out``.
        :param closest: if no path reaches a goal, the path ends at the reachable place nearest to one; see
            ``Plan.remaining``.
        :param tolerance: metres: a path may end this far from the goal; 0: in its cell.
        :param heading_tolerance: radians: the same for the goal's heading.
        :raises wend.NoPath: there is no path, an end is blocked or outside of the map, or a limit was reached.
        :raises ValueError: an unknown planner or option, a value out of range, NaN.

        >>> import wend
        >>> space = wend.Map([[0, 0, 0], [0, 0, 0]], resolution=0.5).free_space()
        >>> plan = space.plan((0.1, 0.1), (1.4, 0.9), planner="jps")
        >>> plan.path.tolist()
        [[0.1, 0.1], [0.75, 0.75], [1.4, 0.9]]
        >>> space.plan((0.1, 0.1), (1.4, 0.9), connectivity=5)
        Traceback (most recent call last):
        ...
        wend.InvalidArgument: option 'connectivity': '5' is not one of 4, 8
        """
        fields = _fields_of(locals())
        return Plan(
            self._inner.plan(start, goals_of(goal), planner, text_of(options) if options else {}, fields, None, False)
        )

    @named_types
    def replan(
        self,
        start: Pose,
        goal: Pose | Iterable[Pose],
        planner: str = "astar",
        *,
        keep: float = 0,
        time_limit: float | None = None,
        expansions: int | None = None,
        nearest: bool = False,
        nearest_limit: float | None = None,
        escape: float = 0,
        closest: bool = False,
        tolerance: float = 0,
        heading_tolerance: float = 0,
        **options: object,
    ) -> Plan:
        """Plans as ``plan()`` does, for a robot that drives while its map changes. What is left of the path that the last
        call answered, from the robot's place on, is answered again unless another path is cheaper by more than the
        share `keep`: if it is free on the present map, is for the same planner and goals, and the robot is no farther
        from it than two cells, or 0.3 m if that is more. ``Plan.kept`` says so.

        Planners from cell to cell that are optimal and need no index are replaced by ``replanner`` with the same moves,
        which repairs what it found before; planners that resume do so themselves, all others plan anew.

        :param keep: 0: any cheaper path is taken; 0.1: one that is cheaper by more than a tenth; 1: none while the last
            one is free.
        :raises wend.NoPath: as ``plan()``.
        :raises ValueError: as ``plan()``.

        >>> import wend
        >>> space = wend.Map([[0, 0, 0], [0, 1, 0], [0, 0, 0]]).free_space()
        >>> plan = space.replan((0, 0), (2, 2))
        >>> space.replan(plan.path[1], (2, 2)).kept
        True
        """
        fields = _fields_of(locals())
        return Plan(
            self._inner.plan(start, goals_of(goal), planner, text_of(options) if options else {}, fields, None, True)
        )

    @named_types
    def plan_many(
        self,
        starts: Iterable[Pose],
        goals: Iterable[Pose],
        planner: str = "astar",
        *,
        threads: int = 0,
        time_limit: float | None = None,
        expansions: int | None = None,
        nearest: bool = False,
        nearest_limit: float | None = None,
        escape: float = 0,
        closest: bool = False,
        progress: bool = False,
        **options: object,
    ) -> list[Plan | NoPath]:
        """Plans from each start to the goal at the same place in `goals`, with threads that share what the planner
        prepares.

        :param threads: 0: as many as the machine runs at once.
        :param nearest: as in ``plan()``; so are `nearest_limit`, `escape` and `closest`.
        :param progress: show a progress bar of tqdm, where that is installed.
        :returns: a ``Plan``, or the ``NoPath`` that ``plan()`` would raise, for each.
        :raises ValueError: as ``plan()``, and if there are more starts than goals or the other way round.

        >>> import wend
        >>> space = wend.Map([[0, 0, 1, 0]]).free_space()
        >>> found, not_found = space.plan_many([(0, 0), (0, 0)], [(1, 0), (3, 0)])
        >>> found.cells.tolist(), not_found.status
        ([[0, 0], [1, 0]], 'unreachable')
        """
        fields = _fields_of(locals())
        all_starts, all_goals = list(starts), list(goals)
        if len(all_starts) != len(all_goals):
            message = f"there are {len(all_starts)} starts and {len(all_goals)} goals"
            raise InvalidArgument(message, "invalid_option", "goals")
        settings = (planner, text_of(options), fields, checked_threads(threads))
        answers: list[Any] = []
        with progress_bar(progress, len(all_starts), " queries") as tell:
            # In parts, to say how far it is; the planners are kept from one to the next.
            count = max(1, len(all_starts))
            part = count if tell is None else max(_LEAST_PART, count // 100)
            for begin in range(0, count, part):
                some = slice(begin, begin + part)
                answers += self._inner.plan_many(all_starts[some], all_goals[some], *settings)
                if tell is not None:
                    tell(len(answers) / count)
        return [Plan(answer) if isinstance(answer, _core.Plan) else _no_path(answer) for answer in answers]

    @named_types
    def solutions(
        self,
        start: Pose,
        goal: Pose | Iterable[Pose],
        planner: str = "ara_star",
        *,
        time_limit: float | None = None,
        expansions: int | None = None,
        nearest: bool = False,
        nearest_limit: float | None = None,
        escape: float = 0,
        closest: bool = False,
        tolerance: float = 0,
        heading_tolerance: float = 0,
        **options: object,
    ) -> Iterator[Plan]:
        """Yields the paths of an anytime planner, each cheaper or with a smaller ``Plan.bound`` than the one before. The
        search goes on when the next path is asked for, so leave the loop when a path is good enough. Without a
        limit the last path is optimal.

        :param time_limit: seconds since the first path is asked for; what is done between the paths counts.
        :param expansions: the most states to expand.
        :param nearest: as in ``plan()``; so are `nearest_limit`, `escape` and `closest`.
        :raises wend.NoPath: as ``plan()``, when the first path is asked for.
        :raises ValueError: as ``plan()``, and if the planner finds one path only.

        >>> import wend
        >>> space = wend.Map([[0, 0, 0], [0, 1, 0], [0, 0, 0]]).free_space()
        >>> [plan.bound for plan in space.solutions((0, 0), (2, 2))][-1]
        1.0
        """
        fields = _fields_of(locals())
        search = self._inner.solutions(start, goals_of(goal), planner, text_of(options) if options else {}, fields)
        return (Plan(found) for found in iter(search.next, None))

    @named_types
    def trace(
        self,
        start: Pose,
        goal: Pose | Iterable[Pose],
        planner: str = "astar",
        *,
        time_limit: float | None = None,
        expansions: int | None = None,
        **options: object,
    ) -> Trace:
        """Plans as ``plan()`` does, and keeps every event of the search; also of one that finds no path.

        >>> import wend
        >>> space = wend.Map([[0, 0, 0]]).free_space()
        >>> trace = space.trace((0, 0), (2, 0))
        >>> trace.expansion.tolist(), trace.g.tolist()
        ([[1, 2, 3]], [[0.0, 1.0, 2.0]])
        """
        fields = _fields_of(locals())
        recording = _core.Recording()
        map = self.map
        goals = goals_of(goal)
        plan: Plan | None = None
        failure: NoPath | None = None
        try:
            plan = Plan(self._inner.plan(start, goals, planner, text_of(options), fields, recording, False))
        except NoPath as no_path:
            failure = no_path
        return Trace(map if plan is None else plan.map, recording, plan, failure)

    @named_types
    def cost_to_go(
        self, goal: Pose | Iterable[Pose], *, connectivity: Connectivity = 8, corner_rule: CornerRule = "none"
    ) -> npt.NDArray[np.float64]:
        """The cost of the cheapest path from every cell to the nearest goal: shape (height, width), in cells times
        terrain; infinite without a path.

        :raises wend.NoPath: a goal is blocked.
        :raises ValueError: a goal is outside of the map.

        >>> import wend
        >>> wend.Map([[0, 0, 0]]).free_space().cost_to_go((0, 0)).tolist()
        [[0.0, 1.0, 2.0]]
        """
        return self._inner.cost_to_go(goals_of(goal), str(connectivity), corner_rule)

    @named_types
    def policy(
        self, goal: Pose | Iterable[Pose], *, connectivity: Connectivity = 8, corner_rule: CornerRule = "none"
    ) -> npt.NDArray[np.int8]:
        """The step (dx, dy) of a cheapest path from every cell: shape (height, width, 2), int8; (0, 0) in a goal and
        where there is no path. Errors are those of ``cost_to_go()``.

        >>> import wend
        >>> wend.Map([[0, 0, 0]]).free_space().policy((0, 0)).tolist()
        [[[0, 0], [-1, 0], [-1, 0]]]
        """
        return self._inner.policy(goals_of(goal), str(connectivity), corner_rule)

    @named_types
    def explain(
        self, start: Pose, goal: Pose, *, connectivity: Connectivity = 8, corner_rule: CornerRule = "none"
    ) -> Explanation:
        """Why no path joins two points, for planners that step from cell to cell, and what would open one.

        :raises ValueError: an end is outside of the map.

        >>> import wend
        >>> why = wend.Map([[0, -1, 0]]).free_space().explain((0, 0), (2, 0))
        >>> why.path_exists, why.ways[0].unknown_free
        (False, True)
        """
        text, start_component, goal_component, path_exists, ways = self._inner.explain(
            start, goal, str(connectivity), corner_rule
        )
        return Explanation(text, path_exists, start_component, goal_component, tuple(Way(*way) for way in ways))

    @named_types
    def explain_drive(self, start: Pose, goal: Pose, **options: object) -> DriveExplanation:
        """Why ``hybrid_astar`` finds no drive, and what would open one: a smaller footprint or turning radius, or reverse
        gear. The first search is that of ``plan``; up to 20 more have 20,000 expansions each. Ctrl-C stops them.

        :param start: (x, y, heading).
        :param goal: (x, y, heading) or (x, y), with any heading.
        :param options: those of the planner.
        :raises ValueError: an unknown option, or a value out of range.

        >>> import numpy as np, wend
        >>> cells = np.zeros((9, 9))
        >>> cells[3:, 3:] = 1
        >>> robot = [(1, 1.2), (1, -1.2), (-1, -1.2), (-1, 1.2)]
        >>> space = wend.Map(cells).free_space(robot, outside="blocked")
        >>> why = space.explain_drive((1.5, 7.5, -np.pi / 2), (7.5, 1.5, 0), turning_radius=200)
        >>> why.drive_exists, why.turning_radius is not None and why.turning_radius < 200
        (False, True)
        """
        return DriveExplanation(*self._inner.explain_drive(start, goal, text_of(options)))

    def fits(self, pose: Pose) -> bool:
        """May the robot stand at (x, y) or (x, y, heading)? Without a heading: at the heading 0.

        >>> import wend
        >>> space = wend.Map([[0, 1]]).free_space()
        >>> space.fits((0.5, 0.5)), space.fits((1.5, 0.5)), space.fits((9, 9))
        (True, False, False)
        """
        return self._inner.why_blocked(pose) is None

    def why_blocked(self, pose: Pose) -> str | None:
        """Why the robot may not stand there, in a few words; None if it may.

        >>> import wend
        >>> wend.Map([[0, 1]]).free_space().why_blocked((1.5, 0.5))
        'an obstacle'
        """
        return self._inner.why_blocked(pose)

    def nearest(self, pose: Pose) -> tuple[float, float, float]:
        """The nearest pose (x, y, heading) with the same heading at which the robot fits; `pose` itself if it does.

        :raises ValueError: it fits nowhere.

        >>> import wend
        >>> wend.Map([[0, 1, 1]]).free_space().nearest((2.5, 0.5))
        (0.5, 0.5, 0.0)
        """
        return self._inner.nearest(pose)

    @property
    def passable(self) -> npt.NDArray[np.bool_]:
        """Where the robot may stand in the middle of a cell at every heading: shape (height, width), bool."""
        return self._inner.passable().view(np.bool_)

    @property
    def clearance(self) -> npt.NDArray[np.float64]:
        """The distance from the middle of each cell to the nearest obstacle in metres: shape (height, width); infinite
        without obstacles."""
        return self._inner.clearance()

    @property
    def costs(self) -> npt.NDArray[np.float64]:
        """The cost of a unit of length in each cell, as planners use it: that of the map, and more near obstacles if
        there is a clearance cost, rounded to 1/256. Shape (height, width)."""
        return self._inner.costs()

    @named_types
    def edit(
        self,
        corner: Sequence[int],
        array: npt.ArrayLike | None = None,
        costs: npt.ArrayLike | None = None,
    ) -> list[tuple[int, int, int, int]]:
        """Changes the cells of a box, and repairs what depends on them: planners keep the rest of what they have
        prepared. ``map`` is the new map from then on; plans and maps of before stay as they are.

        It takes O(cells near the box), but O(cells) once while a plan, a trace or a map of the space as it was is alive.
        New states and costs replace those of the map under its masks: a zone in the box is gone unless `array` has it.
        An index does not fit any more: its planner raises ``wend.Error`` with the status ``index_mismatch``.

        :param corner: (x, y): the cell that gets ``array[0, 0]``.
        :param array: the new states: 0 free, 1 an obstacle, -1 unknown. None: as they are.
        :param costs: the new costs of the map, finite and at least 1, of the same shape. None: as they are.
        :returns: (x, y, width, height) of boxes that contain all cells of the free space that may differ.
        :raises ValueError: the box is not on the map, or an array has other values; then nothing changes.

        >>> import numpy as np, wend
        >>> space = wend.Map(np.zeros((3, 5), dtype=np.int8)).free_space()
        >>> space.edit((2, 0), [[1], [1]])
        [(2, 0, 1, 2)]
        >>> space.plan((0, 0), (4, 0)).cells.tolist()
        [[0, 0], [1, 1], [1, 2], [2, 2], [3, 2], [4, 1], [4, 0]]
        """
        x, y = _cell_of(corner, "corner")
        if array is None and costs is None:
            raise InvalidArgument("array or costs must be given", "invalid_map", "array")
        states = None if array is None else numbers_of(array, "array")
        return self._edited(self._inner.edit, x, y, states, None if costs is None else numbers_of(costs, "costs"))

    @named_types
    def edit_cells(
        self,
        cells: npt.ArrayLike,
        states: npt.ArrayLike,
        costs: npt.ArrayLike | None = None,
    ) -> list[tuple[int, int, int, int]]:
        """The same for single cells, wherever they are.

        :param cells: shape (n, 2), integers: (x, y) of each.
        :param states: n new states, or one for all.
        :param costs: n new costs, or one for all. None: as they are.

        >>> import numpy as np, wend
        >>> space = wend.Map(np.zeros((3, 5), dtype=np.int8)).free_space()
        >>> space.edit_cells([(1, 1), (3, 1)], 1)
        [(1, 1, 3, 1)]
        >>> space.map.array.tolist()
        [[0, 0, 0, 0, 0], [0, 1, 0, 1, 0], [0, 0, 0, 0, 0]]
        """
        places = np.atleast_2d(numbers_of(cells, "cells"))
        if places.size == 0:
            return []
        if places.ndim != 2 or places.shape[1] != 2 or places.dtype.kind not in "iu":
            raise InvalidArgument("cells must be integers of the shape (n, 2)", "invalid_map", "cells")
        rows = np.column_stack((places.astype(np.int64), _for_each(states, "states", len(places)).astype(np.int64)))
        if not np.isin(rows[:, 2], (-1, 0, 1)).all():
            message = "states must be 0 (free), 1 (obstacle) or -1 (unknown)"
            raise InvalidArgument(message, "invalid_map", "states")
        values = None
        if costs is not None:
            values = np.ascontiguousarray(_for_each(costs, "costs", len(places)).astype(np.float64)[:, np.newaxis])
        return self._edited(self._inner.edit_cells, np.ascontiguousarray(rows), values)

    def _edited(self, edit: Any, *arguments: Any) -> list[tuple[int, int, int, int]]:
        self._map = None  # what shares the cells would make the edit copy them
        boxes: list[tuple[int, int, int, int]] = edit(*arguments)
        return boxes

    @named_types
    def use_index(self, index: Index) -> None:
        """Lets the index's planner answer from it from now on. If it was built for something else, ``plan()`` raises
        ``wend.Error`` with the status ``index_mismatch``."""
        index._inner.give_to(self._inner)

    def __repr__(self) -> str:
        return f"<wend.FreeSpace on {self.map!r}>"


def _cell_of(cell: Sequence[int], name: str) -> tuple[int, int]:
    try:
        x, y = (operator.index(number) for number in cell)
    except (TypeError, ValueError) as error:
        raise InvalidArgument(f"{name} must be two integers (x, y), not {cell!r}", "invalid_map", name) from error
    largest = 2**31
    return max(-largest, min(x, largest)), max(-largest, min(y, largest))


def _for_each(values: npt.ArrayLike, name: str, count: int) -> npt.NDArray[Any]:
    """An array of `count` values; a single value is repeated."""
    numbers = np.ravel(numbers_of(values, name))
    if len(numbers) not in (1, count):
        raise InvalidArgument(f"{name} has {len(numbers)} values for {count} cells", "invalid_map", name)
    return np.broadcast_to(numbers, (count,))


def _no_path(answer: Error) -> NoPath:
    if isinstance(answer, NoPath):
        return answer
    raise answer


Map._space_of = FreeSpace
