#pragma once

// A smoother that bounds curvature: bends no tighter than a turning radius, for robots that steer.
//
//   const auto drivable = wend::smooth_by_curvature(plan->path, space, {.radius = 4});
//   if (drivable && !drivable->within_bound) report("too tight");
//
// First gradient descent, in place (gradient_smoother.hpp); then sweeps in which every
// three successive points that bend more than they may are moved by the least that puts them right,
// and somewhat more (S. Kaczmarz 1937, with over-relaxation; as M. Müller and others do it in
// position-based dynamics, 2007), and in which points keep even distances. A bend is wide enough if an
// arc of that radius rounds it within a tenth of a cell (Corner in path_metrics.hpp), as measure() says it;
// lines that are long for that (more than 1.5 cells or half the radius) are divided first, so the
// result may have more points than the path.
//
// It is a local method: it widens bends as far as obstacles let it, and does not look for another way
// around. No point moves farther than two radii from where it was, or `max_distance`: where a path comes back beside
// itself, bends that are too tight stay so. Smoothed::within_bound says whether all of them are wide enough. On 100 plans of A* on
// generated offices, for a robot 0.4 m wide in cells of 0.1 m, it met radii of 0.3 and 0.4 m on all
// and 0.5 m on 99; 1 m, which doors there hardly allow, on 35 (tests/smoothing_test.cpp).

#include <cstdint>

#include "wend/path/smoothing/smoother.hpp"

namespace wend {

struct CurvatureOptions {
  double radius = 4;  // cells: the smallest turning radius; 0: any
  double alpha = 0.02;
  double beta = 0.3;
  std::int64_t max_sweeps = 5000;
  double max_distance = 0;  // cells: how far a point moves at most; 0: two radii
  bool unsafe = false;
  bool squeeze = false;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"radius", "lower limit on the turning radius, in cells"}, self.radius, {0, 1e6});
    field({"alpha", "weight that holds each point at its original position"}, self.alpha, {0, 2});
    field({"beta", "weight that pulls neighbouring points together"}, self.beta, {0, 1});
    field({"max_sweeps", "limit on the number of sweeps"}, self.max_sweeps, {1, 1e9});
    field({"max_distance",
           "largest distance from the given path, in cells; 0: twice the turning radius"},
          self.max_distance, {0, 1e6});
    field({"unsafe", "even through obstacles"}, self.unsafe);
    field({"squeeze", "a point may pass between two obstacles that touch at a corner"},
          self.squeeze);
  }
};

/// Errors: see SmoothingResult; unsupported_query for a path that would be divided into more than kMostResampled
/// points, too. O(points) a sweep.
SmoothingResult smooth_by_curvature(const Path& path, const FreeSpace& space,
                                    const CurvatureOptions& options = {},
                                    const StopSmoothing& stop = {});

}  // namespace wend
