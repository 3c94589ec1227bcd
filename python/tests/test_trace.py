"""Traces: the layers are those of the events, and the search is that of plan()."""

from __future__ import annotations

import numpy as np
import pytest
import wend

ROOM = np.zeros((12, 18), dtype=np.int8)
ROOM[:9, 6] = 1
ROOM[3:, 12] = 1
START, GOAL = (0.5, 0.5), (17.5, 11.5)


@pytest.mark.parametrize("planner", ["astar", "dijkstra", "bfs", "dfs", "greedy", "jps", "theta_star"])
def test_layers_are_those_of_the_events(planner: str) -> None:
    space = wend.Map(ROOM).free_space()
    trace = space.trace(START, GOAL, planner)
    plan = space.plan(START, GOAL, planner)
    assert trace.plan is not None and trace.failure is None
    assert np.array_equal(trace.plan.path, plan.path)
    events = list(trace.events())
    assert len(events) == len(trace)
    expanded = [event.cell for event in events if event.kind == "expand"]
    assert len(expanded) == plan.metrics.expanded
    assert [tuple(cell) for cell in trace.order.tolist()] == expanded
    assert sum(event.kind == "generate" for event in events) == plan.metrics.generated
    for number, (x, y) in enumerate(expanded, 1):
        assert trace.expansion[y, x] == number
    last = {event.cell: event for event in events}
    for (x, y), event in last.items():
        assert (trace.g[y, x], trace.h[y, x], trace.f[y, x]) == (event.g, event.h, event.f)
    assert np.isfinite(trace.g).sum() == len(last)
    assert (trace.generation > 0).sum() == len(last)
    assert (trace.parents[..., 0] >= 0).sum() == len(last) - 1


def test_parents_lead_to_the_start() -> None:
    trace = wend.Map(ROOM).free_space().trace(START, GOAL, "dijkstra")
    x, y = 17, 11
    costs = []
    while x >= 0:
        costs.append(trace.g[y, x])
        x, y = trace.parents[y, x].tolist()
    assert costs[-1] == 0
    assert costs == sorted(costs, reverse=True)


def test_a_failed_search_has_a_trace() -> None:
    cells = ROOM.copy()
    cells[:, 12] = 1
    trace = wend.Map(cells).free_space().trace(START, GOAL, "bfs")
    assert trace.plan is None and trace.failure is not None
    assert trace.failure.status == "unreachable"
    limited = wend.Map(ROOM).free_space().trace(START, GOAL, expansions=5)
    assert limited.failure is not None and limited.failure.status == "expansion_limit"
    assert len(limited.order) == 5
    with pytest.raises(wend.InvalidArgument):
        wend.Map(ROOM).free_space().trace(START, GOAL, "astr")


def test_a_car_has_vertices_and_headings() -> None:
    trace = wend.Map(ROOM).free_space().trace((2, 2, 0), (16, 10), "car")
    assert all(event.heading is not None for event in trace.events())
    assert trace.expansion.shape[0] in (12, 13)
