// D* Lite: S. Koenig and M. Likhachev, "D* Lite", AAAI 2002, in its final version: a heuristic search backwards
// from the goal that repairs what changed edges make inconsistent.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/grid/cost_grid.hpp"
#include "wend/planner/grid/leap_engine.hpp"
#include "wend/planner/grid/whole_estimate.hpp"
#include "wend/planner/incremental/consistent_nodes.hpp"
#include "wend/planner/incremental/incremental_options.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/space/grid/cost_units.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {
namespace {

template <class Word, class Units>
class DStarLite final : public GridEngine {
 public:
  DStarLite(std::shared_ptr<const CostGrid<Word>> grid, const BestFirst& parts)
      : grid_(std::move(grid)),
        estimate_(parts, grid_->least_steps()),
        nodes_(grid_->state_count()) {}

  bool allocated() const override { return nodes_.allocated(); }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    limits_.begin(limits);
    observer_ = observer;
    metrics_ = {};
    outcome_ = allocated() ? SearchOutcome::running : SearchOutcome::out_of_memory;
    if (!allocated()) return;
    begin_at(start, goals);
    metrics_.max_frontier = nodes_.open_count();
  }

  SearchOutcome step() override {
    advance();
    return outcome_;
  }

  SearchOutcome run() override {
    while (outcome_ == SearchOutcome::running) advance();
    return outcome_;
  }

  const SearchMetrics& metrics() const override { return metrics_; }

  OpenList open_list(std::size_t most) const override {
    OpenList list;
    if (outcome_ != SearchOutcome::running) return list;
    auto order = nodes_.in_order([this](StateId id) { return key_of(id); });
    if (order.empty() || !must_expand(key_of(order.front()))) {
      if (!ends_with_start()) return list;
      std::erase(order, start_);
      order.insert(order.begin(), start_);
    }
    list.count = order.size();
    order.resize(std::min(most, order.size()));
    for (const StateId id : order) list.entries.push_back({event_of(id), OpenTie::none});
    return list;
  }

  double heuristic(const Cell& place) const override { return estimate_.cells(place); }

  void write_path(Path& path) const override {
    path.clear();
    StateId id = start_;
    path.append(grid_->cell(id));
    while (nodes_.rhs(id) != 0) {
      id = best_successor(id).id;
      path.append(grid_->cell(id));
    }
  }

 private:
  using Grid = CostGrid<Word>;
  static constexpr std::uint64_t kNever = ConsistentNodes::kNever;

  struct Successor {
    StateId id;
    std::uint64_t cost;  // of the path by way of it
  };

  void begin_at(const Cell& start, std::span<const GoalRegion> goals) {
    const auto changes = grid_->changes_since(log_position_);
    const Cell before = started_ ? grid_->cell(start_) : start;
    log_position_ = grid_->log_end();
    start_ = grid_->number(start);
    const GoalRegion here(start);
    const bool keeps = started_ && changes && least_steps_ == grid_->least_steps() &&
                       std::ranges::equal(goals, goals_) && !changes_a_root(*changes);
    if (!keeps) {
      estimate_.begin({&here, 1});
      plant(goals);
      return;
    }
    const GoalRegion there(start);
    estimate_.begin({&there, 1});
    moved_ += estimate_.units(before);
    for (const auto& change : *changes) {
      update_from_successors(change.id);
      for (unsigned direction = 0; direction < kDirections; ++direction) {
        update_from_successors(grid_->neighbour(change.id, direction));
      }
    }
  }

  void plant(std::span<const GoalRegion> goals) {
    started_ = true;
    moved_ = 0;
    least_steps_ = grid_->least_steps();
    estimate_.set_least_steps(least_steps_);
    goals_.assign(goals.begin(), goals.end());
    nodes_.begin();
    const CellBox map{{0, 0}, {grid_->width(), grid_->height()}};
    for (const GoalRegion& goal : goals) {
      goal.for_each([&](Cell cell) {
        const StateId id = map.contains(cell) ? grid_->number(cell) : 0;
        if (grid_->word(id) == 0 || nodes_.rhs(id) == 0) return;
        set_rhs(id, 0);
      });
    }
  }

  bool changes_a_root(std::span<const typename Grid::Change> changes) const {
    return std::ranges::any_of(changes, [&](const auto& change) {
      return Grid::steps(change.before) != Grid::steps(grid_->word(change.id)) &&
             any_contains(goals_, grid_->cell(change.id));
    });
  }

