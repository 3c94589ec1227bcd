#include "wend/sight/portals.hpp"

#include <algorithm>
#include <utility>

#include "wend/map/row_runs.hpp"

namespace wend {

Portals::Portals(const BitGrid& free, const OpenGap& open_gap, DeadlineCheck& stop)
    : width_(free.width()) {
  first_run_.reserve(static_cast<std::size_t>(free.height()) + 1);
  for (int y = 0; y < free.height() && !stop.now(); ++y) {
    first_run_.push_back(static_cast<std::uint32_t>(runs_.size()));
    for_each_run(free.row_words(y), free.width(),
                 [this](const RowRun& run) { runs_.push_back({run.begin, run.end, 0, 0}); });
  }
  first_run_.push_back(static_cast<std::uint32_t>(runs_.size()));
  runs_.push_back({0, 0, 0, 0});  // whose numbers end those of the last run
  for (int y = 1; y < free.height() && !stop.now(); ++y) join_rows(y, open_gap);
  if (stop.has_passed()) return;
  // No run of the first row has portals below it, none of the last one has portals above it.
  const auto end = static_cast<std::uint32_t>(portals_.size());
  for (std::uint32_t i = first_run_[static_cast<std::size_t>(std::max(free.height() - 1, 0))];
       i < runs_.size(); ++i) {
    runs_[i].first_above = end;
  }
  runs_.back().first_below = end;
}

/// Makes the portals between the rows y - 1 and y, from left to right: those of a run are consecutive.
void Portals::join_rows(int y, const OpenGap& open_gap) {
  const auto row = static_cast<std::size_t>(y);
  std::uint32_t below = first_run_[row - 1];
  std::uint32_t above = first_run_[row];
  const std::uint32_t end_of_below = above;
  const std::uint32_t end_of_above = first_run_[row + 1];
  const auto next = [this] { return static_cast<std::uint32_t>(portals_.size()); };
  const auto to_next_below = [&] {
    ++below;
    if (below < end_of_below) runs_[below].first_above = next();
  };
  const auto to_next_above = [&] {
    ++above;
    if (above < end_of_above) runs_[above].first_below = next();
  };
  if (below < end_of_below) runs_[below].first_above = next();
  if (above < end_of_above) runs_[above].first_below = next();
  while (below < end_of_below && above < end_of_above) {
    const SightRun& low = runs_[below];
    const SightRun& high = runs_[above];
    const int left = std::max(low.left, high.left);
    const int right = std::min(low.right, high.right);
    const bool rising = low.right == left;  // if it is a gap
    if (left < right ||
        (left == right && open_gap &&
         open_gap({rising ? left - 1 : left, y - 1}, {rising ? left : left - 1, y}))) {
      add_portal(y, below, above);
    }
    const bool leave_below = low.right <= high.right;
    const bool leave_above = high.right <= low.right;
    if (leave_below) to_next_below();
    if (leave_above) to_next_above();
  }
  while (below < end_of_below) to_next_below();
  while (above < end_of_above) to_next_above();
}

void Portals::add_portal(int y, std::uint32_t below, std::uint32_t above) {
  const SightRun& low = runs_[below];
  const SightRun& high = runs_[above];
  const auto id = static_cast<std::uint32_t>(portals_.size());
  Portal portal{std::max(low.left, high.left),
                std::min(low.right, high.right),
                below,
                above,
                kNoCorner,
                kNoCorner};
  if (portal.left == portal.right) {
    portal.left_corner = corner_at(portal.left, y, id, BlockedCell::gap, low.right == portal.left);
    portal.right_corner = portal.left_corner;
  } else {
    if (low.left < high.left) {
      portal.left_corner = corner_at(portal.left, y, id, BlockedCell::high_left, true);
    } else if (low.left > high.left) {
      portal.left_corner = corner_at(portal.left, y, id, BlockedCell::low_left, false);
    }
    if (low.right < high.right) {
      portal.right_corner = corner_at(portal.right, y, id, BlockedCell::low_right, true);
    } else if (low.right > high.right) {
      portal.right_corner = corner_at(portal.right, y, id, BlockedCell::high_right, false);
    }
  }
  portals_.push_back(portal);
}

std::uint32_t Portals::corner_at(int x, int y, std::uint32_t portal, BlockedCell blocked,
                                 bool rising) {
  constexpr std::uint32_t kBits = (1U << 28U) - 1;
  corners_.push_back({x, y, portal & kBits, static_cast<std::uint32_t>(blocked) & 7U, rising});
  return static_cast<std::uint32_t>(corners_.size()) - 1;
}

std::uint32_t Portals::run_of(Cell cell) const {
  const auto row = static_cast<std::size_t>(cell.y);
  const auto begin = runs_.begin() + first_run_[row];
  const auto end = runs_.begin() + first_run_[row + 1];
  const auto behind =
      std::upper_bound(begin, end, cell.x, [](int x, const SightRun& run) { return x < run.left; });
  return static_cast<std::uint32_t>(behind - runs_.begin()) - 1;
}

bool Portals::sees(const SightPoint& one, const SightPoint& other) const {
  const std::int64_t scale = std::max(one.scale, other.scale);
  SightPoint from = one.scaled(scale);
  SightPoint to = other.scaled(scale);
  if (to.cell.y < from.cell.y) std::swap(from, to);
  // The line passes level y at from.x + dx (y - from.y) / dy.
  const std::int64_t dx = to.x - from.x;
  const std::int64_t dy = to.y - from.y;
  std::uint32_t run = run_of(from.cell);
  for (int y = from.cell.y + 1; y <= to.cell.y; ++y) {
    const std::int64_t up = scale * y - from.y;
    const std::int64_t at = dx * up + from.x * dy;  // x times dy
    const auto begin = portals_.begin() + runs_[run].first_above;
    const auto end = portals_.begin() + end_above(run);
    const auto found = std::partition_point(
        begin, end, [&](const Portal& portal) { return scale * portal.right * dy < at; });
    if (found == end || scale * found->left * dy > at) return false;
    run = found->above;
  }
  return runs_[run].left <= to.cell.x && to.cell.x < runs_[run].right;
}

}  // namespace wend
