#pragma once

// Generated maps, and their drawings as text, for the tests of the generators.

#include <string>

#include "wend/generate/generators.hpp"

namespace wend::test {

inline GridMap made(const std::string& name, int width, int height, std::uint64_t seed,
                    const OptionValues& options = {}) {
  return make_map(name, width, height, seed, options).value();
}

inline std::string error_of(const std::string& name, int width, int height,
                            const OptionValues& options = {}) {
  const auto map = make_map(name, width, height, 1, options);
  return map ? "no error" : map.error().message;
}

/// Draws a map as a text grid: # for occupied, ? for unknown, digits for cells that cost more than 1.
inline std::string drawn(const GridMap& map) {
  std::string text;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const Cell cell{x, y};
      const CellState state = map.state(cell);
      const int cost = static_cast<int>(map.terrain(cell));
      const char free = cost == 1 ? '.' : static_cast<char>('0' + cost);
      text += state == CellState::occupied ? '#' : state == CellState::unknown ? '?' : free;
    }
    text += '\n';
  }
  return text;
}

}  // namespace wend::test
