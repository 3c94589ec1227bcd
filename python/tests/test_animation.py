"""Animations: the page has every event and refers to nothing outside of it; the frames of a GIF are the search."""

from __future__ import annotations

import base64
import html
import json
import pathlib
import re
import sys
import zlib
from typing import Any

import numpy as np
import pytest
import wend
from PIL import Image, ImageSequence

ROOM = np.zeros((12, 18), dtype=np.int8)
ROOM[:9, 6] = 1
ROOM[3:, 12] = 1
ROOM[0, 15] = -1
START, GOAL = (0.5, 0.5), (17.5, 11.5)
LAYERS = ("g", "h", "f")


def trace_of(planner: str = "astar", y_up: bool = False) -> wend.Trace:
    start, goal = ((2.0, 2.0, 0.0), (16.0, 10.0)) if planner == "car" else (START, GOAL)
    return wend.Map(ROOM, y_up=y_up).free_space().trace(start, goal, planner)


def search_in(page: str) -> dict[str, Any]:
    """What the script of a page starts with."""
    found = re.search(r"^const search = (.*);$", page, re.MULTILINE)
    assert found is not None
    search: dict[str, Any] = json.loads(found[1])
    return search


def test_a_page_needs_nothing_else() -> None:
    page = trace_of().animate().html
    assert "__SEARCH__" not in page
    assert not re.search(r"https?:|\bsrc=|<link|@import|url\(", page)


@pytest.mark.parametrize("planner", ["astar", "dijkstra", "jps", "lattice", "car"])
def test_a_page_has_every_event(planner: str) -> None:
    trace = trace_of(planner)
    search = search_in(trace.animate(step=3).html)
    data = zlib.decompress(base64.b64decode(search["data"]))
    count = search["events"]
    assert count == len(trace) and search["step"] == 3
    cells, parents = np.frombuffer(data, "<i4", 2 * count).reshape(2, count)
    costs = np.frombuffer(data, "<f4", 3 * count, 8 * count).reshape(3, count)
    kinds = np.frombuffer(data, np.uint8, count, 20 * count)
    states = np.frombuffer(data, np.uint8, -1, 21 * count)
    assert states.reshape(ROOM.shape).tolist() == np.where(ROOM < 0, 2, ROOM).tolist()
    assert search["vertices"] == (planner == "car")
    columns = search["columns"]
    for i, event in enumerate(trace.events()):
        assert divmod(cells[i], columns) == event.cell[::-1]
        assert parents[i] == (-1 if event.parent is None else event.parent[1] * columns + event.parent[0])
        assert ("generate", "expand", "relax")[kinds[i]] == event.kind
        assert np.allclose(costs[:, i], (event.g, event.h, event.f), rtol=1e-6)
        assert search["headings"] == (event.heading is not None)


def test_a_page_says_how_the_search_ended() -> None:
    walled = np.where(np.arange(18) == 12, 1, ROOM)
    failed = search_in(wend.Map(walled).free_space().trace(START, GOAL).animate().html)
    assert failed["path"] is None and len(failed["outcome"]) > 20
    found = search_in(trace_of().animate().html)
    assert found["path"][-1] == list(GOAL) and found["outcome"].startswith("Path found")


def test_a_notebook_shows_the_page_in_a_frame() -> None:
    animation = trace_of().animate(layer="h")
    frame = re.fullmatch(r'<iframe srcdoc="([^"]*)" sandbox="allow-scripts" .*></iframe>', animation._repr_html_())
    assert frame is not None
    assert html.unescape(frame[1]) == animation.html
    assert search_in(animation.html)["layer"] == "h"


def test_arguments_are_checked(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    trace = trace_of()
    with pytest.raises(wend.InvalidArgument, match="layer is 'x'"):
        trace.animate(layer="x")  # type: ignore[arg-type]
    with pytest.raises(wend.InvalidArgument, match="film.mp4 must end in .html or .gif"):
        trace.animate(tmp_path / "film.mp4")
    monkeypatch.setitem(sys.modules, "PIL", None)
    with pytest.raises(ImportError, match="needs Pillow"):
        trace.animate(tmp_path / "film.gif")
    assert list(tmp_path.iterdir()) == []
    trace.animate(tmp_path / "film.html")
    assert (tmp_path / "film.html").read_text() == trace.animate().html


def frames_of(trace: wend.Trace, folder: pathlib.Path, **options: Any) -> list[Any]:
    """The colours in the middle of each cell, frame after frame: shape (height, width, 3)."""
    trace.animate(folder / "film.gif", **options)
    frames = []
    with Image.open(folder / "film.gif") as film:
        scale = film.width // trace.map.width
        assert film.height == scale * trace.map.height
        for frame in ImageSequence.Iterator(film):
            frames.append(np.asarray(frame.convert("RGB"))[scale // 2 :: scale, scale // 2 :: scale])
    return frames


def test_the_frames_of_a_gif_are_the_search(tmp_path: pathlib.Path) -> None:
    trace = trace_of()
    frames = frames_of(trace, tmp_path)
    assert len(frames) == len(trace.order) + 1
    free, expanded, current = (255, 255, 255), (0x9B, 0xD0, 0xF2), (0xD0, 0x3A, 0x86)
    for step in range(1, len(frames) - 1):
        x, y = trace.order[step - 1]
        assert tuple(frames[step][y, x]) == current
        done = (0 < trace.expansion) & (trace.expansion < step)
        assert ((frames[step] == expanded).all(axis=2) == done).all()
    assert (frames[-1][(trace.generation == 0) & (ROOM == 0)] == free).all()
    upright = frames_of(trace_of(y_up=True), tmp_path)
    assert (upright[40] == frames[40][::-1]).all()


@pytest.mark.parametrize("layer", LAYERS)
def test_the_colours_of_a_gif_are_the_values(layer: Any, tmp_path: pathlib.Path) -> None:
    trace = trace_of()
    frames = frames_of(trace, tmp_path, layer=layer)
    values = getattr(trace, layer)
    clear = np.isfinite(values)
    for x, y in np.floor(trace.plan._inner.points()).astype(int) if trace.plan else ():
        clear[y, x] = False  # the path covers it
    order = np.argsort(values[clear])
    green = frames[-1][clear][order][:, 1].astype(int)  # falls from the least to the greatest
    assert (np.diff(green) <= 0).all() and green[0] > green[-1] + 50


def test_a_long_search_has_200_frames(tmp_path: pathlib.Path) -> None:
    assert len(frames_of(wend.Map(np.zeros((40, 40))).free_space().trace((1, 1), (38, 9), "dijkstra"), tmp_path)) == 200


def test_a_car_and_a_search_without_a_path_have_gifs(tmp_path: pathlib.Path) -> None:
    assert len(frames_of(trace_of("car"), tmp_path)) > 10
    blocked = wend.Map(np.eye(3)).free_space().trace((0.5, 0.5), (2.5, 2.5))
    assert len(frames_of(blocked, tmp_path)) == 1
