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

/// A pose of a drive, and the cheapest way to it that is known.
struct Knot {
  Pose pose;
  double cost = std::numeric_limits<double>::infinity();
  int gear = 0;            // before the pose
  std::size_t before = 0;  // the knot that the way comes from
  Drive way = {};          // from there
};

/// The cost of a motion behind another one with that gear; sets the gear to its own.
double cost_behind(int& gear, const Motion& motion, double way, const Steering& steering) {
  const int next = gear_of(motion);
  double cost = steering.cost(motion, way);
  if (gear * next < 0) cost += steering.costs().gear_change;
  if (next != 0) gear = next;
  return cost;
}

/// Cuts a drive at its changes of motion and into pieces of at most `spacing`.
Drive cut(const Drive& drive, double spacing) {
  Drive pieces;
  for (const DrivenMotion& driven : drive) {
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::abs(driven.motion.length) / spacing)));
    const Motion piece = part_of(driven.motion, 1.0 / count);
    for (int i = 0; i < count; ++i) {
      const Motion before = part_of(driven.motion, static_cast<double>(i) / count);
      pieces.push_back({pose_after(driven.from, before), piece});
    }
  }
  return pieces;
}

/// Offers a way from one knot to another.
void offer(const std::vector<Knot>& knots, std::size_t from, Knot& to, double cost, int gear,
           Drive way) {
  if (knots[from].cost + cost >= to.cost - kLeastGain) return;
  to.cost = knots[from].cost + cost;
  to.gear = gear;
  to.before = from;
  to.way = std::move(way);
}

/// Tries the cheapest connection between two knots.
void connect(std::vector<Knot>& knots, std::size_t from, std::size_t to, const MotionCheck& check,
             const Steering& steering) {
  const double bound = knots[to].cost - knots[from].cost;
  const Pose& start = knots[from].pose;
  if (straight_distance(start.point(), knots[to].pose.point()) >= kStraightEnough * bound) return;
  std::array<Connection, 1> best;
  if (steering.connect(start, knots[to].pose, knots[from].gear, bound, best) == 0) return;
  Drive way;
  Pose pose = start;
  int gear = knots[from].gear;
  double cost = 0;
  for (const Motion& motion : best[0].all()) {
    const double length = check.cost(pose, motion);
    if (length == MotionCheck::kBlocked) return;
    cost += cost_behind(gear, motion, length, steering);
    way.push_back({pose, motion});
    pose = pose_after(pose, motion);
  }
  offer(knots, from, knots[to], cost, gear, std::move(way));
}

}  // namespace

double cost_of(const Drive& drive, const MotionCheck& check, const Steering& steering) {
  int gear = 0;
  double cost = 0;
  for (const DrivenMotion& driven : drive) {
    cost +=
        cost_behind(gear, driven.motion, check.cost_of_way(driven.from, driven.motion), steering);
  }
  return cost;
}

Drive joined(const Drive& drive) {
  constexpr double kSame = 1e-9;
  Drive result;
  for (const DrivenMotion& next : drive) {
    if (!result.empty()) {
      Motion& last = result.back().motion;
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
    result.push_back(next);
  }
  return result;
}

Drive shortened(const Drive& drive, const MotionCheck& check, const Steering& steering,
                double spacing) {
  const Drive pieces = cut(drive, spacing);
  if (pieces.empty()) return drive;
  std::vector<Knot> knots;
  for (const DrivenMotion& piece : pieces) knots.push_back({piece.from});
  knots.push_back({pose_after(pieces.back().from, pieces.back().motion)});
  knots[0].cost = 0;
  // All ways along the drive first: they bound what a connection may cost.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    int gear = knots[i].gear;
    const double way = check.cost_of_way(pieces[i].from, pieces[i].motion);
    const double cost = cost_behind(gear, pieces[i].motion, way, steering);
    offer(knots, i, knots[i + 1], cost, gear, {pieces[i]});
  }
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (i > 0) {
      // What was gained before this knot, is gained on the way along the drive, too.
      int gear = knots[i - 1].gear;
      const double way = check.cost_of_way(pieces[i - 1].from, pieces[i - 1].motion);
      const double cost = cost_behind(gear, pieces[i - 1].motion, way, steering);
      offer(knots, i - 1, knots[i], cost, gear, {pieces[i - 1]});
    }
    for (const std::size_t hops : kHops) {
      if (i + hops < knots.size()) connect(knots, i, i + hops, check, steering);
    }
  }
  Drive result;
  for (std::size_t i = knots.size() - 1; i > 0; i = knots[i].before) {
    result.insert(result.begin(), knots[i].way.begin(), knots[i].way.end());
  }
  return result;
}

}  // namespace wend
