// The snippets of the public headers, compiled and run as they stand there. The last tests look into
// those headers for lines that are not here, and compare README.md with the example that it shows.

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "bench/comparison/comparison_run.hpp"
#include "bench/database/bench_database.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/analysis/layer.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/analysis/search_recorder.hpp"
#include "wend/analysis/widest_path.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/base/random.hpp"
#include "wend/control/follower.hpp"
#include "wend/control/nearest_ahead.hpp"
#include "wend/control/pid.hpp"
#include "wend/control/simulation.hpp"
#include "wend/control/speed_profile.hpp"
#include "wend/generate/generators.hpp"
#include "wend/geometry/arc.hpp"
#include "wend/geometry/arc_distance.hpp"
#include "wend/geometry/box.hpp"
#include "wend/geometry/car_move.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/geometry/line.hpp"
#include "wend/io/files.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/path/curvature_smoother.hpp"
#include "wend/path/gradient_smoother.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/refinement.hpp"
#include "wend/path/simplification.hpp"
#include "wend/path/smoother.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/animation/gif.hpp"
#include "wend/render/picture/drawing.hpp"
#include "wend/render/picture/panels.hpp"
#include "wend/render/terminal/terminal_picture.hpp"
#include "wend/render/terminal/text_picture.hpp"
#include "wend/report/path_report.hpp"
#include "wend/report/posthoc_trace.hpp"
#include "wend/robot/fits_along.hpp"
#include "wend/robot/footprint.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/robot/placed_polygon.hpp"
#include "wend/robot/point_sweep.hpp"
#include "wend/robot/swept_clearance.hpp"

namespace {

namespace fs = std::filesystem;

const fs::path kSource = WEND_SOURCE_DIR;

// What the snippets call.
std::string reported;
void report(std::string_view what) { reported = what; }
int cells_planned_on = 0;
void plan_on(const wend::GridMap& map) { cells_planned_on = static_cast<int>(map.size()); }

/// A map file in a folder of its own, which is the working folder while this lives.
class OfficeInWorkingFolder {
 public:
  OfficeInWorkingFolder() {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "office.yaml")
        << "image: office.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\n"
           "occupied_thresh: 0.65\nfree_thresh: 0.25\n";
    std::ofstream(folder_ / "office.pgm") << "P2 4 3 255\n"
                                             "254 254 254 254\n254 0 0 254\n254 254 254 254\n";
    fs::current_path(folder_);
  }
  ~OfficeInWorkingFolder() {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }
  OfficeInWorkingFolder(const OfficeInWorkingFolder&) = delete;
  OfficeInWorkingFolder& operator=(const OfficeInWorkingFolder&) = delete;

 private:
  fs::path before_ = fs::current_path();
  fs::path folder_ = fs::path(::testing::TempDir()) / ("wend_snippets_" + std::to_string(getpid()));
};

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

TEST(Snippets, OfArcClearance) {
  const wend::FreeSpace space(wend::GridMap(wend::Grid<wend::CellState>(2, 2)),
                              {.footprint = wend::Footprint::disc(0.2)});
  double length = 0;
  const wend::Arc arc = wend::arc_to({0, 0, 0}, {1, 1});  // from corner to corner of cell (0,0)
  if (wend::fits_along(space, arc)) length += arc.length;
  EXPECT_NEAR(length, wend::kPi / 2, 1e-12);
  const double clearance = wend::arc_clearance(space, arc);
  EXPECT_TRUE(std::isinf(clearance));
}

TEST(Snippets, OfFootprints) {
  const auto robot = wend::parse_footprint("0.4,0.25; 0.4,-0.25; -0.3,-0.25; -0.3,0.25");
  if (!robot) return report(robot.error().message);
  const double radius = robot->circumscribed_radius();  // 0.47 m
  EXPECT_NEAR(radius, 0.4717, 1e-4);
  const auto box = wend::Polygon::make({{0.4, 0.25}, {-0.3, 0.25}, {-0.3, -0.25}, {0.4, -0.25}});
  if (!box) return report(box.error().message);
  const double gap = wend::distance_to_outline(*box, {0, 0});  // 0.25
  EXPECT_EQ(gap, 0.25);
  const wend::GridMap map(wend::Grid<wend::CellState>(4, 4));
  const wend::FreeSpace space(map, {.footprint = *robot});
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
  const wend::GridMap map(wend::Grid<wend::CellState>(4, 4));
  const wend::Obstacles obstacles(map, {.unknown = wend::UnknownPolicy::free});
  const wend::FreeSpace small(obstacles, {.footprint = wend::Footprint::disc(0.2)});
  const wend::FreeSpace large(obstacles, {.footprint = wend::Footprint::disc(0.5)});
  EXPECT_EQ(&small.squared_half_cell_clearance(), &large.squared_half_cell_clearance());
}

