// What planning again takes while a robot discovers its map. The drives are recorded once; every
// planner then replays them: the same starts, goals and edits. Making a planner is counted apart. All times are
// CPU time of the thread.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/comparison/random_queries.hpp"
#include "bench/measure/markdown_table.hpp"
#include "bench/measure/measuring.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_maps.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/explore/explorer.hpp"
#include "wend/planner/costs/leap_engine.hpp"
#include "wend/planner/planners.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend::bench {
namespace {

constexpr std::uint64_t kSeed = 7;

/// A map, a robot, and how far it sees.
struct Setting {
  std::string name;
  GridMap map;
  FreeSpaceOptions robot;
  double range;  // cells
};

/// One plan of a drive: what the robot had learned since the plan before, and where it was.
struct Moment {
  MapEdit edit;
  Cell start;
};

/// What a robot met on its way to a goal.
struct RecordedDrive {
  FreeSpace space;  // as the robot believed it at first
  Cell goal;
  std::vector<Moment> moments;
};

std::vector<Setting> settings(const std::filesystem::path& data) {
  constexpr double kResolution = 0.05;
  constexpr double kGameRange = 30;
  const double robot_range = 10 / kResolution;
  const FreeSpaceOptions disc{.footprint = Footprint::disc(0.2)};
  const FreeSpaceOptions inflated{.footprint = Footprint::disc(0.2), .clearance_distance = 0.35};
  std::vector<Setting> all;
  const auto load = [&](const char* name, const FreeSpaceOptions& robot, double range) {
    for (NamedMap& loaded : loaded_maps({data / name})) {
      all.push_back({loaded.name, std::move(loaded.map), robot, range});
    }
  };
  for (const char* name : {"arena2", "den520d", "orz700d", "Berlin_0_1024", "AcrosstheCape"}) {
    load(fmt::format("nine/{}.map", name).c_str(), {}, kGameRange);
  }
  load("ros/nav2/depot.yaml", disc, robot_range);
  load("ros/nav2/depot.yaml", inflated, robot_range);
  for (const auto& [kind, width, height] :
       {std::tuple{"warehouse", 1000, 1700}, std::tuple{"office", 1200, 900}}) {
    const GridMap map = in_metres(generated_map(kind, width, height), kResolution);
    all.push_back({kind, map, disc, robot_range});
    all.push_back({std::string(kind) + ", costs", map, inflated, robot_range});
  }
  return all;
}

/// Far ends: the farthest of many random pairs.
std::vector<CellPair> far_pairs(const FreeSpace& space, std::size_t count) {
  constexpr std::size_t kOutOf = 10;
  auto pairs = random_pairs(space, kOutOf * count, kSeed);
  std::ranges::sort(pairs, std::ranges::greater(), [](const CellPair& pair) {
    return octile_cost<std::uint64_t>(pair.start, pair.goal);
  });
  pairs.resize(std::min(pairs.size(), count));
  return pairs;
}

/// Drives with planner "astar", which all planners then replay.
std::vector<RecordedDrive> record(const Setting& setting, ReplanWhen when, std::size_t count) {
  const FreeSpace truth = value_or_refuse(make_free_space(setting.map, setting.robot));
  std::vector<RecordedDrive> drives;
  for (const CellPair& pair : far_pairs(truth, count)) {
    auto explorer = Explorer::make(setting.map, pair.start, pair.goal,
                                   {.robot = setting.robot,
                                    .sensor_range = setting.range,
                                    .planner = {"astar"},
                                    .when = when});
    if (!explorer) throw Refused(explorer.error().message);
    RecordedDrive drive{explorer->believed(), pair.goal, {}};
    MapEdit learned;
    std::optional<Status> end;
    while (!end) {
      const Cell start = explorer->cell();
      end = explorer->step();
      const MapEdit& edit = explorer->last_edit();
      learned.cells.insert(learned.cells.end(), edit.cells.begin(), edit.cells.end());
      if (!explorer->planned()) continue;
      drive.moments.push_back({std::move(learned), start});
      learned = {};
    }
    if (*end != Status::found) throw Wrong("a robot did not reach its goal");
    drives.push_back(std::move(drive));
  }
  return drives;
}

/// A planner to be timed; made for each drive.
struct Contestant {
  std::string name;
  std::function<std::unique_ptr<Planner>(const FreeSpace&)> make;
};

std::unique_ptr<Planner> made(const std::string& name, const FreeSpace& space,
                              const OptionValues& options) {
  return value_or_refuse(make_planner(name, space, options));
}

/// A* in whole numbers with the classes of cells, without leaps: the yardstick.
std::unique_ptr<Planner> scratch_without_leaps(const FreeSpace& space) {
  return std::make_unique<GridPlanner>(space, [](const FreeSpace& other, DeadlineCheck& stop) {
    return leap_parts(other, {{}, HeuristicKind::octile, 0, 1, false}, 0, stop);
  });
}

std::vector<Contestant> contestants() {
  const auto named = [](const std::string& name, const std::string& planner,
                        const OptionValues& options) {
    return Contestant{
        name, [planner, options](const FreeSpace& space) { return made(planner, space, options); }};
  };
  return {{"A* from scratch", scratch_without_leaps},
          named("astar", "astar", {}),
          named("d_star_lite", "d_star_lite", {}),
          named("replanner", "replanner", {})};
}

/// Milliseconds of a drive.
struct Times {
  double making = 0;  // of the planner, on the map that it believes in at first
  double plans = 0;   // all of them, and telling the planner of changes

