#pragma once

// Query: from where, to where, with what limits, and who watches. Plan: what a planner found.
// PlanFailure: why it found nothing.

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/base/status.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

class SearchObserver;

/// Where a path may end, in grid coordinates. A pose is a goal; a point is one with any heading.
struct Goal {
  Point point;
  std::optional<double> heading;  // radians; nothing: any will do

  // NOLINTNEXTLINE(google-explicit-constructor): a pose is a goal
  Goal(const Pose& pose) : point(pose.point()), heading(pose.heading) {}
  explicit Goal(Point where) : point(where) {}
};

/// In grid coordinates. A grid planner takes the cells that start and goal lie in, whatever the
/// headings; a car the nearest corners and headings of its lattice (Plan says how near). With
/// several goals the cheapest one is found.
struct Query {
  Pose start;
  std::vector<Goal> goals;
  Limits limits = {};
  SearchObserver* observer = nullptr;  // told every event of the search; not owned

  static Query between(Cell start, Cell goal) { return {pose_at(start), {pose_at(goal)}}; }
};

/// How far from what a query asked for a path begins or ends: grid planners take whole cells, a car
/// the nearest corner and heading.
struct SnappingError {
  double distance = 0;  // cells; of a grid planner 0: any point of a cell is in it
  double turn = 0;      // radians, not negative

  friend bool operator==(const SnappingError&, const SnappingError&) = default;
};

struct Plan {
  /// What `bound` says where nothing is guaranteed about the cost.
  static constexpr double kNoBound = std::numeric_limits<double>::infinity();

  Path path;
  /// Recomputed from the path by its space. In cells, times terrain; of a car its fuel, in units.
  double cost = 0;
  double bound = kNoBound;              // cost <= bound * the cheapest cost; 1: optimal
  std::vector<std::string_view> moves;  // one fewer than poses, where moves have names
  SnappingError start_snapping_error;
  SnappingError goal_snapping_error;  // from the goal that was reached
  SearchMetrics metrics;

  bool optimal() const { return bound == 1; }
};

struct PlanFailure {
  Status status;          // never Status::found
  SearchMetrics metrics;  // of the search until then
  std::string reason{};   // where and why, for people: Planner::reason()
};

}  // namespace wend
