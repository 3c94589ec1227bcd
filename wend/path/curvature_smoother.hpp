#pragma once

// A smoother that bounds curvature: bends no tighter than a turning radius, for robots that steer.
//
// The textbook's gradient descent (gradient_smoother.hpp), and between its sweeps every three
// successive points that bend more than they may are moved the least that puts them right
// (S. Kaczmarz 1937, as position-based dynamics does it: M. Müller and others 2007). Curvature of
// three points is Menger's, 1 / the radius of the circle through them. Where obstacles leave no room
// the bend stays tighter, and Smoothed::within_bound says so.

#include <cstdint>

#include "wend/path/smoother.hpp"

namespace wend {

struct CurvatureOptions {
  double radius = 4;  // cells: the smallest turning radius
  double alpha = 0.02;
  double beta = 0.3;
  std::int64_t max_sweeps = 5000;
  bool unsafe = false;
  bool squeeze = false;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"radius", "the smallest turning radius, in cells"}, self.radius, {0, 1e6});
    field({"alpha", "how strongly points are held where they were"}, self.alpha, {0, 2});
    field({"beta", "how strongly neighbours are drawn together"}, self.beta, {0, 1});
    field({"max_sweeps", "done after so many sweeps"}, self.max_sweeps, {1, 1e9});
    field({"unsafe", "whatever it runs into"}, self.unsafe);
    field({"squeeze", "a point may pass between two obstacles that touch at a corner"},
          self.squeeze);
  }
};

/// Errors: see SmoothingError. A path is not empty.
SmoothingResult smooth_by_curvature(const Path& path, const FreeSpace& space,
                                    const CurvatureOptions& options = {});

}  // namespace wend
