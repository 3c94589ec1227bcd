#pragma once

// CornerGraph: the corners of a map, and edges between those that a shortest way joins directly.
//
// Two corners are joined if an octile path between them is free and no corner lies on any of these
// paths. Distances between corners in this graph are those on the grid. (T. Uras, S. Koenig and C.
// Hernandez, "Subgoal Graphs for Optimal Pathfinding in Eight-Neighbor Grids", 2013.)
//
// All these edges are needed: without those that do not turn tightly around their corners, or with
// the first of several in a row only, some shortest paths are lost.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/index/corner_cost.hpp"
#include "wend/index/corners.hpp"

namespace wend {

struct CornerEdge {
  std::uint32_t to;
  CornerCost cost;  // octile_cost() of the two cells

  friend bool operator==(const CornerEdge&, const CornerEdge&) = default;
};

class CornerGraph {
 public:
  /// O(corners * the cells on their diagonals); 8 bytes an edge.
  explicit CornerGraph(Corners corners);

  const Corners& corners() const { return corners_; }
  std::size_t size() const { return corners_.size(); }
  std::size_t edge_count() const { return edges_.size(); }

  /// Where a corner leads to. Every edge has its opposite.
  std::span<const CornerEdge> edges(std::uint32_t corner) const {
    return std::span(edges_).subspan(begins_[corner], begins_[corner + 1] - begins_[corner]);
  }

 private:
  Corners corners_;
  std::vector<std::size_t> begins_;  // by corner, and the end
  std::vector<CornerEdge> edges_;
};

}  // namespace wend
