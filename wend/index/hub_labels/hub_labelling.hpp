#pragma once

// HubLabelling: for every corner some hubs and the exact costs of the paths to them, so that a
// shortest path between any two corners passes a hub that both have.
//
// Hubs are added one by one, the most important first. Each hub spreads over the corner graph by
// Dijkstra's algorithm, pruned where earlier hubs already give the cost. (T. Akiba, Y. Iwata and Y.
// Yoshida, "Fast Exact Shortest-Path Distance Queries on Large Networks by Pruned Landmark Labeling",
// 2013.) The order of the hubs decides how small the labels become: see label_order.hpp.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/index/corner_graph.hpp"
#include "wend/index/corners.hpp"
#include "wend/index/index_building.hpp"

namespace wend {

/// One hub of a corner's label.
struct HubEntry {
  std::uint32_t hub;  // hubs count from 0, the most important one
  CornerCost cost;
};

/// Does a hub of the label give a path of at most `cost`? `by_hub`: the costs from the other end to each
/// hub.
inline bool covers(std::span<const HubEntry> label, std::span<const CornerCost> by_hub,
                   CornerCost cost) {
  return std::any_of(label.begin(), label.end(),
                     [&](const HubEntry& entry) { return by_hub[entry.hub] + entry.cost <= cost; });
}

/// The corners that a hub reached, by cost: the tree of shortest paths to it.
struct HubTreeNode {
  static constexpr std::uint32_t kRoot = static_cast<std::uint32_t>(-1);

  std::uint32_t corner;
  std::uint32_t parent;  // its place in the tree; kRoot for the hub itself
};

class HubLabelling {
 public:
  /// A labelling without hubs. Both must outlive it.
  HubLabelling(const CornerGraph& graph, const IndexBuilding& building);

  std::size_t hubs() const { return hub_corners_.size(); }
  bool is_hub(std::uint32_t corner) const { return is_hub_[corner] != 0; }
  std::uint32_t corner_of(std::uint32_t hub) const { return hub_corners_[hub]; }

  /// In the order of the hubs.
  std::span<const HubEntry> label(std::uint32_t corner) const { return labels_[corner]; }

  std::span<const HubTreeNode> tree(std::uint32_t hub) const {
    return std::span(nodes_).subspan(trees_[hub], trees_[hub + 1] - trees_[hub]);
  }

  /// The largest cost so far; costs are right if it is below kUnreachedCost.
  CornerCost greatest_cost() const { return greatest_cost_; }

  /// Makes a corner the next hub; it must not be a hub yet.
  void add_hub(std::uint32_t corner);

 private:
  void spread(std::uint32_t hub, std::uint32_t root);
  void reach(const CornerFrontier::Entry& entry);

  const CornerGraph& graph_;
  const IndexBuilding& building_;
  std::vector<std::uint32_t> hub_corners_;
  std::vector<std::uint8_t> is_hub_;           // by corner
  std::vector<std::vector<HubEntry>> labels_;  // by corner
  std::vector<HubTreeNode> nodes_;             // tree after tree
  std::vector<std::size_t> trees_{0};          // by hub: where its tree begins, and the end
  CornerCost greatest_cost_ = 0;

  // State of the hub that spreads.
  std::vector<CornerCost> from_root_;  // by hub before it
  CornerFrontier frontier_;
};

// ComponentHubs: which hubs the cells of a component need, by which of their first corners.
//
// A cell reaches a hub at the least cost over its first corners. It does not need a hub if the path
// there can pass a more important hub that it reaches: that one serves every goal as well. A component
// keeps a hub if any of its cells needs it, by a corner that gives the least cost to such a cell;
// testing only some of the cells would be wrong.

class ComponentHubs {
 public:
  /// Needs a complete labelling. Both arguments must outlive it. Each thread needs its own.
  ComponentHubs(const Corners& corners, const HubLabelling& labelling);

  /// For cells that all have these first corners: the hubs that each corner is kept for, in their
  /// order. Valid until the next call.
  std::span<const std::vector<HubEntry>> choose(std::span<const Cell> cells,
                                                std::span<const std::uint32_t> first);

 private:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  /// How a hub is reached from the current cell.
  struct Reached {
    CornerCost cost;
    CornerCost from_corner;
    std::uint32_t by;  // the index of a first corner
  };

  void list_hubs(std::span<const std::uint32_t> first);
  void reach_hubs(Cell cell, std::span<const std::uint32_t> first);
  void keep_what_is_needed(Cell cell, std::span<const std::uint32_t> first);
  bool is_kept(Cell cell, std::span<const std::uint32_t> first, std::size_t slot) const;
  bool is_needed(std::size_t slot) const;

  const Corners& corners_;
  const HubLabelling& labelling_;
  std::vector<std::uint32_t> slots_;           // by hub: its place in hubs_, or none
  std::vector<std::uint32_t> hubs_;            // of the component, in their order
  std::vector<Reached> reached_;               // by slot
  std::vector<std::vector<Reached>> kept_by_;  // by slot
  std::vector<std::vector<HubEntry>> chosen_;  // by first corner
};

}  // namespace wend
