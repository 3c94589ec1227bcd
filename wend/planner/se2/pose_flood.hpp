#pragma once

// PoseFlood: from how many poses can a robot drive to a goal at all, or to how many from its start? It drives the motions
// of a search from there on, in any order, until no new pose is left. Where it ends, it looks again, more closely:
// where the robot has hardly any room, longer motions end at once.

#include <cstdint>
#include <span>
#include <vector>

#include "wend/planner/se2/hybrid_goal.hpp"
#include "wend/planner/se2/hybrid_resolution.hpp"
#include "wend/planner/se2/pose_table.hpp"
#include "wend/space/se2/motion_check.hpp"
#include "wend/space/se2/steering.hpp"

namespace wend {

class PoseFlood {
 public:
  /// To the first poses, or away from them?
  enum class Direction { to_goal, from_start };

  /// Check and steering must outlive the flood.
  PoseFlood(const MotionCheck& check, const Steering& steering, const HybridResolution& resolution,
            Direction direction);

  void begin(std::span<const HybridGoal> goals);
  void begin(const Pose& start);

  /// Expands at most `most` poses. True once no pose is left, however closely it looks.
  bool run(std::uint64_t most);

  /// Has it ended?
  bool has_ended() const { return closer_ && next_ == poses_.size(); }
  /// Has it ended after few poses?
  bool is_small() const { return small_ && has_ended(); }
  /// How many poses it has reached, looking as closely as it does now.
  std::size_t size() const { return poses_.size(); }

 private:
  void begin_at(const HybridResolution& resolution);
  void add(const Pose& pose);
  void expand(Pose pose);

  const MotionCheck& check_;
  const Steering& steering_;
  HybridResolution first_;
  Direction direction_;
  HybridResolution resolution_;
  PoseTable seen_;
  std::vector<Pose> origins_;
  std::vector<Pose> poses_;
  std::size_t next_ = 0;
  bool small_ = false;
  bool closer_ = false;
};

}  // namespace wend
