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

#include "wend/planner/costs/cost_grid_parts.hpp"
#include "wend/planner/costs/integer_search.hpp"
#include "wend/planner/costs/leap_engine.hpp"
#include "wend/planner/costs/whole_estimate.hpp"
#include "wend/planner/incremental/consistent_nodes.hpp"
#include "wend/planner/incremental/incremental_options.hpp"
#include "wend/planner/incremental/kept_roots.hpp"

namespace wend {
namespace {

template <class Word, class Units>
class DStarLite final : public IntegerSearch {
 public:
  DStarLite(std::shared_ptr<const CostGrid<Word>> its_grid, const BestFirst& parts)
      : grid_(std::move(its_grid)),
        estimate_(parts, grid().least_steps()),
        nodes_(grid().state_count()) {}

  bool allocated() const override { return nodes_.allocated(); }
  bool expects_a_path() const override { return true; }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    if (!begin_counting(limits, observer)) return;
    begin_at(start, goals);
    count_open(nodes_.open_count());
  }

  SearchOutcome step() override { return advance(true); }
  SearchOutcome run() override {
    return outcome() == SearchOutcome::running ? advance(false) : outcome();
  }

  OpenList open_list(std::size_t most) const override {
    OpenList list;
    if (outcome() != SearchOutcome::running) return list;
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
    path.append(grid().cell(id));
    while (nodes_.rhs(id) != 0) {
      id = best_successor(id).id;
      path.append(grid().cell(id));
    }
  }

 private:
  using Grid = CostGrid<Word>;
  static constexpr std::uint64_t kNever = ConsistentNodes::kNever;

  struct Successor {
    StateId id;
    std::uint64_t cost;  // of the path by way of it
  };

  const Grid& grid() const { return *grid_; }

  void begin_at(const Cell& start, std::span<const GoalRegion> goals) {
    const auto changes = roots_.take(grid(), goals);
    const Cell before = grid().cell(start_);
    start_ = grid().number(start);
    const GoalRegion here(start);
    estimate_.begin({&here, 1});
    if (!changes) return plant();
    moved_ += estimate_.units(before);
    for (const auto& change : *changes) {
      update_from_successors(change.id);
      for (unsigned direction = 0; direction < kDirections; ++direction) {
        update_from_successors(grid().neighbour(change.id, direction));
      }
    }
  }

  void plant() {
    moved_ = 0;
    estimate_.set_least_steps(grid().least_steps());
    nodes_.begin();
    roots_.for_each(grid(), [&](StateId id) { set_rhs(id, 0); });
  }

  ConsistentNodes::Key key_of(StateId id) const {
    const std::uint64_t cost = std::min(nodes_.g(id), nodes_.rhs(id));
    if (cost == kNever) return {kNever, kNever};
    return {cost + estimate_.units(grid().cell(id)) + moved_, cost};
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
    count_reached(id, !first);
  }

  template <class Visit>
  void for_each_neighbour(StateId id, Visit&& visit) const {
    const Word word = grid().word(id);
    if (word == 0) return;
    unsigned moves = grid().moves(kNoMove, word);
    for (; moves != 0; moves &= moves - 1) {
      const auto direction = static_cast<unsigned>(std::countr_zero(moves));
      const StateId next = grid().neighbour(id, direction);
      const std::uint64_t sum = Grid::steps(word) + Grid::steps(grid().word(next));
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

  bool is_root(StateId id) const { return roots_.contains(grid().cell(id)); }

  void update_from_successors(StateId id) {
    if (!nodes_.touched(id) && grid().word(id) == 0) return;
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

  SearchOutcome advance(bool once) {
    do {
      expand_next();
    } while (!once && outcome() == SearchOutcome::running);
    return outcome();
  }

  /// Expands one cell, or ends the search.
  [[gnu::always_inline]] void expand_next() {
    while (!nodes_.empty()) {
      const ConsistentNodes::Key least = nodes_.least_key();
      if (!must_expand(least)) break;
      const StateId id = nodes_.least();
      if (const auto key = key_of(id); least < key) {
        nodes_.update(id, key);
        continue;
      }
      if (stopped()) return;
      expand(id);
      return;
    }
    if (nodes_.rhs(start_) == kNever) return end(SearchOutcome::exhausted);
    if (ends_with_start()) {
      if (stopped()) return;
      count_expansion(start_);
    }
    end(SearchOutcome::found);
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
    count_open(nodes_.open_count());
  }

  CellArrival arrival_of(StateId id) const override {
    const std::uint64_t cost = std::min(nodes_.g(id), nodes_.rhs(id));
    const double units_per_cell = 2.0 * static_cast<double>(grid().one()) * Units::kStraight;
    const double g = cost == kNever ? std::numeric_limits<double>::infinity()
                                    : static_cast<double>(cost) / units_per_cell;
    const Cell cell = grid().cell(id);
    CellArrival arrival{cell, g, estimate_.cells(cell), {}};
    if (nodes_.rhs(id) == 0) return arrival;
    if (const Successor best = best_successor(id); best.id != id) {
      arrival.parent = grid().cell(best.id);
    }
    return arrival;
  }

  std::shared_ptr<const Grid> grid_;
  WholeEstimate<Units> estimate_;  // to the start
  ConsistentNodes nodes_;
  KeptRoots<Word> roots_;
  std::uint64_t moved_ = 0;  // km
  StateId start_ = 0;
};

GridPlanner::Parts d_star_lite_parts(const FreeSpace& space, const DStarLiteOptions& options,
                                     DeadlineCheck& stop) {
  const HeuristicKind kind = resolved(HeuristicKind::automatic, options.moves.connectivity);
  const BestFirst parts{options.moves, kind, 0, 1};
  if (!can_leap(space, parts)) return best_first_parts(space, parts);
  const auto engine_on = [&]<class Word>(const std::shared_ptr<CostGrid<Word>>& grid) {
    std::shared_ptr<GridEngine> engine;
    if (grid->one() == 1) {
      engine = std::make_shared<DStarLite<Word, OctileUnits<std::uint64_t>>>(grid, parts);
    } else {
      engine = std::make_shared<DStarLite<Word, CostUnits>>(grid, parts);
    }
    return engine;
  };
  const auto remake = [options](const FreeSpace& other) {
    return d_star_lite_parts(other, options, DeadlineCheck::never());
  };
  return cost_grid_parts(space, parts, engine_on, remake, stop);
}

}  // namespace

PlannerInfo d_star_lite_planner() {
  return grid_planner<DStarLiteOptions>(
      {.name = "d_star_lite",
       .summary = "D* Lite: repairs its search after changes",
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
      d_star_lite_parts);
}

}  // namespace wend
