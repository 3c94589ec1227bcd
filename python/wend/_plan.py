"""Plan: a path and what found it. Trajectory and Drive: what a robot makes of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import text_of
from ._errors import Metrics
from ._listed import Listed
from ._map import Map
from ._pictures import colours_of, plot, svg_of
from ._types import named_types

__all__ = ["Drive", "LeadOut", "Plan", "Quality", "Trajectory", "follow"]


class Quality(Listed[float], fields=_core.path_metrics()):
    """Measures of a path: metres and radians. Radii are infinite for a straight path, and clearances where nothing is
    near."""

    __slots__ = ()


class LeadOut(NamedTuple):
    """A way out of what blocks the start, along which the robot never overlaps more of it."""

    length: float
    """Metres; a turn in place has none."""
    points: int
    """How many points of the path come before the first one where the robot fits."""
    reason: str
    """Why the robot does not fit at the start."""


class Plan:
    """A path that a planner found. ``FreeSpace.plan()`` makes it.

    >>> import wend
    >>> plan = wend.Map([[0, 0], [0, 0]], resolution=2.0).free_space().plan((1, 1), (3, 3))
    >>> plan
    <wend.Plan of 2 points, 2.83 m>
    """

    __slots__ = ("_cells", "_inner", "_map", "_path")

    _inner: _core.Plan
    _map: Map | None
    _path: npt.NDArray[np.float64] | None
    _cells: npt.NDArray[np.int32] | None

    def __init__(self, core: _core.Plan) -> None:
        self._inner = core
        self._map = None
        self._path = None
        self._cells = None

    @property
    def map(self) -> Map:
        """The map that it was planned on."""
        if self._map is None:
            self._map = Map._of(self._inner.map())
        return self._map

    @property
    def path(self) -> npt.NDArray[np.float64]:
        """The path in metres: shape (n, 2), or (n, 3) with headings if the planner's states have them. From the start
        to the goal, both included; for planners on cells, the centres of cells between them. Read-only."""
        if self._path is None:
            self._path = self._inner.path()
            self._path.flags.writeable = False
        return self._path

    @property
    def cells(self) -> npt.NDArray[np.int32]:
        """The cells (x, y) in which these points lie: shape (n, 2), int32, read-only."""
        if self._cells is None:
            self._cells = self._inner.cells()
            self._cells.flags.writeable = False
        return self._cells

    @property
    def cost(self) -> float:
        """What the planner minimises: the length in cells, times terrain. After ``smooth()``, still that of the path
        that was smoothed."""
        return self._inner.cost

    @property
    def bound(self) -> float:
        """cost <= bound * the cheapest cost. 1: optimal; infinite: no guarantee."""
        return self._inner.bound

    @property
    def kept(self) -> bool:
        """Is it what was left of the path that ``FreeSpace.replan()`` had answered before?"""
        return self._inner.kept

    @property
    def length(self) -> float:
        """The length of the path in metres."""
        return self._inner.length

    @property
    def metrics(self) -> Metrics:
        """The work of the search."""
        return Metrics(*self._inner.work)

    @property
    def seconds(self) -> float:
        """The time of the search."""
        return self._inner.seconds

    @property
    def notes(self) -> list[str]:
        """A sentence for each end that was moved (``nearest=True``), led out (``escape=``) or replaced
        (``closest=True``), and one if a planner on cells took the disc around the robot's polygon."""
        return self._inner.notes

    @property
    def lead_out(self) -> LeadOut | None:
        """How the path begins if the robot does not fit at the start (``escape=``); None if it fits. ``cost`` is that of
        the path behind it."""
        lead_out = self._inner.lead_out
        return None if lead_out is None else LeadOut(*lead_out)

    @property
    def start_shift(self) -> float:
        """Metres from the start that was asked for to the path's first point: 0 wherever the robot can go from there to
        the middle of the cell, where the path of a planner on cells begins otherwise. Planners on lattices begin at a
        vertex.

        >>> import wend
        >>> space = wend.Map([[0, 0, 0]], resolution=1).free_space()
        >>> space.plan((0.25, 0.5), (2.5, 0.5)).start_shift
        0.0
        """
        return self._inner.start_shift

    @property
    def goal_shift(self) -> float:
        """The same for the path's last point and the goal that is nearest to it, tolerance included."""
        return self._inner.goal_shift

    @property
    def gears(self) -> list[int]:
        """For each piece between two points: 1 ahead, -1 in reverse, 0 for a turn in place.

        >>> import wend
        >>> wend.Map([[0, 0, 0]]).free_space().plan((0, 0), (2, 0)).gears
        [1, 1]
        """
        return self._inner.gears

    @property
    def remaining(self) -> float | None:
        """Metres from the path's end to the nearest goal: 0 if a goal was reached. None unless ``closest=True``, or
        ``nearest=True`` moved a goal that no path reaches.

        >>> import wend
        >>> space = wend.Map([[0, 0, 0, 1, 0]], resolution=1).free_space()
        >>> space.plan((0.5, 0.5), (4.5, 0.5), closest=True).remaining
        2.0
        """
        return self._inner.remaining

    @property
    def moves(self) -> list[str]:
        """The names of the car's moves, one fewer than poses; empty for other planners."""
        return self._inner.moves

    def quality(self) -> Quality:
        """Measures of the path.

        >>> import wend
        >>> wend.Map([[0, 0, 0]]).free_space().plan((0, 0), (2, 0)).quality().length
        2.0
        """
        return Quality(*self._inner.quality())

    @named_types
    def smooth(
        self,
        smoother: str | None = "gradient",
        *,
        simplify: Literal["collinear", "tolerance", "sight"] | None = None,
        spacing: float | None = None,
        max_distance: float | None = None,
        **options: object,
    ) -> Plan:
        """A smoother path that touches no obstacle: simplified, then smoothed, then resampled, as far as each is asked
        for.

        :param smoother: a name from ``wend.smoothers()``; `options` are its options. None: not smoothed. A path of
            poses takes ``"drive"`` in place of ``"gradient"``.
        :param spacing: metres between the points of the result.
        :param max_distance: metres: how far smoothing may lead from the path. None: as the smoother says.
        :raises ValueError: an option that is not valid, or a path of poses that is to be simplified.

        >>> import wend
        >>> plan = wend.Map([[0] * 9] * 5).free_space().plan((0, 0), (8, 4))
        >>> plan.smooth(None, simplify="sight").path.tolist()
        [[0.5, 0.5], [8.5, 4.5]]
        """
        return Plan(self._inner.smooth(smoother, simplify, spacing, max_distance, text_of(options)))

    @named_types
    def trajectory(self, *, corner_rounding: float | None = None, **limits: object) -> Trajectory:
        """The fastest trajectory along the path, from rest to rest.

        :param corner_rounding: metres: corners become arcs that stay within this of them. None: a tenth of a cell.
        :param limits: `speed` (m/s, default 0.5), `turn_rate` (rad/s, 1.5), `acceleration` (m/s^2, 1),
            `turn_acceleration` (rad/s^2, 5), `lateral_acceleration` (m/s^2, 1).

        >>> import wend
        >>> plan = wend.Map([[0] * 9]).free_space().plan((0, 0), (8, 0))
        >>> plan.trajectory(speed=1.0, acceleration=1.0).duration
        9.0
        """
        return Trajectory(self._inner.trajectory(text_of(limits), corner_rounding))

    def plot(self, ax: Any = None) -> Any:
        """Draws the path on its map with matplotlib, in cells, and returns the axes; None: on new ones. Needs
        matplotlib."""
        return plot(self.map._inner, colours_of(self.map.array), self._inner.points(), ax)

    def _repr_svg_(self) -> str:
        """The path on its map, as a notebook shows it."""
        return svg_of(self.map._inner, colours_of(self.map.array), self._inner.points())

    def __len__(self) -> int:
        return len(self.path)

    def __repr__(self) -> str:
        return f"<wend.Plan of {len(self)} points, {self.length:.3g} m>"


