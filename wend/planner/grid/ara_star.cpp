// ARA*: M. Likhachev, G. Gordon and S. Thrun, "ARA*: Anytime A* with Provable Bounds on Sub-Optimality", NIPS
// 2003. A LeapSearch in rounds; where a disc may cut corners, a ForwardSearch.

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <type_traits>

#include "wend/planner/costs/leap_engine.hpp"
#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/grid/grid_options.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/planner/jump/prepared_jumps.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/search_engine.hpp"

namespace wend {
namespace {

/// What a step costs at least, in the whole numbers of a GridSpace.
template <class Space>
struct LeastStep {
  static constexpr std::uint64_t kStraight = OctileUnits<std::uint64_t>::kStraight;
  static constexpr std::uint64_t kDiagonal = OctileUnits<std::uint64_t>::kDiagonal;
};

template <>
struct LeastStep<TerrainGrid> {
  static constexpr std::uint64_t kStraight = 2 * CostMap::kOne * CostUnits::kStraight;
  static constexpr std::uint64_t kDiagonal = 2 * CostMap::kOne * CostUnits::kDiagonal;
};

/// f = g + w h, where h is the cost of a way without obstacles, in whole numbers.
template <class Space>
class WeightedEstimate : public TowardsGoals {
 public:
  using Cost = typename Space::Cost;
  using Key = RealKey<Cost>;

  explicit WeightedEstimate(HeuristicKind kind)
      : shorter_(kind == HeuristicKind::manhattan ? Least::kStraight
                                                  : Least::kDiagonal - Least::kStraight) {}

  void weigh(double weight) { weight_ = weight; }

  Key key(const GridState& state, Cost g) const {
    return {static_cast<double>(g) + weight_ * static_cast<double>(units(state.cell)), g};
  }
  Cost total(const GridState& state, Cost g) const { return g + units(state.cell); }
  bool near_overflow(const Key& /*key*/) const { return false; }

  double h(Cell cell) const { return static_cast<double>(units(cell)) / Space::kUnitsPerCell; }
  double f(Cell cell, double g) const { return g + weight_ * h(cell); }

 private:
  using Least = LeastStep<Space>;

  Cost units(Cell cell) const {
    return goals_.least(cell, [&](Cell goal) {
      const auto dx = static_cast<Cost>(std::abs(cell.x - goal.x));
      const auto dy = static_cast<Cost>(std::abs(cell.y - goal.y));
      return Least::kStraight * std::max(dx, dy) + shorter_ * std::min(dx, dy);
    });
  }

  Cost shorter_;
  double weight_ = 1;
};

template <class Space>
std::unique_ptr<GridEngine> make_engine(const FreeSpace& space, const AraStarOptions& options) {
  using Engine = AnytimeEngineOf<GridEngine, GridNames, Space, WeightedEstimate<Space>>;
  const HeuristicKind kind = resolved(HeuristicKind::automatic, options.moves.connectivity);
  return std::make_unique<Engine>(Space(space, options.moves), WeightedEstimate<Space>(kind),
                                  AnytimeWeights{options.initial_weight, options.weight_step});
}

GridPlanner::Parts ara_star_parts(const FreeSpace& space, const AraStarOptions& options,
                                  DeadlineCheck& stop) {
  const HeuristicKind kind = resolved(HeuristicKind::automatic, options.moves.connectivity);
  const bool noise =
      space.uniform_terrain() && PreparedJumps::of(space)->is_noise(space.passable());
  const BestFirst parts{options.moves, kind, 0, 1, options.leaps && !noise};
  if (can_leap(space, parts)) {
    return anytime_leap_parts(space, parts, {options.initial_weight, options.weight_step}, stop);
  }
  auto engine = space.uniform_terrain() ? make_engine<ExactGrid>(space, options)
                                        : make_engine<TerrainGrid>(space, options);
  return {options.moves, std::move(engine), Plan::kNoBound};
}

}  // namespace

PlannerInfo ara_star_planner() {
  return grid_planner<AraStarOptions>(
      {.name = "ara_star",
       .summary = "ARA*: a path soon, then cheaper ones",
       .idea = "A* with a large weight finds a path after few cells. The next search takes a "
               "smaller weight, and "
               "expands only cells whose cost has fallen and those that were left open. With the "
               "time or the "
               "expansions used up, the answer is the best path so far.",
       .citation = "Likhachev, Gordon, Thrun 2003",
       .guarantee_text = "optimal without a limit; at a limit the bound of the answer is proven; "
                         "on terrain at most "
                         "1.5e-6 of the cost more",
       .time = "O(n log n) in the n cells expanded; a cell may be expanded once for each weight",
       .memory = "21 bytes per cell, 16 per frontier entry; on terrain 17 and 8, or 21 and 16 if "
                 "sums of costs "
                 "outgrow 32 bits; 16 and 24 where a disc may cut corners",
       .bytes_per_cell = 21,
       .when = "When an answer is due at a fixed time, whatever the map. Until the path is optimal "
               "it does more "
               "work than astar.",
       .guarantee = Guarantee::bounded,
       .capabilities = {.jumps = true, .leaps = true, .terrain = true, .anytime = true}},
      ara_star_parts);
}

}  // namespace wend
