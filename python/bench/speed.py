"""Times wend beside other Python packages on MovingAI maps and on a world of 20 x 20 cells.

usage: speed.py FOLDER [PAGE]

FOLDER has maps and their .scen files. The result is Markdown; with PAGE, docs/python.md, it also replaces the section
"How fast" there. The exit code is 1 if a target is missed.
"""

from __future__ import annotations

import datetime
import math
import os
import pathlib
import platform
import re
import sys
import time
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import networkx
import numpy as np
import pyastar2d
from pathfinding.core.diagonal_movement import DiagonalMovement
from pathfinding.core.grid import Grid
from pathfinding.finder.a_star import AStarFinder
from skimage.graph import route_through_array

import wend

MAPS = ["arena2", "den520d", "64room_000", "maze512-4-0"]
QUERIES = 20  # of each map
MANY = {"jps": 1000, "astar": 100}  # queries of each map for plan_many()
Cell = tuple[int, int]
Query = tuple[Cell, Cell]
Search = Callable[[Cell, Cell], Any]


def centre(cell: Cell) -> tuple[float, float]:
    return cell[0] + 0.5, cell[1] + 0.5


def with_wend(map: wend.Map, planner: str) -> Search:
    space = map.free_space()
    return lambda start, goal: space.plan(centre(start), centre(goal), planner).path


def with_skimage(map: wend.Map) -> Search:
    costs = np.where(map.array == 0, 1.0, -1.0)
    return lambda start, goal: route_through_array(costs, start[::-1], goal[::-1], geometric=True)


def with_pyastar2d(map: wend.Map) -> Search:
    costs = np.where(map.array == 0, 1, np.inf).astype(np.float32)
    return lambda start, goal: pyastar2d.astar_path(costs, start[::-1], goal[::-1], allow_diagonal=True)


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


PEERS: dict[str, Callable[[wend.Map], Search]] = {
    "wend, jps": lambda map: with_wend(map, "jps"),
    "wend, astar": lambda map: with_wend(map, "astar"),
    "pyastar2d, astar_path": with_pyastar2d,
    "scikit-image, route_through_array": with_skimage,
    "networkx, astar_path": with_networkx,
    "python-pathfinding, A*": with_pathfinding,
}
SKIMAGE = "scikit-image, route_through_array"


