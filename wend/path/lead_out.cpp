#include "wend/path/lead_out.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "wend/geometry/segment.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/sweep.hpp"

namespace wend {
namespace {

constexpr double kLookStep = 0.05;  // cells, between two looks at the overlap
constexpr double kGrowth = 1e-3;    // of the overlap, that is not one: planners look elsewhere

/// The looks at a segment, the last one at its end. A turn moves the robot's farthest point.
int looks_along(const Segment& segment, double radius) {
  const double farthest = std::abs(segment.length) + radius * std::abs(segment.turn);
  return std::max(1, static_cast<int>(std::ceil(std::min(farthest / kLookStep, 1e6))));
}

/// What remains of a path behind a share of one of its pieces.
Path rest_of(const Path& path, std::size_t piece, double share) {
  if (path.driven()) {
    const JoinedPoses drive(path.driven_poses());
    std::vector<Pose> poses(path.driven_poses().begin() + static_cast<std::ptrdiff_t>(piece) + 1,
                            path.driven_poses().end());
    if (share < 1) poses.insert(poses.begin(), pose_on(drive.segment(piece), share));
    return Path::through(std::move(poses));
  }
  const std::vector<Point> points = path.points();
  std::vector<Point> rest(points.begin() + static_cast<std::ptrdiff_t>(piece) + 1, points.end());
  if (share < 1) {
    rest.insert(rest.begin(), Line{points[piece], points[piece + 1]}.at(share));
  }
  return Path::along(std::move(rest));
}

/// A place on a path.
struct OnPath {
  std::size_t piece = 0;  // index in Path::segments()
  double share = 0;       // of that piece
  double along = 0;       // cells, from the start
  Pose pose;
};

/// Follows a path out of what blocks its start.
class LeadWalk {
 public:
  LeadWalk(const Path& path, const FreeSpace& space, double most, bool as_disc)
      : space_(space),
        pieces_(path.segments()),
        turns_(space.outline() != nullptr && !path.driven() && !as_disc),
        radius_(space.radius_in_cells()),
        most_(most),
        measure_(space, as_disc),
        least_(measure_.at(path.poses().front())) {
    at_.pose = path.poses().front();
  }

  /// Walks on to the next look at which the robot fits. False if the overlap grows, the lead is too long, or the path
  /// ends.
  bool to_free() {
    while (step()) {
      if (turns_ && look_ == 1 && !turn_to_piece()) return false;
      const Overlap here = measure_.at(at_.pose);
      if (here.exceeds(least_, kGrowth)) return false;
      least_ = here.least(least_);
      if (here.none()) return true;
    }
    ended_ = at_.piece >= pieces_.size();
    return false;
  }

  const OnPath& at() const { return at_; }
  bool ended() const { return ended_; }
  bool overlaps() const { return !least_.none(); }

 private:
  bool step() {
    if (at_.piece < pieces_.size() && look_ == looks_along(pieces_[at_.piece], radius_)) {
      ++at_.piece;
      look_ = 0;
    }
    if (at_.piece >= pieces_.size()) return false;
    const Segment& piece = pieces_[at_.piece];
    const int looks = looks_along(piece, radius_);
    const double before = at_.along;
    ++look_;
    at_.share = static_cast<double>(look_) / looks;
    at_.along = before + std::abs(piece.length) / looks;
    at_.pose = pose_on(piece, at_.share);
    return at_.along <= most_ + 1e-6;
  }

  /// A polygon turns in place from line to line.
  bool turn_to_piece() {
    if (at_.piece == 0) return true;
    const Pose before = end_of(pieces_[at_.piece - 1]);
    const TurnInPlace turn =
        turn_between(space_, before.point(), before.heading, pieces_[at_.piece].from.heading);
    const Segment motion(turn.from, 0, turn.angle, 0);
    const int looks = looks_along(motion, radius_);
    for (int i = 1; i <= looks; ++i) {
      const Overlap here = measure_.at(pose_on(motion, static_cast<double>(i) / looks));
      if (here.exceeds(least_, kGrowth)) return false;
      least_ = here.least(least_);
    }
    return true;
  }

