#pragma once

// Everything about an answer of a planner, and what must not change it.

#include <ostream>
#include <string>

#include "wend/planner/observer.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planner_info.hpp"

namespace wend::test {

struct Answer {
  Status status = Status::found;
  Plan plan;

  friend bool operator==(const Answer& a, const Answer& b) {
    return a.status == b.status && a.plan.path == b.plan.path && a.plan.moves == b.plan.moves &&
           a.plan.cost == b.plan.cost && a.plan.bound == b.plan.bound &&
           a.plan.start_snapping_error == b.plan.start_snapping_error &&
           a.plan.goal_snapping_error == b.plan.goal_snapping_error &&
           a.plan.metrics == b.plan.metrics;
  }
  friend std::ostream& operator<<(std::ostream& out, const Answer& answer);
};

/// "found, path of 4, cost 3, bound 1, expanded 9, generated 20, frontier 11"
std::string text_of(const Answer& answer);

Answer answer_of(Planner& planner, const Query& query);

/// How much dearer than the optimum a path may be that is cheapest in whole numbers on cells with costs.
inline constexpr double kRelativeOfCosts = 1.6e-6;

/// Are they equal, with all metrics? Those of a planner that learns (Capabilities) may differ; of one that
/// resumes, the path too, which then costs the same.
bool same_answers(const PlannerInfo& info, const Answer& one, Answer other);

/// Asks again, one expansion at a time and with an observer: what differs from `answer`, or an empty
/// text. A planner that looks answers up in an index has nothing to show.
std::string stepping_fault(Planner& planner, const PlannerInfo& info, Query query,
                           const Answer& answer);

}  // namespace wend::test
