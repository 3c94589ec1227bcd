// A car on a lattice of grid corners: A* over corners and headings. State lattices: M. Pivtoraiko
// and A. Kelly, "Efficient Constrained Path Planning via Search in State Lattices", 2005.

#include <algorithm>
#include <cmath>

#include "wend/planner/lattice/lattice_planner.hpp"

namespace wend {
namespace {

/// With the spacing of the lattice: --lattice-resolution, or the turning radius in whole cells.
Expected<CarOptions, Error> car_options(const OptionValues& values, const Frame& frame) {
  auto options = parse_options<CarOptions>(values);
  if (!options || options->turning_radius <= 0) return options;
  const auto is_resolution = [](const auto& value) {
    return value.first == "lattice_resolution" || value.first == "unit";
  };
  const auto given = std::ranges::find_if(values, is_resolution);
  if (given != values.end()) {
    return failure(Status::invalid_option,
                   given->first + " and turning_radius set the same value: give one of them");
  }
  options->driving.unit = unit_for(options->turning_radius, frame);
  return options;
}

PlaceGrid car_places(const FreeSpace& space, const OptionValues& values) {
  const auto options = car_options(values, space.map().frame());
  return corners_of(space, options ? static_cast<int>(options->driving.unit) : 1);
}

PlannerResult make_car_within(const FreeSpace& space, const OptionValues& values,
                              const Deadline& deadline) {
  auto options = car_options(values, space.map().frame());
  if (!options) return Unexpected<Error>(options.error());
  const auto lattice_for = [driving = options->driving](
                               const FreeSpace& other,
                               DeadlineCheck& stop) -> Expected<CarLattice, Error> {
    std::string why_none = why_no_lattice(other.map(), driving);
    if (!why_none.empty()) return failure(Status::unsupported_map, std::move(why_none));
    CarLattice lattice(other, driving, stop);
    if (stop.has_passed()) return failure(stop.deadline()->status(), stop.deadline()->text());
    return lattice;
  };
  const auto engine_on = [options = *options](const CarLattice& lattice) {
    if (options.anytime()) {
      return make_anytime_engine(lattice, options.heuristic, anytime_weights(options));
    }
    return make_engine(lattice, options.heuristic, options.weight);
  };
  DeadlineCheck stop(&deadline);
  auto planner = std::make_unique<LatticePlanner<CarLattice>>(
      space, LatticeParts<CarLattice>{lattice_for, engine_on, "the car", options->bound()}, stop);
  if (auto fault = planner->fault()) return Unexpected<Error>(*std::move(fault));
  return planner;
}

PlannerResult make_car(const FreeSpace& space, const OptionValues& values) {
  return make_car_within(space, values, {});
}

}  // namespace

std::int64_t unit_for(double turning_radius, const Frame& frame) {
  constexpr double kMost = 1e6;
  constexpr double kRounding = 1e-9;
  const double cells = turning_radius / frame.resolution * (1 - kRounding);
  if (!(cells > 1)) return 1;  // or NaN, which the range of the option refuses
  return static_cast<std::int64_t>(std::min(std::ceil(cells), kMost));
}

PlannerInfo car_planner() {
  return {
      .name = "car",
      .summary = "A* for a car on a lattice, with six motions",
      .idea =
          "At a lattice vertex the car faces north, west, east or south. It moves one lattice cell "
          "straight, or a quarter circle of that radius, forwards or in reverse. A turn costs pi/2 "
          "times the terrain of the cell that it sweeps.",
      .citation = "Pivtoraiko, Kelly 2005; Hart, Nilsson, Raphael 1968",
      .guarantee_text =
          "optimal on its lattice with a weight up to 1; above 1 at most w times the optimum; of "
          "an anytime search at a limit, at most the bound that it has proven times the optimum",
      .time = "O(n log n) in the n poses expanded; with whole terrain costs log of a small bucket",
      .memory =
          "8 bytes per pose, four poses per lattice vertex, 16 per frontier entry; 16 and 24 "
          "with terrain costs that are not whole or above 5, a factor for reversing, a weight "
          "other than 0 and 1, or an initial_weight",
      .when =
          "For robots that cannot turn in place. On a fine map set lattice_resolution to the "
          "turning radius in cells. With an initial_weight it has a path soon and better ones "
          "until a limit, as ara_star.",
      .motion = "car",
      .mover = "a car, from corner to corner",
      .cost_name = "fuel",
      .guarantee = Guarantee::bounded,
      .preprocessing = Preprocessing::none,
      .capabilities = {.headings = true,
                       .vertices = Vertices::corners,
                       .terrain = true,
                       .can_step = true},
      .options = option_schema<CarOptions>(),
      .make = make_car,
      .make_within = make_car_within,
      .places = car_places};
}

}  // namespace wend
