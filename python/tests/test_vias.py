"""Paths through places: FreeSpace.plan(via=, closed=)."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import wend

ROOM = np.zeros((20, 30), dtype=np.int8)
ROOM[:15, 10] = 1
ROOM[5:, 20] = 1


def room() -> wend.FreeSpace:
    return wend.Map(ROOM, resolution=0.1).free_space(0.05)


def test_legs_are_plans_made_alone() -> None:
    space = room()
    places = [(0.25, 0.25), (1.55, 1.75), (1.55, 0.35), (2.85, 1.55)]
    plan = space.plan(places[0], places[-1], via=places[1:-1])
    assert [(leg.start, leg.goal) for leg in plan.legs] == [
        ("start", "via 1"),
        ("via 1", "via 2"),
        ("via 2", "goal"),
    ]
    for leg, begin, end in zip(plan.legs, places, places[1:]):
        alone = space.plan(begin, end)
        assert leg.cost == alone.cost and leg.expanded == alone.metrics.expanded
        assert leg.length == pytest.approx(alone.length) and leg.bound == 1 and leg.shift == 0
        assert plan.path[leg.first] == pytest.approx(begin)
        assert plan.path[leg.last] == pytest.approx(end)
    assert plan.cost == pytest.approx(sum(leg.cost for leg in plan.legs))
    assert plan.bound == 1
    assert space.plan(places[0], places[-1]).legs == []


def test_a_closed_path_ends_where_it_begins() -> None:
    plan = room().plan((0.25, 0.25), via=(1.55, 1.75), closed=True)
    assert plan.path[0] == pytest.approx(plan.path[-1])
    assert plan.legs[-1].goal == "start"
    with pytest.raises(wend.InvalidArgument, match="it has no goal"):
        room().plan((0.25, 0.25), (1, 1), via=(1.55, 1.75), closed=True)
    with pytest.raises(ValueError, match="needs a via"):
        room().plan((0.25, 0.25), closed=True)


def test_refined_paths_and_trajectories_go_through_vias() -> None:
    vias = [(1.55, 1.75), (1.55, 0.35)]
    plan = room().plan((0.25, 0.25), (2.85, 1.55), via=vias)
    smooth = plan.smooth(spacing=0.05)
    for leg, via in zip(smooth.legs, vias):
        assert smooth.path[leg.last] == pytest.approx(via)
    flowing, stopping = smooth.trajectory(), smooth.trajectory(stop=True)
    assert stopping.duration > flowing.duration
    rows = stopping.samples(0.01)
    for via in vias:
        nearest = rows[np.argmin(np.hypot(rows[:, 1] - via[0], rows[:, 2] - via[1]))]
        assert abs(nearest[4]) < 0.02


def test_headings_go_on() -> None:
    space = wend.Map(np.zeros((40, 40)), resolution=0.1).free_space("rect:0.4x0.2,0.1")
    plan = space.plan((1, 1, 0), (3, 3, 0), "hybrid_astar", via=[(2, 2, 1.57), (3, 1)], turning_radius=0.3)
    assert plan.path[plan.legs[0].last, 2] == pytest.approx(1.57, abs=1e-6)
    assert np.isinf(plan.bound)


def test_failures_name_the_leg() -> None:
    space = wend.Map([[0, 0, 0, 1, 0]]).free_space()
    with pytest.raises(wend.NoPath, match="leg 2 of 2, from via 1 to the goal: there is no path") as failure:
        space.plan((0, 0), (4, 0), via=(2, 0))
    assert failure.value.status == "unreachable"


@pytest.mark.parametrize("via", [(float("nan"), 0), [(1, 1), None], 5, [(1,)]])
def test_what_is_no_via(via: Any) -> None:
    with pytest.raises(wend.InvalidArgument) as error:
        room().plan((0.25, 0.25), (2.85, 1.55), via=via)
    assert error.value.where == "via"
