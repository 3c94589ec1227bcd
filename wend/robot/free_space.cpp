#include "wend/robot/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "wend/base/choice.hpp"
#include "wend/base/parse.hpp"
#include "wend/robot/cell_costs.hpp"
#include "wend/robot/fits_along.hpp"
#include "wend/robot/point_sweep.hpp"
#include "wend/robot/polygon_sweep.hpp"
#include "wend/robot/sweep.hpp"

namespace wend {
namespace {

/// The cells whose clearance is large enough.
BitGrid cells_with_clearance(const Grid<std::uint32_t>& clearance, double least) {
  BitGrid passable(clearance.width(), clearance.height());
  const auto threshold = static_cast<std::uint32_t>(std::ceil(least));
  for (int y = 0; y < clearance.height(); ++y) {
    set_row(passable.row_words(y), clearance.row(y),
            [threshold](std::uint32_t here) { return here >= threshold; });
  }
  return passable;
}

std::optional<Error> fault_of(const Robot& robot) {
  const auto wrong = [](const std::string& name, double value) {
    return Error{
        Status::invalid_option,
        "the robot's " + name + " is " + format_number(value) + ": a finite number from 0 expected",
        name};
  };
  const auto valid = [](double value) { return value >= 0 && std::isfinite(value); };
  if (!robot.footprint.valid()) return wrong("radius", robot.footprint.circumscribed_radius());
  if (!valid(robot.clearance_distance)) {
    return wrong("clearance_distance", robot.clearance_distance);
  }
  if (!valid(robot.clearance_cost)) return wrong("clearance_cost", robot.clearance_cost);
  return std::nullopt;
}

}  // namespace

std::string_view describe(BlockReason reason) {
  constexpr std::array<Choice<BlockReason>, 7> kTexts{
      {{"outside the map", BlockReason::outside},
       {"an obstacle", BlockReason::obstacle},
       {"unknown", BlockReason::unknown},
       {"closer to an obstacle than the robot's radius", BlockReason::too_close},
       {"too close to the map's edge for the robot's radius", BlockReason::over_edge},
       {"where the robot's footprint overlaps an obstacle", BlockReason::overlaps},
       {"where the robot's footprint reaches over the map's edge", BlockReason::leaves}}};
  return choice_name(reason, kTexts);
}

double free_space_bytes_per_cell(const GridMap& map, const FreeSpaceOptions& options) {
  const double bits = (options.footprint.outline() ? 3.0 : 2.0) / 8;  // blocked, passable, possible
  constexpr double kClearance = sizeof(std::uint32_t);
  constexpr double kComponents = sizeof(std::uint32_t);
  const bool raised = CellCosts(options.robot(), map.frame().resolution).raise();
  const bool costs = raised || !map.uniform_terrain();
  return bits + kClearance + kComponents + (costs ? sizeof(std::uint16_t) : 0);
}

Expected<FreeSpace, Error> make_free_space(GridMap map, const FreeSpaceOptions& options) {
  Robot robot = options.robot();
  if (auto fault = fault_of(robot)) return Unexpected<Error>(*std::move(fault));  // before O(cells)
  return make_free_space(Obstacles(std::move(map), options.obstacles()), std::move(robot));
}

Expected<FreeSpace, Error> make_free_space(Obstacles obstacles, Robot robot) {
  if (auto fault = fault_of(robot)) return Unexpected<Error>(*std::move(fault));
  auto costs = cell_costs(obstacles, CellCosts(robot, obstacles.map().frame().resolution));
  if (!costs) return Unexpected<Error>(std::move(costs).error());
  return FreeSpace(std::move(obstacles), std::move(robot), *std::move(costs));
}

FreeSpace::FreeSpace(Obstacles obstacles, Robot robot, CostMap costs) {
  const Footprint& footprint = robot.footprint;
  const double resolution = obstacles.map().frame().resolution;
  const auto& clearance = obstacles.squared_half_cell_clearance();
  const double least = least_squared_half_cells(footprint.circumscribed_radius() / resolution);
  BitGrid passable = cells_with_clearance(clearance, least);
  BitGrid possible;
  std::optional<Polygon> outline;
  if (footprint.outline()) {
    outline = footprint.outline()->scaled(1 / resolution);
    possible = cells_with_clearance(
        clearance, least_squared_half_cells(footprint.inscribed_radius() / resolution));
  }
  ConnectedComponents components(passable);
  data_ = std::make_shared<const Data>(
      Data{std::move(obstacles), std::move(robot), std::move(outline), least, std::move(passable),
           std::move(possible), std::move(components), std::move(costs)});
}

FreeSpaceOptions FreeSpace::options() const {
  return {.footprint = footprint(),
          .unknown = obstacles().unknown(),
          .outside = outside(),
          .clearance_distance = robot().clearance_distance,
          .clearance_cost = robot().clearance_cost};
}

std::optional<BlockReason> FreeSpace::why_blocked(Cell cell) const {
  if (!contains(cell)) return BlockReason::outside;
  if (data_->passable[cell]) return std::nullopt;
  if (!obstacles().blocked()[cell]) {
    return obstacles().edge_is_nearest(cell) ? BlockReason::over_edge : BlockReason::too_close;
  }
  return reason_in(cell);
}

std::optional<BlockReason> FreeSpace::why_blocked(const Pose& pose) const {
  const Point point = pose.point();
  const bool finite = std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
  if (!finite || distance_inside(*this, point) < -kPointTolerance) return BlockReason::outside;
  const Cell cell = nearest_cell(*this, point);
  const bool in_obstacle = obstacles().blocked()[cell];
  if (outline()) {
    const auto reason = PolygonSweep(*this).why_blocked(pose);
    if (reason != BlockReason::overlaps || !in_obstacle) return reason;
  } else if (disc_fits_along(*this, Line{point, point})) {
    return std::nullopt;
  }
  if (in_obstacle) return reason_in(cell);
  const bool over_edge = !keeps_distance(*this, edge_clearance(*this, point));
  return over_edge && !is_point() ? BlockReason::over_edge : BlockReason::too_close;
}

BlockReason FreeSpace::reason_in(Cell blocked) const {
  return map().state(blocked) == CellState::unknown ? BlockReason::unknown : BlockReason::obstacle;
}

std::optional<Cell> cell_under(const FreeSpace& space, Point point) {
  // Written so that it also rejects numbers that are not finite.
  if (!(point.x >= 0 && point.y >= 0 && point.x < space.width() && point.y < space.height())) {
    return std::nullopt;
  }
  return Cell{static_cast<int>(point.x), static_cast<int>(point.y)};
}

}  // namespace wend
