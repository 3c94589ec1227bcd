#pragma once

// ValueRows: the values of a rectangle of cells, and where two of them differ. Knows no ROS.

#include <cstddef>
#include <cstdint>
#include <span>

#include "wend/geometry/cell_box.hpp"

namespace wend_ros {

/// A view of rows of values, which may be part of longer rows.
class ValueRows {
 public:
  /// Rows of `width` values, one behind the other.
  ValueRows(std::span<const std::int8_t> values, std::size_t width)
      : ValueRows(values, width, width) {}
  /// Each row begins `stride` values behind the one before; as many as fit.
  ValueRows(std::span<const std::int8_t> values, std::size_t width, std::size_t stride)
      : values_(values),
        width_(width),
        stride_(stride),
        height_(values.size() < width || width == 0 ? 0 : (values.size() - width) / stride + 1) {}

  int width() const { return static_cast<int>(width_); }
  int height() const { return static_cast<int>(height_); }
  std::span<const std::int8_t> row(int y) const {
    return values_.subspan(static_cast<std::size_t>(y) * stride_, width_);
  }

  /// The values of a box of these cells, which is not empty.
  ValueRows part(const wend::CellBox& box) const {
    const std::size_t first =
        static_cast<std::size_t>(box.begin.y) * stride_ + static_cast<std::size_t>(box.begin.x);
    const auto part_width = static_cast<std::size_t>(box.width());
    const std::size_t length = static_cast<std::size_t>(box.height() - 1) * stride_ + part_width;
    return {values_.subspan(first, length), part_width, stride_};
  }

 private:
  std::span<const std::int8_t> values_;
  std::size_t width_;
  std::size_t stride_;
  std::size_t height_;
};

struct Difference {
  wend::CellBox box;       // the least that contains all cells that differ; empty if none does
  std::int64_t cells = 0;  // how many differ
};

/// Where two rectangles of the same size differ. O(values).
Difference difference(const ValueRows& before, const ValueRows& after);

}  // namespace wend_ros
