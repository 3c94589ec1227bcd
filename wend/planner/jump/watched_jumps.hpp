#pragma once

// What somebody sees who watches a jump point search: a watcher, which is told of each state, and the open states.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_set>

#include "wend/base/state_id.hpp"
#include "wend/geometry/cell.hpp"

namespace wend {

/// The default watcher. It does nothing and costs nothing.
struct NoJumpWatcher {
  void on_generate(Cell, Cell, auto) const {}
  void on_expand(Cell, Cell, auto) const {}
  void on_reach(Cell, Cell, auto, bool) const {}
};

/// JumpPointSearch::for_each_open() of a running search. `queue` is a copy of its own, by f - least_f; `seer`: the node from which the
/// cheapest goal was seen.
template <class Jumps, class Queue, class Goals, class Visit>
std::uint64_t visit_open_jumps(const Jumps& jumps, Queue queue, const Goals& goals,
                               typename Jumps::Cost least_f, StateId seer, std::size_t most,
                               Visit&& visit) {
  std::unordered_set<StateId> open;  // older entries of a state are skipped
  std::optional<std::uint64_t> bucket;
  while (!queue.empty()) {
    const auto entry = queue.pop();
    if (queue.least_key() > goals.best() - least_f) break;
    const auto& node = jumps.node(entry.id);
    if (entry.f >= goals.best() || node.pending == 0 || !open.insert(entry.id).second) continue;
    if (open.size() > most) continue;
    const std::uint64_t here = queue.least_key();
    visit(node.cell, jumps.node(node.parent).cell, node.g(), here == bucket);
    bucket = here;
  }
  const Cell from = jumps.node(seer).cell;
  const bool goal_is_last = goals.best() != Goals::kInfinite && from != goals.goal();
  if (!goal_is_last) return open.size();
  if (open.size() < most) visit(goals.goal(), from, goals.best(), false);
  return open.size() + 1;
}

}  // namespace wend
