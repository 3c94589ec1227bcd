#pragma once

// Connected components: which cells can reach each other, known before any search.
//
// Without corner cutting (and if one corner may be cut) two cells are connected if they are
// 4-connected; if both corners may be cut, if they are 8-connected. One label for each run of cells
// serves both: 8-connected components are unions of 4-connected ones.
//
// The map is cut into tiles of 64 x 64 cells. Each knows the components of its own cells, and which of
// them touch those of the next tiles; the components of the map are joined from these when somebody first
// asks. So after an edit only the tiles in which a cell has changed are labelled again.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/lazy.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/component_tile.hpp"

namespace wend {

/// Which cells are neighbours.
enum class Adjacency {
  edges,              // cells that share an edge (4-connected)
  edges_and_corners,  // or a corner (8-connected)
};

/// The connected components of a set of cells: a number and a size for each. Takes a quarter of a byte for
/// each cell, and 6 bytes for each run of cells in a row of a tile. All threads may ask.
class WEND_API ConnectedComponents {
 public:
  /// No cells and no components.
  ConnectedComponents() = default;

  /// The components of the set cells. O(cells / 64 + runs).
  explicit ConnectedComponents(const BitGrid& cells, DeadlineCheck& stop = DeadlineCheck::never());

  /// Does now what the first question with this adjacency would do. False if the deadline passed before.
  bool prepare(Adjacency adjacency, DeadlineCheck& stop) const;

  /// The same for `cells`, which differ only in a box of the map. O(rows of its tiles + runs there).
  void repair(const BitGrid& cells, const CellBox& box);

  /// The component of a cell: 0 for a cell that is not set, else from 1 on. Do not mix numbers of the
  /// two adjacencies. O(1); the first question, also after a repair, takes O(components of all tiles),
  /// for edges_and_corners O(cells / 64) too.
  std::uint32_t component(Cell cell, Adjacency adjacency) const {
    const ComponentTile& tile = tiles_[tile_of(cell)];
    const std::uint32_t label = tile.label(cell);
    return label == 0 ? 0 : numbers(adjacency).of_label[tile.first_label() + label];
  }

  /// Are both cells set and in the same component? O(1), as component().
  bool connected(Cell a, Cell b, Adjacency adjacency) const {
    const std::uint32_t component_of_a = component(a, adjacency);
    return component_of_a != 0 && component_of_a == component(b, adjacency);
  }

  /// How many cells the component of a cell has; 0 if the cell is not set.
  std::size_t size_of_component(Cell cell, Adjacency adjacency) const {
    return numbers(adjacency).sizes[component(cell, adjacency)];
  }

  /// The number of components.
  std::size_t count(Adjacency adjacency) const { return numbers(adjacency).sizes.size() - 1; }

  /// The sizes of all components, largest first.
  std::vector<std::size_t> sizes(Adjacency adjacency) const;

 private:
  /// The components of the map.
  struct Numbers {
    std::vector<std::uint32_t> of_label;  // by label, counted on over all tiles
    std::vector<std::size_t> sizes{0};    // by component; 0 for the cells that are not set
  };

  std::size_t tile_of(Cell cell) const {
    return static_cast<std::size_t>(cell.y) / 64 * columns_ +
           (static_cast<std::size_t>(cell.x) + 1) / 64;
  }
  const Numbers& numbers(Adjacency adjacency) const {
    if (adjacency == Adjacency::edges) {
      return joined_.get([this] { return joined_over_edges(DeadlineCheck::never()); });
    }
    return merged_.get([this] { return joined_over_corners(DeadlineCheck::never()); });
  }

  void link_to_next(std::size_t tile);
  void count_labels();
  Numbers joined_over_edges(DeadlineCheck& stop) const;
  Numbers joined_over_corners(DeadlineCheck& stop) const;

  std::size_t columns_ = 0;  // of tiles: the words of a row
  std::size_t rows_ = 0;
  std::vector<ComponentTile> tiles_;  // row by row
  std::uint32_t labels_ = 0;          // of all tiles
  Lazy<Numbers> joined_;              // 4-connected
  Lazy<Numbers> merged_;              // 8-connected
};

}  // namespace wend
