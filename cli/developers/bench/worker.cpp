#include "cli/developers/bench/worker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/interrupt.hpp"
#include "wend/base/thread_time.hpp"

namespace wend::cli {
namespace {

const Clock& cpu_clock() {
  static const Clock clock = thread_cpu_seconds;
  return clock;
}

}  // namespace

BenchWorker::BenchWorker(const FreeSpace& space, Make make, WorkerRules rules, Complain complain)
    : space_(space), make_(std::move(make)), rules_(rules), complain_(std::move(complain)) {}

void BenchWorker::keep(std::unique_ptr<Planner> planner, const ScenarioQuery& query) {
  planner_ = std::move(planner);
  planner_->plan(asked(query), plan_);
}

bool BenchWorker::time_first(const ScenarioQuery& query, BenchAnswer& answer) {
  const Query first_query = asked(query);
  PlannerResult made;
  Plan plan;
  Status status = Status::memory_limit;
  FirstQuery first;
  first.prepare_s = seconds_of(cpu_clock(), [&] { made = make_(); });
  if (made) {
    first.seconds = seconds_of(cpu_clock(), [&] { status = (*made)->plan(first_query, plan); });
    watch(**made, first_query, answer);
  } else {
    status = made.error().status;
  }
  if (Interruptible::cancelled()) return false;
  take(query, answer, status, plan);
  answer.first = first;
  return true;
}

bool BenchWorker::time_later(const ScenarioQuery& query, BenchAnswer& answer) {
  const Query later_query = asked(query);
  Status status = Status::found;
  const double seconds =
      least_seconds(cpu_clock(), [&] { status = planner_->plan(later_query, plan_); });
  watch(*planner_, later_query, answer);
  if (Interruptible::cancelled()) return false;
  take(query, answer, status, plan_);
  answer.seconds.push_back(seconds);
  return true;
}

bool BenchWorker::time_fresh(const ScenarioQuery& query, BenchAnswer& answer) {
  if (!time_first(query, answer) || !answer.first) return false;
  answer.seconds.push_back(answer.first->seconds);
  return true;
}

Query BenchWorker::asked(const ScenarioQuery& query) const {
  Query asked = Query::between(query.start, query.goal);
  asked.limits.cancel = &Interruptible::cancelled();
  if (rules_.limit_s > 0) {
    asked.limits.seconds = rules_.limit_s;
    asked.limits.clock = cpu_clock();
  }
  return asked;
}

/// Asks an anytime planner once more, so that noting its paths does not count in the times of other runs.
void BenchWorker::watch(Planner& planner, Query query, BenchAnswer& answer) {
  if (!planner.anytime() || !answer.progress.empty()) return;
  query.on_solution = [&answer, begun = cpu_clock()()](const Plan& plan) {
    answer.progress.push_back({cpu_clock()() - begun, plan.cost});
  };
  Plan plan;
  planner.plan(query, plan);
  if (Interruptible::cancelled()) answer.progress.clear();
}

/// The first answer settles what is right; later ones are the same, unless one ran out of time. Then the paths
/// of an anytime planner differ, and the last one counts.
void BenchWorker::take(const ScenarioQuery& query, BenchAnswer& answer, Status status,
                       const Plan& plan) {
  const bool known = answer.first.has_value() || !answer.seconds.empty();
  const bool may_differ = rules_.limit_s > 0 && !answer.progress.empty();
  if (!known || may_differ || answer.status == Status::time_limit) {
    settle(query, answer, status, plan);
  } else if (status != Status::time_limit) {
    compare(query, answer, status, plan);
  }
  answer.expanded = plan.metrics.expanded;
}

void BenchWorker::settle(const ScenarioQuery& query, BenchAnswer& answer, Status status,
                         const Plan& plan) {
  answer.status = status;
  answer.length = status == Status::found ? plan.cost : 0;
  judge(query, answer, wrong_answer(space_, rules_.moves, query, status, plan, rules_.path_kind));
}

void BenchWorker::compare(const ScenarioQuery& query, BenchAnswer& answer, Status status,
                          const Plan& plan) {
  constexpr double kRounding = 1e-9;
  const bool same_length = !answer.found() || std::abs(plan.cost - answer.length) <=
                                                  kRounding * std::max(1.0, answer.length);
  if (status == answer.status && same_length) return;
  judge(query, answer,
        fmt::format("the answer differs from an earlier repetition ({}, cost {:.8f})",
                    describe(status), plan.cost));
}

void BenchWorker::judge(const ScenarioQuery& query, BenchAnswer& answer, const std::string& wrong) {
  if (wrong.empty() || answer.wrong) return;
  answer.wrong = true;
  complain_(query, wrong);
}

}  // namespace wend::cli
