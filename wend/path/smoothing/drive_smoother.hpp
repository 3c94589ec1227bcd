#pragma once

// The smoother of drives: of paths of poses, as planners with headings find them. It makes arcs wider, changes
// curvature less abruptly, and keeps away from obstacles, with a given least turning radius. Changes of gear may move.
//
//   const auto smoothed = wend::smooth_drive(plan->path, space, {.turning_radius = 0.4});
//   if (!smoothed) return report(smoothed.error().message);
//
// It lowers the sum, along the path and in units of the turning radius, of
//
//   beta curvature^2 + length + clearance_weight (share by which clearance is too small)^2
//
// and, from piece to piece, of alpha (change of curvature)^2: the terms of D. Dolgov, S. Thrun, M. Montemerlo and
// J. Diebel, "Path Planning for Autonomous Vehicles in Unknown Semi-structured Environments", 2010. Where they move
// points and then have to make the result drivable, here the variables are the curvatures of short arcs and the
// lengths between changes of gear. So every step is drivable, and the bound on curvature is a bound on a variable.
// Windows of a dozen arcs are changed one after the other, with both of their ends fixed, by the method of Gauss and
// Newton (drive_window.hpp). A change is accepted if it lowers the sum, if the robot's shape fits along it, swept
// exactly, if no arc is tighter than allowed, and if the path does not become longer than `longer` allows. If nothing
// can be improved, the result is the path.
//
// Start, goal, turns in place and steps to the side stay as they are. Thread-safe.

#include <cstdint>

#include "wend/base/compiler.hpp"
#include "wend/path/smoothing/smoother.hpp"

namespace wend {

/// The options of the smoother of drives. On maps in cells, a metre is a cell.
struct DriveSmootherOptions {
  double turning_radius =
      0;               // metres; 0, or more than the path's own: that of the path's tightest arc
  double alpha = 0.1;  // weight of squared changes of curvature
  double beta = 0.3;   // weight of squared curvatures
  double clearance =
      0.2;  // metres beyond the inscribed disc that are enough; 0: clearance does not matter
  double clearance_weight = 1;   // weight of the share by which clearance is too small
  double longer = 0.05;          // share by which the path may become longer
  std::int64_t max_sweeps = 20;  // over the whole path
  double max_distance = 0;       // cells: how far a pose moves at most; 0: any distance

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"turning_radius",
           "least turning radius in metres (in cells on maps in cells); 0: that of the tightest "
           "arc of "
           "the path"},
          self.turning_radius, {0, 1e6});
    field({"alpha", "weight of squared changes of curvature"}, self.alpha, {0, 1e3});
    field({"beta", "weight of squared curvatures"}, self.beta, {0, 1e3});
    field({"clearance",
           "distance from obstacles, beyond the robot's inscribed disc, that is enough, in metres; "
           "0: clearance does not matter"},
          self.clearance, {0, 1e6});
    field({"clearance_weight", "weight of the share by which clearance is too small"},
          self.clearance_weight, {0, 1e6});
    field({"longer", "share of its length by which the path may become longer"}, self.longer,
          {0, 1});
    field({"max_sweeps", "limit on the number of sweeps"}, self.max_sweeps, {1, 1e9});
    field({"max_distance", "largest distance from the given path, in cells; 0: any distance"},
          self.max_distance, {0, 1e6});
  }
};

/// No path is cut into more pieces than these to be smoothed.
inline constexpr int kMostDrivePieces = 20'000;

/// Smooths a path of poses. Fails with invalid_option for options out of range, and with unsupported_query for a path
/// of cells or waypoints, one with a fault (path_fault.hpp), one that is not free, and one that is so long for its
/// turning radius that it would be cut into more than kMostDrivePieces. O(arcs) a sweep.
WEND_API SmoothingResult smooth_drive(const Path& path, const FreeSpace& space,
                                      const DriveSmootherOptions& options = {},
                                      const StopSmoothing& stop = {});

/// The sum that smooth_drive() lowers, for a path of poses, cut into pieces as there. Fails as that does, but for a
/// path that is not free. O(arcs).
WEND_API Expected<double, Error> drive_roughness(const Path& path, const FreeSpace& space,
                                                 const DriveSmootherOptions& options = {});

}  // namespace wend
