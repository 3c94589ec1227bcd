// The snippets of the headers of base to robot, of the generators and of the map loader, compiled and
// run as they stand there. snippet_lines_test.cpp looks into the headers for lines that are not here.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/snippets/snippets.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/base/random.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/base/workers.hpp"
#include "wend/generate/generators.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/arc_distance.hpp"
#include "wend/geometry/box.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/geometry/curve.hpp"
#include "wend/geometry/line.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/io/files.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/primitives/load_primitives.hpp"
#include "wend/io/text.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/car_primitives.hpp"
#include "wend/robot/footprint.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/motion_primitives.hpp"
#include "wend/robot/sweep/fits_along.hpp"
#include "wend/robot/sweep/placed_polygon.hpp"
#include "wend/robot/sweep/point_sweep.hpp"
#include "wend/robot/sweep/swept_cells.hpp"
#include "wend/robot/sweep/swept_clearance.hpp"

namespace {

namespace fs = std::filesystem;

using wend::test::OfficeInWorkingFolder;
using wend::test::report;
using wend::test::reported;

int cells_planned_on = 0;
void plan_on(const wend::GridMap& map) { cells_planned_on = static_cast<int>(map.size()); }

TEST(Snippets, OfExpected) {
  wend::Expected<int, std::string> parsed = wend::Unexpected<std::string>("no number");
  if (!parsed) report(parsed.error());
  EXPECT_EQ(reported, "no number");
}

struct WalkOptions {
  std::int64_t max_steps = 100;
  double boldness = 0.5;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"max_steps", "limit on the number of steps"}, self.max_steps, {1, 1e9});
    field({"boldness", "how far it strays"}, self.boldness, {0, 1});
  }
};

TEST(Snippets, OfOptions) {
  const auto options = wend::parse_options<WalkOptions>({{"max_steps", "50"}});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->max_steps, 50);
  EXPECT_EQ(options->boldness, 0.5);
}

TEST(Snippets, OfRandom) {
  wend::Random random(42);
  const int die = 1 + static_cast<int>(random.below(6));
  EXPECT_TRUE(die >= 1 && die <= 6);
}

TEST(Snippets, OfDirectionHeadingCarMoveAndCompass) {
  const wend::Cell next = wend::step({3, 4}, wend::Direction::plus_x);  // (4,4)
  EXPECT_EQ(next, (wend::Cell{4, 4}));
  const wend::Cell ahead = wend::ahead(wend::Heading::minus_y);  // (0,-1)
  EXPECT_EQ(ahead, (wend::Cell{0, -1}));

  const wend::Frame frame{.y_up = true};
  const std::string_view up = wend::name_of(wend::Direction::plus_y, frame);
  const std::string_view north = wend::letter_of(wend::Heading::plus_y, frame);
  EXPECT_EQ(up, "up");
  EXPECT_EQ(north, "N");

  const wend::CornerPose place{{1, 0}, wend::Heading::plus_x};
  const wend::Pose pose = wend::pose_of(place);  // x 1, y 0, heading 0
  EXPECT_EQ(pose, (wend::Pose{1, 0, 0}));

  const wend::CornerPose from{{1, 0}, wend::Heading::plus_x};
  const wend::CornerPose to = wend::moved(from, wend::CarMove::fwd_plus);  // (2,1) facing +y
  EXPECT_EQ(to, (wend::CornerPose{{2, 1}, wend::Heading::plus_y}));
}

TEST(Snippets, OfArc) {
  const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});  // a quarter circle of radius 1
  const wend::Pose middle = wend::pose_on(arc, arc.length / 2);
  EXPECT_NEAR(middle.heading, wend::kPi / 4, 1e-12);
}

TEST(Snippets, OfArcDistance) {
  const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});      // around the centre (0,1)
  const double gap = wend::distance(arc, wend::Cell{1, -1});  // sqrt(2) - 1, at (1,0)
  EXPECT_NEAR(gap, std::sqrt(2) - 1, 1e-12);
}

