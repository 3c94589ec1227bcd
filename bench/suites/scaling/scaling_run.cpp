#include "bench/suites/scaling/scaling_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "bench/boost/boost_planner.hpp"
#include "bench/comparison/comparison_run.hpp"
#include "bench/measure/measuring.hpp"
#include "bench/suites/scaling/child_process.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/generate/generators.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {
namespace {

constexpr std::uint64_t kSeed = 7;
constexpr std::size_t kMostQueries = 200;
constexpr std::size_t kNewPlanners = 10;  // that are asked one query
constexpr double kGrowth = 6;             // of a build time from one size to the next, conservative
constexpr double kMilliseconds = 1e3;
constexpr double kMicroseconds = 1e6;
constexpr const char* kBoost = "boost-astar";

/// What a child process measures.
struct Measured {
  PlannerScale scale{};
  std::array<double, kMostQueries> costs{};
};

PlannerInfo info_of(const std::string& planner) {
  return planner == kBoost ? boost_astar_planner() : *planners().find(planner);
}

/// Makes instances of one planner on one map.
class Team {
 public:
  /// Builds the index, if the planner needs one. Ends the process if the build fails.
  Team(const PlannerInfo& info, FreeSpace space) : info_(info), space_(std::move(space)) {
    if (!info_.index_support) return;
    const double begin = thread_cpu_seconds();
    auto index = info_.index_support->build(space_, {});
    if (!index) _exit(1);
    build_s_ = thread_cpu_seconds() - begin;
    index_ = *std::move(index);
  }

  std::unique_ptr<Planner> make() const {
    auto planner = info_.index_support ? info_.index_support->make_planner(space_, {}, index_)
                                       : info_.make(space_, {});
    if (!planner) _exit(1);
    return *std::move(planner);
  }

  double build_s() const { return build_s_; }
  std::uint64_t index_bytes() const { return index_.size(); }

 private:
  const PlannerInfo& info_;
  FreeSpace space_;
  IndexBytes index_{};
  double build_s_ = 0;
};

/// Asks as many queries as there is time for, then repeats them. Sets their number, the time of later
/// queries, and the costs.
void ask(Planner& planner, const std::vector<Query>& queries, double seconds, Measured& measured) {
  Plan plan;
  std::size_t count = 0;
  const double begin = thread_cpu_seconds();
  while (count < queries.size() && thread_cpu_seconds() - begin <= seconds) {
    planner.plan(queries[count], plan);
    measured.costs[count] = plan.cost;
    ++count;
  }
  measured.scale.queries = count;
  const double later = least_seconds(thread_cpu_seconds, [&] {
    for (std::size_t i = 0; i < count; ++i) planner.plan(queries[i], plan);
  });
  measured.scale.later_us = kMicroseconds * later / static_cast<double>(count);
}

/// Asks new planners one query each, as many as there is time for.
void ask_first(const Team& team, std::span<const Query> queries, double seconds,
               PlannerScale& scale) {
  double total = 0;
  double least = std::numeric_limits<double>::infinity();
  std::size_t asked = 0;
  const double begin = thread_cpu_seconds();
  while (asked < std::min(kNewPlanners, queries.size()) &&
         thread_cpu_seconds() - begin <= seconds) {
    Plan plan;
    double prepared = 0;
    const auto planner = timed(thread_cpu_seconds, prepared, [&] { return team.make(); });
    double searched = 0;
    timed(thread_cpu_seconds, searched, [&] { return planner->plan(queries[asked], plan); });
    least = std::min(least, prepared);
    total += searched;
    ++asked;
  }
  scale.prepare_ms = kMilliseconds * least;
  scale.first_us = kMicroseconds * total / static_cast<double>(asked);
}

/// Wall-clock microseconds per query when threads share the queries, each with a new planner. Quick
/// queries are handed out in batches, so that the overhead of sharing is not measured.
double ask_on(unsigned threads, const Team& team, std::span<const Query> queries, double query_us) {
  constexpr double kTask = 20'000;  // microseconds
  constexpr std::size_t kTasks = 10;
  const std::size_t in_a_task =
      std::max<std::size_t>(1, static_cast<std::size_t>(kTask / query_us));
  const std::size_t tasks = in_a_task > 1 ? std::max(kTasks, queries.size() / in_a_task)
                                          : std::max<std::size_t>(threads, queries.size());
  std::vector<std::unique_ptr<Planner>> planners;
  planners.reserve(threads);
  std::vector<Plan> plans(threads);
  ThreadWorkers workers(threads);
  for (unsigned i = 0; i < threads; ++i) planners.push_back(team.make());
  const auto answer = [&](std::size_t task, unsigned worker) {
    for (std::size_t i = 0; i < in_a_task; ++i) {
      const Query& query = queries[(task * in_a_task + i) % queries.size()];
      planners[worker]->plan(query, plans[worker]);
    }
  };
  for (unsigned i = 0; i < threads; ++i) planners[i]->plan(queries.front(), plans[i]);
  const double begin = wall_seconds();
  workers.run(tasks, answer);
  return kMicroseconds * (wall_seconds() - begin) / static_cast<double>(tasks * in_a_task);
}

Measured measure(const PlannerInfo& info, const FreeSpace& space, const std::vector<Query>& queries,
                 double seconds) {
  Measured measured;
  const std::uint64_t before = private_bytes();
  const Team team(info, space);
  {
    const auto planner = team.make();
    ask(*planner, queries, seconds, measured);
    measured.scale.memory_bytes = private_bytes() - before;
  }
  measured.scale.build_s = team.build_s();
  measured.scale.index_bytes = team.index_bytes();
  const auto answered = std::span(queries).first(measured.scale.queries);
  ask_first(team, answered, seconds, measured.scale);
  const double one = ask_on(1, team, answered, measured.scale.later_us);
  measured.scale.two_threads_gain = one / ask_on(2, team, answered, measured.scale.later_us);
  return measured;
}

bool same(double a, double b) {
  constexpr double kRounding = 1e-6;
  return std::abs(a - b) <= kRounding * std::max(1.0, a);
}

/// One kind of map in all sizes.
class KindRun {
 public:
  KindRun(const ScalingPlan& plan, const MapKind& kind)
      : plan_(plan),
        kind_(kind),
        last_builds_(plan.planners.size(), 0.0),
        last_queries_(plan.planners.size(), 0.0) {}

