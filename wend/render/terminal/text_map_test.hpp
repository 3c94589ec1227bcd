#pragma once

// Small maps for tests, written as they are drawn.

#include <string>
#include <string_view>
#include <vector>

#include "wend/map/grid_map.hpp"

namespace wend {

/// '#' occupied, '?' unknown, '1' to '9' free with that terrain, anything else free. With y up, the
/// last line is row 0.
inline GridMap map_of(const std::vector<std::string_view>& lines, Frame frame = {}) {
  const int width = static_cast<int>(lines.front().size());
  const int height = static_cast<int>(lines.size());
  Grid<CellState> cells(width, height);
  Grid<double> terrain(width, height, 1);
  for (int n = 0; n < height; ++n) {
    for (int x = 0; x < width; ++x) {
      const Cell cell{x, frame.y_up ? height - 1 - n : n};
      const char character = lines[static_cast<std::size_t>(n)][static_cast<std::size_t>(x)];
      if (character == '#') cells[cell] = CellState::occupied;
      if (character == '?') cells[cell] = CellState::unknown;
      if (character >= '1' && character <= '9') terrain[cell] = character - '0';
    }
  }
  return *make_grid_map(cells, frame, terrain);
}

/// The cells that are drawn as that character, as a layer; y is down.
inline BitGrid marked_of(const std::vector<std::string_view>& lines, char character) {
  BitGrid cells(static_cast<int>(lines.front().size()), static_cast<int>(lines.size()));
  for (int y = 0; y < cells.height(); ++y) {
    const std::string_view line = lines[static_cast<std::size_t>(y)];
    for (int x = 0; x < cells.width(); ++x) {
      cells.set({x, y}, line[static_cast<std::size_t>(x)] == character);
    }
  }
  return cells;
}

/// Lines joined by '\n', with one after the last.
inline std::string lines_of(const std::vector<std::string_view>& lines) {
  std::string text;
  for (const std::string_view line : lines) {
    text += line;
    text += '\n';
  }
  return text;
}

}  // namespace wend
