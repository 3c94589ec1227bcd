#pragma once

// The outcome of one query, with everything that a report shows. In JSON:
//
//   {"schema": 1, "planner": "astar", "status": "found", "cost": 2.41, "bound": 1,
//    "length_cells": 2.41, "length_m": 0.12, "path": [[1,1],[2,2],[3,2]], "path_m":
//    [[0.07,0.07],...], "robot_radius": 0.2, "footprint": "disc:0.2", "metrics":
//    {"expanded": 3, "generated": 9, "max_frontier": 6},
//    "times": {"load_us": 310.5, "free_space_us": 92.1, "planner_us": 3.6, "index_us": null,
//    "search_us": 4.2}}
//
// `times` are CPU time, see WorkTimes; null for steps that were not needed.
// `path` is a list of cells, `path_m` their centres in the map's frame. `bound` is the guaranteed
// factor between the cost and the cheapest cost, null without a guarantee. `footprint` is the robot's
// shape as text_of() writes it, `robot_radius` the radius of the disc around it, for which planners on
// cells plan: both in metres (in cells on a map without a resolution). On failure `status` is
// the name of the reason and `reason` says it in words; `path` and `path_m` are empty, `cost` and
// the lengths null.
//
// If the path was simplified, smoothed or resampled, "path_smoothed", "path_smoothed_m",
// "smoothing", "path_metrics" and "path_smoothed_metrics" follow: see path_report.hpp. `path` and
// the cost remain those of the plan. `path_smoothed` is a list of waypoints in grid coordinates, in
// which the centre of cell (i,j) is (i+0.5, j+0.5).
//
// The paths of an anytime planner, in order: "solutions": [{"search_us": 8.1, "cost": 3.41, "bound": 1.4,
// "expanded": 9}, ...]. The last one is the answer.
//
// If a trajectory was asked for, "trajectory" follows: see trajectory_report.hpp.
//
// For a car:
//
//   {"schema": 1, "planner": "car", "status": "found", "cost": 2.57, "length_cells": 2.57, "length_m": 0.12,
//    "steps": 2, "path": [[1,0],[2,1],[2,2]], "headings": ["E","S","S"], "moves":
//    ["FWD_RIGHT","FWD"], "path_m": [[0.05,0],...], "yaw": [0,1.57,1.57], "bound": 1,
//    "start_shift": {"cells": 0.5, "m": 0.025, "degrees": 4}, "goal_shift": {...},
//    "poses_m": [[0.05,0,0],...], "gears": [1,1], "steps_in_reverse": 0, "turning_radius_cells": 1, "turning_radius_m": 0.05, "states": 1600,
//    "metrics": {...}, "times": {...}}
//
// `path` is then a list of lattice vertices, and `headings` are N, W, E or S on a page (or, for
// other headings, the angle in radians from +x towards +y of the grid). `moves` are the motion
// primitives between them, one fewer, and `steps` is their number. `path_m` are the same points in
// the map's frame and `yaw` the headings there, radians counter-clockwise from its +x. `poses_m` are
// the poses to drive, x, y and yaw: the same again or, if the path was refined, those of the refined
// path. `gears` has one number for each segment between them: 1 ahead, -1 in reverse, 0 for a turn in
// place. The shifts
// are the snapping errors of start and goal, and `states` is the number of valid states. On failure
// the lists are empty, `steps` and the shifts null.
//
// If the path begins with a way out of what blocks the start: "lead_out": {"length_cells": 2, "length_m": 0.1,
// "points": 2, "reason": "the start ... is blocked: ..."}; `points` of the path come before the first free one, and
// `cost` is that of the path behind it. If --closest was asked for, or goals were moved because no path reaches them:
// "remaining": {"cells": 3, "m": 0.15}, the distance from the path's end to the nearest goal, 0 where it was reached.
//
// Layers, if given, follow as "layers": {"g": [[0,1,...],...]}, a list for every row, row 0 first:
// numbers, or names of directions on a page ("up_left"); null for unset cells.

// As text, a car's plan is a command list: a line for the start, then one for each move with the
// vertex and the heading at its end.
//
//   Start (1,0,E)
//   Go FWD_RIGHT -> (2,1,S)
//   Go FWD -> (2,2,S)

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/analysis/layer.hpp"
#include "wend/base/status.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/place_grid.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/map/place_text.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/report/path_report.hpp"
#include "wend/report/trajectory_report.hpp"
#include "wend/robot/footprint.hpp"

namespace wend {

/// The time of one query, including loading the map: CPU seconds of the thread (thread_time.hpp);
/// for an index, of all threads that built it.
struct WorkTimes {
  double load = 0;                  // reading the map
  double free_space = 0;            // computing the FreeSpace
  std::optional<double> planner{};  // making the planner, including its preprocessing
  std::optional<double> index{};    // building an index, or opening one
  double search = 0;                // one run of the query

  double preparation() const { return load + free_space + planner.value_or(0) + index.value_or(0); }
};

/// A path that an anytime planner told.
struct TimedSolution {
  double seconds = 0;  // CPU time since the search began
  double cost = 0;
  double bound = 0;            // Plan::bound
  std::uint64_t expanded = 0;  // until then
};

struct PlanResult {
  std::string planner;
  Status status = Status::found;
  Plan plan;  // on failure only its metrics
  WorkTimes times{};
  std::string reason;              // of a failure, in words
  Capabilities capabilities{};     // of the planner
  std::string cost_name = "cost";  // PlannerInfo::cost_name
  std::uint64_t states = 0;        // Planner::state_count()
  // The refined path, if it was smoothed or the like.
  std::optional<RefinedPath> refined{};
  // The trajectory along the path, refined or not, if it was asked for.
  std::optional<SampledTrajectory> trajectory{};
  bool anytime = false;                    // Planner::anytime()
  std::vector<TimedSolution> solutions{};  // of an anytime planner, in order
  std::optional<LeadOut>
      lead_out{};  // how the paths begin, if they lead out of what blocks the start
  std::optional<double> remaining{};  // metres to the nearest goal, as in PlanAnswer
  PlaceGrid places = {};              // of the planner; a car turns in their spacing
  Footprint footprint{};
  std::vector<std::string> notes{};  // sentences, as PlanAnswer::notes
  std::string planned_as_disc{};     // Explainer::planned_as_disc()
};

/// One line with its line end.
std::string plan_json(const PlanResult& result, const Frame& frame,
                      std::span<const Layer> layers = {});

/// The command list of a car's plan, with poses as pose_text() writes them; empty without a path. Each line has its
/// line end.
std::string drive_commands(const Plan& plan, const Frame& frame);

/// The number of a car's moves in reverse.
std::size_t steps_in_reverse(const Plan& plan);

}  // namespace wend
