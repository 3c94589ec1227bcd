#pragma once

// Blocks of text beside each other, as columns of a newspaper are.

#include <string>
#include <string_view>
#include <vector>

namespace wend::cli {

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