  Times& operator+=(const Times& other) {
    making += other.making;
    plans += other.plans;
    return *this;
  }
};

/// The costs found must be those of `costs`, which it fills at first.
Times replay(const RecordedDrive& drive, const Contestant& contestant, std::vector<double>& costs) {
  FreeSpace space = drive.space;
  std::unique_ptr<Planner> planner;
  Times times;
  Plan plan;
  for (std::size_t i = 0; i < drive.moments.size(); ++i) {
    const Moment& moment = drive.moments[i];
    if (planner != nullptr) planner->release();
    const SpaceChange change = value_or_refuse(space.edit(moment.edit));
    double begun = thread_cpu_seconds();
    if (planner == nullptr) {
      planner = contestant.make(space);
      times.making = (thread_cpu_seconds() - begun) * 1e3;
      begun = thread_cpu_seconds();
    } else if (!planner->update(space, change)) {
      throw Wrong(contestant.name + " could not be updated");
    }
    const Status status = planner->plan(Query::between(moment.start, drive.goal), plan);
    times.plans += (thread_cpu_seconds() - begun) * 1e3;
    if (status != Status::found) throw Wrong(contestant.name + " found no path");
    if (costs.size() == i) costs.push_back(plan.cost);
    if (std::abs(plan.cost - costs[i]) > 2e-6 * costs[i]) {
      throw Wrong(contestant.name + " is not optimal");
    }
  }
  return times;
}

struct Sums {
  std::vector<double> logs;  // of the ratio to the yardstick, by contestant
  int rows = 0;
};

void measure(const Setting& setting, ReplanWhen when, std::size_t count, int rounds,
             MarkdownTable& table, Sums& sums) {
  const auto drives = record(setting, when, count);
  std::size_t plans = 0;
  for (const RecordedDrive& drive : drives) plans += drive.moments.size();
  const auto all = contestants();
  std::vector<Times> best(all.size(), Times{INFINITY, INFINITY});
  std::vector<std::vector<double>> costs(drives.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t c = 0; c < all.size(); ++c) {
      Times total;
      for (std::size_t i = 0; i < drives.size(); ++i) total += replay(drives[i], all[c], costs[i]);
      const auto count_of_drives = static_cast<double>(drives.size());
      if (total.plans / count_of_drives >= best[c].plans) continue;
      best[c] = {total.making / count_of_drives, total.plans / count_of_drives};
    }
  }
  std::vector<std::string> row{setting.name + (when == ReplanWhen::path ? ", path" : ", discovery"),
                               fmt::format("{}", plans / drives.size())};
  for (const Times& times : best) row.push_back(fmt::format("{:.2f}", times.plans));
  row.push_back(fmt::format("{:.1f}", best.front().plans / best.back().plans));
  row.push_back(fmt::format("{:.2f}", best.back().making));
  table.add(row);
  sums.logs.resize(all.size());
  for (std::size_t c = 0; c < all.size(); ++c)
    sums.logs[c] += std::log(best.front().plans / best[c].plans);
  ++sums.rows;
}

void run(const std::filesystem::path& data, std::size_t count, int rounds) {
  std::vector<TextTable::Column> columns{{"map, when it plans"}, {"plans a drive"}};
  for (const Contestant& contestant : contestants()) columns.push_back({contestant.name + ", ms"});
  columns.push_back({"times as fast"});
  columns.push_back({"making replanner, ms"});
  MarkdownTable table(columns);
  Sums sums;
  for (const Setting& setting : settings(data)) {
    for (const ReplanWhen when : {ReplanWhen::path, ReplanWhen::discovery}) {
      measure(setting, when, count, rounds, table, sums);
    }
  }
  std::vector<std::string> means{"geometric mean over A* from scratch", ""};
  for (const double log : sums.logs)
    means.push_back(fmt::format("{:.2f} x", std::exp(log / sums.rows)));
  means.resize(means.size() + 2);
  table.add(means);
  fmt::print("{}", table.text());
}

}  // namespace

Measure add_replanning(CLI::App& app) {
  struct Arguments {
    std::filesystem::path data = data_folder();
    std::size_t drives = 3;
    int rounds = 3;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("--data", arguments->data, "folder with the real maps")->capture_default_str();
  app.add_option("--drives", arguments->drives, "random drives on each map")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_rounds(app, arguments->rounds);
  return [arguments] {
    stay_on_one_core();
    run(arguments->data, arguments->drives, arguments->rounds);
    return 0;
  };
}

}  // namespace wend::bench
