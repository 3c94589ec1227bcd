#pragma once

// Paths for people and for programs: their metrics, where they collide, and how smoothing changed them.
//
//   const std::vector<wend::MeasuredPath> paths{wend::measured("planned", plan->path, space),
//                                               wend::measured("smoothed", refined->path, space)};
//   std::cout << wend::metrics_table(paths, wend::metres_of(space.map().frame()));
//
// In JSON all of metrics_of() follow, lengths in cells and in metres, angles in degrees:
//
//   {"points": 2, "length_cells": 3.0, "length_m": 0.15, "turning_degrees": 0.0, ..., "reversals": 0, ...}
//
// Infinite values are null: the turning radius of a line, the clearance if nothing is near. The radii
// are those of PathMetrics: without rounding a corner has radius 0.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "wend/geometry/frame.hpp"
#include "wend/io/file_error.hpp"
#include "wend/path/path.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/refinement.hpp"
#include "wend/report/trajectory_report.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// The unit of lengths for people.
struct LengthUnit {
  std::string_view name = "cells";
  double per_cell = 1;
};

inline LengthUnit metres_of(const Frame& frame) { return {"m", frame.resolution}; }

struct MeasuredPath {
  std::string title;  // "smoothed"
  std::size_t points = 0;
  std::optional<PathMetrics> metrics{};  // nothing: it cannot be measured
};

/// Measures a path. It may leave the map: one that measure() refuses has no metrics. Corners are rounded as there.
MeasuredPath measured(std::string title, const Path& path, const FreeSpace& space,
                      double corner_rounding = kCornerRounding);

/// A line for each metric, a column for each path, with the titles above if there are several paths. All
/// are measured with the same corner rounding. Empty if the first has no metrics.
std::string metrics_table(std::span<const MeasuredPath> paths, const LengthUnit& unit);

/// The name of the kind for programs: "too_close".
std::string_view to_string(CollisionKind kind);

/// {"schema": 1, "free": false, "collision": {"kind": "too_close", "along_cells", "along_m", "point": [x,y],
/// "point_m": [x,y], "obstacle": [i,j]}, "metrics": {...}}; null without a collision, and
/// without metrics. If the path begins with a way out of what blocks its start, "lead_out": {"length_cells", "length_m"}
/// follows. One line with its line end.
std::string check_json(const MeasuredPath& path, const std::optional<PathCollision>& collision,
                       const Frame& frame, double lead_cells = 0);

/// A path before and after refinement.
struct RefinedPath {
  Path before;
  Refinement wanted;
  Refined refined;
  MeasuredPath measured_before;
  MeasuredPath measured_after;
};

RefinedPath refined_path(Path before, const Refinement& wanted, Refined refined,
                         const FreeSpace& space, double corner_rounding = kCornerRounding);

/// The result of smoothing, a line for each value; empty if nothing was smoothed.
std::string smoothing_text(const RefinedPath& path, const LengthUnit& unit = {});

/// {"schema", "path", "path_m", "path_smoothed", "path_smoothed_m", "smoothing": {"smoother", "sweeps",
/// "converged", "held", "returned", "within_bound", "largest_distance_cells", "largest_distance_m"}, "path_metrics", "path_smoothed_metrics"}.
/// `path` are cells, and is left out for a path without cells; `path_smoothed` are waypoints in grid
/// coordinates; `smoothing` is null if nothing was smoothed. For a path of poses, "poses_m" and "gears" follow as in
/// plan_json(). With a trajectory along the refined path,
/// "trajectory" follows: see trajectory_report.hpp. One line with its line end.
std::string smoothing_json(const RefinedPath& path, const Frame& frame,
                           const std::optional<SampledTrajectory>& trajectory = {});

/// {"schema": 1, "status": "not_free", "reason": "...", "path": [], "path_m": []}: replaces a path that
/// does not exist. load_path() reads the status and the reason back.
std::string failed_plan_json(const FailedPlan& plan);

}  // namespace wend
