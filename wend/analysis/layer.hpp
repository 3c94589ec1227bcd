#pragma once

// Layer: one thing that is known of every cell of a map, for people to look at: what a search did
// there, what it costs to go on from there, what the map is there. Numbers, or directions.
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
#include "wend/geometry/direction.hpp"
#include "wend/map/free_space.hpp"
#include "wend/map/grid.hpp"
#include "wend/planner/planner.hpp"

namespace wend {

enum class LayerKind {
  // Of a search; of a car's, of the corners of a cell.
  expansion,   // the order in which cells were expanded, from 1
  generation,  // the order in which they were reached, from 1
  g,           // what the path to a cell costs, as far as the search knows
  heuristic,   // the planner's estimate of the rest, of every cell where the robot may be
  f,           // the priority
  closed,      // 1 where the search has been, else 0
  frontier,    // 1 where it would have gone on, else 0
  parent,      // towards the cell from which a cell was reached
  // Of a cost-to-go field.
  cost,    // what the cheapest path to the goal costs
  policy,  // which way to move
  // Of the map and the robot.
  occupied,   // 1 occupied, 0 free
  clearance,  // distance to the nearest obstacle, in cells
  terrain,    // what a unit of length costs this robot
};

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

/// Where a layer comes from.
enum class LayerSource { search, cost_to_go, map };

LayerSource source_of(LayerKind kind);

/// "order of expansion", "clearance"
std::string_view title_of(LayerKind kind);

/// Are its numbers lengths, in cells?
bool is_length(LayerKind kind);

struct Layer {
  LayerKind kind;
  Grid<double> numbers;                   // NaN where nothing is known; empty for directions
  Grid<std::optional<Direction>> arrows;  // empty for numbers
};

/// Of the search that `recorder` watched. The heuristic is that of `planner`'s last query.
Layer search_layer(LayerKind kind, const Planner& planner, const SearchRecorder& recorder);

/// Of a cost-to-go field for the same space.
Layer cost_to_go_layer(LayerKind kind, const FreeSpace& space, const CostToGo& field);

/// Of the map and the robot. Obstacles have no clearance, and cells where the robot may not be no
/// terrain.
Layer map_layer(LayerKind kind, const FreeSpace& space);

}  // namespace wend
