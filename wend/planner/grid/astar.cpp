// A*: the cheapest g + w h first. P. Hart, N. Nilsson and B. Raphael, "A Formal Basis for the
// Heuristic Determination of Minimum Cost Paths", 1968; with a weight: I. Pohl, 1970.

#include "wend/planner/grid/best_first.hpp"
#include "wend/planner/grid/grid_planner.hpp"

namespace wend {
namespace {

struct AStarOptions {
  GridMoves moves;
  HeuristicOptions heuristic{HeuristicKind::automatic};
  double weight = 1;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
    HeuristicOptions::fields(self.heuristic, field);
    field({"weight",
           "w in f = g + w h: 0 is Dijkstra, 1 A*, above 1 at most w times the optimum",
           {"lambda", "w"}},
          self.weight, OptionRange{0, 1e6});
  }
};

GridPlanner::Parts choose_parts(const FreeSpace& space, const AStarOptions& options) {
  const BestFirst parts{options.moves, resolved(options.heuristic.kind, options.moves.connectivity),
                        options.heuristic.constant, options.weight};
  return {options.moves, make_best_first_engine(space, parts), parts.bound()};
}

}  // namespace

PlannerInfo astar_planner() {
  return grid_planner<AStarOptions>(
      {.name = "astar",
       .summary = "A*: what the path costs so far plus an estimate of the rest, cheapest first",
       .idea = "Every open cell has a key: what the cheapest known way to it costs, plus w "
               "times an estimate of the rest. The cell with the smallest key is expanded "
               "next, so the search leans towards the goal. An estimate that never "
               "overestimates cannot hide a cheaper path.",
       .citation = "Hart, Nilsson, Raphael 1968; weighted: Pohl 1970",
       .guarantee_text = "optimal with a weight up to 1 and a heuristic that never overestimates; "
                         "above 1 at most w times the optimum; manhattan on 8 neighbours: complete",
       .time = "O(n log n) in the n cells expanded; on uniform terrain the log is that of a "
               "small bucket",
       .memory = "8 bytes a cell and 16 an entry of the frontier; 16 and 24 on terrain, with "
                 "euclidean, with manhattan on 8 neighbours, with a weight other than 0 and 1, and "
                 "when the search is watched",
       .bytes_per_cell = 8,
       .when = "The default, on terrain too: cheapest paths with little search where the "
               "goal's direction says where to go. In mazes the estimate says little, and it "
               "searches almost as much as dijkstra. A weight above 1 often expands far less, but "
               "each expansion then costs several times as much: measure it on your maps.",
       .guarantee = Guarantee::bounded,
       .plans_on_terrain = true},
      choose_parts);
}

}  // namespace wend
