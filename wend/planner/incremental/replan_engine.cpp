#include "wend/planner/incremental/replan_engine.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "wend/planner/grid/cost_grid_parts.hpp"
#include "wend/planner/grid/leap_engine.hpp"
#include "wend/planner/incremental/kept_path.hpp"
#include "wend/planner/incremental/repair_tree.hpp"
#include "wend/search/limit_check.hpp"

namespace wend {
namespace {

/// How much work the tree may do, in expansions of the leaping search.
class TreeBudget {
 public:
  /// `even`: every cell costs the same. Leaps are then so fast that a tree never pays.
  TreeBudget(ReplanSearch search, bool even) : search_(search), even_(even) {}

  /// Is it the tree's turn? A tree for other goals would have to be grown first. Who watches a search must not see
  /// two.
  bool is_due(bool same_goals, bool watched) const {
    if (search_ != ReplanSearch::automatic) return search_ == ReplanSearch::tree;
    return !even_ && same_goals && !watched && leap_work_ > 0 && saved_ >= needed_;
  }

  /// The most expansions of the tree in this search.
  std::uint64_t expansions() const {
    if (search_ == ReplanSearch::tree) return Limits::kUnlimited;
    return static_cast<std::uint64_t>(saved_ * kTreeExpansionsPerLeap) + 1;
  }

  void leapt(std::uint64_t expanded) {
    leap_work_ = static_cast<double>(expanded);
    if (needed_ == 0) needed_ = kFirstNeed * leap_work_;
    saved_ += kShare * leap_work_;
  }

  /// The tree found the path.
  void tree_found(std::uint64_t expanded) {
    needed_ = static_cast<double>(expanded) / kTreeExpansionsPerLeap;
    saved_ += (1 + kShare) * leap_work_ - needed_;
  }

  /// The tree did not end within its budget.
  void tree_stopped(std::uint64_t expanded) {
    const double spent = static_cast<double>(expanded) / kTreeExpansionsPerLeap;
    saved_ = std::max(0.0, saved_ - spent);
    needed_ = 2 * std::max(needed_, spent);
  }

 private:
  static constexpr double kShare = 0.1;
  static constexpr double kFirstNeed = 1;
  // What a leaping search needs for an expansion, the tree needs for so many.
  static constexpr double kTreeExpansionsPerLeap = 2;

  ReplanSearch search_;
  bool even_;
  double leap_work_ = 0;  // of the last leaping search
  double saved_ = 0;
  double needed_ = 0;  // that the tree is thought to need
};

template <class Word>
class ReplanEngine final : public GridEngine {
 public:
  ReplanEngine(std::shared_ptr<const CostGrid<Word>> grid, const BestFirst& parts,
               ReplanSearch search)
      : grid_(std::move(grid)),
        kept_(*grid_, parts.moves),
        budget_(search, grid_->one() == 1),
        leaps_(make_leap_engine<Word>(grid_, parts)),
        tree_(make_repair_tree<Word>(grid_, parts)) {}

  bool allocated() const override { return leaps_->allocated() && tree_->allocated(); }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    start_ = start;
    const bool same_goals = std::ranges::equal(goals, goals_);
    goals_.assign(goals.begin(), goals.end());
    user_limits_ = &limits;
    begun_ = limits.now();
    before_ = metrics_ = {};
    observer_ = observer;
    used_ = nullptr;
    ended_ = outcome_without_search(limits);
    if (ended_ != SearchOutcome::running) return;
    if (kept_.is_cheapest_from(start, goals)) {
      ended_ = SearchOutcome::found;
      return;
    }
    kept_.forget();
    if (budget_.is_due(same_goals, observer != nullptr)) {
      begin_tree();
    } else {
      begin_leaps();
    }
  }

  SearchOutcome step() override { return used_ == nullptr ? ended_ : after(used_->step()); }

