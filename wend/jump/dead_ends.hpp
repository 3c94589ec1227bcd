#pragma once

// DeadEnds: the parts of a map that no shortest path passes through unless it begins or ends in them.
//
// A run is a maximal stretch of passable cells in a row (or a column). A run that touches only one other
// run is a dead end: a path that enters it must return through the same run, and staying in that run is
// strictly shorter. So it is removed, and then the runs that have become dead ends, alternating between
// rows and columns, until nothing changes or it no longer pays. The rest is the core.
//
// A path that begins in a dead end needs this dead end and the run that was its neighbour when it was
// removed; if that run was removed later, its neighbour too, and so on: these are opened. No shortest
// path between cells of the core and of opened dead ends leaves them: a dead end that stays closed
// touched, when it was removed, one run of those that are open, so the argument above holds for it.
//
// A search that jumps needs this only for jump points, so dead ends without jump points are never
// opened.
//
// After an edit of the map the argument still holds if the changed cells and those next to them are opened for
// every query, too: all other dead ends touch one run, as before, in which a path can stay.
//
//   const auto dead_ends = std::make_shared<const wend::DeadEnds>(boards);
//   wend::OpenDeadEnds open(dead_ends);
//   open.open_for(start, goals);
//   if (open.contains(open.number(jump_point))) ...
//
// Immutable; O(cells) to make; 4 bytes per cell and a few per dead end.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/jump/bit_lines.hpp"
#include "wend/jump/jump_boards.hpp"
#include "wend/map/grid.hpp"

namespace wend {

class DeadEnds {
 public:
  static constexpr std::uint32_t kCore = 0;

  explicit DeadEnds(const JumpBoards& boards);

  /// The number of the dead end that a cell is in, from 1 on, or kCore.
  std::uint32_t number(Cell cell) const { return numbers_[cell]; }

  /// The number of dead ends.
  std::size_t size() const { return exits_.size() - 2; }

  /// The number of cells outside the core.
  std::size_t cells() const { return cells_; }

  /// The nearest dead ends with jump points that a dead end leads to. Their numbers are greater.
  std::span<const std::uint32_t> exits(std::uint32_t number) const {
    return std::span(exit_numbers_).subspan(exits_[number], exits_[number + 1] - exits_[number]);
  }

 private:
  Grid<std::uint32_t> numbers_;  // by cell
  std::size_t cells_ = 0;
  std::vector<std::size_t> exits_;  // by number: where they begin, and the end
  std::vector<std::uint32_t> exit_numbers_;
};

/// The dead ends that a query needs. Each thread needs its own.
class OpenDeadEnds {
 public:
  explicit OpenDeadEnds(std::shared_ptr<const DeadEnds> dead_ends)
      : dead_ends_(std::move(dead_ends)), opened_(dead_ends_->size() + 1) {}

  /// Opens the dead ends that shortest paths between these cells need, and closes all others. O(opened
  /// dead ends).
  void open_for(Cell start, std::span<const Cell> goals);

  /// Opens the dead ends of these cells for all queries that follow.
  void keep_open(std::span<const Cell> cells);

  /// The dead end that a cell is in.
  std::uint32_t number(Cell cell) const { return dead_ends_->number(cell); }

  /// May a jump point in this dead end lie on a shortest path? In the core every jump point may.
  bool contains(std::uint32_t number) const { return opened_[number] == query_; }

 private:
  void open(std::uint32_t first);
  void push(std::uint32_t number);

  std::shared_ptr<const DeadEnds> dead_ends_;
  std::uint32_t query_ = 0;
  std::vector<std::uint32_t> opened_;  // by number: the query that it was opened for last
  std::vector<std::uint32_t> pending_;
  std::vector<std::uint32_t> kept_open_;
};

}  // namespace wend
