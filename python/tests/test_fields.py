"""What Python's functions name is what the C++ side lists."""

from __future__ import annotations

import inspect
import math
import pickle
from typing import Any

import numpy as np
import pytest
import wend
from wend import _core

SPACE = wend.Map(np.zeros((9, 9), dtype=np.int8), resolution=0.5).free_space()
FIELDS = {name: field for field in _core.request_fields() for name in (field[0], *field[1])}
NO_FIELDS = {"self", "start", "goal", "starts", "goals", "planner", "options", "threads", "progress"}


def wrong(name: str, value: object) -> dict[str, Any]:
    return {name: value}


@pytest.mark.parametrize("name", ["plan", "replan", "plan_many", "solutions", "trace"])
def test_arguments_are_fields_of_a_request(name: str) -> None:
    for argument in inspect.signature(getattr(wend.FreeSpace, name)).parameters.values():
        if argument.name in NO_FIELDS:
            continue
        default = FIELDS[argument.name][4]
        if argument.default is None:
            assert not math.isfinite(default)
        else:
            assert argument.default == default


def test_arguments_of_free_space_are_the_fields_of_a_robot() -> None:
    # The footprint has the radius: a number, or another shape.
    arguments = inspect.signature(wend.Map.free_space).parameters
    listed = {name: default for name, _, _, _, default, _ in _core.robot_fields() if name != "robot_radius"}
    assert {name: arguments[name].default for name in listed} == listed
    assert set(arguments) - set(listed) == {"self", "footprint", "warm"}
    for name in listed:
        assert f"`{name}`" in str(wend.Map.free_space.__doc__) or f":param {name}:" in str(wend.Map.free_space.__doc__)


@pytest.mark.parametrize("name", ["clearance_distance", "clearance_cost"])
def test_values_of_a_robot_out_of_range_name_the_argument(name: str) -> None:
    with pytest.raises(wend.InvalidArgument, match=f"option '{name}': '-1' is not between 0 and") as caught:
        SPACE.map.free_space(**wrong(name, -1))
    assert caught.value.where == name


def test_trajectories_take_every_listed_limit() -> None:
    plan = SPACE.plan((0.25, 0.25), (3.75, 2.25))
    for limit in _core.trajectory_limits():
        name, default = limit["name"], float(limit["default"])
        assert f"`{name}` (" in str(wend.Plan.trajectory.__doc__)
        assert plan.trajectory(**wrong(name, default)).duration == plan.trajectory().duration
        with pytest.raises(wend.InvalidArgument, match=f"option '{name}': '0' is not between"):
            plan.trajectory(**wrong(name, 0))


def test_docstrings_describe_the_arguments() -> None:
    for argument in set(inspect.signature(wend.FreeSpace.plan).parameters) - {"self", "options"}:
        assert f":param {argument}:" in str(wend.FreeSpace.plan.__doc__), argument


def test_fields_that_no_function_names_come_among_the_options() -> None:
    start, goal = (0.25, 0.25), (3.75, 2.25)
    assert len(SPACE.plan(start, goal, straighten=True)) == 2
    assert len(SPACE.plan(start, goal, spacing=0.1)) > len(SPACE.plan(start, goal))
    assert SPACE.plan(start, goal, from_field=True).cost == SPACE.plan(start, goal).cost
    with pytest.raises(wend.InvalidArgument, match="option 'spacing': '-1' is not between 0 and"):
        SPACE.plan(start, goal, spacing=-1)


@pytest.mark.parametrize("name", ["time_limit", "nearest_limit", "escape", "tolerance", "heading_tolerance", "expansions"])
def test_values_out_of_range_name_the_argument(name: str) -> None:
    with pytest.raises(wend.InvalidArgument, match=f"option '{name}': '-1' is ") as caught:
        SPACE.plan((0, 0), (1, 1), **wrong(name, -1))
    assert caught.value.where == name


def test_wrong_types_name_the_argument() -> None:
    for name, value in [("nearest", 1.5), ("escape", "far"), ("expansions", 1.5), ("time_limit", "long")]:
        with pytest.raises(wend.InvalidArgument, match=f"{name} must be"):
            SPACE.plan((0, 0), (1, 1), **wrong(name, value))


def test_quality_has_every_listed_metric() -> None:
    quality = SPACE.plan((0.25, 0.25), (3.75, 2.25)).quality()
    listed = _core.path_metrics()
    assert quality._fields == tuple(name for name, _, _ in listed) and len(quality) == len(listed)
    for (name, unit, _), value in zip(listed, quality, strict=True):
        assert getattr(quality, name) == value == quality._asdict()[name]
        assert isinstance(value, float if unit else int)
        assert getattr(wend.Quality, name).__doc__
    assert pickle.loads(pickle.dumps(quality)) == quality
    assert repr(quality).startswith("Quality(length=")


def test_metrics_have_every_listed_metric() -> None:
    metrics = SPACE.plan((0.25, 0.25), (3.75, 2.25)).metrics
    assert metrics._fields == tuple(name for name, _, _ in _core.search_metrics())
    assert metrics == wend.Metrics(*metrics) and isinstance(metrics.expanded, int)
