// Lazy Theta*: Theta* that looks for obstacles only on the lines to the cells that it expands. A. Nash,
// S. Koenig and C. Tovey, "Lazy Theta*: Any-Angle Path Planning and Path Length Analysis in 3D", 2010.

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
    const StateId id = state.number;
    const StateId parent = search.arrival(id);
    if (parent == search.kNoArrival) return Link<double>{id, search.g(id) + step_cost};
    const GridState from = search.space().state(parent);
    return Link<double>{parent, search.g(parent) + SightGrid::distance(from, next)};
  }

  static std::optional<Link<double>> settled(const auto& search, const GridState& state) {
    const StateId parent = search.arrival(state.number);
    if (parent == search.kNoArrival) return std::nullopt;
    if (search.space().sees(search.space().state(parent), state)) return std::nullopt;
    std::optional<Link<double>> best;
    const auto look = [&](const GridState& neighbour, Move /*move*/, double step_cost) {
      const StateId id = neighbour.number;
      if (!search.closed(id)) return;
      const double g = search.g(id) + step_cost;
      if (!best || g < best->g) best = Link<double>{id, g};
    };
    search.space().for_each_successor(state, kNoMove, look);  // steps lead both ways
    return best;
  }
};

}  // namespace

PlannerInfo lazy_theta_star_planner() {
  return grid_planner<LazyThetaStarOptions>(
      {.name = "lazy_theta_star",
       .summary =
           "Lazy Theta*: Theta* that checks the line to a cell only when it expands the cell",
       .idea =
           "It takes for granted that a cell is in sight of its neighbour's parent. If that proves "
           "wrong, the cell gets the best of its expanded neighbours for its parent.",
       .citation = "Nash, Koenig, Tovey 2010",
       .guarantee_text =
           "complete; paths are hardly ever longer than those of astar, but not always "
           "the shortest",
       .time = "O(n log n) in the n cells expanded, and a line of sight for each of them",
       .memory = "16 bytes per cell, 24 per frontier entry",
       .bytes_per_cell = 16,
       .when = "As theta_star, of which it is the faster one; its paths are about as long.",
       .guarantee = Guarantee::complete,
       .any_angle = true},
      any_angle_parts<ParentsTakenOnTrust, SightCheck::when_expanded>);
}

}  // namespace wend
