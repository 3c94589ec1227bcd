#include "wend/cover/coverage_ends.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/robot/near_map.hpp"
#include "wend/robot/sweep/fits_along.hpp"

namespace wend {
namespace {

constexpr double kLeastTool = 2;       // cells
constexpr double kGreatestTool = 500;  // cells
constexpr double kMostLength = 1e6;    // cells, of a turn cost

Error invalid(std::string what, std::string option) {
  return {Status::invalid_option, std::move(what), std::move(option)};
}

bool within(double value, double least, double greatest) {
  return value >= least && value <= greatest;
}

std::optional<Error> size_fault(const std::optional<BitGrid>& cells, const FreeSpace& space,
                                std::string_view name) {
  if (!cells || (cells->width() == space.width() && cells->height() == space.height()))
    return std::nullopt;
  return invalid(std::string(name) + ": " + std::to_string(cells->width()) + " x " +
                     std::to_string(cells->height()) + " cells, but the map has " +
                     std::to_string(space.width()) + " x " + std::to_string(space.height()),
                 std::string(name));
}

/// An end of the path, as a cell of which the robot may stand in the middle.
Expected<Cell, Error> cell_of(Point point, const FreeSpace& space, bool start) {
  const std::string name = start ? "start" : "end";
  if (!near_map(space, point) || !space.contains(cell_at(point))) {
    return failure(start ? Status::start_outside : Status::goal_outside,
                   "the " + name + " lies outside the map", name);
  }
  const Cell cell = cell_at(point);
  if (const auto reason = space.why_blocked(cell)) {
    return failure(start ? Status::start_blocked : Status::goal_blocked,
                   "the robot cannot stand at the " + name + ": " + std::string(describe(*reason)),
                   name);
  }
  return cell;
}

std::optional<Cell> cell_of_largest_component(const FreeSpace& space) {
  std::optional<Cell> largest;
  std::size_t most = 0;
  for (const Cell cell : every_cell(space.passable())) {
    if (!space.passable(cell)) continue;
    const std::size_t size = space.components().size_of_component(cell, Adjacency::edges);
    if (size <= most) continue;
    most = size;
    largest = cell;
  }
  return largest;
}

}  // namespace

std::optional<Error> fault_of(const CoverageOptions& options, const FreeSpace& space) {
  const double resolution = space.map().frame().resolution;
  const double tool = options.tool_width / resolution;
  if (!within(tool, kLeastTool, kGreatestTool)) {
    return invalid("tool_width: a number from " + format_number(kLeastTool * resolution) + " to " +
                       format_number(kGreatestTool * resolution) + " expected (2 to 500 cells)",
                   "tool_width");
  }
  if (!(options.overlap >= 0 && options.overlap < options.tool_width)) {
    return invalid("overlap: a number from 0 to below the tool's width expected", "overlap");
  }
  if (!(options.share > 0 && options.share <= 1)) {
    return invalid("share: a number above 0, at most 1, expected", "share");
  }
  if (options.angle && !within(*options.angle, -kLargestHeading, kLargestHeading)) {
    return invalid("angle: a number from -1e6 to 1e6 expected", "angle");
  }
  if (options.turn_cost && !within(*options.turn_cost / resolution, 0, kMostLength)) {
    return invalid("turn_cost: a number from 0 to 1e6 cells expected", "turn_cost");
  }
  if (auto fault = size_fault(options.area, space, "area")) return fault;
  return size_fault(options.covered, space, "covered");
}

std::optional<Point> standing_place(const std::optional<Point>& point, const FreeSpace& space) {
  if (!point || disc_fits_along(space, Line{*point, *point})) return point;
  return centre_of(cell_at(*point));
}

Expected<Cell, Error> first_cell(const CoverageOptions& options, const FreeSpace& space) {
  std::optional<Cell> from;
  for (const bool start : {true, false}) {
    const std::optional<Point>& point = start ? options.start : options.end;
    if (!point) continue;
    const auto cell = cell_of(*point, space, start);
    if (!cell) return cell;
    if (from && !space.components().connected(*from, *cell, Adjacency::edges)) {
      return failure(Status::unreachable, "no path joins the start and the end", "end");
    }
    from = *cell;
  }
  if (!from) from = cell_of_largest_component(space);
  if (!from) return failure(Status::unreachable, "the robot fits nowhere on the map");
  return *from;
}

}  // namespace wend