  SearchOutcome run() override {
    if (used_ == nullptr) return ended_;
    SearchOutcome outcome = after(used_->run());
    while (outcome == SearchOutcome::running) outcome = after(used_->run());
    return outcome;
  }

  const SearchMetrics& metrics() const override { return metrics_; }

  OpenList open_list(std::size_t most) const override {
    return used_ == nullptr ? OpenList{} : used_->open_list(most);
  }

  double heuristic(const Cell& place) const override {
    return used_ == nullptr ? 0 : used_->heuristic(place);
  }

  void write_path(Path& path) const override {
    if (used_ == nullptr) {
      kept_.write(path);
    } else {
      used_->write_path(path);
      kept_.keep(path.cells(), goals_);
    }
  }

 private:
  /// Has the time passed, or the query been cancelled, before it began?
  static SearchOutcome outcome_without_search(const Limits& limits) {
    Limits no_expansions = limits;
    no_expansions.expansions = Limits::kUnlimited;
    LimitCheck check;
    check.begin(no_expansions);
    return check.look(0);
  }

  void begin_tree() {
    limits_ = *user_limits_;
    tree_limited_ = budget_.expansions() < limits_.expansions;
    limits_.expansions = std::min(limits_.expansions, budget_.expansions());
    used_ = tree_.get();
    used_->begin(start_, goals_, limits_, observer_);
  }

  void begin_leaps() {
    limits_ = *user_limits_;
    if (limits_.timed()) limits_.seconds -= limits_.now() - begun_;
    if (limits_.expansions != Limits::kUnlimited) {
      limits_.expansions -= std::min(limits_.expansions, before_.expanded);
    }
    used_ = leaps_.get();
    used_->begin(start_, goals_, limits_, observer_);
  }

  /// What the outcome of the search in use is for the whole.
  SearchOutcome after(SearchOutcome outcome) {
    count();
    if (outcome == SearchOutcome::running) return outcome;
    const std::uint64_t expanded = used_->metrics().expanded;
    if (used_ == leaps_.get()) {
      budget_.leapt(expanded);
      return outcome;
    }
    if (outcome == SearchOutcome::expansion_limit && tree_limited_) {
      budget_.tree_stopped(expanded);
      before_ = metrics_;
      begin_leaps();
      return SearchOutcome::running;
    }
    budget_.tree_found(expanded);
    return outcome;
  }

  void count() {
    const SearchMetrics& now = used_->metrics();
    metrics_ = {before_.expanded + now.expanded, before_.generated + now.generated,
                std::max(before_.max_frontier, now.max_frontier)};
  }

  std::shared_ptr<const CostGrid<Word>> grid_;
  mutable KeptPath<Word> kept_;
  TreeBudget budget_;
  std::shared_ptr<GridEngine> leaps_;
  std::shared_ptr<GridEngine> tree_;
  GridEngine* used_ = nullptr;                  // null: nothing is searched
  SearchOutcome ended_ = SearchOutcome::found;  // then
  // The present search.
  Cell start_{};
  std::vector<GoalRegion> goals_;
  const Limits* user_limits_ = nullptr;
  double begun_ = 0;
  Limits limits_;              // of the search in use
  bool tree_limited_ = false;  // by the budget
  SearchObserver* observer_ = nullptr;
  SearchMetrics before_;  // of the tree, if it was stopped
  SearchMetrics metrics_;
};

}  // namespace

GridPlanner::Parts replan_parts(const FreeSpace& space, const BestFirst& parts, ReplanSearch search,
                                DeadlineCheck& stop) {
  if (!can_leap(space, parts)) return best_first_parts(space, parts);
  const auto engine_on = [&]<class Word>(const std::shared_ptr<CostGrid<Word>>& grid) {
    return std::make_shared<ReplanEngine<Word>>(grid, parts, search);
  };
  const auto remake = [=](const FreeSpace& other) { return replan_parts(other, parts, search); };
  return cost_grid_parts(space, parts, engine_on, remake, stop);
}

}  // namespace wend
