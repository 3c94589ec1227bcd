#include "wend/map/distance_field.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <ranges>

#include "wend/map/grid_within.hpp"
#include "wend/map/row_runs.hpp"

namespace wend {
namespace {

// Distances within a column, in cells.
using CellCount = std::uint16_t;
constexpr CellCount kFar = UINT16_MAX;
constexpr double kMostColumns = 1 << 30;  // more than a map has

CellCount one_cell_farther(CellCount distance) {
  return static_cast<CellCount>(std::min<int>(distance, kFar - 1) + 1);
}

/// Sets a row to 0 in blocked cells, and elsewhere to one more than the row above.
void count_on(std::span<const std::uint64_t> blocked_words, std::span<const CellCount> above,
              std::span<CellCount> row) {
  for (std::size_t x = 0; x < row.size(); ++x) row[x] = one_cell_farther(above[x]);
  for (std::size_t i = 0; i < blocked_words.size(); ++i) {
    for (std::uint64_t bits = blocked_words[i]; bits != 0; bits &= bits - 1) {
      row[64 * i + static_cast<std::size_t>(std::countr_zero(bits)) - 1] = 0;
    }
  }
}

/// Distance of every cell to the nearest blocked cell of its own column.
Grid<CellCount> column_distances(const BitGrid& blocked, DeadlineCheck& stop) {
  const int height = blocked.height();
  auto distances = grid_within<CellCount>(blocked.width(), height, 0, stop);
  const std::vector<CellCount> far(static_cast<std::size_t>(blocked.width()), kFar);
  std::span<const CellCount> above = far;
  for (int y = 0; y < height && !stop.now(); ++y) {
    count_on(blocked.row_words(y), above, distances.row(y));
    above = distances.row(y);
  }
  for (int y = height - 2; y >= 0 && !stop.now(); --y) {
    const auto row = distances.row(y);
    const auto below = distances.row(y + 1);
    for (std::size_t x = 0; x < row.size(); ++x) {
      row[x] = std::min(row[x], one_cell_farther(below[x]));
    }
  }
  return distances;
}

std::int64_t floor_quotient(std::int64_t dividend, std::int64_t divisor) {
  if (divisor == 1) return dividend;  // spares most divisions where obstacles are dense
  const std::int64_t quotient = dividend / divisor;
  return quotient - static_cast<std::int64_t>(dividend % divisor < 0);
}

/// Squared distance from a cell's centre to a closed square `cells` columns or rows away, in half-cells.
std::int64_t squared_axis_distance(std::int64_t cells) {
  const std::int64_t half_cells = cells == 0 ? 0 : 2 * std::abs(cells) - 1;
  return half_cells * half_cells;
}

/// A column whose nearest obstacle is the nearest one for some segment of the row.
struct Column {
  std::int64_t x;
  std::int64_t squared;     // squared distance in the column
  std::int64_t first_cell;  // where its segment begins

