"""FreeSpace.cover()."""

import math

import numpy as np
import pytest
import wend


def room(height=24, width=36):
    cells = np.zeros((height, width), dtype=np.int8)
    cells[[0, -1], :] = 1
    cells[:, [0, -1]] = 1
    return wend.Map(cells, resolution=0.05)


@pytest.fixture(scope="module")
def space():
    return room().free_space(0.1)


def test_covers_what_its_arrays_say(space):
    coverage = space.cover(tool_width=0.2)
    assert coverage.covered_share >= 0.999
    assert coverage.wanted.shape == coverage.covered.shape == (24, 36)
    assert coverage.wanted.dtype == bool
    assert coverage.missed.sum() == coverage.wanted.sum() - coverage.covered.sum()
    steps = np.diff(coverage.points, axis=0)
    assert math.isclose(np.hypot(*steps.T).sum(), coverage.length, rel_tol=1e-9)
    # An independent raster: the distance of each cell's centre from the path.
    nearest = np.full((24, 36), np.inf)
    y, x = (np.indices((24, 36)) + 0.5) * 0.05
    for (ax, ay), (dx, dy) in zip(coverage.points, steps):
        squared = dx * dx + dy * dy
        along = np.clip(((x - ax) * dx + (y - ay) * dy) / squared, 0, 1) if squared > 0 else 0
        nearest = np.minimum(nearest, np.hypot(x - ax - along * dx, y - ay - along * dy))
    assert (nearest[coverage.covered] <= 0.1 + 1e-6).all()
    assert (nearest[coverage.missed] >= 0.1 - 1e-6).all()


def test_begins_and_ends_where_it_is_told(space):
    coverage = space.cover(0.2, start=(0.2, 0.3), end=(1.5, 0.9))
    assert coverage.points[0].tolist() == pytest.approx([0.2, 0.3])
    assert coverage.points[-1].tolist() == pytest.approx([1.5, 0.9])


def test_goes_on_after_an_interruption(space):
    whole = space.cover(0.2)
    done = whole.covered.copy()
    done[:, 18:] = False
    rest = space.cover(0.2, covered=done)
    assert rest.length < 0.75 * whole.length
    assert len(space.cover(0.2, covered=whole.wanted).points) == 0


def test_covers_only_an_area(space):
    area = np.zeros((24, 36), dtype=bool)
    area[5:10, 5:10] = True
    coverage = space.cover(0.2, area=area)
    assert coverage.wanted.sum() == 25
    assert coverage.length < 2


@pytest.mark.parametrize(
    "arguments",
    [
        {"tool_width": 0},
        {"tool_width": math.nan},
        {"tool_width": 1e9},
        {"overlap": 0.2},
        {"share": 0},
        {"angle": math.inf},
        {"turn_cost": -1},
        {"start": (99, 99)},
        {"area": np.zeros((3, 3))},
    ],
)
def test_refuses(space, arguments):
    with pytest.raises(ValueError):
        space.cover(**{"tool_width": 0.2, **arguments})


def test_says_that_the_start_is_blocked(space):
    with pytest.raises(wend.Error, match="start"):
        space.cover(0.2, start=(0.01, 0.01))
