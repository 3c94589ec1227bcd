#include "wend/index/leg_path.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstdlib>

namespace wend {
namespace {

int sign(int value) { return (value > 0) - (value < 0); }

/// Writes the first cells of a run, and says where the next one goes. Four at a time, so that short
/// runs, which mazes have many of, take no loop: what is too much is overwritten.
Cell* write_run(Cell at, Cell step, int steps, Cell* out, const Cell* end) {
  constexpr int kAtOnce = 4;
  int done = 0;
  for (; done < steps && end - out - done >= kAtOnce; done += kAtOnce) {
    for (int i = 0; i < kAtOnce; ++i) {
      out[done + i] = {at.x + (done + i) * step.x, at.y + (done + i) * step.y};
    }
  }
  for (; done < steps; ++done) out[done] = {at.x + done * step.x, at.y + done * step.y};
  return out + steps;
}

}  // namespace

Cell bend_of(Cell from, Cell to) {
  const int dx = to.x - from.x;
  const int dy = to.y - from.y;
  const int diagonal = std::min(std::abs(dx), std::abs(dy));
  return {from.x + diagonal * sign(dx), from.y + diagonal * sign(dy)};
}

void LegPath::append(Cell point) {
  const Cell last = points_.back();
  const int dx = std::abs(point.x - last.x);
  const int dy = std::abs(point.y - last.y);
  steps_.diagonal += static_cast<std::uint32_t>(std::min(dx, dy));
  steps_.straight += static_cast<std::uint32_t>(std::abs(dx - dy));
  points_.push_back(point);
}

void LegPath::write(std::span<Cell> cells) const {
  assert(cells.size() == steps_.cells());
  Cell* out = cells.data();
  const Cell* const end = out + cells.size();
  Cell at = points_.front();
  const auto go_to = [&](Cell target) {
    const int dx = target.x - at.x;
    const int dy = target.y - at.y;
    const int steps = std::max(std::abs(dx), std::abs(dy));
    out = write_run(at, {sign(dx), sign(dy)}, steps, out, end);
    at = target;
  };
  for (const Cell point : points_) {
    go_to(bend_of(at, point));
    go_to(point);
  }
  *out = at;
}

}  // namespace wend
