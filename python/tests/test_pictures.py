"""Pictures: a PNG of a map is read back as the map; an SVG shows the path where it is."""

from __future__ import annotations

import base64
import pathlib
import sys
import types
import xml.etree.ElementTree as ET
from typing import Any

import numpy as np
import pytest
import wend

CELLS = np.array([[0, 1, 0, 0, 0], [0, 1, -1, 0, 0], [0, 0, 0, 0, 1]], dtype=np.int8)
SVG = "{http://www.w3.org/2000/svg}"


def cells_in(png: bytes, folder: pathlib.Path) -> list[list[int]]:
    """What wend reads from a PNG, by its C++ loader; it takes light grey to be free."""
    (folder / "picture.png").write_bytes(png)
    cells: list[list[int]] = wend.Map.load(folder / "picture.png").array.tolist()
    return cells


def test_a_picture_of_a_map_is_the_map(tmp_path: pathlib.Path) -> None:
    cells = np.where(CELLS == 1, 1, 0)
    assert cells_in(wend.Map(cells)._repr_png_(), tmp_path) == cells.tolist()
    assert cells_in(wend.Map(cells, y_up=True)._repr_png_(), tmp_path) == cells[::-1].tolist()


@pytest.mark.parametrize("y_up", [False, True])
def test_a_picture_of_a_plan_shows_the_path(y_up: bool, tmp_path: pathlib.Path) -> None:
    plan = wend.Map(CELLS, resolution=0.1, y_up=y_up).free_space().plan((0.05, 0.05), (0.45, 0.05))
    picture = ET.fromstring(plan._repr_svg_())
    assert picture.get("viewBox") == "0 0 5 3"
    line = picture.find(f"{SVG}polyline")
    assert line is not None
    points = [tuple(map(float, point.split(","))) for point in line.get("points", "").split()]
    rows = plan.cells[:, 1] + 0.5
    assert [x for x, _ in points] == (plan.cells[:, 0] + 0.5).tolist()
    assert [y for _, y in points] == (3 - rows if y_up else rows).tolist()
    assert len(picture.findall(f"{SVG}circle")) == 2
    image = picture.find(f"{SVG}image")
    assert image is not None
    data = base64.b64decode(image.get("href", "").split(",")[1])
    assert data == plan.map._repr_png_()


def test_a_picture_of_a_trace_shows_the_search() -> None:
    space = wend.Map(CELLS).free_space()
    found = space.trace((0.5, 0.5), (4.5, 0.5))
    failed = space.trace((0.5, 0.5), (4.5, 2.5))
    assert "<polyline" in found._repr_svg_()
    assert "<polyline" not in failed._repr_svg_()
    assert space.trace((0.5, 0.5), (4.5, 0.5), "bfs")._repr_svg_() != found._repr_svg_()


class Axes:
    """Stands for matplotlib's: remembers what is drawn."""

    def __init__(self) -> None:
        self.images: list[Any] = []
        self.lines: list[Any] = []

    def imshow(self, colours: Any, *, origin: str, extent: tuple[int, int, int, int]) -> None:
        self.images.append((colours, origin, extent))

    def plot(self, x: Any, y: Any, *style: str, color: str) -> None:
        self.lines.append((np.atleast_1d(x).tolist(), np.atleast_1d(y).tolist()))


@pytest.mark.parametrize("y_up", [False, True])
def test_plots_in_cells(y_up: bool) -> None:
    plan = wend.Map(CELLS, resolution=0.1, y_up=y_up).free_space().plan((0.05, 0.05), (0.45, 0.05))
    axes = Axes()
    assert plan.plot(axes) is axes
    colours, origin, extent = axes.images[0]
    assert (origin, extent) == (("lower", (0, 5, 0, 3)) if y_up else ("upper", (0, 5, 3, 0)))
    assert (colours[0, 1] == (0x2B, 0x2D, 0x33)).all()  # the obstacle in row 0, whichever way up
    assert axes.lines[0] == ((plan.cells[:, 0] + 0.5).tolist(), (plan.cells[:, 1] + 0.5).tolist())
    assert axes.lines[1:] == [([0.5], [0.5]), ([4.5], [0.5])]
    plan.map.plot(axes)
    assert len(axes.images) == 2 and len(axes.lines) == 3


def test_plots_on_new_axes(monkeypatch: pytest.MonkeyPatch) -> None:
    axes = Axes()
    pyplot = types.SimpleNamespace(figure=lambda: types.SimpleNamespace(add_subplot=lambda: axes))
    monkeypatch.setitem(sys.modules, "matplotlib", types.SimpleNamespace(pyplot=pyplot))
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", pyplot)
    assert wend.Map(CELLS).plot() is axes
