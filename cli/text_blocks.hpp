#pragma once

// Blocks of text beside each other, as columns of a newspaper are.

#include <string>
#include <string_view>
#include <vector>

namespace wend::cli {

/// How many columns of a terminal a line takes: UTF-8, one column a character, colours none.
int columns_of(std::string_view line);

/// Each block is lines, each with its end. A block that does not fit into the columns begins
/// below those before it.
std::string side_by_side(const std::vector<std::string>& blocks, int columns);

}  // namespace wend::cli
