#include "wend_ros/sensed_map.hpp"

#include <cassert>
#include <string>
#include <utility>
#include <vector>

#include "wend/explore/visible_cells.hpp"

namespace wend_ros {
namespace {

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
    : truth_(std::move(truth), {.unknown = wend::UnknownPolicy::free}), known_(std::move(known)) {}

wend::CellBox SensedMap::look(wend::MapPoint from, double range) {
  const wend::GridMap& map = truth();
  const wend::Frame& frame = map.frame();
  std::vector<wend::Cell> seen;
  wend::append_visible_cells(truth_, frame.to_grid(from), range / frame.resolution, seen);
  wend::MapEdit edit;
  wend::CellBox changed;
  for (const wend::Cell cell : seen) {
    const wend::CellState state = map.state(cell);
    const double terrain = map.terrain(cell);
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
