// Sets of motion primitives from files, in both formats, drive where the same set made in memory drives, and
// hybrid_astar drives there, too.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>

#include "conformance/driven_path.hpp"
#include "conformance/random_map.hpp"
#include "tests/testing/build_paths.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/io/primitives/load_primitives.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kSetResolution = 0.1;  // metres
constexpr double kSetRadius = 3;        // cells
constexpr double kMostRadius = 1000;

/// A car on a lattice with four headings: a cell ahead or back, a quarter of a circle to either side in both gears.
MotionPrimitives quarter_turns() {
  MotionPrimitives::Parts parts{.resolution = kSetResolution, .headings = {}, .primitives = {}};
  for (int from = 0; from < 4; ++from) {
    const double heading = from * kPi / 2;
    parts.headings.push_back(heading);
    const auto placed = [&](const Pose& pose) {
      const double cosine = std::round(std::cos(heading));
      const double sine = std::round(std::sin(heading));
      return Pose{cosine * pose.x - sine * pose.y, sine * pose.x + cosine * pose.y,
                  heading + pose.heading};
    };
    const auto add = [&](int turned, const Pose& end) {
      const Pose to = placed(end);
      parts.primitives.push_back(
          {static_cast<int>(parts.primitives.size()),
           from,
           (from + turned + 4) % 4,
           {static_cast<int>(std::lround(to.x)), static_cast<int>(std::lround(to.y))},
           1,
           {{0, 0, heading}, to}});
    };
    for (const int gear : {1, -1}) {
      add(0, {1.0 * gear, 0, 0});
      for (const int side : {1, -1}) {
        add(side * gear, {gear * kSetRadius, side * kSetRadius, side * gear * kPi / 2});
      }
    }
  }
  return *MotionPrimitives::make(std::move(parts));
}

std::string mprim_of(const MotionPrimitives& set) {
  std::string text =
      fmt::format("resolution_m: {}\nnumberofangles: {}\ntotalnumberofprimitives: {}\n",
                  kSetResolution, set.headings().size(), set.all().size());
  for (const MotionPrimitive& primitive : set.all()) {
    text += fmt::format(
        "primID: {}\nstartangle_c: {}\nendpose_c: {} {} {}\nadditionalactioncostmult: 1\n"
        "intermediateposes: {}\n",
        primitive.number, primitive.from, primitive.by.x, primitive.by.y, primitive.to,
        primitive.poses.size());
    for (const Pose& pose : primitive.poses) {
      text +=
          fmt::format("{} {} {}\n", pose.x * kSetResolution, pose.y * kSetResolution, pose.heading);
    }
  }
  return text;
}

std::string json_of(const MotionPrimitives& set) {
  std::string primitives;
  for (const MotionPrimitive& primitive : set.all()) {
    std::string poses;
    for (const Pose& pose : primitive.poses) {
      poses += fmt::format("{}[{}, {}, {}]", poses.empty() ? "" : ", ", pose.x * kSetResolution,
                           pose.y * kSetResolution, pose.heading);
    }
    primitives += fmt::format(
        "{}{{\"trajectory_id\": {}, \"start_angle_index\": {}, \"end_angle_index\": {}, "
        "\"poses\": [{}]}}",
        primitives.empty() ? "" : ",\n", primitive.number, primitive.from, primitive.to, poses);
  }
  return fmt::format(
      "{{\"lattice_metadata\": {{\"grid_resolution\": {}, \"heading_angles\": [{}]}},\n"
      "\"primitives\": [{}]}}",
      kSetResolution, fmt::join(set.headings(), ", "), primitives);
}

/// A yard with a few obstacles, in metres.
GridMap scattered_yard(Random& random, double resolution) {
  const int width = random.between(20, 40);
  const int height = random.between(20, 40);
  Grid<CellState> states(width, height, CellState::free);
  for (const Cell cell : every_cell(states)) {
    if (random.chance(0.015)) states[cell] = CellState::occupied;
  }
  Frame frame;
  frame.resolution = resolution;
  frame.metric = true;
  return *make_grid_map(states, frame);
}

/// Between poses of a lattice with these headings; the robot fits at most of them.
Query query_on(Random& random, const FreeSpace& space, const MotionPrimitives& set) {
  const auto pose = [&] {
    constexpr int kTries = 20;
    Pose drawn;
    for (int i = 0; i < kTries && (i == 0 || !space.fits(drawn)); ++i) {
      const Cell cell = random_cell(random, space.width(), space.height());
      drawn = pose_at(cell, set.headings()[random.below(set.headings().size())]);
    }
    return drawn;
  };
  const Pose start = pose();
  return {start, {Goal(pose())}};
}

Expected<Plan, PlanFailure> lattice_plan(const GridMap& map, const FreeSpaceOptions& robot,
                                         const MotionPrimitives& set, const Query& query) {
  FreeSpaceOptions with = robot;
  with.primitives = set;
  return (*make_planner("lattice", *make_free_space(map, with)))->plan(query);
}

/// The least radius of the arcs of a set, in cells; 0 if it turns in place.
double least_radius(const MotionPrimitives& set) {
  double least = kMostRadius;
  for (const MotionPrimitive& primitive : set.all()) {
    for (std::size_t i = 1; i < primitive.poses.size(); ++i) {
      const Segment segment = segment_between(primitive.poses[i - 1], primitive.poses[i]);
      if (std::abs(segment.turn) < 1e-9) continue;
      least = std::min(least, std::abs(segment.length / segment.turn));
    }
  }
  return least;
}

