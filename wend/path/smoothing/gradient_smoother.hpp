#pragma once

// The gradient smoother: gradient descent on
//
//   sum over the inner points of  alpha (s_i - p_i)^2  +  sum of  beta (s_i - s_i+1)^2
//
// where p is the path and s the smoothed one, in grid coordinates: alpha holds the points, beta draws
// neighbours together. S. Thrun, "Artificial Intelligence for Robotics", Udacity 2012. A sweep does,
// for every inner point,
//
//   s_i += -(alpha + 2 beta) s_i + alpha p_i + beta s_i-1 + beta s_i+1
//
// with all neighbours from the sweep before, or in place. It ends when the squared changes of a sweep
// sum to less than epsilon, or after max_sweeps. From the sweep before it diverges unless
// alpha + 4 beta < 2, in place unless alpha + 2 beta < 2; such options are refused.
//
//   const auto smoothed = wend::smooth_by_gradient(plan->path, space, {.beta = 0.4});
//
// Safe (unless `unsafe`): where the two lines of a point, or the turns of a polygon at their ends, would
// not stay free it makes an eighth of its
// move, or none in that sweep; one that could not move rests for 1, 2, 4 and then 8 sweeps. With such
// moves cut or left out the objective still does not grow from sweep to sweep. O(points) a sweep; a
// move where there is room costs two comparisons (smoothing.hpp).

#include <cstdint>

#include "wend/base/compiler.hpp"
#include "wend/path/smoothing/smoother.hpp"

namespace wend {

/// The options of the gradient smoother.
struct GradientOptions {
  double alpha = 0.1;              // 0 to 2: holds each point at its original position
  double beta = 0.3;               // 0 to 1: pulls neighbouring points together
  double epsilon = 0.001;          // squared cells
  std::int64_t max_sweeps = 1000;  // 1 to 1e9
  double max_distance = 0;         // cells: how far a point moves at most; 0: any distance
  bool in_place = false;           // use the new position of a point within the same sweep
  bool unsafe = false;             // skip the collision check
  bool squeeze = false;            // a point may pass between two obstacles that touch at a corner

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"alpha", "weight that holds each point at its original position"}, self.alpha, {0, 2});
    field({"beta", "weight that pulls neighbouring points together"}, self.beta, {0, 1});
    field({"epsilon",
           "threshold for convergence: the sum of the squared changes of a sweep (cells squared)"},
          self.epsilon, {0, 1e6});
    field({"max_sweeps", "limit on the number of sweeps"}, self.max_sweeps, {1, 1e9});
    field({"max_distance", "largest distance from the given path, in cells; 0: any distance"},
          self.max_distance, {0, 1e6});
    field({"in_place", "use the new position of a point within the same sweep"}, self.in_place);
    field({"unsafe", "skip the collision check; the path may collide with obstacles"}, self.unsafe);
    field({"squeeze", "a point may pass between two obstacles that touch at a corner"},
          self.squeeze);
  }
};

/// Smooths a path of cells or waypoints. Fails with invalid_option for options out of range, and with
/// unsupported_query for a path of poses, one with a fault (path_fault.hpp) or one that is not free. O(points) a
/// sweep.
WEND_API SmoothingResult smooth_by_gradient(const Path& path, const FreeSpace& space,
                                            const GradientOptions& options = {},
                                            const StopSmoothing& stop = {});

}  // namespace wend
