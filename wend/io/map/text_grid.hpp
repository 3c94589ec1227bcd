#pragma once

// Text grids: a map as people type it.
//
//   . . # .        0 .    free
//   . 3 # ?        1 # @  blocked
//   ~ . . .        ?      unknown
//                  ~      rough: free, a step costs twice its length
//                  2..9   free, a step costs that many times its length
//
// One line a row, row 0 on top; blanks or tabs between the cells are allowed. LF or CRLF; blank
// lines after the last row are skipped. Beware: 1 is a blocked cell, not a cost.

#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/io/io_error.hpp"
#include "wend/io/line_reader.hpp"
#include "wend/io/map/loaded_map.hpp"

namespace wend {

/// The dearest terrain that a text grid can hold.
inline constexpr double kLargestTextTerrain = 9;

/// Has the first line letters of cells and nothing else?
bool looks_like_text_grid(std::string_view bytes);

/// `file` is the name for errors. Linear time, in the memory of the map.
Expected<LoadedMap, IoError> parse_text_grid(LineReader lines, const std::string& file);

/// The same of a text in memory.
inline Expected<LoadedMap, IoError> parse_text_grid(std::string_view text,
                                                    const std::string& file) {
  return parse_text_grid(LineReader(text), file);
}

/// The file for a map, drawn as the map is; an error says what the format cannot hold.
Expected<std::string, std::string> format_text_grid(const GridMap& map);

}  // namespace wend
