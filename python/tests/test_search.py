"""search(), planners of one's own, and the check of them."""

from __future__ import annotations

from collections import deque
from typing import Any

import numpy as np
import pytest
import wend
import wend.testing
from hypothesis import given, settings
from hypothesis import strategies as st

WORLD = [[0, 0, 0, 0], [1, 1, 1, 0], [0, 0, 0, 0]]
NAMES = ["astar", "dijkstra", "bfs", "dfs", "greedy"]


class OfWend(wend.PlannerBase):
    """A planner of wend, held to what a planner of one's own is held to."""

    def __init__(self, name: str, **options: object) -> None:
        self.name = name
        self.options = options

    def search(self, world_state: Any, robot_pose: Any, goal_pose: Any) -> list[tuple[int, int]] | None:
        return wend.search(world_state, robot_pose, goal_pose, self.name, **self.options)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", NAMES)
def test_planners_of_wend_pass_the_check(name: str) -> None:
    wend.testing.check_planner(OfWend(name), shortest=name in ("astar", "dijkstra", "bfs"))


def test_the_random_walk_passes_the_check() -> None:
    wend.testing.check_planner(OfWend("random", max_steps=50), complete=False)
    wend.testing.check_planner(OfWend("random", max_steps=100_000), worlds=60)
    walk = wend.search(WORLD, (0, 0), (0, 2), "random", max_steps=10_000, seed=2)
    assert walk == wend.search(WORLD, (0, 0), (0, 2), "random", max_steps=10_000, seed=2)


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 8), st.integers(1, 8))
def test_lists_and_arrays_give_the_same(seed: int, width: int, height: int) -> None:
    numbers = np.random.default_rng(seed)
    cells = (numbers.random((height, width)) < 0.3).astype(np.int64)
    robot = (int(numbers.integers(width)), int(numbers.integers(height)))
    goal = (int(numbers.integers(width)), int(numbers.integers(height)))
    path = wend.search(cells.tolist(), robot, goal)
    assert wend.search(cells, robot, goal) == path
    assert wend.search(cells.astype(bool).tolist(), robot, goal) == path
    assert wend.search(cells.astype(float).tolist(), robot, goal) == path
    assert wend.search(list(cells), robot, goal) == path
    assert wend.search(tuple(map(tuple, cells.tolist())), robot, goal) == path
    flipped = wend.search(cells.T, robot[::-1], goal[::-1], order="xy")
    assert (flipped is None) == (path is None)
    assert flipped is None or path is None or len(flipped) == len(path)
    rows = wend.search(cells, robot[::-1], goal[::-1], order="rc")
    assert rows == (None if path is None else [(y, x) for x, y in path])


def test_connectivity() -> None:
    open_world = [[0] * 4 for _ in range(4)]
    orthogonal = wend.search(open_world, (0, 0), (3, 3))
    diagonal = wend.search(open_world, (0, 0), (3, 3), connectivity=8)
    assert orthogonal is not None and len(orthogonal) == 7
    assert diagonal == [(0, 0), (1, 1), (2, 2), (3, 3)]


def test_start_is_goal_and_blocked_ends() -> None:
    assert wend.search(WORLD, (0, 0), (0, 0)) == [(0, 0)]
    assert wend.search(WORLD, (0, 1), (0, 0)) is None
    assert wend.search(WORLD, (0, 0), (0, 1)) is None
    assert wend.search([[0, -1, 0]], (0, 0), (2, 0)) is None
    assert wend.search(WORLD, np.array([0, 0]), [np.int64(0), np.int8(2)]) is not None


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        ((WORLD, (4, 0), (0, 0)), {}, "robot_pose is outside the map, which has x from 0 to 3"),
        ((WORLD, (0, 0), (0, -1)), {}, "goal_pose is outside"),
        ((WORLD, (0, 0), (2**70, 0)), {}, "goal_pose is outside"),
        ((WORLD, (0.5, 0), (0, 0)), {}, "robot_pose must be a tuple of two integers"),
        ((WORLD, (0, 0, 0), (0, 0)), {}, "robot_pose must be"),
        ((WORLD, None, (0, 0)), {}, "robot_pose must be"),
        (([[0, 2]], (0, 0), (0, 0)), {}, r"world_state\[0, 1\] is 2"),
        (([[0, 2**70]], (0, 0), (0, 0)), {}, r"world_state\[0, 1\] is inf"),
        (([[0, float("nan")]], (0, 0), (0, 0)), {}, r"world_state\[0, 1\] is nan"),
        (([[0, 0], [0]], (0, 0), (0, 0)), {}, r"world_state\[1\] has 1 values, world_state\[0\] has 2"),
        (([[0, "a"]], (0, 0), (0, 0)), {}, "world_state has the type"),
        (([[0, None]], (0, 0), (0, 0)), {}, "world_state has the type object"),
        (([], (0, 0), (0, 0)), {}, "world_state has the shape"),
        (([[]], (0, 0), (0, 0)), {}, "world_state has the shape"),
        ((None, (0, 0), (0, 0)), {}, "world_state"),
        ((WORLD, (0, 0), (0, 2)), {"planner": "astr"}, "did you mean 'astar'"),
        ((WORLD, (0, 0), (0, 2)), {"planner": "car"}, "does not step from cell to cell"),
        ((WORLD, (0, 0), (0, 2)), {"planner": "theta_star"}, "does not step from cell to cell"),
        ((WORLD, (0, 0), (0, 2)), {"planner": "random", "connectivity": 8}, "random takes connectivity=4 only"),
        ((WORLD, (0, 0), (0, 2)), {"planner": "jps"}, "jps takes connectivity=8 only"),
        ((WORLD, (0, 0), (0, 2)), {"connectivity": 6}, "connectivity is 6"),
        ((WORLD, (0, 0), (0, 2)), {"order": "yx"}, "order is 'yx'"),
        ((WORLD, (0, 0), (0, 2)), {"steps": 6}, "unknown option 'steps'"),
    ],
)
def test_invalid_arguments_are_named(arguments: Any, options: Any, message: str) -> None:
    with pytest.raises(wend.InvalidArgument, match=message):
        wend.search(*arguments, **options)


