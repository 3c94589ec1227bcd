#pragma once

// What driving on a lattice costs, as options: CarDriving for the car, LatticeCosts for motion primitives.

#include <array>
#include <cstdint>

#include "wend/base/choice.hpp"
#include "wend/base/options.hpp"

namespace wend {

/// How the terrain of the two cells beside a straight move changes its cost.
enum class StraightTerrain {
  none,  // nothing: it costs 1
  mean,  // the mean of their multipliers
  max,   // the larger one
};

constexpr std::array<Choice<StraightTerrain>, 3> choice_names(StraightTerrain) {
  return {{{"none", StraightTerrain::none},
           {"mean", StraightTerrain::mean},
           {"max", StraightTerrain::max}}};
}

/// How a car drives on the corners of a grid: the resolution of its lattice, and the cost of its moves.
struct CarDriving {
  static constexpr double kLeastReverseFactor = 0.01;  // the smallest valid reverse_factor

  std::int64_t unit = 1;  // spacing of the lattice in map cells, which is also the turning radius
  StraightTerrain straight_terrain =
      StraightTerrain::none;  // what a straight move costs on terrain
  double reverse_factor = 1;  // factor on the cost of a move in reverse

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({.name = "lattice_resolution",
           .help = "spacing of the car's lattice in map cells, which is also its turning radius",
           .former = "unit"},
          self.unit, OptionRange{1, 1e6});
    field({"straight_terrain",
           "what a straight move costs on terrain: 1, or the mean or the larger multiplier of the "
           "two cells beside it"},
          self.straight_terrain);
    field({"reverse_factor", "factor on the cost of a move in reverse"}, self.reverse_factor,
          OptionRange{kLeastReverseFactor, 1e6});
  }
};

/// What motion primitives cost besides their length.
struct LatticeCosts {
  double reverse_factor = 2;  // factor on the cost of driving in reverse
  double turn_cost = 1;       // cells a radian, of a turn in place

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"reverse_factor", "factor on the cost of driving in reverse"}, self.reverse_factor,
          OptionRange{0.01, 1e6});
    field({"turn_cost", "cost of turning in place by a radian, in cells"}, self.turn_cost,
          OptionRange{0.001, 1e6});
  }
};

}  // namespace wend