  const FreeSpace& space_;
  std::vector<Segment> pieces_;
  bool turns_;  // a polygon, along lines
  double radius_;
  double most_;
  OverlapMeasure measure_;
  Overlap least_;
  OnPath at_;
  int look_ = 0;
  bool ended_ = false;
};

PathCollision collision_at(const OnPath& at, const FreeSpace& space) {
  PathCollision collision;
  collision.kind = space.outline()    ? CollisionKind::overlaps
                   : space.is_point() ? CollisionKind::obstacle
                                      : CollisionKind::too_close;
  collision.piece = at.piece;
  collision.along = at.along;
  collision.point = at.pose.point();
  const Cell cell = nearest_cell(space, collision.point);
  if (space.obstacles().blocked()[cell]) {
    collision.kind = CollisionKind::obstacle;
    collision.obstacle = cell;
  }
  return collision;
}

/// Behind the first free place a turning polygon may be said to touch (fits_along.hpp): then the lead goes on.
LedPath led_along(const Path& path, const FreeSpace& space, double most, Adjacency adjacency,
                  bool as_disc) {
  LeadWalk walk(path, space, most, as_disc);
  std::optional<PathCollision> behind;
  while (walk.to_free()) {
    const OnPath& at = walk.at();
    behind = first_collision(rest_of(path, at.piece, at.share), space, adjacency);
    if (!behind) return {std::nullopt, at.along, true};
    const bool touches = behind->along <= 2 * kLookStep;
    behind->piece += at.piece;
    behind->along += at.along;
    if (!touches) return {behind, at.along, true};
  }
  if (behind) return {behind, behind->along, true};
  if (walk.ended()) return {std::nullopt, walk.at().along, !walk.overlaps()};
  return {collision_at(walk.at(), space), walk.at().along, false};
}

/// Some joints of a path, in order.
Path part_of(const Path& path, std::size_t first, std::size_t count) {
  const auto some = [&](auto joints) {
    const auto part = joints.subspan(first, count);
    return std::vector(part.begin(), part.end());
  };
  return path.visit([&](std::span<const Cell> cells) { return Path(some(cells)); },
                    [&](std::span<const Point> waypoints) {
                      return path.leads_over_cells() ? Path::over_cells(some(waypoints))
                                                     : Path::along(some(waypoints));
                    },
                    [&](const JoinedPoses& drive) { return Path::through(some(drive.poses())); });
}

}  // namespace

Path joined(const Path& lead, const Path& rest) {
  const auto before_last = [](auto items) { return items.first(items.size() - 1); };
  return rest.visit(
      [&](std::span<const Cell> cells) {
        const auto first = before_last(lead.cells());
        std::vector<Cell> all(first.begin(), first.end());
        all.insert(all.end(), cells.begin(), cells.end());
        return Path(std::move(all));
      },
      [&](std::span<const Point> waypoints) {
        std::vector<Point> all = lead.points();
        all.pop_back();
        all.insert(all.end(), waypoints.begin(), waypoints.end());
        const bool over_cells = lead.leads_over_cells() && rest.leads_over_cells();
        return over_cells ? Path::over_cells(std::move(all)) : Path::along(std::move(all));
      },
      [&](const JoinedPoses& drive) {
        std::vector<Pose> all = lead.poses();
        all.pop_back();
        all.insert(all.end(), drive.poses().begin(), drive.poses().end());
        return Path::through(std::move(all));
      });
}

Path lead_of(const Path& path, std::size_t points) { return part_of(path, 0, points + 1); }

Path behind_lead(const Path& path, std::size_t points) {
  return part_of(path, points, path.size() - points);
}

LedPath check_with_lead(const Path& path, const FreeSpace& space, double most,
                        Adjacency adjacency) {
  assert(!path.empty());
  const auto collision = first_collision(path, space, adjacency);
  const bool starts_free = !collision || collision->along > 0 || most <= 0;
  if (starts_free) return {collision, 0, true};
  LedPath led = led_along(path, space, most, adjacency, false);
  if (!led.collision || path.driven() || space.outline() == nullptr) return led;
  return led_along(path, space, most, adjacency, true);
}

DepthWatch::DepthWatch(const FreeSpace& space, const Pose& start, double rounding)
    : measure_(space),
      radius_(space.radius_in_cells()),
      rounding_(rounding),
      least_(measure_.at(start)) {}

bool DepthWatch::go_along(const Segment& segment) {
  const int looks = looks_along(segment, radius_);
  for (int i = 1; i <= looks; ++i) {
    const Overlap here = measure_.at(pose_on(segment, static_cast<double>(i) / looks));
    if (here.exceeds(least_, rounding_)) return false;
    least_ = here.least(least_);
  }
  return true;
}

}  // namespace wend
