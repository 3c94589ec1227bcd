#include "wend/cover/plan_coverage.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "wend/base/deadline.hpp"
#include "wend/cover/area_parts.hpp"
#include "wend/cover/coverage_area.hpp"
#include "wend/cover/coverage_ends.hpp"
#include "wend/cover/crumbs.hpp"
#include "wend/cover/joined_strokes.hpp"
#include "wend/cover/pruning.hpp"
#include "wend/cover/stroke_order.hpp"
#include "wend/cover/swaths.hpp"
#include "wend/cover/wall_strips.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_collision.hpp"

namespace wend {
namespace {

Unexpected<Error> out_of_time(const Deadline& deadline) {
  return failure(deadline.status(), "planning the coverage: " + deadline.text());
}

CoverageArea area_of(const FreeSpace& space, const CoverageOptions& options, Cell from) {
  CoverageArea area(space, from, options.tool_width / space.map().frame().resolution);
  if (options.area) area.confine_to(*options.area);
  if (options.covered) area.add_covered(*options.covered);
  return area;
}

std::size_t may_stay(const CoverageArea& area, double share) {
  return static_cast<std::size_t>((1 - share) * static_cast<double>(area.wanted().count()));
}

/// Strokes that cover the area up to the share, in no order.
Expected<std::vector<Stroke>, Error> strokes_over(CoverageArea& area,
                                                  const CoverageOptions& options, double turn_cost,
                                                  const Deadline& deadline) {
  constexpr double kLeastStrip = 0.15;  // of the tool's square: a smaller strip is a crumb
  constexpr int kRounds = 2;  // of swaths: what the first left over may lie well for another angle
  const double resolution = area.space().map().frame().resolution;
  const SwathOptions swath_options{options.overlap / resolution, turn_cost, options.angle};
  const CoverageArea before = area;
  std::vector<Stroke> strokes =
      wall_strips(area, kLeastStrip * area.tool_width() * area.tool_width());
  for (int round = 0; round < kRounds; ++round) {
    for (const std::vector<Cell>& part : parts_left(area)) {
      if (deadline.passed()) return out_of_time(deadline);
      const std::vector<Stroke> more = swaths(area, part, swath_options);
      strokes.insert(strokes.end(), more.begin(), more.end());
    }
  }
  const std::size_t rest = may_stay(area, options.share);
  const std::vector<Stroke> more = crumbs(area, rest);
  strokes.insert(strokes.end(), more.begin(), more.end());
  const std::size_t slack = rest - std::min(rest, area.count_left());
  return pruned(before, std::move(strokes), slack);
}

std::size_t turns_of(const std::vector<Point>& points) {
  constexpr double kLeast = 20 * kPi / 180;
  std::size_t turns = 0;
  for (std::size_t i = 2; i < points.size(); ++i) {
    const double before = Line{points[i - 2], points[i - 1]}.heading();
    const double after = Line{points[i - 1], points[i]}.heading();
    if (std::abs(normalized_angle(after - before)) > kLeast) ++turns;
  }
  return turns;
}

BitGrid without(BitGrid cells, const BitGrid& others) {
  for (int y = 0; y < cells.height(); ++y) {
    const auto words = cells.row_words(y);
    const auto taken = others.row_words(y);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] &= ~taken[i];
  }
  return cells;
}

BitGrid unreached_of(const CoverageArea& area, const std::optional<BitGrid>& within) {
  BitGrid free = area.space().obstacles().blocked().complement();
  if (within) free = without(std::move(free), within->complement());
  return without(std::move(free), area.wanted());
}

Coverage coverage_along(Stroke points, CoverageArea area, const CoverageOptions& options) {
  const double resolution = area.space().map().frame().resolution;
  const std::size_t to_cover = area.count_left();
  Coverage coverage;
  if (!points.empty()) area.cover(points);
  coverage.length = length_of(points) * resolution;
  coverage.lower_bound =
      static_cast<double>(to_cover - area.count_left()) / area.tool_width() * resolution;
  coverage.turns = turns_of(points);
  coverage.wanted = area.wanted();
  coverage.covered = without(area.wanted(), area.left());
  coverage.unreached = unreached_of(area, options.area);
  const std::size_t wanted = area.wanted().count();
  if (wanted > 0) {
    coverage.covered_share =
        1 - static_cast<double>(area.count_left()) / static_cast<double>(wanted);
  }
  coverage.path = Path::along(std::move(points));
  return coverage;
}

}  // namespace

Expected<Coverage, Error> plan_coverage(const FreeSpace& space, const CoverageOptions& options) {
  if (auto error = fault_of(options, space)) return Unexpected<Error>(std::move(*error));
  const auto from = first_cell(options, space);
  if (!from) return Unexpected<Error>(from.error());
  const Deadline deadline(options.limits);
  CoverageArea area = area_of(space, options, *from);
  const CoverageArea untouched = area;
  if (area.wanted().count() == 0) {
    return failure(Status::unreachable, "the tool reaches no cell of the area", "area");
  }
  const double resolution = space.map().frame().resolution;
  const double turn_cost = options.turn_cost.value_or(options.tool_width) / resolution;
  auto strokes = strokes_over(area, options, turn_cost, deadline);
  if (!strokes) return Unexpected<Error>(strokes.error());
  if (deadline.passed()) return out_of_time(deadline);
  StrokeOrderOptions order{.turn_cost = turn_cost};
  order.start = standing_place(options.start, space);
  order.end = standing_place(options.end, space);
  order.seed = options.seed;
  order.limits = deadline.left();
  order.limits.seconds = deadline.seconds_left() / 2;  // the ways take time, too
  const std::size_t count = strokes->size();
  const auto in_order = ordered(untouched, std::move(*strokes), order);
  if (!in_order) return Unexpected<Error>(in_order.error());
  auto points = joined(untouched, *in_order, order.start, order.end, deadline);
  if (!points) return Unexpected<Error>(points.error());
  Coverage coverage = coverage_along(std::move(*points), untouched, options);
  coverage.strokes = count;
  return coverage;
}

}  // namespace wend
