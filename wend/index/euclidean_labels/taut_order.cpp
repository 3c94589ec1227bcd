#include "wend/index/euclidean_labels/taut_order.hpp"

#include <algorithm>

#include "wend/base/random.hpp"
#include "wend/index/euclidean_labels/taut_tree.hpp"
#include "wend/index/sampled_forest.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::size_t kFirstTrees = 40;
constexpr std::size_t kFewEdges = 8;        // a corner: then new trees grow
constexpr std::size_t kNodesPerCorner = 8;  // of those that are left
constexpr std::size_t kTreesBetweenHubs = 4;
constexpr std::uint64_t kTaken = UINT64_MAX;

class SampledTautTrees {
 public:
  explicit SampledTautTrees(const TautGraph& graph)
      : tree_(graph),
        corners_(static_cast<std::uint32_t>(graph.portals().corners().size())),
        forest_(corners_),
        node_of_(corners_, kNone),
        taken_(corners_, 0) {}

  std::size_t size() const { return forest_.size(); }
  std::uint64_t total(std::uint32_t corner) const { return forest_.total(corner); }

  /// A tree from a random corner that has not been taken. Calls grew(corner) for its corners.
  template <class Grew>
  void grow(Grew&& grew) {
    const std::uint32_t root = random_root();
    if (root == kNone) return;
    forest_.begin_tree();
    add(root, kNone);
    tree_.spread(root, [&](const TautTree::Reached& at) {
      if (taken_[at.corner] != 0) return false;
      add(at.corner, node_of_[tree_.before(at.edge)]);
      return true;
    });
    forest_.end_tree(grew);
  }

  /// Cuts off what lies behind a corner in all trees.
  void take(std::uint32_t corner) {
    taken_[corner] = 1;
    forest_.cut(corner);
  }

 private:
  static constexpr std::uint32_t kNone = SampledForest::kNone;

  std::uint32_t random_root() {
    constexpr int kTries = 64;
    for (int i = 0; corners_ > 0 && i < kTries; ++i) {
      const auto root = static_cast<std::uint32_t>(random_.below(corners_));
      if (taken_[root] == 0) return root;
    }
    return kNone;  // few are left
  }

  void add(std::uint32_t corner, std::uint32_t parent) {
    node_of_[corner] = forest_.add(corner, parent, 1);
  }

  TautTree tree_;
  std::uint32_t corners_;
  Random random_{1};
  SampledForest forest_;
  std::vector<std::uint32_t> node_of_;  // of each corner, in the tree that grows
  std::vector<std::uint8_t> taken_;
};

struct Candidate {
  std::uint64_t total;     // at least that of the corner
  std::uint64_t at_first;  // before any corner was taken
  std::uint32_t corner;

  friend bool operator<(const Candidate& a, const Candidate& b) {
    if (a.total != b.total) return a.total > b.total;
    return a.at_first != b.at_first ? a.at_first > b.at_first : a.corner < b.corner;
  }
};

}  // namespace

std::vector<std::uint32_t> taut_order(const TautGraph& graph, const IndexBuilding& building) {
  const auto corners = static_cast<std::uint32_t>(graph.portals().corners().size());
  const bool grows_new = graph.edges() < kFewEdges * corners;
  SampledTautTrees trees(graph);
  for (std::size_t i = 0; i < kFirstTrees && !building.cancelled(); ++i) {
    trees.grow([](std::uint32_t) {});
  }
  std::vector<std::uint64_t> at_first;
  std::vector<Candidate> queue;
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    at_first.push_back(trees.total(corner));
    queue.push_back({at_first.back(), at_first.back(), corner});
  }
  min_heap::make(queue);
  std::vector<std::uint64_t> queued = at_first;  // of each corner: its total in the queue
  const auto push = [&](std::uint32_t corner) {
    queued[corner] = trees.total(corner);
    min_heap::push(queue, {queued[corner], at_first[corner], corner});
  };
  std::vector<std::uint32_t> order;
  while (order.size() < corners && !building.cancelled()) {
    const Candidate best = min_heap::pop(queue);
    if (best.total != queued[best.corner]) continue;  // it was pushed again
    if (best.total != trees.total(best.corner)) {
      push(best.corner);
      continue;
    }
    queued[best.corner] = kTaken;
    order.push_back(best.corner);
    trees.take(best.corner);
    const std::size_t left = corners - order.size();
    for (std::size_t i = 0;
         grows_new && i < kTreesBetweenHubs && trees.size() < kNodesPerCorner * left; ++i) {
      trees.grow([&](std::uint32_t corner) {
        if (trees.total(corner) > queued[corner]) push(corner);
      });
    }
  }
  return order;
}

}  // namespace wend
