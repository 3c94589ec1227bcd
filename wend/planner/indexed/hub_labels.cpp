#include "wend/index/hub_labels/hub_index.hpp"
#include "wend/planner/indexed/index_planner.hpp"

namespace wend {

PlannerInfo hub_labels_planner() {
  return with_index(
      {.name = std::string(kHubLabels),
       .summary = "Hub labels: looks up paths in an index",
       .idea = "Shortest paths turn at obstacle corners. Each corner has a label: a few hubs with "
               "the costs to them. A query returns the stored path through the best common hub of "
               "two labels.",
       .citation = "Akiba, Iwata, Yoshida 2013; Uras, Koenig, Hernandez 2013",
       .guarantee_text = "optimal on 8 neighbours without corner cutting, on uniform terrain",
       .time = "O(hubs of two labels + cells of the path), about a microsecond",
       .memory =
           "index: 10 to 100 bytes per cell; planner: half a byte per cell, 8 bytes per hub and "
           "thread",
       .bytes_per_cell = 0.5,
       .when = "For many queries on one map. Building the index takes seconds.",
       .guarantee = Guarantee::optimal,
       .preprocessing = Preprocessing::slow},
      {.build = build_hub_index, .open = opening_in_steps(open_hub_index)});
}

}  // namespace wend
