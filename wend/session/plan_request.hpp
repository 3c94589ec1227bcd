#pragma once

// PlanRequest: what a Session plans, in metres of the map's frame, and what is done with the path.
// PlanAnswer: what came of it.
//
//   wend::PlanRequest request{{1, 1, 0}, {{{15, 9}}}};
//   request.planner.name = "jps";
//   request.refinement.smoother = wend::SmootherChoice{"gradient"};

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "wend/base/choice.hpp"
#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/limits.hpp"
#include "wend/geometry/map_pose.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/refinement.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/failure.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/search/search_metrics.hpp"
#include "wend/session/leeway.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// Where a path may end, in metres. On a map without a resolution, a cell is 1 m.
struct MapGoal {
  MapPoint point;                      // metres, in the map's frame
  std::optional<double> heading = {};  // radians; unset: any heading
  double tolerance = 0;                // metres: how far from the point a path may end, see Goal
  double heading_tolerance = 0;        // radians: the same for the heading
};

/// What places and lengths are given or said in.
enum class MapUnits {
  metres,  // of the map's frame
  cells    // grid coordinates
};

/// What people call the units: their names in options.
constexpr std::array<Choice<MapUnits>, 2> choice_names(MapUnits) {
  return {{{"metres", MapUnits::metres}, {"cells", MapUnits::cells}}};
}

/// What messages call the ends of a request: texts as a person typed them. Where one is empty, the place itself is
/// said.
struct EndTexts {
  std::string start = {};               // "(1.5,2,45deg) m"
  std::vector<std::string> goals = {};  // empty, or one for each goal
};

struct PlanRequest {
  MapPose start;                 // grid planners ignore headings
  std::vector<MapGoal> goals;    // one or more; the cheapest is found
  PlannerSpec planner{"astar"};  // and its options
  Limits limits = {};            // of the search; those on time and the flag are of the whole call
  SearchObserver* observer = nullptr;  // of the search; not owned
  OnSolution on_solution = {};         // as Query::on_solution: paths in grid coordinates
  /// Moves blocked ends, see nearest_ends() and Planner::nearest_free(), and goals that no path reaches.
  bool nearest = false;
  /// By how much at most, in metres. Unset: 1 m on a map in metres, else by any distance.
  std::optional<double> nearest_limit = {};
  /// The longest way out of a start where the robot does not fit, in metres; 0: none. See way_out().
  double escape = 0;
  /// If no path reaches a goal, ends at the reachable place that is nearest to one.
  bool closest = false;
  bool explain = true;  // why there is no path, at length; else in a short sentence
  /// Answers from the costs to the goals from everywhere, which are kept for the next request with the
  /// same goals. For planners that step from cell to cell.
  bool from_field = false;
  /// For Session::replan(), at least 0: by which share of its cost another path must be cheaper than what is left of
  /// the last one. 0: any cheaper path is taken; 1: the last one is kept as long as it is free.
  double keep = 0;
  Refinement refinement = {};                       // the planner's moves replace its adjacency
  std::optional<TrajectoryLimits> trajectory = {};  // also times the path
  double corner_rounding = kCornerRounding;         // cells; of the trajectory
  /// What start, goals and tolerances are given in. In cells, they are grid coordinates, and so are their headings:
  /// exactly what a Query has.
  MapUnits coordinates = MapUnits::metres;
  MapUnits wording = MapUnits::metres;  // of messages; where a map has no resolution, cells
  EndTexts texts = {};                  // what messages call the ends

  /// What it may do where the robot cannot be.
  Leeway leeway() const { return {escape, nearest, nearest_limit, closest}; }
};

/// A path, what was done with it, and the space that it was planned on.
struct PlanAnswer {
  FreeSpace space;                      // that it was planned on
  Plan plan;                            // as the planner found it, in grid coordinates, but for
                                        // its ends, see with_ends(); its cost is that of the
                                        // path behind the lead out, between the centres
  std::optional<GridMoves> moves = {};  // how the planner moves
  std::optional<Refined> refined = {};  // if a refinement was asked for
  std::optional<Trajectory> trajectory = {};  // if one was asked for
  std::optional<Error> fault = {};            // why the path could not be refined or timed
  std::vector<std::string> notes =
      {};                     // a sentence for each end that was moved or led out, and one if a
                              // polygon was planned for as the disc around it
  double search_seconds = 0;  // by SessionOptions::clock
  bool kept = false;          // is it what was left of the last path? See Session::replan()
  std::optional<LeadOut> lead_out =
      {};  // how both paths begin, if the robot did not fit at the start
  /// Metres from the path's end to the nearest goal; 0 if it was reached. Set if the request says closest, or the goals
  /// were moved because no path reaches them.
  std::optional<double> remaining = {};

  /// How far the path begins from the start that was asked for, in metres: 0 wherever the robot can go from there to the
  /// middle of its cell, for planners on cells; those on lattices begin at a vertex.
  double start_shift() const { return in_metres(plan.start_snapping_error.distance); }
  /// The same of its end and the goal that is nearest to it, tolerance included.
  double goal_shift() const { return in_metres(plan.goal_snapping_error.distance); }

  /// The path, refined if it could be; in grid coordinates.
  const Path& path() const { return refined ? refined->path : plan.path; }

  /// Its poses in metres of the map's frame. O(n).
  WEND_API std::vector<MapPose> poses() const;

 private:
  double in_metres(double cells) const { return cells * space.map().frame().resolution; }
};

/// Why there is no answer, in a sentence that says where and what would help.
struct RequestFailure : PlanFailure {
  double search_seconds = 0;  // by SessionOptions::clock
};

/// The query of a request in the grid coordinates of a map.
WEND_API Query query_of(const PlanRequest& request, const Frame& frame);

/// Refines the path of an answer, as the request says, puts the lead before it, if there is one, and times it. If that
/// fails, or there is no time for it before the deadline, the answer's fault says why. The lead is never refined.
WEND_API void finish_path(PlanAnswer& answer, const PlanRequest& request, const Path& lead = {},
                          const Deadline& deadline = {});

/// The fastest trajectory along a path with rounded corners, see rounded_corners() and Trajectory::along(). Fails as
/// they do.
WEND_API Expected<Trajectory, Error> timed_path(const Path& path, const FreeSpace& space,
                                                Adjacency adjacency, const TrajectoryLimits& limits,
                                                double corner_rounding = kCornerRounding,
                                                const Deadline& deadline = {});

}  // namespace wend
