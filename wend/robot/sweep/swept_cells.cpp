#include "wend/robot/sweep/swept_cells.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "wend/geometry/arc_distance.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"
#include "wend/robot/sweep/sweep.hpp"

namespace wend {
namespace {

constexpr double kTouch = 1e-9;  // cells

/// Around the base point's way: around points of it, and the arcs between them.
Box box_of(const Segment& segment) {
  constexpr double kSpacing = 1.0 / 16;  // cells
  const int pieces = 1 + static_cast<int>(std::abs(segment.length) / kSpacing);
  Box box(segment.from.point());
  for (int i = 1; i <= pieces; ++i) {
    box.include(pose_on(segment, static_cast<double>(i) / pieces).point());
  }
  // An arc is off its chord by an eighth of its length times its turn.
  const double bulge = std::abs(segment.length * segment.turn) / (8.0 * pieces * pieces);
  return box.grown_by(bulge + kTouch);
}

/// Which cells the space's robot sweeps on one segment.
class SegmentSweep {
 public:
  SegmentSweep(const FreeSpace& space, const Segment& segment)
      : space_(space), segment_(segment), way_(way_of_base(segment)) {}

  bool sweeps(Cell square) const {
    if (space_.is_point()) return distance(way_, square) <= kTouch;
    if (!space_.outline()) return !keeps_distance(space_, distance(way_, square));
    if (distance(way_, square) >= space_.radius_in_cells() + kSweepTolerance) return false;
    return segment_.turn == 0 ? overlaps_on_line(square) : overlaps(segment_, square);
  }

 private:
  bool overlaps_on_line(Cell square) const {
    const Point to = end_of(segment_).point();
    const Point by{to.x - segment_.from.x, to.y - segment_.from.y};
    return PlacedPolygon(*space_.outline(), segment_.from).overlaps_along(by, square);
  }

  /// Halves the segment until no point of the polygon moves so far on it that it could come near.
  bool overlaps(const Segment& segment, Cell square) const {
    constexpr double kSure = 0.02;  // cells: more than what fits_along() is unsure of
    const PlacedPolygon robot(*space_.outline(), pose_on(segment, 0.5));
    if (robot.overlaps(square)) return true;
    const double moves =
        (std::abs(segment.length) + space_.radius_in_cells() * std::abs(segment.turn)) / 2;
    if (robot.distance_to(square) >= moves + kSure) return false;
    if (moves + kSure <= kSweepTolerance) return true;
    const auto halves = halves_of(segment);
    return overlaps(halves[0], square) || overlaps(halves[1], square);
  }

  const FreeSpace& space_;
  const Segment& segment_;
  Arc way_;
};

Cell low_cell(const Box& box) { return cell_at(box.low); }
Cell high_cell(const Box& box) { return cell_at(box.high); }

Cell least(Cell a, Cell b) { return {std::min(a.x, b.x), std::min(a.y, b.y)}; }
Cell greatest(Cell a, Cell b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }

/// The segments between poses; of a single pose, a turn by nothing.
std::vector<Segment> segments_of(std::span<const Pose> poses) {
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    segments.push_back(segment_between(poses[i - 1], poses[i]));
  }
  if (segments.empty()) segments.emplace_back(poses.front(), 0, 0, 0);
  return segments;
}

bool on_map(const FreeSpace& space, Cell from, Cell low, Cell high) {
  return from.x + low.x >= 0 && from.y + low.y >= 0 && from.x + high.x < space.width() &&
         from.y + high.y < space.height();
}

bool is_free(const BitGrid& blocked, const SweptCells::Run& run, Cell from) {
  const auto bit = static_cast<std::size_t>(from.x + run.dx + 1);  // the bit of cell x is x + 1
  return (bits_from(blocked.row_words(from.y + run.dy), bit) & run.cells) == 0;
}

/// The same where some of the cells lie outside the map.
bool is_free_cell_by_cell(const BitGrid& blocked, const SweptCells::Run& run, Cell from) {
  for (std::uint64_t cells = run.cells; cells != 0; cells &= cells - 1) {
    const Cell cell{from.x + run.dx + std::countr_zero(cells), from.y + run.dy};
    if (blocked.contains(cell) && blocked[cell]) return false;
  }
  return true;
}

}  // namespace

SweptCells::SweptCells(const FreeSpace& space, std::span<const Pose> poses) {
  assert(!poses.empty());
  const std::vector<Segment> segments = segments_of(poses);
  Box way = box_of(segments.front());
  for (const Segment& segment : segments) {
    const Box box = box_of(segment);
    way.include(box.low);
    way.include(box.high);
  }
  way_low_ = low_cell(way);
  way_high_ = high_cell(way);
  const double margin = space.radius_in_cells() + kSweepTolerance;
  const Box around = way.grown_by(margin);
  low_ = way_low_;
  high_ = way_high_;
  for (int y = low_cell(around).y; y <= high_cell(around).y; ++y) {
    for (int x = low_cell(around).x; x <= high_cell(around).x; ++x) {
      const bool swept = std::ranges::any_of(segments, [&](const Segment& segment) {
        return SegmentSweep(space, segment).sweeps({x, y});
      });
      if (!swept) continue;
      constexpr int kCellsOfRun = 64;
      if (runs_.empty() || runs_.back().dy != y || x - runs_.back().dx >= kCellsOfRun) {
        runs_.push_back({x, y, 0});
      }
      runs_.back().cells |= std::uint64_t{1} << static_cast<unsigned>(x - runs_.back().dx);
      low_ = least(low_, {x, y});
      high_ = greatest(high_, {x, y});
    }
  }
  const Point middle{0.5, 0.5};
  const double farthest = std::max({distance(middle, way.low), distance(middle, way.high),
                                    distance(middle, Point{way.low.x, way.high.y}),
                                    distance(middle, Point{way.high.x, way.low.y})});
  const double half_cells = 2 * (farthest + margin);
  const double reach = std::ceil(half_cells * half_cells);
  constexpr double kMost = std::numeric_limits<std::uint32_t>::max();
  reach_ = static_cast<std::uint32_t>(std::min(reach, kMost));
}

bool fits(const FreeSpace& space, const SweptCells& swept, Cell from) {
  if (!on_map(space, from, swept.way_low(), swept.way_high())) return false;
  if (space.is_known_clear(from, swept.reach())) return true;
  const BitGrid& blocked = space.obstacles().blocked();
  if (on_map(space, from, swept.low(), swept.high())) {
    return std::ranges::all_of(
        swept.runs(), [&](const SweptCells::Run& run) { return is_free(blocked, run, from); });
  }
  if (space.outside() == OutsidePolicy::blocked) return false;
  return std::ranges::all_of(swept.runs(), [&](const SweptCells::Run& run) {
    return is_free_cell_by_cell(blocked, run, from);
  });
}

}  // namespace wend