  ConsistentNodes::Key key_of(StateId id) const {
    const std::uint64_t cost = std::min(nodes_.g(id), nodes_.rhs(id));
    if (cost == kNever) return {kNever, kNever};
    return {cost + estimate_.units(grid_->cell(id)) + moved_, cost};
  }

  /// Opens an inconsistent node, or moves it; closes a consistent one.
  void update(StateId id) { nodes_.update(id, key_of(id)); }

  void set_rhs(StateId id, std::uint64_t rhs) {
    const std::uint64_t before = nodes_.rhs(id);
    if (rhs == before) return;
    const bool first = !nodes_.touched(id);
    nodes_.set_rhs(id, rhs);
    update(id);
    if (rhs > before) return;
    metrics_.generated += first ? 1 : 0;
    if (observer_ != nullptr) tell_reached(id, !first);
  }

  template <class Visit>
  void for_each_neighbour(StateId id, Visit&& visit) const {
    const Word word = grid_->word(id);
    if (word == 0) return;
    unsigned moves = grid_->moves(kNoMove, word);
    for (; moves != 0; moves &= moves - 1) {
      const auto direction = static_cast<unsigned>(std::countr_zero(moves));
      const StateId next = grid_->neighbour(id, direction);
      const std::uint64_t sum = Grid::steps(word) + Grid::steps(grid_->word(next));
      visit(next, sum * ((direction & 1U) != 0 ? Units::kDiagonal : Units::kStraight));
    }
  }

  Successor best_successor(StateId id) const {
    Successor best{id, kNever};
    for_each_neighbour(id, [&](StateId next, std::uint64_t cost) {
      const std::uint64_t g = nodes_.g(next);
      if (g != kNever && g + cost < best.cost) best = {next, g + cost};
    });
    return best;
  }

  bool is_root(StateId id) const { return any_contains(goals_, grid_->cell(id)); }

  void update_from_successors(StateId id) {
    if (!nodes_.touched(id) && grid_->word(id) == 0) return;
    if (!is_root(id)) set_rhs(id, best_successor(id).cost);
  }

  /// Can an open node with the least key lead to the start more cheaply?
  bool must_expand(ConsistentNodes::Key least) const {
    return least < key_of(start_) || nodes_.rhs(start_) > nodes_.g(start_);
  }

  /// Is the start, which has its cost from its neighbours, what is expanded last?
  bool ends_with_start() const {
    return nodes_.rhs(start_) != kNever && nodes_.g(start_) != nodes_.rhs(start_);
  }

  void advance() {
    while (!nodes_.empty()) {
      const ConsistentNodes::Key least = nodes_.least_key();
      if (!must_expand(least)) break;
      const StateId id = nodes_.least();
      if (const auto key = key_of(id); least < key) {
        nodes_.update(id, key);
        continue;
      }
      if (limits_.due(metrics_.expanded)) {
        outcome_ = limits_.look(metrics_.expanded);
        if (outcome_ != SearchOutcome::running) return;
      }
      expand(id);
      return;
    }
    const bool found = nodes_.rhs(start_) != kNever;
    outcome_ = found ? SearchOutcome::found : SearchOutcome::exhausted;
    if (!ends_with_start()) return;
    if (limits_.due(metrics_.expanded)) outcome_ = limits_.look(metrics_.expanded);
    if (outcome_ == SearchOutcome::running) outcome_ = SearchOutcome::found;
    if (outcome_ == SearchOutcome::found) count_expansion(start_);
  }

  void expand(StateId id) {
    count_expansion(id);
    const std::uint64_t before = nodes_.g(id);
    if (const std::uint64_t rhs = nodes_.rhs(id); before > rhs) {
      nodes_.set_g(id, rhs);
      update(id);
      for_each_neighbour(id, [&](StateId next, std::uint64_t cost) {
        if (rhs + cost < nodes_.rhs(next)) set_rhs(next, rhs + cost);
      });
    } else {
      nodes_.set_g(id, kNever);
      update(id);
      for_each_neighbour(id, [&](StateId next, std::uint64_t cost) {
        if (nodes_.rhs(next) == before + cost && !is_root(next)) {
          set_rhs(next, best_successor(next).cost);
        }
      });
    }
    metrics_.max_frontier = std::max<std::uint64_t>(metrics_.max_frontier, nodes_.open_count());
  }

