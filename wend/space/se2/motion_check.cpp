#include "wend/space/se2/motion_check.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/arc_distance.hpp"
#include "wend/robot/fits_along.hpp"
#include "wend/robot/sweep.hpp"

namespace wend {
namespace {

constexpr double kPiece = 1;        // cells
constexpr double kShortest = 0.05;  // cells: a disc that is as near as this is decided exactly
constexpr double kSure = 0.02;      // cells that a polygon keeps from obstacles where it turns

/// Points at the middles of equal pieces of a motion.
class Middles {
 public:
  Middles(const Pose& from, const Motion& motion, int pieces) {
    const Motion piece = part_of(motion, 1.0 / pieces);
    const Pose first = pose_after(from, part_of(piece, 0.5));
    point_ = first.point();
    const Pose second = pose_after(from, part_of(piece, 1.5));
    step_ = {second.x - first.x, second.y - first.y};
    turn_ = sine_and_cosine(piece.turn);
  }

  const Point& point() const { return point_; }

  void go_on() {
    point_ = {point_.x + step_.x, point_.y + step_.y};
    step_ = {turn_.cosine * step_.x - turn_.sine * step_.y,
             turn_.sine * step_.x + turn_.cosine * step_.y};
  }

 private:
  Point point_;
  Point step_;
  SineCosine turn_;
};

}  // namespace

MotionCheck::MotionCheck(const FreeSpace& space)
    : space_(space),
      rows_(space.outline() != nullptr ? FootprintRows(*space.outline()) : FootprintRows()),
      circumscribed_(space.radius_in_cells()),
      inscribed_(space.inscribed_radius_in_cells()),
      spin_(space.outline() != nullptr ? circumscribed_ : 0),
      known_(circumscribed_ + (space.outline() != nullptr ? 8 : 2)),
      uniform_(space.uniform_terrain()) {}

int MotionCheck::pieces_of(const Motion& motion) const {
  const double reach = std::abs(motion.length) + spin_ * std::abs(motion.turn);
  return std::max(1, static_cast<int>(std::ceil(reach / kPiece)));
}

double MotionCheck::room_at(Point point) const {
  const Cell cell = cell_at(point);
  const Point centre = centre_of(cell);
  const double dx = point.x - centre.x;
  const double dy = point.y - centre.y;
  return near_clearance(space_, cell) - circumscribed_ - std::sqrt(dx * dx + dy * dy);
}

/// Calls blocked(i, room) for each piece, unless an earlier one has shown that it is free. It returns true to stop.
template <class Blocked>
double MotionCheck::walk(const Pose& from, const Motion& motion, Blocked&& blocked) const {
  const int pieces = pieces_of(motion);
  const double length = std::abs(motion.length);
  Middles middles(from, motion, pieces);
  double sum = 0;
  for (int i = 0; i < pieces; ++i, middles.go_on()) {
    const Point point = middles.point();
    if (!on_map(point)) return kBlocked;
    if (blocked(i, pieces, point)) return kBlocked;
    sum += uniform_ ? 1 : space_.terrain(cell_at(point));
  }
  return sum * length / pieces;
}

double MotionCheck::cost_of_way(const Pose& from, const Motion& motion) const {
  return walk(from, motion, [](int, int, Point) { return false; });
}

double MotionCheck::cost(const Pose& from, const Motion& motion) const {
  if (!stays_on_map(from, motion)) return kBlocked;
  if (space_.is_point()) {
    return fits_along(space_, segment_of(from, motion)) ? cost_of_way(from, motion) : kBlocked;
  }
  const double reach = std::abs(motion.length) + spin_ * std::abs(motion.turn);
  int free_until = 0;  // the first piece that is not known to be free
  return walk(from, motion, [&](int i, int pieces, Point point) {
    if (i < free_until) return false;
    const double piece = reach / pieces;
    const double room = room_at(point);
    if (room >= piece / 2) {
      free_until = i + 1;
      if (piece > 0) free_until += static_cast<int>(std::min(room / piece - 0.5, 1e6));
      return false;
    }
    const Motion before = part_of(motion, static_cast<double>(i) / pieces);
    return !piece_fits(pose_after(from, before),
                       {motion.length / pieces, motion.turn / pieces, motion.course}, piece / 2);
  });
}

/// Far from the map's edge this is decided at once.
bool MotionCheck::stays_on_map(const Pose& from, const Motion& motion) const {
  const Pose to = pose_after(from, motion);
  const double way = std::abs(motion.length);
  const double edge =
      std::min(distance_inside(space_, from.point()), distance_inside(space_, to.point()));
  if (edge >= way / 2) return true;
  return distance_inside(space_, segment_of(from, motion)) >= -kOverlapTolerance;
}

/// `from` is where the piece begins; no point of the robot is farther than half_reach from where it is at the
/// middle.
bool MotionCheck::piece_fits(const Pose& from, const Motion& motion, double half_reach) const {
  const Motion half = part_of(motion, 0.5);
  const Pose middle = pose_after(from, half);
  bool decided = false;
  const bool fits = rows_.empty() ? disc_fits(from, motion, middle, half_reach, decided)
                                  : polygon_fits(from, motion, middle, half_reach, decided);
  if (decided) return fits;
  return piece_fits(from, half, half_reach / 2) && piece_fits(middle, half, half_reach / 2);
}

bool MotionCheck::disc_fits(const Pose& from, const Motion& motion, const Pose& middle,
                            double half_reach, bool& decided) const {
  decided = true;
  if (!on_map(middle.point())) return false;
  const double room = room_at(middle.point());
  if (room >= half_reach) return true;
  if (half_reach < kShortest) return fits_along(space_, segment_of(from, motion));
  const double wide = circumscribed_ + half_reach;
  bool blocked = false;
  bool near = edge_clearance(space_, middle.point()) < wide;
  any_obstacle(space_, Box(middle.point()).grown_by(wide), [&](Cell square) {
    const double gap = distance(middle.point(), square);
    near = near || gap < wide;
    blocked = !keeps_distance(space_, gap);
    return blocked;
  });
  decided = blocked || !near;
  return !blocked;
}

bool MotionCheck::polygon_fits(const Pose& from, const Motion& motion, const Pose& middle,
                               double half_reach, bool& decided) const {
  decided = true;
  if (!on_map(middle.point())) return false;
  if (room_at(middle.point()) >= half_reach) return true;
  if (!rows_.meet_obstacle(space_, middle, half_reach + kSure)) return true;
  if (rows_.convex() && rows_.meet_obstacle(space_, middle, 0)) return false;
  if (half_reach <= kMargin - kSure) {
    const bool exact = motion.turn == 0 || !rows_.convex();
    return exact && fits_along(space_, segment_of(from, motion));
  }
  decided = false;
  return true;
}

}  // namespace wend
