"""NaN, infinity, 1e300, 5e-324: every call raises the documented exception or answers with finite numbers."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import wend

NUMBERS = [math.nan, math.inf, -math.inf, 1e300, -1e300, 1e18, 5e-324]
SPACE = wend.Map(np.zeros((8, 20), dtype=np.int8), resolution=0.1).free_space(0.1)
ENDS = (0.25, 0.25), (1.75, 0.55)
PLAN = SPACE.plan(*ENDS, "theta_star")

CALLS: list[Any] = [
    lambda number: SPACE.plan((number, 0.25), ENDS[1]).path,
    lambda number: SPACE.plan(ENDS[0], (0.25, number), "hybrid_astar").path,
    lambda number: SPACE.plan((*ENDS[0], number), (*ENDS[1], 0.0), "hybrid_astar").path,
    lambda number: SPACE.plan(*ENDS, tolerance=number).path,
    lambda number: SPACE.plan(*ENDS, "hybrid_astar", turning_radius=number, expansions=500).path,
    lambda number: SPACE.nearest((number, 0.25, 0.0)),
    lambda number: SPACE.fits((0.25, number)),
    lambda number: SPACE.cost_to_go((number, 0.25)),
    lambda number: SPACE.explain((0.25, number), ENDS[1]).text,
    lambda number: PLAN.smooth(spacing=number).path,
    lambda number: PLAN.smooth("curvature", radius=number).path,
    lambda number: PLAN.trajectory(corner_rounding=number).duration,
    lambda number: PLAN.trajectory(speed=number).duration,
    lambda number: PLAN.trajectory().samples(number),
    lambda number: PLAN.trajectory().at(number),
    lambda number: SPACE.map.free_space(number).clearance,
    lambda number: wend.Map(np.zeros((2, 2)), resolution=number).resolution,
    lambda number: wend.Map(np.zeros((2, 2)), resolution=1, origin=(number, 0, 0)).resolution,
    lambda number: wend.Map(np.zeros((2, 2)), costs=[[1, number], [1, 1]]).costs,
]


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("call", CALLS)
def test_absurd_numbers_are_refused_or_harmless(call: Any, number: float) -> None:
    try:
        answer = call(number)
    except wend.Error as error:  # InvalidArgument or NoPath
        assert str(error)
    else:
        numbers = np.asarray(answer)
        assert numbers.dtype.kind in "US" or not np.isnan(numbers.astype(float)).any()
