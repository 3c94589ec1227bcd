#pragma once

// The open list of a search as a table, as textbooks print it: what is expanded next, and why that.
//
//   open list: 12, the next first
//        x  y        g        h        f  tie
//    1   5  2        1        3        4
//    2   5  1  1.41421  3.41421  4.82843
//    3   5  3  1.41421  3.41421  4.82843  new
//   9 more
//   new: tied with the one above, the newest is first

#include <string>

#include "wend/planner/observer.hpp"

namespace wend::cli {

inline constexpr int kMostOpenEntries = 10;

/// In at most `rows` rows, but with at least one entry.
std::string open_list_text(const OpenList& list, int rows);

/// With kMostOpenEntries entries at most.
std::string open_list_text(const OpenList& list);

}  // namespace wend::cli