TEST(Snippets, OfCurve) {
  const wend::Pose from{2, 2, 0};
  const wend::Pose aside{2, 5, 0};
  const wend::CurveCosts costs{.reverse = 2, .gear_change = 0.5};
  const wend::Curve parking = wend::cheapest_reeds_shepp(from, aside, 1, costs);
  const wend::Curve ahead = wend::cheapest_dubins(from, aside, 1);
  std::vector<wend::Pose> poses{from};
  wend::append_poses(parking, from, 1, poses);
  EXPECT_NEAR(wend::distance(poses.back().point(), aside.point()), 0, 1e-9);
  EXPECT_GT(parking.gear_changes(), 0);
  EXPECT_GT(ahead.length(), parking.length());
}

TEST(Snippets, OfTrigonometry) {
  const wend::SineCosine north = wend::sine_and_cosine(wend::kPi / 2);
  const double heading = wend::arc_tangent(1, -1);  // 3/4 pi
  EXPECT_EQ(north.sine, 1);
  EXPECT_NEAR(heading, 0.75 * wend::kPi, 1e-15);
}

TEST(Snippets, OfArcClearance) {
  const wend::FreeSpace space =
      *wend::make_free_space(*wend::make_grid_map(wend::Grid<wend::CellState>(2, 2)),
                             {.footprint = wend::Footprint::disc(0.2)});
  double length = 0;
  const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});  // from corner to corner of cell (0,0)
  if (wend::fits_along(space, arc)) length += arc.length;
  EXPECT_NEAR(length, wend::kPi / 2, 1e-12);
  const double clearance = wend::arc_clearance(space, arc);
  EXPECT_TRUE(std::isinf(clearance));
}

TEST(Snippets, OfSegmentsAndMotionPrimitives) {
  const wend::Segment aside = wend::segment_between({0, 0, 0}, {0, 2, 0});   // 2 to the left
  const wend::Segment turn = wend::segment_between({0, 0, 0}, {0, 0, 1.5});  // in place
  const wend::Pose middle = wend::pose_on(turn, 0.5);                        // heading 0.75
  EXPECT_EQ(aside.length, 2);
  EXPECT_EQ(middle.heading, 0.75);

  const auto robot = wend::MotionPrimitives::turning_circle(4);  // radius of at least 4 cells
  const std::size_t ways =
      robot->leaving(0).size();  // straight, two turns, and the same in reverse
  EXPECT_EQ(ways, 6U);

  const wend::GridMap map = *wend::make_grid_map(wend::Grid<wend::CellState>(8, 8));
  const wend::FreeSpace space = *wend::make_free_space(map);
  const std::vector<wend::Pose> poses{{0.5, 0.5, 0}, {4.5, 0.5, 0}};
  const wend::SweptCells swept(space, poses);
  bool free = false;
  if (wend::fits(space, swept, {3, 7})) free = true;
  EXPECT_TRUE(free);
}

bool load_primitives_and_report(const wend::GridMap& map, const wend::Footprint& robot) {
  const auto load = [&]() -> bool {
    const auto report = [](const std::string& message) { return !message.empty(); };
    const auto primitives = wend::load_primitives("ackermann.json");
    if (!primitives) return report(primitives.error().message);
    const auto space = wend::make_free_space(map, {.footprint = robot, .primitives = *primitives});
    return space->robot().primitives.has_value();
  };
  return load();
}

TEST(Snippets, OfLoadingMotionPrimitives) {
  EXPECT_TRUE(
      load_primitives_and_report(*wend::make_grid_map(wend::Grid<wend::CellState>(2, 2)), {}))
      << "a missing file is reported";
}

