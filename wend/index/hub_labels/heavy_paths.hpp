#pragma once

// HeavyPaths: the ways from corners to their hubs as runs of steps, to be written down cell by cell
// without a search.
//
// The tree of shortest ways to a hub is cut into paths: each goes on from a corner to the child
// that has most below it. A path is a string of runs from its far end towards the hub; where it
// joins the path of its parent, a joint says where to read on. So a way to a hub is read from few
// places in memory.
//
// A string is of 16-bit words: a run is its steps times 8 plus its Direction; a joint is a 0
// followed by the place to read on at, lower half first, kHub at the hub.

#include <cstdint>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/index/corners.hpp"
#include "wend/index/hub_labels/hub_labelling.hpp"

namespace wend {

using RunWord = std::uint16_t;

namespace run_word {

inline constexpr RunWord kJoint = 0;
inline constexpr std::uint32_t kHub = static_cast<std::uint32_t>(-1);
inline constexpr int kMostSteps = (1 << 13) - 1;

constexpr RunWord of(int steps, Direction direction) {
  return static_cast<RunWord>(steps * kDirections + static_cast<int>(direction));
}
constexpr std::uint32_t steps(RunWord word) { return word / kDirections; }
constexpr Direction direction(RunWord word) { return static_cast<Direction>(word % kDirections); }

}  // namespace run_word

class HeavyPaths {
 public:
  /// Of a complete labelling. O(its entries).
  HeavyPaths(const Corners& corners, const HubLabelling& labelling);

  std::span<const RunWord> words() const { return words_; }

  /// Where the ways from a corner to its hubs begin in words(), in the order of its label; kHub
  /// where the corner is the hub.
  std::span<const std::uint32_t> places(std::uint32_t corner) const {
    return std::span(places_).subspan(begins_[corner], begins_[corner + 1] - begins_[corner]);
  }

 private:
  void add_tree(std::span<const HubTreeNode> tree);
  void add_path(std::span<const HubTreeNode> tree, std::uint32_t top);
  void add_way(Cell from, Cell to);
  void add_joint(std::uint32_t place);

  const Corners& corners_;
  std::vector<RunWord> words_;
  std::vector<std::size_t> begins_;    // by corner, and the end: in places_
  std::vector<std::uint32_t> places_;  // by corner, label after label

  // Of the tree that is added, by node.
  std::vector<std::uint32_t> below_;   // nodes in its subtree
  std::vector<std::uint32_t> heavy_;   // the child with most below it
  std::vector<std::uint32_t> starts_;  // where its way begins
  std::vector<std::uint32_t> path_;
  std::vector<std::size_t> next_;  // by corner: the next of its places to fill
};

}  // namespace wend