/// What hybrid_astar says for a robot with that turning radius, held to the independent check.
Expected<Plan, PlanFailure> hybrid_plan(const FreeSpace& space, double radius, const Query& query) {
  const double metres = radius * space.map().frame().resolution;
  OptionValues options{{"turning_radius", fmt::format("{}", metres)},
                       {"turn_factor", "1"},
                       {"time_budget", "1000"}};  // on slow machines, too
  if (metres == 0) options.emplace_back("motion_model", "differential");
  auto plan = (*make_planner("hybrid_astar", space, options))->plan(query);
  if (plan) {
    const DriveReport report = checked_drive(
        space, plan->path, query, {.turning_radius = radius, .turns_in_place = radius == 0});
    EXPECT_EQ(report.fault, "");
  }
  return plan;
}

/// The same for a robot that moves in every direction.
Expected<Plan, PlanFailure> omni_plan(const FreeSpace& space, const Query& query) {
  auto plan = (*make_planner("hybrid_astar", space, {{"motion_model", "omni"}}))->plan(query);
  if (plan) {
    const DriveReport report =
        checked_drive(space, plan->path, query, {.turns_in_place = true, .moves_aside = true});
    EXPECT_EQ(report.fault, "");
  }
  return plan;
}

constexpr std::string_view kSetRobot = "0.2,0.15; -0.1,0.15; -0.1,-0.15; 0.2,-0.15";

/// The set written in a format and read again.
using InFile = Expected<MotionPrimitives, Error> (*)(const MotionPrimitives& set);

Expected<MotionPrimitives, Error> set_in_mprim(const MotionPrimitives& set) {
  return parse_primitives(mprim_of(set), "set.mprim");
}

Expected<MotionPrimitives, Error> set_in_json(const MotionPrimitives& set) {
  return parse_primitives(json_of(set), "set.json");
}

void expect_to_drive_alike(const MotionPrimitives& set, InFile written) {
  const auto read = written(set);
  ASSERT_TRUE(read) << read.error().message;
  int found = 0;
  double driven = 0;
  double on_lattice = 0;
  for (std::uint64_t seed = 0; seed < share_of(40U); ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Random random(seed);
    const GridMap map = scattered_yard(random, kSetResolution);
    const FreeSpaceOptions robot{.footprint = random.chance(0.5) ? Footprint::disc(0.15)
                                                                 : *parse_footprint(kSetRobot)};
    const FreeSpace space = *make_free_space(map, robot);
    const Query query = query_on(random, space, set);
    const auto from_memory = lattice_plan(map, robot, set, query);
    const auto from_file = lattice_plan(map, robot, *read, query);
    ASSERT_EQ(from_memory.has_value(), from_file.has_value());
    if (!from_memory) continue;
    ++found;
    EXPECT_NEAR(from_file->cost, from_memory->cost, 1e-6);
    const auto hybrid = hybrid_plan(space, kSetRadius, query);
    ASSERT_TRUE(hybrid) << hybrid.error().message;
    EXPECT_LE(hybrid->cost, 1.1 * from_memory->cost + 1e-9);
    driven += hybrid->cost;
    on_lattice += from_memory->cost;
  }
  EXPECT_LE(driven, on_lattice);
  EXPECT_GT(found, static_cast<int>(share_of(20U)));
}

TEST(PrimitivesOfFiles, InMprimDriveTheSameMaps) {
  expect_to_drive_alike(quarter_turns(), set_in_mprim);
}

TEST(PrimitivesOfFiles, InJsonDriveTheSameMaps) {
  expect_to_drive_alike(quarter_turns(), set_in_json);
  expect_to_drive_alike(*MotionPrimitives::turning_circle(kSetRadius), set_in_json);
}

struct SbplSet {
  const char* file;
  bool aside = false;  // does it move in other directions than that of its heading?
};

/// Their headings are multiples of a sixteenth of a turn, and their straight motions lead to vertices a little
/// aside: hybrid_astar cannot drive them exactly, but wherever they lead.
class PrimitivesOfSbpl : public ::testing::TestWithParam<SbplSet> {};

TEST_P(PrimitivesOfSbpl, LeadNowhereThatHybridAStarDoesNotReach) {
  const std::filesystem::path file = data_folder() / "sbpl" / GetParam().file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " does not exist";
  const MotionPrimitives set = *load_primitives(file);
  const double radius = least_radius(set);
  int found = 0;
  for (std::uint64_t seed = 0; seed < share_of(60U); ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Random random(seed);
    const GridMap map = scattered_yard(random, *set.resolution());
    const FreeSpaceOptions robot{.footprint = Footprint::disc(1.2 * *set.resolution())};
    const FreeSpace space = *make_free_space(map, robot);
    const Query query = query_on(random, space, set);
    const auto plan = lattice_plan(map, robot, set, query);
    if (!plan) continue;
    ++found;
    const DriveReport report =
        checked_drive(space, plan->path, query, {.turns_in_place = true, .moves_aside = true});
    EXPECT_EQ(report.fault, "");
    const auto hybrid =
        GetParam().aside ? omni_plan(space, query) : hybrid_plan(space, radius, query);
    EXPECT_TRUE(hybrid) << hybrid.error().message;
  }
  EXPECT_GT(found, static_cast<int>(share_of(20U)));
}

INSTANTIATE_TEST_SUITE_P(Files, PrimitivesOfSbpl,
                         ::testing::Values(SbplSet{"mprim_unicycle_noturninplace.mprim"},
                                           SbplSet{"mprim_pr2_10cm.mprim", true}));

}  // namespace
}  // namespace wend::test
