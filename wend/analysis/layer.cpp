#include "wend/analysis/layer.hpp"

#include <cassert>
#include <limits>

#include "wend/map/distance_field.hpp"

namespace wend {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// A grid of value(cell) for every cell of the space.
template <class Value>
auto grid_of(const FreeSpace& space, Value&& value) {
  Grid<decltype(value(Cell{}))> grid(space.width(), space.height());
  for (const Cell cell : every_cell(grid)) grid[cell] = value(cell);
  return grid;
}

double order_or_nothing(std::uint32_t order) {
  return order == 0 ? kNothing : static_cast<double>(order);
}

double unless_blocked(const FreeSpace& space, Cell cell, double value) {
  return space.passable(cell) ? value : kNothing;
}

Grid<double> search_numbers(LayerKind kind, const Planner& planner,
                            const SearchRecorder& recorder) {
  const FreeSpace& space = planner.free_space();
  const SearchLayers& layers = recorder.layers();
  switch (kind) {
    case LayerKind::expansion:
      return grid_of(space, [&](Cell cell) { return order_or_nothing(layers.expansion[cell]); });
    case LayerKind::generation:
      return grid_of(space, [&](Cell cell) { return order_or_nothing(layers.generation[cell]); });
    case LayerKind::g:
      return layers.g;
    case LayerKind::f:
      return layers.f;
    case LayerKind::heuristic:
      return grid_of(
          space, [&](Cell cell) { return unless_blocked(space, cell, planner.heuristic(cell)); });
    case LayerKind::closed:
      return grid_of(space, [&](Cell cell) {
        return unless_blocked(space, cell, layers.expansion[cell] != 0 ? 1 : 0);
      });
    case LayerKind::frontier:
      return grid_of(space, [&](Cell cell) {
        const bool open = layers.generation[cell] != 0 && layers.expansion[cell] == 0;
        return unless_blocked(space, cell, open ? 1 : 0);
      });
    default:
      assert(false && "not a layer of a search");
      return {};
  }
}

double occupied_or_free(CellState state) {
  if (state == CellState::unknown) return kNothing;
  return state == CellState::occupied ? 1 : 0;
}

}  // namespace

LayerSource source_of(LayerKind kind) {
  switch (kind) {
    case LayerKind::cost:
    case LayerKind::policy:
      return LayerSource::cost_to_go;
    case LayerKind::occupied:
    case LayerKind::clearance:
    case LayerKind::terrain:
      return LayerSource::map;
    default:
      return LayerSource::search;
  }
}

bool is_length(LayerKind kind) { return kind == LayerKind::clearance; }

std::string_view title_of(LayerKind kind) {
  constexpr std::array<Choice<LayerKind>, 13> kTitles{
      {{"order of expansion", LayerKind::expansion},
       {"order of generation", LayerKind::generation},
       {"g, cost from the start", LayerKind::g},
       {"h, estimate of the rest", LayerKind::heuristic},
       {"f, priority", LayerKind::f},
       {"closed", LayerKind::closed},
       {"frontier", LayerKind::frontier},
       {"parent", LayerKind::parent},
       {"cost to the goal", LayerKind::cost},
       {"policy", LayerKind::policy},
       {"occupied", LayerKind::occupied},
       {"clearance", LayerKind::clearance},
       {"terrain, cost of a unit of length", LayerKind::terrain}}};
  return choice_name(kind, kTitles);
}

Layer search_layer(LayerKind kind, const Planner& planner, const SearchRecorder& recorder) {
  assert(source_of(kind) == LayerSource::search);
  if (kind == LayerKind::parent) return {kind, {}, recorder.layers().parent};
  Layer layer{kind, search_numbers(kind, planner, recorder), {}};
  if (kind == LayerKind::expansion) layer.motions = recorder.motions();
  return layer;
}

Layer cost_to_go_layer(LayerKind kind, const FreeSpace& space, const CostToGo& field) {
  assert(source_of(kind) == LayerSource::cost_to_go);
  if (kind == LayerKind::policy) {
    return {kind, {}, grid_of(space, [&](Cell cell) { return field.policy(cell); })};
  }
  const auto cost = [&](Cell cell) { return unless_blocked(space, cell, field.cost(cell)); };
  return {kind, grid_of(space, cost), {}};
}

Layer map_layer(LayerKind kind, const FreeSpace& space) {
  assert(source_of(kind) == LayerSource::map);
  if (kind == LayerKind::occupied) {
    const GridMap& map = space.map();
    return {kind, grid_of(space, [&](Cell cell) { return occupied_or_free(map.state(cell)); }), {}};
  }
  const auto number = [&](Cell cell) {
    if (kind == LayerKind::terrain) return unless_blocked(space, cell, space.terrain(cell));
    if (space.obstacles().blocked()[cell]) return kNothing;
    return distance_in_cells(space.squared_half_cell_clearance()[cell]);
  };
  return {kind, grid_of(space, number), {}};
}

}  // namespace wend
