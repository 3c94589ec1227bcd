#pragma once

// Query: start, goals, limits and observer. Plan: the path that a planner found. (Failure, in failure.hpp: why it found
// none.)

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

class SearchObserver;
struct Plan;

/// Receives a path, on the thread that searches. The plan is that of the caller, valid until it returns. If a path is
/// good enough, set the flag Limits::cancel here: this path is then the answer.
///
///   query.limits.seconds = 0.05;
///   query.on_solution = [&](const wend::Plan& plan) { bounds.push_back(plan.bound); };
using OnSolution = std::function<void(const Plan&)>;

/// Where a path may end, in grid coordinates: a pose, or a point with any heading; with a tolerance, near it.
///
/// A path ends at a place of the planner: the centre of a cell, or a vertex of a lattice. It may be the place
/// that stands for the point (the cell that it lies in, the nearest vertex), or any at a distance of at most
/// `tolerance`. In the same way its heading, if the planner has headings and the goal has one, may be the
/// nearest of the planner, or any that differs by at most `heading_tolerance`. So a larger tolerance never
/// takes a path away, and the point itself may be blocked or off the map. The path is the planner's best to
/// any of these ends. A query takes O(places within the tolerance) more.
///
///   wend::Query query{start, {wend::Goal(wend::Pose{18.5, 4.5, 0}, 3)}};  // at most 3 cells away
struct Goal {
  Point point;                    // grid coordinates
  std::optional<double> heading;  // radians; unset: any heading
  double tolerance = 0;           // cells, at least 0
  double heading_tolerance = 0;   // radians, at least 0; grid planners ignore it

  /// What a distance or angle may exceed a tolerance by: metres and degrees are rounded when they become
  /// cells and radians.
  static constexpr double kRounding = 1e-9;

  /// A point with a heading, and how far from both a path may end.
  // NOLINTNEXTLINE(google-explicit-constructor): a pose is a goal
  Goal(const Pose& pose, double most_cells = 0, double most_radians = 0)
      : point(pose.point()),
        heading(pose.heading),
        tolerance(most_cells),
        heading_tolerance(most_radians) {}
  /// A point with any heading.
  explicit Goal(Point where, double most_cells = 0) : point(where), tolerance(most_cells) {}

  /// Is a point within the tolerance? Without a tolerance, none is.
  bool reaches(Point where) const {
    return tolerance > 0 && distance(point, where) <= tolerance + kRounding;
  }
  /// Is a heading, in radians, within the tolerance? Without a tolerance, none is; without a heading, all
  /// are.
  bool reaches_heading(double radians) const {
    if (!heading) return true;
    return heading_tolerance > 0 &&
           std::abs(normalized_angle(radians - *heading)) <= heading_tolerance + kRounding;
  }

  friend bool operator==(const Goal&, const Goal&) = default;
};

/// A query in grid coordinates. A grid planner uses the cells of start and goal and ignores
/// headings. A car uses the nearest vertices and headings of its lattice (Plan has the snapping
/// errors). With several goals, the planner finds the path to the cheapest one.
struct Query {
  Pose start;                          // grid coordinates
  std::vector<Goal> goals;             // one or more
  Limits limits = {};                  // of the search
  SearchObserver* observer = nullptr;  // receives every event of the search; not owned
  /// Receives each path of an anytime planner (Capabilities::anytime) with its cost, its bound and the work
  /// until then: costs and bounds never rise, and one of them falls. The last one is the answer. Other planners
  /// tell their answer. Null: nobody.
  OnSolution on_solution = {};

  /// From the centre of one cell to the centre of another.
  static Query between(Cell start, Cell goal) { return {pose_at(start), {pose_at(goal)}}; }
};

/// The error of a path's start or end against the query: a car snaps to the nearest vertex and
/// heading.
struct SnappingError {
  double distance = 0;  // cells; 0 for grid planners
  double turn = 0;      // radians, not negative

  friend bool operator==(const SnappingError&, const SnappingError&) = default;
};

/// A path, its cost, and the work of the search.
struct Plan {
  /// The `bound` of a plan without a guarantee about the cost.
  static constexpr double kNoBound = std::numeric_limits<double>::infinity();

  Path path;  // grid coordinates
  /// Recomputed from the path by its space. In cells, times terrain; for a car, its fuel in units.
  double cost = 0;
  double bound = kNoBound;              // cost <= bound * the cheapest cost; 1: optimal
  std::vector<std::string_view> moves;  // one fewer than poses, if moves have names
  SnappingError start_snapping_error;   // from the query's start
  SnappingError goal_snapping_error;    // from the goal that was reached, tolerance included
  SearchMetrics metrics;                // of the whole search

  /// Is it certain that no path is cheaper?
  bool optimal() const { return bound == 1; }
};

}  // namespace wend
