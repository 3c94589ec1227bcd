#pragma once

// paint(): a picture of the map and of a search after some expansions. A function of its arguments: going back
// costs the same as going on. O(pixels).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lab/wasm/painting/pyramid.hpp"
#include "lab/wasm/painting/replay.hpp"

namespace wend::lab {

/// Colours as the bytes of a canvas: red first, in the lowest byte.
struct Palette {
  std::uint32_t page;
  std::uint32_t free;
  std::uint32_t obstacle;
  std::uint32_t unknown;
  std::uint32_t too_close;
  std::uint32_t rough_least;
  std::uint32_t rough_most;
  std::uint32_t expanded;
  std::uint32_t frontier;
  std::uint32_t current;
  std::uint32_t grid;
  std::array<std::uint32_t, 256> ramp;  // of values, from the least to the greatest
};

/// Which part of the map a picture shows. Pixel (x, y) shows the point left + x * cells, top + y * cells.
struct View {
  int width;     // pixels
  int height;    // pixels
  double left;   // cells
  double top;    // cells, from the row that is drawn first
  double cells;  // a pixel
  bool y_up;     // the last row is drawn first
};

/// Values of cells that are drawn as colours; without values, what the search did is drawn.
struct Values {
  std::span<const float> of_cells = {};  // NaN: unknown; empty: none
  float least = 0;
  float greatest = 1;
  bool of_search = true;  // shown where the search has been
};

/// What is painted.
struct Picture {
  std::span<const std::uint8_t> cells;
  std::span<const std::uint8_t> fits;  // 1: the robot fits; empty: wherever it is free
  int width;
  int height;
  const Pyramid& pyramid;  // with the steps of its level
  const Replay& replay;
  std::uint32_t step;
  Values values = {};
};

/// Paints into `pixels`, width * height of the view.
void paint(const Picture& picture, const View& view, const Palette& palette,
           std::span<std::uint32_t> pixels);

}  // namespace wend::lab
