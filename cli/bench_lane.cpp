#include "bench_lane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "interrupt.hpp"
#include "limit_arguments.hpp"
#include "wend/report/scenario_verdict.hpp"

namespace wend::cli {
namespace {

constexpr double kQuick = 100e-6;  // seconds; a check takes some millionths

}  // namespace

BenchLane::BenchLane(std::unique_ptr<Planner> planner, Complain complain)
    : planner_(std::move(planner)), complain_(std::move(complain)) {}

void BenchLane::warm_up(const ScenarioQuery& query) { ask(query); }

bool BenchLane::time(const ScenarioQuery& query, BenchAnswer& answer) {
  if (!ask(query)) return false;
  answer.seconds.push_back(seconds_);
  if (answer.seconds.size() > 1) {
    compare(query, answer);
  } else if (seconds_ < kQuick) {
    unsettled_.push_back({&query, &answer});
  } else {
    settle(query, answer);
  }
  return true;
}

bool BenchLane::settle() {
  bool cancelled = false;
  for (const Unsettled& each : unsettled_) {
    cancelled = cancelled || !ask(*each.query);
    if (cancelled) {
      each.answer->seconds.clear();
    } else {
      settle(*each.query, *each.answer);
    }
  }
  unsettled_.clear();
  return !cancelled;
}

bool BenchLane::ask(const ScenarioQuery& query) {
  Query asked = Query::between(query.start, query.goal);
  asked.limits.cancel = &Interruptible::cancelled();
  const double begin = steady_seconds();
  status_ = planner_->plan(asked, plan_);
  seconds_ = steady_seconds() - begin;
  return !Interruptible::cancelled();
}

void BenchLane::settle(const ScenarioQuery& query, BenchAnswer& answer) {
  answer.status = status_;
  answer.length = plan_.path.length();
  answer.expanded = plan_.metrics.expanded;
  std::string wrong = wrong_answer(query, status_, plan_);
  if (wrong.empty() && status_ == Status::found) {
    wrong = wrong_path(planner_->free_space(), query, plan_.path);
  }
  judge(query, answer, wrong);
}

void BenchLane::compare(const ScenarioQuery& query, BenchAnswer& answer) {
  constexpr double kRounding = 1e-9;
  const bool same_length = !answer.found() || std::abs(plan_.cost - answer.length) <=
                                                  kRounding * std::max(1.0, answer.length);
  if (status_ == answer.status && same_length) return;
  judge(query, answer,
        fmt::format("another answer in pass {} than before ({}, cost {:.8f})",
                    answer.seconds.size(), describe(status_), plan_.cost));
}

void BenchLane::judge(const ScenarioQuery& query, BenchAnswer& answer, const std::string& wrong) {
  if (wrong.empty() || answer.wrong) return;
  answer.wrong = true;
  complain_(query, wrong);
}

}  // namespace wend::cli