TEST(Snippets, OfLineAndPointSweep) {
  const wend::Line line{{0.5, 0.5}, {3.5, 0.5}};
  const double gap = wend::distance(line, wend::Cell{2, 2});  // 1.5
  EXPECT_EQ(gap, 1.5);

  wend::Grid<wend::CellState> cells(4, 2, wend::CellState::free);
  cells[{2, 0}] = cells[{2, 1}] = wend::CellState::occupied;
  const wend::FreeSpace space{wend::GridMap(cells)};
  wend::PointSweep sweep(space, {0.5, 0.5});
  if (!sweep.go_to({3.5, 1.5})) report("blocked");
  EXPECT_EQ(reported, "blocked");
}

TEST(Snippets, OfSmoothingAndSimplification) {
  wend::Grid<wend::CellState> cells(20, 10, wend::CellState::free);
  for (int y = 0; y < 8; ++y) cells[{10, y}] = wend::CellState::occupied;
  const wend::FreeSpace space(wend::GridMap(cells), {.footprint = wend::Footprint::disc(0.4)});
  const auto planner = wend::make_planner("astar", space);
  const auto plan = (*planner)->plan(wend::Query::between({2, 2}, {17, 2}));
  reported.clear();
  {
    const wend::SmootherInfo* gradient = wend::smoothers().find("gradient");
    const auto smoothed = gradient->smooth(plan->path, space, {{"beta", "0.4"}});
    if (!smoothed) report(smoothed.error().message());
    EXPECT_TRUE(smoothed);
  }
  {
    const auto smoothed = wend::smooth_by_gradient(plan->path, space, {.beta = 0.4});
    EXPECT_TRUE(smoothed);
    const wend::Path& path = smoothed->path;
    if (const auto collision = wend::first_collision(path, space)) {
      report(wend::describe(collision->kind));
    }
  }
  const auto drivable = wend::smooth_by_curvature(plan->path, space, {.radius = 4});
  if (drivable && !drivable->within_bound) report("too tight");
  EXPECT_TRUE(drivable);
  EXPECT_TRUE(reported.empty()) << reported;

  const wend::Path fewer = wend::without_collinear(plan->path);
  const wend::Path taut = wend::string_pulled(plan->path, space);
  EXPECT_LT(fewer.size(), plan->path.size());
  EXPECT_LE(taut.length(), fewer.length());
  const auto refined = wend::refined(plan->path, space,
                                     {.simplify = wend::Simplification{wend::SimplifyBy::sight},
                                      .smoother = wend::SmootherChoice{"gradient"}});
  EXPECT_TRUE(refined);
}

TEST(Snippets, OfMapsRowByRow) {
  wend::GridMapBuilder rows(2);
  rows.append(std::array{wend::CellState::free, wend::CellState::occupied});
  const wend::GridMap map = std::move(rows).finish();
  EXPECT_EQ(map.state({1, 0}), wend::CellState::occupied);
}

TEST(Snippets, OfMapsAndFreeSpace) {
  wend::Grid<wend::CellState> cells(20, 10, wend::CellState::free);
  cells[{3, 4}] = wend::CellState::occupied;
  const wend::GridMap map(cells);

  const wend::FreeSpace space(map, {.footprint = wend::Footprint::disc(0.2)});
  if (const auto reason = space.why_blocked(wend::Cell{3, 4})) report(wend::describe(*reason));
  EXPECT_EQ(reported, "an obstacle");
}

void generate() {
  const wend::GeneratorInfo* maze = wend::generators().find("maze");
  const auto map = maze->make(41, 21, 7, {{"corridor_width", "1"}});
  if (!map) report(map.error().message());
  ASSERT_TRUE(map);
  EXPECT_EQ(map->width(), 41);
}

