#include "wend/geometry/arc_distance.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

constexpr double kTouching = 1e-12;  // cells
constexpr Point kOrigin{0, 0};

double without_rounding(double distance) { return distance < kTouching ? 0 : distance; }

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }

/// Faster than hypot(): no length here is so large or so small that its square is not a number.
double norm(Point point) { return std::sqrt(dot(point, point)); }

double distance_to_interval(double low, double high, double value) {
  return std::max({low - value, value - high, 0.0});
}

/// The distance to the closed unit square whose corner with the least coordinates is `low`.
double distance_to_unit_square(Point low, Point point) {
  return norm({distance_to_interval(low.x, low.x + 1, point.x),
               distance_to_interval(low.y, low.y + 1, point.y)});
}

/// An arc in its own coordinates: it leaves (0, 0) along +x and bends towards +y, around the
/// centre (0, 1 / curvature). All computed points stay near the arc, however far its centre is.
class OwnFrame {
 public:
  explicit OwnFrame(const Arc& arc)
      : from_(arc.from.point()),
        curvature_(arc.length == 0 ? 0 : std::abs(arc.curvature)),
        turn_(std::abs(arc.turn())) {
    assert(turn_ <= 2 * kPi + 1e-9);
    // In reverse it leaves against its heading, and it bends to the other side.
    const double gear = arc.length < 0 ? -1 : 1;
    const double side = gear * arc.curvature < 0 ? -1 : 1;
    const auto [sine, cosine] = sine_and_cosine(arc.from.heading);
    along_ = {gear * cosine, gear * sine};
    across_ = {-side * along_.y, side * along_.x};
    end_ = point_on(Arc{{}, 0, curvature_}, std::abs(arc.length));
  }

  double to(Point point) const { return distance_to(own({point.x - from_.x, point.y - from_.y})); }

  double to(Cell square) const {
    const Point low{square.x - from_.x, square.y - from_.y};
    double least =
        std::min(distance_to_unit_square(low, kOrigin), distance_to_unit_square(low, seen(end_)));
    // A side is nearest in its middle only to a point of the circle that lies farthest out.
    if (curvature_ > 0) {
      for (const Point out : {Point{1, 0}, Point{-1, 0}, Point{0, 1}, Point{0, -1}}) {
        const Point farthest = farthest_along(own(out));
        if (!passes_abreast(farthest)) continue;
        least = std::min(least, distance_to_unit_square(low, seen(farthest)));
      }
    }
    const std::array<Point, 4> corners{own(low), own({low.x + 1, low.y}),
                                       own({low.x + 1, low.y + 1}), own({low.x, low.y + 1})};
    for (std::size_t i = 0; i < corners.size() && least > 0; ++i) {
      least = std::min(least, distance_to(corners[i]));
      if (goes_in(corners[i], corners[(i + 1) % corners.size()])) return 0;
    }
    return least;
  }

 private:
  // Convert between own coordinates and offsets from the start in grid coordinates.
  Point own(Point offset) const { return {dot(offset, along_), dot(offset, across_)}; }
  Point seen(Point point) const {
    return {point.x * along_.x + point.y * across_.x, point.x * along_.y + point.y * across_.y};
  }

  /// Does the ray from the centre through this point meet the arc? Two cross products tell: the ray
  /// must be after the ray through the start and before the one through the end.
  bool passes_abreast(Point point) const {
    const bool after_start = point.x >= 0;
    const bool before_end =
        end_.x * (1 - curvature_ * point.y) >= point.x * (1 - curvature_ * end_.y);
    return turn_ <= kPi ? after_start && before_end : after_start || before_end;
  }

  /// 0 on the circle (or line), positive outside of it: curvature * (square of the distance from
  /// the centre - square of the radius).
  double outside(Point point) const { return curvature_ * dot(point, point) - 2 * point.y; }

  double distance_to(Point point) const {
    if (!passes_abreast(point))
      return std::min(norm(point), norm({point.x - end_.x, point.y - end_.y}));
    return std::abs(outside(point)) / (1 + norm({curvature_ * point.x, 1 - curvature_ * point.y}));
  }

  /// The point of the circle that lies farthest in a direction.
  Point farthest_along(Point direction) const {
    // (sin t, -cos t) / curvature from the centre, t the turn; 1 - cos t without cancellation.
    const double cosine = -direction.y;
    const double rest = cosine > 0 ? direction.x * direction.x / (1 + cosine) : 1 - cosine;
    return {direction.x / curvature_, rest / curvature_};
  }

  /// Does the line between two points a unit apart enter the circle, at a point of the arc? Where the
  /// arc cuts through a square, the part of the border between the two cuts is inside the circle; so
  /// on the way around the square one of the cuts enters it.
  bool goes_in(Point a, Point b) const {
    const Point step{b.x - a.x, b.y - a.y};
    // a + t step is on the circle where curvature t^2 + 2 half t + outside(a) is 0.
    const double half = curvature_ * dot(a, step) - step.y;
    const double discriminant = half * half - curvature_ * outside(a);
    if (outside(a) < 0 || half >= 0 || discriminant < 0) return false;
    const double t = outside(a) / (std::sqrt(discriminant) - half);  // the smaller one
    return t <= 1 && passes_abreast({a.x + t * step.x, a.y + t * step.y});
  }

  Point from_;
  double curvature_;  // at least 0
  double turn_;       // at least 0
  Point along_;       // unit vectors, in grid coordinates
  Point across_;
  Point end_;  // in own coordinates
};

}  // namespace

double distance(Point point, Cell square) {
  return distance_to_unit_square({static_cast<double>(square.x), static_cast<double>(square.y)},
                                 point);
}

double distance(const Arc& arc, Point point) { return without_rounding(OwnFrame(arc).to(point)); }

double distance(const Arc& arc, Cell square) { return without_rounding(OwnFrame(arc).to(square)); }

}  // namespace wend
