#pragma once

// LabelOrder: chooses the next hub so that labels become small: the corner on the most shortest paths
// that no hub covers yet, as SampledTrees estimate.
//
// As hubs cut trees short, new trees keep up the number of nodes. Once new trees have only a few nodes,
// nearly all paths are covered and the rest of the order matters little; then the remaining trees are
// used up. The order is the same in every run.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "wend/index/corner_graph.hpp"
#include "wend/index/first_corners.hpp"
#include "wend/index/hub_labels/hub_labelling.hpp"
#include "wend/index/index_building.hpp"

namespace wend {

class SampledTrees;

class LabelOrder {
 public:
  /// All four must outlive it.
  LabelOrder(const CornerGraph& graph, const AllFirstCorners& first, const HubLabelling& labelling,
             const IndexBuilding& building);
  ~LabelOrder();

  /// A corner that is not a hub yet; there must be one. Make it a hub before the next call. Any such corner if the
  /// building was cancelled.
  std::uint32_t next();

 private:
  struct Candidate {
    std::uint64_t total;  // at least the total of the corner
    std::uint32_t corner;

    friend bool operator<(const Candidate& a, const Candidate& b) {
      return a.total != b.total ? a.total > b.total : a.corner < b.corner;
    }
  };

  void grow_trees();
  void push(std::uint32_t corner, std::uint64_t total);

  const HubLabelling& labelling_;
  const IndexBuilding& building_;
  std::unique_ptr<SampledTrees> trees_;
  std::size_t wanted_nodes_;
  std::size_t grown_ = 0;
  double nodes_of_late_;  // per tree, as a running mean
  bool all_told_ = false;
  std::vector<Candidate> queue_;
  std::vector<std::uint64_t> queued_;  // by corner: its total in the queue, 0 if it is in none
  std::uint32_t rest_ = 0;             // corners from here on may not be hubs, once all is told
};

}  // namespace wend
