#pragma once

// SideRooms: parts of a map, each behind one narrow door, that no cheapest path passes through unless it begins or
// ends there. A search leaves them closed: it does not step through their doors.
//
// A run is a maximal stretch of free cells in a row or a column, and touches the runs in the next ones that a step may
// lead to. A run without which the map would fall apart (an articulation point of the runs) is a door of what it
// separates from the rest. The path along a door from one of its cells to another has to cost less than any through the
// room behind it; a search of the few cells next to the door finds that out. Then no cheapest path between cells outside
// enters the room, also of those that CostGrid's classes keep.
//
// All of this holds while cells become dearer or blocked elsewhere than in doors.
//
// O(cells), and for each door the square of its width at most; 1 bit a cell and 8 bytes a run.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/base/deadline.hpp"
#include "wend/base/state_id.hpp"
#include "wend/planner/costs/cost_grid.hpp"
#include "wend/planner/goal_region.hpp"

namespace wend {

class SideRooms {
 public:
  /// Of no use if the deadline passes before they are found.
  template <class Word>
  explicit SideRooms(const CostGrid<Word>& grid, DeadlineCheck& stop = DeadlineCheck::never());

  /// Closes all rooms but those that the start and the goal, which are free, lie in. With several goals or a tolerance
  /// all rooms are open. O(rooms).
  void close_for(Cell start, std::span<const GoalRegion> goals);

  /// Is it the first cell behind the door of a closed room?
  bool closed(StateId id) const { return (closed_[id / 64] >> (id % 64) & 1U) != 0; }

  /// Do the rooms stay what they are after these changes?
  template <class Word>
  bool outlast(const CostGrid<Word>& grid,
               std::span<const typename CostGrid<Word>::Change> changes) const {
    return std::ranges::none_of(changes, [&](const auto& change) {
      return grid.became_better(change) || std::ranges::binary_search(doors_, change.id);
    });
  }

 private:
  /// Runs are numbered in the order in which a depth-first search reached them, so that those of a room are an interval.
  struct Run {
    int begin;
    std::uint32_t number;
  };

  /// All rows, or all columns.
  struct Runs {
    std::vector<std::uint32_t> first;  // of each line, and the end
    std::vector<Run> runs;

    std::uint32_t number_at(int line, int at) const;
  };

  struct Room {
    std::size_t by_columns;  // 0 or 1
    std::uint32_t begin;     // the runs
    std::uint32_t end;
    std::uint32_t first_entry;
    std::uint32_t end_of_entries;
  };

  template <class Word>
  class Finder;

  bool contains(const Room& room, const std::array<std::uint32_t, 2>& numbers) const {
    return numbers[room.by_columns] >= room.begin && numbers[room.by_columns] < room.end;
  }
  std::array<std::uint32_t, 2> numbers_of(Cell cell) const {
    return {lines_[0].number_at(cell.y, cell.x), lines_[1].number_at(cell.x, cell.y)};
  }
  void set(const Room& room, bool closed);

  std::array<Runs, 2> lines_;  // rows, columns
  std::vector<Room> rooms_;
  std::vector<StateId> entries_;  // the first cells behind their doors
  std::vector<StateId> doors_;    // the cells of all doors, sorted
  std::vector<std::uint64_t> closed_;
  std::vector<std::uint32_t> open_;  // rooms, for the present query
};

}  // namespace wend
