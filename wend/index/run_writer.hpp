#pragma once

// RunWriter: writes a path cell by cell from runs of steps, upwards or downwards in memory.
//
// It writes a run eight cells at a time, past the end of the run where there is room; later cells
// overwrite the excess. Most runs are short, and a loop of one round has no branch to mispredict.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/geometry/direction.hpp"
#include "wend/index/index_engine.hpp"

namespace wend {

/// kWay is 1 to write upwards, -1 to write downwards.
template <int kWay>
class RunWriter {
 public:
  /// Writes into the `room` cells from `next` on. The path so far ends at `at`, which is already
  /// written.
  RunWriter(Cell* next, std::size_t room, Cell at) : next_(next), room_(room), at_(packed(at)) {}

  std::size_t room() const { return room_; }

  /// The steps must fit into the buffer.
  void run(Direction direction, std::size_t steps) {
    if (steps <= kAtOnce && room_ >= kAtOnce) [[likely]] {
      store_all(direction);
      advance(steps, direction);
    } else {
      run_far(direction, std::min(steps, room_));
    }
  }

  /// Diagonally first, then straight.
  void go_to(Cell to) {
    const Cell from = unpacked(at_);
    const Cell way{to.x - from.x, to.y - from.y};
    const int wide = std::abs(way.x);
    const int high = std::abs(way.y);
    const int diagonal = std::min(wide, high);
    constexpr Direction kDiagonals[2][2] = {{Direction::minus_x_minus_y, Direction::minus_x_plus_y},
                                            {Direction::plus_x_minus_y, Direction::plus_x_plus_y}};
    if (diagonal > 0) {
      run(kDiagonals[way.x > 0 ? 1 : 0][way.y > 0 ? 1 : 0], static_cast<std::size_t>(diagonal));
    }
    if (wide > high) {
      run(way.x > 0 ? Direction::plus_x : Direction::minus_x,
          static_cast<std::size_t>(wide - high));
    } else if (high > wide) {
      run(way.y > 0 ? Direction::plus_y : Direction::minus_y,
          static_cast<std::size_t>(high - wide));
    }
  }

 private:
  static_assert(sizeof(Cell) == sizeof(std::int64_t) && std::endian::native == std::endian::little);
  static constexpr std::size_t kAtOnce = 8;

  // A cell as one number made of its bytes, so that a step is one addition. x is not negative and
  // does not carry into y.
  static constexpr std::int64_t packed(Cell cell) {
    return static_cast<std::int64_t>(cell.y) * (std::int64_t{1} << 32U) + cell.x;
  }
  static constexpr Cell unpacked(std::int64_t cell) {
    return {static_cast<int>(cell & 0xFFFFFFFF), static_cast<int>(cell >> 32U)};
  }

  static constexpr auto kSteps = [] {
    std::array<std::int64_t, kDirections> steps{};
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = packed(kDirectionSteps[i]);
    return steps;
  }();

  // Two cells as they lie in memory.
  using Pair [[gnu::vector_size(2 * sizeof(std::int64_t))]] = std::int64_t;
  static constexpr std::size_t kPairs = kAtOnce / 2;

  /// The offsets of the cells of a run from the cell before the run.
  static constexpr auto kOffsets = [] {
    std::array<std::array<Pair, kPairs>, kDirections> table{};
    for (std::size_t direction = 0; direction < table.size(); ++direction) {
      for (std::size_t i = 0; i < kPairs; ++i) {
        const auto near = static_cast<std::int64_t>(2 * i + 1) * kSteps[direction];
        const std::int64_t far = near + kSteps[direction];
        table[direction][i] = kWay > 0 ? Pair{near, far} : Pair{far, near};
      }
    }
    return table;
  }();

  void run_far(Direction direction, std::size_t steps) {
    for (; steps >= kAtOnce; steps -= kAtOnce) {
      store_all(direction);
      advance(kAtOnce, direction);
    }
    for (; steps > 0; --steps) {
      const std::int64_t cell = at_ + kSteps[static_cast<std::size_t>(direction)];
      store(next_, cell);
      advance(1, direction);
    }
  }

  void store_all(Direction direction) {
    const auto& offsets = kOffsets[static_cast<std::size_t>(direction)];
    const Pair at{at_, at_};
    for (std::size_t i = 0; i < kPairs; ++i) {
      constexpr std::ptrdiff_t kFirst = kWay > 0 ? 0 : -1;
      store(next_ + kFirst + kWay * static_cast<std::ptrdiff_t>(2 * i), at + offsets[i]);
    }
  }
  template <class Cells>
  static void store(void* place, const Cells& cells) {
    std::memcpy(place, &cells, sizeof cells);
  }
  void advance(std::size_t steps, Direction direction) {
    next_ += kWay * static_cast<std::ptrdiff_t>(steps);
    room_ -= steps;
    at_ += static_cast<std::int64_t>(steps) * kSteps[static_cast<std::size_t>(direction)];
  }

  Cell* next_;
  std::size_t room_;
  std::int64_t at_;
};

// LegPath: a path as its turning points. Between two of them it goes diagonally first, then straight.

class LegPath {
 public:
  void begin(Cell start) {
    points_.assign(1, start);
    steps_ = {};
  }
  void append(Cell point);

  OctileSteps steps() const { return steps_; }

  /// Writes the steps().cells() cells of the path.
  void write(std::span<Cell> cells) const;

 private:
  std::vector<Cell> points_;
  OctileSteps steps_;
};

}  // namespace wend
