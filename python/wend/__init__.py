"""wend plans paths for robots on maps, smooths them, and drives robots along them.

The common interface: ``wend.search(world_state, robot_pose, goal_pose, planner)``. The full one: ``wend.Map``, its
``free_space()`` and the ``plan()`` of that. Arrays are array[y, x], points are (x, y), and row 0 is y = 0.

>>> import wend
>>> space = wend.Map([[0, 0, 0], [0, 1, 0], [0, 0, 0]], resolution=1.0).free_space(footprint=0.3)
>>> space.plan((0.5, 0.5), (2.5, 2.5)).length
4.0
"""

from ._animation import Animation
from ._core import version as __version__
from ._errors import Error, InvalidArgument, Metrics, NoPath
from ._explore import Exploration, explore
from ._footprint import rectangle
from ._index import Index
from ._map import Map
from ._plan import Drive, LeadOut, Plan, Quality, Trajectory, follow
from ._registry import ControllerInfo, OptionInfo, PlannerInfo, SmootherInfo, controllers, planners, smoothers
from ._search import Comparison, PlannerBase, compare, search
from ._space import DriveExplanation, Explanation, FreeSpace, Way
from ._trace import Event, Trace

__all__ = [
    "Animation",
    "Comparison",
    "ControllerInfo",
    "Drive",
    "Error",
    "Event",
    "DriveExplanation",
    "Explanation",
    "Exploration",
    "FreeSpace",
    "Index",
    "InvalidArgument",
    "LeadOut",
    "Map",
    "Metrics",
    "NoPath",
    "OptionInfo",
    "Plan",
    "PlannerBase",
    "PlannerInfo",
    "Quality",
    "SmootherInfo",
    "Trace",
    "Trajectory",
    "Way",
    "__version__",
    "compare",
    "controllers",
    "explore",
    "follow",
    "planners",
    "rectangle",
    "search",
    "smoothers",
]

for _error in (Error, InvalidArgument, NoPath):
    _error.__module__ = "wend"  # as messages name them
