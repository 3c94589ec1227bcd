#include "wend_ros/sensed_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "wend/geometry/angle.hpp"

namespace wend_ros {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The border crossings of a ray along one axis.
struct Axis {
  int step;       // to the next cell
  double next;    // the length of the ray up to the next border
  double length;  // of the ray between two borders

  static Axis of(double from, int cell, double direction) {
    if (direction == 0) return {0, kNever, kNever};
    const double border = direction > 0 ? cell + 1.0 : cell;
    return {direction > 0 ? 1 : -1, (border - from) / direction, 1 / std::abs(direction)};
  }
};

/// Appends the cells of a ray, with the first occupied one.
void follow_ray(const wend::GridMap& map, wend::Point from, wend::Cell cell, double angle,
                double range, std::vector<wend::Cell>& seen) {
  Axis x = Axis::of(from.x, cell.x, std::cos(angle));
  Axis y = Axis::of(from.y, cell.y, std::sin(angle));
  while (map.contains(cell)) {
    seen.push_back(cell);
    if (map.state(cell) == wend::CellState::occupied) return;
    Axis& nearer = x.next < y.next ? x : y;
    if (nearer.next > range) return;
    (&nearer == &x ? cell.x : cell.y) += nearer.step;
    nearer.next += nearer.length;
  }
}

/// A map of the same size and frame of which nothing is known.
wend::GridMap unknown_map(const wend::GridMap& map) {
  return *wend::make_grid_map(
      wend::Grid<wend::CellState>(map.width(), map.height(), wend::CellState::unknown),
      map.frame());
}

std::string size_of(const wend::GridMap& map) {
  return std::to_string(map.width()) + " x " + std::to_string(map.height()) + " cells";
}

}  // namespace

std::vector<wend::Cell> seen_cells(const wend::GridMap& map, wend::Point from, double range) {
  std::vector<wend::Cell> seen;
  const bool inside = from.x >= 0 && from.y >= 0 && from.x < map.width() && from.y < map.height();
  if (!inside) return seen;
  const wend::Cell cell{static_cast<int>(from.x), static_cast<int>(from.y)};
  constexpr double kGap = 0.5;  // cells, between the ends of two rays
  const double farthest = std::min(range, std::hypot(map.width(), map.height()));
  const int rays = static_cast<int>(std::ceil(2 * wend::kPi * std::max(farthest, 1.0) / kGap));
  for (int i = 0; i < rays; ++i) {
    follow_ray(map, from, cell, 2 * wend::kPi * i / rays, farthest, seen);
  }
  return seen;
}

wend::Expected<SensedMap, wend::Error> SensedMap::make(wend::GridMap truth,
                                                       std::optional<wend::GridMap> known) {
  if (!known) known = unknown_map(truth);
  if (known->width() != truth.width() || known->height() != truth.height()) {
    return wend::failure(wend::Status::invalid_map, "the known map has " + size_of(*known) +
                                                        ", and the true one " + size_of(truth));
  }
  if (known->frame() != truth.frame()) {
    return wend::failure(wend::Status::invalid_map,
                         "the known map has another origin or resolution than the true one");
  }
  return SensedMap(std::move(truth), *std::move(known));
}

SensedMap::SensedMap(wend::GridMap truth, wend::GridMap known)
    : truth_(std::move(truth)), known_(std::move(known)) {}

wend::CellBox SensedMap::look(wend::MapPoint from, double range) {
  const wend::Frame& frame = truth_.frame();
  wend::MapEdit edit;
  wend::CellBox changed;
  for (const wend::Cell cell : seen_cells(truth_, frame.to_grid(from), range / frame.resolution)) {
    const wend::CellState state = truth_.state(cell);
    const double terrain = truth_.terrain(cell);
    if (known_.state(cell) == state && known_.terrain(cell) == terrain) continue;
    edit.cells.push_back({cell, state, terrain});
    changed = changed.joined_with({cell, {cell.x + 1, cell.y + 1}});
  }
  if (changed.empty()) return changed;
  [[maybe_unused]] const auto edited = known_.edit(edit);
  assert(edited);
  return changed;
}

}  // namespace wend_ros
