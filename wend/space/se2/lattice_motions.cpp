#include "wend/space/se2/lattice_motions.hpp"

#include <cmath>
#include <utility>

#include "wend/robot/motion_primitives.hpp"

namespace wend {
namespace {

/// A line, an arc, or a turn in place. (segment_between() differs between platforms in the last bits.)
Motion motion_between(const Pose& from, const Pose& to) {
  const double turn = wrapped_angle(to.heading - from.heading);
  const double length = straight_distance(from.point(), to.point()) / chord_share(turn);
  const auto [sine, cosine] = sine_and_cosine(from.heading + turn / 2);
  const bool ahead = (to.x - from.x) * cosine + (to.y - from.y) * sine >= 0;
  return {ahead ? length : -length, turn, 0};
}

/// The step of a primitive, which is in units of the lattice.
LatticeMotions::Step step_of(const MotionPrimitive& primitive) {
  LatticeMotions::Step step;
  for (std::size_t i = 1; i < primitive.poses.size(); ++i) {
    Motion motion = motion_between(primitive.poses[i - 1], primitive.poses[i]);
    motion.length *= LatticeMotions::kSpacing;
    step.motions.push_back(motion);
  }
  step.by = {primitive.by.x * LatticeMotions::kSpacing, primitive.by.y * LatticeMotions::kSpacing};
  step.to = static_cast<std::size_t>(primitive.to);
  return step;
}

bool drives_back(const LatticeMotions::Step& step) {
  for (const Motion& motion : step.motions) {
    if (motion.length < 0) return true;
  }
  return false;
}

/// The step to a neighbour on the lattice, without a turn.
LatticeMotions::Step slide(double heading, std::size_t number, int dx, int dy) {
  const Point by{dx * LatticeMotions::kSpacing, dy * LatticeMotions::kSpacing};
  double length = straight_distance({}, by);
  double course = wrapped_angle(arc_tangent(dy, dx) - heading);
  if (std::abs(course) > kPi / 2) {
    course = wrapped_angle(course - kPi);
    length = -length;
  }
  return {{{length, 0, course}}, by, number};
}

}  // namespace

LatticeMotions::LatticeMotions(const Steering& steering) {
  const bool is_car =
      steering.model() == DriveKind::reeds_shepp || steering.model() == DriveKind::dubins;
  const auto set = MotionPrimitives::turning_circle(is_car ? steering.radius() / kSpacing : 0);
  if (!set) return;
  headings_.assign(set->headings().begin(), set->headings().end());
  for (std::size_t heading = 0; heading < headings_.size(); ++heading) {
    std::vector<Step>& steps = steps_.emplace_back();
    for (const MotionPrimitive& primitive : set->leaving(static_cast<int>(heading))) {
      Step step = step_of(primitive);
      if (steering.model() == DriveKind::dubins && drives_back(step)) continue;
      if (steering.model() == DriveKind::omni && primitive.by != Cell{}) continue;
      steps.push_back(std::move(step));
    }
    if (steering.model() != DriveKind::omni) continue;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        if (dx != 0 || dy != 0) steps.push_back(slide(headings_[heading], heading, dx, dy));
      }
    }
  }
}

std::size_t LatticeMotions::heading_of(const Pose& pose) const {
  const auto count = static_cast<long>(headings_.size());
  const long nearest = std::lround(pose.heading / (2 * kPi) * static_cast<double>(count));
  return static_cast<std::size_t>((nearest % count + count) % count);
}

Pose LatticeMotions::nearest(const Pose& pose) const {
  return {std::round(pose.x / kSpacing) * kSpacing, std::round(pose.y / kSpacing) * kSpacing,
          headings_[heading_of(pose)]};
}

}  // namespace wend
