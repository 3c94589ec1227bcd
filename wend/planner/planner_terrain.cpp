#include "wend/planner/planner_terrain.hpp"

#include "wend/planner/planner.hpp"

namespace wend {

std::string_view terrain_in_words(const PlannerInfo& planner) {
  if (planner.plans_on_terrain) return "costs count";
  constexpr int kSide = 2;
  const GridMap rough(Grid<CellState>(kSide, kSide, CellState::free), {},
                      Grid<double>(kSide, kSide, 2));
  return planner.make(FreeSpace(rough), {}) ? "ignored" : "refused";
}

}  // namespace wend
