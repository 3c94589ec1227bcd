// Jump point search: D. Harabor and A. Grastien, "Online Graph Pruning for Pathfinding on Grid
// Maps", 2011, and "Improving Jump Point Search", 2014.

#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/jump/learning_engine.hpp"
#include "wend/planner/jump/prepared_jumps.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/planner/widening_engine.hpp"

namespace wend {
namespace {

GridPlanner::Parts choose_parts(const FreeSpace& space, DeadlineCheck& /*stop*/) {
  if (!space.uniform_terrain()) return {{}, nullptr, 1};
  const auto shared = PreparedJumps::of(space);
  if (shared->is_noise(space.passable())) {
    return best_first_parts(space, {{}, HeuristicKind::octile, 0, 1});
  }
  const auto engine = [prepared = shared, cells = &space.passable()]<class Cost>(Cost /*type*/) {
    return [prepared, cells] { return std::make_unique<LearningEngine<Cost>>(prepared, *cells); };
  };
  return {{},
          std::make_unique<WideningEngine<GridEngine>>(engine(std::uint32_t{}),
                                                       engine(std::uint64_t{})),
          1};
}

}  // namespace

PlannerInfo jps_planner() {
  return {
      .name = "jps",
      .summary = "Jump point search: A* from turn to turn",
      .idea =
          "It considers only shortest paths with diagonal steps first, which turn only at "
          "obstacle corners. It reads 64 cells at a time, skips dead ends, and caches "
          "unbranched chains of jump points as shortcuts. It scans the cells at first, and "
          "prepares the map after some queries, for all jps planners on the same free space.",
      .citation = "Harabor, Grastien 2011 and 2014",
      .guarantee_text = "optimal on 8 neighbours without corner cutting, on uniform terrain",
      .time = "O(n log n) in the n cells expanded, and the cells between them, 64 at a time",
      .memory =
          "1 bit per cell where it has searched, 44 bytes per jump point reached, 8 per frontier "
          "entry; on a prepared map 8 bytes per cell, 57 per jump point, 16 per shortcut used so "
          "far, 16 per jump point expanded so far; as astar on large maps of noise",
      .bytes_per_cell = 8,
      .when =
          "The fastest planner without an index on maps with rooms, streets or corridors. On "
          "large maps of random noise, where it would skip few cells, it searches as astar does. "
          "It refuses terrain and clearance costs.",
      .guarantee = Guarantee::optimal,
      .preprocessing = Preprocessing::none,
      .capabilities = {.jumps = true, .can_step = true, .learns = true},
      .options = {},
      .make = [](const FreeSpace& space, const OptionValues& values) -> PlannerResult {
        auto refused = refused_options(values);
        if (!refused) refused = refused_terrain("jps", space);
        if (refused) return Unexpected<Error>(*std::move(refused));
        return std::make_unique<GridPlanner>(space, choose_parts);
      }};
}

}  // namespace wend
