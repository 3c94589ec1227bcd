#pragma once

// The options of the planners that keep what they found for the next query, as structs. Front ends set the same
// fields by name.
//
//   const auto planner = wend::make_planner(space, wend::ReplannerOptions{});

#include <string_view>

#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// The options of `replanner`.
struct ReplannerOptions {
  static constexpr std::string_view kPlanner = "replanner";  // its name

  GridMoves moves = {};  // how the robot steps

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
  }
};

/// The options of `d_star_lite`.
struct DStarLiteOptions {
  static constexpr std::string_view kPlanner = "d_star_lite";  // its name

  GridMoves moves = {};  // how the robot steps

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
  }
};

}  // namespace wend
