#include "bench/suites/se2/se2_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bench/boost/boost_astar.hpp"
#include "bench/measure/measuring.hpp"
#include "bench/suites/se2/exhaustive_drive.hpp"
#include "wend/base/status.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/session/failure_text.hpp"

namespace wend::bench {
namespace {

/// Adds the turning radius, if the planner has such an option and it is not set.
void set_turning_radius(const PlannerInfo& info, double radius, OptionValues& options) {
  const std::string name = "turning_radius";
  const bool has_it = std::ranges::any_of(
      info.options, [&](const OptionInfo& option) { return option.name == name; });
  const bool is_set =
      std::ranges::any_of(options, [&](const auto& option) { return option.first == name; });
  if (has_it && !is_set) options.emplace_back(name, format_number(radius));
}

/// The least time of an action in ms. A slow one is done once.
template <class Action>
double least_ms(int rounds, Action&& action) {
  constexpr double kSlow = 1000;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    const double begun = thread_cpu_seconds();
    action();
    least = std::min(least, (thread_cpu_seconds() - begun) * 1e3);
    if (least > kSlow) break;
  }
  return least;
}

/// The value of an option, if it is set.
std::string_view value_of(const OptionValues& options, std::string_view name) {
  const auto found =
      std::ranges::find(options, name, [](const auto& option) { return option.first; });
  return found == options.end() ? std::string_view{} : std::string_view(found->second);
}

/// What the checker holds the robot to by the options of its planner. `radius` is in cells, and holds for cars.
test::DriveRules rules_of(const OptionValues& options, double radius) {
  const std::string_view model = value_of(options, "motion_model");
  const bool turns = model == "differential" || model == "omni";
  return {.turning_radius = turns ? 0 : radius,
          .reverses = model != "dubins" && value_of(options, "allow_reverse") != "false",
          .turns_in_place = turns,
          .moves_aside = model == "omni"};
}

/// The same for one plan. A lattice moves the ends to its states, and says how far.
test::DriveRules rules_for(const Plan& plan, test::DriveRules rules) {
  const auto widened = [&rules](const SnappingError& error) {
    return rules.end_tolerance + std::max(error.distance, error.turn);
  };
  rules.end_tolerance =
      std::max(widened(plan.start_snapping_error), widened(plan.goal_snapping_error));
  return rules;
}

void note_path(const FreeSpace& space, const Query& query, const Plan& plan,
               const test::DriveRules& rules, std::size_t number, Se2Run& run) {
  const double resolution = space.map().frame().resolution;
  const test::DriveReport report =
      test::checked_drive(space, plan.path, query, rules_for(plan, rules));
  if (!report.fault.empty())
    run.faults.push_back(fmt::format("query {}: {}", number, report.fault));
  run.length += report.length * resolution;
  run.gear_changes += static_cast<std::size_t>(report.gear_changes);
  run.costs.emplace_back(plan.cost * resolution);
}

/// Counts how poses are reached.
class CurveCounter final : public SearchObserver {
 public:
  explicit CurveCounter(Se2Run& run) : run_(run) {}

  /// Has there been no event of continuous poses?
  bool in_vain() const { return in_vain_; }

  void on_generate(const SearchEvent& event) override {
    in_vain_ = in_vain_ && event.way.empty();
    if (event.way.size() < 2) return;
    ++run_.reached;
    run_.by_curves += event.way.size() > 2 ? 1 : 0;
  }
  void on_expand(const SearchEvent& /*event*/) override {}
  void on_relax(const SearchEvent& event) override { on_generate(event); }

 private:
  Se2Run& run_;
  bool in_vain_ = true;
};

/// Asks the solved queries once more, for a planner of continuous poses.
void count_curves(Planner& planner, const std::vector<Query>& queries, Se2Run& run) {
  CurveCounter counter(run);
  Plan plan;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (!run.costs[i]) continue;
    Query query = queries[i];
    query.observer = &counter;
    planner.plan(query, plan);
    if (counter.in_vain()) return;
  }
}

std::string verdict(const FreeSpace& space, const Query& query, double radius) {
  const ExhaustiveAnswer answer = exhaustive_drive(space, query, radius);
  return fmt::format("; the exhaustive search {} after {} states",
                     answer.found ? "FINDS A DRIVE" : "finds none", answer.states);
}

}  // namespace

Expected<Se2Run, Error> se2_run(const FreeSpace& space, PlannerSpec spec,
                                const std::vector<Query>& queries, const Se2Settings& settings) {
  set_turning_radius(*planners().find(spec.name), settings.turning_radius, spec.options);
  Se2Run run;
  const double resident = resident_bytes();
  const double begun = thread_cpu_seconds();
  const auto planner = make_planner(spec.name, space, spec.options);
  if (!planner) return Unexpected<Error>(planner.error());
  run.making_ms = (thread_cpu_seconds() - begun) * 1e3;

  const double radius = settings.turning_radius / space.map().frame().resolution;
  const test::DriveRules rules = rules_of(spec.options, radius);
  Plan plan;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    Query query = queries[i];
    query.limits.seconds = settings.seconds;
    Status status = Status::found;
    const auto ask = [&] { status = (*planner)->plan(query, plan); };
    if (i == 0) run.first_query_ms = least_ms(1, ask);
    run.ms.push_back(least_ms(settings.rounds, ask));
    run.expanded.push_back(static_cast<double>(plan.metrics.expanded));
    if (status == Status::found) {
      note_path(space, query, plan, rules, i, run);
      continue;
    }
    run.costs.emplace_back();
    const Pose& start = query.start;
    run.unsolved.push_back(fmt::format(
        "query {} from ({},{},{:.2f} rad): {}: {}{}", i, start.x, start.y, start.heading,
        to_string(status), words_of((*planner)->failure(query, status), plan.metrics, space),
        settings.exhaustive ? verdict(space, query, radius) : ""));
  }
  run.resident_mb = (resident_bytes() - resident) / 1e6;
  count_curves(**planner, queries, run);
  return run;
}

std::vector<double> boost_ms(const FreeSpace& space, const std::vector<Query>& queries,
                             int rounds) {
  const FreeSpaceOptions with = space.options();
  const FreeSpace disc = *make_free_space(
      space.map(), {.footprint = Footprint::disc(space.footprint().inscribed_radius()),
                    .unknown = with.unknown,
                    .outside = with.outside});
  BoostAStar astar(disc);
  Path path;
  std::vector<double> times;
  for (const Query& query : queries) {
    const Cell from = cell_at(query.start.point());
    const Cell to = cell_at(query.goals.front().point);
    times.push_back(least_ms(rounds, [&] { astar.plan(from, to, path); }));
  }
  return times;
}

}  // namespace wend::bench
