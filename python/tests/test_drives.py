"""hybrid_astar: a robot with a shape, a heading and a turning radius."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import wend

CELL = 0.1
CAR = [(0.45, 0.2), (0.45, -0.2), (-0.15, -0.2), (-0.15, 0.2)]
OPTIONS: dict[str, Any] = {"turning_radius": 0.6}

# Two parked cars with a gap between them at one edge, and a wall at the other one.
STREET = np.zeros((30, 60), dtype=np.int8)
STREET[:6, :20] = STREET[:6, 30:] = STREET[26:] = 1


def street() -> wend.FreeSpace:
    return wend.Map(STREET, resolution=CELL).free_space(CAR, outside="blocked")


def blocked_under(pose: npt.NDArray[np.float64]) -> bool:
    """Does the car, as a net of points, lie on an obstacle or off the map?"""
    along, aside = np.meshgrid(np.linspace(-0.149, 0.449, 40), np.linspace(-0.199, 0.199, 28))
    x = pose[0] + along * math.cos(pose[2]) - aside * math.sin(pose[2])
    y = pose[1] + along * math.sin(pose[2]) + aside * math.cos(pose[2])
    columns = np.floor(x / CELL).astype(int)
    rows = np.floor(y / CELL).astype(int)
    inside = (columns >= 0) & (columns < STREET.shape[1]) & (rows >= 0) & (rows < STREET.shape[0])
    return not inside.all() or bool(STREET[rows, columns].any())


def turned(a: float, b: float) -> float:
    return math.remainder(b - a, 2 * math.pi)


def test_parks_in_a_gap() -> None:
    start, goal = (0.5, 1.6, 0.0), (2.3, 0.3, 0.0)
    plan = street().plan(start, goal, "hybrid_astar", **OPTIONS)
    assert plan.path[0] == pytest.approx(start) and plan.path[-1] == pytest.approx(goal, abs=1e-6)
    assert len(plan.moves) == len(plan.path) - 1
    assert any(move.startswith("REV") for move in plan.moves)
    quality = plan.quality()
    assert quality.reversals >= 1 and quality.smallest_turning_radius >= 0.6 * (1 - 1e-6)
    assert plan.cost * CELL >= plan.length > math.dist(start[:2], goal[:2])
    assert math.isinf(plan.bound)
    poses = plan.smooth(None, spacing=0.02).path
    steps = np.hypot(*np.diff(poses[:, :2], axis=0).T)
    assert steps.max() < 0.021
    assert not any(blocked_under(pose) for pose in poses)
    turns = np.array([turned(a[2], b[2]) for a, b in zip(poses, poses[1:])])
    assert (np.abs(turns) <= steps / 0.6 * 1.01 + 1e-6).all()


def test_any_heading_and_several_goals() -> None:
    space = street()
    exact = space.plan((0.5, 1.6, 0), (4.5, 1.6, math.pi), "hybrid_astar", **OPTIONS)
    free = space.plan((0.5, 1.6, 0), (4.5, 1.6), "hybrid_astar", **OPTIONS)
    assert free.cost < exact.cost
    both = space.plan((0.5, 1.6, 0), [(4.5, 1.6, math.pi), (3.0, 1.6, 0)], "hybrid_astar", **OPTIONS)
    assert both.path[-1] == pytest.approx((3.0, 1.6, 0), abs=1e-6)
    near = space.plan((0.5, 1.6, 0), (4.5, 1.6, 0.3), "hybrid_astar", tolerance=0.2, heading_tolerance=0.4, **OPTIONS)
    assert math.dist(near.path[-1][:2], (4.5, 1.6)) <= 0.2 + 1e-6
    assert abs(turned(near.path[-1][2], 0.3)) <= 0.4 + 1e-6


def test_models() -> None:
    space = wend.Map(np.zeros((40, 40)), resolution=CELL).free_space(0.15)
    start, goal = (1, 1, 0), (2.5, 2, math.pi)
    ahead = space.plan(start, goal, "hybrid_astar", allow_reverse=False, **OPTIONS)
    assert not any(move.startswith("REV") for move in ahead.moves)
    dubins = space.plan(start, goal, "hybrid_astar", motion_model="dubins", **OPTIONS)
    assert dubins.cost == ahead.cost and dubins.path.tolist() == ahead.path.tolist()
    dear = space.plan(start, goal, "hybrid_astar", reverse_factor=20, **OPTIONS)
    assert dear.cost >= space.plan(start, goal, "hybrid_astar", **OPTIONS).cost - 1e-6


def test_says_what_is_wrong() -> None:
    space = street()
    with pytest.raises(wend.NoPath, match="corner lies in the obstacle") as blocked:
        space.plan((0.5, 1.6, 0), (1.7, 0.75, 0), "hybrid_astar", **OPTIONS)
    assert blocked.value.status == "goal_blocked"
    with pytest.raises(wend.InvalidArgument, match="differential"):
        space.plan((0.5, 1.6, 0), (4, 1.6, 0), "hybrid_astar", turning_radius=0)
    with pytest.raises(ValueError, match="start"):
        space.plan((0.5, 1.6, math.nan), (4, 1.6, 0), "hybrid_astar")
    walled = STREET.copy()
    walled[:, 35] = 1
    with pytest.raises(wend.NoPath, match="obstacles separate the two") as parted:
        wend.Map(walled, resolution=CELL).free_space(CAR).plan((0.5, 1.6, 0), (5, 1.6, 0), "hybrid_astar", **OPTIONS)
    assert parted.value.metrics.expanded == 0


def test_the_same_drive_again_and_in_many() -> None:
    space = street()
    starts = [(0.5, 1.6, 0), (4.5, 1.6, 3.0)]
    goals = [(2.3, 0.3, 0), (2.7, 0.3, math.pi)]
    one = [space.plan(start, goal, "hybrid_astar", **OPTIONS) for start, goal in zip(starts, goals)]
    many = space.plan_many(starts, goals, "hybrid_astar", threads=2, **OPTIONS)
    for alone, among in zip(one, many):
        assert isinstance(among, wend.Plan)
        assert among.path.tolist() == alone.path.tolist() and among.cost == alone.cost


def test_a_limit_ends_with_what_there_is() -> None:
    space = street()
    few = space.plan((0.5, 1.6, 0), (4.5, 1.6, 0), "hybrid_astar", expansions=1, **OPTIONS)
    assert few.metrics.expanded <= 1
    with pytest.raises(wend.NoPath) as none:
        space.plan((0.5, 1.6, 0), (2.7, 0.3, math.pi), "hybrid_astar", expansions=1, **OPTIONS)
    assert none.value.status == "expansion_limit"


def test_traces_the_ways_between_states() -> None:
    start, goal = (0.5, 1.6, 0.0), (2.3, 0.3, 0.0)
    trace = street().trace(start, goal, "hybrid_astar", **OPTIONS)
    events = list(trace.events())
    assert events[0].way is None and events[0].parent is None
    for event in events[1:]:
        if event.parent is None:  # the start, when it is expanded
            assert event.way is None
            continue
        assert event.way is not None and event.way.shape[0] >= 2
        assert np.floor(event.way[-1, :2]).astype(int).tolist() == list(event.cell)
        assert np.floor(event.way[0, :2]).astype(int).tolist() == list(event.parent)
        assert event.way[-1, 2] == event.heading
    assert any(event.parent is not None for event in events)
