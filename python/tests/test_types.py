"""Arguments of a wrong type, and numbers that are not finite, are refused by name; nothing else changes."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import wend

# Any: mypy would refuse the calls below.
untyped: Any = wend
WORLD: Any = np.zeros((5, 6), dtype=int)
MAP: Any = wend.Map(WORLD, resolution=0.5)
SPACE: Any = MAP.free_space()
PLAN: Any = SPACE.plan((0.1, 0.1), (2, 2))
ENDS: Any = ((0, 0), (1, 1))
ANYTHING: Any = None


@pytest.mark.parametrize(
    ("call", "where"),
    [
        (lambda: untyped.Map(WORLD, resolution="a"), "resolution"),
        (lambda: untyped.Map(WORLD, origin="ab"), "origin"),
        (lambda: untyped.Map(WORLD, origin=None), "origin"),
        (lambda: untyped.Map(WORLD, origin=5), "origin"),
        (lambda: untyped.Map(WORLD, y_up="no"), "y_up"),
        (lambda: untyped.Map.load(5), "file"),
        (lambda: untyped.Map.load(None), "file"),
        (lambda: untyped.Map.load("map.png", resolution="x"), "resolution"),
        (lambda: MAP.save(3), "file"),
        (lambda: MAP.free_space(object()), "footprint"),
        (lambda: MAP.free_space(unknown=None), "unknown"),
        (lambda: MAP.free_space(outside=3), "outside"),
        (lambda: MAP.free_space(clearance_distance="a"), "clearance_distance"),
        (lambda: MAP.free_space(warm=-1), "warm"),
        (lambda: MAP.free_space(warm=1.5), "warm"),
        (lambda: SPACE.plan(*ENDS, None), "planner"),
        (lambda: SPACE.plan(*ENDS, time_limit="1"), "time_limit"),
        (lambda: SPACE.plan(*ENDS, expansions=1.5), "expansions"),
        (lambda: SPACE.plan(*ENDS, expansions=2**70), "expansions"),
        (lambda: SPACE.plan(*ENDS, nearest="yes"), "nearest"),
        (lambda: SPACE.plan(*ENDS, nearest_limit="far"), "nearest_limit"),
        (lambda: SPACE.plan(*ENDS, escape="far"), "escape"),
        (lambda: SPACE.plan(*ENDS, closest=1.5), "closest"),
        (lambda: SPACE.plan(*ENDS, tolerance="a"), "tolerance"),
        (lambda: SPACE.plan_many(None, None), "starts"),
        (lambda: SPACE.plan_many([(0, 0)], [None]), "goal"),
        (lambda: SPACE.plan_many([(math.nan, 0)], [(1, 1)]), "start"),
        (lambda: SPACE.plan_many([(0, 0)], [(1, 1)], threads="2"), "threads"),
        (lambda: SPACE.plan_many([], [], threads=1.5), "threads"),
        (lambda: SPACE.trace(*ENDS, 3), "planner"),
        (lambda: SPACE.policy(ENDS[0], corner_rule=3), "corner_rule"),
        (lambda: SPACE.use_index(None), "index"),
        (lambda: PLAN.smooth(3), "smoother"),
        (lambda: PLAN.smooth(simplify=3), "simplify"),
        (lambda: PLAN.smooth(spacing="a"), "spacing"),
        (lambda: PLAN.smooth(spacing=math.nan), "spacing"),
        (lambda: PLAN.smooth(spacing=0), "spacing"),
        (lambda: PLAN.trajectory(corner_rounding="a"), "corner_rounding"),
        (lambda: PLAN.trajectory(corner_rounding=math.nan), "corner_rounding"),
        (lambda: PLAN.trajectory(corner_rounding=-1), "corner_rounding"),
        (lambda: PLAN.trajectory().samples("a"), "period"),
        (lambda: PLAN.trajectory().at(None), "time"),
        (lambda: untyped.follow(None), "plan"),
        (lambda: untyped.follow(PLAN, 3), "controller"),
        (lambda: untyped.follow(PLAN, model=[1]), "model"),
        (lambda: untyped.Index.build(None), "space"),
        (lambda: untyped.Index.build(SPACE, 3), "planner"),
        (lambda: untyped.Index.open(None), "file"),
        (lambda: untyped.search(WORLD, *ENDS, None), "planner"),
        (lambda: untyped.search(WORLD, *ENDS, wend.PlannerBase), "planner"),
        (lambda: untyped.compare(WORLD, *ENDS, [None]), "planner"),
        (lambda: untyped.compare(WORLD, *ENDS, repetitions=1.5), "repetitions"),
    ],
)
def test_the_argument_is_named(call: Callable[[], Any], where: str) -> None:
    with pytest.raises(wend.InvalidArgument, match=where) as caught:
        call()
    assert caught.value.where == where


def test_names_of_options_are_strings() -> None:
    with pytest.raises(wend.InvalidArgument, match="strings, not int"):
        untyped.follow(PLAN, simulation={1: 2})


def test_numbers_of_numpy_are_numbers() -> None:
    numbers: Any = {"time_limit": np.float32(1), "expansions": np.int64(100), "tolerance": np.float64(0.5)}
    goal: Any = (np.float32(2), np.float64(2))
    plan = SPACE.plan(np.array([0.1, 0.1]), goal, **numbers)
    assert plan.cost <= PLAN.cost
    radii: list[Any] = [np.array(0.25), np.float32(0.25)]
    assert all(MAP.free_space(radius).fits((1, 1)) for radius in radii)
    assert len(SPACE.plan_many(iter([(0, 0)]), iter([(1, 1)]), threads=int(np.int8(1)))) == 1


def test_errors_of_a_planner_of_ones_own_stay_what_they_are() -> None:
    class Wrong(wend.PlannerBase):
        def search(self, world_state: Any, robot_pose: Any, goal_pose: Any) -> Any:
            return len(ANYTHING)

    calls: list[Callable[[], Any]] = [
        lambda: untyped.search(WORLD, *ENDS, Wrong()),
        lambda: untyped.compare(WORLD, *ENDS, [Wrong()]),
    ]
    for call in calls:
        with pytest.raises(TypeError, match="has no len"):
            call()


def test_a_missing_argument_is_what_python_says() -> None:
    with pytest.raises(TypeError, match="missing 1 required"):
        SPACE.plan((0, 0))
