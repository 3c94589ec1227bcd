#include "wend/render/picture/cell_paints.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace wend {
namespace {

// A wall one cell wide must not fade away where eight cells share a pixel.
constexpr double kObstacleWeight = 3;
constexpr double kRoleWeight = 2;

// The one cell that is expanded now shows among hundreds.
constexpr double kCurrentWeight = 40;

double weight_of(CellRole role) { return role == CellRole::current ? kCurrentWeight : kRoleWeight; }

template <class Layer>
bool as_large_as(const Layer& layer, const FreeSpace& space) {
  return layer.width() == space.width() && layer.height() == space.height();
}

// Only an assertion asks.
[[maybe_unused]] bool fits(const Scene& scene) {
  const auto marks = [&](const MarkedCells& marked) {
    return as_large_as(marked.cells, scene.space);
  };
  return std::ranges::all_of(scene.marked, marks) &&
         (!scene.heatmap || as_large_as(scene.heatmap->values, scene.space)) &&
         (!scene.arrows || as_large_as(*scene.arrows, scene.space));
}

}  // namespace

/// The colours of rough ground would be taken for heat.
bool is_rough(const Scene& scene, Cell cell) {
  const GridMap& map = scene.space.map();
  return !scene.heatmap && map.state(cell) != CellState::occupied && map.terrain(cell) != 1;
}

CellPaints::CellPaints(const Scene& scene, const Style& style) : scene_(scene), style_(style) {
  assert(fits(scene));
  if (scene.heatmap) range_ = range_of(*scene.heatmap);
}

std::optional<Colour> CellPaints::heat(Cell cell) const {
  const auto& heatmap = scene_.heatmap;
  if (!heatmap || !range_) return std::nullopt;
  if (scene_.space.map().state(cell) == CellState::occupied) return std::nullopt;
  const double value = heatmap->values[cell];
  if (!std::isfinite(value)) return std::nullopt;
  return style_.heat(range_->share(value));
}

Paint CellPaints::operator[](Cell cell) const {
  const FreeSpace& space = scene_.space;
  const CellState state = space.map().state(cell);
  if (state == CellState::occupied) return {style_.occupied, kObstacleWeight};
  if (const auto role = role_of(scene_, cell)) {
    return {is_rough(scene_, cell) ? style_.of(*role, space.map().terrain(cell)) : style_.of(*role),
            weight_of(*role)};
  }
  if (const auto colour = heat(cell)) return {*colour};
  if (state == CellState::unknown) return {style_.unknown};
  if (!space.passable()[cell]) return {style_.too_close};
  if (!is_rough(scene_, cell)) return {style_.free};
  return {style_.rough(space.map().terrain(cell))};
}

std::optional<Stripes> CellPaints::stripes(Cell cell) const {
  if (!is_rough(scene_, cell)) return std::nullopt;
  const auto role = role_of(scene_, cell);
  if (!role && !style_.stripes_all_rough) return std::nullopt;
  const double multiplier = scene_.space.map().terrain(cell);
  return Stripes{role ? style_.of(*role) : style_.rough(multiplier), style_.stripe(multiplier)};
}

}  // namespace wend
