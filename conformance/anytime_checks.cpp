// Anytime planners on cells against the reference: every path that they tell, and their answers at limits.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "conformance/answer.hpp"
#include "conformance/checks.hpp"
#include "wend/base/random.hpp"

namespace wend::test {
namespace {

constexpr double kRoundingOfCosts = 1e-9;

struct Told {
  std::vector<Plan> plans;  // in order
  Answer answer;
};

Told told_by(Planner& planner, Query query) {
  Told told;
  query.on_solution = [&](const Plan& plan) { told.plans.push_back(plan); };
  told.answer = answer_of(planner, query);
  return told;
}

/// "cost 8, bound 1.5 after 30 expansions"
std::string text_of(const Plan& plan) {
  return fmt::format("cost {}, bound {} after {} expansions", plan.cost, plan.bound,
                     plan.metrics.expanded);
}

/// A legal path whose bound is true.
void hold_to_its_bound(Examination& examination, const Plan& plan, const Reference& reference,
                       const Cell start, double least, double slack) {
  const auto cells = plan.path.cells();
  if (cells.empty()) return examination.violate("a path of cells", "an empty one");
  const std::string fault = reference.fault(cells, start, cells.back());
  if (!fault.empty()) examination.violate("a legal path", fault);
  const double cost = reference.cost_of(cells);
  const bool true_cost = std::abs(plan.cost - cost) <= kRoundingOfCosts * std::max(1.0, cost);
  if (!true_cost)
    examination.violate(fmt::format("cost {}, that of its path", cost), text_of(plan));
  if (!(plan.bound >= 1) || !(plan.cost <= plan.bound * least * (1 + slack) + kRoundingOfCosts)) {
    examination.violate(fmt::format("at most bound times {}", least), text_of(plan));
  }
}

/// Costs and bounds never rise, the work does not fall, and the last path is the answer.
void hold_to_their_order(Examination& examination, const Told& told) {
  for (std::size_t i = 1; i < told.plans.size(); ++i) {
    const Plan& before = told.plans[i - 1];
    const Plan& plan = told.plans[i];
    if (plan.cost <= before.cost && plan.bound <= before.bound &&
        plan.metrics.expanded >= before.metrics.expanded) {
      continue;
    }
    examination.violate("no more than " + text_of(before), text_of(plan));
  }
  if (told.answer.status != Status::found) {
    if (!told.plans.empty()) examination.violate("no path", text_of(told.plans.back()));
    return;
  }
  if (told.plans.empty() || !(told.plans.back().path == told.answer.plan.path) ||
      told.plans.back().bound != told.answer.plan.bound) {
    examination.violate("the last reported path is the answer: " + text_of(told.answer),
                        told.plans.empty() ? "no path was reported" : text_of(told.plans.back()));
  }
}

/// At a limit: the best path until then, the same each time.
void hold_to_its_limit(Examination& examination, Planner& planner, Query query, const Told& all,
                       std::uint64_t limit) {
  query.limits.expansions = limit;
  examination.ask(query);
  const Told told = told_by(planner, query);
  hold_to_their_order(examination, told);
  const std::uint64_t expanded = told.answer.plan.metrics.expanded;
  if (expanded > limit)
    examination.violate(fmt::format("at most {} expansions", limit), text_of(told.answer));
  if (!(told.answer == told_by(planner, query).answer)) {
    examination.violate(text_of(told.answer), "another answer at the same limit");
  }
  // Paths found before the limit are reported with and without it, and the answer is at least as good.
  for (std::size_t i = 0; i < all.plans.size() && all.plans[i].metrics.expanded <= limit; ++i) {
    const bool same = i < told.plans.size() && told.plans[i].cost == all.plans[i].cost;
    if (!same) examination.violate(text_of(all.plans[i]), text_of(told.answer));
  }
  if (told.answer.status == Status::found || told.answer.status == Status::expansion_limit) return;
  examination.violate("a path or expansion_limit", text_of(told.answer));
}

}  // namespace

void examine_anytime(Examination& examination, std::uint64_t seed) {
  const Trial trial = examination.random_trial(seed);
  examination.on(trial, seed);
  const auto planner = examination.planner_for(trial);
  if (planner == nullptr) return;
  const Reference reference = reference_for(trial, examination.info());
  const double slack =
      planner->free_space().uniform_terrain() ? kRoundingOfCosts : kRelativeOfCosts;
  Random random(seed);
  for (int i = 0; i < 4; ++i) {
    const TestQuery test_query = random_test_query(random, trial.map);
    const Query query = test_query.query();
    examination.ask(query);
    const Told told = told_by(*planner, query);
    hold_to_their_order(examination, told);
    if (told.answer.status != Status::found) continue;
    examination.count_found();
    const double least = truth_of(reference, trial.map, test_query).cost;
    for (const Plan& plan : told.plans) {
      hold_to_its_bound(examination, plan, reference, test_query.start, least, slack);
    }
    if (!told.answer.plan.optimal())
      examination.violate("bound 1 in the end", text_of(told.answer));
    const std::uint64_t needed = told.answer.plan.metrics.expanded;
    const std::uint64_t limit = random.below(needed + 1);
    hold_to_its_limit(examination, *planner, query, told, limit);
    Query limited = query;
    limited.limits.expansions = limit;
    const Answer answer = answer_of(*planner, limited);
    if (answer.status == Status::found) {
      hold_to_its_bound(examination, answer.plan, reference, test_query.start, least, slack);
    }
  }
}

}  // namespace wend::test
