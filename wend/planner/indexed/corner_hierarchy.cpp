// A contraction hierarchy on the turns of a map. R. Geisberger, P. Sanders, D. Schultes, D. Delling,
// "Contraction Hierarchies: Faster and Simpler Hierarchical Routing in Road Networks", 2008;
// D. Harabor, T. Uras, P. Stuckey, S. Koenig, "Regarding Jump Point Search and Subgoal Graphs", 2019.

#include "wend/index/corner_hierarchy/corner_hierarchy.hpp"

#include "wend/planner/indexed/index_planner.hpp"

namespace wend {

PlannerInfo corner_hierarchy_planner() {
  return with_index(
      {.name = "corner_hierarchy",
       .summary = "Contraction hierarchy on the turns around obstacles' corners",
       .idea =
           "A path turns only at corners of obstacles, and where it can go on from there depends "
           "on how it arrived: that makes a sparse directed graph. Its nodes are taken out one by "
           "one, and shortcuts put in their place. A query climbs from its start and from its "
           "goal, and meets at the top.",
       .citation = "Geisberger et al. 2008; Harabor et al. 2019",
       .guarantee_text = "optimal, on 8 neighbours without corner cutting",
       .time = "O(k) in the k arcs climbed, some tens to some thousands, and the turns that start "
               "and goal see",
       .memory = "the index: 40 to 75 bytes a turn; a planner on it: 36 bytes a turn and 5 a cell",
       .bytes_per_cell = 5,
       .when =
           "Where many queries come on one map, and its index is to be small and built within "
           "seconds, mostly within a tenth of one. hub_labels answers faster and takes longer to "
           "build. Not on terrain.",
       .preprocessing = Preprocessing::quick},
      {.build =
           [](const BitGrid& passable, const IndexBuilding& building) {
             return build_corner_hierarchy(passable, building);
           },
       .open = open_corner_hierarchy});
}

}  // namespace wend
