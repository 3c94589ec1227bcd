#pragma once

// Turns rows of cells into runs, and rows of runs into few rectangles: equal runs in consecutive rows
// are joined.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace wend {

/// Calls visit(x, length, value) for the runs of equal values in a row of `width` cells.
template <class ValueAt, class Visit>
void for_runs(int width, const ValueAt& value_at, const Visit& visit) {
  for (int x = 0; x < width;) {
    const int first = x;
    const auto value = value_at(first);
    while (x < width && value_at(x) == value) ++x;
    visit(first, x - first, value);
  }
}

/// `runs_of_row(y)` gives the rectangles of row y, one cell high, from left to right. `alike(a, b)`
/// says whether two rectangles that cover the same columns may be joined. Returns nothing if more than
/// `most` remain. O(runs) in time; the memory is that of the rectangles.
template <class Rectangle, class RunsOfRow, class Alike>
std::optional<std::vector<Rectangle>> joined_rows(int height, std::size_t most,
                                                  RunsOfRow&& runs_of_row, Alike&& alike) {
  std::vector<Rectangle> done;
  std::vector<Rectangle> open;  // those that reach the previous row, from left to right
  for (int y = 0; y < height; ++y) {
    std::vector<Rectangle> runs = runs_of_row(y);
    auto above = open.begin();
    for (Rectangle& run : runs) {
      while (above != open.end() && above->x < run.x) done.push_back(*above++);
      if (above == open.end() || run.x != above->x || run.width != above->width ||
          !alike(run, *above)) {
        continue;
      }
      run.y = above->y;
      run.height = above->height + 1;
      ++above;
    }
    done.insert(done.end(), above, open.end());
    open = std::move(runs);
    if (done.size() + open.size() > most) return std::nullopt;
  }
  done.insert(done.end(), open.begin(), open.end());
  return done;
}

}  // namespace wend
