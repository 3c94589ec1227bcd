"""The trials of the C++ conformance suite: every planner gives the same answers through Python, to the last digit.

`./run python-test` builds wend-trials, which draws maps, robots, options and queries as the suite does, and writes
what the planners answer in C++.
"""

from __future__ import annotations

import collections
import json
import math
import os
import subprocess
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import wend

PROGRAM = os.environ.get("WEND_TRIALS")
SEEDS = 200
INDEXED = {planner.name: planner.needs_index for planner in wend.planners()}

pytestmark = pytest.mark.skipif(PROGRAM is None, reason="WEND_TRIALS does not name wend-trials: see ./run python-test")


@pytest.fixture(scope="module")
def trials() -> dict[str, list[Any]]:
    """By the names of planners."""
    lines = subprocess.run([str(PROGRAM), str(SEEDS)], check=True, capture_output=True, text=True).stdout
    by_planner = collections.defaultdict(list)
    for trial in map(json.loads, lines.splitlines()):
        by_planner[trial["planner"]].append(trial)
    return by_planner


def space_of(trial: Any) -> wend.FreeSpace:
    space = wend.Map(**trial["map"]).free_space(**trial["robot"])
    # Every other time: without an index, these planners make their own.
    if INDEXED[trial["planner"]] and trial["seed"] % 2 == 0 and not trial["refused"]:
        space.use_index(wend.Index.build(space, trial["planner"], threads=1))
    return space


def answer_of(space: wend.FreeSpace, trial: Any, query: Any) -> Any:
    """In the words of wend-trials."""
    tolerances = {name: query[name] for name in ("tolerance", "heading_tolerance")}
    try:
        plan = space.plan(query["start"], query["goal"], trial["planner"], **tolerances, **trial["options"])
    except wend.NoPath as no_path:
        return {"status": no_path.status, "path": [], "metrics": list(no_path.metrics)}
    return {
        "status": "found",
        "cost": plan.cost,
        "bound": plan.bound if math.isfinite(plan.bound) else None,
        "path": plan.path.tolist(),
        "metrics": list(plan.metrics),
    }


def queries_of(trials: list[Any]) -> Iterator[tuple[Any, Any]]:
    for trial in trials:
        for query in trial["queries"]:
            yield trial, query


@pytest.mark.parametrize("name", INDEXED)
def test_a_planner_answers_as_in_cpp(name: str, trials: dict[str, list[Any]]) -> None:
    assert len(trials[name]) == SEEDS
    found = 0
    for trial in trials[name]:
        space = space_of(trial)
        for query in trial["queries"]:
            expected = query["answer"]
            if expected["status"] == "found":
                found += 1
            else:
                del expected["cost"], expected["bound"]
            assert answer_of(space, trial, query) == expected, f"{name}, seed {trial['seed']}"
    assert found > SEEDS / 4


def test_planners_refuse_as_in_cpp(trials: dict[str, list[Any]]) -> None:
    refused = [trial for some in trials.values() for trial in some if trial["refused"]]
    assert {"jps", "hub_labels"} <= {trial["planner"] for trial in refused}
    for trial in refused:
        space = space_of(trial)
        with pytest.raises(wend.InvalidArgument) as caught:
            space.plan((0, 0), (0, 0), trial["planner"], **trial["options"])
        assert caught.value.status == trial["refused"] == "unsupported_map"


def test_the_trials_are_of_every_kind(trials: dict[str, list[Any]]) -> None:
    assert set(trials) == set(INDEXED)
    everything = [trial for some in trials.values() for trial in some]
    maps = [trial["map"] for trial in everything]
    assert any(map["costs"] for map in maps) and any(map["costs"] is None for map in maps)
    assert any((np.array(map["array"]) < 0).any() for map in maps)
    statuses = {query["answer"]["status"] for _, query in queries_of(everything)}
    blocked = {"start_blocked", "goal_blocked", "start_outside", "goal_outside", "unreachable", "step_limit"}
    assert statuses == {"found", *blocked}
    assert any(len(query["goal"]) > 1 for _, query in queries_of(everything))
    assert any(query["tolerance"] > 0 for _, query in queries_of(everything))
