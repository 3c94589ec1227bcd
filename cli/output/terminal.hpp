#pragma once

// The output of the program: whether it is a terminal, and its size.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "wend/render/terminal/terminal_picture.hpp"

namespace wend::cli {

inline constexpr int kUsualColumns = 80;

struct Screen {
  bool is_terminal = false;
  int columns = kUsualColumns;  // if it is not a terminal
  int rows = 60;
  Terminal terminal;  // ASCII without colours if the output is not a terminal
};

/// Standard output. NO_COLOR is respected.
Screen detect_screen();

/// Does it draw pictures in pixels, over which it cannot write text?
bool has_pixels(const Terminal& terminal);

/// For tables: the terminal's width, but no less than what all of them fit into.
std::size_t table_width(const Screen& screen);

/// Is somebody watching standard error?
bool progress_is_seen();

/// The number of terminal columns of a line: UTF-8, one column per character, none for colours.
int columns_of(std::string_view line);

/// The text, broken into lines of at most `columns`; lines after the first are indented. A word longer
/// than a line gets its own line. The last line has no line end.
std::string folded(std::string_view text, int columns, int indent = 0);

/// An aligned grid of cells without colours, each `columns_a_cell` wide with the blank before it. A grid
/// wider than `columns` is split into bands below each other; a line above each names its cells.
std::string folded_grid(std::string_view grid, int columns_a_cell, int columns);

/// The rows that the text takes on a screen that breaks longer lines.
int rows_on_screen(std::string_view text, int columns);

/// The number of columns of the widest line.
int columns_of_all(std::string_view text);

inline constexpr int kGapBetweenBlocks = 3;

/// Each block consists of lines with line ends. A block that does not fit into the columns begins
/// below those before it.
std::string side_by_side(const std::vector<std::string>& blocks, int columns);

}  // namespace wend::cli
