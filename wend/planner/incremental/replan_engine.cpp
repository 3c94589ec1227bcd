#include "wend/planner/incremental/replan_engine.hpp"

#include <memory>
#include <utility>
#include <vector>

#include "wend/planner/costs/cost_grid_parts.hpp"
#include "wend/planner/costs/leap_engine.hpp"
#include "wend/planner/incremental/kept_path.hpp"
#include "wend/search/limit_check.hpp"

namespace wend {
namespace {

template <class Word>
class ReplanEngine final : public GridEngine {
 public:
  ReplanEngine(std::shared_ptr<const CostGrid<Word>> grid, const BestFirst& parts)
      : grid_(std::move(grid)),
        kept_(*grid_, parts.moves),
        leaps_(make_leap_engine<Word>(grid_, parts)) {}

  bool allocated() const override { return leaps_->allocated(); }
  bool expects_a_path() const override { return true; }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    goals_.assign(goals.begin(), goals.end());
    searches_ = false;
    kept_outcome_ = outcome_without_search(limits);
    if (kept_outcome_ != SearchOutcome::running) return;
    if (kept_.is_cheapest_from(start, goals)) {
      kept_outcome_ = SearchOutcome::found;
      return;
    }
    kept_.forget();
    searches_ = true;
    leaps_->begin(start, goals, limits, observer);
  }

  SearchOutcome step() override { return searches_ ? leaps_->step() : kept_outcome_; }
  SearchOutcome run() override { return searches_ ? leaps_->run() : kept_outcome_; }

  const SearchMetrics& metrics() const override {
    return searches_ ? leaps_->metrics() : kNothingSearched;
  }

  OpenList open_list(std::size_t most) const override {
    return searches_ ? leaps_->open_list(most) : OpenList{};
  }

  double heuristic(const Cell& place) const override {
    return searches_ ? leaps_->heuristic(place) : 0;
  }

  void write_path(Path& path) const override {
    if (!searches_) {
      kept_.write(path);
    } else {
      leaps_->write_path(path);
      kept_.keep(path.cells(), goals_);
    }
  }

 private:
  static constexpr SearchMetrics kNothingSearched = {};

  /// Has the time passed, or the query been cancelled, before it began?
  static SearchOutcome outcome_without_search(const Limits& limits) {
    Limits no_expansions = limits;
    no_expansions.expansions = Limits::kUnlimited;
    LimitCheck check;
    check.begin(no_expansions);
    return check.look(0);
  }

  std::shared_ptr<const CostGrid<Word>> grid_;
  mutable KeptPath<Word> kept_;
  std::shared_ptr<GridEngine> leaps_;
  // The present search.
  std::vector<GoalRegion> goals_;
  bool searches_ = false;
  SearchOutcome kept_outcome_ = SearchOutcome::found;  // if it does not search
};

}  // namespace

GridPlanner::Parts replan_parts(const FreeSpace& space, const BestFirst& parts,
                                DeadlineCheck& stop) {
  if (!can_leap(space, parts)) return best_first_parts(space, parts);
  const auto engine_on = [&]<class Word>(const std::shared_ptr<CostGrid<Word>>& grid) {
    return std::make_shared<ReplanEngine<Word>>(grid, parts);
  };
  const auto remake = [=](const FreeSpace& other) { return replan_parts(other, parts); };
  return cost_grid_parts(space, parts, engine_on, remake, stop);
}

}  // namespace wend
