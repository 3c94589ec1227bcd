#pragma once

// PictureLayout: a picture's size, and where in it the map and the footer lie.

#include "wend/render/picture/axis_room.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/scene.hpp"

namespace wend {

struct PictureLayout {
  static constexpr int kMargin = 24;  // pixels around the map
  static constexpr int kFooter = 48;  // pixels below it, for scale bar and legend of one line

  int width = 0;   // pixels
  int height = 0;  // pixels
  MapView view;
  AxisRoom axes;  // around the view

  /// The left end of the middle of the footer's first line.
  Point footer() const;

  /// Room for that many more lines of the footer.
  void add_footer_lines(int lines);
};

/// The longer side of the whole picture comes out between 800 and 1600 pixels, before axes and
/// lines of the footer are added: the map is enlarged by a whole number, or shrunk to fit.
PictureLayout picture_layout(const GridMap& map, const AxisRoom& axes = {});

/// The map as large as fits; from `crisp_from` pixels a cell on, in whole pixels.
MapView fitted_view(const GridMap& map, int most_width, int most_height, double crisp_from);

}  // namespace wend
