// A robot on a state lattice: A* over cells and headings, by motion primitives that are data. M. Pivtoraiko
// and A. Kelly, "Efficient Constrained Path Planning via Search in State Lattices", 2005.

#include "wend/planner/lattice/lattice_planner.hpp"

namespace wend {
namespace {

Expected<MotionPrimitives, Error> primitives_for(const FreeSpace& space,
                                                 const LatticeOptions& options) {
  const auto refused = [](std::string why) {
    return failure(Status::invalid_option, std::move(why));
  };
  if (const auto& primitives = space.robot().primitives) {
    if (options.turning_radius == 0) {
      return options.ways_back ? primitives->with_ways_back() : *primitives;
    }
    return refused("turning_radius changes nothing: the robot has motion primitives of its own");
  }
  if (options.ways_back) return refused("ways_back changes nothing without motion primitives");
  auto made =
      MotionPrimitives::turning_circle(options.turning_radius / space.map().frame().resolution);
  if (made) return *std::move(made);
  return refused("turning_radius is too large for this resolution: " + made.error().message);
}

Expected<MotionLattice, Error> lattice_of(const FreeSpace& space, const LatticeOptions& options) {
  auto primitives = primitives_for(space, options);
  if (!primitives) return Unexpected<Error>(std::move(primitives.error()));
  std::string why_none = MotionLattice::why_none(space, *primitives);
  if (!why_none.empty()) return failure(Status::unsupported_map, std::move(why_none));
  return MotionLattice(space, *primitives, options.costs);
}

PlannerResult make_lattice(const FreeSpace& space, const OptionValues& values) {
  const auto options = parse_options<LatticeOptions>(values);
  if (!options) {
    return Unexpected<Error>(options.error());
  }
  const auto lattice_for = [options = *options](const FreeSpace& other, DeadlineCheck& /*stop*/) {
    return lattice_of(other, options);
  };
  const auto engine_on = [options = *options](const MotionLattice& lattice) {
    if (options.anytime()) {
      return make_anytime_engine(lattice, options.heuristic, anytime_weights(options));
    }
    return make_engine(lattice, options.heuristic, options.weight);
  };
  auto planner = std::make_unique<LatticePlanner<MotionLattice>>(
      space, LatticeParts<MotionLattice>{lattice_for, engine_on, "the robot", options->bound()});
  if (auto fault = planner->fault()) return Unexpected<Error>(*std::move(fault));
  return planner;
}

}  // namespace

PlannerInfo lattice_planner() {
  return {
      .name = "lattice",
      .summary = "A* by motion primitives, for any footprint",
      .idea =
          "A state is a cell and a heading. Motion primitives lead from state to state; the "
          "robot's own shape is swept along each. The heuristic is the way around the obstacles "
          "for a robot that may take any heading at every cell.",
      .citation = "Pivtoraiko, Kelly 2005; Hart, Nilsson, Raphael 1968",
      .guarantee_text =
          "optimal among the paths of its primitives with a weight up to 1; above 1 "
          "at most w times the optimum; of an anytime search at a limit, at most the bound that it "
          "has proven times the optimum",
      .time =
          "O(n log n) in the n poses expanded; the heuristic O(m log m) in the cells it reaches",
      .memory =
          "16 bytes per cell and heading where the search goes, in pages, 24 with an "
          "initial_weight; 16 per cell with the heuristic; 24 per frontier entry",
      .when =
          "For robots that are not round, or that have a turning circle. Primitives come from "
          "SBPL's or Nav2's files (--primitives), or from a turning radius. With an initial_weight "
          "it has a path soon and better ones until a limit, as ara_star.",
      .motion = "poses",
      .mover = "a robot with a shape and a heading, from cell to cell",
      .guarantee = Guarantee::bounded,
      .preprocessing = Preprocessing::none,
      .capabilities = {.headings = true, .primitives = true, .terrain = true, .can_step = true},
      .options = option_schema<LatticeOptions>(),
      .make = make_lattice};
}

}  // namespace wend
