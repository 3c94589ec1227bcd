#include "docs/planner_page/driving.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <utility>

#include "bench/measure/markdown_table.hpp"
#include "bench/measure/statistics.hpp"
#include "docs/planner_page/measurements.hpp"
#include "wend/base/random.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/geometry/corner_pose.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/text_table.hpp"

namespace wend::planner_page {
namespace {

constexpr std::array<std::string_view, 5> kCars{"car:heuristic=zero", "car:heuristic=diagonal",
                                                "car:heuristic=headings", "car:heuristic=obstacles",
                                                "car:weight=1.5"};
constexpr double kBlockedShare = 0.12;
constexpr std::uint64_t kDrivingSeed = 7;

/// Statistics of one planner over the queries on a map.
struct MeasuredCar {
  double expanded = 0;    // median
  double us = 0;          // median
  double cost = 1;        // over the cheapest: the median,
  double worst_cost = 1;  // and the greatest
};

std::unique_ptr<Planner> car_of(std::string_view text, const FreeSpace& space) {
  const auto specs = parse_planner_specs(text);
  assert(specs && specs->size() == 1);
  auto planner = make_planner(specs->front().name, space, specs->front().options);
  assert(planner);
  return *std::move(planner);
}

Pose random_pose(Random& random, const FreeSpace& space) {
  const auto below = [&](int end) {
    return static_cast<int>(random.below(static_cast<std::uint64_t>(end)));
  };
  const Cell corner{below(space.width() + 1), below(space.height() + 1)};
  return pose_of({corner, kAllHeadings[random.below(kHeadings)]});
}

/// Random queries that have a path.
std::vector<Query> car_queries(const FreeSpace& space, std::size_t count) {
  const auto car = car_of("car", space);
  Random random(kDrivingSeed);
  std::vector<Query> queries;
  while (queries.size() < count) {
    const Query query{random_pose(random, space), {random_pose(random, space)}};
    if (car->plan(query)) queries.push_back(query);
  }
  return queries;
}

/// In the order of kCars, whose first is optimal.
std::vector<MeasuredCar> measured_cars(const FreeSpace& space, std::size_t count, Effort effort) {
  const std::vector<Query> queries = car_queries(space, count);
  std::vector<double> least_costs;
  std::vector<MeasuredCar> cars;
  for (const std::string_view name : kCars) {
    const auto planner = car_of(name, space);
    std::vector<double> costs;
    std::vector<double> expanded;
    std::vector<double> us;
    Plan plan;
    for (const Query& query : queries) {
      const double seconds = least_seconds(
          thread_cpu_seconds, [&] { planner->plan(query, plan); }, repetition(effort));
      costs.push_back(plan.cost);
      expanded.push_back(static_cast<double>(plan.metrics.expanded));
      us.push_back(seconds * 1e6);
    }
    if (least_costs.empty()) least_costs = costs;
    for (std::size_t i = 0; i < costs.size(); ++i) {
      costs[i] = least_costs[i] > 0 ? costs[i] / least_costs[i] : 1;
    }
    cars.push_back({summary_of(expanded).median, summary_of(us).median, summary_of(costs).median,
                    *std::ranges::max_element(costs)});
  }
  return cars;
}

/// A row with a column for each of kCars, the least in bold.
void add_row(MarkdownTable& table, const std::string& map, const std::string& title,
             const std::vector<MeasuredCar>& cars, double MeasuredCar::* value, int decimals) {
  std::vector<double> values;
  values.reserve(cars.size());
  for (const MeasuredCar& car : cars) values.push_back(car.*value);
  const std::vector<bool> best = best_of(values, false);
  std::vector<std::string> row{map, title};
  for (std::size_t i = 0; i < values.size(); ++i) {
    row.push_back(decimal(values[i], decimals, best[i]));
  }
  table.add(row);
}

}  // namespace

std::string driving_section(Effort effort) {
  const int size = effort == Effort::quick ? 30 : 300;
  const std::size_t count = effort == Effort::quick ? 3 : 200;
  const std::string cells = std::to_string(static_cast<int>(kBlockedShare * size * size));
  std::vector<TextTable::Column> columns{{"map"}, {"measure"}};
  for (const std::string_view name : kCars) {
    columns.push_back({fmt::format("`{}`", name), Align::right});
  }
  MarkdownTable table(std::move(columns));
  const auto add = [&](const std::string& title, std::string_view kind,
                       const OptionValues& options) {
    const FreeSpace space =
        *make_free_space(generated_map(kind, size, size, kDrivingSeed, options));
    const std::vector<MeasuredCar> cars = measured_cars(space, count, effort);
    add_row(table, title, "time, µs", cars, &MeasuredCar::us, 1);
    add_row(table, "", "expanded", cars, &MeasuredCar::expanded, 0);
    std::vector<std::string> costs{"", "cost / cheapest (worst)"};
    for (const MeasuredCar& car : cars) {
      costs.push_back(fmt::format("{:.2f} ({:.2f})", car.cost, car.worst_cost));
    }
    table.add(costs);
  };
  add("Empty", "car", {{"obstacles", "0"}, {"rough", "0"}});
  add("Random", "car", {{"obstacles", cells}, {"rough", cells}});
  add("Parking", "parking", {});
  return fmt::format(
      "`car` on maps of {0} x {0} cells, {1} random queries each: empty; random with 12 % "
      "obstacles "
      "and 12 % rough ground; and a parking lot.\n\n{2}",
      size, count, table.text());
}

}  // namespace wend::planner_page