class Correct(wend.PlannerBase):
    """Breadth-first search; its faulty variants override a step each."""

    def search(self, world_state: Any, robot_pose: Any, goal_pose: Any) -> list[tuple[int, int]] | None:
        parents: dict[tuple[int, int], tuple[int, int] | None] = {robot_pose: None}
        if not self.free(world_state, *robot_pose):
            return None
        frontier = deque([robot_pose])
        while frontier:
            here = frontier.popleft()
            if here == goal_pose:
                return self.path(parents, here)
            for dx, dy in self.steps():
                there = (here[0] + dx, here[1] + dy)
                if there not in parents and self.free(world_state, *there):
                    parents[there] = here
                    frontier.append(there)
        return None

    def steps(self) -> list[tuple[int, int]]:
        return [(1, 0), (-1, 0), (0, 1), (0, -1)]

    def free(self, world: Any, x: int, y: int) -> bool:
        return 0 <= y < len(world) and 0 <= x < len(world[0]) and world[y][x] == 0

    def path(self, parents: Any, here: Any) -> list[tuple[int, int]]:
        path = []
        while here is not None:
            path.append(here)
            here = parents[here]
        return path[::-1]


class Diagonal(Correct):
    def steps(self) -> list[tuple[int, int]]:
        return [*super().steps(), (1, 1)]


class NeverLeft(Correct):
    def steps(self) -> list[tuple[int, int]]:
        return [(1, 0), (0, 1), (0, -1)]


class ThroughWalls(Correct):
    def free(self, world: Any, x: int, y: int) -> bool:
        return 0 <= y < len(world) and 0 <= x < len(world[0])


class Backwards(Correct):
    def path(self, parents: Any, here: Any) -> list[tuple[int, int]]:
        return super().path(parents, here)[::-1]


class Careless(Correct):
    def path(self, parents: Any, here: Any) -> list[tuple[int, int]]:
        return super().path(parents, here)[:-1]


class Scribbler(Correct):
    def search(self, world_state: Any, robot_pose: Any, goal_pose: Any) -> list[tuple[int, int]] | None:
        path = super().search(world_state, robot_pose, goal_pose)
        world_state[0][0] = 7
        return path


class Crashes(Correct):
    def free(self, world: Any, x: int, y: int) -> bool:
        return bool(world[y][x] == 0)


class LongWay(Correct):
    """Depth first: correct, but not shortest."""

    def search(self, world_state: Any, robot_pose: Any, goal_pose: Any) -> list[tuple[int, int]] | None:
        return wend.search(world_state, robot_pose, goal_pose, "dfs")


def test_a_correct_planner_passes() -> None:
    wend.testing.check_planner(Correct, shortest=True)


@pytest.mark.parametrize(
    ("planner", "message", "cells"),
    [
        (Diagonal, "is not an orthogonal step", 4),
        (NeverLeft, "there is a path, and it returned None", 2),
        (ThroughWalls, "there is no path, and it returned one|is an obstacle", 1),
        (Backwards, "does not start at the robot", 2),
        (Careless, "does not end at the goal|does not start at the robot", 1),
        (Scribbler, "changed world_state", 1),
        (Crashes, "raised IndexError", 2),
    ],
)
def test_the_check_finds_faults_and_small_worlds(planner: Any, message: str, cells: int) -> None:
    with pytest.raises(wend.testing.PlannerFault, match=message) as caught:
        wend.testing.check_planner(planner)
    assert len(caught.value.world) * len(caught.value.world[0]) == cells


def test_the_check_finds_long_paths_where_asked() -> None:
    wend.testing.check_planner(LongWay)
    with pytest.raises(wend.testing.PlannerFault, match="are enough"):
        wend.testing.check_planner(LongWay, shortest=True)


def test_ends_in_the_closest_cell_and_leads_out() -> None:
    world = [[1, 0, 0, 0, 1, 0]]
    assert wend.search(world, (1, 0), (5, 0)) is None
    assert wend.search(world, (1, 0), (5, 0), closest=True) == [(1, 0), (2, 0), (3, 0)]
    assert wend.search(world, (0, 0), (2, 0)) is None
    assert wend.search(world, (0, 0), (2, 0), escape=1) == [(0, 0), (1, 0), (2, 0)]
    for row in wend.compare(world, (0, 0), (5, 0), ["astar", "bfs"], escape=1, closest=True):
        assert row.path == [(0, 0), (1, 0), (2, 0), (3, 0)]
    with pytest.raises(wend.InvalidArgument, match="escape"):
        wend.search(world, (0, 0), (2, 0), escape=-1)


def test_compares_planners() -> None:
    rows = wend.compare(WORLD, (0, 0), (0, 2), ["astar", "bfs", Correct()], repetitions=2)
    assert [(row.planner, row.steps) for row in rows] == [("astar", 8), ("bfs", 8), ("Correct", 8)]
    assert all(row.seconds >= 0 for row in rows)
    assert wend.compare(WORLD, (0, 0), (0, 1))[0].steps is None
    with pytest.raises(wend.InvalidArgument):
        wend.compare(WORLD, (0, 0), (0, 2), repetitions=0)


def test_planner_base_is_abstract() -> None:
    with pytest.raises(TypeError):
        wend.PlannerBase()  # type: ignore[abstract]
