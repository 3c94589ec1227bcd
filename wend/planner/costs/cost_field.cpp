#include "wend/planner/costs/cost_field.hpp"

#include <algorithm>

namespace wend {

template <class Number, class Word, class Units>
SearchOutcome CostField<Number, Word, Units>::run(std::span<const Cell> goals,
                                                  const Limits& limits) {
  if (!allocated()) return SearchOutcome::out_of_memory;
  outcome_ = SearchOutcome::running;
  LimitCheck check;
  check.begin(limits);
  queue_.begin(0, width_bits_);
  for (const Cell goal : goals) reach(grid_.number(goal), Node::start());
  while (!queue_.empty()) {
    const std::size_t open = queue_.size();
    bucket_.clear();
    queue_.take_bucket(bucket_);
    bound_ = queue_.end_of_bucket();
    if (bound_ + most_step() > Node::kMostCost) return outcome_ = SearchOutcome::cost_overflow;
    metrics_.max_frontier = std::max<std::uint64_t>(metrics_.max_frontier, open);
    drain(check);
    if (outcome_ != SearchOutcome::running) return outcome_;
  }
  return outcome_ = SearchOutcome::exhausted;
}

/// The three rows around a cell, each of which may lie in two lines of the cache. Inline: g++ takes a function
/// that only prefetches for one without effects, and drops its calls.
template <class Number, class Word, class Units>
void CostField<Number, Word, Units>::fetch_ahead(StateId id) const {
  for (const StateId row : {grid_.neighbour(id, static_cast<unsigned>(Direction::plus_y)), id,
                            grid_.neighbour(id, static_cast<unsigned>(Direction::minus_y))}) {
    __builtin_prefetch(&nodes_[row - 1], 1);
    __builtin_prefetch(&nodes_[row + 1], 1);
    if constexpr (!Node::kUniform) {
      __builtin_prefetch(grid_.words() + row - 1);
      __builtin_prefetch(grid_.words() + row + 1);
    }
  }
  if constexpr (Node::kUniform) __builtin_prefetch(grid_.words() + id);
}

/// Expands the cells of the bucket, unless the search ends early.
template <class Number, class Word, class Units>
void CostField<Number, Word, Units>::drain(LimitCheck& check) {
  const std::uint64_t number = queue_.least_key() >> width_bits_;
  for (std::size_t i = 0; i < bucket_.size(); ++i) {
    if (i + kAhead < bucket_.size()) fetch_ahead(bucket_[i + kAhead]);
    const StateId id = bucket_[i];
    // A cell that was reached more cheaply since was expanded in an earlier bucket.
    if (nodes_[id].bucket(width_bits_) != number) continue;
    if (check.due(metrics_.expanded)) {
      outcome_ = check.look(metrics_.expanded);
      if (outcome_ != SearchOutcome::running) return;
    }
    expand(id);
  }
}

template <class Number, class Word, class Units>
void CostField<Number, Word, Units>::expand(StateId id) {
  ++metrics_.expanded;
  const Word word = grid_.word(id);
  const std::uint64_t steps = Grid::steps(word);
  const Node node = nodes_[id];
  unsigned moves = grid_.moves(node.arrival(), word);
  for (; moves != 0; moves &= moves - 1) {
    const auto direction = static_cast<unsigned>(std::countr_zero(moves));
    const StateId next = grid_.neighbour(id, direction);
    const std::uint64_t sum = Node::kUniform ? 2 : steps + Grid::steps(grid_.word(next));
    reach(next, node.after(sum, direction));
  }
}

template <class Number, class Word, class Units>
void CostField<Number, Word, Units>::reach(StateId id, Node node) {
  const Node before = nodes_[id];
  if (before.as_cheap_as(node)) return;
  nodes_[id] = node;
  metrics_.generated += before.reached() ? 0 : 1;
  const std::uint64_t bucket = node.bucket(width_bits_);
  // Its entry in the same bucket serves both.
  if (before.reached() && before.bucket(width_bits_) == bucket) return;
  queue_.push(node.g(), id);
}

template class CostField<std::uint64_t, std::uint32_t, CostUnits>;
template class CostField<std::uint64_t, std::uint64_t, CostUnits>;
template class CostField<WideFieldNumber, std::uint32_t, CostUnits>;
template class CostField<WideFieldNumber, std::uint64_t, CostUnits>;
template class CostField<std::uint64_t, std::uint32_t, OctileUnits<std::uint32_t>>;
template class CostField<WideFieldNumber, std::uint32_t, OctileUnits<std::uint64_t>>;

}  // namespace wend
