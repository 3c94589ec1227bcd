#include "wend/map/direction_map.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

constexpr double kMostFactor = 1e4;
constexpr double kRounding = 1e-9;  // radians

/// In steps of 1/256.
std::uint32_t rounded(double factor) {
  if (factor == std::numeric_limits<double>::infinity()) return DirectionMap::kForbidden;
  const double most = std::numeric_limits<std::uint32_t>::max();
  const double steps = std::floor(factor * DirectionMap::kOne + 0.5);
  return static_cast<std::uint32_t>(std::min(steps, most));
}

double factor_of(const Arrow& arrow, double heading) {
  const double away = std::abs(normalized_angle(heading - arrow.heading));
  return away <= arrow.tolerance + kRounding ? 1 : arrow.against;
}

double factor_of(const Slope& slope, double heading) {
  const auto [sine, cosine] = sine_and_cosine(heading);
  const double rise = slope.rise_x * cosine + slope.rise_y * sine;
  return 1 + (rise > 0 ? slope.climb * rise : -slope.descend * rise);
}

template <class Value>
void add_to(std::vector<Value>& values, const std::vector<Value>& more) {
  values.insert(values.end(), more.begin(), more.end());
  std::ranges::sort(values, [](const Value& a, const Value& b) { return a < b; });
}

Error wrong_option(const std::string& name, double value, const std::string& expected) {
  return {Status::invalid_option,
          name + " is " + format_number(value) + ": " + expected + " expected", name};
}

std::optional<Error> fault_of(const ArrowOptions& options) {
  if (!(options.tolerance >= 0 && options.tolerance <= kPi)) {
    return wrong_option("tolerance", options.tolerance, "an angle from 0 to half a turn");
  }
  const bool forbidden = options.factor == std::numeric_limits<double>::infinity();
  if (!forbidden && !(options.factor >= 1 && options.factor <= kMostFactor)) {
    return wrong_option("factor", options.factor, "a factor from 1 to 10000, or infinity");
  }
  return std::nullopt;
}

std::optional<Error> fault_of(const SlopeOptions& options) {
  const auto valid = [](double cost) { return cost >= 0 && cost <= kMostFactor; };
  if (!valid(options.climb)) {
    return wrong_option("climb", options.climb, "a number from 0 to 10000");
  }
  if (!valid(options.descend)) {
    return wrong_option("descend", options.descend, "a number from 0 to 10000");
  }
  return std::nullopt;
}

/// Values for cells that are NaN or finite.
std::optional<Error> fault_of(const GridMap& map, const Grid<double>& values,
                              const std::string& what) {
  const auto wrong = [&](std::string message) {
    return Error{Status::invalid_map, std::move(message), what};
  };
  if (values.width() != map.width() || values.height() != map.height()) {
    return wrong("the " + what + " have " + std::to_string(values.width()) + " x " +
                 std::to_string(values.height()) + " cells, the map " +
                 std::to_string(map.width()) + " x " + std::to_string(map.height()) +
                 ": the same size expected");
  }
  constexpr double kMost = 1e9;
  for (const Cell cell : every_cell(values)) {
    if (std::isnan(values[cell]) || std::abs(values[cell]) <= kMost) continue;
    return wrong("cell (" + std::to_string(cell.x) + ',' + std::to_string(cell.y) + ") of the " +
                 what + " is " + format_number(values[cell]) +
                 ": a number within 1e9 expected, or NaN for none");
  }
  return std::nullopt;
}

GridMap with(const GridMap& map, DirectionMap directions) {
  GridMap directed = map;
  directed.set_directions(std::make_shared<const DirectionMap>(std::move(directions)));
  return directed;
}

/// The rise per cell between the neighbours of a cell, of which some may be off the map or unknown.
double rise_between(const Grid<double>& heights, Cell before, Cell cell, Cell after) {
  const auto known = [&](Cell at) { return heights.contains(at) && !std::isnan(heights[at]); };
  if (!known(cell)) return 0;
  const double low = known(before) ? heights[before] : heights[cell];
  const double high = known(after) ? heights[after] : heights[cell];
  const int cells = (known(before) ? 1 : 0) + (known(after) ? 1 : 0);
  return cells == 0 ? 0 : (high - low) / cells;
}

}  // namespace

