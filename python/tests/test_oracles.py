"""Paths and costs on random arrays of any type and layout, against Dijkstra's algorithm of scipy and of networkx.

Both get their graphs from loops in this file, which share nothing with wend.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import networkx
import numpy as np
import numpy.typing as npt
import pytest
import wend
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

Cell = tuple[int, int]
TYPES = ["?", "i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f2", "f4", "f8", "g", ">i4", ">f8"]


class Query(NamedTuple):
    """A world of 0 and 1, what its cells cost, and two cells (x, y) that are free."""

    cells: npt.NDArray[np.int8]
    costs: npt.NDArray[np.float64]
    start: Cell
    goal: Cell


def edges(query: Query, connectivity: int, corner_rule: str) -> Iterator[tuple[Cell, Cell, float]]:
    """Each step once, with its cost: its length times the mean of what its two cells cost."""
    height, width = query.cells.shape
    most_blocked = {"none": 0, "one": 1, "both": 2}[corner_rule]

    def blocked(x: int, y: int) -> bool:
        return not (0 <= x < width and 0 <= y < height) or bool(query.cells[y, x])

    for y, x in itertools.product(range(height), range(width)):
        for dx, dy in [(1, 0), (0, 1)] + [(1, 1), (-1, 1)] * (connectivity == 8):
            beside = 0 if dx * dy == 0 else blocked(x + dx, y) + blocked(x, y + dy)
            if not blocked(x, y) and not blocked(x + dx, y + dy) and beside <= most_blocked:
                mean = (query.costs[y, x] + query.costs[y + dy, x + dx]) / 2
                yield (x, y), (x + dx, y + dy), math.hypot(dx, dy) * float(mean)


Oracle = Callable[[Query, int, str], npt.NDArray[np.float64]]


def with_scipy(query: Query, connectivity: int, corner_rule: str) -> npt.NDArray[np.float64]:
    """The cost of the cheapest path from every cell to the goal: shape (height, width)."""
    height, width = query.cells.shape
    steps = list(edges(query, connectivity, corner_rule))
    rows = [y * width + x for (x, y), _, _ in steps]
    columns = [y * width + x for _, (x, y), _ in steps]
    graph = csr_matrix(([cost for _, _, cost in steps], (rows, columns)), shape=(height * width,) * 2)
    goal = query.goal[1] * width + query.goal[0]
    costs: npt.NDArray[np.float64] = dijkstra(graph, directed=False, indices=goal)
    return costs.reshape(height, width)


def with_networkx(query: Query, connectivity: int, corner_rule: str) -> npt.NDArray[np.float64]:
    """The same."""
    graph = networkx.Graph()
    graph.add_node(query.goal)
    graph.add_weighted_edges_from(edges(query, connectivity, corner_rule))
    costs = np.full(query.cells.shape, np.inf)
    for (x, y), cost in networkx.single_source_dijkstra_path_length(graph, query.goal).items():
        costs[y, x] = cost
    return costs


ORACLES = [with_scipy, with_networkx]


@st.composite
def queries(draw: st.DrawFn, terrain: bool = False) -> Query:
    height = draw(st.integers(1, 12))
    width = draw(st.integers(1, 12))
    numbers = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    cells = (numbers.random((height, width)) < draw(st.sampled_from([0, 0.2, 0.4]))).astype(np.int8)
    costs = np.ones((height, width))
    if terrain:
        rough = numbers.random((height, width)) < 0.5
        costs[rough] += draw(st.sampled_from([1, 8])) * numbers.random(np.count_nonzero(rough))
        costs = np.floor(costs) if draw(st.booleans()) else np.round(256 * costs) / 256  # wend rounds so
    ends = [(draw(st.integers(0, width - 1)), draw(st.integers(0, height - 1))) for _ in range(2)]
    for x, y in ends:
        cells[y, x] = 0
    return Query(cells, costs, ends[0], ends[1])


@st.composite
def laid_out(draw: st.DrawFn, array: npt.NDArray[Any], types: list[str]) -> npt.NDArray[Any]:
    """The same numbers in another type and layout."""
    array = array.astype(draw(st.sampled_from(types)))
    height, width = array.shape
    down, right = draw(st.sampled_from([-3, -1, 1, 2])), draw(st.sampled_from([-2, -1, 1, 3]))
    fields = np.zeros((height * abs(down), width * abs(right)), dtype=[("odd", "u1"), ("number", array.dtype)])
    layout = fields["number"][::down, ::right]
    layout[...] = array
    if draw(st.booleans()):
        layout = np.asfortranarray(layout)
    layout.flags.writeable = draw(st.booleans())
    assert np.array_equal(layout, array)
    return layout


def centre(cell: Cell) -> tuple[float, float]:
    return cell[0] + 0.5, cell[1] + 0.5


def check_path(plan: wend.Plan, query: Query) -> None:
    assert plan.cells.dtype == np.int32
    assert plan.path.dtype == np.float64
    assert np.array_equal(plan.path, plan.cells + 0.5)
    assert not plan.path.flags.writeable and not plan.cells.flags.writeable


def cost_along(cells: list[Cell], query: Query, connectivity: int, corner_rule: str) -> float:
    """Fails if these are not steps from the start to the goal."""
    assert (cells[0], cells[-1]) == (query.start, query.goal)
    cost_of = {frozenset(step[:2]): step[2] for step in edges(query, connectivity, corner_rule)}
    return sum(cost_of[frozenset(step)] for step in zip(cells, cells[1:]))


def check_plan(space: wend.FreeSpace, query: Query, planner: str, moves: Any, expected: float) -> None:
    """A shortest path, or none where there is none."""
    connectivity, corner_rule = moves
    options = {} if planner == "jps" else {"connectivity": connectivity, "corner_rule": corner_rule}
    try:
        plan = space.plan(centre(query.start), centre(query.goal), planner, **options)
    except wend.NoPath as no_path:
        assert no_path.status == "unreachable"
        assert math.isinf(expected)
        return
    assert plan.cost == pytest.approx(expected, rel=1e-12)
    assert plan.bound == 1
    check_path(plan, query)
    cells = [(x, y) for x, y in plan.cells.tolist()]
    assert cost_along(cells, query, connectivity, corner_rule) == pytest.approx(expected, rel=1e-12)


MOVES = [(4, "none"), (8, "none"), (8, "one"), (8, "both")]


@pytest.mark.parametrize("oracle", ORACLES)
@settings(max_examples=60, deadline=None)
@given(query=queries(), moves=st.sampled_from(MOVES), data=st.data())
def test_shortest_paths(oracle: Oracle, query: Query, moves: tuple[int, str], data: st.DataObject) -> None:
    expected = oracle(query, *moves)[query.start[::-1]]
    space = wend.Map(data.draw(laid_out(query.cells, TYPES))).free_space()
    for planner in ["astar", "dijkstra"] + ["jps"] * (moves == (8, "none")):
        check_plan(space, query, planner, moves, expected)


@pytest.mark.parametrize("oracle", ORACLES)
@settings(max_examples=60, deadline=None)
@given(query=queries(terrain=True), moves=st.sampled_from(MOVES), data=st.data())
def test_cheapest_paths(oracle: Oracle, query: Query, moves: tuple[int, str], data: st.DataObject) -> None:
    whole = np.array_equal(query.costs, np.floor(query.costs))
    costs = data.draw(laid_out(query.costs, ["u1", "i2", ">i4", "f2", "f4", "f8"] if whole else ["f8", ">f8", "g"]))
    space = wend.Map(query.cells, costs=costs).free_space()
    expected = oracle(query, *moves)[query.start[::-1]]
    for planner in "astar", "dijkstra":
        check_plan(space, query, planner, moves, expected)


@pytest.mark.parametrize("oracle", ORACLES)
@settings(max_examples=60, deadline=None)
@given(query=queries(), connectivity=st.sampled_from([4, 8]), as_lists=st.booleans(), data=st.data())
def test_search(oracle: Oracle, query: Query, connectivity: Any, as_lists: bool, data: st.DataObject) -> None:
    expected = oracle(query, connectivity, "none")[query.start[::-1]]
    array = data.draw(laid_out(query.cells, TYPES))
    path = wend.search(array.tolist() if as_lists else array, query.start, query.goal, connectivity=connectivity)
    if path is None:
        assert math.isinf(expected)
    else:
        assert cost_along(path, query, connectivity, "none") == pytest.approx(expected)


@pytest.mark.parametrize("oracle", ORACLES)
@settings(max_examples=40, deadline=None)
@given(query=queries(terrain=True), moves=st.sampled_from(MOVES))
def test_cost_to_go_and_policy(oracle: Oracle, query: Query, moves: Any) -> None:
    space = wend.Map(query.cells, costs=query.costs).free_space()
    names = {"connectivity": moves[0], "corner_rule": moves[1]}
    costs = space.cost_to_go(centre(query.goal), **names)
    expected = oracle(query, *moves)
    assert costs == pytest.approx(expected, rel=1e-12)
    policy = space.policy(centre(query.goal), **names)
    path = [query.start]
    while (step := tuple(policy[path[-1][::-1]].tolist())) != (0, 0):
        path.append((path[-1][0] + step[0], path[-1][1] + step[1]))
        assert len(path) <= query.cells.size
    if math.isinf(expected[query.start[::-1]]):
        assert path == [query.start]
    else:
        assert cost_along(path, query, *moves) == pytest.approx(expected[query.start[::-1]], rel=1e-12)


def test_the_oracles_know_corners() -> None:
    query = Query(np.array([[0, 1], [0, 0]], dtype=np.int8), np.ones((2, 2)), (0, 0), (1, 1))
    for oracle in ORACLES:
        costs = [oracle(query, *moves)[0, 0] for moves in MOVES]
        assert costs == pytest.approx([2, 2, math.sqrt(2), math.sqrt(2)])
