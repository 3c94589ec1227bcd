#pragma once

// Everything about an answer of a planner, and what must not change it.

#include <gtest/gtest.h>

#include <ostream>

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
  friend std::ostream& operator<<(std::ostream& out, const Answer& answer) {
    return out << to_string(answer.status) << ", path of " << answer.plan.path.size() << ", cost "
               << answer.plan.cost << ", bound " << answer.plan.bound << ", expanded "
               << answer.plan.metrics.expanded << ", generated " << answer.plan.metrics.generated
               << ", frontier " << answer.plan.metrics.max_frontier;
  }
};

inline Answer answer_of(Planner& planner, const Query& query) {
  Answer answer;
  answer.status = planner.plan(query, answer.plan);
  return answer;
}

class CountingObserver final : public SearchObserver {
 public:
  void on_generate(const SearchEvent&) override { ++generated; }
  void on_expand(const SearchEvent&) override { ++expanded; }
  void on_relax(const SearchEvent& event) override { EXPECT_TRUE(event.parent); }

  std::uint64_t generated = 0;
  std::uint64_t expanded = 0;
};

/// Asks again, one expansion at a time and with an observer. Who looks answers up in an index has
/// nothing to show.
inline void expect_same_when_stepped_and_watched(Planner& planner, const PlannerInfo& info,
                                                 Query query, const Answer& answer) {
  Answer stepped;
  auto outcome = planner.begin(query, stepped.plan);
  if (info.can_step) {
    while (!outcome) outcome = planner.step(stepped.plan);
    stepped.status = *outcome;
    EXPECT_EQ(stepped, answer);
  } else {
    EXPECT_TRUE(outcome.has_value() && *outcome != Status::found);
  }

  CountingObserver counts;
  query.observer = &counts;
  EXPECT_EQ(answer_of(planner, query), answer);
  if (info.preprocessing != Preprocessing::none) return;
  EXPECT_EQ(counts.generated, answer.plan.metrics.generated);
  EXPECT_EQ(counts.expanded, answer.plan.metrics.expanded);
}

}  // namespace wend::test
