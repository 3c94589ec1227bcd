"""Exceptions: pickled, out of other processes, and their reasons."""

from __future__ import annotations

import multiprocessing
import pickle
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import wend
import wend.testing

WALL = [[0, 1, 0]]


def a_failure(call: Callable[[], object]) -> Any:
    with pytest.raises(Exception) as caught:  # noqa: PT011
        call()
    return caught.value


def plan_through_the_wall(_: int = 0) -> None:
    wend.Map(WALL).free_space().plan((0, 0), (2, 0))


class Through(wend.PlannerBase):
    def search(self, world_state, robot_pose, goal_pose):  # type: ignore[no-untyped-def]
        return [robot_pose, goal_pose]


FAILURES: dict[str, Callable[[], object]] = {
    "NoPath": plan_through_the_wall,
    "a limit": lambda: wend.Map([[0] * 99]).free_space().plan((0, 0), (98, 0), expansions=1),
    "InvalidArgument": lambda: wend.Map([[0, 7]]),
    "Error": lambda: wend.Map.load("no such file.png"),
    "PlannerFault": lambda: wend.testing.check_planner(Through),
}


@pytest.mark.parametrize("kind", FAILURES)
def test_exceptions_survive_pickling(kind: str) -> None:
    failure = a_failure(FAILURES[kind])
    copy = pickle.loads(pickle.dumps(failure))
    assert type(copy) is type(failure)
    assert str(copy) == str(failure) != ""
    names = ("status", "where", "metrics", "reason", "world", "robot_pose", "goal_pose")
    for name in names:
        assert getattr(copy, name, None) == getattr(failure, name, None)


def test_plan_many_answers_survive_pickling() -> None:
    answer = wend.Map(WALL).free_space().plan_many([(0, 0)], [(2, 0)])[0]
    assert str(pickle.loads(pickle.dumps(answer))) == str(answer)


def test_a_pool_passes_on_that_there_is_no_path() -> None:
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        answer = pool.map_async(plan_through_the_wall, [0])
        with pytest.raises(wend.NoPath, match="there is no path"):
            answer.get(timeout=300)


def test_the_reason_is_found_out_when_it_is_read() -> None:
    cells = np.zeros((1200, 1200), dtype=np.int8)
    cells[:, 600] = 1
    cells[::7, 300] = 1
    space = wend.Map(cells).free_space(0.4)
    start, goal = (0.5, 0.5), (1100.5, 0.5)
    space.plan(start, (100.5, 0.5))  # the planner is ready
    space.plan_many([start], [goal])

    def cpu_seconds(call: Callable[[], Any]) -> tuple[Any, float]:
        begun = time.process_time()
        return call(), time.process_time() - begun

    failure, planned = cpu_seconds(lambda: a_failure(lambda: space.plan(start, goal)))
    reason, read = cpu_seconds(lambda: failure.reason)
    assert "connected component" in reason
    assert planned < read / 4
    again, kept = cpu_seconds(lambda: str(failure))
    assert again == reason and kept < read / 4


def test_the_reason_is_that_of_the_map_of_the_moment() -> None:
    space = wend.Map(WALL).free_space()
    failure = a_failure(lambda: space.plan((0, 0), (2, 0)))
    space.edit((1, 0), [[0]])
    assert space.plan((0, 0), (2, 0)).cost == 2
    assert "there is no path from start" in str(failure)


def test_maps_whose_numbers_cannot_tell_cells_apart_are_refused() -> None:
    with pytest.raises(ValueError, match="do not tell cells"):
        wend.Map([[0, 0]], resolution=0.05, origin=(1e16, 0, 0))
    for resolution in (1e12, 1e307, 1e-300):
        with pytest.raises(ValueError, match="resolution"):
            wend.Map([[0, 0]], resolution=resolution)