TEST(Snippets, OfFootprints) {
  const auto robot = wend::parse_footprint("0.4,0.25; 0.4,-0.25; -0.3,-0.25; -0.3,0.25");
  ASSERT_TRUE(robot);
  if (!robot) return report(robot.error().message);
  const double radius = robot->circumscribed_radius();  // 0.47 m
  EXPECT_NEAR(radius, 0.4717, 1e-4);
  const auto car =
      wend::Footprint::rectangle(4.2, 1.8, 1.35);  // base point between the rear wheels
  EXPECT_EQ(*car, *wend::parse_footprint("rect:4.2x1.8,1.35"));
  const auto box = wend::Polygon::make({{0.4, 0.25}, {-0.3, 0.25}, {-0.3, -0.25}, {0.4, -0.25}});
  ASSERT_TRUE(box);
  if (!box) return report(box.error().message);
  const double gap = wend::distance_to_outline(*box, {0, 0});  // 0.25
  EXPECT_EQ(gap, 0.25);
  const wend::GridMap map = *wend::make_grid_map(wend::Grid<wend::CellState>(4, 4));
  const wend::FreeSpace space = *wend::make_free_space(map, {.footprint = *robot});
  EXPECT_TRUE(space.fits({1.5, 1.5, 0.3}));
}

TEST(Snippets, OfPlacedPolygonsAndBoxes) {
  const double heading = 0;
  const wend::Polygon outline_in_cells = *wend::Polygon::make({{1, 1}, {-1, 1}, {-1, -1}, {1, -1}});
  const wend::PlacedPolygon robot(outline_in_cells, {3.5, 2.5, heading});
  EXPECT_TRUE(robot.overlaps(wend::Cell{4, 2}));
  const wend::Line line{{0.5, 0.5}, {3.5, 0.5}};
  wend::Box box(line.from);
  box.include(line.to);
  EXPECT_EQ(box.high, line.to);
}

TEST(Snippets, OfErrors) {
  const std::string text = "a robot";
  const auto footprint = wend::parse_footprint(text);
  if (!footprint) return report(footprint.error().message);
  FAIL();
}

TEST(Snippets, OfObstacles) {
  const wend::GridMap map = *wend::make_grid_map(wend::Grid<wend::CellState>(4, 4));
  const wend::Obstacles obstacles(map, {.unknown = wend::UnknownPolicy::free});
  const wend::FreeSpace small =
      *wend::make_free_space(obstacles, {.footprint = wend::Footprint::disc(0.2)});
  const wend::FreeSpace large =
      *wend::make_free_space(obstacles, {.footprint = wend::Footprint::disc(0.5)});
  EXPECT_EQ(&small.squared_half_cell_clearance(), &large.squared_half_cell_clearance());
}

TEST(Snippets, OfLineAndPointSweep) {
  const wend::Line line{{0.5, 0.5}, {3.5, 0.5}};
  const double gap = wend::distance(line, wend::Cell{2, 2});  // 1.5
  EXPECT_EQ(gap, 1.5);

  wend::Grid<wend::CellState> cells(4, 2, wend::CellState::free);
  cells[{2, 0}] = cells[{2, 1}] = wend::CellState::occupied;
  const wend::FreeSpace space = *wend::make_free_space(*wend::make_grid_map(cells));
  wend::PointSweep sweep(space, {0.5, 0.5});
  if (!sweep.go_to({3.5, 1.5})) report("blocked");
  EXPECT_EQ(reported, "blocked");
}

TEST(Snippets, OfEdits) {
  const wend::GridMap map =
      *wend::make_grid_map(wend::Grid<wend::CellState>(20, 10, wend::CellState::free));
  const wend::CellBox edited{{3, 4}, {5, 6}};  // four cells
  const wend::CellBox reached = edited.grown_by(10).clipped_to(map);
  EXPECT_EQ(reached, (wend::CellBox{{0, 0}, {15, 10}}));

  wend::FreeSpace space = *wend::make_free_space(map);
  wend::Grid<wend::CellState> door(3, 1, wend::CellState::occupied);
  const auto change = space.edit({.corner = {12, 7}, .states = door});
  if (!change) return report(change.error().message);
  EXPECT_EQ(change->boxes, (std::vector<wend::CellBox>{{{12, 7}, {15, 8}}}));
}

TEST(Snippets, OfMapsRowByRow) {
  wend::GridMapBuilder rows(2);
  rows.append(std::array{wend::CellState::free, wend::CellState::occupied});
  const auto map = std::move(rows).finish();
  ASSERT_TRUE(map);
  EXPECT_EQ(map->state({1, 0}), wend::CellState::occupied);
}

