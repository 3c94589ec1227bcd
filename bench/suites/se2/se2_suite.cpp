// Planners for robots with headings on large maps, in CPU time, with every path checked; beside
// Boost's A* on the cells of the same maps. With --curves: Dubins and Reeds-Shepp curves beside OMPL's.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/measure/markdown_table.hpp"
#include "bench/measure/measuring.hpp"
#include "bench/measure/statistics.hpp"
#include "bench/suites/se2/curve_table.hpp"
#include "bench/suites/se2/se2_case.hpp"
#include "bench/suites/se2/se2_run.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_maps.hpp"
#include "wend/base/thread_time.hpp"

namespace wend::bench {
namespace {

/// hybrid_astar with one option changed at a time.
constexpr std::string_view kVariants =
    "hybrid_astar,hybrid_astar:weight=1,hybrid_astar:weight=1.2,hybrid_astar:weight=2,"
    "hybrid_astar:headings=16,hybrid_astar:headings=72,"
    "hybrid_astar:motion_length=0.1,hybrid_astar:motion_length=0.4,"
    "hybrid_astar:reverse_factor=1,hybrid_astar:reverse_factor=5,hybrid_astar:gear_change_cost=1,"
    "hybrid_astar:turn_factor=1,hybrid_astar:allow_reverse=false,hybrid_astar:turning_radius=0.8,"
    "hybrid_astar:motion_model=dubins,hybrid_astar:motion_model=differential,"
    "hybrid_astar:motion_model=differential,turn_cost=1,hybrid_astar:motion_model=omni";

struct Se2Arguments {
  std::vector<std::filesystem::path> files;
  std::string planners = "lattice";
  std::string only;  // a part of the names of maps
  std::uint64_t queries = 100;
  std::uint64_t seed = 1;
  bool generated = true;
  bool curves = false;
  bool options = false;
  Se2Settings settings{};
};

double at(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return quantile(values, share);
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

constexpr double kNoWay = std::numeric_limits<double>::infinity();

/// Costs of queries; nothing without a path.
using Costs = std::vector<std::optional<double>>;

/// The mean ratio of costs to others, over the queries that both have.
std::string costs_against(const Costs& costs, const Costs& others) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const std::optional<double> cost = costs[i];
    const std::optional<double> other = others[i];
    if (!cost || !other) continue;
    sum += *cost / *other;
    ++count;
  }
  return count == 0 ? "" : fmt::format("{:.4f}", sum / count);
}

/// The lowest cost of each query that any run found.
Costs lowest_costs(const std::vector<Se2Run>& runs) {
  Costs lowest = runs.front().costs;
  for (const Se2Run& run : runs) {
    for (std::size_t i = 0; i < lowest.size(); ++i) {
      const std::optional<double> cost = run.costs[i];
      if (cost && *cost < lowest[i].value_or(kNoWay)) lowest[i] = cost;
    }
  }
  return lowest;
}

double mean_cost(const Se2Run& run) {
  std::vector<double> costs;
  for (const auto& cost : run.costs) {
    if (cost) costs.push_back(*cost);
  }
  return mean(costs);
}

/// Of the poses that were reached, those by curves of several motions, not by one short motion.
std::string share_of_curves(const Se2Run& run) {
  if (run.reached == 0) return "";
  const double share = static_cast<double>(run.by_curves) / static_cast<double>(run.reached);
  return fmt::format("{:.1f} %", 100 * share);
}

std::string ms(double value) { return fmt::format("{:.3g}", value); }

/// The tables of one map, and what went wrong on it.
class MapReport {
 public:
  explicit MapReport(std::string name) : name_(std::move(name)) {}

  void add_making(const std::string& robot, double space_ms) {
    starts_.add({robot, "free space", ms(space_ms), "", ""});
  }

  void add(const std::string& robot, const std::string& planner, const Se2Run& run,
           const Costs& first, const Costs& lowest) {
    starts_.add({robot, planner, ms(run.making_ms), ms(run.first_query_ms),
                 fmt::format("{:.1f}", run.resident_mb)});
    const double total_ms = mean(run.ms) * static_cast<double>(run.ms.size());
    const double expanded = mean(run.expanded) * static_cast<double>(run.expanded.size());
    const auto solved = static_cast<double>(std::max<std::size_t>(run.solved(), 1));
    queries_.add({robot, planner, ms(at(run.ms, 0.5)), ms(at(run.ms, 0.9)), ms(at(run.ms, 0.99)),
                  ms(at(run.ms, 1)), fmt::format("{}/{}", run.solved(), run.ms.size()),
                  fmt::format("{:.0f}", at(run.expanded, 0.5)),
                  fmt::format("{:.0f}", at(run.expanded, 0.99)),
                  fmt::format("{:.0f}", expanded == 0 ? 0 : total_ms * 1e6 / expanded),
                  share_of_curves(run), fmt::format("{:.3f}", mean_cost(run)),
                  costs_against(run.costs, first), costs_against(run.costs, lowest),
                  fmt::format("{:.2f}", run.length / solved),
                  fmt::format("{:.2f}", static_cast<double>(run.gear_changes) / solved),
                  fmt::format("{}", run.faults.size())});
    for (const std::string& why : run.unsolved) complain(robot, planner, "unsolved", why);
    for (const std::string& fault : run.faults) complain(robot, planner, "FAULT", fault);
    faults_ += run.faults.size();
  }

