"""Times wend beside other Python packages on MovingAI maps and on a world of 20 x 20 cells.

usage: speed.py FOLDER    a folder with maps and their .scen files
"""

from __future__ import annotations

import math
import pathlib
import sys
import time
from collections.abc import Callable, Iterable
from typing import Any

import networkx
import numpy as np
from pathfinding.core.diagonal_movement import DiagonalMovement
from pathfinding.core.grid import Grid
from pathfinding.finder.a_star import AStarFinder
from skimage.graph import route_through_array

import wend

MAPS = ["arena2", "den520d", "64room_000", "maze512-4-0"]
QUERIES = 20  # of each map
Cell = tuple[int, int]
Search = Callable[[Cell, Cell], Any]


def with_wend(map: wend.Map, planner: str) -> Search:
    space = map.free_space()

    def search(start: Cell, goal: Cell) -> Any:
        return space.plan((start[0] + 0.5, start[1] + 0.5), (goal[0] + 0.5, goal[1] + 0.5), planner).path

    return search


def with_skimage(map: wend.Map) -> Search:
    costs = np.where(map.array == 0, 1.0, -1.0)
    return lambda start, goal: route_through_array(costs, start[::-1], goal[::-1], geometric=True)


def with_pathfinding(map: wend.Map) -> Search:
    grid = Grid(matrix=(map.array == 0).astype(int).tolist())
    finder = AStarFinder(diagonal_movement=DiagonalMovement.only_when_no_obstacle)

    def search(start: Cell, goal: Cell) -> Any:
        grid.cleanup()
        return finder.find_path(grid.node(*start), grid.node(*goal), grid)

    return search


def with_networkx(map: wend.Map) -> Search:
    free = map.array == 0
    graph = networkx.Graph()
    for y, x in np.argwhere(free).tolist():
        for dx, dy in ((1, 0), (0, 1), (1, 1), (-1, 1)):
            block = [(x + dx, y + dy), (x + dx, y), (x, y + dy)]
            if all(0 <= a < map.width and 0 <= b < map.height and free[b, a] for a, b in block):
                graph.add_edge((x, y), block[0], weight=math.hypot(dx, dy))

    def octile(a: Cell, b: Cell) -> float:
        dx, dy = abs(a[0] - b[0]), abs(a[1] - b[1])
        return max(dx, dy) + (math.sqrt(2) - 1) * min(dx, dy)

    return lambda start, goal: networkx.astar_path(graph, start, goal, octile)


def queries_of(scenario: pathlib.Path, count: int) -> list[tuple[Cell, Cell]]:
    """The given number of queries of a .scen file, evenly spread over it."""
    rows = [line.split() for line in scenario.read_text().splitlines()[1:] if line.strip()]
    chosen = [rows[i * len(rows) // count] for i in range(count)]
    return [((int(row[4]), int(row[5])), (int(row[6]), int(row[7]))) for row in chosen]


def microseconds(search: Search, queries: Iterable[tuple[Cell, Cell]]) -> float:
    """The mean, from the first query on: nothing is warm. Making free spaces, graphs and grids is not counted."""
    begin = time.perf_counter()
    count = 0
    for start, goal in queries:
        search(start, goal)
        count += 1
    return (time.perf_counter() - begin) / count * 1e6


PEERS: dict[str, Callable[[wend.Map], Search]] = {
    "wend, jps": lambda map: with_wend(map, "jps"),
    "wend, astar": lambda map: with_wend(map, "astar"),
    "scikit-image, route_through_array": with_skimage,
    "networkx, astar_path": with_networkx,
    "python-pathfinding, A*": with_pathfinding,
}


def on_maps(folder: pathlib.Path) -> None:
    print("| microseconds a query | " + " | ".join(MAPS) + " | times the time of jps |")
    print("|---" * (len(MAPS) + 2) + "|")
    of_jps: list[float] = []
    for name, make in PEERS.items():
        times = []
        for map_name in MAPS:
            search = make(wend.Map.load(folder / f"{map_name}.map"))
            times.append(microseconds(search, queries_of(folder / f"{map_name}.map.scen", QUERIES)))
        of_jps = of_jps or times
        ratio = math.exp(sum(math.log(a / b) for a, b in zip(times, of_jps)) / len(MAPS))
        print(f"| {name} | " + " | ".join(f"{value:,.0f}" for value in times) + f" | {ratio:,.1f} |", flush=True)


def on_a_small_world() -> None:
    """One call each, from a list of lists, with everything that it needs."""
    numbers = np.random.default_rng(3)
    world = (numbers.random((20, 20)) < 0.2).astype(int).tolist()
    world[0][0] = world[19][19] = 0
    query = [((0, 0), (19, 19))]
    print("\n| microseconds a call, 20 x 20 cells | |\n|---|---|")
    peers: dict[str, Search] = {"wend.search": lambda start, goal: wend.search(world, start, goal, connectivity=8)}
    for name, make in PEERS.items():
        peers[name] = lambda start, goal, make=make: make(wend.Map(world))(start, goal)
    for name, search in peers.items():
        print(f"| {name} | {min(microseconds(search, query * 20) for _ in range(10)):,.1f} |", flush=True)


if __name__ == "__main__":
    on_maps(pathlib.Path(sys.argv[1]))
    on_a_small_world()
