#pragma once

// An independent check of driven paths: it drives them itself, in steps, and places the robot's shape on the
// map's cells at every step. It shares no code with the planners, nor with path_collision.hpp: nothing of a
// FreeSpace but its map, its policies and the robot.
//
//   const DriveReport report = checked_drive(space, plan.path, query, {.turning_radius = 4});
//   if (!report.fault.empty()) complain(report.fault);

#include <string>

#include "wend/path/path.hpp"
#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::test {

/// What a path may do. Lengths are cells.
struct DriveRules {
  double turning_radius = 0;    // least radius of arcs; 0: any
  bool reverses = true;         // may it drive in reverse?
  bool turns_in_place = false;  // may it turn without driving?
  bool moves_aside = false;     // may it drive in another direction than its heading?
  double step = 0.1;            // of the base point between two places of the shape
  double end_tolerance =
      1e-6;             // cells, and radians; from the start, and beyond the goal's tolerance
  double depth = 1e-6;  // how deep the shape may reach into a cell: rounding errors
};

struct DriveReport {
  std::string fault;  // the first one, in words; empty if there is none
  double length = 0;  // cells, also of the part in reverse
  double reversed = 0;
  int gear_changes = 0;
  double least_radius = 0;  // of the arcs; infinite without arcs
};

/// Drives a path of poses from the start of a query to one of its goals. O(length / step * cells under the
/// robot * corners).
DriveReport checked_drive(const FreeSpace& space, const Path& path, const Query& query,
                          const DriveRules& rules);

}  // namespace wend::test
