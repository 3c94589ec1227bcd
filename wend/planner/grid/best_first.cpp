#include "wend/planner/grid/best_first.hpp"

#include <algorithm>

#include "wend/planner/costs/leap_engine.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/planner/grid/ordered_engine.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/widening_engine.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/space/grid/grid_space.hpp"

namespace wend {
namespace {

// A bucket is about 1/64 of a straight step wide. A step raises f by at most 2 sqrt(2) cells, some
// 185 of the ring's 256 buckets.
template <class Cost>
inline constexpr unsigned kBucketBits = sizeof(Cost) == sizeof(std::uint32_t) ? 9 : 25;

template <class Space>
using Exact =
    GridEngineOf<Space,
                 BucketFrontier<ExactKey<typename Space::Cost>, kBucketBits<typename Space::Cost>>,
                 ExactEstimate<typename Space::Cost>, DuplicateRule::keep_cheaper>;

template <class Space>
using Real = GridEngineOf<Space, HeapFrontier<RealKey<typename Space::Cost>>, RealEstimate<Space>,
                          DuplicateRule::keep_cheaper>;

template <class Space>
std::unique_ptr<GridEngine> make_exact(const FreeSpace& space, const BestFirst& parts) {
  const HeuristicKind kind = parts.weight > 0 ? parts.heuristic : HeuristicKind::zero;
  return std::make_unique<Exact<Space>>(Space(space, parts.moves, MoveTable::Pruning::canonical),
                                        ExactEstimate<typename Space::Cost>(kind, parts.constant));
}

/// Is the map so large that even the estimates outgrow 32 bits?
bool too_far(const FreeSpace& space) {
  constexpr int kFarthest = UINT32_MAX / OctileUnits<std::uint32_t>::kDiagonal / 4;
  return std::max(space.width(), space.height()) > kFarthest;
}

std::unique_ptr<GridEngine> make_whole(const FreeSpace& space, const BestFirst& parts) {
  if (too_far(space)) return make_exact<ExactGrid>(space, parts);
  return std::make_unique<WideningEngine<GridEngine>>(
      space, [&](const FreeSpace& here) { return make_exact<CompactGrid>(here, parts); },
      [parts](const FreeSpace& here) { return make_exact<ExactGrid>(here, parts); });
}

template <class Space>
std::unique_ptr<GridEngine> make_real(const FreeSpace& space, const BestFirst& parts,
                                      MoveTable::Pruning pruning) {
  return std::make_unique<Real<Space>>(
      Space(space, parts.moves, pruning),
      RealEstimate<Space>(parts.heuristic, parts.constant, 1, parts.weight));
}

/// Expands cell by cell.
std::unique_ptr<GridEngine> make_stepping_engine(const FreeSpace& space, const BestFirst& parts) {
  if (!space.uniform_terrain()) {
    return make_real<TerrainGrid>(space, parts, MoveTable::Pruning::none);
  }
  if (parts.whole()) return make_whole(space, parts);
  return make_real<ExactGrid>(
      space, parts, parts.consistent() ? MoveTable::Pruning::canonical : MoveTable::Pruning::none);
}

}  // namespace

bool BestFirst::consistent() const {
  return weight == 0 || heuristic == HeuristicKind::constant ||
         (weight <= 1 && is_consistent(heuristic, moves.connectivity));
}

double BestFirst::bound() const {
  if (consistent()) return 1;
  return is_consistent(heuristic, moves.connectivity) ? weight : Plan::kNoBound;
}

bool BestFirst::whole() const {
  const bool whole_numbers = weight == 0 || heuristic == HeuristicKind::constant ||
                             (weight == 1 && heuristic != HeuristicKind::euclidean);
  return consistent() && whole_numbers;
}

GridPlanner::Parts best_first_parts(const FreeSpace& space, const BestFirst& parts,
                                    DeadlineCheck& stop) {
  if (parts.order.chosen()) {
    return {parts.moves,
            make_cheapest_way_engine(space, {.moves = parts.moves,
                                             .order = parts.order,
                                             .heuristic = parts.heuristic,
                                             .constant = parts.constant,
                                             .g_share = 1,
                                             .weight = parts.weight}),
            parts.bound()};
  }
  if (!space.uniform_terrain() && parts.leaps && can_leap(space, parts)) {
    return leap_parts(space, parts, 0, stop);
  }
  return {parts.moves, make_stepping_engine(space, parts), parts.bound()};
}

}  // namespace wend
