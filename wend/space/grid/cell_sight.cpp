#include "wend/space/grid/cell_sight.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "wend/map/row_bits.hpp"

namespace wend {
namespace {

/// Is any of the cells of a row between two set, of which either may be the left one?
bool any_between(const BitGrid& cells, int y, int a, int b) {
  return any_set(cells.row_words(y), std::min(a, b), std::max(a, b));
}

/// Where a line from the centre of a cell crosses the upper edges of rows: in which column, counted from that cell in the
/// direction of the line, and whether at the nearer corner of this column.
class Crossings {
 public:
  /// For a line that leads up by `rows`, at least 1, and aside by `columns`.
  Crossings(std::uint32_t columns, std::uint32_t rows)
      : whole_(2 * rows),
        columns_of_row_(columns / rows),
        rest_of_row_(2 * (columns % rows)),
        column_((columns_of_row_ + 1) / 2),
        rest_((columns_of_row_ + 1) % 2 * rows + columns % rows) {}

  std::uint32_t column() const { return column_; }
  bool at_corner() const { return rest_ == 0; }

  void go_on() {
    column_ += columns_of_row_;
    rest_ += rest_of_row_;
    if (rest_ < whole_) return;
    ++column_;
    rest_ -= whole_;
  }

 private:
  std::uint32_t whole_;  // parts of a column
  std::uint32_t columns_of_row_;
  std::uint32_t rest_of_row_;
  std::uint32_t column_;
  std::uint32_t rest_;
};

}  // namespace

bool cells_in_sight(const BitGrid& blocked, Cell a, Cell b, Adjacency adjacency) {
  if (a.y > b.y) std::swap(a, b);
  if (a.y == b.y) return !any_between(blocked, a.y, a.x, b.x);
  const int side = b.x < a.x ? -1 : 1;
  Crossings crossing(static_cast<std::uint32_t>(std::abs(b.x - a.x)),
                     static_cast<std::uint32_t>(b.y - a.y));
  int begin = a.x;
  for (int y = a.y; y < b.y; ++y, crossing.go_on()) {
    const int next = a.x + side * static_cast<int>(crossing.column());
    const int last = crossing.at_corner() ? next - side : next;
    if (any_between(blocked, y, begin, last)) return false;
    if (crossing.at_corner() && adjacency == Adjacency::edges && blocked[{next, y}] &&
        blocked[{last, y + 1}]) {
      return false;
    }
    begin = next;
  }
  return !any_between(blocked, b.y, begin, b.x);
}

}  // namespace wend