def queries_of(scenario: pathlib.Path, count: int) -> list[Query]:
    """The given number of queries of a .scen file, evenly spread over it."""
    rows = [line.split() for line in scenario.read_text().splitlines()[1:] if line.strip()]
    chosen = [rows[i * len(rows) // count] for i in range(count)]
    return [((int(row[4]), int(row[5])), (int(row[6]), int(row[7]))) for row in chosen]


class Scenario(NamedTuple):
    map: wend.Map
    queries: list[Query]


def scenarios_in(folder: pathlib.Path) -> list[Scenario]:
    return [
        Scenario(wend.Map.load(folder / f"{name}.map"), queries_of(folder / f"{name}.map.scen", QUERIES))
        for name in MAPS
    ]


def mean(numbers: Iterable[float]) -> float:
    given = list(numbers)
    return sum(given) / len(given)


def geometric_mean(numbers: Iterable[float]) -> float:
    return math.exp(mean(map(math.log, numbers)))


def microseconds(search: Search, queries: list[Query]) -> float:
    """The mean, from the first query on: nothing is warm. Making free spaces, graphs and grids is not counted.

    CPU time of this thread: all of these packages search on the thread that asks.
    """
    begin = time.thread_time()
    for start, goal in queries:
        search(start, goal)
    return (time.thread_time() - begin) / len(queries) * 1e6


def on_maps(scenarios: list[Scenario]) -> dict[str, list[float]]:
    """Microseconds a query, for each package and map."""
    return {name: [microseconds(make(map), queries) for map, queries in scenarios] for name, make in PEERS.items()}


def on_a_small_world() -> dict[str, float]:
    """Microseconds of one call each, from a list of lists, with everything that it needs."""
    numbers = np.random.default_rng(3)
    world = (numbers.random((20, 20)) < 0.2).astype(int).tolist()
    world[0][0] = world[19][19] = 0
    queries = [((0, 0), (19, 19))] * 20
    peers: dict[str, Search] = {
        "wend.search": lambda start, goal: wend.search(world, start, goal),
        "wend.search, 8 neighbours": lambda start, goal: wend.search(world, start, goal, connectivity=8),
    }
    for name, make in PEERS.items():
        peers[name] = lambda start, goal, make=make: make(wend.Map(world))(start, goal)
    return {name: min(microseconds(search, queries) for _ in range(10)) for name, search in peers.items()}


class AboveCpp(NamedTuple):
    """Microseconds a warm query of jps, means over all queries of all maps."""

    cpp: float
    """The search alone, as C++ measures it within these calls."""
    plan: float
    """``space.plan()``."""
    path: float
    """``plan.path``, the array."""


def above_cpp(scenarios: list[Scenario], repetitions: int = 300) -> AboveCpp:
    least = []
    for map, queries in scenarios:
        space = map.free_space()
        for start, goal in queries:
            from_, to = centre(start), centre(goal)
            seconds = []
            for _ in range(repetitions):
                begin = time.perf_counter()
                plan = space.plan(from_, to, "jps")
                planned = time.perf_counter()
                plan.path
                seconds.append((plan.seconds, planned - begin, time.perf_counter() - planned))
            least.append([min(column) for column in zip(*seconds)])
    return AboveCpp(*(1e6 * mean(column) for column in zip(*least)))


def speedup_of_threads(folder: pathlib.Path, planner: str, count: int, repetitions: int = 12) -> float:
    """How many times as fast plan_many() is on two threads as on one: different queries, nothing is warm."""
    ratios = []
    for name in MAPS:
        map = wend.Map.load(folder / f"{name}.map")
        queries = queries_of(folder / f"{name}.map.scen", count)
        starts, goals = ([centre(query[end]) for query in queries] for end in (0, 1))
        least = {1: math.inf, 2: math.inf}
        for _ in range(repetitions):
            for threads in least:
                space = map.free_space()
                begin = time.perf_counter()
                space.plan_many(starts, goals, planner, threads=threads)
                least[threads] = min(least[threads], time.perf_counter() - begin)
        ratios.append(least[1] / least[2])
    return geometric_mean(ratios)


class Target(NamedTuple):
    what: str
    wanted: str
    value: float
    met: bool


def table(head: list[str], rows: Iterable[list[str]]) -> str:
    lines = ["| " + " | ".join(line) + " |\n" for line in [head, *rows]]
    return "".join([lines[0], "|---" * len(head) + "|\n", *lines[1:]])


def machine() -> str:
    """In general words."""
    names = re.findall(r"^model name\s*: (\S+ \S+)", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    python = ".".join(platform.python_version_tuple()[:2])
    return f"{names[0] if names else platform.machine()}, {os.cpu_count()} cores; Python {python}"


def report(
    times: dict[str, list[float]],
    small: dict[str, float],
    above: AboveCpp,
    threads: dict[str, float],
    targets: list[Target],
) -> str:
    jps = times["wend, jps"]
    ratios = {name: geometric_mean(a / b for a, b in zip(row, jps)) for name, row in times.items()}
    on_maps = table(
        ["microseconds a query", *MAPS, "times the time of jps"],
        [[name, *(f"{value:,.0f}" for value in row), f"{ratios[name]:,.1f}"] for name, row in times.items()],
    )
    calls = table(["one call, 20 x 20 cells", "microseconds"], [[name, f"{value:,.1f}"] for name, value in small.items()])
    wanted = table(
        ["target", "wanted", "measured"], [[target.what, target.wanted, f"{target.value:,.2f}"] for target in targets]
    )
    return f"""`./run bench python` compares wend with other packages: means of {QUERIES} queries on each of four maps of MovingAI's
benchmarks, from the first query on, path included, in CPU time. Making free spaces, graphs and grids is not counted.
wend, networkx and python-pathfinding find shortest paths that cut no corner; the others cut corners. Measured on
{datetime.date.today()} ({machine()}).

{on_maps}
One call on a list of lists of 20 x 20 cells, with everything that it needs:

{calls}
A warm query of `space.plan()` with jps takes {above.plan:.1f} microseconds in the mean, {above.cpp:.1f} of them in the search, as C++
measures it in the same calls; `plan.path` takes {above.path:.1f} more, once. `plan_many()` on two threads is {threads["astar"]:.2f} times as
fast as on one with astar, and {threads["jps"]:.2f} times with jps.

{wanted}"""


def main(arguments: list[str]) -> int:
    if len(arguments) not in (1, 2):
        print(__doc__, file=sys.stderr)
        return 2
    folder = pathlib.Path(arguments[0])
    scenarios = scenarios_in(folder)
    times = on_maps(scenarios)
    small = on_a_small_world()
    above = above_cpp(scenarios)
    threads = {planner: speedup_of_threads(folder, planner, count) for planner, count in MANY.items()}
    ahead = geometric_mean(a / b for a, b in zip(times[SKIMAGE], times["wend, jps"]))
    search, overhead = small["wend.search"], above.plan - above.cpp
    targets = [
        Target("a call of `wend.search` on a 20 x 20 list of lists, microseconds", "at most 25", search, search <= 25),
        Target("`space.plan` with jps above C++, microseconds", "at most 4", overhead, overhead <= 4),
        Target("`plan_many` on two threads, times one", "at least 1.8", threads["astar"], threads["astar"] >= 1.8),
        Target("jps, times scikit-image, geometric mean", "at least 100", ahead, ahead >= 100),
    ]
    text = report(times, small, above, threads, targets)
    print(text)
    if len(arguments) == 2:
        page = pathlib.Path(arguments[1])
        head = "## How fast\n\n"
        before, _, after = page.read_text().partition(head)
        _, following, rest = after.partition("\n## ")
        page.write_text(before + head + text + following + rest)
    missed = [target.what for target in targets if not target.met]
    for what in missed:
        print(f"missed: {what}", file=sys.stderr)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
