#pragma once

// Leeway: what a query may do where the robot cannot be: begin with a way out, move blocked ends, end at the closest
// place. Lengths are in metres.

#include <limits>
#include <optional>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/geometry/frame.hpp"

namespace wend {

struct Leeway {
  /// By how much an end is moved at most, in metres, unless a limit is given, on a map in metres. On others a limit
  /// has to be given.
  static constexpr double kUsualNearestLimit = 1;

  /// The longest way out of a start where the robot does not fit: see way_out(). 0: none.
  double escape = 0;
  /// Moves ends where the robot does not fit to the nearest place, and goals that no path reaches to the nearest one
  /// that a path reaches.
  bool nearest = false;
  /// By how much at most. Unset: by kUsualNearestLimit on a map in metres, else by any distance.
  std::optional<double> nearest_limit = {};
  /// If no path reaches a goal, ends at the reachable place that is nearest to one.
  bool closest = false;

  /// The longest way out in cells.
  double escape_in_cells(const Frame& frame) const { return escape / frame.resolution; }
  /// By how much an end is moved at most, in cells.
  double nearest_in_cells(const Frame& frame) const {
    if (nearest_limit) return *nearest_limit / frame.resolution;
    return frame.metric ? kUsualNearestLimit / frame.resolution
                        : std::numeric_limits<double>::infinity();
  }
};

/// Why a leeway is not valid, if it is not: invalid_option for a length that is NaN or below 0.
WEND_API std::optional<Error> fault_of(const Leeway& leeway);

}  // namespace wend
