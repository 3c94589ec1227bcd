#include "wend/analysis/cost_to_go.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "wend/base/deadline.hpp"
#include "wend/base/large_pages.hpp"
#include "wend/planner/costs/cost_field.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/search/search_outcome.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

constexpr std::uint8_t kNoDirection = kDirections;

/// By a Move from the goal.
constexpr auto kWaysBack = [] {
  std::array<std::uint8_t, kNoMove + 1> ways{};
  ways.fill(kNoDirection);
  for (unsigned i = 0; i < kDirections; ++i) {
    ways[i] = static_cast<std::uint8_t>(opposite(static_cast<Direction>(i)));
  }
  return ways;
}();

/// The priority of a search that goes everywhere: g, and no cell is a goal.
template <class KeyOf>
struct Everywhere {
  using Key = decltype(KeyOf{}(0));

  Key key(const GridState& /*state*/, auto g) const { return KeyOf{}(g); }
  bool is_goal(const GridState& /*state*/) const { return false; }
  bool near_overflow(const Key& /*key*/) const { return false; }
};

struct ExactKeyOf {
  ExactKey<std::uint64_t> operator()(std::uint64_t g) const { return {g, g}; }
};

using UniformField = ForwardSearch<ExactGrid, BucketFrontier<ExactKey<std::uint64_t>, 25>,
                                   Everywhere<ExactKeyOf>, DuplicateRule::keep_cheaper>;
using TerrainField = ForwardSearch<TerrainGrid, HeapFrontier<ExactKey<std::uint64_t>>,
                                   Everywhere<ExactKeyOf>, DuplicateRule::keep_cheaper>;

/// Writes down every cell as it is expanded: then its cost is final. On cells with costs it adds the exact
/// cost of the last step.
template <class Space>
class FieldWriter {
 public:
  FieldWriter(const FreeSpace& space, Grid<double>& costs, Grid<std::uint8_t>& policy)
      : space_(space), costs_(costs), policy_(policy) {
    costs = {space.width(), space.height(), std::numeric_limits<double>::infinity()};
    policy = {space.width(), space.height(), kNoDirection};
  }

  void on_expand(const GridState& state, Move arrival, typename Space::Cost g) {
    costs_[state.cell] = static_cast<double>(g) / Space::kUnitsPerCell;
    if (arrival == kNoMove) return;
    const Direction back = opposite(static_cast<Direction>(arrival));
    policy_[state.cell] = static_cast<std::uint8_t>(back);
    if (space_.uniform_terrain()) return;
    const std::array way{state.cell, step(state.cell, back)};
    costs_[way[0]] = costs_[way[1]] + grid_path_cost(space_, way);
  }
  void on_generate(const GridState&, Move, typename Space::Cost) {}
  void on_relax(const GridState&, Move, typename Space::Cost) {}

 private:
  const FreeSpace& space_;
  Grid<double>& costs_;
  Grid<std::uint8_t>& policy_;
};

std::optional<Status> refusal(const FreeSpace& space, std::span<const Cell> goals) {
  if (goals.empty()) return Status::unsupported_query;
  const auto usable = [&](Cell goal) { return space.contains(goal) && space.passable(goal); };
  if (std::ranges::any_of(goals, usable)) return std::nullopt;
  return space.contains(goals.front()) ? Status::goal_blocked : Status::goal_outside;
}

/// Cell by cell, where a disc may cut corners, or costs differ too much.
template <class Search>
Status search_everywhere(Search& search, std::span<const Cell> goals, const Limits& limits,
                         Grid<double>& costs, Grid<std::uint8_t>& policy, SearchMetrics& metrics) {
  std::vector<GridState> starts;
  starts.reserve(goals.size());
  for (const Cell goal : goals) starts.push_back(search.space().state(goal));
  FieldWriter<typename Search::SpaceType> writer(search.space().free_space(), costs, policy);
  search.begin(starts, limits, writer);
  const SearchOutcome outcome = search.run(writer);
  metrics = search.metrics();
  return outcome == SearchOutcome::exhausted ? Status::found : status_of(outcome);
}

/// What a field writes down.
struct FieldParts {
  Grid<double>& costs;
  Grid<std::uint8_t>& policy;
  SearchMetrics& metrics;
};

/// A grid that is appended row by row, so that its memory is touched once.
template <class Value>
class GrowingGrid {
 public:
  GrowingGrid(int width, int height)
      : width_(width), height_(height), row_(static_cast<std::size_t>(width)) {
    const std::size_t cells = row_.size() * static_cast<std::size_t>(height);
    values_.reserve(cells);
    ask_for_large_pages(values_.data(), cells * sizeof(Value));
  }

  /// The row to write, every cell of it.
  std::span<Value> row() { return row_; }
  void append() { values_.insert(values_.end(), row_.begin(), row_.end()); }
  Grid<Value> take() && { return {width_, height_, std::move(values_)}; }

 private:
  int width_;
  int height_;
  std::vector<Value> row_;
  std::vector<Value> values_;
};

SearchOutcome outcome_of(const DeadlineCheck& stop) {
  return stop.deadline()->status() == Status::cancelled ? SearchOutcome::cancelled
                                                        : SearchOutcome::time_limit;
}