TEST(Snippets, OfGenerators) { generate(); }

void load() {
  const auto loaded = wend::load_map("office.yaml");
  if (!loaded) return report(loaded.error().message());
  plan_on(loaded->map);
}

TEST(Snippets, OfLoadMap) {
  const OfficeInWorkingFolder office;
  load();
  EXPECT_EQ(cells_planned_on, 12);
}

void make_planner_and_plan(const wend::FreeSpace& space) {
  auto planner = wend::make_planner("astar", space, {{"weight", "1.5"}});
  if (!planner) return report(planner.error().message());
  const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
  if (!plan) return report(plan.error().reason);
  EXPECT_EQ(plan->path.cells().back(), (wend::Cell{8, 5}));
}

const wend::FreeSpace& open_space() {
  static const wend::FreeSpace space(
      wend::GridMap(wend::Grid<wend::CellState>(10, 8, wend::CellState::free)));
  return space;
}

TEST(Snippets, OfPath) {
  const auto astar = wend::make_planner("astar", open_space());
  const auto plan = (*astar)->plan(wend::Query::between({1, 1}, {8, 5}));
  std::vector<wend::Cell> cells;
  for (const wend::Cell cell : plan->path.cells()) cells.push_back(cell);
  EXPECT_EQ(cells.size(), plan->path.size());

  double length = 0;
  const wend::Path path = wend::Path::through({{0, 0, 0}, {1, 1, wend::kPi / 2}});
  for (const wend::Arc& arc : path.arcs()) length += arc.length;
  EXPECT_NEAR(length, wend::kPi / 2, 1e-12);
}

TEST(Snippets, OfPlanner) {
  reported.clear();
  make_planner_and_plan(open_space());
  EXPECT_EQ(reported, "");
}

TEST(Snippets, OfAPlannerInSteps) {
  const auto made = wend::make_planner("astar", open_space());
  wend::Planner& planner = **made;
  const wend::Query query = wend::Query::between({1, 1}, {8, 5});
  wend::Plan plan;
  auto outcome = planner.begin(query, plan);
  while (!outcome) outcome = planner.step(plan);
  EXPECT_EQ(*outcome, wend::Status::found);
}

TEST(Snippets, OfOpenList) {
  const auto made = wend::make_planner("astar", open_space());
  wend::Planner& planner = **made;
  wend::SearchRecorder recorder(open_space());
  wend::Query query = wend::Query::between({1, 1}, {8, 5});
  query.observer = &recorder;
  wend::Plan plan;
  std::vector<wend::Cell> order;
  auto outcome = planner.begin(query, plan);
  while (!outcome) {
    const wend::OpenList open = planner.open_list(10);
    order.push_back(open.entries.front().state.cell);  // the one that step() expands now
    outcome = planner.step(plan);
  }
  EXPECT_EQ(order, recorder.expansions());
}

TEST(Snippets, OfCostToGo) {
  const wend::FreeSpace& space = open_space();
  const wend::Cell goal{8, 5};
  const wend::Cell start{1, 1};
  const auto field = wend::CostToGo::make(space, std::array{goal});
  if (const auto path = field->path_from(start)) report("there is a path");
  EXPECT_EQ(reported, "there is a path");
}

TEST(Snippets, OfSearchRecorder) {
  const wend::FreeSpace& space = open_space();
  const auto made = wend::make_planner("astar", space);
  wend::Planner& planner = **made;
  wend::SearchRecorder recorder(space);
  wend::Query query = wend::Query::between({1, 1}, {8, 5});
  query.observer = &recorder;
  const auto plan = planner.plan(query);
  const std::uint32_t first = recorder.layers().expansion[{1, 1}];  // 1: the start
  EXPECT_TRUE(plan);
  EXPECT_EQ(first, 1U);
  wend::SearchRecorder driven(space, 1);
  EXPECT_TRUE(driven.expansions().empty());
}

