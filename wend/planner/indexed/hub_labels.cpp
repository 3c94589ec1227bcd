#include "wend/index/hub_labels/hub_index.hpp"
#include "wend/planner/indexed/index_planner.hpp"

namespace wend {

PlannerInfo hub_labels_planner() {
  return with_index(
      {.name = std::string(kHubLabels),
       .summary = "Hub labels: looks up paths in labels of the map's corners",
       .idea = "Shortest paths turn at corners of obstacles. Every corner has a label: a few hubs "
               "with the costs of the paths to them. The shortest path between two corners passes "
               "through a hub that both labels have. A query compares two labels and returns the "
               "path that the index stores for the best hub.",
       .citation = "T. Akiba, Y. Iwata, Y. Yoshida, \"Fast Exact Shortest-Path Distance Queries on "
                   "Large Networks by Pruned Landmark Labeling\", 2013; T. Uras, S. Koenig, "
                   "C. Hernandez, \"Subgoal Graphs for Optimal Pathfinding in Eight-Neighbor "
                   "Grids\", 2013",
       .guarantee_text = "optimal on 8 neighbours without corner cutting, on uniform terrain",
       .time = "O(hubs of two labels + cells of the path), about a microsecond",
       .memory = "index: 10 to 100 bytes per cell; planner: half a byte per cell, and 8 bytes per "
                 "hub and thread",
       .bytes_per_cell = 0.5,
       .when = "For many queries on a map that does not change. Building the index takes seconds, "
               "so it is not worth it for a few queries.",
       .preprocessing = Preprocessing::slow},
      {.build = build_hub_index, .open = open_hub_index});
}

}  // namespace wend
