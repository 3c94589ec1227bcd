#include "wend/planner/se2/goal_flood.hpp"

namespace wend {

void GoalFlood::begin(std::span<const HybridGoal> goals) {
  seen_.clear();
  poses_.clear();
  next_ = 0;
  constexpr int kHeadings = 36;  // of a goal that may be reached with any
  for (const HybridGoal& goal : goals) {
    Pose pose = goal.pose;
    const int count = goal.any_heading ? kHeadings : 1;
    for (int i = 0; i < count; ++i) {
      pose.heading = wrapped_angle(goal.pose.heading + 2 * kPi * i / count);
      add(pose);
    }
  }
}

void GoalFlood::add(const Pose& pose) {
  std::uint32_t& seen = seen_[pose];
  if (seen != PoseTable::kNone) return;
  seen = static_cast<std::uint32_t>(poses_.size());
  poses_.push_back(pose);
}

bool GoalFlood::run(std::uint64_t most) {
  for (std::uint64_t i = 0; i < most && next_ < poses_.size(); ++i) {
    const Pose pose = poses_[next_++];
    for (const Motion& primitive : steering_.primitives()) {
      const Motion ahead = steering_.scaled(primitive, step_);
      const Motion back{-ahead.length, -ahead.turn, ahead.course};
      if (check_.fits(pose, back)) add(pose_after(pose, back));
    }
  }
  return next_ == poses_.size();
}

}  // namespace wend