wend::Expected<wend::GridMap, wend::Error> map_with_an_obstacle() {
  wend::Grid<wend::CellState> cells(20, 10, wend::CellState::free);
  cells[{3, 4}] = wend::CellState::occupied;
  const auto map = wend::make_grid_map(cells);
  return map;
}

void make_map() {
  const auto map = map_with_an_obstacle();
  if (!map) return report(map.error().message);
  report("a map");
}

TEST(Snippets, OfMapsAndFreeSpace) {
  make_map();
  EXPECT_EQ(reported, "a map");
  const wend::GridMap map = *map_with_an_obstacle();
  const auto robot = wend::parse_footprint("0.4,0.25; 0.4,-0.25; -0.3,-0.25; -0.3,0.25");
  const auto space = wend::make_free_space(map, {.footprint = *robot});
  if (const auto reason = space->why_blocked(wend::Cell{3, 4})) report(wend::describe(*reason));
  EXPECT_EQ(reported, "an obstacle");

  const wend::Obstacles obstacles(map, {.unknown = wend::UnknownPolicy::free});
  const auto small = wend::make_free_space(obstacles, {.footprint = wend::Footprint::disc(0.2)});
  const auto large = wend::make_free_space(obstacles, {.footprint = wend::Footprint::disc(0.5)});
  EXPECT_EQ(&small->obstacles().blocked(), &large->obstacles().blocked());
}

void generate() {
  const auto map = wend::make_map("maze", 41, 21, 7, {{"corridor_width", "1"}});
  if (!map) report(map.error().message);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->width(), 41);
}

TEST(Snippets, OfGenerators) { generate(); }

void load() {
  const auto loaded = wend::load_map("office.yaml");
  if (!loaded) return report(loaded.error().message);
  plan_on(loaded->map);
}

TEST(Snippets, OfLoadMap) {
  const OfficeInWorkingFolder office;
  load();
  EXPECT_EQ(cells_planned_on, 12);
}

TEST(Snippets, OfWorkersAndThreadTime) {
  std::vector<int> squares(100);
  wend::OneWorker().run(squares.size(), [&](std::size_t task, unsigned /*worker*/) {
    squares[task] = static_cast<int>(task * task);
  });
  EXPECT_EQ(squares.back(), 99 * 99);

  const auto planner = wend::make_planner("astar", wend::test::open_ground()).value();
  const wend::Query query = wend::Query::between({1, 1}, {8, 5});
  wend::Plan plan;
  const wend::Clock clock = wend::thread_cpu_seconds;
  const double first = wend::seconds_of(clock, [&] { planner->plan(query, plan); });
  const double later = wend::least_seconds(clock, [&] { planner->plan(query, plan); });
  EXPECT_GE(first, 0);
  EXPECT_GE(later, 0);
}

TEST(Snippets, OfEveryCell) {
  const wend::Grid<int> grid(4, 3, 2);
  int sum = 0;
  for (const wend::Cell cell : wend::every_cell(grid)) sum += grid[cell];
  EXPECT_EQ(sum, 24);
}

TEST(Snippets, OfLines) {
  using wend::LineReader;
  const std::string_view text = "one\r\ntwo\n";
  std::vector<std::string> read;
  LineReader lines(text);
  while (const auto line = lines.next()) read.emplace_back(*line);
  EXPECT_EQ(read, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(lines.number(), 2);
}

void plan_on_named(const std::string& name) {
  if (wend::is_stream(name)) {
    const auto bytes = wend::read_stream(name);
    if (!bytes) return report(bytes.error().message);
    const auto map = wend::parse_map(*bytes, wend::stream_name(name));
    if (map) plan_on(map->map);
  }
}

TEST(Snippets, OfStreams) {
  const OfficeInWorkingFolder office;
  const fs::path pipe = fs::current_path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "..#\n...\n"; });
  cells_planned_on = 0;
  plan_on_named(pipe);
  writer.join();
  EXPECT_EQ(cells_planned_on, 6);
}

}  // namespace
