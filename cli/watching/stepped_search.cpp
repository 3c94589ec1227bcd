#include "cli/watching/stepped_search.hpp"

#include <utility>

#include "wend/base/thread_time.hpp"

namespace wend::cli {

SteppedSearch::SteppedSearch(Planner& planner, Query query, SearchRecorder& recorder,
                             SearchObserver& told, Plan& plan)
    : planner_(planner), query_(std::move(query)), recorder_(recorder), plan_(plan), told_(told) {
  observers_.add(recorder_);
  observers_.add(last_);
  observers_.add(told_);
  query_.observer = &observers_;
}

std::optional<Status> SteppedSearch::begin() {
  recorder_.clear();
  last_ = {};
  told_.begin();
  const double begin = thread_cpu_seconds();
  auto outcome = planner_.begin(query_, plan_);
  seconds_ = thread_cpu_seconds() - begin;
  return outcome;
}

std::optional<Status> SteppedSearch::go_on() {
  const double begin = thread_cpu_seconds();
  auto outcome = planner_.step(plan_);
  seconds_ += thread_cpu_seconds() - begin;
  return outcome;
}

std::optional<Status> SteppedSearch::go_back_to(std::uint64_t expansions) {
  auto outcome = begin();
  while (!outcome && this->expansions() < expansions) outcome = go_on();
  return outcome;
}

}  // namespace wend::cli
