#include "wend/robot/sweep/point_sweep.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/arc_distance.hpp"
#include "wend/robot/sweep/sweep.hpp"

namespace wend {
namespace {

// The union of the obstacles without the points near its edge: for each row the segments of obstacles,
// shortened at both ends; between two rows the segments with obstacles on both sides.

constexpr double kNear = kPointTolerance;

/// Obstacles of one row of cells, or of the two rows beside a line between them: cells blocked in both.
class ObstacleRow {
 public:
  ObstacleRow(const FreeSpace& space, int y) : ObstacleRow(space, y, y) {}
  ObstacleRow(const FreeSpace& space, int y, int other)
      : words_(space.obstacles().blocked().row_words(y)),
        other_(space.obstacles().blocked().row_words(other)),
        width_(space.width()) {}

  /// Does [left, right] reach into a segment of obstacles?
  bool reached_by(double left, double right) const {
    if (right < 0 || left > width_) return false;
    const auto first = static_cast<int>(std::floor(std::max(left + kNear, 0.0)));
    const auto last = static_cast<int>(std::ceil(std::min(right - kNear, width_ + 0.0))) - 1;
    if (last < first) return first > 0 && first < width_ && any(first - 1) && any(first);
    return any(first, std::min(last, width_ - 1));
  }

 private:
  std::uint64_t word(std::size_t i) const { return words_[i] & other_[i]; }

  bool any(int x) const { return any(x, x); }
  bool any(int first, int last) const {
    if (last < first) return false;
    const auto begin = static_cast<std::size_t>(first) + 1;  // the bit of cell x is x + 1
    const auto end = static_cast<std::size_t>(last) + 1;     // this one included
    const std::uint64_t from_begin = ~std::uint64_t{0} << (begin % 64);
    const std::uint64_t to_end = ~std::uint64_t{0} >> (63 - end % 64);
    if (begin / 64 == end / 64) return (word(begin / 64) & from_begin & to_end) != 0;
    if ((word(begin / 64) & from_begin) != 0) return true;
    for (std::size_t i = begin / 64 + 1; i < end / 64; ++i) {
      if (word(i) != 0) return true;
    }
    return (word(end / 64) & to_end) != 0;
  }

  std::span<const std::uint64_t> words_;
  std::span<const std::uint64_t> other_;
  int width_;
};

/// Exactly two obstacles that touch at a corner.
struct Gap {
  Point corner;
  int slope;  // slope of the line through both: 1 or -1

  /// Positive on one of its sides, negative on the other.
  double side_of(Point point) const { return (point.x - corner.x) * slope - (point.y - corner.y); }
  bool contains(Point point) const {
    return std::abs(point.x - corner.x) <= kNear && std::abs(point.y - corner.y) <= kNear;
  }
};

std::optional<Gap> gap_at(const FreeSpace& space, int x, int y) {
  if (x <= 0 || y <= 0 || x >= space.width() || y >= space.height()) return std::nullopt;
  const BitGrid& obstacles = space.obstacles().blocked();
  const bool rising = obstacles[{x - 1, y - 1}];
  if (obstacles[{x, y}] != rising) return std::nullopt;
  if (obstacles[{x - 1, y}] == rising || obstacles[{x, y - 1}] == rising) return std::nullopt;
  return Gap{{x + 0.0, y + 0.0}, rising ? 1 : -1};
}

std::optional<Gap> gap_around(const FreeSpace& space, Point point) {
  const double x = std::round(point.x);
  const double y = std::round(point.y);
  if (std::abs(point.x - x) > kNear || std::abs(point.y - y) > kNear) return std::nullopt;
  if (!(x > 0 && y > 0 && x < space.width() && y < space.height())) return std::nullopt;
  return gap_at(space, static_cast<int>(x), static_cast<int>(y));
}

/// A line, cut at the borders of rows.
class CutLine {
 public:
  CutLine(const FreeSpace& space, const Line& line)
      : space_(space),
        line_(line),
        step_{line.to.x - line.from.x, line.to.y - line.from.y},
        low_(std::min(line.from.y, line.to.y)),
        high_(std::max(line.from.y, line.to.y)) {}

  bool enters_obstacles() const {
    const double rows = space_.height();
    if (high_ < 0 || low_ > rows) return false;
    const auto first = static_cast<int>(std::floor(std::max(low_, 0.0)));
    const auto last = static_cast<int>(std::floor(std::min(high_ + kNear, rows - 1)));
    for (int y = first; y <= last; ++y) {
      const auto inside = between(y + kNear, y + 1 - kNear);
      if (inside && ObstacleRow(space_, y).reached_by(inside->left, inside->right)) return true;
      if (y == 0) continue;
      const auto border = between(y - kNear, y + kNear);
      if (border && ObstacleRow(space_, y - 1, y).reached_by(border->left, border->right))
        return true;
    }
    return false;
  }