  void add_boost(const std::string& robot, const std::vector<double>& times) {
    queries_.add({robot, "Boost's A* on cells", ms(at(times, 0.5)), ms(at(times, 0.9)),
                  ms(at(times, 0.99)), ms(at(times, 1)), "", "", "", "", "", "", "", "", "", "",
                  ""});
  }

  std::size_t faults() const { return faults_; }

  void print(const GridMap& map) const {
    fmt::print("## {}: {} x {} cells of {} m\n\n{}\n{}\n{}", name_, map.width(), map.height(),
               map.frame().resolution, starts_.text(), queries_.text(), complaints_);
    if (!complaints_.empty()) fmt::print("\n");
    std::fflush(stdout);
  }

 private:
  void complain(const std::string& robot, const std::string& planner, const char* what,
                const std::string& text) {
    complaints_ += fmt::format("- {}, {}, {}: {}\n", robot, planner, what, text);
  }

  std::string name_;
  MarkdownTable starts_{{{"robot"}, {"start-up of"}, {"ms"}, {"first query, ms"}, {"MB in use"}}};
  MarkdownTable queries_{{{"robot"},
                          {"planner"},
                          {"median ms"},
                          {"p90"},
                          {"p99"},
                          {"max"},
                          {"solved"},
                          {"expanded, median"},
                          {"p99"},
                          {"ns each"},
                          {"by curves"},
                          {"cost, m"},
                          {"to the first"},
                          {"to the lowest"},
                          {"length, m"},
                          {"gear changes"},
                          {"faults"}}};
  std::string complaints_;
  std::size_t faults_ = 0;
};

/// Says whether all paths are free of faults.
bool measure(const NamedMap& named, const std::vector<PlannerSpec>& planners,
             const Se2Arguments& arguments) {
  MapReport report(named.name);
  for (const NamedRobot& robot : se2_robots()) {
    const double begun = thread_cpu_seconds();
    const FreeSpace space = value_or_refuse(make_free_space(named.map, robot.options));
    report.add_making(robot.name, (thread_cpu_seconds() - begun) * 1e3);
    const auto queries = random_pose_queries(space, arguments.queries, arguments.seed);
    if (queries.empty()) continue;
    std::vector<Se2Run> runs;
    runs.reserve(planners.size());
    for (const PlannerSpec& spec : planners) {
      runs.push_back(value_or_refuse(se2_run(space, spec, queries, arguments.settings)));
    }
    // Options change what is paid for, so costs of variants say nothing of each other's.
    const Costs lowest = arguments.options ? Costs(queries.size()) : lowest_costs(runs);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      report.add(robot.name, planners[i].text, runs[i], runs.front().costs, lowest);
    }
    report.add_boost(robot.name, boost_ms(space, queries, arguments.settings.rounds));
  }
  report.print(named.map);
  return report.faults() == 0;
}

int run(const Se2Arguments& arguments) {
  if (arguments.curves) {
    const CurveTable table = curve_table(2000, 20 * arguments.settings.rounds);
    fmt::print("{}{}", table.text, table.differences);
    return table.differences.empty() ? 0 : 1;
  }
  const auto planners = value_or_refuse(
      parse_planner_specs(arguments.options ? kVariants : std::string_view(arguments.planners)));
  bool all_fine = true;
  for (const NamedMap& map : se2_maps(arguments.files, arguments.generated)) {
    if (map.name.find(arguments.only) == std::string::npos) continue;
    all_fine = measure(map, planners, arguments) && all_fine;
  }
  return all_fine ? 0 : 1;
}

std::vector<std::filesystem::path> default_files() {
  const std::filesystem::path folder = data_folder() / "ros";
  return {folder / "nav2" / "depot.yaml", folder / "nav2" / "100by100_10.yaml",
          folder / "nav2" / "tb3_sandbox.yaml", folder / "aws_warehouse" / "map.yaml",
          folder / "f1tenth" / "berlin.yaml"};
}

}  // namespace

Measure add_se2(CLI::App& app) {
  const auto arguments = std::make_shared<Se2Arguments>();
  arguments->files = default_files();
  app.add_option("maps", arguments->files, "map files, instead of those of the data folder");
  app.add_option(
         "--planner", arguments->planners,
         "a list, as lattice,car:weight=1.5; costs are compared with the first one's, and with the "
         "lowest")
      ->capture_default_str();
  app.add_option("--only", arguments->only, "only maps whose name contains this");
  app.add_option("--queries", arguments->queries, "random pairs of poses for each map and robot")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--seed", arguments->seed, "of the queries")->capture_default_str();
  app.add_flag("!--no-generated", arguments->generated, "leave out the generated maps");
  app.add_option("--turning-radius", arguments->settings.turning_radius, "metres")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
  app.add_option("--rounds", arguments->settings.rounds,
                 "timed runs of every query; the fastest counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--seconds", arguments->settings.seconds, "time limit of a query")
      ->check(CLI::Range(0.001, 3600.0))
      ->capture_default_str();
  app.add_flag(
      "--exhaustive", arguments->settings.exhaustive,
      "look for drives of unsolved queries by an exhaustive search, which takes seconds each");
  app.add_flag(
      "--options", arguments->options,
      "compare hybrid_astar with itself, one option changed at a time, instead of --planner");
  app.add_flag("--curves", arguments->curves, "time Dubins and Reeds-Shepp curves instead");
  return [arguments] {
    stay_on_one_core();
    return run(*arguments);
  };
}

}  // namespace wend::bench
