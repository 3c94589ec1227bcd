#pragma once

// Panels: several scenes beside each other in one picture, to compare planners, robots or styles.
//
//   const std::vector<wend::Panel> panels{{"A*", with_astar, "412 cells expanded"},
//                                         {"Dijkstra", with_dijkstra, "8321 cells expanded"}};
//   const auto svg = wend::draw_panels(panels, wend::PictureKind::svg);
//
// They share one legend. Heatmaps of the same title share one range too, so that equal colours mean
// equal numbers; a range that a heatmap asks for is heeded, and widens the others'. A panel with a
// style of its own has a legend of its own.

#include <optional>
#include <span>
#include <string>

#include "wend/render/picture/drawing.hpp"

namespace wend {

struct Panel {
  std::string title;
  Scene scene;
  std::string caption{};  // below it; '\n' ends a line, a long one is broken into two
  std::optional<Style> style{};
};

/// The bytes of a file of that kind, 600 to 2000 pixels wide, with as many columns as make it
/// pleasant to look at. Text that does not fit ends in an ellipsis. There is at least one panel.
Expected<std::string, Error> draw_panels(std::span<const Panel> panels, PictureKind kind,
                                         const Style& style = {});

}  // namespace wend
