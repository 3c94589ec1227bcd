// A*: the cheapest g + w h first. P. Hart, N. Nilsson and B. Raphael, "A Formal Basis for the
// Heuristic Determination of Minimum Cost Paths", 1968; with a weight: I. Pohl, 1970.

#include "wend/planner/best_first.hpp"
#include "wend/planner/grid_planner.hpp"

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
  return {.name = "astar",
          .summary = "A*: what the path costs so far plus an estimate of the rest, cheapest first",
          .citation = "Hart, Nilsson, Raphael 1968; weighted: Pohl 1970",
          .guarantee =
              "optimal with a weight up to 1 and a heuristic that never overestimates; "
              "above 1 at most w times the optimum; manhattan on 8 neighbours: complete",
          .promise = Promise::bounded,
          .plans_on_terrain = true,
          .preprocessing = Preprocessing::none,
          .can_step = true,
          .options = option_schema<AStarOptions>(),
          .make = [](const FreeSpace& space, const OptionValues& values) {
            return make_grid_planner<AStarOptions>(space, values, choose_parts);
          }};
}

}  // namespace wend
