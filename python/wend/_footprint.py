"""Shapes of robots."""

from __future__ import annotations

__all__ = ["rectangle"]


def rectangle(length: float, width: float, ahead: float = 0) -> list[tuple[float, float]]:
    """The corners of a rectangle, for ``Map.free_space(footprint=...)``.

    :param length: metres, along the robot's heading.
    :param width: metres.
    :param ahead: how far the centre of the rectangle lies ahead of the robot's base point, in metres; negative: behind
        it. Of a car whose base point lies between its rear wheels: half the wheelbase, if it reaches as far beyond the
        front wheels as beyond the rear ones.

    >>> rectangle(4, 2, 1)
    [(3.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (3.0, -1.0)]
    """
    front, rear, side = round(ahead + length / 2, 12), round(ahead - length / 2, 12), width / 2
    return [(front, side), (rear, side), (rear, -side), (front, -side)]
