#include "wend/robot/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "wend/base/choice.hpp"
#include "wend/map/distance_field.hpp"

namespace wend {
namespace {

// Metres divided by a resolution are rarely exact.
constexpr double kRelativeRounding = 1e-9;

BitGrid obstacles_of(const GridMap& map, UnknownPolicy unknown) {
  BitGrid obstacles = map.occupied();
  if (unknown == UnknownPolicy::free) return obstacles;
  for (int y = 0; y < map.height(); ++y) {
    const auto words = obstacles.row_words(y);
    const auto unknown_words = map.unknown().row_words(y);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] |= unknown_words[i];
  }
  return obstacles;
}

/// From a cell's centre to the map's edge, squared, in half-cells.
std::uint32_t squared_half_cells_to_edge(const BitGrid& map, Cell cell) {
  const std::int64_t cells =
      std::min({cell.x, map.width() - 1 - cell.x, cell.y, map.height() - 1 - cell.y});
  return static_cast<std::uint32_t>((2 * cells + 1) * (2 * cells + 1));
}

/// From the centre of every cell to what is nearest: an obstacle or, if it counts, the map's edge.
Grid<std::uint32_t> clearance_of(const BitGrid& obstacles, OutsidePolicy outside) {
  Grid<std::uint32_t> clearance = squared_half_cell_distances(obstacles);
  if (outside == OutsidePolicy::free) return clearance;
  for (int y = 0; y < clearance.height(); ++y) {
    for (int x = 0; x < clearance.width(); ++x) {
      std::uint32_t& here = clearance[{x, y}];
      here = std::min(here, squared_half_cells_to_edge(obstacles, {x, y}));
    }
  }
  return clearance;
}

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

/// The robot's radius as a squared distance in half-cells; a point must still not be in a square,
/// and the largest robot may stand where there is no obstacle.
double least_squared_half_cells(double radius_in_cells) {
  const double exact = 4 * radius_in_cells * radius_in_cells;
  return std::clamp<double>(exact * (1 - kRelativeRounding), std::numeric_limits<double>::min(),
                            kNoObstacle);
}

/// How many times more a cell costs because of the obstacles near it.
class ClearanceCost {
 public:
  ClearanceCost(const FreeSpaceOptions& options, double resolution)
      : radius_(options.robot_radius / resolution),
        distance_(options.clearance_distance / resolution),
        cost_(options.clearance_cost) {}

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

/// The map's terrain times what keeping away costs; empty if that is the map's terrain.
Grid<double> terrain_away_from_obstacles(const GridMap& map, const BitGrid& passable,
                                         const Grid<std::uint32_t>& clearance,
                                         const ClearanceCost& clearance_distance) {
  Grid<double> terrain;
  if (!clearance_distance.needed()) return terrain;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const Cell cell{x, y};
      const double factor = passable[cell] ? clearance_distance.factor(clearance[cell]) : 1;
      if (factor == 1) continue;
      if (terrain.empty()) {
        terrain =
            map.uniform_terrain() ? Grid<double>(map.width(), map.height(), 1) : map.terrain();
      }
      terrain[cell] *= factor;
    }
  }
  return terrain;
}

}  // namespace

std::string_view describe(BlockReason reason) {
  constexpr std::array<Choice<BlockReason>, 5> kTexts{
      {{"outside the map", BlockReason::outside},
       {"an obstacle", BlockReason::obstacle},
       {"unknown", BlockReason::unknown},
       {"closer to an obstacle than the robot's radius", BlockReason::too_close},
       {"too close to the map's edge for the robot's radius", BlockReason::over_edge}}};
  return choice_name(reason, kTexts);
}

OutsidePolicy default_outside_policy(const Frame& frame) {
  return frame.metric ? OutsidePolicy::blocked : OutsidePolicy::free;
}

double free_space_bytes_per_cell(const GridMap& map, const FreeSpaceOptions& options) {
  constexpr double kBits = 2.0 / 8;  // obstacles, passable cells
  constexpr double kClearance = sizeof(std::uint32_t);
  constexpr double kComponents = sizeof(std::uint32_t);
  const bool own_terrain = ClearanceCost(options, map.frame().resolution).needed();
  return kBits + kClearance + kComponents + (own_terrain ? sizeof(double) : 0);
}

FreeSpace::FreeSpace(GridMap map, FreeSpaceOptions options) {
  assert(options.robot_radius >= 0 && std::isfinite(options.robot_radius));
  assert(options.clearance_distance >= 0 && std::isfinite(options.clearance_distance));
  assert(options.clearance_cost >= 0 && std::isfinite(options.clearance_cost));
  if (!options.outside) options.outside = default_outside_policy(map.frame());
  const double least = least_squared_half_cells(options.robot_radius / map.frame().resolution);
  BitGrid obstacles = obstacles_of(map, options.unknown);
  Grid<std::uint32_t> clearance = clearance_of(obstacles, *options.outside);
  BitGrid passable = cells_with_clearance(clearance, least);
  ConnectedComponents components(passable);
  Grid<double> terrain = terrain_away_from_obstacles(
      map, passable, clearance, ClearanceCost(options, map.frame().resolution));
  data_ = std::make_shared<const Data>(Data{std::move(map), options, least, std::move(obstacles),
                                            std::move(clearance), std::move(passable),
                                            std::move(components), std::move(terrain)});
}

std::optional<BlockReason> FreeSpace::why_blocked(Cell cell) const {
  if (!contains(cell)) return BlockReason::outside;
  if (data_->passable[cell]) return std::nullopt;
  if (!data_->obstacles[cell]) {
    const bool edge_is_nearest =
        outside() == OutsidePolicy::blocked &&
        data_->clearance[cell] == squared_half_cells_to_edge(data_->obstacles, cell);
    return edge_is_nearest ? BlockReason::over_edge : BlockReason::too_close;
  }
  return data_->map.state(cell) == CellState::unknown ? BlockReason::unknown
                                                      : BlockReason::obstacle;
}

double FreeSpace::clearance(Cell cell) const { return distance_in_cells(data_->clearance[cell]); }

}  // namespace wend
