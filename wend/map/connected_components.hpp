#pragma once

// Connected components: which cells can reach each other, known before any search.
//
// Without corner cutting (and if one corner may be cut) two cells are connected if they are
// 4-connected; if both corners may be cut, if they are 8-connected. One label for each cell serves
// both: 8-connected components are unions of 4-connected ones.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/map/grid.hpp"

namespace wend {

/// Which cells are neighbours.
enum class Adjacency {
  edges,              // cells that share an edge (4-connected)
  edges_and_corners,  // or a corner (8-connected)
};

/// The connected components of a set of cells: a label and a size for each. 4 bytes for each cell.
class WEND_API ConnectedComponents {
 public:
  /// No cells and no components.
  ConnectedComponents() = default;

  /// The components of the set cells. O(cells).
  explicit ConnectedComponents(const BitGrid& cells);

  /// The component of a cell: 0 for a cell that is not set, else from 1 on. Do not mix labels of the
  /// two adjacencies.
  std::uint32_t component(Cell cell, Adjacency adjacency) const {
    const std::uint32_t label = labels_[cell];
    return adjacency == Adjacency::edges ? label : merged_[label];
  }

  /// Are both cells set and in the same component? O(1).
  bool connected(Cell a, Cell b, Adjacency adjacency) const {
    const std::uint32_t component_of_a = component(a, adjacency);
    return component_of_a != 0 && component_of_a == component(b, adjacency);
  }

  /// How many cells the component of a cell has; 0 if the cell is not set.
  std::size_t size_of_component(Cell cell, Adjacency adjacency) const {
    const std::uint32_t label = component(cell, adjacency);
    return adjacency == Adjacency::edges ? sizes_[label] : merged_sizes_[label];
  }

  /// The number of components.
  std::size_t count(Adjacency adjacency) const;

  /// The sizes of all components, largest first.
  std::vector<std::size_t> sizes(Adjacency adjacency) const;

 private:
  Grid<std::uint32_t> labels_;            // 4-connected
  std::vector<std::uint32_t> merged_{0};  // by label: the 8-connected component
  std::vector<std::size_t> sizes_{0};     // by label
  std::vector<std::size_t> merged_sizes_{0};
};

/// Set cells [begin, end) of one row.
struct RowRun {
  static constexpr std::uint32_t kNoComponent = UINT32_MAX;  // not yet numbered

  int begin;                               // the column of the first cell
  int end;                                 // the column behind the last cell
  std::uint32_t component = kNoComponent;  // numbered by the code that labels runs
};

/// The first cell from x on whose bit is `value`, or width. In `words`, the words of a row, cell x is
/// bit x+1.
inline int next_cell(std::span<const std::uint64_t> words, int x, int width, bool value) {
  const auto first = static_cast<std::size_t>(x) + 1;
  std::size_t word = first / 64;
  std::uint64_t bits = (value ? words[word] : ~words[word]) & (~std::uint64_t{0} << (first % 64));
  while (bits == 0) {
    if (++word == words.size()) return width;
    bits = value ? words[word] : ~words[word];
  }
  const auto found = static_cast<int>(word * 64) + std::countr_zero(bits) - 1;
  return std::min(found, width);
}

/// Calls take(run) for every run of a row, from left to right.
template <class Take>
void for_each_run(std::span<const std::uint64_t> words, int width, Take&& take) {
  for (int x = next_cell(words, 0, width, true); x < width;) {
    const int end = next_cell(words, x, width, false);
    take(RowRun{x, end});
    x = end < width ? next_cell(words, end, width, true) : width;
  }
}

/// Counts the 4-connected components of the set cells of a grid and finds the size of the largest. Takes
/// the grid row by row, in the memory of two rows.
class WEND_API ComponentCounter {
 public:
  /// For rows of `width` cells.
  explicit ComponentCounter(int width) : width_(width) {}

  /// The words of the next row, as BitGrid::row_words() has them. O(width).
  void add_row(std::span<const std::uint64_t> words);

  /// The components of all rows so far.
  std::size_t count() const { return closed_ + open_.size(); }
  /// The number of cells of the largest component so far; 0 without any.
  std::size_t largest() const;

 private:
  int width_;
  std::vector<RowRun> above_;      // of the last row; their components are indices into open_
  std::vector<std::size_t> open_;  // sizes of the components that reach this row
  std::size_t closed_ = 0;         // how many end above it
  std::size_t largest_closed_ = 0;
};

}  // namespace wend
