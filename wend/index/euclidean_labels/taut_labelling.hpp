#pragma once

// TautLabelling: for every corner some hubs, and the lengths of the taut paths to them, so that a shortest path
// between two cells passes a hub which its first and its last corner both have.
//
// Hubs are added one by one, the most important first; each spreads by a TautTree, cut off where earlier hubs already
// give the length. (T. Akiba, Y. Iwata and Y. Yoshida, "Fast Exact Shortest-Path Distance Queries on Large Networks by
// Pruned Landmark Labeling", 2013; for lengths in the plane J. Du, B. Shen and M. A. Cheema, "Ultrafast Euclidean
// Shortest Path Computation Using Hub Labeling", 2023.) Every corner is its own hub at length 0; no entry says so.
//
// Why it suffices to follow taut paths. The corners of a shortest path between two cells are joined by edges that are
// tangent at both ends, and it turns only around them. This is true of each of its parts, and of every path that is as
// short as such a part and could take its place. So a tree from one of these corners has the lengths to the others,
// and no hub that gives a smaller sum is left out.

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "wend/index/euclidean_labels/taut_tree.hpp"
#include "wend/sight/taut_graph.hpp"

namespace wend {

class TautLabelling {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  /// A hub of a corner other than itself, and the path to it.
  struct Entry {
    std::uint32_t corner;
    std::uint32_t hub;   // hubs count from 0, the most important one
    std::uint32_t edge;  // the first one of the path
    std::uint32_t next;  // the entry of the corner behind it; kNone: that is the hub
    double length;       // cells
  };

  /// Without hubs. All edges of the graph must be known. It must outlive the labelling.
  explicit TautLabelling(const TautGraph& graph);

  /// Makes a corner the next hub; it must not be one yet.
  void add_hub(std::uint32_t corner);

  /// Those of a hub follow each other, the nearest corner first.
  std::span<const Entry> entries() const { return entries_; }
  std::uint32_t hubs() const { return static_cast<std::uint32_t>(corners_.size()); }
  std::uint32_t corner_of(std::uint32_t hub) const { return corners_[hub]; }
  /// kNone if it is not a hub yet.
  std::uint32_t hub_of(std::uint32_t corner) const { return hubs_[corner]; }

 private:
  /// What the check for earlier hubs reads of an entry.
  struct Known {
    std::uint32_t hub;
    std::uint32_t entry;
    double length;
  };

  static constexpr double kUnreached = std::numeric_limits<double>::infinity();
  static constexpr double kRounding = 1e-9;  // cells

  bool is_covered(const TautTree::Reached& at) const;

  const TautGraph& graph_;
  TautTree tree_;
  std::vector<std::uint32_t> corners_;  // of each hub
  std::vector<std::uint32_t> hubs_;     // of each corner
  std::vector<Entry> entries_;
  std::vector<std::vector<Known>> labels_;  // of each corner
  std::vector<double> from_root_;           // to each hub; kUnreached between two of them
};

}  // namespace wend
