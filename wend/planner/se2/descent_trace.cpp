#include "wend/planner/se2/descent_trace.hpp"

#include <algorithm>
#include <limits>

#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();
constexpr double kTight = 2;  // room beside the robot, in cells
constexpr int kAside = 4;     // cells that a pose in a narrow place is moved by
constexpr int kTurns = 6;     // times 10 degrees that it is turned by

}  // namespace

double DescentTrace::follow(Point from) {
  constexpr std::size_t kMostPoints = 48;
  points_.clear();
  Point point = from;
  double cost = field_.at(point).cost;
  while (points_.size() < kMostPoints && cost > step_) {
    const Point way = field_.descent(point);
    const Point next{point.x + step_ * way.x, point.y + step_ * way.y};
    if (!check_.free_space().contains(cell_at(next))) break;
    field_.settle(next);
    const CoarseCostField::Value there = field_.at(next);
    if (!there.exact || !(there.cost < cost)) break;
    point = next;
    cost = there.cost;
    points_.push_back({point, check_.room_at(point)});
  }
  return cost;
}

bool DescentTrace::is_narrow_at(std::size_t i) const {
  if (i == 0 || i + 1 >= points_.size()) return false;
  const double room = points_[i].room;
  return room < kTight && room <= points_[i - 1].room && room < points_[i + 1].room;
}

Pose DescentTrace::pose(std::size_t i) const {
  const Point before = points_[i > 0 ? i - 1 : 0].point;
  const Point after = points_[std::min(i + 1, points_.size() - 1)].point;
  const Point at = points_[i].point;
  const Pose pose{at.x, at.y, arc_tangent(after.y - before.y, after.x - before.x)};
  return points_[i].room < kTight ? centred(pose) : pose;
}

double DescentTrace::room_at(Point point) const {
  return check_.free_space().contains(cell_at(point)) ? check_.room_at(point) : kNone;
}

Pose DescentTrace::centred(const Pose& pose) const {
  const auto [sine, cosine] = sine_and_cosine(pose.heading);
  Pose best = pose;
  double most = room_at(pose.point());
  for (int i = -kAside; i <= kAside; ++i) {
    const Point point = centre_of(cell_at({pose.x - i * sine, pose.y + i * cosine}));
    const double room = room_at(point);
    if (room > most) {
      most = room;
      best.x = point.x;
      best.y = point.y;
    }
  }
  best.heading = wrapped_angle(heading_with_most_room(best));
  return best;
}

/// Tries headings to both sides of that of the pose, the nearest first.
double DescentTrace::heading_with_most_room(const Pose& pose) const {
  constexpr double kMore = 1e-6;  // cells
  double heading = pose.heading;
  double most = kNone;
  for (int i = -kTurns; i <= kTurns; ++i) {
    const double turned = pose.heading + (i % 2 == 0 ? i / 2 : -(i + 1) / 2) * kPi / 18;
    const auto [sine, cosine] = sine_and_cosine(turned);
    double room = -kNone;
    for (const double way : {-4.0, -2.0, 2.0, 4.0}) {
      room = std::min(room, room_at({pose.x + way * cosine, pose.y + way * sine}));
    }
    if (room > most + kMore) {
      most = room;
      heading = turned;
    }
  }
  return heading;
}

}  // namespace wend
