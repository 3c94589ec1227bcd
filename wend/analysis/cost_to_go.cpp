#include "wend/analysis/cost_to_go.hpp"

#include <algorithm>
#include <limits>

#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/search/forward_search.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/search/search_outcome.hpp"
#include "wend/space/grid/grid_path.hpp"

namespace wend {
namespace {

constexpr std::uint8_t kNoDirection = kDirections;

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

struct RealKeyOf {
  RealKey<double> operator()(double g) const { return {g, g}; }
};

using UniformField = ForwardSearch<ExactGrid, BucketFrontier<ExactKey<std::uint64_t>, 25>,
                                   Everywhere<ExactKeyOf>, DuplicateRule::keep_cheaper>;
using TerrainField = ForwardSearch<TerrainGrid, HeapFrontier<RealKey<double>>,
                                   Everywhere<RealKeyOf>, DuplicateRule::keep_cheaper>;

/// Writes down every cell as it is expanded: then its cost is final.
template <class Space>
class FieldWriter {
 public:
  FieldWriter(Grid<double>& costs, Grid<std::uint8_t>& policy) : costs_(costs), policy_(policy) {}

  void on_expand(const GridState& state, Move arrival, typename Space::Cost g) {
    costs_[state.cell] = static_cast<double>(g) / Space::kUnitsPerCell;
    if (arrival != kNoMove) {
      policy_[state.cell] = static_cast<std::uint8_t>(opposite(static_cast<Direction>(arrival)));
    }
  }
  void on_generate(const GridState&, Move, typename Space::Cost) {}
  void on_relax(const GridState&, Move, typename Space::Cost) {}

 private:
  Grid<double>& costs_;
  Grid<std::uint8_t>& policy_;
};

std::optional<Status> refusal(const FreeSpace& space, std::span<const Cell> goals) {
  if (goals.empty()) return Status::unsupported_query;
  const auto usable = [&](Cell goal) { return space.contains(goal) && space.passable(goal); };
  if (std::ranges::any_of(goals, usable)) return std::nullopt;
  return space.contains(goals.front()) ? Status::goal_blocked : Status::goal_outside;
}

template <class Search>
Status search_everywhere(Search& search, std::span<const Cell> goals, const Limits& limits,
                         Grid<double>& costs, Grid<std::uint8_t>& policy, SearchMetrics& metrics) {
  std::vector<GridState> starts;
  starts.reserve(goals.size());
  const FreeSpace& space = search.space().free_space();
  for (const Cell goal : goals) {
    if (space.contains(goal) && space.passable(goal)) starts.push_back(search.space().state(goal));
  }
  FieldWriter<typename Search::SpaceType> writer(costs, policy);
  search.begin(starts, limits, writer);
  const SearchOutcome outcome = search.run(writer);
  metrics = search.metrics();
  return outcome == SearchOutcome::exhausted ? Status::found : status_of(outcome);
}

Unexpected<PlanFailure> failed(Status status, const SearchMetrics& metrics = {}) {
  return Unexpected<PlanFailure>({{status, std::string(describe(status))}, metrics});
}

}  // namespace

Expected<CostToGo, PlanFailure> CostToGo::make(const FreeSpace& space, std::span<const Cell> goals,
                                               GridMoves moves, const Limits& limits) {
  if (const auto status = refusal(space, goals)) return failed(*status);
  CostToGo field(space);
  field.costs_ = {space.width(), space.height(), std::numeric_limits<double>::infinity()};
  field.policy_ = {space.width(), space.height(), kNoDirection};
  Status status = Status::found;
  if (space.uniform_terrain()) {
    UniformField search(ExactGrid(space, moves, MoveTable::Pruning::canonical), {});
    status = search_everywhere(search, goals, limits, field.costs_, field.policy_, field.metrics_);
  } else {
    TerrainField search(TerrainGrid(space, moves), {});
    status = search_everywhere(search, goals, limits, field.costs_, field.policy_, field.metrics_);
  }
  if (status != Status::found) return failed(status, field.metrics_);
  return field;
}

std::optional<Direction> CostToGo::policy(Cell cell) const {
  if (policy_[cell] == kNoDirection) return std::nullopt;
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
