"""Costs: occupancy grids, costmaps, masks, functions; what planners make of them is recomputed here."""

from __future__ import annotations

import pathlib
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import wend
from hypothesis import given, settings
from hypothesis import strategies as st

BYTES = np.arange(256)


def test_reads_every_value_of_an_occupancy_grid() -> None:
    values = np.arange(-128, 128)[np.newaxis]
    for occupied_from, factor in ((65, 0), (100, 4), (1, 2)):
        grid = wend.Map.from_occupancy(values, 0.05, occupied_from=occupied_from, cost_factor=factor)
        unknown = (values < 0) | (values > 100)
        occupied = ~unknown & (values >= occupied_from)
        free = ~unknown & ~occupied
        assert np.array_equal(grid.array, np.where(unknown, -1, np.where(occupied, 1, 0)))
        assert np.allclose(grid.costs, np.where(free, 1 + factor * values / 100, 1))
        assert (grid.y_up, grid.resolution) == (True, 0.05)


def test_reads_every_value_of_a_costmap() -> None:
    costmap = wend.Map.from_costmap(BYTES[np.newaxis], 0.05, (1, 2), cost_factor=3, y_up=False)
    assert np.array_equal(costmap.array[0], np.where(BYTES == 255, -1, np.where(BYTES >= 253, 1, 0)))
    assert np.allclose(costmap.costs[0], np.where(BYTES <= 252, 1 + 3 * BYTES / 252, 1))
    assert (costmap.origin, costmap.y_up) == ((1, 2, 0), False)


def refusal(make: Any) -> str:
    with pytest.raises(ValueError) as error:
        make()
    return str(error.value)


def test_refuses_wrong_grids_by_name() -> None:
    assert "256" in refusal(lambda: wend.Map.from_costmap([[0, 256]]))
    assert "-1" in refusal(lambda: wend.Map.from_costmap([[0, -1]]))
    assert "whole numbers" in refusal(lambda: wend.Map.from_occupancy([[0.5]]))
    assert "occupied_from" in refusal(lambda: wend.Map.from_occupancy([[1]], occupied_from=0))
    assert "cost factor" in refusal(lambda: wend.Map.from_costmap([[1]], cost_factor=-1))
    assert "occupied_from" in refusal(lambda: wend.Map.from_occupancy([[1]], occupied_from="x"))  # type: ignore[arg-type]


def test_asks_a_function_once_for_all_cells_in_metres() -> None:
    calls = []

    def costs(x: npt.NDArray[np.float64], y: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        calls.append((x.shape, y.shape))
        return 1 + x + 10 * y

    map = wend.Map(np.zeros((2, 3)), resolution=2.0, origin=(5, 7), costs=costs)
    assert calls == [((2, 3), (2, 3))]
    assert map.costs.tolist() == [[87, 89, 91], [107, 109, 111]]
    turned = wend.Map(np.zeros((2, 3)), origin=(0, 0, np.pi / 2), costs=lambda x, y: 10 - x + y * 0)
    assert np.allclose(turned.costs, [[10.5] * 3, [11.5] * 3]), "rows go towards -x"
    assert wend.Map([[0, 0]]).with_costs(lambda x, y: 3).costs.tolist() == [[3, 3]]
    assert map.with_costs(None).costs.tolist() == [[1] * 3] * 2
    assert map.with_costs(np.full((2, 3), 2)).costs.tolist() == [[2] * 3] * 2
    assert map.costs[0, 0] == 87, "the map itself does not change"


def test_refuses_what_a_function_must_not_return() -> None:
    assert "shape (3,): (1, 2) expected" in refusal(lambda: wend.Map([[0, 0]], costs=lambda x, y: [1, 2, 3]))
    assert "at least 1" in refusal(lambda: wend.Map([[0, 0]], costs=lambda x, y: x * 0))
    assert "type" in refusal(lambda: wend.Map([[0, 0]]).with_costs(lambda x, y: "dear"))
    assert "shape" in refusal(lambda: wend.Map([[0, 0]]).with_costs([[1.0]]))


def write_mask(folder: pathlib.Path, name: str, mode: str, values: list[int], origin: str = "[0, 0, 0]") -> pathlib.Path:
    folder.joinpath(name + ".pgm").write_text(f"P2 {len(values)} 1 255 " + " ".join(map(str, values)) + "\n")
    file = folder / (name + ".yaml")
    file.write_text(
        f"image: {name}.pgm\nmode: {mode}\nresolution: 0.5\norigin: {origin}\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.2\n"
    )
    return file


def test_lays_masks_from_files(tmp_path: pathlib.Path) -> None:
    room = wend.Map(np.zeros((2, 4)), resolution=0.5, y_up=True)
    zone = room.with_mask(write_mask(tmp_path, "zone", "trinary", [0, 255], "[1, 0.5, 0]"))
    assert zone.array.tolist() == [[0, 0, 0, 0], [0, 0, 1, 0]]
    slow = write_mask(tmp_path, "slow", "raw", [0, 50, 25, 100])
    assert room.with_mask(slow, "speed").costs.tolist() == [[1, 2, 4, 1], [1] * 4]
    assert room.with_mask(slow, "speed", multiplier=0.02, top_speed=2.0).costs.tolist() == [[1, 2, 4, 1], [1] * 4]
    both = room.with_mask(slow, "speed").with_mask(str(slow))
    assert both.costs.tolist() == [[1, 2 * 3, 4 * 2, 1], [1] * 4]
    with pytest.raises(wend.Error, match="none.yaml"):
        room.with_mask(tmp_path / "none.yaml")
    with pytest.raises(wend.Error, match="mode: scale"):
        room.with_mask(tmp_path / "zone.yaml", "speed")
    assert "does not touch" in refusal(
        lambda: room.with_mask(write_mask(tmp_path, "far", "raw", [100], "[90, 0, 0]"))
    )
    assert "keepout" in refusal(lambda: room.with_mask(slow, "fast"))  # type: ignore[arg-type]
    assert "kind is for files" in refusal(lambda: room.with_mask(room, "speed"))
    assert "same size" in refusal(lambda: room.with_mask(wend.Map([[0, 1]])))


def cost_of(cells: npt.NDArray[Any], costs: npt.NDArray[np.float64]) -> float:
    """The cost of a path of steps: each its length times the mean of its two cells, as they are stored."""
    stored = np.floor(costs * 256 + 0.5) / 256
    at = stored[cells[:, 1], cells[:, 0]]
    steps = np.hypot(*np.diff(cells, axis=0).T)
    return float(np.sum(steps * (at[1:] + at[:-1]) / 2))


@settings(max_examples=60, deadline=None)
@given(st.data())
def test_every_planner_of_steps_says_what_its_path_costs(data: st.DataObject) -> None:
    random = np.random.default_rng(data.draw(st.integers(0, 2**32 - 1)))
    shape = (int(random.integers(2, 12)), int(random.integers(2, 12)))
    costs = 1 + 9 * random.random(shape) * (random.random(shape) < 0.7)
    space = wend.Map((random.random(shape) < 0.15).astype(np.int8), costs=costs).free_space()
    free = np.argwhere(space.passable)
    if len(free) == 0:
        return
    ends = free[random.integers(len(free), size=2)][:, ::-1]
    assert np.allclose(space.costs, np.floor(costs * 256 + 0.5) / 256)
    for planner in ("astar", "dijkstra", "greedy", "bfs", "dfs"):
        try:
            plan = space.plan(ends[0], ends[1], planner)
        except wend.NoPath:
            continue
        assert plan.cost == pytest.approx(cost_of(plan.cells, costs), rel=1e-9, abs=1e-9), planner
