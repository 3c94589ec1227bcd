#pragma once

// Connected components: which cells can reach which, known before any search.
//
// Without cutting corners (and where one corner may be cut) two cells are connected if they are
// 4-connected; where both corners may be cut, if they are 8-connected. One label a cell serves
// both: 8-connected components are unions of 4-connected ones.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"

namespace wend {

enum class Adjacency {
  edges,              // cells that share an edge (4-connected)
  edges_and_corners,  // or a corner (8-connected)
};

class ConnectedComponents {
 public:
  ConnectedComponents() = default;

  /// The components of the set cells. O(cells).
  explicit ConnectedComponents(const BitGrid& cells);

  /// The component of a cell: 0 for a cell that is not set, else from 1 on. Labels of the two
  /// adjacencies are not to be mixed.
  std::uint32_t component(Cell cell, Adjacency adjacency) const {
    const std::uint32_t label = labels_[cell];
    return adjacency == Adjacency::edges ? label : merged_[label];
  }

  bool connected(Cell a, Cell b, Adjacency adjacency) const {
    const std::uint32_t region_of_a = component(a, adjacency);
    return region_of_a != 0 && region_of_a == component(b, adjacency);
  }

  /// How many cells the component of a cell has; 0 if the cell is not set.
  std::size_t size_of_component(Cell cell, Adjacency adjacency) const {
    const std::uint32_t label = component(cell, adjacency);
    return adjacency == Adjacency::edges ? sizes_[label] : merged_sizes_[label];
  }

  std::size_t count(Adjacency adjacency) const;

  /// The sizes of all components, largest first.
  std::vector<std::size_t> sizes(Adjacency adjacency) const;

 private:
  Grid<std::uint32_t> labels_;            // 4-connected
  std::vector<std::uint32_t> merged_{0};  // by label: the 8-connected component
  std::vector<std::size_t> sizes_{0};     // by label
  std::vector<std::size_t> merged_sizes_{0};
};

}  // namespace wend