TEST(Snippets, OfLayer) {
  const wend::FreeSpace& space = open_space();
  const auto made = wend::make_planner("astar", space);
  wend::Planner& planner = **made;
  wend::SearchRecorder recorder(space);
  wend::Query query = wend::Query::between({1, 1}, {8, 5});
  query.observer = &recorder;
  ASSERT_TRUE(planner.plan(query));
  const wend::Layer order = wend::search_layer(wend::LayerKind::expansion, planner, recorder);
  const double first = order.numbers[{1, 1}];  // 1: the start
  EXPECT_EQ(first, 1);
}

TEST(Snippets, OfScene) {
  const wend::FreeSpace& space = open_space();
  const auto planner = wend::make_planner("astar", space);
  const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
  wend::Scene scene{.space = space};
  scene.path = plan->path;
  scene.start = wend::centre_of({1, 1});
  scene.goals = {wend::centre_of({8, 5})};
  wend::BitGrid cells(space.width(), space.height());
  cells.set({1, 1}, true);
  scene.marked = {{wend::CellRole::expanded, cells}};
  scene.heatmap = {"order of expansion", wend::Grid<double>(space.width(), space.height(), 0)};
  std::cout << wend::text_picture(scene);
  const auto svg = wend::draw_svg(scene, wend::style_of(wend::StyleName::dark));
  EXPECT_TRUE(svg);
}

TEST(Snippets, OfSceneOfADrive) {
  const wend::FreeSpace& space = open_space();
  const auto planner = wend::make_planner("astar", space);
  const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
  const wend::Path smoothed = wend::smooth_by_gradient(plan->path, space)->path;
  wend::Scene scene{.space = space};
  scene.lines = {{wend::LineRole::planned, plan->path.points()},
                 {wend::LineRole::smoothed, smoothed.points()}};
  EXPECT_EQ(scene.lines.size(), 2U);
}

TEST(Snippets, OfSceneOfACar) {
  const wend::FreeSpace& space = open_space();
  wend::Scene yard{.space = space};
  yard.path = wend::Path::through({{0, 0, 0}, {1, 1, wend::kPi / 2}});
  yard.start = yard.path.poses().front();
  yard.unit = 1;
  EXPECT_EQ(yard.start->point, (wend::Point{0, 0}));
  EXPECT_EQ(yard.start->heading, 0);
}

TEST(Snippets, OfDrawing) {
  const OfficeInWorkingFolder office;
  const wend::Scene scene{.space = open_space()};
  const auto png = wend::draw_png(scene);
  if (png) wend::write_file("plan.png", *png);
  EXPECT_TRUE(fs::exists("plan.png"));
}

TEST(Snippets, OfTerminalPicture) {
  const wend::Scene scene{.space = open_space()};
  const bool is_terminal = isatty(STDOUT_FILENO) == 1;
  wend::Terminal terminal;  // plain ASCII
  if (is_terminal) terminal = wend::detect_terminal(environ);
  std::cout << wend::terminal_picture(scene, 80, 24, terminal);
  std::cout << wend::terminal_legend(scene, 80, terminal);
}

TEST(Snippets, OfPanels) {
  const wend::Scene with_astar{.space = open_space()};
  const wend::Scene with_dijkstra{.space = open_space()};
  const std::vector<wend::Panel> panels{{"A*", with_astar, "412 cells expanded"},
                                        {"Dijkstra", with_dijkstra, "8321 cells expanded"}};
  const auto svg = wend::draw_panels(panels, wend::PictureKind::svg);
  EXPECT_TRUE(svg);
}

TEST(Snippets, OfGif) {
  const int width = 3;
  const int height = 2;
  const std::array frames{wend::Grid<std::uint32_t>(width, height, 0xFFFFFF),
                          wend::Grid<std::uint32_t>(width, height, 0x0072B2)};
  wend::GifAnimation animation(width, height, wend::palette_of(frames));
  for (const auto& frame : frames) animation.add(frame, 10);
  const auto bytes = animation.finish();
  EXPECT_TRUE(bytes && bytes->starts_with("GIF89a"));
}

