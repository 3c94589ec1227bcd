#include "wend/space/se2/motion_check.hpp"

#include <algorithm>
#include <cmath>

#include "wend/geometry/arc_distance.hpp"
#include "wend/robot/cell_costs.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"
#include "wend/robot/sweep/sweep.hpp"

namespace wend {
namespace {

constexpr double kPiece = 1;        // cells
constexpr double kShortest = 0.05;  // cells: a disc that is as near as this is decided exactly
constexpr double kSure = 0.004;     // cells that a polygon keeps from obstacles where it turns

/// How far FreeSpace has distances at hand: as far as the robot's radius and its clearance cost need them.
std::uint32_t known_distance(const FreeSpace& space) {
  constexpr double kLeastRadius = 0.5;
  const double radius = space.radius_in_cells();
  const double cells = space.robot().clearance_distance / space.map().frame().resolution;
  const double band = space.robot().clearance_cost > 0 ? cells : 0;
  if (radius <= kLeastRadius && band == 0) return 0;
  const double beyond = space.outline() != nullptr ? 8 : 2;
  const double known = radius + std::max(band, beyond);
  return static_cast<std::uint32_t>(std::min(4 * known * known, 1e9));
}

/// Infinite on a map with terrain.
double plain_room(const FreeSpace& space) {
  if (!space.map().uniform_terrain()) return MotionCheck::kBlocked;
  // The cell's centre is what costs depend on.
  return space.robot().clearance_distance / space.map().frame().resolution + 1;
}

/// How many further pieces of a way are within some room of the middle of one.
int pieces_within(double room, double piece) {
  constexpr double kMost = 1e6;
  return piece > 0 ? static_cast<int>(std::min(std::max(room / piece - 0.5, 0.0), kMost)) : 0;
}

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
    straight_ = piece.turn == 0;
  }

  const Point& point() const { return point_; }

  void go_on() {
    point_ = {point_.x + step_.x, point_.y + step_.y};
    if (straight_) return;
    step_ = {turn_.cosine * step_.x - turn_.sine * step_.y,
             turn_.sine * step_.x + turn_.cosine * step_.y};
  }

 private:
  Point point_;
  Point step_;
  SineCosine turn_;
  bool straight_;
};

}  // namespace

MotionCheck::MotionCheck(const FreeSpace& space)
    : space_(space),
      rows_(space.outline() != nullptr ? FootprintRows(*space.outline()) : FootprintRows()),
      circumscribed_(space.radius_in_cells()),
      spin_(space.outline() != nullptr ? circumscribed_ : 0),
      known_(known_distance(space)),
      costs_its_length_(space.uniform_terrain() && space.robot().clearance_distance == 0),
      plain_room_(plain_room(space)) {
  if (space.outline() != nullptr && known_ > 0) {
    clearance_ = OutlineClearance(space, *space.outline());
  }
  if (rows_.empty()) {
    constexpr double kToCorner = 0.7072;  // from a cell's centre, or a bit more
    const double far = circumscribed_ + kToCorner + kPiece / 2;
    clear_ = static_cast<std::uint32_t>(std::min(std::ceil(4 * far * far), 4e9));
  }
  if (!costs_its_length_) list_prices();
}

/// On uniform terrain the distance of a cell tells what it costs, so that one look at the map is enough for both.
void MotionCheck::list_prices() {
  constexpr std::uint32_t kMostPrices = 1 << 14;
  if (!space_.map().uniform_terrain() || known_ == 0 || known_ >= kMostPrices) return;
  const Robot& robot = space_.robot();
  const CellCosts costs(robot, space_.map().frame().resolution);
  for (std::uint32_t squared = 0; squared <= known_ + 1; ++squared) {
    const double multiplier = static_cast<double>(costs.steps(1, squared)) / CostMap::kOne;
    prices_.push_back(space_.far_enough(squared) ? multiplier
                                                 : multiplier * (1 + robot.clearance_cost));
  }
}

int MotionCheck::pieces_of(const Motion& motion) const {
  const double reach = std::abs(motion.length) + spin_ * std::abs(motion.turn);
  return std::max(1, static_cast<int>(std::ceil(reach / kPiece)));
}

double MotionCheck::room_at(Point point) const {
  const Cell cell = on_map(point) ? cell_on_map(point) : nearest_cell(space_, point);
  if (known_ == 0) {
    return near_clearance(space_, cell) - circumscribed_ -
           straight_distance(point, centre_of(cell));
  }
  const std::uint32_t squared = space_.squared_half_cell_clearance(cell, known_);
  const double clearance = 0.5 * std::sqrt(static_cast<double>(squared));
  return clearance - circumscribed_ - straight_distance(point, centre_of(cell));
}

