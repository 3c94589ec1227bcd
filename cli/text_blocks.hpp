#pragma once

// Blocks of text beside each other, as columns of a newspaper are.

#include <string>
#include <string_view>
#include <vector>

namespace wend::cli {

/// How many columns of a terminal a line takes: UTF-8, one column a character, colours none.
int columns_of(std::string_view line);

/// Words on as many lines as it takes, each but the first indented by so many columns. A word that
/// is longer than a line has one of its own. No line end after the last.
std::string folded(std::string_view text, int columns, int indent = 0);

/// An aligned grid of cells without colours, each so many columns wide with the blank before it, in
/// bands below each other that fit into the
/// columns, each with a line that says which cells it has; as it is where it fits.
std::string folded_grid(std::string_view grid, int columns_a_cell, int columns);

/// Of the widest line.
int columns_of_all(std::string_view text);

inline constexpr int kGapBetweenBlocks = 3;

/// Each block is lines, each with its end. A block that does not fit into the columns begins
/// below those before it.
std::string side_by_side(const std::vector<std::string>& blocks, int columns);

}  // namespace wend::cli
