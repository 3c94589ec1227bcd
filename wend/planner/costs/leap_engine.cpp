#include "wend/planner/costs/leap_engine.hpp"

#include "wend/planner/costs/cost_grid_parts.hpp"
#include "wend/planner/costs/leap_search.hpp"
#include "wend/space/grid/grid_space.hpp"

namespace wend {

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

}  // namespace wend
