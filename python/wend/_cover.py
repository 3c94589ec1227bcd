"""Coverage: a path on which a tool passes over every place that it can reach."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

__all__ = ["Coverage"]


class Coverage(NamedTuple):
    """A path that covers an area. ``FreeSpace.cover()`` makes it."""

    points: npt.NDArray[np.float64]
    """The path in metres: shape (n, 2); the robot drives straight from point to point."""
    wanted: npt.NDArray[np.bool_]
    """The cells that the tool can reach, in the area: shape (height, width)."""
    covered: npt.NDArray[np.bool_]
    """Those that the path covers, or that were covered before."""
    covered_share: float
    """How many of the wanted cells are covered, from 0 to 1."""
    length: float
    """Of the path, in metres."""
    lower_bound: float
    """What the path covers divided by the tool's width: hardly any path is shorter."""
    turns: int
    """Where the direction changes by more than 20 degrees."""
    strokes: int
    """The strips, swaths and crumbs that the path joins."""

    @property
    def missed(self) -> npt.NDArray[np.bool_]:
        """The wanted cells that are not covered: shape (height, width)."""
        return self.wanted & ~self.covered
