#include "bench/speed_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "bench/boost/boost_astar.hpp"
#include "bench/measuring.hpp"
#include "wend/io/load_map.hpp"
#include "wend/io/scenario.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {
namespace {

namespace fs = std::filesystem;
using Error = Unexpected<std::string>;

// Who answers a whole scenario in this time does so in every round. A few queries again and again
// would be learned by heart by the processor's caches and branch predictors.
constexpr double kMostSecondsBetween = 0.5;

/// One of the programs that are compared: answers a query, and says how much it expanded.
struct Contestant {
  std::string name;
  std::function<double(const ScenarioQuery&, Path&, std::uint64_t&)> plan;  // the path's cost
};

Expected<Contestant, std::string> make_contestant(const PlannerSpec& spec, const FreeSpace& space) {
  auto made = make_planner(spec.name, space, spec.options);
  if (!made) return Error(spec.text + ": " + made.error().message());
  const std::shared_ptr<Planner> planner = std::move(*made);
  const auto plan = std::make_shared<Plan>();
  return Contestant{
      spec.text, [planner, plan](const ScenarioQuery& query, Path& path, std::uint64_t& expanded) {
        std::swap(plan->path, path);
        planner->plan(Query::between(query.start, query.goal), *plan);
        std::swap(plan->path, path);
        expanded = plan->metrics.expanded;
        return plan->cost;
      }};
}

Contestant make_boost(const FreeSpace& space) {
  const auto boost = std::make_shared<BoostAStar>(space);
  return {"boost-astar", [boost](const ScenarioQuery& query, Path& path, std::uint64_t& expanded) {
            const BoostAStar::Answer answer = boost->plan(query.start, query.goal, path);
            expanded = answer.expanded;
            return answer.cost;
          }};
}

bool answers(const ScenarioQuery& query, double cost) {
  if (query.says_no_path()) return std::isinf(cost);
  return length_matches(query, cost);
}

/// One contestant answers the sampled queries, and those between them if it is fast enough; the
/// fastest answer to each of the sample so far is kept.
void time_all(Contestant& contestant, const std::vector<ScenarioQuery>& all, bool between,
              std::vector<double>& fastest, Path& path) {
  std::uint64_t expanded = 0;
  if (between) {  // the contestant before has swept the caches
    for (const ScenarioQuery& query : all) contestant.plan(query, path, expanded);
  }
  for (std::size_t i = 0; i < fastest.size(); ++i) {
    const std::size_t at = i * all.size() / fastest.size();
    const double begin = seconds_now();
    contestant.plan(all[at], path, expanded);
    fastest[i] = std::min(fastest[i], 1e6 * (seconds_now() - begin));
    const std::size_t next = (i + 1) * all.size() / fastest.size();
    for (std::size_t j = at + 1; between && j < next; ++j) contestant.plan(all[j], path, expanded);
  }
}

/// What a contestant answers, not timed: this also warms it up.
Timing checked(Contestant& contestant, const std::vector<ScenarioQuery>& queries, Path& path,
               double& path_cells) {
  Timing timing;
  timing.name = contestant.name;
  const auto count = static_cast<double>(queries.size());
  path_cells = 0;
  for (const ScenarioQuery& query : queries) {
    std::uint64_t expanded = 0;
    const double cost = contestant.plan(query, path, expanded);
    if (!answers(query, cost)) ++timing.wrong;
    timing.expanded += static_cast<double>(expanded) / count;
    path_cells += static_cast<double>(path.size()) / count;
  }
  return timing;
}

/// All queries by one contestant, then by the next, round after round. The sample is of all.
std::vector<Timing> time_in_turns(std::vector<Contestant>& contestants,
                                  const std::vector<ScenarioQuery>& all,
                                  const std::vector<ScenarioQuery>& sample, int rounds,
                                  double& path_cells) {
  Path path;
  std::vector<Timing> timings;
  std::vector<bool> between;
  for (Contestant& contestant : contestants) {
    double cells = 0;
    const double begin = seconds_now();
    timings.push_back(checked(contestant, sample, path, cells));
    const double seconds = seconds_now() - begin;
    between.push_back(seconds * static_cast<double>(all.size()) <
                      kMostSecondsBetween * static_cast<double>(sample.size()));
    if (timings.size() == 1) path_cells = cells;  // Boost's
  }
  std::vector<std::vector<double>> fastest(
      contestants.size(),
      std::vector<double>(sample.size(), std::numeric_limits<double>::infinity()));
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      time_all(contestants[i], all, between[i], fastest[i], path);
    }
  }
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const double sum = std::accumulate(fastest[i].begin(), fastest[i].end(), 0.0);
    timings[i].mean_us = sum / static_cast<double>(sample.size());
  }
  return timings;
}

Expected<MapTimings, std::string> time_map(const fs::path& scenario_file, const SpeedPlan& plan) {
  const auto scenario = load_scenario(scenario_file);
  if (!scenario) return Error(scenario.error().message());
  const auto map_file = scenario_map_path(*scenario);
  if (!map_file) return Error(map_file.error().message());
  const auto loaded = load_map(*map_file);
  if (!loaded) return Error(loaded.error().message());
  const GridMap& map = loaded->map;
  if (const auto checked = check_map_size(*scenario, map.width(), map.height()); !checked) {
    return Error(checked.error().message());
  }
  const auto queries = evenly_sampled(scenario->queries, plan.sample);
  if (queries.empty()) return Error(scenario->file + ": there are no queries");

  const FreeSpace space(map);
  std::vector<Contestant> contestants{make_boost(space)};
  for (const PlannerSpec& spec : plan.planners) {
    auto contestant = make_contestant(spec, space);
    if (!contestant) return Error(contestant.error());
    contestants.push_back(*std::move(contestant));
  }
  MapTimings timings;
  timings.map = map_file->stem().string();
  timings.free_cells = space.passable().count();
  timings.queries = queries.size();
  std::vector<Timing> timed =
      time_in_turns(contestants, scenario->queries, queries, plan.rounds, timings.path_cells);
  timings.boost = timed.front();
  timings.planners.assign(timed.begin() + 1, timed.end());
  return timings;
}

}  // namespace

Expected<std::vector<MapTimings>, std::string> run_speed(
    const SpeedPlan& plan,
    const std::function<void(const std::string&, std::size_t, std::size_t)>& progress) {
  const auto files = scenarios_in(plan.folder);
  if (!files) return Error(files.error().message());
  std::vector<MapTimings> maps;
  for (const fs::path& file : *files) {
    progress(file.filename().string(), maps.size(), files->size());
    auto timings = time_map(file, plan);
    if (!timings) return Error(timings.error());
    maps.push_back(*std::move(timings));
  }
  return maps;
}

double geometric_mean_ratio(const std::vector<MapTimings>& maps, std::size_t planner) {
  double sum = 0;
  for (const MapTimings& map : maps) sum += std::log(map.ratio(planner));
  return std::exp(sum / static_cast<double>(maps.size()));
}

}  // namespace wend::bench
