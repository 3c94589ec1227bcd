#include "wend/robot/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "wend/base/choice.hpp"
#include "wend/base/parse.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/robot/cell_costs.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/point_sweep.hpp"
#include "wend/robot/sweep/polygon_sweep.hpp"
#include "wend/robot/sweep/sweep.hpp"

namespace wend {
namespace {

/// The least squared distance in half-cells, rounded up, that is at least `least`.
std::uint32_t threshold_of(double least) { return static_cast<std::uint32_t>(std::ceil(least)); }

double least_squared_half_cells_of(const Robot& robot, const Obstacles& obstacles) {
  return least_squared_half_cells(robot.footprint.circumscribed_radius() /
                                  obstacles.map().frame().resolution);
}

/// The same for cells in which the inner disc fits: around the middle, or, if the base point lies outside the polygon,
/// somewhere.
double least_for_inner_disc(const Robot& robot, const Obstacles& obstacles) {
  constexpr double kToCorner = std::numbers::sqrt2 / 2 + 1e-6;
  const double radius = robot.footprint.inner_disc().radius / obstacles.map().frame().resolution;
  return least_squared_half_cells(
      robot.footprint.covers_base_point() ? radius : std::max(radius - kToCorner, 0.0));
}

/// Sets the bits in a box of the map: of the cells whose clearance is large enough. Every cell that is not
/// blocked has a clearance of 1.
void select_cells(const Obstacles& obstacles, const CappedDistances& distances, double least,
                  const CellBox& box, BitGrid& cells,
                  DeadlineCheck& stop = DeadlineCheck::never()) {
  const std::uint32_t threshold = threshold_of(least);
  if (threshold <= 1) {
    cells.assign_complement(obstacles.blocked(), box);
  } else if (!distances.empty()) {
    distances.select(threshold, box, cells, stop);
  } else if (obstacles.make_clearance(stop)) {
    const auto& clearance = obstacles.squared_half_cell_clearance();
    const auto width = static_cast<std::size_t>(box.width());
    for (int y = box.begin.y; y < box.end.y && !stop.now(); ++y) {
      const auto row = clearance.row(y).subspan(static_cast<std::size_t>(box.begin.x), width);
      assign_row(cells.row_words(y), box.begin.x, row,
                 [threshold](std::uint32_t here) { return here >= threshold; });
    }
  }
}

BitGrid cells_with_clearance(const Obstacles& obstacles, const CappedDistances& distances,
                             double least, DeadlineCheck& stop) {
  BitGrid cells(obstacles.map().width(), obstacles.map().height());
  select_cells(obstacles, distances, least, CellBox::of(cells), cells, stop);
  return cells;
}

/// How far the robot's radius and its clearance cost need distances, and a bit farther, so that they decide
/// about most lines, in cells; 0 if it needs none.
double reach_of(double resolution, const Robot& robot) {
  // A polygon decides about motions of some cells.
  const double beyond = robot.footprint.outline() ? 8 : 2;
  const bool costs = CellCosts(robot, resolution).raise();
  const double radius = robot.footprint.circumscribed_radius() / resolution;
  if (!costs && threshold_of(least_squared_half_cells(radius)) <= 1) return 0;
  const double band = costs ? robot.clearance_distance / resolution : 0;
  return std::ceil(radius + std::max(band, beyond));
}

/// Does the robot need the distances of the Obstacles, because it needs them farther than
/// CappedDistances have them?
bool needs_all_distances(const Obstacles& obstacles, const Robot& robot) {
  return reach_of(obstacles.map().frame().resolution, robot) > CappedDistances::kLargestCap;
}

CappedDistances distances_for(const Obstacles& obstacles, const Robot& robot, DeadlineCheck& stop) {
  const double reach = reach_of(obstacles.map().frame().resolution, robot);
  if (reach == 0 || needs_all_distances(obstacles, robot)) return {};
  return {obstacles.blocked(), obstacles.outside() == OutsidePolicy::blocked,
          static_cast<int>(reach), stop};
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

/// Are the distances there that costs need? They are made unless the deadline passes.
bool can_know_costs(const Obstacles& obstacles, const CappedDistances& distances,
                    const CellCosts& costs, DeadlineCheck& stop) {
  return !costs.raise() || !distances.empty() || obstacles.make_clearance(stop);
}

Unexpected<Error> not_ready(const Deadline& deadline) {
  return failure(
      deadline.status(),
      deadline.text() +
          ", before the free space of the map was ready: it is made once for a map and a "
          "robot; make it without a limit");
}

/// A repair cannot be stopped half-way: that of so many cells takes some 10 ms.
bool takes_long(const MapEdit& edit) {
  constexpr std::size_t kMostCells = std::size_t{1} << 18;
  return edit.states.size() + edit.terrain.size() + edit.cells.size() > kMostCells;
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
  // Blocked, passable, possible; where the base point lies outside, also the cells of the inner disc.
  const double planes = options.footprint.covers_base_point() ? 3.0 : 4.0;
  const double bits = (options.footprint.outline() ? planes : 2.0) / 8;
  const double reach = reach_of(map.frame().resolution, options.robot());
  const bool all_distances = reach > CappedDistances::kLargestCap;
  const double distances = all_distances ? sizeof(std::uint32_t) : sizeof(std::int16_t);
  // A quarter of a byte, and 2 bytes for each run of cells: one in 8 cells, which is much.
  constexpr double kComponents = 0.5;
  const bool raised = CellCosts(options.robot(), map.frame().resolution).raise();
  const bool costs = raised || !map.uniform_terrain();
  return bits + (reach > 0 ? distances : 0) + kComponents + (costs ? sizeof(std::uint16_t) : 0);
}

Expected<FreeSpace, Error> make_free_space(GridMap map, const FreeSpaceOptions& options) {
  Robot robot = options.robot();
  if (auto fault = fault_of(robot)) return Unexpected<Error>(*std::move(fault));  // before O(cells)
  return make_free_space(Obstacles(std::move(map), options.obstacles()), std::move(robot));
}

Expected<FreeSpace, Error> make_free_space(Obstacles obstacles, Robot robot,
                                           const Deadline& deadline) {
  if (auto fault = fault_of(robot)) return Unexpected<Error>(*std::move(fault));
  DeadlineCheck stop(&deadline);
  FreeSpace space(std::move(obstacles), std::move(robot), stop);
  if (stop.has_passed()) return not_ready(deadline);
  FreeSpace::Data& data = space.data_.change();
  if (!can_know_costs(data.obstacles, data.distances, *data.cell_costs, stop))
    return not_ready(deadline);
  auto costs = cell_costs(data.obstacles, data.distances, *data.cell_costs, stop);
  if (stop.has_passed()) return not_ready(deadline);
  if (!costs) return Unexpected<Error>(std::move(costs).error());
  data.costs = *std::move(costs);
  return space;
}

bool FreeSpace::make_components(Adjacency adjacency, const Deadline& deadline) const {
  DeadlineCheck stop(&deadline);
  const ConnectedComponents* const made =
      data_->components.try_get([&]() -> std::optional<ConnectedComponents> {
        std::optional<ConnectedComponents> components(std::in_place, passable(), stop);
        if (stop.has_passed()) components.reset();
        return components;
      });
  return made != nullptr && made->prepare(adjacency, stop);
}

FreeSpace::Data::Data(Obstacles its_obstacles, Robot its_robot, DeadlineCheck& stop)
    : obstacles(std::move(its_obstacles)),
      robot(std::move(its_robot)),
      least_squared_half_cells(least_squared_half_cells_of(robot, obstacles)),
      cell_costs(std::make_shared<const CellCosts>(robot, obstacles.map().frame().resolution)),
      distances(distances_for(obstacles, robot, stop)),
      passable(cells_with_clearance(obstacles, distances, least_squared_half_cells, stop)) {
  if (stop.has_passed()) return;
  const double resolution = obstacles.map().frame().resolution;
  if (robot.footprint.outline()) {
    outline = robot.footprint.outline()->scaled(1 / resolution);
    possible = BitGrid(passable.width(), passable.height());
    if (!robot.footprint.covers_base_point()) {
      const Point centre = robot.footprint.inner_disc().centre;
      ring.emplace(hypotenuse(centre.x, centre.y) / resolution, BasePlace::middle);
      inner_disc_cells = possible;
    }
    select_possible(CellBox::of(passable), stop);
  }
}

/// Finds the possible cells after a change in a box.
void FreeSpace::Data::select_possible(const CellBox& box, DeadlineCheck& stop) {
  const double least = least_for_inner_disc(robot, obstacles);
  if (!ring) {
    select_cells(obstacles, distances, least, box, possible, stop);
    return;
  }
  select_cells(obstacles, distances, least, box, inner_disc_cells, stop);
  if (stop.has_passed()) return;
  const CellBox reached = box.grown_by(ring->reach()).clipped_to(possible);
  constexpr int kRowsAtOnce = 64;
  for (int y = reached.begin.y; y < reached.end.y && !stop.now(); y += kRowsAtOnce) {
    const CellBox band{{reached.begin.x, y},
                       {reached.end.x, std::min(y + kRowsAtOnce, reached.end.y)}};
    ring->spread(inner_disc_cells, obstacles.outside() == OutsidePolicy::free, band, possible);
  }
}

CellBox FreeSpace::Data::repair(const CellBox& edited) {
  CellBox changed = edited;
  if (!distances.empty()) {
    changed = changed.joined_with(distances.repair(obstacles.blocked(), edited));
  }
  select_cells(obstacles, distances, least_squared_half_cells, changed, passable);
  if (outline) select_possible(changed);
  return ring ? changed.grown_by(ring->reach()).clipped_to(possible) : changed;
}

/// Can costs and distances be repaired? Else the space is made anew, which fails if a cell costs too much.
bool FreeSpace::can_repair(const MapEdit& edit) const {
  return !needs_all_distances(obstacles(), robot()) && costs().bytes_per_cell() <= 2 &&
         data_->cell_costs->stay_in_range(greatest_terrain(edit));
}

/// As if the map had been so: nothing is repaired.
Expected<SpaceChange, Error> FreeSpace::make_edited(const MapEdit& edit, const Deadline& deadline) {
  GridMap edited = map();
  edited.edit(edit);
  auto made =
      make_free_space(Obstacles(std::move(edited), options().obstacles()), robot(), deadline);
  if (!made) return Unexpected<Error>(std::move(made.error()));
  *this = *std::move(made);
  SpaceChange change;
  change.boxes = {CellBox::of(map())};
  return change;
}

Expected<SpaceChange, Error> FreeSpace::edit(const MapEdit& edit, const Deadline& deadline) {
  if (auto fault = fault_of(edit, map())) return Unexpected<Error>(*std::move(fault));
  SpaceChange change;
  if (deadline.bounded() && takes_long(edit)) return make_edited(edit, deadline);
  if (!can_repair(edit)) {
    Obstacles edited = obstacles();
    change.boxes = *edited.edit(edit);
    if (change.none()) {
      data_.change().obstacles = std::move(edited);  // whose map may know more
      return change;
    }
    auto made = make_free_space(std::move(edited), robot(), deadline);
    if (!made) return Unexpected<Error>(std::move(made.error()));
    *this = *std::move(made);
    change.boxes = {CellBox::of(map())};
    return change;
  }
  Data& data = data_.change();
  change.boxes = *data.obstacles.edit(edit);
  for (CellBox& box : change.boxes) {
    box = data.repair(box);
    set_cell_costs(data.obstacles, data.distances, *data.cell_costs, box, data.costs);
  }
  if (ConnectedComponents* components = data.components.changeable()) {
    for (const CellBox& box : change.boxes) components->repair(data.passable, box);
  }
  if (!change.none()) data.attachments.space_edited(change);
  return change;
}

FreeSpaceOptions FreeSpace::options() const {
  return {.footprint = footprint(),
          .unknown = obstacles().unknown(),
          .outside = outside(),
          .clearance_distance = robot().clearance_distance,
          .clearance_cost = robot().clearance_cost,
          .primitives = robot().primitives};
}

BitGrid FreeSpace::cells_clear_by(double least) const {
  return cells_with_clearance(data_->obstacles, data_->distances,
                              std::min<double>(least, kNoObstacle), DeadlineCheck::never());
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
    const bool base_decides = in_obstacle && footprint().covers_base_point();
    if (reason != BlockReason::overlaps || !base_decides) return reason;
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
