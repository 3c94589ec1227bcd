// Theta*: A* whose cells may have any parent that sees them. A. Nash, K. Daniel, S. Koenig and A. Felner,
// "Theta*: Any-Angle Path Planning on Grids", 2007.

#include <optional>

#include "wend/planner/any_angle/sight_engine.hpp"

namespace wend {
namespace {

/// From the parent of the cell that is expanded, if it sees the next one; else by the step.
struct ParentsInSight {
  template <class Cost>
  using Node = ParentNode<Cost>;

  static std::optional<Link<double>> link(const auto& search, const GridState& state,
                                          const GridState& next, double step_cost) {
    const auto [step, line] = step_and_line(search, state, next, step_cost);
    if (!line) return step;
    // The step is not cheaper than the line, so sight matters only if the line is cheaper.
    if (search.reached(next.number) && !(line->g < search.g(next.number))) return std::nullopt;
    return search.space().sees(search.space().state(line->parent), next) ? line : step;
  }

  static std::optional<Link<double>> settled(const auto& search, const GridState& state) {
    const StateId parent = search.arrival(state.number);
    if (parent == search.kNoArrival) return std::nullopt;
    return with_shifted_turn(search, state, {parent, search.g(state.number)});
  }
};

}  // namespace

PlannerInfo theta_star_planner() {
  return grid_planner<ThetaStarOptions>(
      {.name = "theta_star",
       .summary = "Theta*: A* that turns at any angle",
       .idea = "A cell takes the parent of its neighbour for its own parent where that one is in "
               "sight. When it is expanded, it takes a neighbour of this parent where the path "
               "becomes shorter.",
       .citation = "Nash, Daniel, Koenig, Felner 2007",
       .guarantee_text =
           "complete; longer than the path of astar pulled taut in only a few queries of a "
           "thousand, but not always the shortest; on costs without a bound",
       .time =
           "O(n log n) in the n cells expanded, and a line of sight for each of their neighbours; "
           "on costs also the cells of each line",
       .memory = "16 bytes per cell, 24 per frontier entry",
       .bytes_per_cell = 16,
       .when = "Where a robot can drive in any direction and the path should have few turns. Its "
               "waypoints lie in the middle of cells; string pulling a path of jps is faster, and "
               "mostly a little longer. On costs, lines are chosen by what they cost.",
       .guarantee = Guarantee::complete,
       .capabilities = {.any_angle = true, .terrain = true}},
      any_angle_parts<ParentsInSight, SightCheck::when_reached>);
}

}  // namespace wend