double DirectionRule::factor(double heading) const {
  double product = 1;
  for (const Arrow& arrow : arrows) product *= factor_of(arrow, heading);
  for (const Slope& slope : slopes) product *= factor_of(slope, heading);
  return product;
}

double heading_of(Direction direction) {
  // Direction turns from +y towards +x, headings from +x towards +y.
  return normalized_angle(kPi / 2 - static_cast<int>(direction) * (kPi / 4));
}

DirectionMap::DirectionMap(int width, int height) : codes_(width, height, 0) { code_of({}); }

std::uint32_t DirectionMap::code_of(const DirectionRule& rule) {
  const auto next = static_cast<std::uint32_t>(rules_.size());
  const auto [found, added] = known_.try_emplace(rule, next);
  if (!added) return found->second;
  rules_.push_back(rule);
  std::array<std::uint32_t, kDirections> factors{};
  for (int i = 0; i < kDirections; ++i) {
    factors[static_cast<std::size_t>(i)] =
        rounded(rule.factor(heading_of(static_cast<Direction>(i))));
  }
  factors_.push_back(factors);
  return next;
}

void DirectionMap::add(Cell cell, const DirectionRule& rule) {
  DirectionRule sum = rules_[codes_[cell]];
  add_to(sum.arrows, rule.arrows);
  add_to(sum.slopes, rule.slopes);
  codes_[cell] = code_of(sum);
}

std::uint32_t DirectionMap::factor(Cell cell, double heading) const {
  return none_at(cell) ? kOne : rounded(rule(cell).factor(heading));
}

DirectionMap directions_of(const GridMap& map) {
  return map.directions() != nullptr ? *map.directions() : DirectionMap(map.width(), map.height());
}

Expected<GridMap, Error> with_arrows(const GridMap& map, const Grid<double>& headings,
                                     const ArrowOptions& options) {
  if (auto fault = fault_of(options)) return Unexpected<Error>(*std::move(fault));
  if (auto fault = fault_of(map, headings, "headings")) return Unexpected<Error>(*std::move(fault));
  DirectionMap directions = directions_of(map);
  for (const Cell cell : every_cell(headings)) {
    if (std::isnan(headings[cell])) continue;
    const double heading = normalized_angle(headings[cell] - map.frame().origin.heading);
    directions.add(cell, {.arrows = {{heading, options.tolerance, options.factor}}});
  }
  return with(map, std::move(directions));
}

Expected<GridMap, Error> with_heights(const GridMap& map, const Grid<double>& heights,
                                      const SlopeOptions& options) {
  if (auto fault = fault_of(options)) return Unexpected<Error>(*std::move(fault));
  if (auto fault = fault_of(map, heights, "heights")) return Unexpected<Error>(*std::move(fault));
  DirectionMap directions = directions_of(map);
  const double cell_size = map.frame().resolution;
  for (const Cell cell : every_cell(heights)) {
    const auto [x, y] = cell;
    const double rise_x = rise_between(heights, {x - 1, y}, cell, {x + 1, y}) / cell_size;
    const double rise_y = rise_between(heights, {x, y - 1}, cell, {x, y + 1}) / cell_size;
    if (rise_x == 0 && rise_y == 0) continue;
    directions.add(cell, {.slopes = {{rise_x, rise_y, options.climb, options.descend}}});
  }
  return with(map, std::move(directions));
}

DirectionRule placed(const DirectionRule& rule, const RulePlacement& placement) {
  const double side = placement.mirrored ? -1 : 1;
  const auto [sine, cosine] = sine_and_cosine(placement.turn);
  DirectionRule there = rule;
  for (Arrow& arrow : there.arrows) {
    arrow.heading = normalized_angle(side * arrow.heading + placement.turn);
  }
  for (Slope& slope : there.slopes) {
    const double x = placement.stretch * slope.rise_x;
    const double y = side * placement.stretch * slope.rise_y;
    slope.rise_x = cosine * x - sine * y;
    slope.rise_y = sine * x + cosine * y;
  }
  return there;
}

}  // namespace wend