class Trajectory:
    """A path with time stamps and speeds. ``Plan.trajectory()`` makes it. Metres, radians, seconds."""

    __slots__ = ("_inner",)

    _inner: _core.Trajectory

    def __init__(self, core: _core.Trajectory) -> None:
        self._inner = core

    @property
    def duration(self) -> float:
        """Seconds from the start to the end."""
        return self._inner.duration

    @property
    def length(self) -> float:
        """Metres."""
        return self._inner.length

    @property
    def smallest_turning_radius(self) -> float:
        """Metres; 0 with a turn in place, infinite on a line."""
        return self._inner.smallest_turning_radius

    @named_types
    def samples(self, period: float = 0.05) -> npt.NDArray[np.float64]:
        """The states at 0, period, 2 period, ... and at the end: rows of time, x, y, heading, speed, turn rate.

        >>> import wend
        >>> plan = wend.Map([[0] * 9]).free_space().plan((0, 0), (8, 0))
        >>> plan.trajectory(speed=1.0, acceleration=1.0).samples(4.5)[1].tolist()
        [4.5, 4.5, 0.5, 0.0, 1.0, 0.0]
        """
        return self._inner.rows(period)

    @named_types
    def at(self, time: float) -> npt.NDArray[np.float64]:
        """The state at a time, as a row of ``samples()``; before the start and after the end the robot stands."""
        row: npt.NDArray[np.float64] = self._inner.row(time)[0]
        return row

    def __repr__(self) -> str:
        return f"<wend.Trajectory of {self.duration:.3g} s, {self.length:.3g} m>"


