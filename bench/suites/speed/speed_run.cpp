#include "bench/suites/speed/speed_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "bench/boost/boost_planner.hpp"
#include "bench/scenario/scenario_verdict.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {
namespace {

constexpr double kMicroseconds = 1e6;
constexpr std::size_t kAskedFirst = 10;  // queries that new planners are asked

const Clock& cpu_clock() {
  static const Clock clock = thread_cpu_seconds;
  return clock;
}

/// One of the planners that are compared, on one map.
class Entry {
 public:
  Entry(std::string name, PlannerInfo info, OptionValues options, FreeSpace space)
      : info_(std::move(info)), options_(std::move(options)), space_(std::move(space)) {
    timing_.name = std::move(name);
  }

  /// Builds the index, if there is one, and makes the planner for later queries. Returns what is
  /// wrong, or empty.
  std::string prepare() {
    if (info_.index_support) {
      Expected<IndexBytes, Error> index;
      timing_.prepare_us = kMicroseconds * seconds_of(cpu_clock(), [&] {
                             index = info_.index_support->build(space_, {});
                           });
      if (!index) return timing_.name + ": " + index.error().message;
      index_ = *std::move(index);
    }
    auto made = make();
    if (!made) return timing_.name + ": " + made.error().message;
    planner_ = *std::move(made);
    return {};
  }

  /// Asks each query of a new planner.
  void time_first(const std::vector<ScenarioQuery>& queries) {
    double prepare = 0;
    double first = 0;
    for (const ScenarioQuery& query : queries) {
      PlannerResult made;
      Plan plan;
      const Query asked = Query::between(query.start, query.goal);
      prepare += seconds_of(cpu_clock(), [&] { made = make(); });
      first += seconds_of(cpu_clock(), [&] { (*made)->plan(asked, plan); });
    }
    const auto count = static_cast<double>(queries.size());
    timing_.prepare_us += kMicroseconds * prepare / count;
    timing_.first_us = kMicroseconds * first / count;
  }

  /// Makes a planner for each query, and counts both. The least of all rounds.
  void time_fresh(const std::vector<ScenarioQuery>& queries) {
    const double seconds = seconds_of(cpu_clock(), [&] {
      for (const ScenarioQuery& query : queries) {
        (*make())->plan(Query::between(query.start, query.goal), plan_);
      }
    });
    const double mean = kMicroseconds * seconds / static_cast<double>(queries.size());
    timing_.fresh_us = timing_.fresh_us == 0 ? mean : std::min(timing_.fresh_us, mean);
  }

  /// The same on a space that no planner has seen. Making it and its components is not counted.
  void time_alone(const std::vector<ScenarioQuery>& queries) {
    double seconds = 0;
    for (const ScenarioQuery& query : queries) {
      const FreeSpace apart = *make_free_space(space_.map(), space_.options());
      static_cast<void>(apart.components());
      seconds += seconds_of(cpu_clock(), [&] {
        (*make(apart))->plan(Query::between(query.start, query.goal), plan_);
      });
    }
    const double mean = kMicroseconds * seconds / static_cast<double>(queries.size());
    timing_.alone_us = timing_.alone_us == 0 ? mean : std::min(timing_.alone_us, mean);
  }

  /// Checks the kept planner's answers, not timed. Sets how many cells the paths have.
  void check(const std::vector<ScenarioQuery>& queries, double& path_cells) {
    path_cells = 0;
    const auto count = static_cast<double>(queries.size());
    for (const ScenarioQuery& query : queries) {
      const Status status = planner_->plan(Query::between(query.start, query.goal), plan_);
      const PathKind kind = info_.capabilities.any_angle ? PathKind::lines : PathKind::steps;
      if (!wrong_answer(space_, {}, query, status, plan_, kind).empty()) ++timing_.wrong;
      timing_.expanded += static_cast<double>(plan_.metrics.expanded) / count;
      path_cells += static_cast<double>(plan_.path.size()) / count;
    }
  }

