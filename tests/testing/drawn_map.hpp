#pragma once

// Maps drawn in a test: '.' free, '#' occupied, '?' unknown, '2' to '9' free at that cost. The
// first line is row 0.

#include <string>
#include <string_view>
#include <vector>

#include "wend/robot/free_space.hpp"

namespace wend::test {

inline std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end != 0) lines.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

inline GridMap drawn_map(std::string_view text, Frame frame = {}) {
  const auto lines = lines_of(text);
  const auto width = static_cast<int>(lines.front().size());
  const auto height = static_cast<int>(lines.size());
  Grid<CellState> states(width, height, CellState::free);
  Grid<double> terrain(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const char letter = lines[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      if (letter == '#') states[{x, y}] = CellState::occupied;
      if (letter == '?') states[{x, y}] = CellState::unknown;
      if (letter >= '2' && letter <= '9') terrain[{x, y}] = letter - '0';
    }
  }
  return *make_grid_map(states, frame, terrain);
}

inline FreeSpace drawn_space(std::string_view text, FreeSpaceOptions options = {}) {
  return *make_free_space(drawn_map(text), options);
}

inline FreeSpace open_space(int width, int height) {
  return *make_free_space(*make_grid_map(Grid<CellState>(width, height, CellState::free)));
}

}  // namespace wend::test
