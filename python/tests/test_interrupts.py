"""Ctrl-C, threads and references."""

from __future__ import annotations

import contextlib
import gc
import pathlib
import resource
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from types import FrameType

import numpy as np
import pytest
import wend


STATM = pathlib.Path("/proc/self/statm")


def resident_bytes() -> int:
    return int(STATM.read_text().split()[1]) * resource.getpagesize()


class Alarm(Exception):
    """What the handler of the signal raises, as that of Ctrl-C raises KeyboardInterrupt."""


@contextlib.contextmanager
def alarm() -> Iterator[None]:
    """A signal arrives soon."""

    def ring(number: int, frame: FrameType | None) -> None:
        raise Alarm

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, 0.05)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


# A walk through the one door takes seconds.
WALLED = np.zeros((1500, 1500), dtype=np.int8)
WALLED[:-1, 1400] = 1
START, GOAL = (0.5, 0.5), (1450.5, 0.5)
STEPS = 100_000_000


def check_usable(space: wend.FreeSpace) -> None:
    assert space.plan(START, (10.5, 0.5)).cost == 10


def test_a_signal_stops_plan() -> None:
    space = wend.Map(WALLED).free_space()
    with pytest.raises(Alarm), alarm():
        space.plan(START, GOAL, "random_walk", max_steps=STEPS)
    check_usable(space)


def test_a_signal_stops_plan_many() -> None:
    space = wend.Map(WALLED).free_space()
    with pytest.raises(Alarm), alarm():
        space.plan_many([START] * 8, [GOAL] * 8, "random_walk", max_steps=STEPS, threads=2)
    check_usable(space)


def test_a_signal_stops_explanations() -> None:
    cells = WALLED.copy()
    cells[:, 1400] = 1
    space = wend.Map(cells).free_space(0.4)
    with pytest.raises(Alarm), alarm():
        space.explain(START, GOAL)
    with pytest.raises(wend.NoPath) as caught:
        space.plan(START, GOAL)
    with pytest.raises(Alarm), alarm():
        _ = caught.value.reason
    check_usable(space)
    assert "connected component" in caught.value.reason


def test_a_time_limit_is_one_of_the_whole_call() -> None:
    cells = (np.random.default_rng(1).random((1500, 1500)) < 0.2).astype(np.int8)
    cells[0] = 0
    space = wend.Map(cells).free_space()
    assert space.plan(START, GOAL).cost == 1450
    for planner in ("alt", "hub_labels", "euclidean_labels"):
        begun = time.process_time()
        with pytest.raises(wend.Error) as caught:
            space.plan(START, GOAL, planner, time_limit=0.01)
        assert caught.value.status == "time_limit"
        assert time.process_time() - begun < 1  # making them takes more


def test_a_signal_stops_search() -> None:
    with pytest.raises(Alarm), alarm():
        wend.search(WALLED, (0, 0), (1450, 0), "random", max_steps=STEPS)


def test_a_signal_stops_a_search_of_explore() -> None:
    space = wend.Map(WALLED).free_space()
    with pytest.raises(Alarm), alarm():
        wend.explore(space, START, GOAL, "random_walk", known=space.map, max_steps=STEPS)
    check_usable(space)


@pytest.mark.parametrize(("planner", "size"), [("hub_labels", 700), ("euclidean_labels", 380)])
def test_a_signal_stops_the_building_of_an_index(planner: str, size: int) -> None:
    cells = np.random.default_rng(1).random((size, size)) < 0.3  # takes seconds
    space = wend.Map(cells.astype(np.int8)).free_space()
    with pytest.raises(Alarm), alarm():
        wend.Index.build(space, planner, threads=2)
    assert wend.Index.build(wend.Map(np.zeros((9, 9))).free_space(), planner).size > 0


# A slow signal would come too late: the map is made before the alarm, what follows takes seconds.
OPEN = np.zeros((4000, 4000), dtype=np.int8)
OPEN[::40, ::40] = 1


