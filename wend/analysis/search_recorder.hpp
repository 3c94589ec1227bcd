#pragma once

// SearchRecorder: an observer that writes down what a search does, for pictures and for looking
// back: a layer for everything that was known of a cell, and what was open at every moment.
//
//   wend::SearchRecorder recorder(space);
//   wend::Query query = wend::Query::between({1, 1}, {8, 5});
//   query.observer = &recorder;
//   const auto plan = planner.plan(query);
//   const std::uint32_t first = recorder.layers().expansion[{1, 1}];  // 1: the start
//
// A car stands on corners, where up to four cells meet (of a lattice with a spacing of several cells:
// four squares of cells). All of them take what a search does there: a cell is reached when one of
// its corners is, with any heading, and what is known of it is what is known of the cheapest state
// around it. So it is where a robot has headings in the middle of cells.
//
//   wend::SearchRecorder driven(space, planner.place_grid());
//
// 25 bytes a cell, and 12 an expansion (of a planner of continuous poses, 20 and 24 a pose); an event of a car takes
// O(spacing^2). A recorder is for one
// search; clear() makes it ready for the next. One thread.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/geometry/place_grid.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"
#include "wend/path/motion_tree.hpp"
#include "wend/planner/observer.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

/// What a search knew of each cell, each layer as large as the map.
struct SearchLayers {
  Grid<std::uint32_t> expansion;   // 1 for the cell expanded first; 0: never expanded
  Grid<std::uint32_t> generation;  // 1 for the cell reached first; 0: never reached
  Grid<double> g;                  // as in Plan::cost, the last one known; NaN: never reached
  Grid<double> h;                  // the same; NaN: never reached
  Grid<double> f;                  // the last priority; NaN: never reached
  Grid<std::optional<Direction>> parent;  // towards the cell or corner it was reached from
};

/// A search after one of its expansions.
struct SearchSnapshot {
  BitGrid expanded;             // the cells expanded so far
  BitGrid frontier;             // reached, not yet expanded
  std::optional<Cell> current;  // the cell expanded last (for a car, a cell that touches the
                                // vertex); unset before the first expansion
};

class WEND_API SearchRecorder final : public SearchObserver {
 public:
  /// For searches on that space, from cell to cell.
  explicit SearchRecorder(const FreeSpace& space);
  /// The same for a planner with these places: Planner::place_grid().
  SearchRecorder(const FreeSpace& space, const PlaceGrid& places);

  /// Writes down that a state was reached for the first time.
  void on_generate(const SearchEvent& event) override;
  /// Writes down that a state was expanded.
  void on_expand(const SearchEvent& event) override;
  /// Writes down that a state was reached again, more cheaply.
  void on_relax(const SearchEvent& event) override;

  /// Forgets everything.
  void clear();

  /// What is known of each cell so far.
  const SearchLayers& layers() const { return layers_; }

  /// The cells (for a car, the vertices) in their order of expansion. A planner without duplicate
  /// detection (random_walk) expands some more than once, and a car expands a vertex with each
  /// heading; the layer keeps the first time.
  const std::vector<Cell>& expansions() const { return expansions_; }

  /// What was driven to each of the states expanded, for planners of continuous poses; empty for others.
  const MotionTree& motions() const { return motions_; }

  /// The state after `expansions` expansions (at most expansions().size()), including everything
  /// that the last of them generated. O(cells).
  SearchSnapshot snapshot(std::size_t expansions) const;

  /// How it stood at the end.
  SearchSnapshot snapshot() const { return snapshot(expansions_.size()); }

 private:
  template <class Visit>
  void for_cells_at(Cell place, Visit&& visit) const;
  void write_down(const SearchEvent& event);

  int reach_;  // cells on each side of a vertex that it stands for; 0: places are cells
  SearchLayers layers_;
  std::vector<Cell> expansions_;
  MotionTree motions_;
  std::vector<std::uint32_t> generated_before_;  // each expansion
  std::uint32_t generated_ = 0;                  // states, each once
};

}  // namespace wend
