#include "wend/robot/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

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

/// The robot's radius as a squared distance in half-cells. A point must still not be in a square, and
/// the largest robot may stand where there is no obstacle.
double least_squared_half_cells(double radius_in_cells) {
  const double exact = 4 * radius_in_cells * radius_in_cells;
  return std::clamp<double>(exact * (1 - kRelativeRounding), std::numeric_limits<double>::min(),
                            kNoObstacle);
}

double least_squared_half_cells_of(const Robot& robot, const Obstacles& obstacles) {
  return least_squared_half_cells(robot.footprint.circumscribed_radius() /
                                  obstacles.map().frame().resolution);
}

/// The same for cells that are possible.
double least_to_be_possible(const Robot& robot, const Obstacles& obstacles) {
  return least_squared_half_cells(robot.footprint.inscribed_radius() /
                                  obstacles.map().frame().resolution);
}

/// Sets the bits in a box of the map: of the cells whose clearance is large enough. Every cell that is not
/// blocked has a clearance of 1.
void select_cells(const Obstacles& obstacles, const CappedDistances& distances, double least,
                  const CellBox& box, BitGrid& cells) {
  const std::uint32_t threshold = threshold_of(least);
  if (threshold <= 1) {
    cells.assign_complement(obstacles.blocked(), box);
  } else if (!distances.empty()) {
    distances.select(threshold, box, cells);
  } else {
    const auto& clearance = obstacles.squared_half_cell_clearance();
    const auto width = static_cast<std::size_t>(box.width());
    for (int y = box.begin.y; y < box.end.y; ++y) {
      const auto row = clearance.row(y).subspan(static_cast<std::size_t>(box.begin.x), width);
      assign_row(cells.row_words(y), box.begin.x, row,
                 [threshold](std::uint32_t here) { return here >= threshold; });
    }
  }
}

BitGrid cells_with_clearance(const Obstacles& obstacles, const CappedDistances& distances,
                             double least) {
  BitGrid cells(obstacles.map().width(), obstacles.map().height());
  select_cells(obstacles, distances, least, CellBox::of(cells), cells);
  return cells;
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

/// How far the robot's radius and its clearance cost need distances, and a bit farther, so that they decide
/// about most lines, in cells; 0 if it needs none.
double reach_of(const Obstacles& obstacles, const Robot& robot) {
  constexpr double kBeyond = 2;  // cells
  const double resolution = obstacles.map().frame().resolution;
  const bool costs = ClearanceCost(robot, resolution).needed();
  if (!costs && threshold_of(least_squared_half_cells_of(robot, obstacles)) <= 1) return 0;
  const double band = costs ? robot.clearance_distance / resolution : 0;
  return std::ceil(robot.footprint.circumscribed_radius() / resolution + std::max(band, kBeyond));
}

/// Does the robot need the distances of the Obstacles, because it needs them farther than
/// CappedDistances have them?
bool needs_all_distances(const Obstacles& obstacles, const Robot& robot) {
  return reach_of(obstacles, robot) > CappedDistances::kLargestCap;
}

CappedDistances distances_for(const Obstacles& obstacles, const Robot& robot) {
  const double reach = reach_of(obstacles, robot);
  if (reach == 0 || needs_all_distances(obstacles, robot)) return {};
  return {obstacles.blocked(), obstacles.outside() == OutsidePolicy::blocked,
          static_cast<int>(reach)};
}

/// The factor on the terrain of each cell of a space.
class ClearanceFactors {
 public:
  ClearanceFactors(const Obstacles& obstacles, const CappedDistances& distances,
                   const BitGrid& passable, const ClearanceCost& cost)
      : obstacles_(obstacles), distances_(distances), passable_(passable), cost_(cost) {}

  double operator[](Cell cell) const {
    if (!passable_[cell]) return 1;
    return cost_.factor(distances_.empty() ? obstacles_.squared_half_cell_clearance()[cell]
                                           : distances_[cell]);
  }

 private:
  const Obstacles& obstacles_;
  const CappedDistances& distances_;
  const BitGrid& passable_;
  const ClearanceCost& cost_;
};

/// Sets the terrain in a box: the map's times the clearance cost. An empty terrain stays empty if that is the
/// map's in the whole box.
void set_terrain(const GridMap& map, const ClearanceFactors& factors, const CellBox& box,
                 Grid<double>& terrain) {
  for (int y = box.begin.y; y < box.end.y; ++y) {
    for (int x = box.begin.x; x < box.end.x; ++x) {
      const double factor = factors[{x, y}];
      if (terrain.empty()) {
        if (factor == 1) continue;
        terrain =
            map.uniform_terrain() ? Grid<double>(map.width(), map.height(), 1) : map.terrain();
      }
      terrain[{x, y}] = map.terrain({x, y}) * factor;
    }
  }
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

FreeSpace::Data::Data(Obstacles its_obstacles, Robot its_robot)
    : obstacles(std::move(its_obstacles)),
      robot(std::move(its_robot)),
      least_squared_half_cells(least_squared_half_cells_of(robot, obstacles)),
      distances(distances_for(obstacles, robot)),
      passable(cells_with_clearance(obstacles, distances, least_squared_half_cells)) {
  const double resolution = obstacles.map().frame().resolution;
  if (robot.footprint.outline()) {
    outline = robot.footprint.outline()->scaled(1 / resolution);
    possible = cells_with_clearance(obstacles, distances, least_to_be_possible(robot, obstacles));
  }
  repair_terrain({CellBox::of(passable)});
}

void FreeSpace::Data::repair_terrain(const std::vector<CellBox>& boxes) {
  const GridMap& map = obstacles.map();
  const ClearanceCost cost(robot, map.frame().resolution);
  if (!cost.needed()) return;
  const ClearanceFactors factors(obstacles, distances, passable, cost);
  for (const CellBox& box : boxes) set_terrain(map, factors, box, terrain);
  if (terrain.empty()) return;
  bool raised = false;  // mostly one of the first cells is, near the map's edge or an obstacle
  for (const Cell cell : every_cell(map)) {
    if (raised = factors[cell] != 1; raised) break;
  }
  if (!raised) terrain = {};
}

CellBox FreeSpace::Data::repair(const CellBox& edited) {
  CellBox changed = edited;
  if (!distances.empty()) {
    changed = changed.joined_with(distances.repair(obstacles.blocked(), edited));
  }
  select_cells(obstacles, distances, least_squared_half_cells, changed, passable);
  if (outline) {
    select_cells(obstacles, distances, least_to_be_possible(robot, obstacles), changed, possible);
  }
  return changed;
}

Expected<SpaceChange, Error> FreeSpace::edit(const MapEdit& edit) {
  if (auto fault = fault_of(edit, map())) return Unexpected<Error>(*std::move(fault));
  Data& data = data_.change();
  SpaceChange change;
  change.boxes = *data.obstacles.edit(edit);
  if (change.none()) return change;
  if (needs_all_distances(data.obstacles, data.robot)) {
    data_ = CopyOnWrite<Data>(std::in_place, data.obstacles, data.robot);
    change.boxes = {CellBox::of(map())};
    return change;
  }
  for (CellBox& box : change.boxes) box = data.repair(box);
  data.repair_terrain(change.boxes);
  if (ConnectedComponents* components = data.components.changeable()) {
    for (const CellBox& box : change.boxes) components->repair(data.passable, box);
  }
  return change;
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