  /// One round: all queries one after the other, as a robot asks them. If one query were
  /// repeated, the processor's caches and branch predictors would learn it.
  void time_later(const std::vector<ScenarioQuery>& queries) {
    std::vector<Query> asked;
    asked.reserve(queries.size());
    for (const ScenarioQuery& query : queries) {
      asked.push_back(Query::between(query.start, query.goal));
    }
    const double seconds = least_seconds(cpu_clock(), [&] {
      for (const Query& query : asked) planner_->plan(query, plan_);
    });
    least_ = std::min(least_, seconds / static_cast<double>(asked.size()));
    timing_.later_us = kMicroseconds * least_;
  }

  const Timing& timing() const { return timing_; }

 private:
  PlannerResult make() const { return make(space_); }
  PlannerResult make(const FreeSpace& space) const {
    return info_.index_support ? info_.index_support->make_planner(space, options_, index_)
                               : info_.make(space, options_);
  }

  PlannerInfo info_;
  OptionValues options_;
  FreeSpace space_;
  IndexBytes index_;
  std::unique_ptr<Planner> planner_;
  Plan plan_;
  double least_ = std::numeric_limits<double>::infinity();  // seconds a later query
  Timing timing_;
};

Expected<MapTimings, Error> time_map(const SpeedMap& map, const SpeedPlan& plan) {
  const FreeSpace space = *make_free_space(map.map);
  const auto sample = evenly_sampled(map.queries, plan.sample);
  std::vector<Entry> entries;
  entries.emplace_back("boost-astar", boost_astar_planner(), OptionValues{}, space);
  for (const PlannerSpec& spec : plan.planners) {
    entries.emplace_back(spec.text, *planners().find(spec.name), spec.options, space);
  }
  MapTimings timings{map.name, space.passable().count(), sample.size(), 0, {}};
  for (Entry& entry : entries) {
    const std::string wrong = entry.prepare();
    if (!wrong.empty()) return failure(Status::invalid_option, map.name + ": " + wrong, map.name);
    entry.time_first(evenly_sampled(sample, kAskedFirst));
    entry.check(sample, timings.path_cells);
  }
  for (int round = 0; round < plan.rounds; ++round) {
    for (Entry& entry : entries) entry.time_later(sample);
    if (!plan.fresh) continue;
    for (Entry& entry : std::span(entries).subspan(1)) {
      entry.time_fresh(sample);
      entry.time_alone(sample);
    }
  }
  for (const Entry& entry : entries) timings.planners.push_back(entry.timing());
  return timings;
}

}  // namespace

Expected<std::vector<MapTimings>, Error> run_speed(
    const std::vector<SpeedMap>& maps, const SpeedPlan& plan,
    const std::function<void(const std::string&, std::size_t, std::size_t)>& progress) {
  std::vector<MapTimings> all;
  for (const SpeedMap& map : maps) {
    progress(map.name, all.size(), maps.size());
    auto timings = time_map(map, plan);
    if (!timings) return Unexpected<Error>(timings.error());
    all.push_back(*std::move(timings));
  }
  return all;
}

double fresh_ratio_of(const std::vector<MapTimings>& maps, std::size_t planner,
                      double Timing::* time) {
  double sum = 0;
  for (const MapTimings& map : maps) {
    sum += std::log(map.planners.front().later_us / map.planners[planner].*time);
  }
  return std::exp(sum / static_cast<double>(maps.size()));
}

SpeedRatios ratios_of(const std::vector<MapTimings>& maps, std::size_t planner) {
  const auto mean_of = [&](double Timing::* time) {
    double sum = 0;
    for (const MapTimings& map : maps) {
      sum += std::log(map.planners.front().*time / map.planners[planner].*time);
    }
    return std::exp(sum / static_cast<double>(maps.size()));
  };
  return {mean_of(&Timing::later_us), mean_of(&Timing::first_us), mean_of(&Timing::prepare_us)};
}

}  // namespace wend::bench
