// Hybrid A*: a robot with a shape and a turning circle, over continuous poses. D. Dolgov, S. Thrun, M. Montemerlo,
// J. Diebel, 2010.

#include <algorithm>
#include <cmath>
#include <utility>

#include "wend/planner/se2/hybrid_planner.hpp"

namespace wend {
namespace {

PlannerResult make(const FreeSpace& space, const OptionValues& values) {
  auto options = parse_options<HybridAStarOptions>(values);
  if (!options) return Unexpected<Error>(options.error());
  const bool car =
      options->motion_model == DriveKind::reeds_shepp || options->motion_model == DriveKind::dubins;
  if (car && options->turning_radius == 0) {
    return failure(Status::invalid_option,
                   "a car needs a turning_radius greater than 0; a robot that turns in place has "
                   "motion_model=differential",
                   "turning_radius");
  }
  return std::make_unique<HybridPlanner>(space, *options);
}

}  // namespace

PlannerInfo hybrid_astar_planner() {
  return {
      .name = "hybrid_astar",
      .summary = "Hybrid A*: a robot with shape and heading",
      .idea =
          "Poses are continuous; of each small box of positions and headings the best one is kept. "
          "Short arcs and lines lead from pose to pose, and Reeds-Shepp curves straight to the "
          "goal, or to where the way around the obstacles leads. The robot's shape is swept along "
          "each motion.",
      .citation = "Dolgov, Thrun, Montemerlo, Diebel 2010; Reeds, Shepp 1990",
      .guarantee_text =
          "the path is free and drivable; it fails if its time_budget is used, or its finest boxes "
          "and motions, and a "
          "lattice of half cells, find no path, which may exist all the same; a path may cost some "
          "percent more than the best",
      .time = "O(n log n) in the n poses expanded; the heuristic O(m) in the squares it reaches",
      .memory = "100 bytes per pose reached; for the map, 1/8 byte a cell and 10 a coarse square",
      .when =
          "For cars and other robots with a turning radius, or of any shape: smooth paths between "
          "exact poses. For a robot whose motions are data, take lattice.",
      .motion = "poses",
      .mover = "a robot with a shape and a heading, from pose to pose",
      .guarantee = Guarantee::none,
      .preprocessing = Preprocessing::none,
      .capabilities = {.headings = true, .terrain = true},
      .options = option_schema<HybridAStarOptions>(),
      .make = make};
}

}  // namespace wend
