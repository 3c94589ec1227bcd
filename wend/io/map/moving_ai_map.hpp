#pragma once

// MovingAI `.map` files, the format of the field's grid benchmarks.
//
//   type octile
//   height 2
//   width 3
//   map
//   ..@
//   .GT
//
// Row 0 is the top row, one letter a cell, LF or CRLF line ends. `. G S` are free, `@ O T W`
// occupied; every cell costs the same. `E` (an emitter on the warehouse maps of the League of
// Robot Runners) is free, and lower-case letters are read as upper-case ones; both get a note.
// The header's two sizes may come in either order. Other types (`tile`, `patch`, `octile-corner`)
// are other formats and refused by name.

#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/io/io_error.hpp"
#include "wend/io/line_reader.hpp"
#include "wend/io/map/loaded_map.hpp"

namespace wend {

/// `file` is the name for errors. Linear time, in the memory of the map: its rows are kept as they
/// come.
Expected<LoadedMap, IoError> parse_moving_ai_map(LineReader lines, const std::string& file);

/// The same of a text in memory.
inline Expected<LoadedMap, IoError> parse_moving_ai_map(std::string_view text,
                                                        const std::string& file) {
  return parse_moving_ai_map(LineReader(text), file);
}

/// The file for a map, drawn as the map is; an error says what the format cannot hold.
Expected<std::string, std::string> format_moving_ai_map(const GridMap& map);

}  // namespace wend
