#pragma once

// CostMap: what a unit of length costs in each cell, as integers.
//
// A multiplier is stored in steps of 1/256: 256 steps are a multiplier of 1, which is the least. A real
// multiplier is rounded to the nearest step, a half up, so a stored one is off by at most 1/512. All
// planners, path costs and pictures read the stored multipliers, so they agree to the last digit.
//
// A cell takes two bytes; four if any multiplier is 256 or more. A map on which every cell costs 1 takes
// none, unless a cell was set().
//
//   const auto steps = wend::CostMap::rounded(1.5);  // 384

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/map/grid.hpp"

namespace wend {

class WEND_API CostMap {
 public:
  /// The number of steps in a multiplier of 1, the least.
  static constexpr std::uint32_t kOne = 256;
  /// The most steps of a multiplier.
  static constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  /// The largest multiplier, almost 2^24.
  static constexpr double kLargest = static_cast<double>(kMost) / kOne;

  /// The nearest number of steps to a multiplier, at least kOne; nothing above kLargest, and for NaN.
  static std::optional<std::uint32_t> rounded(double multiplier) {
    const double steps = multiplier * kOne + 0.5;
    if (!(steps < 1.0 + kMost)) return std::nullopt;
    return std::max(kOne, static_cast<std::uint32_t>(std::max(steps, 0.0)));
  }

  /// Every cell costs 1. For set(), its size must be known.
  CostMap() = default;

  /// The same, for a map of this size.
  CostMap(int width, int height) : width_(width), height_(height) {}

  /// Calls `write_row(y, steps)` once for each row of a map, in order, and takes the steps that it writes, at least kOne.
  template <class WriteRow>
  CostMap(int width, int height, WriteRow&& write_row, DeadlineCheck& stop = DeadlineCheck::never())
      : CostMap(width, height) {
    std::vector<std::uint32_t> row(static_cast<std::size_t>(width));
    for (int y = 0; y < height && !stop.now(); ++y) {
      write_row(y, std::span<std::uint32_t>(row));
      set_row(y, row);
    }
  }

  /// Does every cell cost 1?
  bool uniform() const { return dear_ == 0; }

  /// The steps of a cell, which must be on the map. O(1).
  std::uint32_t steps(Cell cell) const {
    if (!narrow_.empty()) return narrow_[cell];
    return wide_.empty() ? kOne : wide_[cell];
  }

  /// Writes the steps of the cells from (x, y) on, which must be on the map.
  void read_row(int x, int y, std::span<std::uint32_t> steps) const {
    const auto copy = [&](const auto& grid) {
      const auto row = grid.row(y).subspan(static_cast<std::size_t>(x), steps.size());
      for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = row[i];
    };
    if (!narrow_.empty()) return copy(narrow_);
    if (!wide_.empty()) return copy(wide_);
    for (std::uint32_t& each : steps) each = kOne;
  }

  /// The multiplier of a cell, which must be on the map. O(1).
  double multiplier(Cell cell) const { return static_cast<double>(steps(cell)) / kOne; }

  /// Changes the steps of a cell, which must be on the map that the costs were made for. O(1), but for the
  /// first cell that needs wider memory: O(cells).
  void set(Cell cell, std::uint32_t steps);

  /// No cell has more steps than this. O(cells) if a cell takes four bytes, else O(1), and not tight.
  std::uint32_t most_steps() const;

  /// The bytes that a cell takes: 0, 2 or 4.
  std::size_t bytes_per_cell() const;

  /// Do the cells of two maps of the same size cost the same? O(cells).
  friend WEND_API bool operator==(const CostMap& a, const CostMap& b);

 private:
  static constexpr std::uint32_t kMostNarrow = std::numeric_limits<std::uint16_t>::max();

  /// Sets a row whose cells cost 1 until now.
  void set_row(int y, std::span<const std::uint32_t> steps);
  /// Takes memory for cells that may have `most` steps.
  void make_room(std::uint32_t most);

  int width_ = 0;
  int height_ = 0;
  // At most one of the two has cells.
  Grid<std::uint16_t> narrow_;
  Grid<std::uint32_t> wide_;
  std::size_t dear_ = 0;  // the number of cells that cost more than 1
};

}  // namespace wend
