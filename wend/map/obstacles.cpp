#include "wend/map/obstacles.hpp"

#include <algorithm>
#include <bit>

#include "wend/map/distance_field.hpp"

namespace wend {
namespace {

/// Sets what is blocked in the words that a box touches. Calls differs(word, i, y) with the bits of word i of a
/// row that are otherwise than before.
template <class Differs>
void block_cells(const GridMap& map, UnknownPolicy unknown, const CellBox& box, BitGrid& blocked,
                 Differs&& differs) {
  const std::size_t first = (static_cast<std::size_t>(box.begin.x) + 1) / 64;
  const std::size_t last = static_cast<std::size_t>(box.end.x) / 64;
  for (int y = box.begin.y; y < box.end.y; ++y) {
    const auto words = blocked.row_words(y);
    const auto occupied_words = map.occupied().row_words(y);
    const auto unknown_words = map.unknown().row_words(y);
    for (std::size_t i = first; i <= last; ++i) {
      std::uint64_t now = occupied_words[i];
      if (unknown == UnknownPolicy::blocked) now |= unknown_words[i];
      if (now != words[i]) differs(now ^ words[i], i, y);
      words[i] = now;
    }
  }
}

bool edits_terrain(const MapEdit& edit) {
  return !edit.terrain.empty() || std::ranges::any_of(edit.cells, [](const CellEdit& each) {
    return each.terrain.has_value();
  });
}

/// The squared distance from a cell's centre to the map's edge, in half-cells.
std::uint32_t squared_half_cells_to_edge(const BitGrid& map, Cell cell) {
  const std::int64_t cells =
      std::min({cell.x, map.width() - 1 - cell.x, cell.y, map.height() - 1 - cell.y});
  return static_cast<std::uint32_t>((2 * cells + 1) * (2 * cells + 1));
}

}  // namespace

OutsidePolicy default_outside_policy(const Frame& frame) {
  return frame.metric ? OutsidePolicy::blocked : OutsidePolicy::free;
}

Obstacles::Data::Data(GridMap its_map, const ObstacleOptions& options)
    : map(std::move(its_map)),
      unknown(options.unknown),
      outside(options.outside.value_or(default_outside_policy(map.frame()))),
      blocked(map.width(), map.height()) {
  block_cells(map, unknown, CellBox::of(map), blocked, [](auto&&...) {});
}

Obstacles::Data::Data(const Data& other)
    : map(other.map),
      unknown(other.unknown),
      outside(other.outside),
      blocked(other.blocked),
      clearance(other.clearance),
      words_read(other.words_read.load(std::memory_order_relaxed)) {}

Obstacles::Obstacles(GridMap map, ObstacleOptions options)
    : data_(std::in_place, std::move(map), options) {}

Expected<std::vector<CellBox>, Error> Obstacles::edit(const MapEdit& edit) {
  if (auto fault = fault_of(edit, map())) return Unexpected<Error>(*std::move(fault));
  Data& data = data_.change();
  auto boxes = data.map.edit(edit);
  std::vector<Cell> changed;
  const auto note = [&](std::uint64_t bits, std::size_t i, int y) {
    for (; bits != 0; bits &= bits - 1) {
      changed.push_back({static_cast<int>(i) * 64 + std::countr_zero(bits) - 1, y});
    }
  };
  for (const CellBox& box : *boxes) {
    block_cells(data.map, data.unknown, box, data.blocked, note);
  }
  if (!changed.empty()) {
    data.clearance.reset();
    data.words_read.store(0, std::memory_order_relaxed);
  }
  if (edits_terrain(edit)) return boxes;
  return boxes_around(std::move(changed));
}

Grid<std::uint32_t> Obstacles::clearance_of_all(DeadlineCheck& stop) const {
  Grid<std::uint32_t> clearance = squared_half_cell_distances(blocked(), stop);
  if (outside() == OutsidePolicy::free) return clearance;
  for (int y = 0; y < clearance.height() && !stop.now(); ++y) {
    for (int x = 0; x < clearance.width(); ++x) {
      std::uint32_t& here = clearance[{x, y}];
      here = std::min(here, squared_half_cells_to_edge(blocked(), {x, y}));
    }
  }
  return clearance;
}

const Grid<std::uint32_t>& Obstacles::squared_half_cell_clearance() const {
  return data_->clearance.get([this] { return clearance_of_all(DeadlineCheck::never()); });
}

bool Obstacles::make_clearance(DeadlineCheck& stop) const {
  return data_->clearance.try_get([&]() -> std::optional<Grid<std::uint32_t>> {
    auto made = clearance_of_all(stop);
    if (stop.has_passed()) return std::nullopt;
    return made;
  }) != nullptr;
}

std::uint32_t Obstacles::squared_half_cell_clearance(Cell cell, std::uint32_t most) const {
  if (!data_->clearance.made()) {
    if (outside() == OutsidePolicy::blocked) {
      most = std::min(most, squared_half_cells_to_edge(blocked(), cell));
    }
    std::size_t words = 0;
    const std::uint32_t found = squared_half_cell_distance(blocked(), cell, most, words);
    data_->words_read.fetch_add(words, std::memory_order_relaxed);
    if (data_->words_read.load(std::memory_order_relaxed) < 2 * map().size()) return found;
  }
  return std::min(squared_half_cell_clearance()[cell], most);
}

double Obstacles::clearance(Cell cell) const {
  return distance_in_cells(squared_half_cell_clearance(cell, kNoObstacle));
}

bool Obstacles::edge_is_nearest(Cell cell) const {
  if (outside() == OutsidePolicy::free) return false;
  const std::uint32_t to_edge = squared_half_cells_to_edge(data_->blocked, cell);
  return squared_half_cell_clearance(cell, to_edge) == to_edge;
}

}  // namespace wend
