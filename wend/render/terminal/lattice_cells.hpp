#pragma once

// The cells of a car's lattice as characters: blocks of unit x unit cells of the map. What is left
// over at the map's far edges belongs to no cell.

#include "wend/map/grid.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/terminal/text_glyphs.hpp"

namespace wend {

/// How many cells there are across and down.
inline Cell lattice_size(const Scene& scene) {
  const int unit = scene.unit.value_or(1);
  return {scene.space.width() / unit, scene.space.height() / unit};
}

/// Each an obstacle if any of its cells is, else what has a role, else unknown if any is, too close
/// if more than half of them are; else rough by their mean terrain. In ASCII that has its digit.
Grid<Glyph> lattice_cells(const Scene& scene, bool ascii);

}  // namespace wend
