"""Planning, smoothing, following and indexes; test_oracles.py compares costs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import wend

ROOM = np.zeros((20, 30), dtype=np.int8)
ROOM[:15, 10] = 1
ROOM[5:, 20] = 1


def room(footprint: Any = 0.1) -> wend.FreeSpace:
    return wend.Map(ROOM, resolution=0.1).free_space(footprint)


def test_footprints_as_texts_and_rectangles() -> None:
    corners = wend.rectangle(0.4, 0.2, ahead=0.3)
    for footprint in (corners, "rect:0.4x0.2,0.3", [*corners, corners[0]]):
        space = room(footprint)
        assert np.array_equal(space.passable, room(corners).passable)
    with pytest.raises(wend.InvalidArgument, match="write rect:LENGTHxWIDTH"):
        room("rect:0.4")
    open_space = wend.Map(np.zeros((40, 40)), resolution=0.1).free_space("rect:0.4x0.2,0.3")
    plan = open_space.plan((1, 1), (3, 3))
    assert len(plan.notes) == 1 and "planned as the disc around its base point" in plan.notes[0]
    assert open_space.plan((1, 1, 0), (3, 3, 0), "hybrid_astar", turning_radius=0.3).notes == []


def test_metres_and_frames() -> None:
    turned = wend.Map(ROOM, resolution=0.1, origin=(5, -3, math.pi / 2)).free_space()
    straight = wend.Map(ROOM, resolution=0.1).free_space()
    path = straight.plan((0.25, 0.25), (2.85, 1.55)).path
    other = turned.plan((5 - 0.25, -3 + 0.25), (5 - 1.55, -3 + 2.85)).path
    assert other[:, 0] == pytest.approx(5 - path[:, 1])
    assert other[:, 1] == pytest.approx(-3 + path[:, 0])


def test_headings_and_goals() -> None:
    plan = room().plan((0.5, 0.5, 0), (2.5, 1.5, 1.0), "car", lattice_resolution=2)
    assert plan.path.shape == (len(plan.moves) + 1, 3)
    goals: list[Any] = [(2.5, 1.5), np.array([0.75, 0.55])]
    assert tuple(room().plan((0.55, 0.55), goals).cells[-1]) == (7, 5)
    assert tuple(room().plan([0.55, 0.55], [0.75, 0.55]).cells[-1]) == (7, 5)


@pytest.mark.parametrize(
    ("call", "where"),
    [
        (lambda space: space.plan((float("nan"), 0), (1, 1)), "start"),
        (lambda space: space.plan((0.5, 0.5), (float("inf"), 1)), "goal"),
        (lambda space: space.plan((0.5,), (1, 1)), "start"),
        (lambda space: space.plan("ab", (1, 1)), "start"),
        (lambda space: space.plan(None, (1, 1)), "start"),
        (lambda space: space.plan((0.5, 0.5), [(1, 1), None]), "goal"),
        (lambda space: space.plan((0.5, 0.5), None), "goal"),
        (lambda space: space.plan((0.5, 0.5), []), "goal"),
        (lambda space: space.plan((0.5, 0.5), 7), "goal"),
        (lambda space: space.plan((0.5, 0.5), np.zeros((2, 2, 2))), "goal"),
        (lambda space: space.plan((0.5, 0.5), (1, 1), expansions=-1), "expansions"),
        (lambda space: space.plan((0.5, 0.5), (1, 1), weight="heavy"), "weight"),
        (lambda space: space.plan((0.5, 0.5), (1, 1), weight=[1]), "weight"),
        (lambda space: space.plan((0.5, 0.5), (1, 1), no_such_option=1), "no_such_option"),
        (lambda space: space.plan((0.5, 0.5), (1, 1), time_limit=-1), "time_limit"),
        (lambda space: space.plan((0.5, 0.5), (1, 1), time_limit=float("nan")), "time_limit"),
        (lambda space: space.plan((0.5, 0.5), (1, 1), tolerance=float("nan")), "tolerance"),
        (lambda space: space.plan((0.5, 0.5), (1, 1), heading_tolerance=-1), "heading_tolerance"),
        (lambda space: space.plan_many([(0, 0)], []), "goals"),
        (lambda space: space.plan_many([], [], threads=-1), "threads"),
        (lambda space: space.cost_to_go((99, 99)), "goal"),
        (lambda space: space.cost_to_go((1, 1), corner_rule="maybe"), "corner_rule"),
        (lambda space: space.fits((1, float("nan"))), "pose"),
        (lambda space: space.map.free_space(-1), "radius"),
        (lambda space: space.map.free_space([(0, 0), (1, "x"), (1, 1)]), "footprint[1]"),
        (lambda space: space.map.free_space(unknown="maybe"), "unknown"),
    ],
)
def test_invalid_arguments_are_named(call: Any, where: str) -> None:
    with pytest.raises(wend.InvalidArgument) as caught:
        call(room())
    assert caught.value.where == where


def test_unknown_planner_suggests_one() -> None:
    with pytest.raises(ValueError, match="did you mean 'astar'"):
        room().plan((0.5, 0.5), (1, 1), "astr")


def test_no_path_says_why() -> None:
    with pytest.raises(wend.NoPath) as caught:
        room().plan((1.05, 0.5), (2, 1))
    assert caught.value.status == "start_blocked"
    assert "obstacle" in caught.value.reason
    with pytest.raises(wend.NoPath) as caught:
        room().plan((0.5, 0.5), (99, 1))
    assert caught.value.status == "goal_outside"
    with pytest.raises(wend.NoPath) as caught:
        room().plan((0.55, 0.55), (2.85, 1.55), expansions=3)
    assert caught.value.status == "expansion_limit"
    assert caught.value.metrics.expanded == 3
    with pytest.raises(wend.NoPath) as caught:
        room().plan((0.55, 0.55), (2.85, 1.55), time_limit=0)
    assert caught.value.status == "time_limit"
    near = room().plan((0.5, 0.5), (1.05, 0.5), tolerance=0.25)
    assert math.dist(near.path[-1], (1.05, 0.5)) <= 0.25
    plan = room().plan((1.05, 0.5), (0.55, 0.55), nearest=True)
    assert plan.notes and "start" in plan.notes[0]


@pytest.mark.parametrize("planner", ["astar", "theta_star", "lattice", "hybrid_astar"])
def test_leads_out_of_what_blocks_the_start(planner: str) -> None:
    space = room()
    ends = (1.15, 0.55, 0.2), (2.5, 0.25)
    with pytest.raises(wend.NoPath, match=r"escape=0\."):
        space.plan(*ends, planner)
    plan = space.plan(*ends, planner, escape=0.3)
    assert plan.lead_out is not None and plan.notes
    assert 0 < plan.lead_out.length <= 0.3
    assert "fit" in plan.lead_out.reason or "blocked" in plan.lead_out.reason
    assert space.fits(plan.path[plan.lead_out.points]) and not space.fits(plan.path[0])
    assert plan.path[0][:2] == pytest.approx(ends[0][:2])
    assert space.plan((0.5, 0.5, 0), (0.5, 1), planner, escape=0.3).lead_out is None
    smooth = plan.smooth()
    points = plan.lead_out.points
    assert smooth.path[:points] == pytest.approx(plan.path[:points])
    assert wend.follow(plan).outcome != "collision"
    with pytest.raises(wend.InvalidArgument, match="escape"):
        space.plan(*ends, planner, escape=-1)


def test_ends_at_the_closest_place() -> None:
    cells = ROOM.copy()
    cells[:, 20] = 1
    space = wend.Map(cells, resolution=0.1).free_space()
    with pytest.raises(wend.NoPath):
        space.plan((0.5, 0.5), (2.55, 0.55))
    plan = space.plan((0.5, 0.5), (2.55, 0.55), closest=True)
    assert plan.remaining == pytest.approx(0.6)
    assert plan.path[-1] == pytest.approx((1.95, 0.55))
    assert space.plan((0.5, 0.5), (0.5, 1), closest=True).remaining == 0
    assert space.plan((0.5, 0.5), (0.5, 1)).remaining is None


def test_eases_many_queries_and_solutions() -> None:
    cells = ROOM.copy()
    cells[:, 20] = 1
    space = wend.Map(cells, resolution=0.1).free_space()
    ends = (0.5, 0.5), (2.55, 0.55)
    one = space.plan(*ends, closest=True)
    many = space.plan_many([ends[0]] * 3, [ends[1]] * 3, closest=True)
    for plan in [*many, *space.solutions(*ends, closest=True)]:
        assert isinstance(plan, wend.Plan)
        assert plan.remaining == one.remaining
        assert plan.notes == one.notes
        assert plan.path[-1] == pytest.approx(one.path[-1])
    space = room()
    ends = (1.15, 0.55), (2.5, 0.25)
    out = space.plan(*ends, escape=0.3)
    assert out.lead_out is not None
    for plan in [*space.plan_many(ends[:1], ends[1:], escape=0.3), *space.solutions(*ends, escape=0.3)]:
        assert isinstance(plan, wend.Plan)
        assert plan.lead_out == out.lead_out
        assert plan.path[0] == pytest.approx(out.path[0])
    with pytest.raises(wend.InvalidArgument, match="escape"):
        space.plan_many(ends[:1], ends[1:], escape=-1)
    with pytest.raises(wend.NoPath):
        next(space.solutions(*ends))


def test_ends_are_cells_where_a_map_has_no_metres() -> None:
    space = wend.Map([[0, 0, 0, 1, 0]]).free_space()
    plan = space.plan((0, 0), (4, 0), closest=True)
    assert (plan.remaining, plan.start_shift, plan.goal_shift) == (2, 0, 2)


def test_says_how_far_ends_moved_and_in_which_gear() -> None:
    space = wend.Map(np.zeros((9, 9)), resolution=0.5).free_space()
    plan = space.plan((1.1, 1.2), (3.1, 3.4))
    assert plan.start_shift == pytest.approx(math.dist(plan.path[0], (1.1, 1.2)))
    assert plan.goal_shift == pytest.approx(math.dist(plan.path[-1], (3.1, 3.4)))
    assert plan.gears == [1] * (len(plan.path) - 1)
    back = space.plan((3, 2, 0), (1, 2, 0), "hybrid_astar")
    assert set(back.gears) == {-1}


def distance_to_line(point: Any, one: Any, other: Any) -> float:
    along = np.dot(point - one, other - one) / max(np.dot(other - one, other - one), 1e-12)
    return math.dist(point, one + np.clip(along, 0, 1) * (other - one))


def test_smooths_no_farther_than_a_distance() -> None:
    plan = wend.Map(np.zeros((40, 40)), resolution=0.1).free_space().plan((0.2, 0.2), (3.5, 1.2))
    near = plan.smooth(max_distance=0.01)
    for point in near.path:
        assert min(distance_to_line(point, *ends) for ends in zip(plan.path, plan.path[1:])) < 0.01 + 1e-9
    assert near.quality().length <= plan.quality().length
    with pytest.raises(ValueError, match="max_distance"):
        plan.smooth(max_distance=-1)


def test_moves_ends_no_farther_than_a_limit() -> None:
    cells = ROOM.copy()
    cells[:, 20] = 1
    space = wend.Map(cells, resolution=0.1).free_space()
    ends = (0.5, 0.5), (2.55, 0.55)
    assert space.plan(*ends, nearest=True).remaining == pytest.approx(0.6)
    with pytest.raises(wend.NoPath, match="more than the limit of 0.5 m"):
        space.plan(*ends, nearest=True, nearest_limit=0.5)


def test_explains() -> None:
    cells = ROOM.copy()
    cells[15:, 10] = -1
    space = wend.Map(cells, resolution=0.1).free_space(0.1)
    why = space.explain((0.5, 0.5), (2.5, 1.5))
    assert not why.path_exists
    assert why.ways[0].unknown_free
    assert why.start_component == (space.cost_to_go((0.5, 0.5)) < np.inf).sum()
    assert "unknown" in why.text
    assert room().explain((0.5, 0.5), (2.5, 1.5)).path_exists
    assert room().why_blocked((1.05, 0.55)) == "an obstacle"
    assert room().why_blocked((0.55, 0.55)) is None


def test_explains_drives() -> None:
    cells = np.zeros((9, 21))
    cells[[0, 1, 2, 5, 6, 7, 8], 10] = 1

    def space_of(scale: float) -> wend.FreeSpace:
        corners = [(1.5, 1.15), (1.5, -1.15), (-1.5, -1.15), (-1.5, 1.15)]
        robot = [(scale * x, scale * y) for x, y in corners]
        return wend.Map(cells, resolution=0.5).free_space(robot, outside="blocked")

    space = space_of(0.5)
    start, goal = (2, 2, 0), (8, 2, 0)
    why = space.explain_drive(start, goal, turning_radius=1)
    assert not why.drive_exists and why.turning_radius is None and why.reverse_helps is None
    assert why.footprint_scale is not None and 0.7 < why.footprint_scale <= 1 / 1.15
    assert why.narrowest is not None and why.narrowest[0] == 5.25 and why.narrowest_radius == 0.25
    assert "A drive exists with a footprint of at most" in why.text
    smaller = space_of(0.5 * why.footprint_scale)
    assert smaller.explain_drive(start, goal, turning_radius=1).drive_exists
    assert smaller.explain_drive(start, goal[:2], turning_radius=1).text == "there is a drive"
    with pytest.raises(wend.InvalidArgument, match="turning_radius greater than 0"):
        space.explain_drive(start, goal, turning_radius=0)


def test_passable_and_clearance_agree() -> None:
    space = room(0.25)
    assert space.passable.dtype == np.bool_
    assert np.array_equal(space.passable, space.clearance >= 0.25 - 1e-9)
    x, y, heading = space.nearest((1.05, 0.5, 1.25))
    assert space.fits((x, y, heading)) and heading == 1.25


@pytest.mark.parametrize("threads", [0, 1, 3])
def test_plan_many_is_plan(threads: int) -> None:
    space = room()
    starts = [(0.15 + 0.1 * i, 0.15) for i in range(8)] + [(1.05, 0.5)]
    goals = [(2.85, 1.85)] * 9
    plans = space.plan_many(starts, goals, threads=threads)
    for start, goal, plan in zip(starts[:-1], goals, plans):
        assert isinstance(plan, wend.Plan)
        assert np.array_equal(plan.path, space.plan(start, goal).path)
    assert isinstance(plans[-1], wend.NoPath) and plans[-1].status == "start_blocked"
    with pytest.raises(wend.InvalidArgument):
        space.plan_many(starts, goals, "astr", threads=threads)
    assert space.plan_many([], []) == []


def test_smooth_trajectory_and_follow() -> None:
    plan = room().plan((0.55, 0.55), (2.85, 1.55))
    smooth = plan.smooth(simplify="sight", spacing=0.05)
    assert smooth.length < plan.length
    assert smooth.path[[0, -1]] == pytest.approx(plan.path[[0, -1]])
    assert smooth.quality().smallest_clearance >= 0.1 - 1e-9
    trajectory = smooth.trajectory(speed=0.25)
    rows = trajectory.samples(0.1)
    assert rows.shape == (math.floor(trajectory.duration / 0.1) + 2, 6)
    assert rows[:, 4].max() <= 0.25 + 1e-9
    assert rows[-1, :3] == pytest.approx([trajectory.duration, *smooth.path[-1]])
    assert trajectory.at(1e9)[1:] == pytest.approx(rows[-1, 1:])
    straight = room().plan((0.25, 0.25), (0.75, 1.75)).smooth()
    drive = wend.follow(straight, "pid", simulation={"seed": 3, "position_noise": 0.01})
    assert drive.outcome == "reached" and drive.collisions == 0
    assert drive.final_error <= 0.1
    assert drive.samples[0, 1:3] == pytest.approx(straight.path[0])
    for call in (
        lambda: plan.smooth("magic"),
        lambda: plan.smooth(simplify="magic"),  # type: ignore[arg-type]
        lambda: plan.trajectory(speed=-1),
        lambda: trajectory.samples(0),
        lambda: wend.follow(plan, "magic"),
        lambda: wend.follow(plan, model={"drivetrain": "magic"}),
    ):
        with pytest.raises(wend.InvalidArgument):
            call()


def test_follow_turns_to_the_heading_of_the_goal() -> None:
    plan = room().plan((0.35, 0.35, 0), (0.65, 1.2, 2.5), "hybrid_astar", motion_model="differential")
    drive = wend.follow(plan)
    assert drive.outcome == "reached"
    assert abs(drive.final_heading_error) <= 0.1
    assert wend.follow(plan, follower={"heading_tolerance": 0}).outcome == "reached"
    with pytest.raises(wend.InvalidArgument, match="which a bicycle cannot drive|tighter than the bicycle"):
        wend.follow(plan, model={"drivetrain": "bicycle"})


def test_index_saves_and_opens(tmp_path: Any) -> None:
    space = room()
    wend.Index.build(space, "hub_labels", threads=2).save(tmp_path / "room.idx")
    index = wend.Index.open(tmp_path / "room.idx")
    space.use_index(index)
    found = space.plan((0.55, 0.55), (2.85, 1.55), "hub_labels")
    assert found.cost == pytest.approx(space.plan((0.55, 0.55), (2.85, 1.55)).cost)
    other = room(0.2)
    other.use_index(index)
    with pytest.raises(wend.Error) as caught:
        other.plan((0.55, 0.55), (2.85, 1.55), "hub_labels")
    assert caught.value.status == "index_mismatch"
    with pytest.raises(wend.InvalidArgument):
        wend.Index.build(space, "astar")
    (tmp_path / "bad.idx").write_bytes(b"bad")
    with pytest.raises(wend.Error):
        wend.Index.open(tmp_path / "bad.idx")


def test_registries_describe_themselves() -> None:
    for planner in wend.planners():
        assert planner.summary and planner.paper and planner.when
    astar = {planner.name: planner for planner in wend.planners()}["astar"]
    assert "weight" in [option.name for option in astar.options]
    assert astar.guarantee == "bounded" or astar.guarantee == "optimal"


def test_solutions_get_better_until_the_best() -> None:
    space = room()
    best = space.plan((0.55, 0.15), (2.55, 1.85))
    plans = list(space.solutions((0.55, 0.15), (2.55, 1.85), initial_weight=10, weight_step=0.5))
    costs, bounds = [plan.cost for plan in plans], [plan.bound for plan in plans]
    assert costs == sorted(costs, reverse=True)
    assert bounds == sorted(bounds, reverse=True)
    assert bounds[-1] == 1
    assert plans[-1].cost == pytest.approx(best.cost)
    for plan in plans:
        assert best.cost * (1 - 1e-9) <= plan.cost <= plan.bound * best.cost * (1 + 1e-9)


@pytest.mark.parametrize("planner", ["lattice", "car"])
def test_solutions_of_robots_with_headings_end_with_the_best(planner: str) -> None:
    space = room()
    ends = ((0.5, 0.5, 0), (2.5, 1.5, 0))
    best = space.plan(*ends, planner=planner)
    plans = list(space.solutions(*ends, planner=planner, initial_weight=10))
    assert [plan.bound for plan in plans] == sorted((plan.bound for plan in plans), reverse=True)
    assert plans[-1].bound == 1
    assert plans[-1].cost == pytest.approx(best.cost)
    with pytest.raises(ValueError, match=f"{planner} is not an anytime planner"):
        space.solutions(*ends, planner=planner)


def test_solutions_end_at_a_limit_with_the_answer_of_plan() -> None:
    space = room()
    ends = ((0.55, 0.15), (2.55, 1.85))
    needed = space.plan(*ends, planner="ara_star").metrics.expanded
    for expansions in range(needed // 2, needed + 1, 7):
        try:
            answer = space.plan(*ends, planner="ara_star", expansions=expansions)
        except wend.NoPath as failure:
            assert failure.status == "expansion_limit"
            continue
        plans = list(space.solutions(*ends, expansions=expansions))
        assert (plans[-1].cost, plans[-1].bound) == (answer.cost, answer.bound)
    with pytest.raises(wend.NoPath, match=r"stopped after 1 expansion \(expansions=1\)"):
        next(space.solutions(*ends, expansions=1))


def test_solutions_need_an_anytime_planner() -> None:
    with pytest.raises(ValueError, match="astar is not an anytime planner"):
        room().solutions((0.5, 0.5), (1, 1), planner="astar")
    with pytest.raises(wend.NoPath):
        next(room().solutions((0.5, 0.5), (100, 1)))
