#pragma once

// The options of the planners that keep what they found for the next query, as structs. Front ends set the same
// fields by name.
//
//   const auto planner = wend::make_planner(space, wend::ReplannerOptions{});

#include <array>
#include <string_view>

#include "wend/base/choice.hpp"
#include "wend/base/options.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// How `replanner` searches when the last path does not do.
enum class ReplanSearch {
  automatic,  // whichever of both has been cheaper
  leaps,      // from scratch, with leaps
  tree,       // repairs the tree of the last search
};

constexpr std::array<Choice<ReplanSearch>, 3> choice_names(ReplanSearch) {
  return {{{"automatic", ReplanSearch::automatic},
           {"leaps", ReplanSearch::leaps},
           {"tree", ReplanSearch::tree}}};
}

/// The options of `replanner`.
struct ReplannerOptions {
  static constexpr std::string_view kPlanner = "replanner";  // its name

  GridMoves moves = {};                           // how the robot steps
  ReplanSearch search = ReplanSearch::automatic;  // when the last path does not do

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    GridMoves::fields(self.moves, field);
    field(
        {"search",
         "search if the last path is no longer the cheapest: leaps: from scratch; tree: repair the "
         "last search; automatic: whichever has been cheaper"},
        self.search);
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
