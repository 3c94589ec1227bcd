// A contraction hierarchy on the turns of a map. R. Geisberger, P. Sanders, D. Schultes, D. Delling,
// "Contraction Hierarchies: Faster and Simpler Hierarchical Routing in Road Networks", 2008;
// D. Harabor, T. Uras, P. Stuckey, S. Koenig, "Regarding Jump Point Search and Subgoal Graphs", 2019.

#include "wend/index/corner_hierarchy.hpp"

#include "wend/planner/index_planner.hpp"

namespace wend {

PlannerInfo corner_hierarchy_planner() {
  return with_index(
      {.name = "corner_hierarchy",
       .summary = "Contraction hierarchy on the turns around obstacles' corners",
       .idea =
           "A path turns only at corners of obstacles, and where it can go on from there depends "
           "on "
           "how it arrived: that makes a sparse directed graph. Its nodes are taken out one by "
           "one, "
           "and shortcuts put in their place, so that a query only climbs, from its start and from "
           "its goal, and meets at the top.",
       .citation = "Geisberger et al. 2008; Harabor et al. 2019",
       .guarantee = "optimal, on 8 neighbours without corner cutting",
       .time = "O(k log k) in the k turns climbed to, some tens to some hundreds on any map",
       .memory = "the index: some 60 bytes a turn; a planner on it: 32 bytes a turn and 1 a cell",
       .when =
           "Where many queries come on one map, or the map changes now and then: the index takes "
           "milliseconds to a second to build. Not on terrain, and not for a few queries on a map "
           "that changes.",
       .promise = Promise::optimal,
       .plans_on_terrain = false,
       .preprocessing = Preprocessing::quick,
       .can_step = false,
       .options = {},
       .make = {}},
      {.build =
           [](const BitGrid& passable, const IndexBuilding& building) {
             return build_corner_hierarchy(passable, building);
           },
       .open = open_corner_hierarchy});
}

}  // namespace wend
