#pragma once

// MapView: where the map lies in a picture. Picture coordinates are pixels with y down, from the
// picture's top left corner; the map's drawn top left corner is at (left, top).

#include "wend/geometry/pose.hpp"

namespace wend {

struct MapView {
  double left = 0;
  double top = 0;
  int width = 0;    // pixels
  int height = 0;   // pixels
  int columns = 1;  // cells
  int rows = 1;     // cells
  bool y_up = false;

  /// Pixels a cell. Only extremely long maps have other ones across: they are at least a pixel
  /// wide.
  double scale() const {
    return columns >= rows ? static_cast<double>(width) / columns
                           : static_cast<double>(height) / rows;
  }

  /// Grid coordinates to picture coordinates.
  Point to_picture(Point grid) const {
    const double across = grid.x / columns;
    const double down = y_up ? 1 - grid.y / rows : grid.y / rows;
    return {left + across * width, top + down * height};
  }
};

}  // namespace wend
