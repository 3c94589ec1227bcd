#pragma once

// PictureLayout: a picture's size, and where in it the map and the footer lie.

#include "wend/render/map_view.hpp"
#include "wend/render/scene.hpp"

namespace wend {

struct PictureLayout {
  static constexpr int kMargin = 24;  // pixels around the map
  static constexpr int kFooter = 48;  // pixels below it, for scale bar and legend

  int width = 0;   // pixels
  int height = 0;  // pixels
  MapView view;
};

/// The longer side of the whole picture comes out between 800 and 1600 pixels: the map is enlarged
/// by a whole number, or shrunk to fit.
PictureLayout picture_layout(const GridMap& map);

}  // namespace wend
