#pragma once

// SearchObserver: told what a search does, as it does it. Watching does not change the search.

#include <cstdint>
#include <optional>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/heading.hpp"

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

}  // namespace wend
