"""The frames of a search, as a GIF. Needs Pillow."""

from __future__ import annotations

import io
from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from ._pictures import EXPANDED, FRONTIER, PALETTE, drawn, heat_colours
from ._recorded import Recorded

__all__ = ["gif_of"]

_MOST_FRAMES = 200
_SECONDS = 8  # of the search
_STILL = 2000  # the last frame, in ms
_LONGEST_SIDE = 480  # pixels, if a cell has at least one

# Colours by number: the states of cells, then these, then those of a heat map.
_EXPANDED, _FRONTIER, _CURRENT, _PATH, _START, _GOAL = range(3, 9)
_HEAT, _HEATS = 9, 128

Picture = npt.NDArray[np.uint8]


def gif_of(search: Recorded, layer: str) -> bytes:
    """The bytes of a GIF: the search from its first to its last expansion, and then its path."""
    try:
        from PIL import Image
    except ImportError as error:
        raise ImportError("a GIF needs Pillow: pip install pillow") from error
    colours = [*PALETTE[:3], EXPANDED, FRONTIER, *PALETTE[3:], *heat_colours(_HEATS)]
    rows, columns = search.states.shape
    scale = max(1, min(16, _LONGEST_SIDE // max(rows, columns)))
    images = []
    for frame in _frames(search, layer):
        pixels = np.kron(drawn(search.map, frame), np.ones((scale, scale), dtype=np.uint8))
        image = Image.fromarray(pixels)
        image.putpalette([channel for colour in colours for channel in colour])
        images.append(image)
    _draw_path(search, images[-1], scale)
    durations = [max(20, 1000 * _SECONDS // len(images))] * (len(images) - 1) + [_STILL]
    file = io.BytesIO()
    images[0].save(file, "GIF", save_all=True, append_images=images[1:], duration=durations, loop=0, optimize=False)
    return file.getvalue()


def _frames(search: Recorded, layer: str) -> Iterator[Picture]:
    """The numbers of colours of all cells, after some of the steps."""
    kinds, cells = search.kinds, search.cells
    expansions = np.flatnonzero(kinds == 1)
    ends = np.append(expansions, len(kinds))
    rows, columns = search.states.shape
    paint = _paint_of(search, layer)
    picture = np.where(search.states < 0, 2, search.states).astype(np.uint8)
    inside = (cells[:, 0] < columns) & (cells[:, 1] < rows)
    begin = 0
    for step in np.unique(np.linspace(0, len(expansions), _MOST_FRAMES).astype(int)).tolist():
        events = np.arange(begin, ends[step])[inside[begin : ends[step]]]
        paint(picture, events)
        begin = int(ends[step])
        frame = picture.copy()
        if 0 < step < len(expansions) and inside[expansions[step - 1]]:
            x, y = cells[expansions[step - 1]]
            frame[y, x] = _CURRENT
        yield frame


def _paint_of(search: Recorded, layer: str) -> Any:
    """A function that shows some events in a picture."""
    cells = search.cells

    def paint_search(picture: Picture, events: npt.NDArray[np.int64]) -> None:
        x, y = cells[events].T
        expanded = search.kinds[events] == 1
        reached = ~expanded & (picture[y, x] != _EXPANDED)
        picture[y[reached], x[reached]] = _FRONTIER
        picture[y[expanded], x[expanded]] = _EXPANDED

    if layer == "search":
        return paint_search
    values = search.costs[:, "ghf".index(layer)]
    finite = np.isfinite(values)
    least, greatest = (values[finite].min(), values[finite].max()) if finite.any() else (0, 0)
    shares = np.where(finite, values - least, 0) / max(greatest - least, 1e-300)
    numbers = (_HEAT + np.round(shares * (_HEATS - 1))).astype(np.uint8)

    def paint_heat(picture: Picture, events: npt.NDArray[np.int64]) -> None:
        shown = events[finite[events]]
        x, y = cells[shown].T
        picture[y, x] = numbers[shown]

    return paint_heat


def _draw_path(search: Recorded, image: Any, scale: int) -> None:
    points = search.path
    if points is None:
        return
    from PIL import ImageDraw

    if search.map.y_up:
        points = points * (1, -1) + (0, search.map.height)
    pen = ImageDraw.Draw(image)
    corners = [(float(x), float(y)) for x, y in points * scale]
    pen.line(corners, fill=_PATH, width=max(2, scale // 4), joint="curve")
    radius = max(2.5, scale / 2.5)
    for (x, y), colour in ((corners[0], _START), (corners[-1], _GOAL)):
        pen.ellipse((x - radius, y - radius, x + radius, y + radius), fill=colour)