def test_a_signal_stops_the_making_of_a_free_space() -> None:
    world = wend.Map(OPEN)
    with pytest.raises(Alarm), alarm():
        for clearance in range(1, 30):
            world.free_space(2.0, clearance_distance=float(clearance))
    assert wend.Map(np.zeros((9, 9))).free_space(0.4).plan(START, (3.5, 0.5)).cost == 3


def test_a_signal_stops_planners_that_prepare() -> None:
    space = wend.Map(WALLED).free_space()
    with pytest.raises(Alarm), alarm():
        for landmarks in range(1, 9):
            space.plan(START, GOAL, "alt", landmarks=landmarks)
    check_usable(space)


def test_a_signal_stops_smoothing_and_timing() -> None:
    plan = wend.Map(WALLED).free_space().plan(START, GOAL)
    with pytest.raises(Alarm), alarm():
        while True:
            plan.smooth(simplify="sight", spacing=0.01)
    with pytest.raises(Alarm), alarm():
        while True:
            plan.trajectory()
    assert plan.smooth().trajectory().duration > 0


def test_a_signal_stops_an_edit_which_then_changes_nothing() -> None:
    # The first is made anew because its robot needs all distances, the second because it changes many cells.
    for clearance, size in ((100.0, 1), (2.0, 3999)):
        space = wend.Map(OPEN).free_space(clearance_distance=clearance)
        box = np.ones((size, size), dtype=np.int8)
        with pytest.raises(Alarm), alarm():
            space.edit((1, 1), box)
        assert space.fits((1.5, 1.5))
        space.edit((1, 1), [[1]])
        assert not space.fits((1.5, 1.5))


def test_a_signal_stops_follow() -> None:
    plan = wend.Map(WALLED).free_space().plan(START, (1390.5, 1490.5))
    begun = time.process_time()
    wend.follow(plan, simulation={"rate": 1000.0})
    takes = time.process_time() - begun
    begun = time.process_time()
    with pytest.raises(Alarm), alarm():
        wend.follow(plan, simulation={"rate": 1000.0})
    assert time.process_time() - begun < takes / 2


def test_a_signal_stops_the_explanation_of_a_drive() -> None:
    space = wend.Map(WALLED[:400, 1200:]).free_space("rect:3x2")
    with pytest.raises(Alarm), alarm():
        while True:
            space.explain_drive((5.5, 5.5, 0.0), (250.5, 5.5, 0.0), turning_radius=100.0)


def lets_others_run(call: Callable[[], object]) -> bool:
    """Does another thread get the interpreter lock during a call? None takes it from a thread that does not give it
    away: the interval of switches is longer than all calls."""
    count = 0
    running = threading.Event()
    ended = threading.Event()

    def counting() -> None:
        nonlocal count
        running.set()
        while not ended.is_set():
            count += 1
            time.sleep(0)  # gives the lock away

    before = sys.getswitchinterval()
    sys.setswitchinterval(3600)
    thread = threading.Thread(target=counting)
    try:
        thread.start()
        running.wait()
        # On a machine with other work, a call may be over before the other thread has a processor.
        for _ in range(300):
            begun = count
            call()
            if count > begun:
                return True
        return False
    finally:
        ended.set()
        sys.setswitchinterval(before)
        thread.join()


def test_who_keeps_the_interpreter_lock_is_found_out() -> None:
    assert not lets_others_run(lambda: sum(range(100_000)))
    assert lets_others_run(lambda: time.sleep(0.01))


LARGE = np.zeros((1500, 1500), dtype=np.int8)
LARGE[::7, ::5] = 1
EDITED = np.argwhere(LARGE[:200] == 1)[:, ::-1]


