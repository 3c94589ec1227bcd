#pragma once

// Paths for people and for programs: what can be measured of them, where they collide, what smoothing
// did to them.
//
//   const std::vector<wend::MeasuredPath> paths{wend::measured("planned", plan->path, space),
//                                               wend::measured("smoothed", refined->path, space)};
//   std::cout << wend::metrics_table(paths, wend::metres_of(space.map().frame()));
//
// In JSON lengths are in cells and in metres:
//
//   {"points": 2, "length_cells": 3.0, "length_m": 0.15, "turning_degrees": 0.0,
//    "smallest_turning_radius_cells": null, "smallest_turning_radius_m": null,
//    "rounded_turning_radius_cells": null, "rounded_turning_radius_m": null,
//    "corner_rounding_cells": 0.1, "corner_rounding_m": 0.005,
//    "smallest_clearance_cells": 1.0, "smallest_clearance_m": 0.05, "mean_clearance_cells": 1.5,
//    "mean_clearance_m": 0.075, "reversals": 0}
//
// What is infinite is null: the turning radius of a line, the clearance where nothing is near. The
// radii are those of PathMetrics: without rounding a corner has 0.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "wend/geometry/frame.hpp"
#include "wend/io/io_error.hpp"
#include "wend/path/path.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/refinement.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// What people count lengths in.
struct LengthUnit {
  std::string_view name = "cells";
  double per_cell = 1;
};

inline LengthUnit metres_of(const Frame& frame) { return {"m", frame.resolution}; }

struct MeasuredPath {
  std::string title;  // "smoothed"
  std::size_t points = 0;
  PathMetrics metrics{};
};

/// Of a path that is not empty; it may leave the map. Corners are rounded as measure() does.
MeasuredPath measured(std::string title, const Path& path, const FreeSpace& space,
                      double corner_rounding = kCornerRounding);

/// A line for each thing that is measured, a column for each path, with their titles above if there
/// are several. All are measured with the same corner rounding.
std::string metrics_table(std::span<const MeasuredPath> paths, const LengthUnit& unit);

/// The kind as programs call it: "too_close".
std::string_view to_string(CollisionKind kind);

/// {"schema": 1, "free": false, "collision": {"kind": "too_close", "along_cells", "along_m", "point": [x,y],
/// "point_m": [x,y], "obstacle": [i,j]}, "metrics": {...}}; null without a collision. One line with
/// its line end.
std::string check_json(const MeasuredPath& path, const std::optional<PathCollision>& collision,
                       const Frame& frame);

/// What a path was and what became of it.
struct RefinedPath {
  Path before;
  Refinement wanted;
  Refined refined;
  MeasuredPath measured_before;
  MeasuredPath measured_after;
};

RefinedPath refined_path(Path before, const Refinement& wanted, Refined refined,
                         const FreeSpace& space, double corner_rounding = kCornerRounding);

/// What smoothing did, a line for each thing; empty if nothing was smoothed.
std::string smoothing_text(const RefinedPath& path);

/// {"schema", "path", "path_m", "path_smoothed", "path_smoothed_m", "smoothing": {"smoother", "sweeps",
/// "converged", "held", "returned", "within_bound"}, "path_metrics", "path_smoothed_metrics"}.
/// `path` are cells, and left out of a path that has none; `path_smoothed` are waypoints in grid
/// coordinates; `smoothing` is null if nothing was. One line with its line end.
std::string smoothing_json(const RefinedPath& path, const Frame& frame);

/// {"schema": 1, "status": "not_free", "reason": "...", "path": [], "path_m": []}: what takes the
/// place of a path that is not there. load_path() reads the status and the reason back.
std::string failed_plan_json(const FailedPlan& plan);

}  // namespace wend
