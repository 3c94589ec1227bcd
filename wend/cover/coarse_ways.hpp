#pragma once

// Coarse ways: about how far it is from place to place, through doors and around walls. The map is cut into square
// blocks; what hangs together in a block is a node, in its middle.

#include <cstdint>
#include <span>
#include <vector>

#include "wend/cover/coverage_area.hpp"
#include "wend/map/grid.hpp"

namespace wend {

class CoarseWays {
 public:
  /// For the reachable cells of an area. `block` is the size of blocks in cells, at least 1. O(cells).
  CoarseWays(const CoverageArea& area, int block);

  /// The node of a reachable cell.
  std::uint32_t node_of(Cell cell) const { return nodes_[cell] - 1; }
  /// The middle of a node's cells.
  Point middle_of(std::uint32_t node) const { return middles_[node]; }
  /// The lengths of the ways from a node to all nodes, in cells; infinite if there is none. O(nodes log nodes).
  std::vector<double> lengths_from(std::uint32_t node) const;

 private:
  struct Link {
    std::uint32_t to;
    double length;
  };

  void label(const CoverageArea& area, int block);
  void link(const CoverageArea& area);

  Grid<std::uint32_t> nodes_;  // from 1 on; 0: not reachable
  std::vector<Point> middles_;
  std::vector<std::vector<Link>> links_;
};

}  // namespace wend
