#include "wend/generate/kept_cells.hpp"

#include <array>
#include <cstdint>
#include <utility>

#include "wend/geometry/direction.hpp"
#include "wend/map/grid.hpp"

namespace wend {
namespace {

constexpr std::array<Direction, 4> kOverEdges{Direction::plus_x, Direction::plus_y,
                                              Direction::minus_x, Direction::minus_y};

/// Breadth first through cells that are free, then through those behind one that is not, and so on.
class Tunnel {
 public:
  Tunnel(const GridMap& map, Cell from)
      : map_(map), arrivals_(map.width(), map.height(), kNever), now_{{from, kStart}} {}

  /// The cells on the way to `to` that are not free.
  std::vector<Cell> to(Cell to) {
    while (arrivals_[to] == kNever) {
      for (std::size_t i = 0; i < now_.size() && arrivals_[to] == kNever; ++i) reach(now_[i]);
      now_ = std::exchange(next_, {});
    }
    std::vector<Cell> blocked;
    for (Cell cell = to; arrivals_[cell] != kStart;) {
      cell = step(cell, opposite(static_cast<Direction>(arrivals_[cell])));
      if (map_.state(cell) != CellState::free) blocked.push_back(cell);
    }
    return blocked;
  }

 private:
  static constexpr std::uint8_t kNever = 255;
  static constexpr std::uint8_t kStart = 254;

  struct Arrival {
    Cell cell;
    std::uint8_t direction;
  };

  void reach(const Arrival arrival) {
    if (arrivals_[arrival.cell] != kNever) return;
    arrivals_[arrival.cell] = arrival.direction;
    for (const Direction direction : kOverEdges) {
      const Cell beside = step(arrival.cell, direction);
      if (!map_.contains(beside) || arrivals_[beside] != kNever) continue;
      auto& level = map_.state(beside) == CellState::free ? now_ : next_;
      level.push_back({beside, static_cast<std::uint8_t>(direction)});
    }
  }

  const GridMap& map_;
  Grid<std::uint8_t> arrivals_;  // the direction of the last step
  std::vector<Arrival> now_;
  std::vector<Arrival> next_;  // behind one cell more that is not free
};

MapEdit freeing(const std::vector<Cell>& cells) {
  MapEdit edit;
  for (const Cell cell : cells) edit.cells.push_back({cell, CellState::free});
  return edit;
}

}  // namespace

Expected<KeptCells, Error> keep_cells(const GridMap& map, const std::vector<Cell>& cells) {
  KeptCells kept{map};
  const auto freed = kept.map.edit(freeing(cells));
  if (!freed) return Unexpected<Error>(freed.error());
  for (const Cell cell : cells) {
    // All cells before it are joined, so a way to the first one is a way to them all.
    const std::vector<Cell> opened = Tunnel(kept.map, cell).to(cells.front());
    const auto edited = kept.map.edit(freeing(opened));
    if (!edited) return Unexpected<Error>(edited.error());
    kept.opened.insert(kept.opened.end(), opened.begin(), opened.end());
  }
  return kept;
}

}  // namespace wend
