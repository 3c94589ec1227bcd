"""Plans a path for a round robot, smooths it, and says how long it takes."""

import numpy as np

import wend

room = np.zeros((60, 100), dtype=np.int8)  # array[y, x]: 0 is free, 1 an obstacle
room[:45, 40] = 1
room[15:, 70] = 1

space = wend.Map(room, resolution=0.05).free_space(footprint=0.2)
plan = space.plan((0.5, 0.5), (4.5, 2.5))
smooth = plan.smooth(simplify="sight")
print(f"{len(plan)} points, {plan.length:.2f} m; smoothed {smooth.length:.2f} m")
print(f"{plan.metrics.expanded} cells expanded; {smooth.trajectory(speed=0.5).duration:.1f} s at 0.5 m/s")

try:
    wend.Map(room, resolution=0.05).free_space(footprint=0.8).plan((0.5, 0.5), (4.5, 2.5))
except wend.NoPath as no_path:
    print(f"a larger robot: {no_path.reason}")