  std::int64_t squared_distance_from(std::int64_t cell) const {
    return squared_axis_distance(cell - x) + squared;
  }
};

/// The last cell that is at least as near to `left` as to `right`: the largest i with
/// axis(i - left)^2 - axis(i - right)^2 <= right.squared - left.squared. The left side grows with i
/// and is linear in i except for a kink at each of the two columns.
std::int64_t last_cell_nearer_left(const Column& left, const Column& right) {
  const std::int64_t gap = right.x - left.x;
  const std::int64_t sum = left.x + right.x;
  const std::int64_t excess = right.squared - left.squared;
  const std::int64_t at_kink = squared_axis_distance(gap);
  const std::int64_t quarter = excess >> 2;  // rounded down, like all quotients here
  if (excess >= 4 * gap * (gap + 1)) return (floor_quotient(quarter, gap) + sum + 1) >> 1;
  if (excess >= at_kink) return right.x;
  if (gap >= 2 && excess >= 4 * (gap - 1) * (2 - gap)) {
    return std::min(right.x - 1, (floor_quotient(quarter, gap - 1) + sum) >> 1);
  }
  if (excess >= -at_kink) return left.x;
  return (floor_quotient(quarter, gap) + sum - 1) >> 1;
}

/// The columns that matter to a row, in order, each with its segment (a lower envelope).
void nearest_columns(std::span<const CellCount> in_column, std::vector<Column>& envelope) {
  const auto last_cell = static_cast<std::int64_t>(in_column.size()) - 1;
  envelope.clear();
  for (std::size_t x = 0; x < in_column.size(); ++x) {
    if (in_column[x] == kFar) continue;
    Column column{static_cast<std::int64_t>(x), squared_axis_distance(in_column[x]), 0};
    const auto is_nearer_at = [&column](std::int64_t cell, const Column& other) {
      return column.squared_distance_from(cell) < other.squared_distance_from(cell);
    };
    while (!envelope.empty() && is_nearer_at(envelope.back().first_cell, envelope.back())) {
      envelope.pop_back();
    }
    if (!envelope.empty()) {
      if (!is_nearer_at(last_cell, envelope.back())) continue;
      column.first_cell = last_cell_nearer_left(envelope.back(), column) + 1;
    }
    envelope.push_back(column);
  }
}

/// The number of columns from `x` to the nearest set cell of a row that is at most `most` columns away, else
/// more than `most`.
int columns_to_set_cell(std::span<const std::uint64_t> row, int x, int most, int width) {
  const int end = x + std::min(most, width - 1 - x) + 1;
  const auto words_to_end = (static_cast<std::size_t>(end) + 64) / 64;
  const int right = next_cell(row.first(words_to_end), x, end, true);
  most = right < end ? right - x : most + 1;
  const int begin = std::max(x - most, 0);
  const int left = previous_cell(row, x, begin);
  return left < begin ? most : std::min(most, x - left);
}

}  // namespace

double distance_in_cells(std::uint32_t squared_half_cells) {
  if (squared_half_cells == kNoObstacle) return std::numeric_limits<double>::infinity();
  return std::sqrt(static_cast<double>(squared_half_cells)) / 2;
}

Grid<std::uint32_t> squared_half_cell_distances(const BitGrid& blocked, DeadlineCheck& stop) {
  const Grid<CellCount> in_column = column_distances(blocked, stop);
  if (stop.has_passed()) return {};
  auto squared = grid_within(blocked.width(), blocked.height(), kNoObstacle, stop);
  std::vector<Column> envelope;
  for (int y = 0; y < blocked.height() && !stop.now(); ++y) {
    nearest_columns(in_column.row(y), envelope);
    const auto row = squared.row(y);
    std::size_t end = row.size();
    for (const Column& column : std::views::reverse(envelope)) {
      const auto begin = static_cast<std::size_t>(column.first_cell);
      for (std::size_t x = begin; x < end; ++x) {
        const std::int64_t distance = column.squared_distance_from(static_cast<std::int64_t>(x));
        row[x] = static_cast<std::uint32_t>(std::min<std::int64_t>(distance, kNoObstacle));
      }
      end = begin;
    }
  }
  return squared;
}

std::uint32_t squared_half_cell_distance(const BitGrid& blocked, Cell from, std::uint32_t most,
                                         std::size_t& words) {
  std::int64_t least = most;
  for (int rows = 0; squared_axis_distance(rows) < least; ++rows) {
    const bool below = from.y - rows >= 0;
    const bool above = rows > 0 && from.y + rows < blocked.height();
    if (!below && from.y + rows >= blocked.height()) break;
    const std::int64_t in_column = squared_axis_distance(rows);
    const auto look = [&](int y) {
      // No column farther away is nearer: (2 k - 1)^2 + in_column < least.
      const double half_cells = std::sqrt(static_cast<double>(least - in_column));
      const int reach = static_cast<int>(std::min(half_cells / 2 + 1, kMostColumns));
      const int columns = columns_to_set_cell(blocked.row_words(y), from.x, reach, blocked.width());
      words += 2 + static_cast<std::size_t>(std::min(columns, blocked.width())) / 32;
      if (columns > reach) return;
      least = std::min(least, squared_axis_distance(columns) + in_column);
    };
    if (below) look(from.y - rows);
    if (above && in_column < least) look(from.y + rows);
  }
  return static_cast<std::uint32_t>(least);
}

}  // namespace wend
