"""check_planner(): tests a planner of your own on random small worlds.

Paths are compared with a breadth-first search that is written here, in Python, and shares no code with wend.
"""

from __future__ import annotations

import random
from collections import deque
from typing import NamedTuple

from ._search import PlannerBase

__all__ = ["PlannerFault", "check_planner"]

World = list[list[int]]
Cell = tuple[int, int]


class PlannerFault(AssertionError):
    """A planner did not keep what it promises. The message shows the smallest world on which it did not."""

    world: World
    robot_pose: Cell
    goal_pose: Cell

    def __init__(self, message: str, world: World, robot_pose: Cell, goal_pose: Cell) -> None:
        super().__init__(message, world, robot_pose, goal_pose)
        self.world = world
        self.robot_pose = robot_pose
        self.goal_pose = goal_pose

    def __str__(self) -> str:
        return str(self.args[0])


class _Case(NamedTuple):
    world: World
    robot: Cell
    goal: Cell


def check_planner(
    planner: type[PlannerBase] | PlannerBase,
    *,
    worlds: int = 300,
    seed: int = 1,
    complete: bool = True,
    shortest: bool = False,
) -> None:
    """Asks the planner on random worlds of up to 8 x 8 cells, and checks every answer: the path starts at the robot,
    ends at the goal, steps from neighbour to neighbour and enters no obstacle; the world is not changed.

    :param planner: a class without arguments, or an object.
    :param complete: it must also return a path wherever there is one. (A random walk need not.)
    :param shortest: no path may have more steps than needed.
    :raises PlannerFault: with the smallest world on which it fails.

    >>> import wend, wend.testing
    >>> class Lazy(wend.PlannerBase):
    ...     def search(self, world_state, robot_pose, goal_pose):
    ...         return [robot_pose, goal_pose]
    >>> wend.testing.check_planner(Lazy)
    Traceback (most recent call last):
    ...
    wend.testing.PlannerFault: Lazy: (0, 0) to (0, 0) is not an orthogonal step: [(0, 0), (0, 0)]
    R
    robot_pose (0, 0), goal_pose (0, 0)
    """
    made = planner() if isinstance(planner, type) else planner
    numbers = random.Random(seed)
    for i in range(worlds):
        case = _random_case(numbers, largest=2 + 6 * i // worlds)
        fault = _fault_of(made, case, complete, shortest)
        if fault is not None:
            case, fault = _smallest(made, case, fault, complete, shortest)
            name = type(made).__name__
            raise PlannerFault(f"{name}: {fault}\n{_picture(case)}", case.world, case.robot, case.goal)


def _random_case(numbers: random.Random, largest: int) -> _Case:
    width = numbers.randint(1, largest)
    height = numbers.randint(1, largest)
    density = numbers.choice((0.0, 0.2, 0.35, 0.5))
    world = [[int(numbers.random() < density) for _ in range(width)] for _ in range(height)]
    ends = [(numbers.randrange(width), numbers.randrange(height)) for _ in range(2)]
    for x, y in ends:
        if numbers.random() < 0.9:
            world[y][x] = 0
    return _Case(world, ends[0], ends[1])


def _fewest_steps(case: _Case) -> int | None:
    """By breadth-first search; None without a path."""
    world, robot, goal = case
    if world[robot[1]][robot[0]] or world[goal[1]][goal[0]]:
        return None
    steps = {robot: 0}
    frontier = deque([robot])
    while frontier:
        x, y = here = frontier.popleft()
        if here == goal:
            return steps[here]
        for there in ((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)):
            if there not in steps and _is_free(world, there):
                steps[there] = steps[here] + 1
                frontier.append(there)
    return None


def _is_free(world: World, cell: Cell) -> bool:
    x, y = cell
    return 0 <= y < len(world) and 0 <= x < len(world[0]) and world[y][x] == 0


def _fault_of(planner: PlannerBase, case: _Case, complete: bool, shortest: bool) -> str | None:
    given = [list(row) for row in case.world]
    try:
        answer = planner.search(given, case.robot, case.goal)
    except Exception as error:
        return f"it raised {type(error).__name__}: {error}"
    if given != case.world:
        return "it changed world_state"
    fewest = _fewest_steps(case)
    if answer is None:
        return "there is a path, and it returned None" if complete and fewest is not None else None
    try:
        path = [(int(x), int(y)) for x, y in answer]
    except (TypeError, ValueError):
        return f"it must return a list of (x, y) or None, not {answer!r}"
    if fewest is None:
        return f"there is no path, and it returned one: {path}"
    return _fault_of_path(path, case, fewest if shortest else None)


def _fault_of_path(path: list[Cell], case: _Case, fewest: int | None) -> str | None:
    if not path or path[0] != case.robot:
        return f"the path does not start at the robot: {path}"
    if path[-1] != case.goal:
        return f"the path does not end at the goal: {path}"
    for cell in path:
        if not _is_free(case.world, cell):
            return f"{cell} is an obstacle or outside of the world: {path}"
    for (x, y), (next_x, next_y) in zip(path, path[1:]):
        if abs(next_x - x) + abs(next_y - y) != 1:
            return f"{(x, y)} to {(next_x, next_y)} is not an orthogonal step: {path}"
    if fewest is not None and len(path) - 1 != fewest:
        return f"the path has {len(path) - 1} steps, {fewest} are enough: {path}"
    return None


def _smaller(case: _Case) -> list[_Case]:
    """The world without one of its rows or columns (an end there moves to the next), or one of its obstacles."""
    world, robot, goal = case
    cases = []
    for row in range(len(world)):
        if len(world) > 1:
            shift = [(x, min(y - (y > row), len(world) - 2)) for x, y in (robot, goal)]
            cases.append(_Case(world[:row] + world[row + 1 :], shift[0], shift[1]))
    for column in range(len(world[0])):
        if len(world[0]) > 1:
            shift = [(min(x - (x > column), len(world[0]) - 2), y) for x, y in (robot, goal)]
            cases.append(_Case([row[:column] + row[column + 1 :] for row in world], shift[0], shift[1]))
    for y, states in enumerate(world):
        for x, state in enumerate(states):
            if state:
                fewer = [list(other) for other in world]
                fewer[y][x] = 0
                cases.append(_Case(fewer, robot, goal))
    return cases


def _smallest(planner: PlannerBase, case: _Case, fault: str, complete: bool, shortest: bool) -> tuple[_Case, str]:
    """Makes the world smaller as long as the planner fails on it."""
    while True:
        for smaller in _smaller(case):
            its_fault = _fault_of(planner, smaller, complete, shortest)
            if its_fault is not None:
                case, fault = smaller, its_fault
                break
        else:
            return case, fault


def _picture(case: _Case) -> str:
    world, robot, goal = case
    rows = [["#" if state else "." for state in row] for row in world]
    for mark, (x, y) in (("G", goal), ("R", robot)):
        if rows[y][x] != "#":
            rows[y][x] = mark
    lines = ["".join(row) for row in rows]
    return "\n".join([*lines, f"robot_pose {robot}, goal_pose {goal}"])
