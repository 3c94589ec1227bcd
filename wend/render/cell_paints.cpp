#include "wend/render/cell_paints.hpp"

#include <algorithm>
#include <cmath>

namespace wend {
namespace {

// A wall one cell wide must not fade away where eight cells share a pixel.
constexpr double kObstacleWeight = 3;
constexpr double kVisitedWeight = 2;

BitGrid bits_of(const std::vector<Cell>& cells, const FreeSpace& space) {
  if (cells.empty()) return {};
  BitGrid bits(space.width(), space.height());
  for (const Cell cell : cells) {
    if (bits.contains(cell)) bits.set(cell, true);
  }
  return bits;
}

}  // namespace

double roughness(double multiplier) { return std::min(1.0, std::log10(multiplier)); }

CellPaints::CellPaints(const Scene& scene, const Style& style)
    : scene_(scene), style_(style), visited_(bits_of(scene.visited, scene.space)) {}

Paint CellPaints::operator[](Cell cell) const {
  const FreeSpace& space = scene_.space;
  const CellState state = space.map().state(cell);
  if (state == CellState::occupied) return {style_.occupied, kObstacleWeight};
  if (visited_.contains(cell) && visited_[cell]) return {style_.visited, kVisitedWeight};
  if (state == CellState::unknown) return {style_.unknown};
  if (!space.passable()[cell]) return {style_.too_close};
  const double multiplier = space.terrain(cell);
  if (multiplier == 1) return {style_.free};
  return {mixed(style_.slightly_rough, style_.very_rough, roughness(multiplier))};
}

}  // namespace wend
