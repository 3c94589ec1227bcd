// Lazy Theta*: Theta* that looks for obstacles only on the lines to the cells that it expands. A. Nash,
// S. Koenig and C. Tovey, "Lazy Theta*: Any-Angle Path Planning and Path Length Analysis in 3D", 2010.

#include <limits>
#include <optional>

#include "wend/planner/any_angle/sight_engine.hpp"

namespace wend {
namespace {

/// From the parent of the cell that is expanded, as if it saw the next one. When that one is expanded
/// and its parent does not see it, it takes the best of its expanded neighbours.
struct ParentsTakenOnTrust {
  template <class Cost>
  using Node = ParentNode<Cost>;

  static std::optional<Link<double>> link(const auto& search, const GridState& state,
                                          const GridState& next, double step_cost) {
    const auto [step, line] = step_and_line(search, state, next, step_cost);
    return line.value_or(step);
  }

  static std::optional<Link<double>> settled(const auto& search, const GridState& state) {
    const StateId parent = search.arrival(state.number);
    if (parent == search.kNoArrival) return std::nullopt;
    const Link<double> trusted{parent, search.g(state.number)};
    const bool sees = search.space().sees(search.space().state(parent), state);
    return with_shifted_turn(search, state, sees ? trusted : by_step(search, state));
  }

 private:
  /// The shortest way by a step from an expanded neighbour: there is one, which reached the state.
  static Link<double> by_step(const auto& search, const GridState& state) {
    Link<double> best{search.kNoArrival, std::numeric_limits<double>::infinity()};
    const auto look = [&](const GridState& neighbour, Move /*move*/, double step_cost) {
      const StateId id = neighbour.number;
      if (!search.closed(id)) return;
      const double g = search.g(id) + step_cost;
      if (g < best.g) best = {id, g};
    };
    search.space().for_each_successor(state, kNoMove, look);  // steps lead both ways
    return best;
  }
};

}  // namespace

PlannerInfo lazy_theta_star_planner() {
  return grid_planner<LazyThetaStarOptions>(
      {.name = "lazy_theta_star",
       .summary = "Lazy Theta*: Theta* with fewer line checks",
       .idea =
           "It takes for granted that a cell is in sight of its neighbour's parent. If that proves "
           "wrong, the cell gets the best of its expanded neighbours for its parent. Turns are "
           "shifted as in theta_star.",
       .citation = "Nash, Koenig, Tovey 2010",
       .guarantee_text =
           "complete; longer than the path of astar pulled taut in only a few queries of a "
           "thousand, but not always the shortest; on costs without a bound",
       .time = "O(n log n) in the n cells expanded, and a line of sight for each of them; on costs "
               "also the cells of lines to their neighbours",
       .memory = "16 bytes per cell, 24 per frontier entry",
       .bytes_per_cell = 16,
       .when = "As theta_star, of which it is the faster one; its paths are about as long.",
       .guarantee = Guarantee::complete,
       .capabilities = {.any_angle = true, .terrain = true}},
      any_angle_parts<ParentsTakenOnTrust, SightCheck::when_expanded>);
}

}  // namespace wend
