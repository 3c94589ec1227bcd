"""Animation: a search step by step, as a page with a slider or as a GIF."""

from __future__ import annotations

import base64
import html
import json
import os
import pathlib
import zlib
from importlib import resources
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from ._errors import InvalidArgument
from ._film import gif_of
from ._recorded import Recorded

__all__ = ["Animation"]

Layer = Literal["search", "g", "h", "f"]
LAYERS = ("search", "g", "h", "f")

_WIDTH, _HEIGHT, _CELL = 640, 480, 28  # of the picture, as _animation.html shows it: pixels
_CONTROLS = 150  # what is below the picture: pixels


class Animation:
    """A search step by step. ``Trace.animate()`` makes it; a notebook shows it, without a kernel too.

    A step is one expansion. The page has a slider, plays, shows the frontier or the values of g, h or f, and needs
    nothing but a browser. Keys: space plays and pauses; arrows, page up and down, home and end step; 1 to 4 choose what
    the colours show.
    """

    __slots__ = ("_layer", "_outcome", "_search", "_step")

    def __init__(self, search: Recorded, outcome: str, layer: Layer, step: int) -> None:
        if layer not in LAYERS:
            raise InvalidArgument(f"layer is {layer!r}: use one of {', '.join(LAYERS)}", "invalid_option", "layer")
        self._search = search
        self._outcome = outcome
        self._layer = layer
        self._step = step

    @property
    def html(self) -> str:
        """The page: HTML that refers to nothing outside of it."""
        page = (resources.files("wend") / "_animation.html").read_text(encoding="utf-8")
        data = json.dumps(_search_of(self._search, self._outcome, self._layer, self._step)).replace("<", "\\u003c")
        return page.replace("__SEARCH__", data)

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes a page (``.html``), or a GIF of at most 200 frames (``.gif``), which needs Pillow.

        :raises ValueError: another kind of file.
        :raises ImportError: a GIF without Pillow.

        >>> import tempfile, pathlib, wend
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "search.html"
        >>> wend.Map([[0, 0]]).free_space().trace((0, 0), (1, 0)).animate().save(file)
        >>> file.read_text()[:15]
        '<!doctype html>'
        """
        path = pathlib.Path(file)
        if path.suffix == ".html":
            path.write_text(self.html, encoding="utf-8")
        elif path.suffix == ".gif":
            path.write_bytes(gif_of(self._search, self._layer))
        else:
            raise InvalidArgument(f"{path.name} must end in .html or .gif", "invalid_option", "path")

    def _repr_html_(self) -> str:
        """A frame, so that neither its styles nor its names meet those of the notebook."""
        map = self._search.map
        height = min(_CELL, _WIDTH / map.width, _HEIGHT / map.height) * map.height + _CONTROLS
        return (
            f'<iframe srcdoc="{html.escape(self.html)}" sandbox="allow-scripts" title="A search, step by step" '
            f'style="width:100%;height:{height:.0f}px;border:0"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<wend.Animation of {len(self._search.order)} steps>"


def _search_of(search: Recorded, outcome: str, layer: str, step: int) -> dict[str, Any]:
    """What _animation.html reads. The columns are little-endian, in the order of its unpack()."""
    rows, columns = search.shape
    numbers = [_indices(search.cells, columns), _indices(search.parents, columns), *search.costs.T.astype("<f4")]
    states = np.where(search.states < 0, 2, search.states).astype(np.uint8)
    data = b"".join([*(column.tobytes() for column in numbers), search.kinds.tobytes(), states.tobytes()])
    return {
        "width": search.map.width,
        "height": search.map.height,
        "y_up": search.map.y_up,
        "rows": rows,
        "columns": columns,
        "headings": bool(np.isfinite(search.headings).any()),
        "vertices": search.on_corners,
        "layer": layer,
        "step": step,
        "events": len(search.kinds),
        "path": None if search.path is None else search.path.tolist(),
        "outcome": outcome,
        "data": base64.b64encode(zlib.compress(data)).decode(),
    }


def _indices(cells: npt.NDArray[np.int32], columns: int) -> npt.NDArray[np.int32]:
    """Cells (x, y) as numbers, row after row; -1 for (-1, -1)."""
    return np.where(cells[:, 0] < 0, -1, cells[:, 1] * columns + cells[:, 0]).astype("<i4")
