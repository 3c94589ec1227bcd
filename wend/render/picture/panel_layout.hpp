#pragma once

// PanelLayout: where in a picture its panels lie.

#include <span>
#include <vector>

#include "wend/render/picture/axis_room.hpp"
#include "wend/render/picture/map_view.hpp"
#include "wend/render/picture/panels.hpp"

namespace wend {

/// One panel: a title, the map, then a caption and perhaps a legend.
struct PanelPlace {
  double left = 0;    // pixels
  double top = 0;     // of the title
  double width = 0;   // of the map and all text
  double height = 0;  // of it all
  MapView view;
  AxisRoom axes;  // around the view
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
