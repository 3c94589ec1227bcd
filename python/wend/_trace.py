"""Trace: everything that a search did, as arrays and as events."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from typing import Literal, NamedTuple, cast

import numpy as np
import numpy.typing as npt

from . import _core
from ._animation import Animation, Layer
from ._errors import NoPath
from ._map import Map
from ._pictures import EXPANDED, FRONTIER, colours_of, svg_of
from ._plan import Plan
from ._recorded import Recorded

__all__ = ["Event", "Trace"]

_KINDS: tuple[Literal["generate", "expand", "relax"], ...] = ("generate", "expand", "relax")
_GENERATE, _EXPAND, _RELAX = range(3)


class Event(NamedTuple):
    """One event of a search. Costs are in cells."""

    kind: Literal["generate", "expand", "relax"]
    """Reached for the first time; taken from the frontier; reached again, more cheaply."""
    cell: tuple[int, int]
    """(x, y); for the car, a vertex where cells meet."""
    parent: tuple[int, int] | None
    """Where it was reached from; None for the start."""
    g: float
    """The cost from the start."""
    h: float
    """The estimated cost to the goal; 0 without a heuristic."""
    f: float
    """The priority."""
    heading: float | None
    """Radians, for planners of poses."""
    way: npt.NDArray[np.float64] | None = None
    """For ``hybrid_astar``: the poses (x, y, heading) from the parent to the state, in cells and radians, that segments
    join. Shape (n, 3); None for other planners and for the start."""


class Trace:
    """A search from its first event to its last. ``FreeSpace.trace()`` makes it.

    The layers are arrays [y, x]: ``expansion``, ``generation``, ``g``, ``h``, ``f``, ``parents``. For planners whose
    states have headings, each shows what happened last (for the order: first) at a cell with any heading.

    >>> import wend
    >>> trace = wend.Map([[0, 0], [0, 1]]).free_space().trace((0, 0), (1, 0), planner="bfs")
    >>> [(event.kind, event.cell) for event in trace.events()][:2]
    [('generate', (0, 0)), ('expand', (0, 0))]
    """

    __slots__ = ("_ends", "_search", "_ways", "failure", "map", "plan")

    map: Map
    """The map of the search."""
    plan: Plan | None
    """The plan; None if the search found no path."""
    failure: NoPath | None
    """Why there is none; None if there is a path."""

    def __init__(self, map: Map, recording: _core.Recording, plan: Plan | None, failure: NoPath | None) -> None:
        self.map = map
        self.plan = plan
        self.failure = failure
        self._ways = recording.ways()
        self._ends = recording.ends()
        cells = recording.cells()
        # The vertices of a car: one more than cells.
        largest = cells.max(axis=0) if len(cells) > 0 else np.zeros(2, dtype=np.int32)
        self._search = Recorded(
            map=map._inner,
            states=map.array,
            shape=(max(map.height, int(largest[1]) + 1), max(map.width, int(largest[0]) + 1)),
            kinds=recording.kinds(),
            cells=cells,
            parents=recording.parents(),
            costs=recording.costs(),
            headings=recording.headings(),
            on_corners=recording.on_corners,
            path=None if plan is None else plan._inner.points(),
        )

    def __len__(self) -> int:
        """The number of events."""
        return len(self._search.kinds)

    @property
    def order(self) -> npt.NDArray[np.int32]:
        """The cells (x, y) in the order in which they were expanded: shape (n, 2)."""
        return self._search.order

    @property
    def expansion(self) -> npt.NDArray[np.uint32]:
        """When each cell was expanded first, from 1; 0: never. Shape (height, width)."""
        return self._first(_EXPAND)

    @property
    def generation(self) -> npt.NDArray[np.uint32]:
        """When each cell was reached first, from 1; 0: never. Shape (height, width)."""
        return self._first(_GENERATE)

    @property
    def g(self) -> npt.NDArray[np.float64]:
        """The cost of the cheapest path to each cell that the search knows; NaN: never reached."""
        return self._last(0)

    @property
    def h(self) -> npt.NDArray[np.float64]:
        """The estimated cost to the goal; NaN: never reached."""
        return self._last(1)

    @property
    def f(self) -> npt.NDArray[np.float64]:
        """The priority; NaN: never reached."""
        return self._last(2)

    @property
    def parents(self) -> npt.NDArray[np.int32]:
        """The cell (x, y) that each was reached from: shape (height, width, 2); (-1, -1) for the start and where the
        search never was."""
        reached = self._search.kinds != _EXPAND
        layer = np.full((*self._search.shape, 2), -1, dtype=np.int32)
        at = self._search.cells[reached]
        layer[at[:, 1], at[:, 0]] = self._search.parents[reached]
        return layer

    def events(self) -> Iterator[Event]:
        """All events, in order."""
        first = 0
        for i, kind in enumerate(self._search.kinds.tolist()):
            x, y = self._search.cells[i].tolist()
            parent = cast("tuple[int, int]", tuple(self._search.parents[i].tolist()))
            g, h, f = self._search.costs[i].tolist()
            heading = float(self._search.headings[i])
            last = int(self._ends[i])
            way = self._ways[first:last] if last - first > 1 else None
            first = last
            yield Event(
                _KINDS[kind],
                (x, y),
                None if parent == (-1, -1) else parent,
                g,
                h,
                f,
                None if math.isnan(heading) else heading,
                way,
            )

    def animate(
        self, path: str | os.PathLike[str] | None = None, *, layer: Layer = "search", step: int = 0
    ) -> Animation:
        """The search step by step, for a notebook or a browser: one slider, and the frontier, g, h or f as colours.

        :param path: also writes it there: a page (``.html``), or a GIF (``.gif``), which needs Pillow.
        :param layer: what the colours show first: the frontier and what was expanded, or the values of g, h or f.
        :param step: the expansion that the page shows first; -1: the last.
        :raises ValueError: another layer, or another kind of file.

        >>> import wend
        >>> wend.Map([[0, 0, 0]]).free_space().trace((0, 0), (2, 0)).animate()
        <wend.Animation of 3 steps>
        """
        outcome = str(self.failure) if self.plan is None else f"Path found, cost {self.plan.cost:.6g}."
        animation = Animation(self._search, outcome, layer, step)
        if path is not None:
            animation.save(path)
        return animation

    def _repr_svg_(self) -> str:
        """The cells that were expanded, the frontier and the path, as a notebook shows them."""
        colours = colours_of(self.map.array)
        shown = np.s_[: self.map.height, : self.map.width]
        colours[(self.generation > 0)[shown]] = FRONTIER
        colours[(self.expansion > 0)[shown]] = EXPANDED
        return svg_of(self.map._inner, colours, self._search.path)

    def _first(self, kind: int) -> npt.NDArray[np.uint32]:
        at = self._search.cells[self._search.kinds == kind]
        layer = np.zeros(self._search.shape, dtype=np.uint32)
        # NumPy writes in order, so the first time is written last.
        layer[at[::-1, 1], at[::-1, 0]] = np.arange(len(at), 0, -1, dtype=np.uint32)
        return layer

    def _last(self, column: int) -> npt.NDArray[np.float64]:
        layer = np.full(self._search.shape, np.nan)
        layer[self._search.cells[:, 1], self._search.cells[:, 0]] = self._search.costs[:, column]
        return layer

    def __repr__(self) -> str:
        return f"<wend.Trace of {len(self)} events>"
