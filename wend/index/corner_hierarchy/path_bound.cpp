#include "wend/index/corner_hierarchy/path_bound.hpp"

#include <cstdint>
#include <limits>
#include <vector>

#include "wend/map/connected_components.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::uint64_t kMost = std::numeric_limits<HierarchyCost>::max();
constexpr std::uint64_t kUnreached = std::numeric_limits<std::uint64_t>::max();

struct Entry {
  std::uint64_t cost;
  std::uint32_t turn;

  friend bool operator<(const Entry& a, const Entry& b) { return a.cost < b.cost; }
};

/// Where paths from a cell turn, farther and farther away.
class Spread {
 public:
  Spread(const Turns& turns, std::span<const GraphArc> arcs)
      : turns_(turns), arcs_(arcs), costs_(turns.size(), kUnreached), begins_(turns.size() + 1) {
    for (const GraphArc& arc : arcs) ++begins_[arc.tail + 1];
    for (std::uint32_t turn = 0; turn < turns.size(); ++turn) begins_[turn + 1] += begins_[turn];
  }

  /// What the farthest turn costs.
  std::uint64_t from(Cell cell) {
    turns_.for_each_first(cell, [&](const TurnChoice& choice, CornerCost cost) {
      turns_.for_each_of(choice, [&](std::uint32_t turn) { reach(turn, cost); });
    });
    std::uint64_t farthest = 0;
    while (!queue_.empty()) {
      const Entry least = min_heap::pop(queue_);
      if (least.cost > costs_[least.turn]) continue;
      farthest = least.cost;
      for (std::uint32_t arc = begins_[least.turn]; arc < begins_[least.turn + 1]; ++arc) {
        reach(arcs_[arc].head, least.cost + arcs_[arc].cost);
      }
    }
    return farthest;
  }

 private:
  void reach(std::uint32_t turn, std::uint64_t cost) {
    if (cost >= costs_[turn]) return;
    costs_[turn] = cost;
    min_heap::push(queue_, {cost, turn});
  }

  const Turns& turns_;
  std::span<const GraphArc> arcs_;  // in the order of their tails
  std::vector<std::uint64_t> costs_;
  std::vector<std::uint32_t> begins_;
  std::vector<Entry> queue_;
};

}  // namespace

bool paths_may_be_too_long(const Turns& turns, std::span<const GraphArc> arcs) {
  using Units = OctileUnits<CornerCost>;
  const auto width = static_cast<std::uint64_t>(turns.passable().width());
  const auto height = static_cast<std::uint64_t>(turns.passable().height());
  if (width * height * Units::kDiagonal < kMost) return false;
  const std::uint64_t longest_leg = (width + height) * Units::kStraight;
  Spread spread(turns, arcs);
  const ConnectedComponents components(turns.passable());
  std::vector<bool> measured(turns.passable().count() + 1);
  for (std::uint32_t turn = 0; turn < turns.size(); ++turn) {
    const std::uint32_t component = components.component(turns.cell(turn), Adjacency::edges);
    if (measured[component]) continue;
    measured[component] = true;
    const std::uint64_t farthest = spread.from(turns.cell(turn)) + longest_leg;
    if (2 * farthest >= kMost) return true;
  }
  return longest_leg >= kMost;  // where nothing turns
}

}  // namespace wend
