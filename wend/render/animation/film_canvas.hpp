#pragma once

// FilmCanvas: the frames of a film, one after the other in the same buffers: one map or several beside each other, each
// below its name and a counter, and one legend of everything that occurs in the film.
//
//   wend::FilmCanvas canvas(last, wend::legend_of(scenes, style), 800, 640, style);
//   animation.add(canvas.draw(frame), 5);
//
// The layout is that of the panels that it is made with; the frames have panels of the same maps in the same order.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "wend/map/grid.hpp"
#include "wend/render/legend.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

/// One of the maps of a frame.
struct FilmPanel {
  std::string title;    // above it, on the left: "astar"
  std::string counter;  // above it, on the right: "120 expanded"
  Scene scene;
};

class FilmCanvas {
 public:
  /// At least one panel. The whole film has at most that many pixels across and down unless its texts need more.
  FilmCanvas(std::span<const FilmPanel> panels, std::vector<LegendItem> legend, int most_width,
             int most_height, const Style& style);
  FilmCanvas(const FilmCanvas&) = delete;
  FilmCanvas& operator=(const FilmCanvas&) = delete;
  ~FilmCanvas();

  /// A frame as 0xRRGGBB, valid until the next one; empty if there is not enough memory.
  const Grid<std::uint32_t>& draw(std::span<const FilmPanel> panels);

 private:
  class Sheet;
  std::unique_ptr<Sheet> sheet_;
};

}  // namespace wend