TEST(Snippets, OfPosthocTrace) {
  const wend::FreeSpace& space = open_space();
  const wend::Cell start{1, 1};
  const std::array goals{wend::Cell{8, 5}};
  const auto made = wend::make_planner("astar", space);
  wend::Planner& planner = **made;
  wend::Query query = wend::Query::between(start, goals.front());
  wend::Plan plan;
  wend::PosthocTrace trace(space, start, goals, wend::TraceForm::yaml, 100'000);
  query.observer = &trace;
  planner.plan(query, plan);
  const std::string text = trace.finish(plan.path);
  EXPECT_NE(text.find("type: end"), std::string::npos);
  wend::PosthocTrace driven(space, query, 1, wend::TraceForm::json, 100'000);
  EXPECT_NE(driven.finish({}).find("heading"), std::string::npos);
}

void report_width(double radius) { reported = radius == 0.5 ? "half a cell" : "another width"; }
void suggest(const wend::Way& way) {
  reported = way.smaller_robot ? "a smaller robot" : "something else";
}

TEST(Snippets, OfIndexSupport) {
  const wend::FreeSpace space{wend::GridMap(wend::Grid<wend::CellState>(4, 3))};
  reported.clear();
  const wend::PlannerInfo& info = *wend::planners().find("hub_labels");
  const auto index = info.index_support->build(space, {});
  if (!index) report(index.error().message());
  const auto planner = info.index_support->make_planner(space, {}, *index);
  EXPECT_EQ(reported, "");
  EXPECT_TRUE(planner);
}

TEST(Snippets, OfWidestPathAndNoPath) {
  wend::Grid<wend::CellState> cells(5, 3, wend::CellState::free);
  cells[{2, 0}] = cells[{2, 2}] = wend::CellState::occupied;
  const wend::FreeSpace space(wend::GridMap(cells), {.footprint = wend::Footprint::disc(0.75)});
  const wend::Cell start{0, 1};
  const wend::Cell goal{4, 1};
  if (const auto widest = wend::widest_path(space, start, goal)) report_width(widest->radius);
  EXPECT_EQ(reported, "half a cell");

  const wend::NoPath why = wend::explain_no_path(space, start, goal);
  for (const wend::Way& way : why.ways) suggest(way);
  EXPECT_EQ(reported, "a smaller robot");
}

std::string compare(const wend::FreeSpace& space, const wend::Clock& clock) {
  const auto report = [](const std::string& what) { return what; };
  auto run = wend::ComparisonRun::make(space, *wend::parse_planner_specs("astar,bfs"), clock);
  if (!run) return report(run.error().message());
  for (const wend::CellPair& cells : wend::random_pairs(space, 100, 7)) run->answer(cells);
  const std::string table = wend::comparison_table(run->comparison());
  return table;
}

TEST(Snippets, OfComparisonRun) {
  const wend::Clock clock = [seconds = 0.0]() mutable { return ++seconds; };
  EXPECT_NE(compare(open_space(), clock).find("100 queries"), std::string::npos);
}

std::string keep(const std::vector<wend::BenchAnswer>& answers) {
  const auto report = [](const std::string& what) { return what; };
  auto database = wend::BenchDatabase::open("bench.db");
  if (!database) return report(database.error().message());
  const auto experiment = database->experiment({.map = "arena", .version = "wend 0.1.0"});
  const auto planner = database->planner("astar:weight=2");
  if (!experiment || !planner) return report("bench.db cannot be written");
  const auto stored = database->store(*experiment, *planner, answers);
  return stored ? "stored" : stored.error().message();
}

TEST(Snippets, OfBenchDatabase) {
  const OfficeInWorkingFolder folder;
  EXPECT_EQ(keep({{.line = 2, .seconds = {1e-6}}}), "stored");
  EXPECT_EQ(keep({{.line = 3, .seconds = {1e-6}}}), "stored");
}

TEST(Snippets, OfPathReport) {
  const wend::FreeSpace space = open_space();
  const auto planner = wend::make_planner("astar", space);
  const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
  const auto refined =
      wend::refined(plan->path, space, {.smoother = wend::SmootherChoice{"gradient"}});
  const std::vector<wend::MeasuredPath> paths{wend::measured("planned", plan->path, space),
                                              wend::measured("smoothed", refined->path, space)};
  std::cout << wend::metrics_table(paths, wend::metres_of(space.map().frame()));
  EXPECT_LT(paths[1].metrics.length, paths[0].metrics.length);
}

TEST(Snippets, OfPolylineAndNearestAhead) {
  const wend::Polyline line({{0, 0}, {3, 0}, {3, 4}});
  const wend::Pose middle = line.at(5);                                     // (3,2), heading up y
  const wend::OnPolyline nearest = line.nearest({2, 1}, 0, line.length());  // (2,0), 2 along
  EXPECT_EQ(middle, (wend::Pose{3, 2, wend::kPi / 2}));
  EXPECT_EQ(nearest.along, 2);

  const wend::Polyline there_and_back({{0, 0}, {9, 0}, {0, 0}});
  const wend::OnPolyline there = wend::nearest_ahead(there_and_back, {4, 0, 0}, {0, 18, 1});
  EXPECT_EQ(there.along, 4);
}

TEST(Snippets, OfCornerRoundingAndSpeedProfile) {
  const wend::Corner corner({0, 0}, {1, 0}, {1, 1});
  const double radius = corner.radius(0.1);  // 0.24: 0.1 / (sqrt(2) - 1)
  EXPECT_NEAR(radius, 0.24, 0.002);

  const wend::Polyline line({{0, 0}, {3, 0}, {3, 4}});
  const double along = 1;
  const wend::SpeedProfile profile(line, {.lateral_acceleration = 1, .window = 0.2});
  const double fastest = profile.at(along);
  EXPECT_EQ(fastest, wend::VelocityLimits{}.speed);
}

TEST(Snippets, OfMotionModelAndPidTerm) {
  wend::RobotState robot{{0, 0, 0}};
  const wend::Step step = wend::drive(wend::MotionModel{}, robot, {0.3, 0.1}, 0.05);
  robot = step.to;
  EXPECT_EQ(robot.velocity.linear, 0.05) << "as fast as the acceleration allows";

  const double error = 0.2;
  const double change = 0;
  wend::PidTerm heading({.proportional = 3, .integral = 0.2, .derivative = 0.1}, 0.1);
  const double turn_rate = heading.output(error, change, 0.05, 1.5);
  EXPECT_NEAR(turn_rate, 3 * 0.2 + 0.2 * 0.2 * 0.05, 1e-12);
}

struct WheeledRobot {
  void go(const wend::Velocity& velocity) { told = velocity; }
  wend::Velocity told{};
};

TEST(Snippets, OfControllerRouteAndFollower) {
  const wend::ControllerInfo* info = wend::controllers().find("pure_pursuit");
  const auto made = [&] {
    const auto controller = info->make({{"lookahead", "0.5"}});
    if (!controller) report(controller.error().message());
    return controller.has_value();
  };
  EXPECT_TRUE(made());

  const wend::FreeSpace& space = open_space();
  const auto plan =
      wend::make_planner("astar", space).value()->plan(wend::Query::between({1, 1}, {8, 5}));
  ASSERT_TRUE(plan);
  double metres = 0;
  const wend::Route route(plan->path, space.map().frame());
  for (const wend::RouteLeg& leg : route.legs()) metres += leg.line.length();
  EXPECT_EQ(metres, route.length());

  const wend::Path& path = plan->path;
  const wend::Frame& frame = space.map().frame();
  const auto controller = info->make({}).value();
  const wend::Pose pose = route.start();
  WheeledRobot robot;
  wend::Follower follower(*controller);  // the controller outlives it
  follower.follow(wend::Route(path, frame));
  const wend::FollowerStep step = follower.step(pose, 0.05);
  if (step.state == wend::FollowerState::driving) robot.go(step.command);
  EXPECT_GT(robot.told.linear, 0);
}

TEST(Snippets, OfRemainingAndSimulation) {
  const wend::FreeSpace& space = open_space();
  const auto plan =
      wend::make_planner("astar", space).value()->plan(wend::Query::between({1, 1}, {8, 5}));
  ASSERT_TRUE(plan);
  const wend::Path& path = plan->path;
  const wend::Pose pose{3, 2, 0};
  double driven_so_far = 0;
  const wend::Remaining rest = wend::remaining(path, pose, driven_so_far);
  driven_so_far = rest.along;
  EXPECT_NEAR(rest.path.length(), path.length() - driven_so_far, 1e-9);

  reported = "";
  auto controller = wend::controllers().find("pid")->make({});
  const wend::Drive drive = wend::simulate(space, plan->path, **controller, {}, {.seed = 7});
  if (drive.outcome != wend::DriveOutcome::reached) report(wend::describe(drive.outcome));
  EXPECT_EQ(reported, "");
}

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A line without what surrounds its code: blanks and, in headers, the comment's slashes.
std::string_view code_of(std::string_view line) {
  const std::size_t first = line.find_first_not_of("/ \t");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

std::set<std::string, std::less<>> lines_of_code(const fs::path& file) {
  std::set<std::string, std::less<>> lines;
  std::istringstream text(text_of(file));
  for (std::string line; std::getline(text, line);) lines.emplace(code_of(line));
  return lines;
}

bool is_statement(std::string_view code) {
  return !code.empty() && (code.back() == ';' || code.back() == '{') &&
         code.find("...") == std::string_view::npos;
}

/// Complains about every line of a snippet that does not stand in this file.
void expect_here(const fs::path& file, std::string_view code) {
  static const auto here = lines_of_code(kSource / "tests" / "snippets_test.cpp");
  if (is_statement(code) && here.count(code) == 0) {
    ADD_FAILURE() << file << " shows a line that is not compiled here:\n  " << code;
  }
}

TEST(Snippets, OfHeadersStandHere) {
  for (const std::string_view header : {"base/expected.hpp",
                                        "base/options.hpp",
                                        "base/random.hpp",
                                        "map/grid_map.hpp",
                                        "robot/free_space.hpp",
                                        "generate/generators.hpp",
                                        "geometry/direction.hpp",
                                        "geometry/compass.hpp",
                                        "geometry/car_move.hpp",
                                        "geometry/arc.hpp",
                                        "geometry/arc_distance.hpp",
                                        "robot/swept_clearance.hpp",
                                        "path/path.hpp",
                                        "path/polyline.hpp",
                                        "path/path_collision.hpp",
                                        "path/simplification.hpp",
                                        "path/path_metrics.hpp",
                                        "path/smoother.hpp",
                                        "path/gradient_smoother.hpp",
                                        "path/curvature_smoother.hpp",
                                        "path/refinement.hpp",
                                        "geometry/line.hpp",
                                        "robot/point_sweep.hpp",
                                        "control/motion_model.hpp",
                                        "control/pid.hpp",
                                        "control/controller.hpp",
                                        "control/route.hpp",
                                        "control/nearest_ahead.hpp",
                                        "control/follower.hpp",
                                        "control/simulation.hpp",
                                        "control/speed_profile.hpp",
                                        "io/map/load_map.hpp",
                                        "planner/planner.hpp",
                                        "analysis/cost_to_go.hpp",
                                        "planner/index_support.hpp",
                                        "analysis/search_recorder.hpp",
                                        "analysis/layer.hpp",
                                        "planner/observer.hpp",
                                        "report/posthoc_trace.hpp",
                                        "render/animation/gif.hpp",
                                        "render/scene.hpp",
                                        "render/style.hpp",
                                        "render/picture/drawing.hpp",
                                        "render/terminal/terminal_picture.hpp",
                                        "render/picture/panels.hpp",
                                        "analysis/widest_path.hpp",
                                        "analysis/no_path.hpp",
                                        "bench/comparison/comparison_run.hpp",
                                        "bench/database/bench_database.hpp"}) {
    std::istringstream text(
        text_of((header.starts_with("bench/") ? kSource : kSource / "wend") / header));
    int lines = 0;
    for (std::string line; std::getline(text, line);) {
      const bool in_comment = line.find("//   ") < line.find_first_not_of(" /");
      if (!in_comment) continue;
      ++lines;
      expect_here(header, code_of(line));
    }
    EXPECT_GT(lines, 0) << header << " shows no snippet";
  }
}

TEST(Snippets, OfReadmeIsTheExample) {
  const std::string readme = text_of(kSource / "README.md");
  const std::string example = text_of(kSource / "examples" / "plan_path.cpp");
  ASSERT_FALSE(example.empty());
  EXPECT_NE(readme.find("```cpp\n" + example + "```\n"), std::string::npos)
      << "README.md does not show examples/plan_path.cpp as it stands";
}

}  // namespace
