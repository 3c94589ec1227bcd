#pragma once

// The options of `hybrid_astar`, as a struct. Front ends set the same fields by name.
//
//   const auto planner = wend::make_planner(space, wend::HybridAStarOptions{.turning_radius = 0.4});

#include <cstdint>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/base/options.hpp"
#include "wend/space/se2/drive_kind.hpp"

namespace wend {

/// The options of `hybrid_astar`. On maps in cells, a metre is a cell.
struct HybridAStarOptions {
  static constexpr std::string_view kPlanner = "hybrid_astar";  // its name

  DriveKind motion_model = DriveKind::reeds_shepp;  // how the robot moves
  double turning_radius = 0.4;                      // metres; above 0 for cars
  bool allow_reverse = true;                        // a car without it is a Dubins car
  double reverse_factor = 2;                        // factor on the cost of driving in reverse
  double turn_factor = 1.2;                         // factor on the cost of arcs
  double gear_change_cost = 0;  // metres, for each change between ahead and reverse
  double turn_cost = 0.2;       // metres a radian, of a turn in place
  std::int64_t headings = 36;   // how many headings are told apart
  double motion_length =
      0;                 // metres, length of the motions of the search; 0: half the turning radius
  double weight = 1.03;  // w >= 0 in f = g + w h
  double time_budget = 2;  // seconds of CPU time, for queries without a limit of their own

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"motion_model",
           "how the robot moves: a car with or without reverse gear, a robot that turns in place, "
           "or one that "
           "moves in every direction"},
          self.motion_model);
    field({"turning_radius",
           "least turning radius of a car in metres (in cells on maps in cells), greater than 0"},
          self.turning_radius, OptionRange{0, 1e6});
    field({"allow_reverse", "whether the robot may drive in reverse"}, self.allow_reverse);
    field({"reverse_factor", "factor on the cost of driving in reverse"}, self.reverse_factor,
          OptionRange{1, 1e6});
    field({"turn_factor", "factor on the cost of arcs"}, self.turn_factor, OptionRange{1, 1e6});
    field({"gear_change_cost", "cost of a change between ahead and reverse, in metres"},
          self.gear_change_cost, OptionRange{0, 1e6});
    field({"turn_cost", "cost of turning in place by a radian, in metres"}, self.turn_cost,
          OptionRange{0.001, 1e6});
    field({"headings", "number of headings that the search tells apart"}, self.headings,
          OptionRange{8, 360});
    field({"motion_length",
           "length of the motions of the search in metres; 0: half the turning radius, at least a "
           "cell"},
          self.motion_length, OptionRange{0, 1e6});
    field({"weight", "w in f = g + w h: above 1 it searches less, and paths may cost more"},
          self.weight, OptionRange{1, 100});
    field(
        {"time_budget",
         "CPU time in seconds after which a query without a limit of its own ends with time_limit"},
        self.time_budget, OptionRange{0.001, 1e6});
  }
};

}  // namespace wend
