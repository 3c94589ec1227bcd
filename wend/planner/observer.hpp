#pragma once

// SearchObserver: told what a search does, as it does it. Watching does not change the search.

#include <cstdint>
#include <optional>

#include "wend/geometry/cell.hpp"

namespace wend {

/// One event. Costs are in cells; h is 0 where the planner has no heuristic.
struct SearchEvent {
  Cell cell;
  std::optional<Cell> parent;  // none for the start
  double g;
  double h;
  double f;  // the priority, as the planner orders its frontier
};

class SearchObserver {
 public:
  virtual ~SearchObserver() = default;

  virtual void on_generate(const SearchEvent& event) = 0;  // reached for the first time
  virtual void on_expand(const SearchEvent& event) = 0;    // taken from the frontier
  virtual void on_relax(const SearchEvent& event) = 0;     // reached again, more cheaply
};

}  // namespace wend
