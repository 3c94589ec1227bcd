#include "wend/sight/cell_trail.hpp"

#include <algorithm>

namespace wend {
namespace {

/// A point in half cells.
struct HalfCells {
  std::int64_t x;
  std::int64_t y;
};

HalfCells centre(Cell cell) { return {2 * std::int64_t{cell.x} + 1, 2 * std::int64_t{cell.y} + 1}; }
HalfCells vertex(const TautCorner& corner) {
  return {2 * std::int64_t{corner.x}, 2 * std::int64_t{corner.y}};
}

class Trail {
 public:
  Trail(const Portals& portals, Cell start, std::vector<Cell>& cells)
      : portals_(portals), cells_(cells), run_(portals.run_of(start)) {
    cells_.assign(1, start);
  }

  /// Into the run in which the path leaves a corner. False if the trail has not come to it.
  bool leave(const TautCorner& corner, HalfCells to) {
    const Portal& portal = portals_.portal(corner.portal);
    if (run_ != portal.above && run_ != portal.below) return false;
    const HalfCells from = vertex(corner);
    std::uint32_t next = run_;
    if (to.y != from.y) {
      next = to.y > from.y ? portal.above : portal.below;
    } else if (!goes_on(run_, corner.x, to.x > from.x)) {
      next = run_ == portal.above ? portal.below : portal.above;
    }
    if (next != run_) cross(portal, corner.x);
    return true;
  }

  /// Along a line, as far as the run in which it ends. False if obstacles bar it.
  bool follow(HalfCells from, HalfCells to) {
    if (from.y == to.y) return true;
    const bool up = to.y > from.y;
    const std::int64_t rows = up ? to.y - from.y : from.y - to.y;  // in half cells
    for (std::int64_t away = from.y % 2 == 0 ? 2 : 1; away < rows; away += 2) {
      const std::int64_t at = from.x * rows + (to.x - from.x) * away;  // x times rows
      const SightRun& run = portals_.run(run_);
      std::uint32_t id = up ? run.first_above : run.first_below;
      const std::uint32_t last = up ? portals_.end_above(run_) : portals_.end_below(run_);
      std::uint32_t end = last;
      while (id < end) {  // the first one that does not end left of the line
        const std::uint32_t middle = id + (end - id) / 2;
        if (2 * std::int64_t{portals_.portal(middle).right} * rows < at) {
          id = middle + 1;
        } else {
          end = middle;
        }
      }
      if (id == last) return false;
      cross(portals_.portal(id), static_cast<int>(at / (2 * rows)));
    }
    return true;
  }

  /// To a cell of the run that was reached. False for one of another run.
  bool end_at(Cell goal) {
    if (run_ != portals_.run_of(goal)) return false;
    walk_to(goal.x);
    return true;
  }

 private:
  /// Does a run go on beside a vertex of its side?
  bool goes_on(std::uint32_t id, int x, bool right) const {
    const SightRun& run = portals_.run(id);
    return right ? run.right > x : run.left < x;
  }

  /// Into the run on the other side of a portal, near column x.
  void cross(const Portal& portal, int x) {
    const bool up = run_ == portal.below;
    const std::uint32_t next = up ? portal.above : portal.below;
    int here = std::max(portal.left, std::min(x, portal.right - 1));
    int there = here;
    if (portal.left == portal.right) {  // a gap
      const bool from_left = portals_.run(run_).right == portal.left;
      here = from_left ? portal.left - 1 : portal.left;
      there = from_left ? portal.left : portal.left - 1;
    }
    walk_to(here);
    cells_.push_back({there, cells_.back().y + (up ? 1 : -1)});
    run_ = next;
  }

  void walk_to(int x) {
    while (cells_.back().x != x) {
      const Cell last = cells_.back();
      cells_.push_back({last.x + (x > last.x ? 1 : -1), last.y});
    }
  }

  const Portals& portals_;
  std::vector<Cell>& cells_;
  std::uint32_t run_;
};

}  // namespace

bool write_trail(const Portals& portals, Cell start, std::span<const std::uint32_t> corners,
                 Cell goal, std::vector<Cell>& cells) {
  Trail trail(portals, start, cells);
  HalfCells at = centre(start);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TautCorner& corner = portals.corners()[corners[i]];
    if (!trail.follow(at, vertex(corner))) return false;
    at = vertex(corner);
    const bool is_last = i + 1 == corners.size();
    const HalfCells to = is_last ? centre(goal) : vertex(portals.corners()[corners[i + 1]]);
    if (!trail.leave(corner, to)) return false;
  }
  return trail.follow(at, centre(goal)) && trail.end_at(goal);
}

}  // namespace wend
