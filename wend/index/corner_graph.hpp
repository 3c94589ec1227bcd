#pragma once

// CornerGraph: the corners of a map, and edges between those that a shortest path joins directly.
//
// Two corners are joined if an octile path between them is free and no corner lies on any of these
// paths. Distances between corners in this graph are those on the grid. (T. Uras, S. Koenig and C.
// Hernandez, "Subgoal Graphs for Optimal Pathfinding in Eight-Neighbor Grids", 2013.)
//
// All these edges are needed: without the edges that do not turn tightly around their corners, or with
// only the first of several edges in a row, some shortest paths are lost.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/index/corner_cost.hpp"
#include "wend/index/corners.hpp"
#include "wend/index/index_building.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {

struct CornerEdge {
  std::uint32_t to;
  CornerCost cost;  // octile_cost() of the two cells

  friend bool operator==(const CornerEdge&, const CornerEdge&) = default;
};

class CornerGraph {
 public:
  /// O(corners * the cells on their diagonals); 8 bytes an edge.
  explicit CornerGraph(Corners corners, const IndexBuilding& building = {});

  const Corners& corners() const { return corners_; }
  std::size_t size() const { return corners_.size(); }
  std::size_t edge_count() const { return edges_.size(); }

  /// The edges that leave a corner. The graph contains the reverse of every edge.
  std::span<const CornerEdge> edges(std::uint32_t corner) const {
    return std::span(edges_).subspan(begins_[corner], begins_[corner + 1] - begins_[corner]);
  }

 private:
  Corners corners_;
  std::vector<std::size_t> begins_;  // by corner, and the end
  std::vector<CornerEdge> edges_;
};

// CornerFrontier: the open list of Dijkstra's algorithm on the corner graph.

class CornerFrontier {
 public:
  struct Entry {
    CornerCost cost;
    std::uint32_t corner;
    std::uint32_t parent;  // an identifier that the caller chooses

    friend bool operator<(const Entry& a, const Entry& b) {
      return a.cost != b.cost ? a.cost < b.cost : a.corner < b.corner;
    }
  };

  explicit CornerFrontier(std::size_t corners) : costs_(corners, kUnreachedCost) {}

  /// Keeps an entry if it is cheaper than all earlier entries of the corner.
  void reach(const Entry& entry) {
    CornerCost& cost = costs_[entry.corner];
    if (entry.cost >= cost) return;
    if (cost == kUnreachedCost) reached_.push_back(entry.corner);
    cost = entry.cost;
    min_heap::push(heap_, entry);
  }

  bool empty() const { return heap_.empty(); }

  /// The cheapest entry. The frontier must not be empty.
  Entry pop() { return min_heap::pop(heap_); }

  /// Does the corner have a cheaper entry by now?
  bool is_outdated(const Entry& entry) const { return entry.cost > costs_[entry.corner]; }

  /// Removes all entries. O(reached corners).
  void clear() {
    for (const std::uint32_t corner : reached_) costs_[corner] = kUnreachedCost;
    reached_.clear();
    heap_.clear();
  }

 private:
  std::vector<CornerCost> costs_;  // by corner
  std::vector<std::uint32_t> reached_;
  std::vector<Entry> heap_;
};

}  // namespace wend
