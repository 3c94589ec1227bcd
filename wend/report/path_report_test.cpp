#include "wend/report/path_report.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/testing/build_paths.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/map/grid_map.hpp"
#include "wend/search/search_metrics.hpp"

namespace wend {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr Frame kPathFrame{.resolution = 0.5, .origin = {-1, 2, 0}, .y_up = true, .metric = true};

/// A space without anything that limits clearance.
FreeSpace open_space() {
  return *make_free_space(*make_grid_map(Grid<CellState>(8, 6), kPathFrame),
                          {.outside = OutsidePolicy::free});
}

const Path kPlanned({{0, 0}, {1, 0}, {2, 0}, {2, 1}});

RefinedPath refined_by(const Refinement& refinement) {
  return refined_path(kPlanned, refinement, *refined(kPlanned, open_space(), refinement),
                      open_space());
}

TEST(MetricsTable, HasALineForEachMeasureInTheUnit) {
  const MeasuredPath path = measured("path", Path::along({{0, 0}, {3, 4}}), open_space());
  const std::string table = metrics_table(std::vector{path}, metres_of(kPathFrame));
  EXPECT_THAT(table, StartsWith("points                          2\n"
                                "length, m                    2.50\n"
                                "turning, degrees                0\n"
                                "smallest turning radius, m      -\n"
                                "  corners rounded by 0.05 m     -\n"
                                "smallest clearance, m           -\n"
                                "mean clearance, m               -\n"
                                "reversals                       0\n"));
  const auto lines = std::ranges::count(table, '\n');
  EXPECT_EQ(lines, std::ssize(metrics_of(PathMetrics{})))
      << "the points, but no line for the rounding";
  EXPECT_THAT(metrics_table(std::vector{path}, {}),
              HasSubstr("length, cells                   5.00"));
}

std::string text_of_file(const std::string& name) {
  std::ifstream file(test::source_folder() / name);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Metrics, AreThoseOfTheirPage) {
  std::string table = "| name | unit | meaning |\n|---|---|---|\n";
  for (const Metric& metric : metrics_of(PathMetrics{})) {
    const std::string_view unit = metric_unit_name(metric.unit);
    table += "| `" + std::string(metric.name) + "` | " + std::string(unit) +
             (unit.empty() ? "" : " ") + "| " + std::string(metric.help) + " |\n";
  }
  EXPECT_THAT(text_of_file("docs/motion.md"), HasSubstr(table + "\n"));
}

/// A message of ROS stays as it is: whoever has recorded it reads it again. New metrics stand in its list of all.
TEST(Metrics, OfMessagesAreInTheList) {
  const auto check = [](const std::string& message, const auto& list,
                        const std::set<std::string>& others) {
    std::istringstream lines(text_of_file("ros/wend_ros/msg/" + message));
    std::string type;
    std::string name;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("#") || !(std::istringstream(line) >> type >> name)) continue;
      const bool listed = std::ranges::find(list, name, &Metric::name) != list.end();
      EXPECT_NE(listed, others.contains(name)) << message << ": " << name;
    }
    EXPECT_FALSE(name.empty());
  };
  check("PathMetrics.msg", metrics_of(PathMetrics{}), {"largest_curvature", "all"});
  check("SearchMetrics.msg", metrics_of(SearchMetrics{}), {"seconds"});
}

TEST(MetricsTable, SetsPathsBesideEachOther) {
  const std::vector<MeasuredPath> paths{
      measured("planned", kPlanned, open_space()),
      measured("other", Path::along({{1, 1}, {2, 1}}), open_space())};
  const std::string table = metrics_table(paths, {});
  EXPECT_THAT(table, StartsWith("                                planned  other\n"));
  EXPECT_THAT(table, HasSubstr("length, cells                      3.00   1.00\n"));
  EXPECT_THAT(table, HasSubstr("turning, degrees                     90      0\n"));
}

TEST(Measured, TakesCellsThatAreNotOnTheMap) {
  EXPECT_EQ(measured("far", Path({{20, 3}, {22, 3}}), open_space()).metrics->length, 2);
}

