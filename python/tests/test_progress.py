"""Progress bars: they only rise, end at all that there was, and change no result; tqdm is not needed."""

from __future__ import annotations

import sys
import threading
import types
from typing import Any

import numpy as np
import pytest
import wend

RANDOM = np.random.default_rng(3)
SPACE = wend.Map((RANDOM.random((40, 40)) < 0.2).astype(np.int8)).free_space()
STARTS, GOALS = RANDOM.uniform(0, 40, (2, 230, 2)).tolist()


class Bar:
    """Stands for tqdm's."""

    made: list[Bar] = []

    def __init__(self, *, total: int, unit: str) -> None:
        self.total = total
        self.n = 0.0
        self.shown = [0.0]
        self.closed = False
        Bar.made.append(self)

    def update(self, more: float) -> None:
        self.n += more
        self.shown.append(self.n)

    def __enter__(self) -> Bar:
        return self

    def __exit__(self, *error: Any) -> None:
        self.closed = True


@pytest.fixture
def bars(monkeypatch: pytest.MonkeyPatch) -> list[Bar]:
    auto = types.SimpleNamespace(tqdm=Bar)
    monkeypatch.setitem(sys.modules, "tqdm", types.SimpleNamespace(auto=auto))
    monkeypatch.setitem(sys.modules, "tqdm.auto", auto)
    monkeypatch.setattr(Bar, "made", [])
    return Bar.made


def check_complete(bar: Bar, steps: int) -> None:
    assert bar.closed
    assert bar.shown == sorted(bar.shown)
    assert bar.n == bar.total
    assert len(bar.shown) >= steps


def costs_of(answers: list[wend.Plan | wend.NoPath]) -> list[float | str]:
    return [answer.status if isinstance(answer, wend.NoPath) else answer.cost for answer in answers]


@pytest.mark.parametrize("planner", ["astar", "jps"])
def test_plan_many(planner: str, bars: list[Bar]) -> None:
    silent = SPACE.plan_many(STARTS, GOALS, planner, threads=2)
    assert bars == []
    shown = SPACE.plan_many(STARTS, GOALS, planner, threads=2, progress=True)
    assert costs_of(shown) == costs_of(silent) and len(silent) == 230
    assert len(bars) == 1 and bars[0].total == 230
    check_complete(bars[0], 5)
    assert SPACE.plan_many([], [], progress=True) == []


def test_compare(bars: list[Bar]) -> None:
    world = SPACE.map.array
    planners = ["astar", "bfs", "dijkstra"]
    silent = wend.compare(world, (0, 0), (39, 39), planners, repetitions=4)
    assert bars == []
    shown = wend.compare(world, (0, 0), (39, 39), iter(planners), repetitions=4, progress=True)
    assert [row[:3] for row in shown] == [row[:3] for row in silent]
    assert len(bars) == 1 and bars[0].total == 12
    check_complete(bars[0], 13)
    assert wend.compare(world, (0, 0), (1, 1), [], progress=True) == []


def test_tqdm_shows_bars(capsys: pytest.CaptureFixture[str]) -> None:
    SPACE.plan_many(STARTS, GOALS, progress=True)
    wend.compare(SPACE.map.array, (0, 0), (39, 39), ["astar"], progress=True)
    written = capsys.readouterr().err
    assert "230/230" in written and "1/1" in written


@pytest.mark.parametrize("planner", ["hub_labels", "euclidean_labels"])
def test_index(planner: str, bars: list[Bar]) -> None:
    silent = wend.Index.build(SPACE, planner)
    assert bars == []
    assert wend.Index.build(SPACE, planner, progress=True).size == silent.size
    assert len(bars) == 1
    check_complete(bars[0], 2)


def test_an_error_in_the_bar_does_not_stop_the_building(bars: list[Bar], monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(bar: Bar, more: float) -> None:
        if threading.current_thread() is not threading.main_thread():
            raise OSError("no terminal")

    monkeypatch.setattr(Bar, "update", fail)
    unraisable: list[Any] = []
    monkeypatch.setattr(sys, "unraisablehook", unraisable.append)
    assert wend.Index.build(SPACE, progress=True).size > 0
    assert bars[0].closed and str(unraisable[0].exc_value) == "no terminal"


def test_without_tqdm(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "tqdm", None)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    assert len(SPACE.plan_many(STARTS[:3], GOALS[:3], progress=True)) == 3
    assert wend.Index.build(SPACE, progress=True).size > 0
