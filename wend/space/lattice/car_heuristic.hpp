#pragma once

// Heuristics of the car: estimates of the cost from a pose to a corner and, optionally, a heading.
//
//   zero       0
//   diagonal   (diagonal cells) pi / 2 + (orthogonal rest) 1
//   headings   what the drive costs on an empty yard, exactly
//   obstacles  the larger of that and of the cheapest way around the obstacles for a car that turns
//              on the spot (searched anew for every query; CornerSpace)
//
// All are consistent: multipliers are at least 1, and where reversing costs less than driving ahead
// the estimates are scaled by that factor.

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "wend/geometry/corner_pose.hpp"

namespace wend {

/// A goal in lattice coordinates; without a heading, any heading is accepted.
struct CarGoal {
  Cell vertex;
  std::optional<Heading> heading{};

  bool contains(const CornerPose& place) const {
    return place.vertex == vertex && (!heading || place.heading == *heading);
  }
};

/// Costs have kStraight and kTurn.
template <class Costs>
constexpr typename Costs::Cost diagonal_estimate(Cell from, Cell to) {
  using Cost = typename Costs::Cost;
  const int dx = std::abs(to.x - from.x);
  const int dy = std::abs(to.y - from.y);
  const auto turns = static_cast<Cost>(std::min(dx, dy));
  const auto straight = static_cast<Cost>(std::max(dx, dy) - std::min(dx, dy));
  return turns * Costs::kTurn + straight * Costs::kStraight;
}

namespace empty_yard {

/// Which turns must be odd in number between two headings. Bit 0: turns along the diagonal x = y, which
/// swap +x with +y and -x with -y. Bit 1: turns along the other diagonal, which swap +x with -y and -x
/// with +y. Their order does not matter: the two swaps commute.
constexpr unsigned odd_turns(Heading from, Heading to) {
  return static_cast<unsigned>(from) ^ static_cast<unsigned>(to);
}

/// The cost of the cheapest path with turns of these parities.
template <class Costs>
constexpr typename Costs::Cost cheapest(Cell way, Heading from, unsigned odd) {
  using Cost = typename Costs::Cost;
  const int shorter = std::min(std::abs(way.x), std::abs(way.y));
  const int sign = way.x < 0 ? -1 : 1;
  const bool along_first = (way.x < 0) == (way.y < 0);
  const int best_p = along_first ? sign * shorter : 0;
  const int best_q = along_first ? 0 : sign * shorter;
  const auto cost = [&](int turns, int straight) {
    return static_cast<Cost>(turns) * Costs::kTurn + static_cast<Cost>(straight) * Costs::kStraight;
  };
  const bool straight_only = is_along_x(from) ? way.y == 0 : way.x == 0;
  Cost least = cost(0, 0);
  bool any = false;
  for (int p = best_p - 2; p <= best_p + 2; ++p) {
    if ((static_cast<unsigned>(p) & 1U) != (odd & 1U)) continue;
    for (int q = best_q - 2; q <= best_q + 2; ++q) {
      if ((static_cast<unsigned>(q) & 1U) != (odd >> 1U)) continue;
      const int straight = std::abs(way.x - p - q) + std::abs(way.y - p + q);
      int turns = std::abs(p) + std::abs(q);
      if (turns == 0 && !straight_only) turns = 2;  // turn there and back, to face the other axis
      const Cost candidate = cost(turns, straight);
      least = any ? std::min(least, candidate) : candidate;
      any = true;
    }
  }
  return least;
}

}  // namespace empty_yard

/// The cost of the cheapest path on an empty yard, O(1).
///
/// The final heading depends only on whether the number of turns along each diagonal is odd. With at
/// least one turn the car faces along both axes somewhere, and can drive straight along both. It remains
/// to find the net numbers p and q of turns along the two diagonals, with the parities that the headings
/// require, for which |p| + |q| turns and the straight rest cost least. They are within 2 of the best
/// numbers without parities.
template <class Costs>
constexpr typename Costs::Cost headings_estimate(const CornerPose& from, const CarGoal& goal) {
  const Cell way{goal.vertex.x - from.vertex.x, goal.vertex.y - from.vertex.y};
  if (goal.heading) {
    return empty_yard::cheapest<Costs>(way, from.heading,
                                       empty_yard::odd_turns(from.heading, *goal.heading));
  }
  const bool across =
      is_along_x(from.heading) ? way.x == 0 && way.y != 0 : way.y == 0 && way.x != 0;
  if (!across) return diagonal_estimate<Costs>(from.vertex, goal.vertex);
  auto least = empty_yard::cheapest<Costs>(way, from.heading, 0);
  for (unsigned odd = 1; odd < kHeadings; ++odd) {
    least = std::min(least, empty_yard::cheapest<Costs>(way, from.heading, odd));
  }
  return least;
}

}  // namespace wend
