#pragma once

// GridMoves: how a robot moves on a grid: to 4 or 8 neighbours, and what a diagonal step may pass.

#include <array>

#include "wend/base/choice.hpp"
#include "wend/map/connected_components.hpp"

namespace wend {

enum class Connectivity { four, eight };

/// How many of the two cells beside a diagonal step may be blocked.
enum class CornerRule {
  none,  // both must be passable: no corner is cut
  one,   // one of them may be blocked
  both,  // both may be blocked: the robot squeezes between two corners
};

constexpr std::array<Choice<Connectivity>, 2> choice_names(Connectivity) {
  return {{{"4", Connectivity::four}, {"8", Connectivity::eight}}};
}

constexpr std::array<Choice<CornerRule>, 3> choice_names(CornerRule) {
  return {{{"none", CornerRule::none}, {"one", CornerRule::one}, {"both", CornerRule::both}}};
}

struct GridMoves {
  Connectivity connectivity = Connectivity::eight;
  CornerRule corner_rule = CornerRule::none;

  /// Which cells such moves connect.
  Adjacency adjacency() const {
    const bool squeezes = connectivity == Connectivity::eight && corner_rule == CornerRule::both;
    return squeezes ? Adjacency::edges_and_corners : Adjacency::edges;
  }

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"connectivity", "number of neighbours of a cell: 4 or 8"}, self.connectivity);
    field({"corner_rule", "corners that a diagonal step may cut: none, one or both"},
          self.corner_rule);
  }

  friend bool operator==(const GridMoves&, const GridMoves&) = default;
};

}  // namespace wend
