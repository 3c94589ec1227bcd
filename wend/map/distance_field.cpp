#include "wend/map/distance_field.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wend {
namespace {

// Distances along one axis, in half-cells: 0 in the cell itself, then 1, 3, 5, ...
using AxisDistance = std::uint16_t;
constexpr AxisDistance kFar = UINT16_MAX;

AxisDistance one_cell_farther(AxisDistance distance) {
  if (distance >= kFar - 2) return kFar;
  return static_cast<AxisDistance>(distance == 0 ? 1 : distance + 2);
}

/// Distance of every cell to the nearest blocked cell of its own column.
Grid<AxisDistance> column_distances(const BitGrid& blocked) {
  const int height = blocked.height();
  Grid<AxisDistance> distances(blocked.width(), height, kFar);
  for (int y = 0; y < height; ++y) {
    const auto row = distances.row(y);
    const auto words = blocked.row_words(y);
    const auto above = y > 0 ? distances.row(y - 1) : row;  // in row 0 itself, which is far
    for (std::size_t x = 0; x < row.size(); ++x) {
      const bool is_blocked = ((words[(x + 1) / 64] >> ((x + 1) % 64)) & 1U) != 0;
      row[x] = is_blocked ? AxisDistance{0} : one_cell_farther(above[x]);
    }
  }
  for (int y = height - 2; y >= 0; --y) {
    const auto row = distances.row(y);
    const auto below = distances.row(y + 1);
    for (std::size_t x = 0; x < row.size(); ++x) {
      row[x] = std::min(row[x], one_cell_farther(below[x]));
    }
  }
  return distances;
}

std::int64_t floor_quotient(std::int64_t dividend, std::int64_t divisor) {
  const std::int64_t quotient = dividend / divisor;
  return quotient - static_cast<std::int64_t>(dividend % divisor < 0);
}

std::int64_t squared_axis_distance(std::int64_t cells) {
  const std::int64_t half_cells = cells == 0 ? 0 : 2 * std::abs(cells) - 1;
  return half_cells * half_cells;
}

/// A column whose nearest obstacle is the nearest one for some stretch of the row.
struct Column {
  std::int64_t x;
  std::int64_t squared;     // squared distance within the column
  std::int64_t first_cell;  // where its stretch begins

  std::int64_t squared_distance_from(std::int64_t cell) const {
    return squared_axis_distance(cell - x) + squared;
  }
};

/// The last cell that is at least as near to `left` as to `right`: the largest i with
/// axis(i - left)^2 - axis(i - right)^2 <= right.squared - left.squared. The left side grows with i
/// and is linear in i but for a kink at each of the two columns.
std::int64_t last_cell_nearer_left(const Column& left, const Column& right) {
  const std::int64_t gap = right.x - left.x;
  const std::int64_t sum = left.x + right.x;
  const std::int64_t excess = right.squared - left.squared;
  const std::int64_t at_kink = squared_axis_distance(gap);
  if (excess >= 4 * gap * (gap + 1)) {
    return floor_quotient(floor_quotient(excess, 4 * gap) + sum + 1, 2);
  }
  if (excess >= at_kink) return right.x;
  if (gap >= 2 && excess >= 4 * (gap - 1) * (2 - gap)) {
    return std::min(right.x - 1, floor_quotient(floor_quotient(excess, 4 * (gap - 1)) + sum, 2));
  }
  if (excess >= -at_kink) return left.x;
  return std::min(left.x - 1, floor_quotient(floor_quotient(excess, 4 * gap) + sum - 1, 2));
}

/// The columns that matter to a row, in order, each with its stretch (a lower envelope).
void nearest_columns(std::span<const AxisDistance> in_column, std::vector<Column>& envelope) {
  envelope.clear();
  for (std::size_t x = 0; x < in_column.size(); ++x) {
    if (in_column[x] == kFar) continue;
    const std::int64_t distance = in_column[x];
    Column column{static_cast<std::int64_t>(x), distance * distance, 0};
    while (!envelope.empty()) {
      column.first_cell = last_cell_nearer_left(envelope.back(), column) + 1;
      if (column.first_cell > envelope.back().first_cell) break;
      envelope.pop_back();
      column.first_cell = 0;
    }
    if (column.first_cell < static_cast<std::int64_t>(in_column.size())) {
      envelope.push_back(column);
    }
  }
}

}  // namespace

Grid<std::uint32_t> squared_half_cell_distances(const BitGrid& blocked) {
  const Grid<AxisDistance> in_column = column_distances(blocked);
  Grid<std::uint32_t> squared(blocked.width(), blocked.height(), kNoObstacle);
  std::vector<Column> envelope;
  for (int y = 0; y < blocked.height(); ++y) {
    nearest_columns(in_column.row(y), envelope);
    const auto row = squared.row(y);
    std::size_t end = row.size();
    for (auto column = envelope.rbegin(); column != envelope.rend(); ++column) {
      const auto begin = static_cast<std::size_t>(std::max<std::int64_t>(0, column->first_cell));
      for (std::size_t x = begin; x < end; ++x) {
        const std::int64_t distance =
            column->squared_distance_from(static_cast<std::int64_t>(x));
        row[x] = static_cast<std::uint32_t>(std::min<std::int64_t>(distance, kNoObstacle));
      }
      end = std::min(end, begin);
    }
  }
  return squared;
}

}  // namespace wend
