#include "wend/planner/se2/pose_flood.hpp"

namespace wend {
namespace {

constexpr int kHeadingsOfAny = 36;       // of a goal that may be reached with any
constexpr std::size_t kFewPoses = 1000;  // so few that the motions may have been too long
constexpr int kCloser = 2;               // how much finer the second look is
constexpr int kMuchCloser = 4;           // the same after few poses

}  // namespace

PoseFlood::PoseFlood(const MotionCheck& check, const Steering& steering,
                     const HybridResolution& resolution, Direction direction)
    : check_(check),
      steering_(steering),
      first_(resolution),
      direction_(direction),
      resolution_(resolution),
      seen_(resolution.position, resolution.headings) {}

void PoseFlood::begin(std::span<const HybridGoal> goals) {
  origins_.clear();
  for (const HybridGoal& goal : goals) {
    Pose pose = goal.pose;
    const int count = goal.any_heading ? kHeadingsOfAny : 1;
    for (int i = 0; i < count; ++i) {
      pose.heading = wrapped_angle(goal.pose.heading + 2 * kPi * i / count);
      origins_.push_back(pose);
    }
  }
  small_ = closer_ = false;
  begin_at(first_);
}

void PoseFlood::begin(const Pose& start) {
  origins_.assign(1, start);
  small_ = closer_ = false;
  begin_at(first_);
}

void PoseFlood::begin_at(const HybridResolution& resolution) {
  resolution_ = resolution;
  seen_.clear(resolution.position, resolution.headings);
  poses_.clear();
  next_ = 0;
  for (const Pose& pose : origins_) add(pose);
}

void PoseFlood::add(const Pose& pose) {
  std::uint32_t& seen = seen_[pose];
  if (seen != PoseTable::kNone) return;
  seen = static_cast<std::uint32_t>(poses_.size());
  poses_.push_back(pose);
}

void PoseFlood::expand(Pose pose) {
  for (const Motion& primitive : steering_.primitives()) {
    Motion motion = steering_.scaled(primitive, resolution_.step);
    if (direction_ == Direction::to_goal) motion = {-motion.length, -motion.turn, motion.course};
    if (check_.fits(pose, motion)) add(pose_after(pose, motion));
  }
}

bool PoseFlood::run(std::uint64_t most) {
  for (std::uint64_t i = 0; i < most; ++i) {
    if (next_ == poses_.size()) {
      if (closer_) return true;
      closer_ = true;
      small_ = poses_.size() <= kFewPoses;
      begin_at(times_finer(first_, small_ ? kMuchCloser : kCloser));
    }
    expand(poses_[next_++]);
  }
  return false;
}

}  // namespace wend
