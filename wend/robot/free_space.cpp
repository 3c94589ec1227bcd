#include "wend/robot/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "wend/base/choice.hpp"
#include "wend/base/parse.hpp"
#include "wend/map/distance_field.hpp"
#include "wend/robot/fits_along.hpp"
#include "wend/robot/point_sweep.hpp"
#include "wend/robot/polygon_sweep.hpp"
#include "wend/robot/sweep.hpp"

namespace wend {
namespace {

// Metres divided by a resolution are rarely exact.
constexpr double kRelativeRounding = 1e-9;

/// The least squared distance in half-cells, rounded up, that is at least `least`.
std::uint32_t threshold_of(double least) { return static_cast<std::uint32_t>(std::ceil(least)); }

/// The cells whose clearance is large enough. Every cell that is not blocked has a clearance of 1.
BitGrid cells_with_clearance(const Obstacles& obstacles, const CappedDistances& distances,
                             double least) {
  const std::uint32_t threshold = threshold_of(least);
  if (threshold <= 1) return obstacles.blocked().complement();
  BitGrid cells(obstacles.map().width(), obstacles.map().height());
  if (!distances.empty()) {
    distances.select(threshold, CellBox::of(cells), cells);
    return cells;
  }
  const auto& clearance = obstacles.squared_half_cell_clearance();
  for (int y = 0; y < clearance.height(); ++y) {
    set_row(cells.row_words(y), clearance.row(y),
            [threshold](std::uint32_t here) { return here >= threshold; });
  }
  return cells;
}

/// The robot's radius as a squared distance in half-cells. A point must still not be in a square, and
/// the largest robot may stand where there is no obstacle.
double least_squared_half_cells(double radius_in_cells) {
  const double exact = 4 * radius_in_cells * radius_in_cells;
  return std::clamp<double>(exact * (1 - kRelativeRounding), std::numeric_limits<double>::min(),
                            kNoObstacle);
}

/// The factor on a cell's cost because of the obstacles near it.
class ClearanceCost {
 public:
  ClearanceCost(const Robot& robot, double resolution)
      : radius_(robot.footprint.circumscribed_radius() / resolution),
        distance_(robot.clearance_distance / resolution),
        cost_(robot.clearance_cost) {}

  bool needed() const { return distance_ > 0 && cost_ > 0; }

  double factor(std::uint32_t clearance) const {
    const double from_edge = std::fmax(0, distance_in_cells(clearance) - radius_);
    if (from_edge >= distance_) return 1;
    const double inwards = 1 - from_edge / distance_;
    return 1 + cost_ * inwards * inwards;
  }

 private:
  double radius_;    // cells
  double distance_;  // cells
  double cost_;
};

/// The distances to obstacles as far as the robot's radius and its clearance cost need them, and a bit
/// farther, so that they decide about most lines. None for a robot that needs none. None either for one
/// that needs more than there are: it uses those of the Obstacles.
CappedDistances distances_for(const Obstacles& obstacles, const Robot& robot) {
  constexpr double kBeyond = 2;  // cells
  const double resolution = obstacles.map().frame().resolution;
  const double radius = robot.footprint.circumscribed_radius() / resolution;
  const bool costs = ClearanceCost(robot, resolution).needed();
  if (!costs && threshold_of(least_squared_half_cells(radius)) <= 1) return {};
  const double band = costs ? robot.clearance_distance / resolution : 0;
  const double cap = std::ceil(radius + std::max(band, kBeyond));
  if (cap > CappedDistances::kLargestCap) return {};
  return {obstacles.blocked(), obstacles.outside() == OutsidePolicy::blocked,
          static_cast<int>(cap)};
}

/// The map's terrain times the clearance cost; empty if that is the map's terrain.
Grid<double> terrain_away_from_obstacles(const Obstacles& obstacles,
                                         const CappedDistances& distances, const BitGrid& passable,
                                         const ClearanceCost& cost) {
  const GridMap& map = obstacles.map();
  Grid<double> terrain;
  if (!cost.needed()) return terrain;
  const auto clearance = [&](Cell cell) {
    return distances.empty() ? obstacles.squared_half_cell_clearance()[cell] : distances[cell];
  };
  for (const Cell cell : every_cell(map)) {
    const double factor = passable[cell] ? cost.factor(clearance(cell)) : 1;
    if (factor == 1) continue;
    if (terrain.empty()) {
      terrain = map.uniform_terrain() ? Grid<double>(map.width(), map.height(), 1) : map.terrain();
    }
    terrain[cell] *= factor;
  }
  return terrain;
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
  constexpr double kClearance = sizeof(std::int16_t);
  // A quarter of a byte, and 2 bytes for each run of cells: one in 8 cells, which is much.
  constexpr double kComponents = 0.5;
  const bool own_terrain = ClearanceCost(options.robot(), map.frame().resolution).needed();
  return bits + kClearance + kComponents + (own_terrain ? sizeof(double) : 0);
}

Expected<FreeSpace, Error> make_free_space(GridMap map, const FreeSpaceOptions& options) {
  Robot robot = options.robot();
  if (auto fault = fault_of(robot)) return Unexpected<Error>(*std::move(fault));  // before O(cells)
  return make_free_space(Obstacles(std::move(map), options.obstacles()), std::move(robot));
}

Expected<FreeSpace, Error> make_free_space(Obstacles obstacles, Robot robot) {
  if (auto fault = fault_of(robot)) return Unexpected<Error>(*std::move(fault));
  return FreeSpace(std::move(obstacles), std::move(robot));
}

FreeSpace::FreeSpace(Obstacles obstacles, Robot robot) {
  const Footprint& footprint = robot.footprint;
  const double resolution = obstacles.map().frame().resolution;
  CappedDistances distances = distances_for(obstacles, robot);
  const double least = least_squared_half_cells(footprint.circumscribed_radius() / resolution);
  BitGrid passable = cells_with_clearance(obstacles, distances, least);
  BitGrid possible;
  std::optional<Polygon> outline;
  if (footprint.outline()) {
    outline = footprint.outline()->scaled(1 / resolution);
    possible = cells_with_clearance(
        obstacles, distances, least_squared_half_cells(footprint.inscribed_radius() / resolution));
  }
  Grid<double> terrain =
      terrain_away_from_obstacles(obstacles, distances, passable, ClearanceCost(robot, resolution));
  data_ = std::make_shared<const Data>(
      Data{std::move(obstacles), std::move(robot), std::move(outline), least, std::move(passable),
           std::move(possible), std::move(distances), std::move(terrain)});
}

FreeSpaceOptions FreeSpace::options() const {
  return {.footprint = footprint(),
          .unknown = obstacles().unknown(),
          .outside = outside(),
          .clearance_distance = robot().clearance_distance,
          .clearance_cost = robot().clearance_cost};
}

double FreeSpace::clearance(Cell cell, double most) const {
  const double squared = std::ceil(4 * most * most);
  return distance_in_cells(squared_half_cell_clearance(
      cell, squared < kNoObstacle ? static_cast<std::uint32_t>(squared) : kNoObstacle));
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