def calls_that_take_long() -> dict[str, Callable[[], object]]:
    world = wend.Map(LARGE)
    space = world.free_space()
    plan = space.plan((1.5, 1.5), (1450.5, 1450.5))
    trajectory = plan.trajectory()
    return {
        "Map": lambda: wend.Map(LARGE),
        "Map.array": lambda: world.array,
        "Map.with_costs": lambda: world.with_costs(np.full(LARGE.shape, 2.0)),
        "free_space": lambda: world.free_space(0.4, clearance_distance=3.0),
        "passable": lambda: space.passable,
        "clearance": lambda: space.clearance,
        "costs": lambda: space.costs,
        "plan": lambda: space.plan((1.5, 1.5), (1450.5, 1450.5)),
        "plan_many": lambda: space.plan_many([(1.5, 1.5)], [(1450.5, 1450.5)]),
        "cost_to_go": lambda: space.cost_to_go((1.5, 1.5)),
        "policy": lambda: space.policy((1.5, 1.5)),
        "solutions": lambda: next(iter(space.solutions((1.5, 1.5), (1450.5, 1450.5)))),
        "search": lambda: wend.search(LARGE, (1, 1), (1450, 1450)),
        "smooth": lambda: plan.smooth(simplify="sight"),
        "trajectory": lambda: plan.trajectory(),
        "samples": lambda: trajectory.samples(0.01),
        "quality": lambda: plan.quality(),
        "follow": lambda: wend.follow(plan),
        "edit": lambda: space.edit((0, 0), LARGE),
        "edit_cells": lambda: space.edit_cells(EDITED, 1),
        "explain_drive": lambda: space.explain_drive((1.5, 1.5, 0.0), (2.5, 1.5, 0.0)),
    }


def test_what_takes_long_does_not_hold_the_interpreter_lock() -> None:
    for name, call in calls_that_take_long().items():
        assert lets_others_run(call), name


def test_plan_does_not_hold_the_interpreter_lock() -> None:
    space = wend.Map(WALLED).free_space()
    began = threading.Event()

    def walk() -> None:
        began.set()
        with contextlib.suppress(wend.NoPath):
            space.plan(START, GOAL, "random_walk", max_steps=20_000_000)

    thread = threading.Thread(target=walk)
    thread.start()
    began.wait()
    ran_beside = 0
    while thread.is_alive():
        check_usable(space)
        ran_beside += 1
    assert ran_beside > 1


def test_many_calls_leak_nothing() -> None:
    world = np.zeros((8, 8), dtype=np.int8)
    space = wend.Map(world).free_space()

    def calls() -> None:
        for _ in range(200):
            wend.search(world, (0, 0), (7, 7))
            path = space.plan((0.5, 0.5), (7.5, 7.5)).path
            assert len(path) == 8
            with pytest.raises(wend.InvalidArgument):
                space.plan((0.5, 0.5), (7.5, 7.5), weight="x")
            with pytest.raises(wend.NoPath):
                space.plan((0.5, 0.5), (99, 7.5))
            space.trace((0.5, 0.5), (7.5, 7.5)).expansion.sum()
            space.plan_many([(0, 0)], [(1, 1)], threads=1)

    calls()
    gc.collect()
    references = sys.getrefcount(world), sys.getrefcount(None)
    blocks = sys.getallocatedblocks()
    calls()
    gc.collect()
    assert sys.getrefcount(world) == references[0]
    assert abs(sys.getrefcount(None) - references[1]) < 100
    assert sys.getallocatedblocks() - blocks < 200


@pytest.mark.skipif(not STATM.exists(), reason="the size of the process is not in /proc")
def test_memory_does_not_grow_over_100_000_calls() -> None:
    world = [[0] * 20 for _ in range(20)]
    space = wend.Map(world).free_space()

    def calls(count: int) -> None:
        for _ in range(count):
            wend.search(world, (0, 0), (19, 19))
            assert space.plan((0.5, 0.5), (19.5, 19.5)).path.shape == (20, 2)
            with contextlib.suppress(wend.NoPath):
                space.plan((0.5, 0.5), (99, 1))

    calls(2_000)
    gc.collect()
    before = resident_bytes()
    calls(100_000)
    gc.collect()
    assert resident_bytes() - before < 2**20


def test_arrays_outlive_what_made_them() -> None:
    path = wend.Map(np.zeros((5, 5))).free_space().plan((0.5, 0.5), (4.5, 4.5)).path
    gc.collect()
    assert path[-1].tolist() == [4.5, 4.5]
