#pragma once

// ComponentCounter: how many components the cells of a map have, without a label for each cell.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/map/row_runs.hpp"

namespace wend {

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
