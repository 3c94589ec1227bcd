#pragma once

// The options of the planners whose robots have headings, as structs. Front ends set the same fields by name.
//
//   const auto car = wend::make_planner(space, wend::CarOptions{.turning_radius = 0.4});
//   const auto robot = wend::make_planner(space, wend::LatticeOptions{.turning_radius = 0.4});

#include <array>
#include <cstdint>
#include <string_view>

#include "wend/base/choice.hpp"
#include "wend/base/compiler.hpp"
#include "wend/base/options.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/space/lattice/driving_options.hpp"

namespace wend {

/// The estimate of the cost to the goal, for `car`. All are consistent.
enum class CarHeuristic {
  zero,      // 0
  diagonal,  // a turn for each diagonal cell, and the straight rest
  headings,  // the cost on an empty map, exactly
  obstacles,  // at least that, and the cheapest way around obstacles for a car that turns on the spot
};

constexpr std::array<Choice<CarHeuristic>, 4> choice_names(CarHeuristic) {
  return {{{"zero", CarHeuristic::zero},
           {"diagonal", CarHeuristic::diagonal},
           {"headings", CarHeuristic::headings},
           {"obstacles", CarHeuristic::obstacles}}};
}

/// The estimate of the cost to the goal, for `lattice`. All are consistent.
enum class LatticeHeuristic {
  zero,       // 0
  distance,   // the straight distance, times the least cost per cell
  obstacles,  // the cheapest way around obstacles for a robot that may take any heading everywhere
};

constexpr std::array<Choice<LatticeHeuristic>, 3> choice_names(LatticeHeuristic) {
  return {{{"zero", LatticeHeuristic::zero},
           {"distance", LatticeHeuristic::distance},
           {"obstacles", LatticeHeuristic::obstacles}}};
}

namespace detail {
template <class Weight, class Field>
void anytime_fields(Weight& initial_weight, Weight& weight_step, Field&& field) {
  field({"initial_weight",
         "w until the first path; if it is above the weight and 1, the search is anytime, and w "
         "falls from here to the larger of these two"},
        initial_weight, OptionRange{1, 1e6});
  field({"weight_step", "what the next w of an anytime search is below the bound that is proven"},
        weight_step, OptionRange{0.01, 1e6});
}
}  // namespace detail

/// The options of `car`.
struct CarOptions {
  static constexpr std::string_view kPlanner = "car";  // its name

  CarDriving driving = {.reverse_factor = 2};  // the lattice, and the costs of moves
  double turning_radius = 0;  // metres; if above 0, it sets the lattice resolution instead
  CarHeuristic heuristic = CarHeuristic::headings;  // the estimate of the cost to the goal
  double weight = 1;                                // w >= 0 in f = g + w h: 0 is Dijkstra
  double initial_weight = 1;  // above weight and 1: anytime, as `ara_star`; w falls to the larger
  double weight_step = 0.5;   // what the next w is below the bound that is proven

  /// Plan::bound of every answer, of an anytime search without a limit at most.
  double bound() const { return weight > 1 ? weight : 1; }
  /// Does it find paths until the best or a limit, as `ara_star` does?
  bool anytime() const { return initial_weight > bound(); }

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    CarDriving::fields(self.driving, field);
    field({"turning_radius",
           "turning radius in metres (in cells on maps in cells), rounded up to whole cells, "
           "instead of lattice_resolution; 0: lattice_resolution applies"},
          self.turning_radius, OptionRange{0, 1e6});
    field({"heuristic", "estimate of the cost to the goal"}, self.heuristic);
    field({"weight",
           "w in f = g + w h: 0 is Dijkstra, 1 is A*; above 1 the cost is at most w times the "
           "optimum",
           {"lambda", "w"}},
          self.weight, OptionRange{0, 1e6});
    detail::anytime_fields(self.initial_weight, self.weight_step, field);
  }
};

/// The lattice resolution, in cells, for a turning radius in metres: rounded up, so that no turn is
/// tighter, and at least 1.
WEND_API std::int64_t unit_for(double turning_radius, const Frame& frame);

/// The options of `lattice`.
struct LatticeOptions {
  static constexpr std::string_view kPlanner = "lattice";  // its name

  double turning_radius = 0;  // metres, of a robot without primitives of its own; 0: turns in place
  bool ways_back = false;     // also makes the robot's primitives in reverse
  LatticeCosts costs = {};    // of the primitives
  LatticeHeuristic heuristic = LatticeHeuristic::obstacles;  // the estimate of the cost to the goal
  double weight = 1;                                         // w >= 0 in f = g + w h: 0 is Dijkstra
  double initial_weight = 1;  // above weight and 1: anytime, as `ara_star`; w falls to the larger
  double weight_step = 0.5;   // what the next w is below the bound that is proven

  /// Plan::bound of every answer, of an anytime search without a limit at most.
  double bound() const { return weight > 1 ? weight : 1; }
  /// Does it find paths until the best or a limit, as `ara_star` does?
  bool anytime() const { return initial_weight > bound(); }

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"turning_radius",
           "turning radius of a robot without motion primitives of its own, in metres (in cells on "
           "maps in cells); 0: it turns in place"},
          self.turning_radius, OptionRange{0, 1e6});
    field({"ways_back",
           "also makes the motion primitives of the robot in reverse, where it has none that lead "
           "back"},
          self.ways_back);
    LatticeCosts::fields(self.costs, field);
    field(
        {"heuristic", "estimate of the cost to the goal; obstacles: around them, with any heading"},
        self.heuristic);
    field({"weight",
           "w in f = g + w h: 0 is Dijkstra, 1 is A*; above 1 the cost is at most w times the "
           "optimum"},
          self.weight, OptionRange{0, 1e6});
    detail::anytime_fields(self.initial_weight, self.weight_step, field);
  }
};

}  // namespace wend
