#pragma once

// GoalFlood: from how many poses can a robot drive to a goal at all? It drives the motions of a search backwards from
// the goal, in any order, until nothing new is left: then the goal is boxed in, unless a start lies inside.

#include <cstdint>
#include <span>
#include <vector>

#include "wend/planner/se2/hybrid_goal.hpp"
#include "wend/planner/se2/hybrid_resolution.hpp"
#include "wend/planner/se2/pose_table.hpp"
#include "wend/space/se2/motion_check.hpp"
#include "wend/space/se2/steering.hpp"

namespace wend {

class GoalFlood {
 public:
  /// Check and steering must outlive the flood.
  GoalFlood(const MotionCheck& check, const Steering& steering, const HybridResolution& resolution)
      : check_(check),
        steering_(steering),
        step_(resolution.step),
        seen_(resolution.position, resolution.headings) {}

  void begin(std::span<const HybridGoal> goals);

  /// Expands at most `most` poses. True if no pose is left.
  bool run(std::uint64_t most);

  /// The number of poses that were reached.
  std::size_t size() const { return poses_.size(); }

 private:
  void add(const Pose& pose);

  const MotionCheck& check_;
  const Steering& steering_;
  double step_;
  PoseTable seen_;
  std::vector<Pose> poses_;
  std::size_t next_ = 0;
};

}  // namespace wend
