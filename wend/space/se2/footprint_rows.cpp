#include "wend/space/se2/footprint_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "wend/robot/placed_polygon.hpp"
#include "wend/space/se2/motion.hpp"

namespace wend {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// From where to where a shape reaches in a row.
struct Reach {
  double low = kNowhere;
  double high = -kNowhere;

  void include(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

bool is_convex(std::span<const Point> corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % count];
    const Point& c = corners[(i + 2) % count];
    if ((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) < 0) return false;
  }
  return true;
}

/// An edge of a shape, from its lower end to its upper one.
struct Slope {
  Point low;
  Point high;
  double per_row = 0;  // how far it goes to the right on the way up a row

  Slope() = default;
  Slope(const Point& a, const Point& b) : low(a.y <= b.y ? a : b), high(a.y <= b.y ? b : a) {
    if (high.y > low.y) per_row = (high.x - low.x) / (high.y - low.y);
  }

  /// Includes the part with y in [bottom, top].
  void include_part(double bottom, double top, Reach& reach) const {
    if (high.y < bottom || low.y > top) return;
    reach.include(low.y >= bottom ? low.x : low.x + (bottom - low.y) * per_row);
    reach.include(high.y <= top ? high.x : low.x + (top - low.y) * per_row);
  }
};

/// Is any of the cells from `first` to `last`, both on the map, set in a row?
bool any_set(std::span<const std::uint64_t> words, int first, int last) {
  const auto begin = static_cast<std::size_t>(first) + 1;  // the bit of cell x is x + 1
  const auto end = static_cast<std::size_t>(last) + 1;
  const std::uint64_t from = ~std::uint64_t{0} << (begin % 64);
  const std::uint64_t to = ~std::uint64_t{0} >> (63 - end % 64);
  if (begin / 64 == end / 64) return (words[begin / 64] & from & to) != 0;
  if ((words[begin / 64] & from) != 0 || (words[end / 64] & to) != 0) return true;
  for (std::size_t i = begin / 64 + 1; i < end / 64; ++i) {
    if (words[i] != 0) return true;
  }
  return false;
}

}  // namespace

FootprintRows::FootprintRows(const Polygon& outline)
    : count_(outline.corners().size()),
      circumscribed_(farthest_distance(outline, {0, 0})),
      convex_(is_convex(outline.corners())) {
  std::ranges::copy(outline.corners(), corners_.begin());
}

bool FootprintRows::meet_obstacle(const FreeSpace& space, const Pose& pose, double margin) const {
  const auto [sine, cosine] = sine_and_cosine(pose.heading);
  std::array<Point, Polygon::kMostCorners> placed;
  double bottom = kNowhere;
  double top = -kNowhere;
  for (std::size_t i = 0; i < count_; ++i) {
    const Point& corner = corners_[i];
    placed[i] = {pose.x + cosine * corner.x - sine * corner.y,
                 pose.y + sine * corner.x + cosine * corner.y};
    bottom = std::min(bottom, placed[i].y);
    top = std::max(top, placed[i].y);
  }
  std::array<Slope, Polygon::kMostCorners> slopes;
  for (std::size_t i = 0; i < count_; ++i) {
    slopes[i] = Slope(placed[i], placed[i + 1 == count_ ? 0 : i + 1]);
  }
  const bool closed = space.outside() == OutsidePolicy::blocked;
  const double grown = margin - kOverlapTolerance;
  const auto first_row = static_cast<int>(std::floor(bottom - grown));
  const auto last_row = static_cast<int>(std::ceil(top + grown)) - 1;
  if (closed && (first_row < 0 || last_row >= space.height())) return true;
  for (int row = std::max(first_row, 0); row <= std::min(last_row, space.height() - 1); ++row) {
    Reach reach;
    for (std::size_t i = 0; i < count_; ++i) {
      slopes[i].include_part(row - grown, row + 1 + grown, reach);
    }
    if (reach.low > reach.high) continue;
    const auto first = static_cast<int>(std::floor(reach.low - grown));
    const auto last = static_cast<int>(std::ceil(reach.high + grown)) - 1;
    if (closed && (first < 0 || last >= space.width())) return true;
    const int from = std::max(first, 0);
    const int to = std::min(last, space.width() - 1);
    if (from <= to && any_set(space.obstacles().blocked().row_words(row), from, to)) return true;
  }
  return false;
}

}  // namespace wend
