#include "wend/planner/incremental/kept_path.hpp"

#include <algorithm>

#include "wend/space/grid/cost_units.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {
namespace {

// The units of the searches, in which equal paths have equal costs.
template <class Word>
constexpr std::uint64_t straight_unit(const CostGrid<Word>& grid) {
  return grid.one() == 1 ? OctileUnits<std::uint64_t>::kStraight : CostUnits::kStraight;
}
template <class Word>
constexpr std::uint64_t diagonal_unit(const CostGrid<Word>& grid) {
  return grid.one() == 1 ? OctileUnits<std::uint64_t>::kDiagonal : CostUnits::kDiagonal;
}

Direction direction_between(Cell from, Cell to) {
  const Cell step{to.x - from.x, to.y - from.y};
  const auto found = std::ranges::find(kDirectionSteps, step);
  return static_cast<Direction>(found - kDirectionSteps.begin());
}

}  // namespace

template <class Word>
void KeptPath<Word>::keep(std::span<const Cell> path, std::span<const GoalRegion> goals) {
  ids_.clear();
  for (const Cell cell : path) ids_.push_back(grid_.number(cell));
  costs_.assign(ids_.size(), 0);
  for (std::size_t i = ids_.size() - 1; i > 0; --i) {
    costs_[i - 1] = costs_[i] + step_cost(ids_[i - 1], ids_[i]);
  }
  at_ = 0;
  goals_.assign(goals.begin(), goals.end());
  log_position_ = grid_.log_end();
}

template <class Word>
bool KeptPath<Word>::is_cheapest_from(Cell start, std::span<const GoalRegion> goals) {
  if (ids_.empty() || !std::ranges::equal(goals, goals_) || !go_to(start)) return false;
  const auto changes = grid_.changes_since(log_position_);
  if (!changes) return false;
  if (changes->empty()) return true;
  if (cost_of_rest() != costs_[at_]) return false;
  if (may_lead_past(start, costs_[at_], *changes)) return false;
  log_position_ = grid_.log_end();
  return true;
}

template <class Word>
void KeptPath<Word>::write(Path& path) const {
  path.clear();
  for (std::size_t i = at_; i < ids_.size(); ++i) path.append(grid_.cell(ids_[i]));
}

template <class Word>
std::uint64_t KeptPath<Word>::step_cost(StateId from, StateId to) const {
  const std::uint64_t sum = Grid::steps(grid_.word(from)) + Grid::steps(grid_.word(to));
  const Cell a = grid_.cell(from);
  const Cell b = grid_.cell(to);
  return sum * (a.x != b.x && a.y != b.y ? diagonal_unit(grid_) : straight_unit(grid_));
}

/// Robots go forwards, so the start is looked for from the last one on.
template <class Word>
bool KeptPath<Word>::go_to(Cell start) {
  const auto found =
      std::find(ids_.begin() + static_cast<std::ptrdiff_t>(at_), ids_.end(), grid_.number(start));
  if (found == ids_.end()) return false;
  at_ = static_cast<std::size_t>(found - ids_.begin());
  return true;
}

/// Nothing if a step is no longer legal.
template <class Word>
std::optional<std::uint64_t> KeptPath<Word>::cost_of_rest() const {
  std::uint64_t cost = 0;
  for (std::size_t i = at_; i + 1 < ids_.size(); ++i) {
    const Word word = grid_.word(ids_[i]);
    const Direction direction = direction_between(grid_.cell(ids_[i]), grid_.cell(ids_[i + 1]));
    if (word == 0 || (grid_.moves(kNoMove, word) & set_of(direction)) == 0) return std::nullopt;
    cost += step_cost(ids_[i], ids_[i + 1]);
  }
  return grid_.word(ids_.back()) == 0 ? std::nullopt : std::optional(cost);
}

/// Can a path through one of the cells that became better cost less?
template <class Word>
bool KeptPath<Word>::may_lead_past(Cell start, std::uint64_t cost,
                                   std::span<const typename Grid::Change> changes) const {
  return std::ranges::any_of(changes, [&](const auto& change) {
    if (!grid_.became_better(change)) return false;
    const Cell cell = grid_.cell(change.id);
    std::uint64_t onwards = ~std::uint64_t{0};
    for (const GoalRegion& goal : goals_) {
      onwards = std::min(onwards, least_cost(cell, goal.nearest_in_box(cell)));
    }
    return least_cost(start, cell) + onwards < cost;
  });
}

template <class Word>
std::uint64_t KeptPath<Word>::least_cost(Cell from, Cell to) const {
  const auto dx = static_cast<std::uint64_t>(std::abs(from.x - to.x));
  const auto dy = static_cast<std::uint64_t>(std::abs(from.y - to.y));
  const std::uint64_t twice = 2 * grid_.least_steps();
  if (moves_.connectivity == Connectivity::four) return twice * straight_unit(grid_) * (dx + dy);
  const std::uint64_t both = std::min(dx, dy);
  return twice * (straight_unit(grid_) * (std::max(dx, dy) - both) + diagonal_unit(grid_) * both);
}

template class KeptPath<std::uint32_t>;
template class KeptPath<std::uint64_t>;

}  // namespace wend
