#pragma once

// TautTree: Dijkstra's algorithm from a corner over the edges of a TautGraph, by taut paths only. spread() asks at each
// corner that it reaches whether to go on from there.
//
// Where a taut path is a part of a shortest path between two cells, the tree has its length. Elsewhere it may have a
// longer path, because each corner is left only by what lies ahead of the edge by which it was reached first.
//
// O(edges log corners). One thread; it keeps its memory.

#include <cstdint>
#include <limits>
#include <vector>

#include "wend/search/min_heap.hpp"
#include "wend/sight/taut_graph.hpp"

namespace wend {

class TautTree {
 public:
  struct Reached {
    double length;  // from the root, in cells
    std::uint32_t corner;
    std::uint32_t edge;  // the last one of the path

    friend bool operator<(const Reached& a, const Reached& b) {
      return a.length != b.length ? a.length < b.length : a.edge < b.edge;
    }
  };

  /// All edges must be known. The graph must outlive it.
  explicit TautTree(const TautGraph& graph)
      : graph_(graph), lengths_(graph.portals().corners().size(), kUnreached) {}

  /// Calls visit(reached) for corners other than the root, the nearest first. The tree goes on behind a corner if it
  /// returns true.
  template <class Visit>
  void spread(std::uint32_t root, Visit&& visit) {
    lengths_[root] = 0;
    touched_.assign(1, root);
    reach(graph_.known_edges_of(root), 0);
    while (!open_.empty()) {
      const Reached next = min_heap::pop(open_);
      if (next.length > lengths_[next.corner]) continue;  // it was reached by a shorter path
      if (visit(next)) reach(graph_.known_ahead(next.edge), next.length);
    }
    for (const std::uint32_t corner : touched_) lengths_[corner] = kUnreached;
  }

  /// The corner before the last one of a path, by its last edge.
  std::uint32_t before(std::uint32_t edge) const { return graph_.edge(graph_.edge(edge).back).to; }

 private:
  static constexpr double kUnreached = std::numeric_limits<double>::infinity();

  void reach(TautGraph::Edges edges, double length) {
    for (std::uint32_t id = edges.begin; id < edges.end; ++id) {
      const TautGraph::Edge& edge = graph_.edge(id);
      const double here = length + edge.length;
      double& least = lengths_[edge.to];
      if (!(here < least)) continue;
      if (least == kUnreached) touched_.push_back(edge.to);
      least = here;
      min_heap::push(open_, Reached{here, edge.to, id});
    }
  }

  const TautGraph& graph_;
  std::vector<double> lengths_;  // of each corner
  std::vector<std::uint32_t> touched_;
  std::vector<Reached> open_;
};

}  // namespace wend
