"""wend.explore(): drives over maps that the robot does not know."""

from typing import Any

import numpy as np
import pytest

import wend


def random_map(rng: np.random.Generator) -> np.ndarray:
    height, width = rng.integers(4, 30, size=2)
    return (rng.random((height, width)) < 0.3 * rng.random()).astype(np.int8)


def test_arrives_where_a_path_leads() -> None:
    arrived = 0
    for seed in range(60):
        rng = np.random.default_rng(seed)
        array = random_map(rng)
        array[0, 0] = 0
        space = wend.Map(array).free_space()
        goal = (array.shape[1] - 1, array.shape[0] - 1)
        drive = wend.explore(
            space,
            (0, 0),
            goal,
            ["replanner", "d_star_lite", "astar"][seed % 3],
            sensor_range=float(rng.uniform(1, 8)),
            replan="path" if seed % 2 else "discovery",
        )
        reachable = np.isfinite(space.cost_to_go((0, 0))[goal[1], goal[0]])
        assert drive.arrived == reachable, f"seed {seed}: {drive.reason}"
        assert (drive.reason == "") == drive.arrived
        steps = np.abs(np.diff(drive.cells, axis=0)).max(axis=1) if len(drive.cells) > 1 else []
        assert (np.asarray(steps) == 1).all()
        assert (array[drive.cells[:, 1], drive.cells[:, 0]] == 0).all()
        known = np.asarray(drive.known.array)
        assert ((known == -1) | (known == array)).all()
        arrived += drive.arrived
    assert arrived > 20


def test_plans_once_if_it_knows_the_map() -> None:
    array = np.zeros((20, 20), dtype=np.int8)
    array[5:15, 10] = 1
    map = wend.Map(array)
    space = map.free_space()
    drive = wend.explore(space, (2, 10), (17, 10), known=map)
    assert drive.plans == 1
    assert drive.cost == pytest.approx(space.plan((2, 10), (17, 10)).cost)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"goal": (50, 0)}, "the goal is outside the map"),
        ({"start": (1, 0)}, "the start is an obstacle"),
        ({"sensor_range": 0.1}, "at least 1 cell"),
        ({"planner": "theta_star"}, "steps from cell to cell, which theta_star does not"),
        ({"planner": "nothing"}, "nothing"),
        ({"replan": "never"}, "replan"),
        ({"weight": 2}, "weight"),
    ],
)
def test_says_which_argument_is_wrong(arguments: dict[str, Any], message: str) -> None:
    space = wend.Map([[0, 1, 0], [0, 0, 0]]).free_space()
    ends = {"start": (0, 0), "goal": (2, 0)}
    with pytest.raises((ValueError, wend.Error), match=message):
        wend.explore(space, **{**ends, **arguments})


def test_the_known_map_has_the_size_of_the_true_one() -> None:
    space = wend.Map([[0, 0, 0]]).free_space()
    with pytest.raises(ValueError, match="the known map has 1 x 1 cells, the true one 3 x 1"):
        wend.explore(space, (0, 0), (2, 0), known=wend.Map([[0]]))
