"""Map: a grid of free, occupied and unknown cells, and where it lies."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Pose, numbers_of
from ._errors import InvalidArgument
from ._pictures import colours_of, drawn, plot, png_of
from ._types import named_types

if TYPE_CHECKING:
    from ._space import FreeSpace

__all__ = ["Map"]

_FIELDS = {name for name, *_ in _core.robot_fields()}  # of a robot and of what blocks it

CostFunction = Callable[[npt.NDArray[np.float64], npt.NDArray[np.float64]], npt.ArrayLike]
Costs = Union[npt.ArrayLike, CostFunction]


class Map:
    """The content of a map file: cells that are free (0), occupied (1) or unknown (-1). Immutable.

    **Arrays are array[y, x], points are (x, y).** Row 0 of an array is row 0 of the grid, y = 0; so ``array[3, 4]`` is
    the cell with x = 4 and y = 3.

    :param array: shape (height, width), any numbers or booleans, any strides, lists too; it is read in place and not
        kept. 0 is free, 1 an obstacle, -1 unknown.
    :param resolution: metres a cell. None: the unit is the cell, so that the cell (x, y) covers the points from (x, y)
        to (x + 1, y + 1), and lengths "in metres" are cells.
    :param origin: (x, y) or (x, y, heading) of the corner (0, 0) of cell (0, 0): metres, radians.
    :param costs: shape (height, width): the cost of a unit of length in each cell, finite and at least 1; or a function
        of x and y that returns them, see ``with_costs()``. None: 1. A free space rounds them to 1/256, and planners and
        path costs use what it has.
    :param y_up: is row 0 drawn at the bottom, as in occupancy grids of ROS? Only pictures and files ask. Default: row
        0 is at the top, as in text.
    :raises ValueError: for other values, NaN, other shapes; the message says where.

    >>> import numpy as np
    >>> array = np.zeros((3, 5), dtype=np.int8)
    >>> array[0, 4] = 1
    >>> office = Map(array, resolution=0.05)
    >>> office.width, office.height, office.resolution
    (5, 3, 0.05)
    """

    __slots__ = ("_array", "_inner", "_costs", "_notes")

    _inner: _core.Map
    _space_of: ClassVar[Callable[[Map, _core.Space], FreeSpace]]  # _space.py, which knows both, sets it
    _array: npt.NDArray[np.int8] | None
    _costs: npt.NDArray[np.float64] | None
    _notes: tuple[str, ...]

    @named_types
    def __init__(
        self,
        array: npt.ArrayLike,
        resolution: float | None = None,
        origin: Sequence[float] = (0, 0, 0),
        costs: Costs | None = None,
        *,
        y_up: bool = False,
    ) -> None:
        numbers = numbers_of(array, "array")
        metres = None if resolution is None else float(resolution)
        place = _origin_of(origin)
        values = _costs_of(costs, numbers.shape, 1.0 if metres is None else metres, place)
        self._inner = _core.make_map(numbers, metres, place, values, y_up)
        self._array = None
        self._costs = None
        self._notes = ()

    @classmethod
    def _of(cls, core: _core.Map, notes: Sequence[str] = ()) -> Map:
        self = cls.__new__(cls)
        self._inner = core
        self._array = None
        self._costs = None
        self._notes = tuple(notes)
        return self

    @classmethod
    @named_types
    def load(cls, file: str | os.PathLike[str], resolution: float | None = None) -> Map:
        """Reads a ROS ``map.yaml``, a MovingAI ``.map``, a text grid (``.txt``) or an image (``.png``, ``.pgm``,
        ``.bmp``, ``.jpg``). ``Map.notes`` has what is legal in the file, but unusual or probably not meant.

        :param resolution: metres a cell, for an image alone.
        :raises wend.Error: ``invalid_file``, with the file, the line and what is wrong there.

        >>> import tempfile, pathlib
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "room.txt"
        >>> _ = file.write_text("..#\\n...\\n")
        >>> Map.load(file).array.tolist()
        [[0, 0, 1], [0, 0, 0]]
        """
        return cls._of(*_core.load_map(os.fspath(file), resolution))

    @classmethod
    @named_types
    def from_occupancy(
        cls,
        array: npt.ArrayLike,
        resolution: float | None = None,
        origin: Sequence[float] = (0, 0, 0),
        *,
        occupied_from: int = 65,
        cost_factor: float = 0,
        y_up: bool = True,
    ) -> Map:
        """The map of a ``nav_msgs/OccupancyGrid``: 0 to 100, and -1 for unknown.

        :param array: shape (height, width), integers; of a message: ``np.reshape(grid.data, (grid.info.height,
            grid.info.width))``. Values outside of 0..100 are unknown.
        :param occupied_from: the least value of an obstacle, 1 to 100.
        :param cost_factor: a lower value v costs 1 + `cost_factor` * v / 100 times its length. 0: as free ground.
        :raises ValueError: as ``Map()``, and for an `occupied_from` or a `cost_factor` out of range.

        >>> grid = Map.from_occupancy([[0, 50, 100, -1]], 0.05, cost_factor=4)
        >>> grid.array.tolist(), grid.costs.tolist()
        ([[0, 0, 1, -1]], [[1.0, 3.0, 1.0, 1.0]])
        """
        values = _integers_of(array)
        known = np.where((values >= 0) & (values <= 100), values, -1).astype(np.int8)
        metres = None if resolution is None else float(resolution)
        core = _core.map_from_occupancy(known, metres, _origin_of(origin), occupied_from, cost_factor, y_up)
        return cls._of(core)

    @classmethod
    @named_types
    def from_costmap(
        cls,
        array: npt.ArrayLike,
        resolution: float | None = None,
        origin: Sequence[float] = (0, 0, 0),
        *,
        cost_factor: float = 4,
        y_up: bool = True,
    ) -> Map:
        """The map of a costmap of ROS (``costmap_2d``): 0 to 252 are costs, 253 (inscribed) and 254 (lethal) are
        obstacles, 255 is unknown. Obstacles in it have grown by the robot's radius already: plan with a point.

        :param array: shape (height, width), integers from 0 to 255.
        :param cost_factor: a cost v is stored as 1 + `cost_factor` * v / 252 times the length.
        :raises ValueError: as ``Map()``, and for a `cost_factor` out of range.

        >>> costmap = Map.from_costmap([[0, 126, 253, 255]], 0.05)
        >>> costmap.array.tolist(), costmap.costs.tolist()
        ([[0, 0, 1, -1]], [[1.0, 3.0, 1.0, 1.0]])
        """
        values = _integers_of(array)
        if values.size > 0 and (values.min() < 0 or values.max() > 255):
            wrong = values.min() if values.min() < 0 else values.max()
            raise InvalidArgument(f"array has the cost {wrong}: 0 to 255 expected", "invalid_map", "array")
        metres = None if resolution is None else float(resolution)
        core = _core.map_from_costmap(values.astype(np.uint8), metres, _origin_of(origin), cost_factor, y_up)
        return cls._of(core)

    @named_types
    def with_mask(
        self,
        mask: Map | str | os.PathLike[str],
        kind: Literal["keepout", "speed"] = "keepout",
        *,
        base: float = 0,
        multiplier: float = 1,
        top_speed: float | None = None,
    ) -> Map:
        """This map under a mask, as Nav2 has them; masks can be laid one after another.

        Obstacles of the mask become obstacles of the map, costs of its free cells multiply those of the map, and unknown
        cells say nothing. A mask in metres may lie anywhere on a map in metres, and have another resolution; else both
        have the same size.

        :param mask: a map, or the file of a mask.
        :param kind: of a file. "keepout": any map file; obstacles are zones to keep out of. "speed": a ``map.yaml`` with
            ``mode: scale`` or ``raw``; a value v of 1 to 100 limits the speed to `base` + `multiplier` * v, and a cell
            costs the time that it takes.
        :param top_speed: m/s: the limits are in m/s. None: they are in percent of the top speed.
        :raises ValueError: the mask does not touch the map, or the sizes differ.
        :raises wend.Error: ``invalid_file``.

        >>> zones = Map([[0, 1, 0]], costs=[[1, 1, 5]])
        >>> Map([[0, 0, 0]], costs=[[2, 2, 2]]).with_mask(zones).array.tolist()
        [[0, 1, 0]]
        >>> Map([[0, 0, 0]], costs=[[2, 2, 2]]).with_mask(zones).costs.tolist()
        [[2.0, 2.0, 10.0]]
        """
        if isinstance(mask, Map):
            if kind != "keepout":
                message = "kind is for files: of a map, the costs count, which are 100 / percent for speed limits"
                raise InvalidArgument(message, "invalid_option", "kind")
            core, notes = mask._inner, list(mask._notes)
        else:
            top = None if top_speed is None else float(top_speed)
            core, notes = _core.load_mask(os.fspath(mask), kind, base, multiplier, top)
        return Map._of(_core.masked(self._inner, core), [*self._notes, *notes])

    @named_types
    def with_costs(self, costs: Costs | None) -> Map:
        """This map with other costs.

        :param costs: shape (height, width): the cost of a unit of length in each cell, finite and at least 1; or a
            function that is called once with two arrays of that shape, x and y of the middles of the cells in metres,
            and returns the costs. None: 1 everywhere.
        :raises ValueError: for other values and shapes.

        >>> import numpy as np
        >>> field = Map(np.zeros((2, 3), dtype=np.int8), resolution=2.0)
        >>> field.with_costs(lambda x, y: np.where(x > 4, 5.0, 1.0)).costs.tolist()
        [[1.0, 1.0, 5.0], [1.0, 1.0, 5.0]]
        """
        values = _costs_of(costs, (self.height, self.width), self.resolution, self.origin)
        return Map._of(_core.with_costs(self._inner, values))

    @named_types
    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes a ``.yaml`` (with its ``.png``), ``.map``, ``.txt``, ``.png`` or ``.pgm``. What the format cannot hold
        is an error; nothing is changed silently.

        :raises wend.Error: ``invalid_file``.

        >>> import tempfile, pathlib
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "room.txt"
        >>> Map([[0, 1], [0, 0]]).save(file)
        >>> Map.load(file) == Map([[0, 1], [0, 0]])
        True
        """
        self._inner.save(os.fspath(file))

    @property
    def array(self) -> npt.NDArray[np.int8]:
        """The cells, shape (height, width), int8, read-only: 0 free, 1 occupied, -1 unknown. Row 0 is y = 0."""
        if self._array is None:
            self._array = self._inner.states()
            self._array.flags.writeable = False
        return self._array

    @property
    def costs(self) -> npt.NDArray[np.float64]:
        """The cost of a unit of length in each cell, shape (height, width), float64, read-only; at least 1."""
        if self._costs is None:
            self._costs = self._inner.terrain()
            self._costs.flags.writeable = False
        return self._costs

    @property
    def width(self) -> int:
        """The number of columns."""
        return self._inner.width

    @property
    def height(self) -> int:
        """The number of rows."""
        return self._inner.height

    @property
    def resolution(self) -> float:
        """Metres a cell; 1 for a map without one."""
        return self._inner.resolution

    @property
    def notes(self) -> tuple[str, ...]:
        """What is legal in the file of a loaded map and of its masks, but unusual or probably not meant: a sentence
        each. Empty for other maps."""
        return self._notes

    @property
    def origin(self) -> tuple[float, float, float]:
        """(x, y, heading) of the corner (0, 0) of cell (0, 0), in metres and radians."""
        return self._inner.origin

    @property
    def y_up(self) -> bool:
        """Is row 0 drawn at the bottom?"""
        return self._inner.y_up

    @named_types
    def free_space(
        self,
        footprint: float | str | Sequence[Pose] | None = None,
        *,
        unknown: Literal["blocked", "free"] = "blocked",
        outside: Literal["blocked", "free"] | None = None,
        clearance_distance: float = 0,
        clearance_cost: float = 4,
        warm: int = 2,
    ) -> FreeSpace:
        """Where a robot may be on this map. It takes O(cells).

        :param footprint: the shape of the robot: a radius in metres, or the corners of a polygon, [(x, y), ...], in
            metres, with the base point at (0, 0) and +x ahead; ``rectangle()`` makes those of a rectangle. The base
            point may lie outside. Or a text as of the command line's ``--footprint``: "rect:0.8x0.5,0.2". None: a
            point.
        :param unknown: whether unknown cells are obstacles.
        :param outside: whether the robot's shape may leave the map ("free"). None: "blocked" for a map with a
            resolution, else "free".
        :param clearance_distance: metres: cells nearer to obstacles than this cost more, up to 1 + `clearance_cost`
            times as much. 0: off.
        :param warm: how many planners are kept for later queries, with what they have prepared.
        :raises ValueError: for a shape that is not valid, and for numbers out of range.

        >>> space = Map([[0, 0, 0], [0, 1, 0]], resolution=1.0).free_space(footprint=0.5)
        >>> space.passable.tolist()
        [[True, True, True], [True, False, True]]
        """
        fields = {name: value for name, value in locals().items() if name in _FIELDS}
        shape: Any = footprint
        if footprint is not None and not isinstance(footprint, (int, float, str)):
            shape = float(shape) if np.ndim(shape) == 0 else list(footprint)
        if isinstance(warm, int) and warm < 0:
            raise InvalidArgument("warm must be at least 0", "invalid_option", "warm")
        core = _core.make_space(self._inner, shape, fields, warm)
        return Map._space_of(self, core)

    def plot(self, ax: Any = None) -> Any:
        """Draws the map with matplotlib, in cells, and returns the axes; None: on new ones. The cell (x, y) covers x to
        x + 1 and y to y + 1. Needs matplotlib."""
        return plot(self._inner, colours_of(self.array), None, ax)

    def _repr_png_(self) -> bytes:
        """The map as a notebook shows it, a pixel a cell."""
        return png_of(drawn(self._inner, colours_of(self.array)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Map):
            return NotImplemented
        return (
            self.resolution == other.resolution
            and self.origin == other.origin
            and self.y_up == other.y_up
            and np.array_equal(self.array, other.array)
            and np.array_equal(self.costs, other.costs)
        )

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<wend.Map of {self.width} x {self.height} cells of {self.resolution:g} m>"


def _costs_of(
    costs: Costs | None, shape: tuple[int, ...], resolution: float, origin: tuple[float, float, float]
) -> npt.NDArray[Any] | None:
    """Costs as an array. A function is asked for those of the middles of all cells; a number from it stands for all."""
    if costs is None or not callable(costs):
        return None if costs is None else numbers_of(costs, "costs")
    if len(shape) != 2:
        return None  # the array is refused
    rows, columns = np.mgrid[: shape[0], : shape[1]]
    along, across = (columns + 0.5) * resolution, (rows + 0.5) * resolution
    cosine, sine = math.cos(origin[2]), math.sin(origin[2])
    x, y = origin[0] + cosine * along - sine * across, origin[1] + sine * along + cosine * across
    values = numbers_of(costs(x, y), "costs")
    try:
        return np.ascontiguousarray(np.broadcast_to(values, shape), dtype=np.float64)
    except ValueError as error:
        message = f"costs() returned the shape {values.shape}: {tuple(shape)} expected"
        raise InvalidArgument(message, "invalid_map", "costs") from error


def _integers_of(array: npt.ArrayLike) -> npt.NDArray[Any]:
    """An array of whole numbers."""
    numbers = numbers_of(array, "array")
    if numbers.dtype.kind == "f" and not np.array_equal(numbers, np.trunc(numbers)):
        raise InvalidArgument("array has values that are not whole numbers", "invalid_map", "array")
    return numbers


def _origin_of(origin: Sequence[float]) -> tuple[float, float, float]:
    try:
        numbers = [float(number) for number in origin]
    except ValueError as error:
        raise InvalidArgument(f"origin has what is not a number: {origin!r}", "invalid_map", "origin") from error
    if len(numbers) == 2:
        numbers.append(0.0)
    if len(numbers) != 3:
        raise InvalidArgument("origin must be (x, y) or (x, y, heading)", "invalid_map", "origin")
    return numbers[0], numbers[1], numbers[2]
