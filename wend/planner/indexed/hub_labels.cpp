#include "wend/index/hub_labels/hub_index.hpp"
#include "wend/planner/indexed/index_planner.hpp"

namespace wend {

PlannerInfo hub_labels_planner() {
  return with_index(
      {.name = std::string(kHubLabels),
       .summary = "looks paths up in labels of the map's corners",
       .idea = "Shortest paths turn at corners of obstacles. Every corner has a label: a few hubs "
               "with the costs of the ways to them, so that the shortest way between two corners "
               "passes a hub of both. A query compares two labels, and writes down the way that "
               "the index keeps for the best hub.",
       .citation = "T. Akiba, Y. Iwata, Y. Yoshida, \"Fast Exact Shortest-Path Distance Queries on "
                   "Large Networks by Pruned Landmark Labeling\", 2013; T. Uras, S. Koenig, "
                   "C. Hernandez, \"Subgoal Graphs for Optimal Pathfinding in Eight-Neighbor "
                   "Grids\", 2013",
       .guarantee_text =
           "complete and optimal, without cutting corners, where all cells cost the same",
       .time = "O(hubs of two labels + cells of the path); about a microsecond",
       .memory =
           "the index: 10 to 100 bytes a cell; half a byte a cell, and 8 bytes a hub for each "
           "thread",
       .bytes_per_cell = 0.5,
       .when = "Choose it when many queries are asked of a map that does not change. Building "
               "takes seconds, so do not choose it for a few queries.",
       .preprocessing = Preprocessing::slow},
      {.build = build_hub_index, .open = open_hub_index});
}

}  // namespace wend
