#pragma once

// What planners share whose paths turn at any angle: cells that see each other, nodes with any parent.
// Links choose the parents. A path is the cells at which it turns, joined by lines.

#include <memory>
#include <optional>

#include "wend/planner/any_angle/any_angle_options.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/grid/grid_priorities.hpp"
#include "wend/space/grid/sight_grid.hpp"

namespace wend {

/// For a state that is about to be expanded: `link`, or a shorter one by a neighbour of its parent, by a
/// neighbour of that one, and so on. Without it, paths often turn a cell beside the best turn, which the
/// search reached later.
inline Link<double> with_shifted_turn(const auto& search, const GridState& state,
                                      Link<double> link) {
  constexpr double kRounding = 1e-12;
  const auto& space = search.space();
  bool shifted = true;
  const auto look = [&](const GridState& turn, Move /*move*/, double /*step_cost*/) {
    // The state itself is closed, too, and its g may be one that was taken on trust.
    if (!search.closed(turn.number) || turn.number == state.number) return;
    const double g = search.g(turn.number) + space.distance(turn, state);
    if (!(g < link.g * (1 - kRounding)) || !space.sees(turn, state)) return;
    link = {turn.number, g};
    shifted = true;
  };
  while (shifted) {
    shifted = false;
    space.for_each_successor(space.state(link.parent), kNoMove, look);
  }
  return link;
}

/// Two ways to the next state: by the step from the one that is expanded, and by the line from its parent.
struct StepAndLine {
  Link<double> step;
  std::optional<Link<double>>
      line;  // if there is a parent, and the step is not cheaper, as it may be on costs
};

template <class Search>
StepAndLine step_and_line(const Search& search, const GridState& state, const GridState& next,
                          double step_cost) {
  const StateId parent = search.arrival(state.number);
  const Link<double> step{state.number, search.g(state.number) + step_cost};
  if (parent == search.kNoArrival) return {step, {}};
  const GridState from = search.space().state(parent);
  const Link<double> line{parent, search.g(parent) + search.space().distance(from, next)};
  if (Search::SpaceType::kCosts && step.g < line.g) return {step, {}};
  return {step, line};
}

/// The parts of a planner with such links.
template <class Links, SightCheck kCheck>
GridPlanner::Parts any_angle_parts(const FreeSpace& space, const AnyAngleOptions<kCheck>& options) {
  const auto engine_on = [&]<class Space>(Space sight) -> std::unique_ptr<GridEngine> {
    using Engine = GridEngineOf<Space, HeapFrontier<RealKey<double>>, RealEstimate<Space>,
                                DuplicateRule::keep_cheaper, Links>;
    return std::make_unique<Engine>(
        std::move(sight), RealEstimate<Space>(HeuristicKind::euclidean, 0, 1, options.weight));
  };
  const CornerRule rule = options.corner_rule;
  return {{Connectivity::eight, rule},
          space.uniform_terrain() ? engine_on(SightGrid(space, rule))
                                  : engine_on(CostSightGrid(space, rule)),
          Plan::kNoBound,
          true};
}

}  // namespace wend
