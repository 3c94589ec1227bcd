#include "wend/space/se2/outline_clearance.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "wend/geometry/trigonometry.hpp"
#include "wend/robot/sweep/footprint_rows.hpp"
#include "wend/robot/sweep/sweep.hpp"
#include "wend/space/se2/motion.hpp"

namespace wend {
namespace {

constexpr std::size_t kCellsPerCorner = 16;

/// Calls visit(x, y) with each convex corner of the blocked cells, some of them twice.
template <class Visit>
void for_each_corner(const BitGrid& blocked, Visit&& visit) {
  for (int y = 0; y < blocked.height(); ++y) {
    const auto row = blocked.row_words(y);
    const auto below = blocked.row_words(y - 1);
    const auto above = blocked.row_words(y + 1);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i] == 0) continue;
      const std::uint64_t left = row[i] << 1U | (i > 0 ? row[i - 1] >> 63U : 0);
      const std::uint64_t right = row[i] >> 1U | (i + 1 < row.size() ? row[i + 1] << 63U : 0);
      for (const int up : {0, 1}) {
        const std::uint64_t ends = row[i] & ~(up == 0 ? below[i] : above[i]);
        for (const int side : {0, 1}) {
          std::uint64_t cells = ends & ~(side == 0 ? left : right);
          for (; cells != 0; cells &= cells - 1) {
            visit(static_cast<int>(64 * i) + std::countr_zero(cells) - 1 + side, y + up);
          }
        }
      }
    }
  }
}

}  // namespace

OutlineClearance::OutlineClearance(const FreeSpace& space, const Polygon& outline) {
  const BitGrid& blocked = space.obstacles().blocked();
  if (!is_convex(outline.corners())) return;
  columns_ = static_cast<std::size_t>(blocked.width() / kTile) + 1;
  rows_ = blocked.height() / kTile + 1;
  std::vector<std::uint32_t> counts(columns_ * static_cast<std::size_t>(rows_) + 1, 0);
  std::size_t count = 0;
  for_each_corner(blocked, [&](int x, int y) {
    ++counts[tile_of(x / kTile, y / kTile)];
    ++count;
  });
  if (kCellsPerCorner * count > space.map().size()) return;
  std::uint32_t sum = 0;
  for (std::uint32_t& first : counts) first = sum += first;
  corners_.resize(count);
  // From behind, so that each tile's number ends as its first corner.
  for_each_corner(blocked, [&](int x, int y) {
    corners_[--counts[tile_of(x / kTile, y / kTile)]] = {static_cast<float>(x),
                                                         static_cast<float>(y)};
  });
  tiles_ = std::move(counts);
  outline_ = outline.corners();
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const Point& a = outline_[i];
    const Point& b = outline_[(i + 1) % outline_.size()];
    const double length = straight_distance(a, b);
    const Point normal{(b.y - a.y) / length, (a.x - b.x) / length};
    edges_.push_back({normal, normal.x * a.x + normal.y * a.y});
  }
  constexpr double kRounding = 1 + 1e-9;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Point& before = edges_[i].normal;
    const Point& behind = edges_[(i + 1) % edges_.size()].normal;
    const double half = std::max((1 + before.x * behind.x + before.y * behind.y) / 2, 0.0);
    mitre_ = std::max(mitre_, kRounding / std::sqrt(half));
    farthest_ = std::max(farthest_, kRounding * straight_distance(outline_[i], {}));
  }
}

/// The distance of a point from the obstacles, or less.
double OutlineClearance::of_corner(const FreeSpace& space, Point corner, double most) const {
  if (space.outside() == OutsidePolicy::blocked) {
    most = std::min(most, distance_inside(space, corner));
    if (most <= 0) return most;
  }
  // No obstacle is farther from the point than from the nearest one on the map.
  const Point on_map{std::clamp<double>(corner.x, 0, space.width()),
                     std::clamp<double>(corner.y, 0, space.height())};
  const Cell cell{std::min(static_cast<int>(on_map.x), space.width() - 1),
                  std::min(static_cast<int>(on_map.y), space.height() - 1)};
  constexpr double kToCorner = 0.7072;  // from the middle of a cell, or a bit more
  const double far = 2 * (most + kToCorner);
  const auto enough = static_cast<std::uint32_t>(far * far) + 1;
  const std::uint32_t squared = space.squared_half_cell_clearance(cell, enough);
  if (squared == enough) return most;
  const double clear =
      0.5 * std::sqrt(static_cast<double>(squared)) - straight_distance(on_map, centre_of(cell));
  if (clear >= most) return most;
  constexpr double kNear = 2;
  if (clear >= kNear) return clear;
  const double near = std::min(most, kNear);
  double least = near * near;
  any_obstacle(space, Box(on_map).grown_by(near), [&](Cell square) {
    const double dx = std::max({square.x - on_map.x, on_map.x - square.x - 1, 0.0});
    const double dy = std::max({square.y - on_map.y, on_map.y - square.y - 1, 0.0});
    least = std::min(least, dx * dx + dy * dy);
    return false;
  });
  return std::min(near, std::sqrt(least));
}

/// How far a point is outside the edges that it is farthest outside of; `most` or more is as good as that.
double OutlineClearance::outside(double ahead, double aside, double most) const {
  double outside = -std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_) {
    outside = std::max(outside, edge.normal.x * ahead + edge.normal.y * aside - edge.offset);
    if (outside >= most) break;
  }
  return outside;
}

double OutlineClearance::at(const FreeSpace& space, const Pose& pose, double most) const {
  const auto [sine, cosine] = sine_and_cosine(pose.heading);
  double least = most;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Point low{kFar, kFar};
  Point high{-kFar, -kFar};
  for (const Point& corner : outline_) {
    const Point placed{pose.x + cosine * corner.x - sine * corner.y,
                       pose.y + sine * corner.x + cosine * corner.y};
    least = std::min(least, of_corner(space, placed, least));
    if (least <= 0) return least;
    low = {std::min(low.x, placed.x), std::min(low.y, placed.y)};
    high = {std::max(high.x, placed.x), std::max(high.y, placed.y)};
  }
  const auto tile_at = [&](double at, int size) {
    return std::clamp(static_cast<int>(std::floor(at / kTile)), 0, size - 1);
  };
  const int first_row = tile_at(low.y - least, rows_);
  const int last_row = tile_at(high.y + least, rows_);
  const int first = tile_at(low.x - least, static_cast<int>(columns_));
  const int last = tile_at(high.x + least, static_cast<int>(columns_));
  double squared_reach = reach(least) * reach(least);
  for (int row = first_row; row <= last_row; ++row) {
    const std::uint32_t end = tiles_[tile_of(last, row) + 1];
    for (std::uint32_t i = tiles_[tile_of(first, row)]; i < end; ++i) {
      const double dx = static_cast<double>(corners_[i].x) - pose.x;
      const double dy = static_cast<double>(corners_[i].y) - pose.y;
      if (dx * dx + dy * dy > squared_reach) continue;
      const double far = outside(cosine * dx + sine * dy, cosine * dy - sine * dx, least);
      if (far >= least) continue;
      least = far;
      squared_reach = reach(least) * reach(least);
    }
    if (least <= 0) return least;
  }
  return least;
}

}  // namespace wend
