#include "bench/comparison/timed_planner.hpp"

#include <cassert>
#include <utility>

#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"

namespace wend {

TimedPlanner::TimedPlanner(FreeSpace space, PlannerSpec spec, Clock clock,
                           const RepetitionRule& rule)
    : space_(std::move(space)), spec_(std::move(spec)), clock_(std::move(clock)), rule_(rule) {
  const PlannerInfo* const info = planners().find(spec_.name);
  resumes_ = info != nullptr && info->capabilities.resumes;
  auto made = make();
  if (made) {
    planner_ = *std::move(made);
  } else {
    error_ = made.error();
  }
}

PlannerResult TimedPlanner::make() {
  const PlannerInfo* const info = planners().find(spec_.name);
  preparation_ = 0;
  if (info != nullptr && info->index_support) return make_on_index(*info);
  return timed(clock_, preparation_,
               [&] { return make_planner(spec_.name, space_, spec_.options); });
}

PlannerResult TimedPlanner::make_on_index(const PlannerInfo& info) {
  if (!index_) {
    auto built =
        timed(clock_, index_seconds_, [&] { return info.index_support->build(space_, {}); });
    if (!built) return Unexpected<Error>(built.error());
    index_ = *std::move(built);
  }
  preparation_ = index_seconds_;
  return timed(clock_, preparation_,
               [&] { return info.index_support->make_planner(space_, spec_.options, *index_); });
}

Status TimedPlanner::answer(const Query& query, Plan& plan, QueryTimes& times) {
  assert(planner_ != nullptr);
  answer_first(query, plan, times);
  const SearchMetrics first = plan.metrics;
  Status status{};
  times.later = least_seconds(clock_, [&] { status = planner_->plan(query, plan); }, rule_);
  if (resumes_) plan.metrics = first;
  return status;
}

PlannerResult TimedPlanner::another() const {
  const PlannerInfo* const info = planners().find(spec_.name);
  if (info == nullptr || !index_) return make_planner(spec_.name, space_, spec_.options);
  return info->index_support->make_planner(space_, spec_.options, *index_);
}

void TimedPlanner::answer_first(const Query& query, Plan& plan, QueryTimes& times) {
  const auto ask = [&](Planner& planner) {
    times.preparation = preparation_;
    times.first = seconds_of(clock_, [&] { planner.plan(query, plan); });
  };
  if (is_new_) {
    is_new_ = false;
    ask(*planner_);
    // The program's own code is loaded on first use. That is not the planner's time, and it only
    // shows if the planner's time is short.
    const bool is_short = preparation_ + times.first < rule_.fill_seconds;
    if (!is_short) return;
    if (auto again = make()) {
      planner_ = *std::move(again);
      ask(*planner_);
    }
  } else if (auto fresh = make()) {
    ask(**fresh);
  }
}

}  // namespace wend
