#include "wend/space/lattice/car_lattice.hpp"

#include <algorithm>
#include <cassert>
#include <numbers>

#include "wend/geometry/arc.hpp"
#include "wend/map/grid_within.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/sweep.hpp"
#include "wend/robot/sweep/swept_clearance.hpp"

namespace wend {
namespace {

using Steps = std::array<CarStep, std::size_t{kHeadings} * kCarMoves>;

// Bits 0 to 3 are the arcs of a cell, indexed by the corner that is their centre.
constexpr unsigned kLineAlongX = 4;
constexpr unsigned kLineAlongY = 5;

// In units. No obstacle is nearer to a move between corners that blocked cells do not touch: a cell can
// lie at the corner of the square that an arc bulges towards, sqrt(2) from its centre. (The map's edge
// is nearest to one of a move's ends.)
constexpr double kNearestObstacle = std::numbers::sqrt2 - 1;

bool may_touch_obstacles(const FreeSpace& space, int unit) {
  return space.radius_in_cells() > kNearestObstacle * unit;
}

/// The map's edge cuts cells if the unit does not divide the map's size.
int cells_along(int length, int unit) { return (length + unit - 1) / unit; }
int corners_along(int length, int unit) { return length / unit + 1; }

/// What an arc sweeps.
void complete_turn(CarStep& step, Heading heading) {
  step.swept = {std::min(0, step.by.x), std::min(0, step.by.y)};
  // The centre lies beside the car: where the arc does not lead along its heading.
  const Cell along = ahead(heading);
  const Cell side{along.x != 0 ? 0 : step.by.x, along.y != 0 ? 0 : step.by.y};
  step.arc_bit = (side.x > step.swept.x ? 1U : 0U) + (side.y > step.swept.y ? 2U : 0U);
  step.arc_owner = step.swept;
}

/// What lies beside a line.
void complete_straight(CarStep& step) {
  const Cell lower{std::min(0, step.by.x), std::min(0, step.by.y)};
  const bool along_x = step.by.x != 0;
  step.beside = lower;
  step.other_beside = {lower.x - (along_x ? 0 : 1), lower.y - (along_x ? 1 : 0)};
  step.arc_bit = along_x ? kLineAlongX : kLineAlongY;
  step.arc_owner = lower;
}

Steps all_steps() {
  Steps steps;
  for (const MotionPrimitive& primitive : car_primitives().all()) {
    const auto move = static_cast<CarMove>(primitive.number);
    const auto heading = static_cast<Heading>(primitive.from);
    CarStep& step = steps[static_cast<std::size_t>(primitive.from) * kCarMoves +
                          static_cast<std::size_t>(primitive.number)];
    step = {.by = primitive.by,
            .to = static_cast<Heading>(primitive.to),
            .turns = is_turn(move),
            .reverses = is_reverse(move),
            .undone_by = inverse(move)};
    if (step.turns) {
      complete_turn(step, heading);
    } else {
      complete_straight(step);
    }
  }
  return steps;
}

BitGrid blocked_cells(const FreeSpace& space, int unit, DeadlineCheck& stop) {
  if (unit == 1) return space.obstacles().blocked();
  BitGrid blocked(cells_along(space.width(), unit), cells_along(space.height(), unit));
  for (const Cell cell : every_cell(space)) {
    if (stop()) break;
    if (space.obstacles().blocked()[cell]) blocked.set({cell.x / unit, cell.y / unit}, true);
  }
  return blocked;
}

/// The mean over the map cells of each lattice cell; empty if it is 1 everywhere.
Grid<double> mean_terrain(const FreeSpace& space, int unit, DeadlineCheck& stop) {
  if (space.uniform_terrain()) return {};
  auto mean = grid_within<double>(cells_along(space.width(), unit),
                                  cells_along(space.height(), unit), 0, stop);
  for (const Cell cell : every_cell(space)) {
    if (stop()) break;
    mean[{cell.x / unit, cell.y / unit}] += space.terrain(cell);
  }
  for (const Cell cell : every_cell(mean)) {
    if (stop()) break;
    const int width = std::min(unit, space.width() - cell.x * unit);
    const int height = std::min(unit, space.height() - cell.y * unit);
    mean[cell] /= static_cast<double>(width) * height;
  }
  return mean;
}

Pose corner_point(Cell corner, int unit, double heading = 0) {
  return {static_cast<double>(unit) * corner.x, static_cast<double>(unit) * corner.y, heading};
}

/// The corners that no blocked cell touches and where the robot's disc fits.
BitGrid passable_corners(const FreeSpace& space, const BitGrid& blocked, int unit,
                         DeadlineCheck& stop) {
  BitGrid passable(corners_along(space.width(), unit), corners_along(space.height(), unit));
  for (const Cell corner : every_cell(passable)) {
    if (stop()) break;
    const auto [x, y] = corner;
    if (blocked[{x - 1, y - 1}] || blocked[{x, y - 1}] || blocked[{x - 1, y}] || blocked[corner]) {
      continue;
    }
    const bool fits =
        space.radius_in_cells() == 0 || disc_fits_along(space, {corner_point(corner, unit), 0, 0});
    passable.set(corner, fits);
  }
  return passable;
}

/// Sweeps the disc along every arc and line of the lattice. Returns which of them fit, by their owner.
Grid<std::uint8_t> fitting_moves(const FreeSpace& space, const BitGrid& passable,
                                 const Steps& steps, int unit, DeadlineCheck& stop) {
  Grid<std::uint8_t> fitting(passable.width(), passable.height(), 0);
  const auto sweep = [&](Cell corner, Heading heading, const CarStep& step) {
    const Cell to{corner.x + step.by.x, corner.y + step.by.y};
    if (!passable.contains(to) || !passable[to]) return;
    std::uint8_t& bits = fitting[{corner.x + step.arc_owner.x, corner.y + step.arc_owner.y}];
    if (((bits >> step.arc_bit) & 1U) != 0) return;  // seen from its other end
    const Pose from = corner_point(corner, unit, radians_of(heading));
    if (!disc_fits_along(space, arc_to(from, corner_point(to, unit).point()))) return;
    bits = static_cast<std::uint8_t>(bits | 1U << step.arc_bit);
  };
  for (const Cell corner : every_cell(passable)) {
    if (stop()) break;
    if (!passable[corner]) continue;
    for (const Heading heading : kAllHeadings) {
      for (const CarMove move : {CarMove::fwd, CarMove::fwd_plus, CarMove::fwd_minus}) {
        const auto number = static_cast<std::size_t>(heading) * kCarMoves;
        sweep(corner, heading, steps[number + static_cast<std::size_t>(move)]);
      }
    }
  }
  return fitting;
}

}  // namespace

bool has_room_for(const GridMap& map, const CarDriving& driving) {
  return driving.unit <= std::min(map.width(), map.height());
}

std::string why_no_lattice(const GridMap& map, const CarDriving& driving) {
  const std::string size =
      std::to_string(map.width()) + " x " + std::to_string(map.height()) + " cells";
  if (!has_room_for(map, driving)) {
    return "the map of " + size + " is too small for a lattice_resolution of " +
           std::to_string(driving.unit);
  }
  const auto corners = [&](int length) {
    return static_cast<std::uint64_t>(length) / static_cast<std::uint64_t>(driving.unit) + 1;
  };
  if (corners(map.width()) * corners(map.height()) * kHeadings >= UINT32_MAX) {
    return "the map of " + size +
           " has too many lattice vertices for the car planner: choose a larger lattice_resolution";
  }
  return {};
}

CarLattice::CarLattice(FreeSpace space, const CarDriving& driving, DeadlineCheck& stop) {
  assert(has_room_for(space.map(), driving));
  const auto unit = static_cast<int>(driving.unit);
  const Steps steps = all_steps();
  BitGrid blocked = blocked_cells(space, unit, stop);
  BitGrid passable = passable_corners(space, blocked, unit, stop);
  if (stop.has_passed()) return;
  ConnectedComponents components(passable, stop);
  Grid<double> terrain = mean_terrain(space, unit, stop);
  if (stop.has_passed()) return;
  Grid<std::uint8_t> fitting;
  if (may_touch_obstacles(space, unit)) {
    fitting = fitting_moves(space, passable, steps, unit, stop);
  }
  if (stop.has_passed()) return;
  data_ = std::make_shared<const Data>(Data{std::move(space), driving, steps, std::move(blocked),
                                            std::move(passable), std::move(components),
                                            std::move(terrain), std::move(fitting)});
}

std::optional<CornerFault> CarLattice::why_blocked(Cell corner) const {
  if (!data_->passable.contains(corner)) return CornerFault{BlockReason::outside};
  if (data_->passable[corner]) return std::nullopt;
  const FreeSpace& space = data_->space;
  for (int y = (corner.y - 1) * unit(); y < (corner.y + 1) * unit(); ++y) {
    for (int x = (corner.x - 1) * unit(); x < (corner.x + 1) * unit(); ++x) {
      const Cell cell{x, y};
      if (!space.contains(cell) || !space.obstacles().blocked()[cell]) continue;
      const bool unknown = space.map().state(cell) == CellState::unknown;
      return CornerFault{unknown ? BlockReason::unknown : BlockReason::obstacle, cell};
    }
  }
  const Arc here{corner_point(corner, unit()), 0, 0};
  const double clearance = arc_clearance(space, here);
  const bool edge_is_nearest = edge_clearance(space, here) <= clearance;
  return CornerFault{edge_is_nearest ? BlockReason::over_edge : BlockReason::too_close,
                     std::nullopt, clearance};
}

double CarLattice::ground(const CornerPose& from, CarMove move) const {
  const CarStep& way = step(from.heading, move);
  if (terrain().empty()) return 1;
  if (way.turns) return terrain_at(from.vertex, way.swept);
  if (driving().straight_terrain == StraightTerrain::none) return 1;
  const auto multiplier = [&](Cell offset, Cell instead) {
    const Cell cell{from.vertex.x + offset.x, from.vertex.y + offset.y};
    return terrain_at(from.vertex, terrain().contains(cell) ? offset : instead);
  };
  const double a = multiplier(way.beside, way.other_beside);
  const double b = multiplier(way.other_beside, way.beside);
  return driving().straight_terrain == StraightTerrain::max ? std::max(a, b) : (a + b) / 2;
}

Pose CarLattice::to_grid(const CornerPose& place) const {
  return corner_point(place.vertex, unit(), radians_of(place.heading));
}

std::optional<CornerPose> CarLattice::nearest(const Pose& pose) const {
  auto place = nearest_corner_pose(pose, unit());
  if (place) place->vertex = {place->vertex.x / unit(), place->vertex.y / unit()};
  return place;
}

std::optional<CornerPose> CarLattice::place_on(const Pose& pose) const {
  constexpr double kRounding = 1e-9;  // cells
  const auto on_map = [](double at, int length) {
    return at >= -kRounding && at <= length + kRounding;
  };
  const FreeSpace& space = data_->space;
  if (!on_map(pose.x, space.width()) || !on_map(pose.y, space.height())) return std::nullopt;
  auto place = nearest(pose);
  if (place) {
    place->vertex.x = std::min(place->vertex.x, columns() - 1);
    place->vertex.y = std::min(place->vertex.y, rows() - 1);
  }
  return place;
}

std::optional<CarMove> move_between(const CornerPose& from, const CornerPose& to) {
  for (int number = 0; number < kCarMoves; ++number) {
    const auto move = static_cast<CarMove>(number);
    if (moved(from, move) == to) return move;
  }
  return std::nullopt;
}

double car_path_cost(const CarLattice& lattice, std::span<const CornerPose> poses) {
  double turns = 0;  // sums of ground
  double straight = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto move = move_between(poses[i - 1], poses[i]);
    if (!move) continue;
    const CarStep& way = lattice.step(poses[i - 1].heading, *move);
    const double factor = way.reverses ? lattice.driving().reverse_factor : 1;
    (way.turns ? turns : straight) += factor * lattice.ground(poses[i - 1], *move);
  }
  return straight * length_of(CarMove::fwd) + turns * length_of(CarMove::fwd_plus);
}

}  // namespace wend
