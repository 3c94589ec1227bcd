#pragma once

// Layout: how large pictures are, and where in them the map, its axes, the scale bar and panels lie.
// Picture coordinates are pixels with y down, from the picture's top left corner.

#include <span>
#include <string>
#include <vector>

#include "wend/render/picture/panels.hpp"
#include "wend/render/scene.hpp"

namespace wend {

/// Where the map lies in a picture: the map's drawn top left corner is at (left, top).
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

  double bottom() const { return top + height; }

  /// Grid coordinates to picture coordinates.
  Point to_picture(Point grid) const {
    const double across = grid.x / columns;
    const double down = y_up ? 1 - grid.y / rows : grid.y / rows;
    return {left + across * width, top + down * height};
  }

  /// A heading as an angle in the picture, clockwise from the right.
  double angle_of(double heading) const { return y_up ? -heading : heading; }
};

/// The map as large as fits; from `crisp_from` pixels a cell on, in whole pixels.
MapView fitted_view(const GridMap& map, int most_width, int most_height, double crisp_from);

inline constexpr double kAxisFontSize = 15;  // pixels
inline constexpr double kAxisTick = 5;       // pixels
inline constexpr double kAxisGap = 10;       // between a tick and its number: a mark may lie there

/// Of a digit in that font.
inline constexpr double kAxisDigitHeight = 0.73 * kAxisFontSize;

/// Pixels or characters at the sides of a map.
struct Margins {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  int across() const { return left + right; }
  int down() const { return top + bottom; }
};

/// The margins for the axes of a car's lattice; 0 where places are cells.
Margins axis_room(const Scene& scene);

/// How many cells lie between two numbers on an axis, where a cell has that many pixels.
int axis_step(const Scene& scene, double scale);

/// The least of 1, 2, 5, 10, 20, 50, 100 ... that is not less; at most 10^9.
int round_step(double least);

/// A bar of a round length, to tell sizes in a picture by.
struct ScaleBar {
  double pixels = 1;
  std::string label;  // "5 m", "10 cells"

  friend bool operator==(const ScaleBar&, const ScaleBar&) = default;
};

/// The longest bar of 1, 2 or 5 times a power of ten that is not longer than `most` pixels. Metres
/// where the frame is metric, else cells, and then at least one.
ScaleBar scale_bar(const Frame& frame, double pixels_a_cell, double most = 200);

/// A picture's size, and where in it the map and the footer lie.
struct PictureLayout {
  static constexpr int kMargin = 24;  // pixels around the map
  static constexpr int kFooter = 48;  // pixels below it, for scale bar and legend of one line

  int width = 0;   // pixels
  int height = 0;  // pixels
  MapView view;
  Margins axes;  // around the view

  /// The left end of the middle of the footer's first line.
  Point footer() const {
    return {kMargin, view.bottom() + axes.bottom + (kMargin + kFooter) / 2.0};
  }
};

/// The longer side of the whole picture comes out between 800 and 1600 pixels, before axes and
/// further lines of the footer are added: the map is enlarged by a whole number, or shrunk to fit.
PictureLayout picture_layout(const GridMap& map, const Margins& axes = {});

/// One panel: a title, the map, then a caption and perhaps a legend.
struct PanelPlace {
  double left = 0;    // pixels
  double top = 0;     // of the title
  double width = 0;   // of the map and all text
  double height = 0;  // of it all
  MapView view;
  Margins axes;  // around the view
};

struct PanelLayout {
  static constexpr int kMargin = 24;  // pixels around it all
  static constexpr int kGap = 40;     // between panels
  static constexpr int kTitle = 34;   // high
  static constexpr int kCaptionLine = 22;

  int width = 0;  // pixels
  int height = 0;
  std::vector<PanelPlace> places;
};

/// `below` is the room below each map, for caption and legend, in pixels.
PanelLayout panel_layout(std::span<const Panel> panels, double below);

/// The same with that many columns.
PanelLayout panel_layout(std::span<const Panel> panels, double below, int columns);

}  // namespace wend
