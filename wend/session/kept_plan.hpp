#pragma once

// KeptPlan: the path that replan() answered last, for the next time: a robot that replans should not turn back and forth
// between paths that cost nearly the same.

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "wend/base/mutex.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/path/path.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planners.hpp"

namespace wend {

/// What a path is for. It is kept for the same only.
struct Errand {
  PlannerSpec planner;  // as asked for
  std::vector<Goal> goals;
  Frame frame;  // of the map

  friend bool operator==(const Errand& a, const Errand& b) {
    return a.planner.name == b.planner.name && a.planner.options == b.planner.options &&
           a.goals == b.goals && a.frame == b.frame;
  }
};

/// A path that was answered.
struct AnsweredPath {
  Errand errand;
  std::shared_ptr<const Path> found;     // by the planner, from where the robot was then
  std::shared_ptr<const Path> answered;  // the same, refined
  SnappingError goal_snapping_error;
  std::size_t passed = 0;  // of `found`: behind the robot
};

/// All threads may call everything.
class KeptPlan {
 public:
  /// What is left of the kept path, and how far the robot has come. Nothing if there is none for this errand, if it is
  /// not free any more, or if the robot is farther than farthest_from_path() from what was answered.
  struct Rest {
    Plan plan;
    AnsweredPath of;
  };
  std::optional<Rest> rest(const Errand& errand, const Planner& planner, const Query& query) const;

  void keep(AnsweredPath path);

 private:
  mutable Mutex mutex_;  // guards the path
  std::optional<AnsweredPath> path_;
};

/// Is the rest of a path answered again, although the search ended like this with this plan? It is unless the plan is
/// cheaper by more than the share `keep` of what the rest costs. Sets the bound of the rest.
bool is_kept(Plan& rest, Status status, const Plan& found, double keep);

}  // namespace wend
