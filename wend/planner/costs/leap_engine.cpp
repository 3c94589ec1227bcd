#include "wend/planner/costs/leap_engine.hpp"

#include "wend/planner/costs/cost_grid_parts.hpp"
#include "wend/planner/costs/leap_search.hpp"
#include "wend/space/grid/grid_space.hpp"

namespace wend {
namespace {

template <class Cost, class Word, class Units>
using AnytimeLeaps = LeapSearch<Cost, Word, Units, true>;

/// Buckets of other units expand in another order, so an engine in OctileUnits cannot become wider.
template <class Word>
std::shared_ptr<GridEngine> make_anytime_engine(const std::shared_ptr<const CostGrid<Word>>& grid,
                                                const BestFirst& parts, AnytimeWeights weights) {
  using Wide = std::uint64_t;
  if (grid->one() == 1) {
    return std::make_shared<AnytimeLeaps<Wide, Word, OctileUnits<Wide>>>(grid, parts, weights);
  }
  const auto make_wide = [=] {
    return std::make_unique<AnytimeLeaps<Wide, Word, CostUnits>>(grid, parts, weights);
  };
  if constexpr (sizeof(Word) == sizeof(Wide)) return make_wide();
  return std::make_shared<WideningEngine<GridEngine>>(
      [&] { return std::make_unique<AnytimeLeaps<Word, Word, CostUnits>>(grid, parts, weights); },
      make_wide);
}

}  // namespace

bool can_leap(const FreeSpace& space, const BestFirst& parts) {
  return parts.whole() && !sweeps_diagonals(space, parts.moves);
}

template <class Word>
std::shared_ptr<GridEngine> make_leap_engine(const std::shared_ptr<const CostGrid<Word>>& grid,
                                             const BestFirst& parts,
                                             const std::shared_ptr<const Landmarks>& landmarks) {
  // The costs of landmarks are those of the engine in 32 bits.
  return widening_engine_on<LeapSearch>(grid, parts, landmarks);
}

template std::shared_ptr<GridEngine> make_leap_engine(
    const std::shared_ptr<const CostGrid<std::uint32_t>>&, const BestFirst&,
    const std::shared_ptr<const Landmarks>&);
template std::shared_ptr<GridEngine> make_leap_engine(
    const std::shared_ptr<const CostGrid<std::uint64_t>>&, const BestFirst&,
    const std::shared_ptr<const Landmarks>&);

GridPlanner::Parts leap_parts(const FreeSpace& space, const BestFirst& parts, unsigned landmarks,
                              DeadlineCheck& stop) {
  const auto engine_on = [&]<class Word>(const std::shared_ptr<CostGrid<Word>>& grid) {
    const auto bounds = landmarks == 0 ? nullptr : Landmarks::make(*grid, landmarks, stop);
    return make_leap_engine<Word>(grid, parts, bounds);
  };
  const auto remake = [=](const FreeSpace& other) {
    return landmarks == 0 ? best_first_parts(other, parts) : leap_parts(other, parts, landmarks);
  };
  return cost_grid_parts(space, parts, engine_on, remake, stop);
}

GridPlanner::Parts anytime_leap_parts(const FreeSpace& space, const BestFirst& parts,
                                      AnytimeWeights weights, DeadlineCheck& stop) {
  const auto engine_on = [&]<class Word>(const std::shared_ptr<CostGrid<Word>>& grid) {
    return make_anytime_engine<Word>(grid, parts, weights);
  };
  const auto remake = [=](const FreeSpace& other) {
    return anytime_leap_parts(other, parts, weights, DeadlineCheck::never());
  };
  return cost_grid_parts(space, parts, engine_on, remake, stop);
}

}  // namespace wend
