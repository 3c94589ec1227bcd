#include "wend/map/arc_clearance.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/arc_distance.hpp"

namespace wend {
namespace {

// Along an arc clearance changes by no more than the way, and so between a point and the centre of
// a cell. So the clearance of one cell, which is exact, tells much of all points near it.

/// The cell of the map that is nearest to a point.
Cell nearest_cell(const FreeSpace& space, Point point) {
  return {static_cast<int>(std::clamp(std::floor(point.x), 0.0, space.width() - 1.0)),
          static_cast<int>(std::clamp(std::floor(point.y), 0.0, space.height() - 1.0))};
}

struct Box {
  Point low;
  Point high;

  explicit Box(Point point) : low(point), high(point) {}

  void include(Point point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }

  Box grown_by(double margin) const {
    Box box({low.x - margin, low.y - margin});
    box.include({high.x + margin, high.y + margin});
    return box;
  }
};

/// Is there an obstacle of which this holds? All that reach into the box are asked.
template <class Predicate>
bool any_obstacle(const FreeSpace& space, const Box& box, Predicate&& predicate) {
  const Cell first = nearest_cell(space, box.low);
  const Cell last = nearest_cell(space, box.high);
  for (int y = first.y; y <= last.y; ++y) {
    const auto words = space.obstacles().row_words(y);
    const auto begin = static_cast<std::size_t>(first.x) + 1;  // the bit of cell x is x + 1
    const auto end = static_cast<std::size_t>(last.x) + 2;
    for (std::size_t i = begin / 64; 64 * i < end; ++i) {
      std::uint64_t bits = words[i];
      if (64 * i < begin) bits &= ~std::uint64_t{0} << (begin % 64);
      if (64 * i + 64 > end) bits &= ~(~std::uint64_t{0} << (end % 64));
      for (; bits != 0; bits &= bits - 1) {
        const auto x = static_cast<int>(64 * i) + std::countr_zero(bits) - 1;
        if (predicate(Cell{x, y})) return true;
      }
    }
  }
  return false;
}

/// A piece of an arc, of at most half a circle, and what holds all its points.
struct Piece {
  Point from;
  Point to;
  Point middle;       // of the chord
  double half_chord;  // the disc over the chord holds the piece
  double bulge;       // it is no farther off the chord: half_chord * tan(turn / 4), or a bit more

  explicit Piece(const Arc& arc)
      : from(arc.from.point()),
        to(point_on(arc, arc.length)),
        middle{(from.x + to.x) / 2, (from.y + to.y) / 2},
        half_chord(distance(from, to) / 2),
        bulge(half_chord * std::abs(arc.turn()) / kPi) {}

  Box box() const {
    Box ends(from);
    ends.include(to);
    return ends.grown_by(bulge);
  }
};

/// Moves the space's robot along arcs.
class Sweep {
 public:
  explicit Sweep(const FreeSpace& space) : space_(space), radius_(space.radius_in_cells()) {}

  bool fits_at(Point point) const {
    const Cell cell = nearest_cell(space_, point);
    const double clearance = space_.clearance(cell);
    const double from_centre = distance(point, centre_of(cell));
    if (far_enough(clearance - from_centre)) return true;
    if (!far_enough(clearance + from_centre)) return false;
    return !any_obstacle(space_, Box(point).grown_by(radius_),
                         [&](Cell square) { return !far_enough(distance(point, square)); });
  }

  bool fits(const Arc& arc) const {
    if (std::abs(arc.turn()) > kPi) return halves_fit(arc);
    const Piece piece(arc);
    const Cell cell = nearest_cell(space_, piece.middle);
    const Point centre = centre_of(cell);
    const double clearance = space_.clearance(cell);
    const auto [nearer_end, farther_end] =
        std::minmax({distance(centre, piece.from), distance(centre, piece.to)});
    const double farthest =
        std::min(distance(centre, piece.middle) + piece.half_chord, farther_end + piece.bulge);
    if (far_enough(clearance - farthest)) return true;
    if (!far_enough(clearance + nearer_end)) return false;
    constexpr double kShort = 2;
    if (std::abs(arc.length) > std::max(kShort, radius_)) return halves_fit(arc);
    return !any_obstacle(space_, piece.box().grown_by(radius_), [&](Cell square) {
      if (far_enough(distance(piece.middle, square) - piece.half_chord)) return false;
      return !far_enough(distance(piece.to, square)) || !far_enough(distance(arc, square));
    });
  }

 private:
  bool halves_fit(const Arc& arc) const {
    const double half = arc.length / 2;
    return fits({arc.from, half, arc.curvature}) && fits({pose_on(arc, half), half, arc.curvature});
  }

  bool far_enough(double cells) const { return cells > 0 && space_.far_enough(4 * cells * cells); }

  const FreeSpace& space_;
  double radius_;
};

}  // namespace

double arc_clearance(const FreeSpace& space, const Arc& arc) {
  const double length = std::abs(arc.length);
  const int pieces = std::max(static_cast<int>(std::ceil(length)), 1);
  double least = std::numeric_limits<double>::infinity();
  Box box(arc.from.point());
  for (int i = 0; i <= pieces; ++i) {
    const Point point = point_on(arc, arc.length * i / pieces);
    const Cell cell = nearest_cell(space, point);
    least = std::min(least, space.clearance(cell) + distance(point, centre_of(cell)));
    box.include(point);
  }
  if (std::isinf(least)) return least;
  const Point middle = point_on(arc, arc.length / 2);
  any_obstacle(space, box.grown_by(least + length / pieces / 2), [&](Cell square) {
    if (distance(middle, square) - length / 2 < least) {
      least = std::min(least, distance(arc, square));
    }
    return false;
  });
  return least;
}

bool fits_along(const FreeSpace& space, const Arc& arc) {
  if (space.radius_in_cells() == 0) return true;
  const Sweep sweep(space);
  return sweep.fits_at(arc.from.point()) && sweep.fits(arc);
}

}  // namespace wend
