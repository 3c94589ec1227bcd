"""Ways with a direction: what planners make of arrows and heights is recomputed here."""

from __future__ import annotations

import heapq
import math
import pathlib

import numpy as np
import numpy.typing as npt
import pytest
import wend

STEPS = [(dx, dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1) if (dx, dy) != (0, 0)]


def factor(heading: float, arrow: float, tolerance: float, against: float) -> float:
    if math.isnan(arrow):
        return 1
    away = abs((heading - arrow + math.pi) % (2 * math.pi) - math.pi)
    return 1 if away <= tolerance + 1e-9 else against


def costs_from(
    headings: npt.NDArray[np.float64], start: tuple[int, int], tolerance: float, against: float
) -> dict[tuple[int, int], float]:
    """Dijkstra on the edges of an open map."""
    height, width = headings.shape
    costs = {start: 0.0}
    heap = [(0.0, start)]
    while heap:
        cost, (x, y) = heapq.heappop(heap)
        if cost > costs[(x, y)]:
            continue
        for dx, dy in STEPS:
            to = (x + dx, y + dy)
            if not (0 <= to[0] < width and 0 <= to[1] < height):
                continue
            heading = math.atan2(dy, dx)
            here = factor(heading, headings[y, x], tolerance, against)
            there = factor(heading, headings[to[1], to[0]], tolerance, against)
            other = cost + math.hypot(dx, dy) * (here + there) / 2
            if other < costs.get(to, math.inf):
                costs[to] = other
                heapq.heappush(heap, (other, to))
    return costs


@pytest.mark.parametrize("seed", range(20))
def test_costs_are_those_of_a_dijkstra_on_edges(seed: int) -> None:
    random = np.random.default_rng(seed)
    headings = np.where(random.random((6, 7)) < 0.5, np.nan, np.pi / 4 * random.integers(0, 8, (6, 7)))
    tolerance = float(random.choice([np.pi / 4, np.pi / 2]))
    against = float(random.choice([math.inf, 2.5]))
    space = wend.Map(np.zeros((6, 7))).with_arrows(headings, tolerance=tolerance, factor=against).free_space()
    truth = costs_from(headings, (3, 2), tolerance, against)
    for y in range(6):
        for x in range(7):
            expected = truth.get((x, y), math.inf)
            try:
                cost = space.plan((3.5, 2.5), (x + 0.5, y + 0.5)).cost
            except wend.NoPath:
                cost = math.inf
            assert cost == pytest.approx(expected, rel=1e-5)


def test_heights_cost_upwards() -> None:
    hill = wend.Map(np.zeros((1, 3))).with_heights([[0, 1, 2]], climb=3, descend=1).free_space()
    assert hill.plan((0.5, 0.5), (2.5, 0.5)).cost == pytest.approx(2 * 4)
    assert hill.plan((2.5, 0.5), (0.5, 0.5)).cost == pytest.approx(2 * 2)


def test_masks_come_from_images(tmp_path: pathlib.Path) -> None:
    arrows = tmp_path / "arrows.pgm"
    arrows.write_text("P2 3 1 255 1 1 1\n")
    room = wend.Map(np.zeros((1, 3)))
    assert room.with_one_way_mask(arrows) == room.with_arrows(np.zeros((1, 3)))
    assert room.with_one_way_mask(arrows) != room
    ramp = room.with_height_mask(arrows, climb=1)
    assert ramp.notes == ("the height mask is flat: it changes nothing",)


def test_refuses_what_it_does_not_know() -> None:
    room = wend.Map(np.zeros((2, 2)))
    for wrong in (
        lambda: room.with_arrows(np.zeros((1, 2))),
        lambda: room.with_arrows(np.full((2, 2), np.inf)),
        lambda: room.with_arrows(np.zeros((2, 2)), tolerance=4),
        lambda: room.with_arrows(np.zeros((2, 2)), factor=0.5),
        lambda: room.with_heights(np.zeros((2, 2)), climb=-1),
    ):
        with pytest.raises(ValueError):
            wrong()
    directed = room.with_arrows(np.zeros((2, 2))).free_space()
    with pytest.raises(wend.Error, match="jps does not plan on a map with directions"):
        directed.plan((0.5, 0.5), (1.5, 0.5), planner="jps")
