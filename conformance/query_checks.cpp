// What ends a query early: a bad start or goal, limits, a map that the planner refuses.

#include <fmt/format.h>

#include <atomic>
#include <limits>
#include <memory>
#include <string>

#include "conformance/answer.hpp"
#include "conformance/checks.hpp"

namespace wend::test {
namespace {

/// A map without terrain, walled from `wall` columns on, four columns wide.
Trial walled_trial(const Examination& examination, int width, int height, int wall) {
  Grid<CellState> states(width, height, CellState::free);
  for (int y = 0; y < height; ++y) {
    for (int x = wall; x < std::min(wall + 4, width); ++x) states[{x, y}] = CellState::occupied;
  }
  return {*make_grid_map(states), {}, examination.fixed_options().value_or(OptionValues{})};
}

void expect_status(Examination& examination, Planner& planner, const Query& query,
                   Status expected) {
  examination.ask(query);
  const Answer answer = answer_of(planner, query);
  const std::string came = text_of(answer);
  if (answer.status != expected) examination.violate(std::string(to_string(expected)), came);
  if (answer.status == Status::found) return;
  if (const auto leftover = leftover_of(answer.plan); !leftover.empty()) {
    examination.violate("a failure without a path, at infinite cost", leftover);
  }
}

/// Stops at fewer expansions than the query needs, and not at as many. `planner` gives the planner of each
/// query: of one that resumes, a new one. An anytime planner may have a path by then.
template <class PlannerFor>
void expect_expansion_limit(Examination& examination, PlannerFor&& planner, Query query,
                            std::uint64_t needed) {
  for (const std::uint64_t limit : {std::uint64_t{0}, std::uint64_t{1}, needed / 2, needed - 1}) {
    query.limits.expansions = limit;
    examination.ask(query);
    Planner& asked = planner();
    const Answer answer = answer_of(asked, query);
    const SearchMetrics& metrics = answer.plan.metrics;
    const bool anytime = asked.anytime();
    const bool metrics_kept = metrics.expanded == limit && (anytime || metrics.generated >= limit);
    if (anytime && answer.status == Status::found && metrics_kept) continue;
    if (answer.status != Status::expansion_limit || !metrics_kept || metrics.generated == 0 ||
        !leftover_of(answer.plan).empty()) {
      examination.violate(fmt::format("expansion_limit after {} expansions", limit),
                          text_of(answer));
    }
  }
  query.limits.expansions = needed;
  expect_status(examination, planner(), query, Status::found);
}

void expect_clock_and_cancel(Examination& examination, Planner& planner, Query query) {
  double now = 0;
  query.limits.clock = [&] { return now++; };
  query.limits.seconds = 0.5;
  expect_status(examination, planner, query, Status::time_limit);
  query.limits.seconds = 1e9;
  expect_status(examination, planner, query, Status::found);
  query.limits.clock = nullptr;  // the steady clock
  query.limits.seconds = -1;
  expect_status(examination, planner, query, Status::time_limit);
  query.limits.seconds = 1e9;
  expect_status(examination, planner, query, Status::found);
  query.limits = {};
  std::atomic<bool> cancel = true;
  query.limits.cancel = &cancel;
  expect_status(examination, planner, query, Status::cancelled);
  cancel = false;
  expect_status(examination, planner, query, Status::found);
}

}  // namespace

std::string leftover_of(const Plan& plan) {
  const bool clean = plan.path.empty() && plan.cost == kInfinite && plan.moves.empty();
  return clean ? ""
               : fmt::format("path of {}, {} moves, cost {}", plan.path.size(), plan.moves.size(),
                             plan.cost);
}

void examine_status(Examination& examination, std::uint64_t seed) {
  const Trial trial = walled_trial(examination, 16, 12, 6);
  examination.on(trial, seed);
  const auto planner = examination.planner_for(trial);
  if (planner == nullptr) return;
  const Pose left = pose_at({2, 6});
  const Pose inside = {8, 6, 0};
  const Pose right = pose_at({13, 6});
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  for (const Pose& outside : {Pose{-1, 6}, Pose{17, 6}, Pose{2, -1}, Pose{2, 13}, Pose{1e300, 6},
                              Pose{kNotANumber, 6}, Pose{-kInfinite, 6}}) {
    expect_status(examination, *planner, {outside, {left}}, Status::start_outside);
    expect_status(examination, *planner, {left, {outside}}, Status::goal_outside);
  }
  expect_status(examination, *planner, {inside, {left}}, Status::start_blocked);
  expect_status(examination, *planner, {left, {inside}}, Status::goal_blocked);
  expect_status(examination, *planner, {left, {}}, Status::unsupported_query);
  expect_status(examination, *planner, {left, {left}}, Status::found);
  if (examination.info().guarantee == Guarantee::none) return;
  expect_status(examination, *planner, {left, {right}}, Status::unreachable);
}

void examine_limits(Examination& examination, std::uint64_t seed) {
  const Trial trial = walled_trial(examination, 40, 40, 40);
  examination.on(trial, seed);
  const auto planner = examination.planner_for(trial);
  if (planner == nullptr) return;
  const Query query{pose_at({2, 2}), {pose_at({37, 37})}};
  examination.ask(query);
  const Answer unlimited = answer_of(*planner, query);
  if (unlimited.status != Status::found) {
    const bool may_fail = examination.fixed_options().has_value();
    if (!may_fail) examination.violate("a path on an open map", text_of(unlimited));
    return;
  }
  const bool searches = !examination.info().index_support;
  if (searches && unlimited.plan.metrics.expanded > 1) {
    std::unique_ptr<Planner> fresh;
    const auto planner_for_a_query = [&]() -> Planner& {
      if (!examination.info().capabilities.resumes) return *planner;
      fresh = examination.planner_for(trial);
      return *fresh;
    };
    expect_expansion_limit(examination, planner_for_a_query, query,
                           unlimited.plan.metrics.expanded);
  }
  expect_clock_and_cancel(examination, *planner, query);
}

void examine_terrain(Examination& examination, std::uint64_t seed) {
  const Trial trial = walled_trial(examination, 8, 8, 8);
  const FreeSpace flat = *make_free_space(trial.map);
  const auto refuses = [&](const auto& result) {
    return !result && result.error().status == Status::unsupported_map;
  };
  const FreeSpace rough = *make_free_space(
      *make_grid_map(Grid<CellState>(8, 8, CellState::free), {}, Grid<double>(8, 8, 2.0)));
  examination.on(trial, seed);
  const auto planner = examination.planner_for(trial);
  if (planner == nullptr) return;
  const Query query = Query::between({1, 1}, {6, 5});
  const bool takes_terrain = examination.info().make(rough, trial.options).has_value();
  const Status at_first = answer_of(*planner, query).status;
  const bool refused = refuses(planner->update(rough));
  if (refused == takes_terrain) {
    examination.violate(takes_terrain ? "an update to terrain" : "unsupported_map at the update",
                        refused ? "unsupported_map" : "an update");
  }
  if (!takes_terrain) expect_status(examination, *planner, query, Status::unsupported_map);
  if (!planner->update(flat)) examination.violate("an update to a flat map", "a failure");
  expect_status(examination, *planner, query, at_first);
}

}  // namespace wend::test
