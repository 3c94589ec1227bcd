#pragma once

// What the program writes to: a terminal or not, and how large it is.

#include <string>
#include <string_view>
#include <vector>

#include "wend/render/terminal/terminal_picture.hpp"

namespace wend::cli {

struct Screen {
  bool is_terminal = false;
  int columns = 80;  // where it is no terminal, as wide as one mostly is
  int rows = 60;
  Terminal terminal;  // ASCII without colours if the output is not a terminal
};

/// Standard output. NO_COLOR is respected.
Screen detect_screen();

/// Does it draw pictures with pixels of their own, over which no text can stand?
bool has_pixels(const Terminal& terminal);

/// Is somebody watching standard error?
bool progress_is_seen();

/// How many columns of a terminal a line takes: UTF-8, one column a character, colours none.
int columns_of(std::string_view line);

/// The text, broken into lines of at most `columns`; lines after the first are indented. A word longer
/// than a line gets its own line. The last line has no line end.
std::string folded(std::string_view text, int columns, int indent = 0);

/// An aligned grid of cells without colours, each `columns_a_cell` wide with the blank before it. A grid
/// wider than `columns` is split into bands below each other; a line above each names its cells.
std::string folded_grid(std::string_view grid, int columns_a_cell, int columns);

/// Of the widest line.
int columns_of_all(std::string_view text);

inline constexpr int kGapBetweenBlocks = 3;

/// Each block is lines, each with its end. A block that does not fit into the columns begins
/// below those before it.
std::string side_by_side(const std::vector<std::string>& blocks, int columns);

}  // namespace wend::cli
