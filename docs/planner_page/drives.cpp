#include "docs/planner_page/drives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <memory>

#include "bench/measure/statistics.hpp"
#include "docs/planner_page/markdown.hpp"
#include "docs/planner_page/measured_family.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/car_move.hpp"
#include "wend/planner/planners.hpp"

namespace wend::planner_page {
namespace {

constexpr std::array<std::string_view, 5> kPlanners{"car:heuristic=zero", "car:heuristic=diagonal",
                                                    "car:heuristic=headings",
                                                    "car:heuristic=obstacles", "car:weight=1.5"};
constexpr double kObstacles = 0.12;
constexpr double kRounding = 1 + 1e-9;
constexpr std::uint64_t kSeed = 7;

std::unique_ptr<Planner> planner_of(std::string_view text, const FreeSpace& space) {
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
  return pose_of({corner, kAllHeadings[random.below(kHeadings)]}, space.map().frame().y_up);
}

/// Random drives that there are.
std::vector<Query> random_drives_on(const FreeSpace& space, std::size_t count) {
  const auto car = planner_of("car", space);
  Random random(kSeed);
  std::vector<Query> drives;
  while (drives.size() < count) {
    const Query drive{random_pose(random, space), {random_pose(random, space)}};
    if (car->plan(drive)) drives.push_back(drive);
  }
  return drives;
}

/// One value a drive.
struct Answers {
  std::vector<double> fuel;
  std::vector<double> expanded;
  std::vector<double> us;
};

Answers answers(std::string_view text, const FreeSpace& space, const std::vector<Query>& drives,
                Effort effort) {
  const auto planner = planner_of(text, space);
  Answers all;
  Plan plan;
  for (const Query& drive : drives) {
    const double seconds =
        least_seconds(thread_cpu_seconds, [&] { planner->plan(drive, plan); }, repetition(effort));
    all.fuel.push_back(plan.cost);
    all.expanded.push_back(static_cast<double>(plan.metrics.expanded));
    all.us.push_back(seconds * 1e6);
  }
  return all;
}

DriveYard study_yard(const std::string& title, const FreeSpace& space, std::size_t count,
                     Effort effort) {
  const std::vector<Query> drives = random_drives_on(space, count);
  DriveYard yard{title, drives.size(), {}};
  std::vector<double> least_fuel;
  for (const std::string_view planner : kPlanners) {
    const Answers all = answers(planner, space, drives, effort);
    if (least_fuel.empty()) least_fuel = all.fuel;
    std::vector<double> ratios;
    ratios.reserve(drives.size());
    for (std::size_t i = 0; i < drives.size(); ++i) {
      ratios.push_back(least_fuel[i] > 0 ? all.fuel[i] / least_fuel[i] : 1);
    }
    const double worst = *std::max_element(ratios.begin(), ratios.end());
    yard.rows.push_back({std::string(planner), summary_of(std::move(ratios)).median, worst,
                         summary_of(all.expanded).median, summary_of(all.us).median});
  }
  return yard;
}

std::vector<bool> least_of_column(const DriveYard& yard, double DriveRow::* value) {
  double least = std::numeric_limits<double>::infinity();
  for (const DriveRow& row : yard.rows) least = std::min(least, row.*value);
  std::vector<bool> best;
  best.reserve(yard.rows.size());
  for (const DriveRow& row : yard.rows) best.push_back(row.*value <= least * kRounding);
  return best;
}

}  // namespace

const DriveRow& DriveYard::fastest_optimal() const {
  const DriveRow* fastest = &rows.front();
  for (const DriveRow& row : rows) {
    if (row.worst_cost <= kRounding && row.us < fastest->us) fastest = &row;
  }
  return *fastest;
}

DriveStudy study_drives(Effort effort) {
  const bool quick = effort == Effort::quick;
  const int size = quick ? 30 : 300;
  const std::size_t count = quick ? 3 : 200;
  const std::string cells = std::to_string(static_cast<int>(kObstacles * size * size));
  const auto yard = [&](const std::string& title, std::string_view kind,
                        const OptionValues& options) {
    return study_yard(title, FreeSpace(generated_map(kind, size, size, kSeed, options)), count,
                      effort);
  };
  DriveStudy study;
  study.about = fmt::format(
      "`car` on yards of {0} x {0} cells, {1} random drives each, start and goal with a heading: "
      "empty; with 12 % obstacles and 12 % rough road at random; and a parking yard. Values are "
      "medians.",
      size, count);
  study.yards.push_back(yard("Empty", "car", {{"obstacles", "0"}, {"rough", "0"}}));
  study.yards.push_back(yard("Random", "car", {{"obstacles", cells}, {"rough", cells}}));
  study.yards.push_back(yard("Parking", "parking", {}));
  return study;
}

std::string drive_tables(const DriveStudy& study) {
  MarkdownTable table({{"yard"},
                       {"planner"},
                       {"fuel / least", Align::right},
                       {"worst", Align::right},
                       {"expanded", Align::right},
                       {"time, µs", Align::right}});
  for (const DriveYard& yard : study.yards) {
    const std::vector<bool> fewest = least_of_column(yard, &DriveRow::expanded);
    const std::vector<bool> fastest = least_of_column(yard, &DriveRow::us);
    for (std::size_t i = 0; i < yard.rows.size(); ++i) {
      const DriveRow& row = yard.rows[i];
      table.add({i == 0 ? yard.title : "", code(row.planner), number(row.cost, 3),
                 number(row.worst_cost, 3), number(row.expanded, 0, fewest[i]),
                 number(row.us, 1, fastest[i])});
    }
  }
  return table.text();
}

std::string drive_findings(const DriveStudy& study) {
  std::string text = "**The car's estimate.** Of those that find the least fuel the fastest was";
  for (std::size_t i = 0; i < study.yards.size(); ++i) {
    const DriveYard& yard = study.yards[i];
    const DriveRow& best = yard.fastest_optimal();
    text += fmt::format("{} {} on *{}* ({} of the time without an estimate)",
                        i == 0                        ? ""
                        : i + 1 == study.yards.size() ? " and"
                                                      : ",",
                        code(best.planner), yard.title, percent(best.us / yard.rows.front().us));
  }
  text += ".";
  const DriveRow& weighted = study.yards.back().rows.back();
  const DriveRow& best = study.yards.back().fastest_optimal();
  if (weighted.us < best.us) {
    text += fmt::format(
        " With a weight of 1.5 a drive on *{}* took {} of that time and {} more fuel.",
        study.yards.back().title, percent(weighted.us / best.us), percent(weighted.cost - 1));
  }
  return text;
}

}  // namespace wend::planner_page
