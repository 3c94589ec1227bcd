// The snippets of the headers of paths, planners, analysis, pictures, reports and benchmarks, compiled and
// run as they stand there.

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bench/comparison/comparison_run.hpp"
#include "bench/comparison/timed_planner.hpp"
#include "bench/database/bench_database.hpp"
#include "bench/database/sqlite.hpp"
#include "bench/scenario/scenario_queries.hpp"
#include "tests/snippets/snippets.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/analysis/layer.hpp"
#include "wend/analysis/no_drive.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/analysis/search_recorder.hpp"
#include "wend/analysis/widest_path.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/options.hpp"
#include "wend/base/random.hpp"
#include "wend/io/files.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/path/dense_poses.hpp"
#include "wend/path/exact_ends.hpp"
#include "wend/path/outline_poses.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/path/path_metrics.hpp"
#include "wend/path/refinement.hpp"
#include "wend/path/smoothing/curvature_smoother.hpp"
#include "wend/path/smoothing/drive_smoother.hpp"
#include "wend/path/smoothing/gradient_smoother.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/path/smoothing/smoother.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/animation/film_canvas.hpp"
#include "wend/render/animation/gif.hpp"
#include "wend/render/animation/lzw_encoder.hpp"
#include "wend/render/picture/drawing.hpp"
#include "wend/render/picture/panels.hpp"
#include "wend/render/terminal/terminal_picture.hpp"
#include "wend/render/terminal/text_picture.hpp"
#include "wend/report/path_report.hpp"
#include "wend/report/posthoc_trace.hpp"
#include "wend/report/text_table.hpp"
#include "wend/robot/near_map.hpp"
#include "wend/robot/repeated_moves.hpp"
#include "wend/session/plan_request.hpp"

