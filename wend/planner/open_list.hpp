#pragma once

// OpenList: the open states of a search that is stepped, in the order in which it would expand them.
// For lessons: which cell comes next, and why that one.
//
//   auto outcome = planner.begin(query, plan);
//   while (!outcome) {
//     const wend::OpenList open = planner.open_list(10);
//     order.push_back(open.entries.front().state.cell);  // the one that step() expands now
//     outcome = planner.step(plan);
//   }
//
// A plain value.

#include <cstdint>
#include <vector>

#include "wend/planner/observer.hpp"

namespace wend {

/// What decides between an entry and the one before it.
enum class OpenTie : unsigned char {
  none,   // the smaller f, or the order of arrival of a frontier that has no other
  g,      // f is the same: the larger g comes first
  newest  // f and g are the same: what was opened last comes first
};

struct OpenEntry {
  SearchEvent state;  // how it was reached last
  OpenTie tie = OpenTie::none;
};

struct OpenList {
  std::vector<OpenEntry> entries;  // the next one first
  std::uint64_t count = 0;         // of all open states
};

}  // namespace wend