  void count_expansion(StateId id) {
    ++metrics_.expanded;
    if (observer_ != nullptr) observer_->on_expand(event_of(id));
  }

  [[gnu::noinline]] void tell_reached(StateId id, bool again) {
    if (again) {
      observer_->on_relax(event_of(id));
    } else {
      observer_->on_generate(event_of(id));
    }
  }

  SearchEvent event_of(StateId id) const {
    const Cell cell = grid_->cell(id);
    const double per_cell = 2.0 * static_cast<double>(grid_->one()) * Units::kStraight;
    const std::uint64_t cost = std::min(nodes_.g(id), nodes_.rhs(id));
    const double g = cost == kNever ? std::numeric_limits<double>::infinity()
                                    : static_cast<double>(cost) / per_cell;
    const double h = estimate_.cells(cell);
    SearchEvent event{{}, {}, g, h, g + h};
    event.cell = cell;
    if (nodes_.rhs(id) == 0) return event;
    if (const Successor best = best_successor(id); best.id != id) {
      event.parent = grid_->cell(best.id);
    }
    return event;
  }

  std::shared_ptr<const Grid> grid_;
  WholeEstimate<Units> estimate_;  // to the start
  ConsistentNodes nodes_;
  std::vector<GoalRegion> goals_;
  bool started_ = false;
  std::uint64_t log_position_ = 0;
  std::uint64_t least_steps_ = 0;
  std::uint64_t moved_ = 0;  // km
  StateId start_ = 0;
  LimitCheck limits_;
  SearchObserver* observer_ = nullptr;
  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
};

GridPlanner::Parts choose_parts(const FreeSpace& space, const DStarLiteOptions& options);

template <class Word>
GridPlanner::Parts parts_with(const std::shared_ptr<CostGrid<Word>>& grid,
                              const std::shared_ptr<GridEngine>& engine,
                              const DStarLiteOptions& options) {
  GridPlanner::Parts made{options.moves, engine, 1};
  made.repaired = [=](const FreeSpace& space, const SpaceChange& change) {
    if (!grid->can_become(space)) return choose_parts(space, options);
    grid->repair(space, change);
    return parts_with(grid, engine, options);
  };
  return made;
}

template <class Word>
GridPlanner::Parts parts_on(const FreeSpace& space, const BestFirst& parts,
                            const DStarLiteOptions& options) {
  const auto grid = std::make_shared<CostGrid<Word>>(space, parts.moves);
  std::shared_ptr<GridEngine> engine;
  if (grid->one() == 1) {
    engine = std::make_shared<DStarLite<Word, OctileUnits<std::uint64_t>>>(grid, parts);
  } else {
    engine = std::make_shared<DStarLite<Word, CostUnits>>(grid, parts);
  }
  return parts_with(grid, engine, options);
}

GridPlanner::Parts choose_parts(const FreeSpace& space, const DStarLiteOptions& options) {
  const HeuristicKind kind = resolved(HeuristicKind::automatic, options.moves.connectivity);
  const BestFirst parts{options.moves, kind, 0, 1};
  if (!can_leap(space, parts)) return best_first_parts(space, parts);
  if (CostGrid<std::uint32_t>::holds(space.costs())) {
    return parts_on<std::uint32_t>(space, parts, options);
  }
  return parts_on<std::uint64_t>(space, parts, options);
}

}  // namespace

PlannerInfo d_star_lite_planner() {
  return grid_planner<DStarLiteOptions>(
      {.name = "d_star_lite",
       .summary =
           "D* Lite: repairs its last search, backwards from the goal, after changes of the map",
       .idea = "Each cell has its cost to the goal and the one that its neighbours imply. A change "
               "makes some "
               "cells inconsistent; the search expands these, in the order of A*, as far as the "
               "robot's path "
               "needs it.",
       .citation = "Koenig, Likhachev 2002",
       .guarantee_text = "optimal; on terrain at most 1.5e-6 of the cost more",
       .time =
           "O(k log k) in the k cells that become inconsistent; the first query as A*, backwards",
       .memory = "29 bytes per cell, 4 per frontier entry",
       .bytes_per_cell = 29,
       .when = "To learn or compare. replanner answers the same queries and is faster. Where a "
               "disc may cut corners "
               "it searches anew, as astar.",
       .guarantee = Guarantee::optimal,
       .capabilities = {.terrain = true, .resumes = true}},
      choose_parts);
}

}  // namespace wend
