#pragma once

// Layer: a value for every cell of a map, to be shown: of a search, of the cost to go, or of the
// map. Numbers or directions.
//
//   const wend::Layer order = wend::search_layer(wend::LayerKind::expansion, planner, recorder);
//   const double first = order.numbers[{1, 1}];  // 1: the start
//
// Values; made in O(cells).

#include <array>
#include <optional>
#include <string_view>

#include "wend/analysis/cost_to_go.hpp"
#include "wend/analysis/search_recorder.hpp"
#include "wend/base/choice.hpp"
#include "wend/base/compiler.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/map/grid.hpp"
#include "wend/planner/planner.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// What the values of a layer mean.
enum class LayerKind {
  // From a search; for a car, from the lattice vertices that the cell touches.
  expansion,   // the order in which cells were expanded, from 1
  generation,  // the order in which they were reached, from 1
  g,           // the cost of the cheapest known path to a cell
  heuristic,   // the planner's estimate of the remaining cost, for every passable cell
  f,           // the priority
  closed,      // 1 if the cell was expanded, else 0
  frontier,    // 1 if the cell is open, else 0
  parent,      // towards the cell from which a cell was reached
  // Of a cost-to-go field.
  cost,    // the cost of the cheapest path to the goal
  policy,  // the direction to move
  // Of the map and the robot.
  occupied,   // 1 occupied, 0 free
  clearance,  // distance to the nearest obstacle, in cells
  terrain,    // the cost of a unit of length for this robot
};

/// The values and their names, as options and reports spell them.
constexpr std::array<Choice<LayerKind>, 13> choice_names(LayerKind) {
  return {{{"expansion", LayerKind::expansion},
           {"generation", LayerKind::generation},
           {"g", LayerKind::g},
           {"heuristic", LayerKind::heuristic},
           {"f", LayerKind::f},
           {"closed", LayerKind::closed},
           {"frontier", LayerKind::frontier},
           {"parent", LayerKind::parent},
           {"cost", LayerKind::cost},
           {"policy", LayerKind::policy},
           {"occupied", LayerKind::occupied},
           {"clearance", LayerKind::clearance},
           {"terrain", LayerKind::terrain}}};
}

/// The source of a layer.
enum class LayerSource {
  search,      // search_layer() makes it
  cost_to_go,  // cost_to_go_layer()
  map          // map_layer()
};

/// The source of a layer of this kind.
WEND_API LayerSource source_of(LayerKind kind);

/// "order of expansion", "clearance"
WEND_API std::string_view title_of(LayerKind kind);

/// Are its numbers lengths, in cells?
WEND_API bool is_length(LayerKind kind);

struct Layer {
  LayerKind kind;                         // what the values mean
  Grid<double> numbers;                   // NaN if unknown; empty for directions
  Grid<std::optional<Direction>> arrows;  // empty for numbers
  /// Of `expansion` with a planner of continuous poses: what was driven, in order; empty for others.
  MotionTree motions{};
};

/// A layer of the search that `recorder` observed. The heuristic is that of `planner`'s last query.
WEND_API Layer search_layer(LayerKind kind, const Planner& planner, const SearchRecorder& recorder);

/// A layer of a cost-to-go field for the same space.
WEND_API Layer cost_to_go_layer(LayerKind kind, const FreeSpace& space, const CostToGo& field);

/// A layer of the map and the robot. Obstacles have no clearance, and impassable cells have no
/// terrain.
WEND_API Layer map_layer(LayerKind kind, const FreeSpace& space);

}  // namespace wend
