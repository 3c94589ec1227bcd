#include "wend/robot/sweep/placed_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

/// The region between two parallel lines: low < x * point.x + y * point.y < high.
struct Strip {
  double x;
  double y;
  double low;
  double high;

  double of(Point point) const { return x * point.x + y * point.y; }
};

/// An open square as seen from a polygon that moves by `by`: the square moves by -by. The region that it
/// passes is a hexagon, the intersection of three strips: two along the axes and one along the movement.
class PassedSquares {
 public:
  PassedSquares(Point by, Cell square)
      : strips_{{{1, 0, square.x - std::max(by.x, 0.0), square.x + 1 - std::min(by.x, 0.0)},
                 {0, 1, square.y - std::max(by.y, 0.0), square.y + 1 - std::min(by.y, 0.0)},
                 across(by, square)}},
        centre_{square.x + 0.5 - by.x / 2, square.y + 0.5 - by.y / 2} {
    for (Strip& strip : strips_) {
      strip.low += kOverlapTolerance;
      strip.high -= kOverlapTolerance;
    }
  }

  Point centre() const { return centre_; }

  /// Clips the line by one strip after the other.
  bool meet(const Line& line) const {
    double begin = 0;
    double end = 1;
    for (const Strip& strip : strips_) {
      const double from = strip.of(line.from);
      const double change = strip.of(line.to) - from;
      if (change == 0) {
        if (from < strip.low || from > strip.high) return false;
        continue;
      }
      const double enters = ((change > 0 ? strip.low : strip.high) - from) / change;
      const double leaves = ((change > 0 ? strip.high : strip.low) - from) / change;
      begin = std::max(begin, enters);
      end = std::min(end, leaves);
      if (begin > end) return false;
    }
    return true;
  }

 private:
  static Strip across(Point by, Cell square) {
    const double length = hypotenuse(by.x, by.y);
    constexpr double kEverything = std::numeric_limits<double>::max();
    if (length == 0) return {0, 0, -kEverything, kEverything};
    Strip strip{-by.y / length, by.x / length, 0, 0};
    const double middle = strip.of({square.x + 0.5, square.y + 0.5});
    const double half = (std::abs(strip.x) + std::abs(strip.y)) / 2;
    strip.low = middle - half;
    strip.high = middle + half;
    return strip;
  }

  std::array<Strip, 3> strips_;
  Point centre_;
};

}  // namespace

PlacedPolygon::PlacedPolygon(const Polygon& polygon, const Pose& pose)
    : size_(polygon.corners().size()), box_(pose.point()) {
  if (size_ > kFew) many_.resize(size_);
  const std::span<Point> corners = size_ > kFew ? std::span<Point>(many_) : few_;
  const auto [sine, cosine] = sine_and_cosine(pose.heading);
  for (std::size_t i = 0; i < size_; ++i) {
    const Point corner = polygon.corners()[i];
    corners[i] = {pose.x + cosine * corner.x - sine * corner.y,
                  pose.y + sine * corner.x + cosine * corner.y};
    if (i == 0) box_ = Box(corners[i]);
    box_.include(corners[i]);
  }
}

// A polygon and an open convex region overlap if an edge of the polygon meets the region, or if the
// whole region, and so its centre, lies inside the polygon.
bool PlacedPolygon::overlaps_along(Point by, Cell square) const {
  const PassedSquares passed(by, square);
  for (std::size_t i = 0; i < size_; ++i) {
    if (passed.meet(edge(i))) return true;
  }
  return is_inside(corners(), passed.centre());
}

std::optional<std::size_t> PlacedPolygon::side_across(Cell square) const {
  const PassedSquares passed({0, 0}, square);
  for (std::size_t i = 0; i < size_; ++i) {
    if (passed.meet(edge(i))) return i;
  }
  return std::nullopt;
}

double PlacedPolygon::distance_to(Cell square) const {
  if (is_inside(corners(), centre_of(square))) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < size_ && least > 0; ++i) {
    least = std::min(least, distance(edge(i), square));
  }
  return std::isfinite(least) ? least : 0;
}

}  // namespace wend
