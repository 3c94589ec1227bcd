#include <fmt/format.h>

#include <utility>

#include "bench/suites/motion/motion_row.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_maps.hpp"
#include "wend/control/simulation.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/nearest_passable.hpp"

namespace wend::bench {
namespace {

constexpr double kStepBar = 1e-6;        // seconds
constexpr double kSimulationBar = 5e-3;  // of a minute
constexpr double kMinute = 60;
constexpr double kRate = 20;

struct Office {
  FreeSpace space;  // of a disc of 0.2 m
  Path path;        // for one of 0.3 m, longer than a minute
};

/// Splits every cell of 10 cm into four of 5 cm, as map servers have them.
Office office() {
  constexpr int kSide = 1000;
  const GridMap coarse = generated_map("office", kSide / 2, kSide / 2, {}, 1);
  Frame frame = coarse.frame();
  frame.resolution /= 2;
  Grid<CellState> states(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) states[{x, y}] = coarse.state({x / 2, y / 2});
  }
  const GridMap map = *make_grid_map(states, frame);
  const FreeSpace cautious = *make_free_space(map, {.footprint = Footprint::disc(0.3)});
  const auto start = nearest_passable(cautious, {0, 0});
  if (!start) throw Wrong("there is no room in the office");
  const auto goal = nearest_passable(cautious, {kSide - 1, kSide - 1}, start);
  if (!goal) throw Wrong("there is no goal in the office");
  const auto plan = (*make_planner("astar", cautious))->plan(Query::between(*start, *goal));
  if (!plan) throw Wrong(plan.error().message);
  return {*make_free_space(map, {.footprint = Footprint::disc(0.2)}), plan->path};
}

MotionRow simulating(const Office& office, const ControllerInfo& info, int rounds) {
  const auto controller = info.make({}).value();
  Drive drive;
  MotionRow row;
  row.name = fmt::format("simulate a minute at {} Hz, {}", kRate, info.name);
  row.seconds = fastest(rounds, [&] {
    drive = simulate(office.space, office.path, *controller, {},
                     {.rate = kRate, .time_limit = kMinute});
  });
  if (drive.outcome != DriveOutcome::time) throw Wrong(std::string(describe(drive.outcome)));
  row.bar_seconds = kSimulationBar;
  row.note = fmt::format("{} commands, {:.1f} m", drive.samples.size() - 1, drive.distance);
  return row;
}

/// Repeats the steps of that minute without the simulation. Each step includes a share of the
/// follower's copy of the route.
MotionRow stepping(const Office& office, const ControllerInfo& info, int rounds) {
  const auto controller = info.make({}).value();
  const Frame& frame = office.space.map().frame();
  std::vector<MapPose> poses;
  for (const DriveSample& sample :
       simulate(office.space, office.path, *controller, {}, {.rate = kRate, .time_limit = kMinute})
           .samples) {
    poses.push_back(frame.to_metres(sample.pose));
  }
  Follower follower(*controller);
  const Route route(office.path, frame);
  MotionRow row;
  row.seconds = fastest(rounds, [&] {
    follower.follow(route);
    for (const MapPose& pose : poses) follower.step(pose, 1 / kRate);
  });
  row.seconds /= static_cast<double>(poses.size());
  row.name = fmt::format("a control step, {}", info.name);
  row.bar_seconds = kStepBar;
  row.note = fmt::format("{:.1f} m of {:.1f} m", follower.along(), route.length());
  return row;
}

}  // namespace

std::vector<MotionRow> following_rows(int rounds) {
  const Office place = office();
  std::vector<MotionRow> rows;
  for (const ControllerInfo& info : controllers()) rows.push_back(stepping(place, info, rounds));
  for (const ControllerInfo& info : controllers()) rows.push_back(simulating(place, info, rounds));
  return rows;
}

}  // namespace wend::bench