class Drive(NamedTuple):
    """A simulated drive along a path: metres, radians, seconds."""

    outcome: str
    """"reached" (it stands within the tolerances), "stuck", "off_path", "collision", "time" or "missed" (it stands
    beside the goal, where its noisy poses tell that it is there)."""
    time: float
    distance: float
    cross_track_rms: float
    cross_track_largest: float
    final_error: float
    """The distance from the goal at the end."""
    collisions: int
    samples: npt.NDArray[np.float64]
    """Rows of time, x, y, heading, speed, turn rate: the true state at each command."""
    final_heading_error: float
    """The heading of the path's end minus that of the robot."""


@named_types
def follow(
    plan: Plan,
    controller: str | None = None,
    *,
    model: Mapping[str, object] | None = None,
    simulation: Mapping[str, object] | None = None,
    follower: Mapping[str, object] | None = None,
    **options: object,
) -> Drive:
    """Simulates a robot that follows the path on its map.

    :param controller: a name from ``wend.controllers()``; `options` are its options. By default "stanley" for a path
        of poses, else "pure_pursuit".
    :param model: `drivetrain` ("differential", "bicycle" or "omni"), `speed`, `turn_rate`, `acceleration`, ...
    :param simulation: `rate`, `latency`, `position_noise`, `heading_noise`, `actuation_noise`, `seed`, `escape` (by
        default a little more than the plan's ``lead_out``), ...
    :param follower: `goal_tolerance`, `heading_tolerance` (0.1 rad, of a goal with a heading; 0: any),
        `acceptance_radius`, `off_path`, `stuck_time`, ...

    "reached" means that the robot stands within the tolerances. A path that such a robot cannot drive raises
    `InvalidArgument`.

    >>> import wend
    >>> plan = wend.Map([[0] * 40] * 20, resolution=0.1).free_space().plan((0.5, 0.5), (3.5, 1.5))
    >>> wend.follow(plan.smooth(), "pid").outcome
    'reached'
    """
    simulated = dict(simulation or {})
    if plan.lead_out is not None:
        simulated.setdefault("escape", plan.lead_out.length + 2 * plan.map.resolution)
    return Drive(
        **plan._inner.follow(
            controller, text_of(options), text_of(model or {}), text_of(simulated), text_of(follower or {})
        )
    )
