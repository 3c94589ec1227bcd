#pragma once

// ComponentCounter: how many 4-connected components the set cells of a grid make, and how large the
// largest is, told row by row in the memory of two rows. ConnectedComponents knows each cell's component
// too, in four bytes a cell.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/map/row_runs.hpp"

namespace wend {

class ComponentCounter {
 public:
  explicit ComponentCounter(int width) : width_(width) {}

  /// The words of the next row, as BitGrid::row_words() has them. O(width).
  void add_row(std::span<const std::uint64_t> words);

  /// Of all rows so far.
  std::size_t count() const { return closed_ + open_.size(); }
  std::size_t largest() const;

 private:
  struct LabelledRun {
    RowRun run;
    std::uint32_t component;  // an index of open_
  };

  int width_;
  std::vector<LabelledRun> above_;  // the runs of the row that came last
  std::vector<std::size_t> open_;   // sizes of the components that reach that row
  std::size_t closed_ = 0;          // how many end above it
  std::size_t largest_closed_ = 0;
};

}  // namespace wend
