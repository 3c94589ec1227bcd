"""Recorded: the events of a search in columns, and what pictures need beside them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core

__all__ = ["Recorded"]


class Recorded(NamedTuple):
    """A search on a map, from its first event to its last."""

    map: _core.Map
    states: npt.NDArray[np.int8]
    """Of the map's cells: 0, 1 and -1."""
    shape: tuple[int, int]
    """Rows and columns of layers: those of the map; for the vertices of a car, one more."""
    kinds: npt.NDArray[np.uint8]
    """0: generated; 1: expanded; 2: reached again, more cheaply."""
    cells: npt.NDArray[np.int32]
    parents: npt.NDArray[np.int32]
    """(-1, -1) for the start."""
    costs: npt.NDArray[np.float64]
    """g, h and f."""
    headings: npt.NDArray[np.float64]
    """NaN for planners on cells."""
    on_corners: bool
    """Are the cells corners of cells, where a car stands?"""
    path: npt.NDArray[np.float64] | None
    """The points of the path, in cells; None if there is none."""

    @property
    def order(self) -> npt.NDArray[np.int32]:
        """The cells (x, y) in the order in which they were expanded."""
        cells: npt.NDArray[np.int32] = self.cells[self.kinds == 1]
        return cells
