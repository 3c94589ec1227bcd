#pragma once

// ValueRows: the values of a rectangle of cells, one for each cell, and where two such rectangles differ. What the
// messages of ROS bring is compared with what was there before, so that only the change is an edit.
//
//   const std::vector<std::int8_t> before{0, 0, 0, 0};
//   const std::vector<std::int8_t> after{0, 0, 0, 100};
//   const auto found = wend::difference<std::int8_t>({before, 2}, {after, 2});
//   const wend::Cell first = found.box.begin;  // (1, 1)

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

#include "wend/geometry/cell_box.hpp"

namespace wend {

/// A view of rows of values, which may be part of longer rows.
template <class Value>
class ValueRows {
 public:
  /// Rows of `width` values, one behind the other.
  ValueRows(std::span<const Value> values, std::size_t width) : ValueRows(values, width, width) {}
  /// Each row begins `stride` values behind the one before; as many as fit.
  ValueRows(std::span<const Value> values, std::size_t width, std::size_t stride)
      : values_(values),
        width_(width),
        stride_(stride),
        height_(values.size() < width || width == 0 ? 0 : (values.size() - width) / stride + 1) {}

  /// The number of columns.
  int width() const { return static_cast<int>(width_); }
  /// The number of rows.
  int height() const { return static_cast<int>(height_); }
  /// The values of a row.
  std::span<const Value> row(int y) const {
    return values_.subspan(static_cast<std::size_t>(y) * stride_, width_);
  }
  /// The value of a cell of these rows.
  Value operator[](Cell cell) const { return row(cell.y)[static_cast<std::size_t>(cell.x)]; }

  /// The values of a box of these cells, which is not empty.
  ValueRows part(const CellBox& box) const {
    const std::size_t first =
        static_cast<std::size_t>(box.begin.y) * stride_ + static_cast<std::size_t>(box.begin.x);
    const auto part_width = static_cast<std::size_t>(box.width());
    const std::size_t length = static_cast<std::size_t>(box.height() - 1) * stride_ + part_width;
    return {values_.subspan(first, length), part_width, stride_};
  }

 private:
  std::span<const Value> values_;
  std::size_t width_;
  std::size_t stride_;
  std::size_t height_;
};

/// Where values differ.
struct Difference {
  CellBox box;             // the least that contains all cells that differ; empty if none does
  std::int64_t cells = 0;  // how many differ

  /// Do so few cells of the box differ that they are better edited one by one? A box around cells that are far
  /// apart would repair all that lies between.
  bool sparse() const {
    constexpr std::int64_t kShare = 8;
    return cells * kShare <= box.size();
  }
};

/// Where two rectangles of the same size differ. O(values).
template <class Value>
Difference difference(const ValueRows<Value>& before, const ValueRows<Value>& after) {
  assert(before.width() == after.width() && before.height() == after.height());
  Difference found;
  for (int y = 0; y < after.height(); ++y) {
    const auto old_row = before.row(y);
    const auto row = after.row(y);
    if (std::equal(row.begin(), row.end(), old_row.begin())) continue;  // a memcmp
    const auto first = std::mismatch(row.begin(), row.end(), old_row.begin()).first;
    const auto behind = std::mismatch(row.rbegin(), row.rend(), old_row.rbegin()).first.base();
    const auto begin = static_cast<int>(first - row.begin());
    const auto end = static_cast<int>(behind - row.begin());
    found.box = found.box.joined_with({{begin, y}, {end, y + 1}});
    for (auto x = static_cast<std::size_t>(begin); x < static_cast<std::size_t>(end); ++x) {
      found.cells += row[x] != old_row[x] ? 1 : 0;
    }
  }
  return found;
}

}  // namespace wend
