#pragma once

// GridEngine: a search on the cells of a grid.

#include "wend/planner/search_engine.hpp"

namespace wend {

using GridEngine = SearchEngine<Cell, Cell>;

struct GridNames {
  static Cell place(const auto& state) { return state.cell; }
  static void tell_place(SearchEvent& event, const auto& /*space*/, Cell cell) {
    event.cell = cell;
  }
  static void tell_parent(SearchEvent& event, const auto& /*space*/, Cell cell) {
    event.parent = cell;
  }
  static void append(Path& path, const auto& /*space*/, Cell cell) { path.append(cell); }
};

template <class Space, class Frontier, class Priority, DuplicateRule kDuplicates>
using GridEngineOf = SearchEngineOf<GridEngine, GridNames, Space, Frontier, Priority, kDuplicates>;

}  // namespace wend
