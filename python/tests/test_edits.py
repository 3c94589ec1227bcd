"""Edits of a free space: afterwards it is the space of the edited map, and what was made before stays."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import wend
from hypothesis import given, settings
from hypothesis import strategies as st


def expect_same(space: wend.FreeSpace, array: npt.NDArray[Any], costs: npt.NDArray[Any], **robot: Any) -> None:
    """The space is the one that is made of these cells from scratch."""
    fresh = wend.Map(array, resolution=0.5, costs=costs).free_space(**robot)
    assert np.array_equal(space.map.array, array)
    assert np.array_equal(space.map.costs, costs)
    assert np.array_equal(space.passable, fresh.passable)
    assert np.array_equal(space.clearance, fresh.clearance)
    assert np.array_equal(space.costs, fresh.costs)
    free = np.argwhere(fresh.passable)
    if len(free) > 0:
        ends = (free[[0, -1]][:, ::-1] + 0.5) * 0.5
        for planner in ("astar", "dijkstra"):
            assert cost_between(space, ends, planner) == cost_between(fresh, ends, planner)


def cost_between(space: wend.FreeSpace, ends: npt.NDArray[Any], planner: str) -> float | str:
    try:
        return space.plan(ends[0], ends[1], planner).cost
    except wend.NoPath as no_path:
        return no_path.status


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_a_space_is_that_of_the_edited_map(seed: int) -> None:
    random = np.random.default_rng(seed)
    shape = (int(random.integers(1, 20)), int(random.integers(1, 20)))
    array = random.choice([0, 1, -1], size=shape, p=[0.8, 0.15, 0.05]).astype(np.int8)
    costs = 1 + np.floor(4 * random.random(shape)) * random.integers(0, 2)
    robots: list[dict[str, Any]] = [{}, {"footprint": 0.3}, {"clearance_distance": 1.0}]
    robot = robots[random.integers(3)]
    space = wend.Map(array, resolution=0.5, costs=costs).free_space(**robot)
    held = []
    for _ in range(6):
        size = (int(random.integers(1, shape[0] + 1)), int(random.integers(1, shape[1] + 1)))
        y, x = int(random.integers(shape[0] - size[0] + 1)), int(random.integers(shape[1] - size[1] + 1))
        box = np.s_[y : y + size[0], x : x + size[1]]
        states = random.choice([0, 1, -1], size=size).astype(np.int8)
        values = 1 + np.floor(4 * random.random(size))
        before, kept = space.map, space.map.array.copy()
        if random.random() < 0.5:
            held.append((before, kept))  # what is alive makes the edit copy
        del before
        if random.random() < 0.5:
            with_states, with_costs = random.random() < 0.7, random.random() < 0.5
            with_costs = with_costs or not with_states
            space.edit((x, y), states if with_states else None, values if with_costs else None)
            if with_states:
                array[box] = states
            if with_costs:
                costs[box] = values
        else:
            cells = np.column_stack((random.integers(shape[1], size=5), random.integers(shape[0], size=5)))
            new_states, new_costs = random.choice([0, 1, -1], size=5), 1 + random.integers(3, size=5)
            space.edit_cells(cells, new_states, new_costs)
            for (cell_x, cell_y), state, cost in zip(cells, new_states, new_costs):
                array[cell_y, cell_x], costs[cell_y, cell_x] = state, cost
        expect_same(space, array, costs, **robot)
        for map, as_it_was in held:
            assert np.array_equal(map.array, as_it_was)


def test_says_what_may_differ() -> None:
    space = wend.Map(np.zeros((40, 40)), resolution=0.5).free_space(footprint=1.0)
    before = space.passable.copy()
    boxes = space.edit((20, 10), [[1]])
    seen = np.zeros((40, 40), dtype=bool)
    for x, y, width, height in boxes:
        seen[y : y + height, x : x + width] = True
    changed = before != space.passable
    assert changed.any() and not (changed & ~seen).any()
    assert space.edit((20, 10), [[1]]) == [], "nothing differs any more"


def test_plans_and_traces_of_before_keep_their_map() -> None:
    room = wend.Map(np.zeros((3, 5), dtype=np.int8))
    space = room.free_space()
    plan, trace = space.plan((0, 1), (4, 1)), space.trace((0, 1), (4, 1))
    assert space.map is room
    space.edit((2, 0), [[1], [1], [0]])
    assert plan.map == room == trace.map
    assert space.map.array[:, 2].tolist() == [1, 1, 0]
    assert space.map is space.map
    assert plan.quality().length == 4 and plan.smooth().length == pytest.approx(4)
    assert space.plan((0, 1), (4, 1)).length > 4


def refusal(make: Any) -> str:
    with pytest.raises(ValueError) as error:
        make()
    return str(error.value)


def test_refuses_wrong_edits_and_changes_nothing() -> None:
    wrong: Any
    space = wend.Map(np.zeros((3, 5))).free_space()
    assert "cell (5,0)" in refusal(lambda: space.edit((5, 0), [[1]]))
    assert "cell (-1,0)" in refusal(lambda: space.edit((-1, 0), [[1]]))
    assert "is not on the map" in refusal(lambda: space.edit((10**30, -(10**30)), [[1]]))
    assert "array[0, 1] is 7" in refusal(lambda: space.edit((0, 0), [[1, 7]]))
    assert "costs[0, 0] is 0.5" in refusal(lambda: space.edit((0, 0), [[1]], [[0.5]]))
    assert "differ in size" in refusal(lambda: space.edit((0, 0), [[1]], [[1, 2]]))
    assert "array or costs" in refusal(lambda: space.edit((0, 0)))
    for wrong in (3, (1,), (0.5, 1), ("a", "b"), (1, 2, 3)):
        assert "corner" in refusal(lambda: space.edit(wrong, [[1]])), wrong
    assert "states must be" in refusal(lambda: space.edit_cells([(0, 0)], 2))
    assert "shape (n, 2)" in refusal(lambda: space.edit_cells([(0, 0, 0)], 1))
    assert "shape (n, 2)" in refusal(lambda: space.edit_cells([(0.0, 0.5)], 1))
    assert "states has 3 values for 2 cells" in refusal(lambda: space.edit_cells([(0, 0), (1, 1)], [1, 0, 1]))
    assert "at least 1" in refusal(lambda: space.edit_cells([(0, 0)], 1, 0.0))
    assert "is not on the map" in refusal(lambda: space.edit_cells([(0, 9)], 1))
    assert space.edit_cells(np.zeros((0, 2), dtype=int), 1) == []
    assert space.map.array.tolist() == [[0] * 5] * 3


def test_an_index_does_not_fit_any_more() -> None:
    space = wend.Map(np.zeros((12, 12))).free_space()
    space.use_index(wend.Index.build(space, "hub_labels"))
    assert space.plan((0, 0), (11, 11), "hub_labels").length > 0
    space.edit((5, 5), [[1]])
    with pytest.raises(wend.Error) as error:
        space.plan((0, 0), (11, 11), "hub_labels")
    assert error.value.status == "index_mismatch"


def test_threads_plan_while_one_edits() -> None:
    """Every plan is a path on the map that it names."""
    space = wend.Map(np.zeros((60, 60), dtype=np.int8)).free_space()
    faults: list[str] = []
    stop = threading.Event()

    def plan() -> None:
        while not stop.is_set():
            found = space.plan((0, 30), (59, 30))
            cells = found.cells
            if found.map.array[cells[:, 1], cells[:, 0]].any():
                faults.append("a path through an obstacle")
            if len(space.cost_to_go((0, 30))) != 60 or not space.fits((0.5, 30.5)):
                faults.append("something else")

    threads = [threading.Thread(target=plan) for _ in range(3)]
    for thread in threads:
        thread.start()
    wall = np.ones((50, 1), dtype=np.int8)
    for i in range(150):
        space.edit((1 + i % 58, 5), wall if i % 2 == 0 else 1 - wall)
        space.edit((1, 0), np.zeros((60, 58), dtype=np.int8))
    stop.set()
    for thread in threads:
        thread.join()
    assert faults == []


def test_replans_with_all_that_was_asked_for() -> None:
    array = np.zeros((20, 30), dtype=np.int8)
    array[:16, 15] = 1
    start, goal = (5.5, 5.5, 0.0), (25.5, 5.5, 1.0)
    for planner in ("astar", "theta_star", "hybrid_astar", "lattice", "car"):
        space = wend.Map(array).free_space()
        plan, again = space.plan(start, goal, planner), space.replan(start, goal, planner)
        assert not again.kept
        assert again.cost == pytest.approx(plan.cost)
        if planner in ("hybrid_astar", "lattice", "car"):
            assert again.path == pytest.approx(plan.path)


def test_keeps_a_path_unless_another_is_cheaper_by_the_share() -> None:
    array = np.zeros((20, 30), dtype=np.int8)
    array[:16, 15] = 1
    start, goal = (5.5, 5.5, 0.0), (25.5, 5.5)
    for planner in ("astar", "any_angle", "hybrid_astar"):
        space = wend.Map(array).free_space()
        around = space.replan(start, goal, planner)
        space.edit((15, 2), np.zeros((8, 1), dtype=np.int8))
        kept = space.replan(start, goal, planner, keep=0.9)
        assert kept.kept
        assert kept.cost == pytest.approx(around.cost)
        through = space.replan(start, goal, planner, keep=0.01)
        assert not through.kept
        assert through.cost < 0.99 * around.cost
    for wrong in (-1.0, float("nan")):
        with pytest.raises(wend.InvalidArgument, match="option 'keep'"):
            space.replan(start, goal, keep=wrong)