namespace {

namespace fs = std::filesystem;

using wend::test::OfficeInWorkingFolder;
using wend::test::open_ground;
using wend::test::report;
using wend::test::reported;

TEST(Snippets, OfSmoothingAndSimplification) {
  wend::Grid<wend::CellState> cells(20, 10, wend::CellState::free);
  for (int y = 0; y < 8; ++y) cells[{10, y}] = wend::CellState::occupied;
  const wend::FreeSpace space = *wend::make_free_space(*wend::make_grid_map(cells),
                                                       {.footprint = wend::Footprint::disc(0.4)});
  const auto planner = wend::make_planner("astar", space);
  const auto plan = (*planner)->plan(wend::Query::between({2, 2}, {17, 2}));
  reported.clear();
  {
    const auto smoother = wend::make_smoother("gradient", {{"beta", "0.4"}});
    if (!smoother) return report(smoother.error().message);
    const auto smoothed = (*smoother)(plan->path, space);
    if (!smoothed) report(smoothed.error().message);
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
  [&, plan = std::make_unique<wend::Plan>()] {
    plan->path = wend::Path::through({{1.5, 0.5, 0}, {2, 0.5, 0}});
    const auto smoothed = wend::smooth_drive(plan->path, space, {.turning_radius = 0.4});
    if (!smoothed) return report(smoothed.error().message);
    EXPECT_EQ(smoothed->path, plan->path) << "a line";
  }();
  EXPECT_TRUE(reported.empty()) << reported;

  [&] {
    const auto fewer = wend::without_collinear(plan->path);
    const auto taut = wend::string_pulled(plan->path, space);
    if (!fewer || !taut) return report("the path cannot be simplified");
    EXPECT_LT(fewer->size(), plan->path.size());
    EXPECT_LE(taut->length(), fewer->length());
    if (const auto fault = wend::fault_of(*taut, space)) return report(fault->message);
    const wend::Point point = taut->points().back();
    if (!wend::near_map(space, point)) return report("NaN, infinite or far off the map");
  }();
  EXPECT_TRUE(reported.empty()) << reported;
  [&] {
    const wend::PathEnds ends{{1.4, 1.6}, {8.3, 5.7}};
    const wend::Path path = wend::with_ends(plan->path, ends, space);
    EXPECT_EQ(path.points().front(), ends.start);
  }();
  const auto refined = wend::refined(plan->path, space,
                                     {.simplify = wend::Simplification{wend::SimplifyBy::sight},
                                      .smoother = wend::SmootherChoice{"gradient"}});
  EXPECT_TRUE(refined);
}

void make_planner_and_plan(const wend::FreeSpace& space) {
  auto planner = wend::make_planner("astar", space, {{"weight", "1.5"}});
  if (!planner) return report(planner.error().message);
  const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
  if (!plan) return report(plan.error().message);
  EXPECT_EQ(plan->path.cells().back(), (wend::Cell{8, 5}));
}

TEST(Snippets, OfPath) {
  const auto astar = wend::make_planner("astar", open_ground());
  const auto plan = (*astar)->plan(wend::Query::between({1, 1}, {8, 5}));
  std::vector<wend::Cell> cells;
  for (const wend::Cell cell : plan->path.cells()) cells.push_back(cell);
  EXPECT_EQ(cells.size(), plan->path.size());

  double length = 0;
  const wend::Path path = wend::Path::through({{0, 0, 0}, {1, 1, wend::kPi / 2}});
  for (const wend::Arc& arc : path.arcs()) length += arc.length;
  const auto outlines = wend::outline_poses(path, 0.5);  // of a robot that is a cell wide
  EXPECT_EQ(outlines.front(), path.poses().front());
  const auto poses = wend::dense_poses(path);  // lines between them are within 0.01 cells of it
  EXPECT_GT(poses.size(), path.size());
  EXPECT_NEAR(length, wend::kPi / 2, 1e-12);

  const std::size_t lines =
      path.visit([](std::span<const wend::Cell> cells) { return cells.size() - 1; },
                 [](std::span<const wend::Point> waypoints) { return waypoints.size() - 1; },
                 [](const wend::JoinedPoses& poses) { return poses.segment_count(); });
  EXPECT_EQ(lines, 1U);
}

TEST(Snippets, OfPlanner) {
  reported.clear();
  make_planner_and_plan(open_ground());
  EXPECT_EQ(reported, "");
}

TEST(Snippets, OfOnSolution) {
  const auto planner = wend::make_planner("ara_star", open_ground());
  ASSERT_TRUE(planner);
  wend::Query query = wend::Query::between({1, 1}, {8, 5});
  std::vector<double> bounds;
  query.limits.clock = [] { return 0.0; };
  query.limits.seconds = 0.05;
  query.on_solution = [&](const wend::Plan& plan) { bounds.push_back(plan.bound); };
  EXPECT_TRUE((*planner)->plan(query));
  EXPECT_FALSE(bounds.empty());
}

TEST(Snippets, OfAPlannerInSteps) {
  const auto made = wend::make_planner("astar", open_ground());
  wend::Planner& planner = **made;
  const wend::Query query = wend::Query::between({1, 1}, {8, 5});
  wend::Plan plan;
  auto outcome = planner.begin(query, plan);
  while (!outcome) outcome = planner.step(plan);
  EXPECT_EQ(*outcome, wend::Status::found);
}

TEST(Snippets, OfOpenList) {
  const auto made = wend::make_planner("astar", open_ground());
  wend::Planner& planner = **made;
  wend::SearchRecorder recorder(open_ground());
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
  const wend::FreeSpace& space = open_ground();
  const wend::Cell goal{8, 5};
  const wend::Cell start{1, 1};
  const auto field = wend::CostToGo::make(space, std::array{goal});
  if (const auto path = field->path_from(start)) report("there is a path");
  EXPECT_EQ(reported, "there is a path");
}

TEST(Snippets, OfSearchRecorderAndLayer) {
  const wend::FreeSpace& space = open_ground();
  const auto made = wend::make_planner("astar", space);
  wend::Planner& planner = **made;
  wend::SearchRecorder recorder(space);
  wend::Query query = wend::Query::between({1, 1}, {8, 5});
  query.observer = &recorder;
  const auto plan = planner.plan(query);
  ASSERT_TRUE(plan);
  {
    const std::uint32_t first = recorder.layers().expansion[{1, 1}];  // 1: the start
    EXPECT_EQ(first, 1U);
  }
  const wend::Layer order = wend::search_layer(wend::LayerKind::expansion, planner, recorder);
  const double first = order.numbers[{1, 1}];  // 1: the start
  EXPECT_EQ(first, 1);
  wend::SearchRecorder driven(space, planner.place_grid());
  EXPECT_TRUE(driven.expansions().empty());
}

TEST(Snippets, OfMotionTree) {
  wend::SearchRecorder recorder(open_ground());
  wend::Query query{{1.5, 1.5, 0}, {wend::Goal(wend::Pose{8.5, 5.5, 0})}};
  query.observer = &recorder;
  ASSERT_TRUE((*wend::make_planner("hybrid_astar", open_ground()))->plan(query));
  std::size_t poses = 0;
  const wend::MotionTree& tree = recorder.motions();
  for (std::size_t i = 0; i < tree.size(); ++i) poses += tree.branch(i).size();
  EXPECT_GT(poses, 0U);
}

TEST(Snippets, OfScene) {
  const wend::FreeSpace& space = open_ground();
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
  const wend::FreeSpace& space = open_ground();
  const auto planner = wend::make_planner("astar", space);
  const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
  const wend::Path smoothed = wend::smooth_by_gradient(plan->path, space)->path;
  wend::Scene scene{.space = space};
  scene.lines = {{wend::LineRole::planned, plan->path.points()},
                 {wend::LineRole::smoothed, smoothed.points()}};
  EXPECT_EQ(scene.lines.size(), 2U);
}

TEST(Snippets, OfPlaceGrid) {
  const auto made = wend::make_planner("astar", open_ground());
  const wend::Planner& planner = **made;
  const wend::PlaceGrid places = planner.place_grid();
  const wend::Point point = places.point({3, 2});  // grid coordinates
  EXPECT_EQ(point, (wend::Point{3.5, 2.5}));
}

TEST(Snippets, OfSceneOfACar) {
  const wend::FreeSpace& space = open_ground();
  wend::Scene yard{.space = space};
  yard.path = wend::Path::through({{0, 0, 0}, {1, 1, wend::kPi / 2}});
  yard.start = yard.path.poses().front();
  yard.places = wend::corners_of(space);
  EXPECT_EQ(yard.start->point, (wend::Point{0, 0}));
  EXPECT_EQ(yard.start->heading, 0);
}

TEST(Snippets, OfDrawing) {
  const OfficeInWorkingFolder office;
  const wend::Scene scene{.space = open_ground()};
  const auto png = wend::draw_png(scene);
  if (png) wend::write_file("plan.png", *png);
  EXPECT_TRUE(fs::exists("plan.png"));
}

TEST(Snippets, OfTerminalPicture) {
  const wend::Scene scene{.space = open_ground()};
  const bool is_terminal = isatty(STDOUT_FILENO) == 1;
  wend::Terminal terminal;  // plain ASCII
  if (is_terminal) terminal = wend::detect_terminal(environ);
  std::cout << wend::terminal_picture(scene, 80, 24, terminal);
  std::cout << wend::terminal_legend(scene, 80, terminal);
}

TEST(Snippets, OfPanels) {
  const wend::Scene with_astar{.space = open_ground()};
  const wend::Scene with_dijkstra{.space = open_ground()};
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

TEST(Snippets, OfFilmCanvas) {
  const wend::Style style;
  const std::array scenes{wend::Scene{.space = open_ground()}};
  const std::array last{wend::FilmPanel{"astar", "120 expanded", scenes[0]}};
  const auto frame = last;
  wend::FilmCanvas canvas(last, wend::legend_of(scenes, style), 800, 640, style);
  const std::array frames{canvas.draw(frame)};
  wend::GifAnimation animation(frames[0].width(), frames[0].height(), wend::palette_of(frames));
  animation.add(canvas.draw(frame), 5);
  EXPECT_TRUE(animation.finish());
}

TEST(Snippets, OfPosthocTrace) {
  const wend::FreeSpace& space = open_ground();
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
  wend::PosthocTrace driven(space, query, wend::corners_of(space), wend::TraceForm::json, 100'000);
  EXPECT_NE(driven.finish({}).find("heading"), std::string::npos);
}

void report_width(double radius) { reported = radius == 0.5 ? "half a cell" : "another width"; }
void suggest(const wend::Way& way) {
  reported = way.smaller_robot ? "a smaller robot" : "something else";
}

TEST(Snippets, OfIndexSupport) {
  const wend::FreeSpace space =
      *wend::make_free_space(*wend::make_grid_map(wend::Grid<wend::CellState>(4, 3)));
  reported.clear();
  const wend::PlannerInfo& info = *wend::planners().find("hub_labels");
  const auto index = info.index_support->build(space, {});
  if (!index) report(index.error().message);
  const auto planner = info.index_support->make_planner(space, {}, *index);
  EXPECT_EQ(reported, "");
  EXPECT_TRUE(planner);
}

TEST(Snippets, OfWidestPathAndNoPath) {
  wend::Grid<wend::CellState> cells(5, 3, wend::CellState::free);
  cells[{2, 0}] = cells[{2, 2}] = wend::CellState::occupied;
  const wend::FreeSpace space = *wend::make_free_space(*wend::make_grid_map(cells),
                                                       {.footprint = wend::Footprint::disc(0.75)});
  const wend::Cell start{0, 1};
  const wend::Cell goal{4, 1};
  if (const auto widest = wend::widest_path(space, start, goal)) report_width(widest->radius);
  EXPECT_EQ(reported, "half a cell");

  const wend::NoPath why = wend::explain_no_path(space, start, goal);
  for (const wend::Way& way : why.ways) suggest(way);
  EXPECT_EQ(reported, "a smaller robot");
}

void suggest_radius(double radius) {
  reported = radius < 200 ? "a smaller radius" : "something else";
}

TEST(Snippets, OfHybridAStarOptions) {
  const wend::FreeSpace space = open_ground();
  const auto planner = wend::make_planner(space, wend::HybridAStarOptions{.turning_radius = 0.4});
  EXPECT_TRUE(planner);
}

TEST(Snippets, OfNoDrive) {
  wend::Grid<wend::CellState> cells(12, 9, wend::CellState::free);
  for (int y = 3; y < 9; ++y) {
    for (int x = 3; x < 12; ++x) cells[{x, y}] = wend::CellState::occupied;
  }
  const wend::FreeSpace space =
      *wend::make_free_space(*wend::make_grid_map(cells),
                             {.footprint = *wend::parse_footprint("1,1.2; 1,-1.2; -1,-1.2; -1,1.2"),
                              .outside = wend::OutsidePolicy::blocked});
  const wend::Query query{{1.5, 7.5, -wend::kPi / 2}, {wend::Goal(wend::Pose{10, 1.5, 0})}};
  const auto why = wend::explain_no_drive(space, query, {.turning_radius = 200});
  if (why && why->turning_radius) suggest_radius(*why->turning_radius);
  EXPECT_EQ(reported, "a smaller radius");
}

std::string compare(const wend::FreeSpace& space, const wend::Clock& clock) {
  const auto report = [](const std::string& what) { return what; };
  auto run = wend::ComparisonRun::make(space, *wend::parse_planner_specs("astar,bfs"), clock);
  if (!run) return report(run.error().message);
  for (const wend::CellPair& cells : wend::random_pairs(space, 100, 7)) run->answer(cells);
  const std::string table = wend::comparison_table(run->comparison());
  return table;
}

TEST(Snippets, OfComparisonRun) {
  const wend::Clock clock = [seconds = 0.0]() mutable { return ++seconds; };
  EXPECT_NE(compare(open_ground(), clock).find("100 queries"), std::string::npos);
}

std::string keep(const std::vector<wend::BenchAnswer>& answers) {
  const auto report = [](const std::string& what) { return what; };
  auto database = wend::BenchDatabase::open("bench.db");
  if (!database) return report(database.error().message);
  const auto experiment = database->experiment({.map = "arena", .version = "wend 0.1.0"});
  const auto planner = database->planner("astar:weight=2");
  if (!experiment || !planner) return report("bench.db cannot be written");
  const auto stored = database->store(*experiment, *planner, answers);
  return stored ? "stored" : stored.error().message;
}

TEST(Snippets, OfBenchDatabase) {
  const OfficeInWorkingFolder folder;
  EXPECT_EQ(keep({{.line = 2, .seconds = {1e-6}}}), "stored");
  EXPECT_EQ(keep({{.line = 3, .seconds = {1e-6}}}), "stored");
}

TEST(Snippets, OfPathReport) {
  const wend::FreeSpace space = open_ground();
  const auto planner = wend::make_planner("astar", space);
  const auto plan = (*planner)->plan(wend::Query::between({1, 1}, {8, 5}));
  const auto refined =
      wend::refined(plan->path, space, {.smoother = wend::SmootherChoice{"gradient"}});
  const std::vector<wend::MeasuredPath> paths{wend::measured("planned", plan->path, space),
                                              wend::measured("smoothed", refined->path, space)};
  std::cout << wend::metrics_table(paths, wend::metres_of(space.map().frame()));
  EXPECT_LT(paths[1].metrics->length, paths[0].metrics->length);
}

void answer(const wend::FreeSpace& space, const wend::PlannerSpec& spec) {
  const wend::Query query = wend::Query::between({1, 1}, {8, 5});
  wend::Plan plan;
  wend::TimedPlanner planner(space, spec, wend::thread_cpu_seconds);
  if (planner.error()) return report(planner.error()->message);
  wend::QueryTimes times;
  const wend::Status status = planner.answer(query, plan, times);
  report(wend::describe(status));
}

TEST(Snippets, OfTimedPlanner) {
  answer(open_ground(), wend::parse_planner_specs("astar")->front());
  EXPECT_EQ(reported, wend::describe(wend::Status::found));
}

TEST(Snippets, OfScenarioQueries) {
  const wend::FreeSpace& space = open_ground();
  const auto queries = wend::scenario_queries(space, {}, {.seed = 1, .buckets = 10});
  ASSERT_TRUE(queries);
  EXPECT_FALSE(queries->empty());
}

TEST(Snippets, OfSqlite) {
  using wend::SqliteStatement;
  wend::SqliteConnection connection(":memory:");
  connection.run(
      "CREATE TABLE planners (id INTEGER, name TEXT); INSERT INTO planners VALUES (7, 'astar')");
  std::vector<std::string> names;
  SqliteStatement query(connection, "SELECT name FROM planners WHERE id = ?");
  for (query.start(std::int64_t{7}); query.next();) names.push_back(query.text(0));
  EXPECT_EQ(connection.error(), "");
  EXPECT_EQ(names, std::vector<std::string>{"astar"});
}

TEST(Snippets, OfTextTable) {
  std::string printed;
  const auto print = [&](const std::string& text) { printed = text; };
  wend::TextTable table({{"planner"}, {"mean us", wend::Align::right}});
  table.add({"astar", "12.5"});
  print(table.text());
  EXPECT_NE(printed.find("astar"), std::string::npos);
}

TEST(Snippets, OfGoals) {
  const wend::FreeSpace space = open_ground();
  const wend::Pose start = wend::pose_at({1, 1});
  wend::Query query{start, {wend::Goal(wend::Pose{18.5, 4.5, 0}, 3)}};  // at most 3 cells away
  EXPECT_EQ(query.goals.front().tolerance, 3);

  const wend::Goal goal(wend::centre_of({4, 4}), 1);
  const auto status = [&]() {
    wend::GoalRegion region(goal, cell_under(space, goal.point), cells_of(space));
    if (!region.keep_if([&](wend::Cell cell) { return space.passable(cell); }))
      return wend::Status::goal_blocked;
    return wend::Status::found;
  };
  EXPECT_EQ(status(), wend::Status::found);
}

TEST(Snippets, OfTypedOptions) {
  const wend::FreeSpace space = open_ground();
  wend::PlanRequest request;
  const auto make = [&] {
    const auto planner = wend::make_planner(space, wend::AStarOptions{.weight = 2});
    if (!planner) return report(planner.error().message);

    request.planner = wend::planner_spec(wend::AStarOptions{.weight = 2});
  };
  reported = {};
  make();
  EXPECT_EQ(reported, "");
  EXPECT_EQ(request.planner.name, "astar");
  {
    const auto planner = wend::make_planner(space, wend::ThetaStarOptions{.weight = 1.5});
    EXPECT_TRUE(planner);
  }
  const auto car = wend::make_planner(space, wend::CarOptions{.turning_radius = 0.4});
  const auto robot = wend::make_planner(space, wend::LatticeOptions{.turning_radius = 0.4});
  EXPECT_TRUE(car);
  EXPECT_TRUE(robot);
  {
    const auto planner = wend::make_planner(space, wend::HybridAStarOptions{.turning_radius = 0.4});
    EXPECT_TRUE(planner);
  }
  const wend::OptionValues values = wend::option_values(wend::AStarOptions{.weight = 2});
  EXPECT_EQ(values, (wend::OptionValues{{"weight", "2"}}));
}

TEST(Snippets, OfCompressedPixels) {
  std::string file;
  const auto append = [&file](const std::string& blocks) { file += blocks; };
  wend::LzwEncoder encoder(8);
  encoder.add(7, 800);  // a run of equal pixels
  encoder.add(3, 1);
  append(encoder.finish());
  EXPECT_EQ(file.back(), '\0') << "the empty block";
}

TEST(Snippets, OfMovesInARow) {
  wend::Plan plan;
  plan.moves = {"FWD_RIGHT", "FWD", "FWD", "FWD"};
  std::vector<std::string> lines;
  for (const wend::RepeatedMove& move : wend::merged_moves(plan.moves)) {
    lines.push_back("Go " + wend::text_of(move));  // "Go FWD_RIGHT", "Go 3 x FWD"
  }
  EXPECT_EQ(lines, (std::vector<std::string>{"Go FWD_RIGHT", "Go 3 x FWD"}));
}

}  // namespace
