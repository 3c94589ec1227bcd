"""Pictures for notebooks: a map as a PNG, and paths and searches on it as an SVG. The colours are those of
docs/colours.md."""

from __future__ import annotations

import base64
import struct
import zlib
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core

__all__ = ["PALETTE", "colours_of", "heat_colours", "plot", "png_of", "svg_of"]

_FREE = (0xFF, 0xFF, 0xFF)
_OCCUPIED = (0x2B, 0x2D, 0x33)
_UNKNOWN = (0xC6, 0xC9, 0xCE)
_PATH = "#0072B2"
_START = "#009E73"
_GOAL = "#D55E00"

PALETTE = (_FREE, _OCCUPIED, _UNKNOWN, (0xD0, 0x3A, 0x86), (0x00, 0x72, 0xB2), (0x00, 0x9E, 0x73), (0xD5, 0x5E, 0x00))
"""Free, occupied, unknown, being expanded, path, start, goal."""

_HEAT = ((0xFF, 0xF3, 0xBF), (0xFC, 0xCE, 0x8C), (0xF2, 0xA0, 0x7C), (0xDB, 0x74, 0x86), (0xB0, 0x55, 0x9A))

EXPANDED = (0x9B, 0xD0, 0xF2)
FRONTIER = (0x4F, 0x8F, 0xE0)

_WIDTH = 480  # of an SVG as it is shown, in pixels; small maps are not enlarged beyond 24 pixels a cell

Colours = npt.NDArray[np.uint8]


def colours_of(cells: npt.NDArray[np.int8]) -> Colours:
    """The colours of 0, 1 and -1: shape (height, width, 3)."""
    return np.array([_FREE, _OCCUPIED, _UNKNOWN], dtype=np.uint8)[cells]


def heat_colours(count: int) -> list[list[int]]:
    """Colours from the least to the greatest number."""
    places = np.linspace(0, len(_HEAT) - 1, count)
    channels = [np.interp(places, np.arange(len(_HEAT)), channel) for channel in zip(*_HEAT)]
    colours: list[list[int]] = np.stack(channels, axis=1).round().astype(int).tolist()
    return colours


def png_of(colours: Colours) -> bytes:
    """The bytes of a PNG, 8 bits a channel; row 0 is at the top."""
    height, width, _ = colours.shape
    rows = np.zeros((height, 1 + 3 * width), dtype=np.uint8)  # each row begins with its filter: none
    rows[:, 1:] = colours.reshape(height, 3 * width)

    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(rows.tobytes()))
        + chunk(b"IEND", b"")
    )


def drawn(map: _core.Map, layer: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """A layer with its rows from the top down, as the map is drawn."""
    return layer[::-1] if map.y_up else layer


def plot(map: _core.Map, colours: Colours, points: npt.NDArray[np.float64] | None, ax: Any) -> Any:
    """Draws the cells and a path through points, in grid coordinates, on matplotlib's axes; None: on new ones."""
    if ax is None:
        import matplotlib.pyplot

        ax = matplotlib.pyplot.figure().add_subplot()
    width, height = map.width, map.height
    if map.y_up:
        ax.imshow(colours, origin="lower", extent=(0, width, 0, height))
    else:
        ax.imshow(colours, origin="upper", extent=(0, width, height, 0))
    if points is not None:
        ax.plot(points[:, 0], points[:, 1], color=_PATH)
        for point, colour in ((points[0], _START), (points[-1], _GOAL)):
            ax.plot(*point, "o", color=colour)
    return ax


def svg_of(map: _core.Map, colours: Colours, points: npt.NDArray[np.float64] | None) -> str:
    """The cells in these colours, and a path through points in grid coordinates."""
    width, height = map.width, map.height
    scale = min(24.0, _WIDTH / width)
    data = base64.b64encode(png_of(drawn(map, colours))).decode()
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
        f'width="{scale * width:g}" height="{scale * height:g}" role="img">',
        f'<image width="{width}" height="{height}" style="image-rendering:pixelated" '
        f'href="data:image/png;base64,{data}"/>',
    ]
    if points is not None:
        xy = points * (1, -1) + (0, height) if map.y_up else points
        line = " ".join(f"{x:.6g},{y:.6g}" for x, y in xy)
        thick = max(0.15, 2 / scale)
        parts.append(f'<polyline points="{line}" fill="none" stroke="{_PATH}" stroke-width="{thick:.3g}"/>')
        for (x, y), colour in ((xy[0], _START), (xy[-1], _GOAL)):
            parts.append(f'<circle cx="{x:.6g}" cy="{y:.6g}" r="{2 * thick:.3g}" fill="{colour}"/>')
    return "".join([*parts, "</svg>"])
