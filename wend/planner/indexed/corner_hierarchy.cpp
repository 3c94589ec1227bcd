// A contraction hierarchy on the turns of a map. R. Geisberger, P. Sanders, D. Schultes, D. Delling,
// "Contraction Hierarchies: Faster and Simpler Hierarchical Routing in Road Networks", 2008;
// D. Harabor, T. Uras, P. Stuckey, S. Koenig, "Regarding Jump Point Search and Subgoal Graphs", 2019.

#include "wend/index/corner_hierarchy/corner_hierarchy.hpp"

#include "wend/planner/indexed/index_planner.hpp"

namespace wend {

PlannerInfo corner_hierarchy_planner() {
  return with_index(
      {.name = "corner_hierarchy",
       .summary = "Contraction hierarchy of obstacle corners",
       .idea =
           "The turns of shortest paths form a sparse directed graph. Shortcuts replace its nodes "
           "one by one. A query searches upwards from start and goal until the searches meet.",
       .citation = "Geisberger et al. 2008; Harabor et al. 2019",
       .guarantee_text = "optimal, on 8 neighbours without corner cutting",
       .time = "O(k) in the k arcs searched, tens to thousands, plus the turns visible from start "
               "and goal",
       .memory = "index: 40 to 75 bytes per turn; planner: 36 bytes per turn and 5 per cell",
       .bytes_per_cell = 5,
       .when = "For many queries on one map, with a small index built within seconds. hub_labels "
               "answers faster and builds longer.",
       .guarantee = Guarantee::optimal,
       .preprocessing = Preprocessing::quick},
      {.build =
           [](const BitGrid& passable, const IndexBuilding& building) {
             return build_corner_hierarchy(passable, building);
           },
       .open = opening_in_steps(open_corner_hierarchy)});
}

}  // namespace wend