/// The same for a convex polygon at a pose, so far that it is worth looking.
double MotionCheck::room_around(const Pose& pose) const {
  constexpr double kMost = 16;  // cells
  return clearance_.at(space_, pose, kMost);
}

double MotionCheck::cost_of_way(const Pose& from, const Motion& motion) const {
  const int pieces = pieces_of(motion);
  Middles middles(from, motion, pieces);
  double sum = 0;
  for (int i = 0; i < pieces; ++i, middles.go_on()) {
    if (on_map(middles.point())) sum += multiplier_at(middles.point());
  }
  return sum * std::abs(motion.length) / pieces;
}

double MotionCheck::cost(const Pose& from, const Motion& motion) const {
  if (!stays_on_map(from, motion)) return kBlocked;
  if (space_.is_point()) {
    return fits_along(space_, segment_of(from, motion)) ? cost_of_way(from, motion) : kBlocked;
  }
  const int pieces = pieces_of(motion);
  const double piece = (std::abs(motion.length) + spin_ * std::abs(motion.turn)) / pieces;
  Middles middles(from, motion, pieces);
  double sum = 0;
  for (int i = 0; i < pieces;) {
    const Point point = middles.point();
    if (!on_map(point)) return kBlocked;
    int free_until = i + 1;   // the first piece that is not known to be free
    int plain_until = i + 1;  // the first one that may cost more than its length
    if (space_.is_known_clear(cell_on_map(point), clear_)) {
      // No branch here depends on how far it is clear, so that the next cells are read meanwhile.
    } else if (const double room = room_at(point); room >= piece / 2) {
      free_until += pieces_within(room, piece);
      if (room > plain_room_) plain_until += pieces_within(room - plain_room_, piece);
    } else {
      const double around =
          clearance_.empty() ? 0
                             : room_around(pose_after(from, part_of(motion, (i + 0.5) / pieces)));
      if (around >= piece / 2 + kSure) {
        free_until += pieces_within(around - kSure, piece);
      } else {
        const Pose begin = pose_after(from, part_of(motion, static_cast<double>(i) / pieces));
        const Motion part = part_of(motion, 1.0 / pieces);
        const bool known_near = around > 0 && piece / 2 > kMargin - kSure;
        if (!(known_near ? halves_fit(begin, part, piece / 2) : piece_fits(begin, part, piece / 2)))
          return kBlocked;
      }
    }
    sum += multiplier_at(point);
    middles.go_on();
    ++i;
    for (const int end = std::min(plain_until, pieces); i < end; ++i, middles.go_on()) sum += 1;
    for (const int end = std::min(free_until, pieces); i < end; ++i, middles.go_on()) {
      if (!on_map(middles.point())) return kBlocked;
      sum += multiplier_at(middles.point());
    }
  }
  return sum * std::abs(motion.length) / pieces;
}

/// Far from the map's edge this is decided at once.
bool MotionCheck::stays_on_map(const Pose& from, const Motion& motion) const {
  const double way = std::abs(motion.length);
  const double edge = distance_inside(space_, from.point());
  if (edge >= way) return true;
  const Pose to = pose_after(from, motion);
  if (std::min(edge, distance_inside(space_, to.point())) >= way / 2) return true;
  return distance_inside(space_, segment_of(from, motion)) >= -kOverlapTolerance;
}

/// `from` is where the piece begins; no point of the robot is farther than half_reach from where it is at the
/// middle.
bool MotionCheck::piece_fits(const Pose& from, const Motion& motion, double half_reach) const {
  const Pose middle = pose_after(from, part_of(motion, 0.5));
  bool decided = false;
  const bool fits = rows_.empty() ? disc_fits(from, motion, middle, half_reach, decided)
                                  : polygon_fits(from, motion, middle, half_reach, decided);
  return decided ? fits : halves_fit(from, motion, half_reach);
}

bool MotionCheck::halves_fit(const Pose& from, const Motion& motion, double half_reach) const {
  const Motion half = part_of(motion, 0.5);
  return piece_fits(from, half, half_reach / 2) &&
         piece_fits(pose_after(from, half), half, half_reach / 2);
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
  if (clearance_.empty()) {
    if (!rows_.meet_obstacle(space_, middle, half_reach + kSure)) return true;
    if (rows_.convex() && rows_.meet_obstacle(space_, middle, 0)) return false;
  } else {
    const double room = clearance_.at(space_, middle, half_reach + kSure);
    if (room >= half_reach + kSure) return true;
    if (room <= 0 && rows_.meet_obstacle(space_, middle, 0)) return false;
  }
  if (half_reach <= kMargin - kSure) {
    const bool exact = motion.turn == 0 || !rows_.convex();
    return exact && fits_along(space_, segment_of(from, motion));
  }
  decided = false;
  return true;
}

}  // namespace wend