  Expected<MapScale, Error> run(int size, const std::function<void(const std::string&)>& progress) {
    progress(fmt::format("{}, {} x {}", kind_.name, size, size));
    const auto map = make_map(kind_.generator, size, size, kSeed, kind_.options);
    if (!map) return Unexpected<Error>(map.error());
    const double begin = thread_cpu_seconds();
    const FreeSpace space = *make_free_space(*map);
    MapScale scale{kind_, size, space.passable().count(), thread_cpu_seconds() - begin, {}};
    std::vector<Query> queries;
    for (const CellPair& cells : random_pairs(space, plan_.queries, kSeed)) {
      queries.push_back(Query::between(cells.start, cells.goal));
    }
    std::vector<double> costs;
    for (std::size_t i = 0; i < plan_.planners.size(); ++i) {
      progress(fmt::format("{}, {} x {}: {}", kind_.name, size, size, plan_.planners[i]));
      scale.planners.push_back(run_planner(i, size, space, queries, costs));
    }
    return scale;
  }

 private:
  std::optional<PlannerScale> run_planner(std::size_t planner, int size, const FreeSpace& space,
                                          const std::vector<Query>& queries,
                                          std::vector<double>& costs) {
    const std::string& name = plan_.planners[planner];
    double& last_build = last_builds_[planner];
    if (name == kBoost && size > plan_.largest_for_boost) return std::nullopt;
    if (last_build * kGrowth > plan_.most_build_seconds) return std::nullopt;
    if (last_queries_[planner] > plan_.most_query_seconds) return std::nullopt;
    const PlannerInfo info = info_of(name);
    auto measured = in_child([&] { return measure(info, space, queries, plan_.query_seconds); });
    if (!measured) {
      last_build = plan_.most_build_seconds;  // a larger map would fail, too
      return std::nullopt;
    }
    last_build = measured->scale.build_s;
    last_queries_[planner] = measured->scale.later_us / kMicroseconds;
    for (std::size_t i = 0; i < measured->scale.queries; ++i) {
      if (i == costs.size()) costs.push_back(measured->costs[i]);
      measured->scale.wrong = measured->scale.wrong || !same(costs[i], measured->costs[i]);
    }
    return measured->scale;
  }

  const ScalingPlan& plan_;
  const MapKind& kind_;
  std::vector<double> last_builds_;  // seconds, on the map before
  std::vector<double> last_queries_;
};

}  // namespace

Expected<std::vector<MapScale>, Error> run_scaling(
    const ScalingPlan& plan, const std::function<void(const std::string&)>& progress) {
  if (plan.queries < 1 || plan.queries > kMostQueries) {
    return failure(Status::invalid_option, fmt::format("from 1 to {} queries", kMostQueries));
  }
  for (const std::string& name : plan.planners) {
    if (name != kBoost && planners().find(name) == nullptr) {
      return failure(Status::invalid_option, planners().unknown("planner", name), name);
    }
  }
  std::vector<MapScale> maps;
  for (const MapKind& kind : plan.kinds) {
    KindRun run(plan, kind);
    for (const int size : plan.sizes) {
      auto scale = run.run(size, progress);
      if (!scale) return Unexpected<Error>(scale.error());
      maps.push_back(*std::move(scale));
    }
  }
  return maps;
}

std::vector<std::string> optimal_planners() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    const bool optimal =
        info.guarantee == Guarantee::optimal || info.guarantee == Guarantee::bounded;
    if (!info.capabilities.headings && optimal) names.push_back(info.name);
  }
  names.emplace_back(kBoost);
  return names;
}

}  // namespace wend::bench