TEST(CheckJson, TellsWhereAPathCollides) {
  const MeasuredPath path = measured("path", kPlanned, open_space());
  const json is_free = json::parse(check_json(path, std::nullopt, kPathFrame));
  EXPECT_EQ(is_free.at("free"), true);
  EXPECT_TRUE(is_free.at("collision").is_null());
  EXPECT_EQ(is_free.at("metrics").at("length_cells"), 3);
  EXPECT_EQ(is_free.at("metrics").at("length_m"), 1.5);
  EXPECT_TRUE(is_free.at("metrics").at("smallest_clearance_m").is_null());
  EXPECT_EQ(is_free.at("schema"), 1);
  const auto metric = [&](const char* name) {
    return is_free.at("metrics").at(name).get<double>();
  };
  EXPECT_EQ(metric("smallest_turning_radius_cells"), 0) << "of a corner";
  EXPECT_EQ(metric("smallest_turning_radius_m"), 0);
  EXPECT_NEAR(metric("rounded_turning_radius_cells"), 0.1 / (std::sqrt(2.0) - 1), 1e-9);
  EXPECT_NEAR(metric("rounded_turning_radius_m"), 0.05 / (std::sqrt(2.0) - 1), 1e-9);
  EXPECT_EQ(metric("corner_rounding_cells"), 0.1);
  EXPECT_EQ(metric("corner_rounding_m"), 0.05);
  const PathCollision collision{CollisionKind::too_close, 1, 1.5, {2, 0.5}, Cell{3, 1}};
  const json collides = json::parse(check_json(path, collision, kPathFrame));
  EXPECT_EQ(collides.at("free"), false);
  EXPECT_EQ(collides.at("collision"),
            json::parse(R"({"kind":"too_close","along_cells":1.5,"along_m":0.75,
                            "point":[2,0.5],"point_m":[0.0,2.25],"obstacle":[3,1]})"));
}

TEST(SmoothingJson, HasBothPathsAndWhatWasDone) {
  const json smoothed =
      json::parse(smoothing_json(refined_by({.smoother = SmootherChoice{"gradient"}}), kPathFrame));
  EXPECT_EQ(smoothed.at("path"), json::parse("[[0,0],[1,0],[2,0],[2,1]]"));
  EXPECT_EQ(smoothed.at("path_smoothed").size(), 4U);
  EXPECT_EQ(smoothed.at("path_smoothed").front(), json::parse("[0.5,0.5]"));
  EXPECT_EQ(smoothed.at("path_smoothed").back(), json::parse("[2.5,1.5]"));
  EXPECT_EQ(smoothed.at("path_smoothed_m").back(), json::parse("[0.25,2.75]"));
  EXPECT_EQ(smoothed.at("smoothing").at("smoother"), "gradient");
  EXPECT_EQ(smoothed.at("smoothing").at("converged"), true);
  EXPECT_EQ(smoothed.at("smoothing").at("held"), 0);
  EXPECT_LT(smoothed.at("path_smoothed_metrics").at("length_cells").get<double>(), 3);
  EXPECT_EQ(smoothed.at("path_metrics").at("length_cells"), 3);
}

TEST(SmoothingJson, SaysNothingOfSmoothingWhereNothingWasSmoothed) {
  const RefinedPath simplified = refined_by({.simplify = Simplification{SimplifyBy::collinear}});
  const json plan = json::parse(smoothing_json(simplified, kPathFrame));
  EXPECT_TRUE(plan.at("smoothing").is_null());
  EXPECT_EQ(plan.at("path_smoothed"), json::parse("[[0.5,0.5],[2.5,0.5],[2.5,1.5]]"));
  EXPECT_EQ(smoothing_text(simplified), "");
  EXPECT_EQ(simplified.measured_after.title, "simplified");
}

TEST(SmoothingJson, OfWaypointsHasNoCells) {
  RefinedPath path = refined_by({.simplify = Simplification{SimplifyBy::collinear}});
  path.before = Path::along({{0.5, 0.5}, {2.5, 1.5}});
  EXPECT_FALSE(json::parse(smoothing_json(path, kPathFrame)).contains("path"));
}

TEST(SmoothingText, SaysHowItWent) {
  RefinedPath path = refined_by({.smoother = SmootherChoice{"gradient"}});
  EXPECT_THAT(smoothing_text(path), HasSubstr("smoother  gradient\nsmoothed  "));
  EXPECT_THAT(smoothing_text(path), HasSubstr("held      none: no obstacle was in the way\n"));
  path.refined.smoothing->held = 0.125;
  path.refined.smoothing->converged = false;
  path.refined.smoothing->sweeps = 1;
  EXPECT_THAT(smoothing_text(path), HasSubstr("1 sweep, stopped by the limit\n"));
  EXPECT_THAT(smoothing_text(path), HasSubstr("12.5 % of the inner points, by obstacles\n"));
  EXPECT_THAT(smoothing_text(path), Not(HasSubstr("bound")));
  path.refined.smoothing->within_bound = false;
  path.refined.smoothing->returned = true;
  EXPECT_THAT(smoothing_text(path),
              HasSubstr("held      all: smoothing would have lengthened the path"));
  EXPECT_THAT(smoothing_text(path), HasSubstr("curvature exceeds the bound"));
}

TEST(FailedPlanJson, IsReadBackAsAPlanWithoutAPath) {
  const FailedPlan plan{"not_free", "it touches (3,4)"};
  const auto path = parse_path_json(failed_plan_json(plan), "smooth.json", {});
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().failed_plan, plan);
}

}  // namespace
}  // namespace wend
