#pragma once

// The two passes of time-optimal path parameterisation: they lower the speeds at places of a path until
// a robot can reach each of them from the place before, and brake to each of them in time.
//
// At constant acceleration a, the square of the speed changes linearly along the path, by 2 a ds. So
// `squared` are squares of speeds, and change(i) is 2 a ds from place i to place i + 1.
//
// J. Bobrow, S. Dubowsky and J. Gibson, "Time-Optimal Control of Robotic Manipulators Along Specified
// Paths", 1985, for limits that depend on the place alone.

#include <algorithm>
#include <cstddef>
#include <span>

namespace wend {

/// Forwards: squared[i + 1] <= squared[i] + change(i). O(n).
template <class Change>
void limit_acceleration(std::span<double> squared, const Change& change) {
  for (std::size_t i = 1; i < squared.size(); ++i) {
    squared[i] = std::min(squared[i], squared[i - 1] + change(i - 1));
  }
}

/// Backwards: squared[i] <= squared[i + 1] + change(i). O(n).
template <class Change>
void limit_braking(std::span<double> squared, const Change& change) {
  for (std::size_t i = squared.size(); i-- > 1;) {
    squared[i - 1] = std::min(squared[i - 1], squared[i] + change(i - 1));
  }
}

}  // namespace wend