  /// Requires a line that does not enter obstacles. A gap that contains an end of the line is not passed.
  bool passes_a_gap() const {
    const auto first = static_cast<int>(std::clamp(std::ceil(low_ - kNear), 1.0, kFarAway));
    const auto last =
        static_cast<int>(std::clamp(std::floor(high_ + kNear), 0.0, space_.height() - 1.0));
    for (int y = first; y <= last; ++y) {
      const auto border = between(y - kNear, y + kNear);
      if (border && passes_a_gap(y, *border)) return true;
    }
    return false;
  }

 private:
  static constexpr double kFarAway = 1e9;

  struct Stretch {
    double left;
    double right;
  };

  /// The columns in which the line is between two heights; only one for a vertical line.
  std::optional<Stretch> between(double low, double high) const {
    if (high_ < low || low_ > high) return std::nullopt;
    if (low_ == high_) return stretch(0, 1);
    const double down = std::clamp((low - line_.from.y) / step_.y, 0.0, 1.0);
    const double up = std::clamp((high - line_.from.y) / step_.y, 0.0, 1.0);
    return stretch(down, up);
  }

  Stretch stretch(double from, double to) const {
    const double a = line_.from.x + from * step_.x;
    const double b = line_.from.x + to * step_.x;
    return {std::min(a, b), std::max(a, b)};
  }

  bool passes_a_gap(int y, const Stretch& border) const {
    const auto left = static_cast<int>(std::clamp(std::ceil(border.left - kNear), 1.0, kFarAway));
    const auto right =
        static_cast<int>(std::clamp(std::floor(border.right + kNear), 0.0, space_.width() - 1.0));
    for (int x = left; x <= right; ++x) {
      const auto gap = gap_at(space_, x, y);
      if (!gap || gap->contains(line_.from) || gap->contains(line_.to)) continue;
      if ((gap->side_of(line_.from) > 0) != (gap->side_of(line_.to) > 0)) return true;
    }
    return false;
  }

  const FreeSpace& space_;
  Line line_;
  Point step_;
  double low_;  // rows
  double high_;
};

/// Is there no obstacle near the box around a line? Not asked for large boxes, of which the line crosses a
/// small part.
bool clearly_free(const FreeSpace& space, const SweptPiece& line) {
  constexpr double kLarge = 64;  // cells
  const Box box = line.box().grown_by(kNear);
  if (box.high.x - box.low.x > kLarge || box.high.y - box.low.y > kLarge) return false;
  const bool edge_counts = space.outside() == OutsidePolicy::blocked;
  if (edge_counts &&
      !(distance_inside(space, box.low) > 0 && distance_inside(space, box.high) > 0)) {
    return false;
  }
  return !any_obstacle(space, box, [](Cell /*square*/) { return true; });
}

}  // namespace

bool in_gap(const FreeSpace& space, Point point) { return gap_around(space, point).has_value(); }

/// The point stopped in a gap. Does it pass through the gap on its way from `before` to `after`?
bool PointSweep::passes_its_gap(Point before, Point after) const {
  const auto gap = gap_around(*space_, at_);
  return gap && !gap->contains(after) && (gap->side_of(before) > 0) != (gap->side_of(after) > 0);
}

void PointSweep::arrive(Point to) {
  if (to == at_) return;
  const auto gap = adjacency_ == Adjacency::edges ? gap_around(*space_, to) : std::nullopt;
  if (!gap) {
    before_gap_.reset();
  } else if (!gap->contains(at_)) {
    before_gap_ = at_;
  }
  at_ = to;
}

bool PointSweep::go_to(Point to) {
  if (!exact_ || !is_exact(to)) return false;
  const Line line{at_, to};
  if (!clearly_free(*space_, SweptPiece(line))) {
    const CutLine cut(*space_, line);
    if (cut.enters_obstacles()) return false;
    if (adjacency_ == Adjacency::edges) {
      if (cut.passes_a_gap()) return false;
      if (before_gap_ && passes_its_gap(*before_gap_, to)) return false;
    }
  }
  arrive(to);
  return true;
}

bool PointSweep::go_along(const Arc& arc) {
  return exact_ && near_map(*space_, arc) && go_along_pieces(arc);
}

bool PointSweep::go_along_pieces(const Arc& arc) {
  if (!turns_far(arc)) {
    const SweptPiece piece(arc);
    // A piece that bulges less than that is treated as a line.
    if (piece.bulge <= kPointTolerance / 8) return go_to(piece.to);
    const bool touches_none = !any_obstacle(*space_, piece.box(), [&](Cell square) {
      return distance(piece.middle, square) <= piece.half_chord + kPointTolerance;
    });
    if (touches_none) {
      arrive(piece.to);
      return true;
    }
    const Point middle = point_on(arc, arc.length / 2);
    if (CutLine(*space_, {middle, middle}).enters_obstacles()) return false;
  }
  const auto halves = halves_of(arc);
  return go_along_pieces(halves[0]) && go_along_pieces(halves[1]);
}

}  // namespace wend
