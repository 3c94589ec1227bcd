#pragma once

// Heuristics: estimates of the cost between two cells, in straight steps.
//
//   zero       0
//   constant   a value, the same everywhere, the goal included: it changes no order
//   manhattan  |dx| + |dy|            exact on 4 neighbours; too high on 8
//   octile     max + (sqrt(2)-1) min  exact on 8 neighbours
//   euclidean  sqrt(dx^2 + dy^2)
//
// Terrain multipliers are at least 1, so a heuristic that is admissible on uniform terrain is
// admissible on any terrain.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "wend/base/choice.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// A heuristic on a grid; the comment of this header has the formulas.
enum class HeuristicKind {
  automatic,  // the exact one of the connectivity: manhattan on 4 neighbours, octile on 8
  zero,       // 0
  constant,   // the same everywhere
  manhattan,  // the sum of both distances
  octile,     // steps to 8 neighbours
  euclidean   // the straight distance
};

constexpr std::array<Choice<HeuristicKind>, 6> choice_names(HeuristicKind) {
  return {{{"auto", HeuristicKind::automatic},
           {"zero", HeuristicKind::zero},
           {"constant", HeuristicKind::constant},
           {"manhattan", HeuristicKind::manhattan},
           {"octile", HeuristicKind::octile},
           {"euclidean", HeuristicKind::euclidean}}};
}

/// A heuristic as an option of a planner.
struct HeuristicOptions {
  HeuristicKind kind = HeuristicKind::automatic;  // which one
  double constant = 1;                            // the value of HeuristicKind::constant

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"heuristic",
           "estimate of the cost to the goal; auto is manhattan on 4 neighbours and octile on 8"},
          self.kind);
    field({"constant", "value of the constant heuristic"}, self.constant, OptionRange{0, 1e9});
  }
};

/// The kind that `automatic` stands for: the exact one of the connectivity.
constexpr HeuristicKind resolved(HeuristicKind kind, Connectivity connectivity) {
  if (kind != HeuristicKind::automatic) return kind;
  return connectivity == Connectivity::four ? HeuristicKind::manhattan : HeuristicKind::octile;
}

/// Consistent: h(u) <= cost(u, v) + h(v) on every step, so A* is optimal.
constexpr bool is_consistent(HeuristicKind kind, Connectivity connectivity) {
  return resolved(kind, connectivity) != HeuristicKind::manhattan ||
         connectivity == Connectivity::four;
}

/// The value of a heuristic, not `automatic`, between two cells. `constant` is the value of that kind.
inline double heuristic_value(HeuristicKind kind, double constant, Cell from, Cell to) {
  const double dx = std::abs(from.x - to.x);
  const double dy = std::abs(from.y - to.y);
  switch (kind) {
    case HeuristicKind::constant:
      return constant;
    case HeuristicKind::manhattan:
      return dx + dy;
    case HeuristicKind::octile:
      return std::max(dx, dy) + (std::numbers::sqrt2 - 1) * std::min(dx, dy);
    case HeuristicKind::euclidean:
      return std::sqrt(dx * dx + dy * dy);
    case HeuristicKind::zero:
    case HeuristicKind::automatic:
      break;
  }
  return 0;
}

}  // namespace wend
