#include "conformance/answer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>

namespace wend::test {
namespace {

class CountingObserver final : public SearchObserver {
 public:
  void on_generate(const SearchEvent&) override { ++generated; }
  void on_expand(const SearchEvent&) override { ++expanded; }
  void on_relax(const SearchEvent& event) override { orphans += event.parent ? 0 : 1; }

  std::uint64_t generated = 0;
  std::uint64_t expanded = 0;
  std::uint64_t orphans = 0;  // relaxed from nowhere
};

std::string stepped_fault(Planner& planner, const PlannerInfo& info, const Query& query,
                          const Answer& answer) {
  // A planner that never ends a stepped search must not keep the suite. One that begins again with a wider
  // type of costs takes the steps of both searches.
  constexpr std::uint64_t kSlack = 1000;
  const std::uint64_t most = 4 * answer.plan.metrics.expanded + kSlack;
  Answer stepped;
  auto outcome = planner.begin(query, stepped.plan);
  if (!info.capabilities.can_step) {
    return outcome && *outcome != Status::found ? "" : "it cannot be stepped, but began a search";
  }
  for (std::uint64_t steps = 0; !outcome; ++steps) {
    if (steps > most) return fmt::format("stepped: no outcome after {} steps", steps);
    outcome = planner.step(stepped.plan);
  }
  stepped.status = *outcome;
  return same_answers(info, answer, stepped) ? "" : "stepped: " + text_of(stepped);
}

}  // namespace

std::string text_of(const Answer& answer) {
  const SearchMetrics& metrics = answer.plan.metrics;
  return fmt::format("{}, path of {}, cost {}, bound {}, expanded {}, generated {}, frontier {}",
                     to_string(answer.status), answer.plan.path.size(), answer.plan.cost,
                     answer.plan.bound, metrics.expanded, metrics.generated, metrics.max_frontier);
}

std::ostream& operator<<(std::ostream& out, const Answer& answer) { return out << text_of(answer); }

Answer answer_of(Planner& planner, const Query& query) {
  Answer answer;
  answer.status = planner.plan(query, answer.plan);
  return answer;
}

bool same_answers(const PlannerInfo& info, const Answer& one, Answer other) {
  if (info.capabilities.resumes) {
    return one.status == other.status && one.plan.bound == other.plan.bound &&
           one.plan.path.empty() == other.plan.path.empty() &&
           (one.plan.cost == other.plan.cost ||
            std::abs(one.plan.cost - other.plan.cost) <= kRelativeOfCosts * one.plan.cost);
  }
  if (info.capabilities.learns) other.plan.metrics = one.plan.metrics;
  return one == other;
}

std::string stepping_fault(Planner& planner, const PlannerInfo& info, Query query,
                           const Answer& answer) {
  if (auto fault = stepped_fault(planner, info, query, answer); !fault.empty()) return fault;
  CountingObserver counts;
  query.observer = &counts;
  const Answer watched = answer_of(planner, query);
  if (!same_answers(info, answer, watched)) return "watched: " + text_of(watched);
  if (counts.orphans > 0) return fmt::format("{} relaxed states have no parent", counts.orphans);
  if (info.preprocessing != Preprocessing::none) return {};
  const SearchMetrics& metrics = watched.plan.metrics;
  if (counts.generated == metrics.generated && counts.expanded == metrics.expanded) return {};
  return fmt::format("the observer saw {} generated and {} expanded states", counts.generated,
                     counts.expanded);
}

}  // namespace wend::test
