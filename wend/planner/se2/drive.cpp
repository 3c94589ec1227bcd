#include "wend/planner/se2/drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace wend {
namespace {

/// Connections lead over so many knots.
constexpr std::array<std::size_t, 6> kHops{2, 3, 5, 8, 13, 20};
constexpr double kStraightEnough = 0.98;  // of the cost: a connection gains nothing there
constexpr double kLeastGain = 1e-6;       // cells

/// The cost of a motion behind another one with that gear; sets the gear to its own.
double cost_behind(int& gear, const Motion& motion, double way, const Steering& steering) {
  const int next = gear_of(motion);
  double cost = steering.cost(motion, way);
  if (gear * next < 0) cost += steering.costs().gear_change;
  if (next != 0) gear = next;
  return cost;
}

}  // namespace

double cost_of(const DrivenMotions& drive, const MotionCheck& check, const Steering& steering) {
  int gear = 0;
  double cost = 0;
  for (const DrivenMotion& driven : drive) {
    cost +=
        cost_behind(gear, driven.motion, check.cost_of_way(driven.from, driven.motion), steering);
  }
  return cost;
}

void join(DrivenMotions& drive) {
  constexpr double kSame = 1e-9;
  std::size_t count = 0;
  for (const DrivenMotion next : drive) {
    if (count > 0) {
      Motion& last = drive[count - 1].motion;
      const Motion& motion = next.motion;
      const bool same = last.course == motion.course && gear_of(last) == gear_of(motion) &&
                        std::abs(last.turn * motion.length - motion.turn * last.length) < kSame &&
                        last.turn * motion.turn >= 0;
      if (same) {
        last.length += motion.length;
        last.turn += motion.turn;
        continue;
      }
    }
    drive[count++] = next;
  }
  drive.resize(count);
}

/// Cuts a drive at its changes of motion and into pieces of at most the spacing.
void DriveShortener::cut(const DrivenMotions& drive) {
  pieces_.clear();
  for (const DrivenMotion& driven : drive) {
    const double length = std::abs(driven.motion.length);
    constexpr double kMostPieces = 1e4;  // for absurdly small spacings
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::min(length / spacing_, kMostPieces))));
    for (int i = 0; i < count; ++i) {
      const Motion before = part_of(driven.motion, static_cast<double>(i) / count);
      pieces_.push_back({pose_after(driven.from, before), part_of(driven.motion, 1.0 / count)});
    }
  }
}

bool DriveShortener::is_worth(std::size_t from, std::size_t to, double cost) const {
  return knots_[from].cost + cost < knots_[to].cost - kLeastGain;
}

/// Offers the way along the drive from a knot to the next one.
void DriveShortener::go_along(std::size_t from) {
  const DrivenMotion& piece = pieces_[from];
  int gear = knots_[from].gear;
  const double way = check_.cost_of_way(piece.from, piece.motion);
  const double cost = cost_behind(gear, piece.motion, way, steering_);
  if (!is_worth(from, from + 1, cost)) return;
  knots_[from + 1] = {knots_[from + 1].pose, knots_[from].cost + cost, gear, from, {piece}, 1};
}

/// Tries the cheapest connection between two knots.
void DriveShortener::connect(std::size_t from, std::size_t to) {
  const double bound = knots_[to].cost - knots_[from].cost;
  Pose pose = knots_[from].pose;
  const double straight = straight_distance(pose.point(), knots_[to].pose.point());
  if (straight >= kStraightEnough * bound) return;
  std::array<Connection, 1> best;
  int gear = knots_[from].gear;
  if (steering_.connect(pose, knots_[to].pose, gear, bound, best) == 0) return;
  Knot knot{knots_[to].pose, 0, 0, from, {}, 0};
  double cost = 0;
  for (const Motion& motion : best[0].all()) {
    const double way = check_.cost(pose, motion);
    if (way == MotionCheck::kBlocked) return;
    cost += cost_behind(gear, motion, way, steering_);
    knot.way[knot.way_size++] = {pose, motion};
    pose = pose_after(pose, motion);
  }
  if (!is_worth(from, to, cost)) return;
  knot.cost = knots_[from].cost + cost;
  knot.gear = gear;
  knots_[to] = knot;
}

/// A knot keeps one way, whose gear may cost a change behind it, and a motion in pieces samples the ground at other
/// places than the whole: so costs are compared at the end.
void DriveShortener::shorten(DrivenMotions& drive) {
  if (drive.empty()) return;
  before_ = drive;
  cut(drive);
  take_cheapest(drive);
  join(drive);
  if (cost_of(drive, check_, steering_) > cost_of(before_, check_, steering_)) drive = before_;
}

void DriveShortener::take_cheapest(DrivenMotions& drive) {
  knots_.clear();
  for (const DrivenMotion& piece : pieces_) knots_.push_back({piece.from});
  knots_.push_back({pose_after(pieces_.back().from, pieces_.back().motion)});
  knots_[0].cost = 0;
  // All ways along the drive first: they bound what a connection may cost.
  for (std::size_t i = 0; i < pieces_.size(); ++i) go_along(i);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    // What was gained before this knot is gained behind it, too.
    if (i > 0) go_along(i - 1);
    for (const std::size_t hops : kHops) {
      if (i + hops < knots_.size()) connect(i, i + hops);
    }
  }
  go_along(pieces_.size() - 1);
  drive.clear();
  for (std::size_t i = knots_.size() - 1; i > 0; i = knots_[i].before) {
    for (std::size_t k = knots_[i].way_size; k > 0; --k) drive.push_back(knots_[i].way[k - 1]);
  }
  std::ranges::reverse(drive);
}

}  // namespace wend
