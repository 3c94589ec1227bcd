#pragma once

// What can be seen of a search without changing it: SearchObserver is told what it does, as it does it;
// OpenList says what it would do next.

#include <cstdint>
#include <optional>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"

namespace wend {

/// One event. Costs are as in Plan::cost; h is 0 where the planner has no heuristic.
struct SearchEvent {
  Cell cell;                   // of a car: its corner
  std::optional<Cell> parent;  // none for the start
  double g;
  double h;
  double f;                                 // the priority, as the planner orders its frontier
  std::optional<Heading> heading{};         // of a car
  std::optional<Heading> parent_heading{};  // of a car, where there is a parent
};

class SearchObserver {
 public:
  virtual ~SearchObserver() = default;

  virtual void on_generate(const SearchEvent& event) = 0;  // reached for the first time
  virtual void on_expand(const SearchEvent& event) = 0;    // taken from the frontier
  virtual void on_relax(const SearchEvent& event) = 0;     // reached again, more cheaply
};

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

/// The open states of a search that is stepped, in the order in which it would expand them.
/// For lessons: which cell comes next, and why that one.
///
///   auto outcome = planner.begin(query, plan);
///   while (!outcome) {
///     const wend::OpenList open = planner.open_list(10);
///     order.push_back(open.entries.front().state.cell);  // the one that step() expands now
///     outcome = planner.step(plan);
///   }
struct OpenList {
  std::vector<OpenEntry> entries;  // the next one first
  std::uint64_t count = 0;         // of all open states
};

}  // namespace wend
