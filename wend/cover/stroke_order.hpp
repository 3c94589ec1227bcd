#pragma once

// The order in which a robot drives strokes, each in either direction: the one with the least length of the ways between
// them, and the least turning.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/limits.hpp"
#include "wend/cover/coverage_area.hpp"

namespace wend {

struct StrokeOrderOptions {
  double turn_cost = 0;             // of half a turn, in cells; other turns in proportion
  std::optional<Point> start = {};  // where the robot is before, reachable
  std::optional<Point> end = {};    // where it has to be afterwards, reachable
  std::uint64_t kicks_per_stop = 1;
  std::uint64_t seed = 1;
  Limits limits = {};
};

/// The strokes in order, reversed where they are driven backwards. Fails as plan_tour() does. O(strokes^2).
Expected<std::vector<Stroke>, Error> ordered(const CoverageArea& area, std::vector<Stroke> strokes,
                                             const StrokeOrderOptions& options);

}  // namespace wend
