#pragma once

// CarDriving: how a car drives on the corners of a grid: how wide its lattice is, and what its
// moves cost.

#include <array>
#include <cstdint>

#include "wend/base/choice.hpp"

namespace wend {

/// What a straight move pays for the terrain of the two cells that it runs between.
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

struct CarDriving {
  static constexpr double kLeastReverseFactor = 0.01;

  std::int64_t unit = 1;  // map cells
  StraightTerrain straight_terrain = StraightTerrain::none;
  double reverse_factor = 1;

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

}  // namespace wend