template <class Field>
SearchOutcome fill(Field field, const FreeSpace& space, std::span<const Cell> goals,
                   const Deadline& deadline, const FieldParts& parts) {
  const SearchOutcome outcome = field.run(goals, deadline.left());
  parts.metrics = field.metrics();
  if (outcome != SearchOutcome::exhausted) return outcome;
  GrowingGrid<double> costs(space.width(), space.height());
  GrowingGrid<std::uint8_t> policy(space.width(), space.height());
  DeadlineCheck stop(&deadline);
  for (int y = 0; y < space.height(); ++y) {
    if (stop.now()) return outcome_of(stop);
    for (int x = 0; x < space.width(); ++x) {
      const auto at = static_cast<std::size_t>(x);
      costs.row()[at] = field.cost({x, y});
      policy.row()[at] = kWaysBack[field.arrival({x, y})];
    }
    costs.append();
    policy.append();
  }
  parts.costs = std::move(costs).take();
  parts.policy = std::move(policy).take();
  return outcome;
}

/// In nodes of 64 bits, or wide ones if these do not do.
template <class Word, class Units, class WideUnits>
Status fill_by(const FreeSpace& space, const CostGrid<Word>& grid, std::span<const Cell> goals,
               const Deadline& deadline, const FieldParts& parts) {
  SearchOutcome outcome =
      fill(CostField<std::uint64_t, Word, Units>(grid), space, goals, deadline, parts);
  if (outcome == SearchOutcome::cost_overflow) {
    outcome =
        fill(CostField<WideFieldNumber, Word, WideUnits>(grid), space, goals, deadline, parts);
  }
  return outcome == SearchOutcome::exhausted ? Status::found : status_of(outcome);
}

template <class Word>
std::optional<Status> fill_fast(const FreeSpace& space, std::span<const Cell> goals,
                                GridMoves moves, const Deadline& deadline,
                                const FieldParts& parts) {
  DeadlineCheck stop(&deadline);
  const CostGrid<Word> grid(space, moves, stop);
  if (stop.has_passed()) return deadline.status();
  if (!CostField<std::uint64_t, Word, CostUnits>::suits(grid)) return std::nullopt;
  if constexpr (sizeof(Word) == sizeof(std::uint32_t)) {
    if (space.uniform_terrain()) {
      return fill_by<Word, OctileUnits<std::uint32_t>, OctileUnits<std::uint64_t>>(
          space, grid, goals, deadline, parts);
    }
  }
  return fill_by<Word, CostUnits, CostUnits>(space, grid, goals, deadline, parts);
}

/// Nothing if the fast way does not suit the map.
std::optional<Status> fill_fast(const FreeSpace& space, std::span<const Cell> goals,
                                GridMoves moves, const Deadline& deadline,
                                const FieldParts& parts) {
  if (sweeps_diagonals(space, moves)) return std::nullopt;
  if (!CostGrid<std::uint32_t>::holds(space.costs())) {
    return fill_fast<std::uint64_t>(space, goals, moves, deadline, parts);
  }
  return fill_fast<std::uint32_t>(space, goals, moves, deadline, parts);
}

Unexpected<PlanFailure> failed(Status status, const SearchMetrics& metrics = {}) {
  return Unexpected<PlanFailure>({{status, std::string(describe(status))}, metrics});
}

}  // namespace

Expected<CostToGo, PlanFailure> CostToGo::make(const FreeSpace& space, std::span<const Cell> goals,
                                               GridMoves moves, const Limits& limits) {
  if (const auto status = refusal(space, goals)) return failed(*status);
  CostToGo field(space);
  std::vector<Cell> usable;
  std::ranges::copy_if(goals, std::back_inserter(usable),
                       [&](Cell goal) { return space.passable(goal); });
  const FieldParts parts{field.costs_, field.policy_, field.metrics_};
  Status status = Status::found;
  if (const auto fast = fill_fast(space, usable, moves, Deadline(limits), parts)) {
    status = *fast;
  } else if (space.uniform_terrain()) {
    UniformField search(ExactGrid(space, moves), {});
    status = search_everywhere(search, usable, limits, field.costs_, field.policy_, field.metrics_);
  } else {
    TerrainField search(TerrainGrid(space, moves), {});
    status = search_everywhere(search, usable, limits, field.costs_, field.policy_, field.metrics_);
  }
  if (status != Status::found) return failed(status, field.metrics_);
  return field;
}

std::optional<Direction> CostToGo::policy(Cell cell) const {
  if (!policy_.contains(cell) || policy_[cell] == kNoDirection) return std::nullopt;
  return static_cast<Direction>(policy_[cell]);
}

Expected<Plan, PlanFailure> CostToGo::path_from(Cell start) const {
  if (!space_.contains(start)) return failed(Status::start_outside);
  if (!space_.passable(start)) return failed(Status::start_blocked);
  if (costs_[start] == std::numeric_limits<double>::infinity()) {
    return failed(Status::unreachable);
  }
  Plan plan;
  plan.path.append(start);
  for (Cell cell = start; const auto direction = policy(cell);) {
    cell = step(cell, *direction);
    plan.path.append(cell);
  }
  plan.cost = grid_path_cost(space_, plan.path.cells());
  plan.bound = 1;
  return plan;
}

}  // namespace wend
