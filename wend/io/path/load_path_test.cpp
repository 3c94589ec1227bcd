#include "wend/io/path/load_path.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/geometry/corner_pose.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/path/path_csv.hpp"

namespace wend {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const Frame kTurned{0.05, {-3, 7.5, 0.25}, true, true};

/// Waypoints with numbers that need many digits.
Path any_waypoints() {
  std::vector<Point> points;
  const int count = *rc::gen::inRange(1, 40);
  for (int i = 0; i < count; ++i) {
    points.push_back({*rc::gen::inRange(0, 1 << 30) / 7.0, *rc::gen::inRange(0, 1 << 30) / 997.0});
  }
  return Path::along(points);
}

std::string list_of(const Path& path) {
  std::string list;
  for (const Point point : path.points()) {
    list += fmt::format("[{:.17g},{:.17g}],", point.x, point.y);
  }
  list.pop_back();
  return "[" + list + "]";
}

Path any_path() {
  std::vector<Cell> cells;
  const int count = *rc::gen::inRange(1, 40);
  for (int i = 0; i < count; ++i) {
    cells.push_back({*rc::gen::inRange(0, 1 << 30), *rc::gen::inRange(0, 1 << 30)});
  }
  return Path(cells);
}

std::string json_of(const Path& path) {
  std::string cells;
  for (const Cell cell : path.cells()) cells += fmt::format("[{},{}],", cell.x, cell.y);
  cells.pop_back();
  return R"({"planner":"astar","status":"found","cost":1.5,"path":[)" + cells +
         R"(],"path_m":[[0.5,0.5],[1e3,-2]],"metrics":{"expanded":2,"path":7}})";
}

/// Poses on corners with one of the four headings, or at any point with any heading.
Path any_driven_path() {
  std::vector<Pose> poses;
  const int count = *rc::gen::inRange(1, 40);
  for (int i = 0; i < count; ++i) {
    const Cell corner{*rc::gen::inRange(0, (1 << 30) + 1), *rc::gen::inRange(0, (1 << 30) + 1)};
    const auto heading = *rc::gen::elementOf(kAllHeadings);
    const double aside = *rc::gen::inRange(0, 2) * *rc::gen::inRange(0, 1000) / 997.0;
    const Pose pose = pose_of({corner, heading});
    poses.push_back({std::max(0.0, pose.x - aside), pose.y, pose.heading + 7 * aside});
  }
  return Path::through(poses);
}

/// Writes the JSON with another library than the one that writes plans.
std::string json_of_driven(const Path& path, const Frame& frame) {
  std::string points;
  std::string headings;
  for (const Pose& pose : path.poses()) {
    points += fmt::format("[{:.17g},{:.17g}],", pose.x, pose.y);
    const auto heading = nearest_heading(pose.heading);
    headings += pose.heading == radians_of(heading)
                    ? fmt::format("\"{}\",", letter_of(heading, frame))
                    : fmt::format("{:.17g},", pose.heading);
  }
  points.pop_back();
  headings.pop_back();
  const std::string path_list = "\"path\":[" + points + "]";
  const std::string heading_list = "\"headings\":[" + headings + "]";
  const bool path_first = points.size() % 2 == 0;
  return R"({"status":"found","moves":["FWD"],)" + (path_first ? path_list : heading_list) + "," +
         (path_first ? heading_list : path_list) + R"(,"yaw":[0.25]})";
}

RC_GTEST_PROP(LoadPath, ACsvGivesTheCellsBack, ()) {
  const Path path = any_path();
  const auto parsed = parse_path_csv(path_csv(path, kTurned), "p.csv", kTurned);
  RC_ASSERT(error_of(parsed) == "no error");
  RC_ASSERT(*parsed == path);
}

RC_GTEST_PROP(LoadPath, ACsvGivesThePosesBack, (bool y_up)) {
  Frame frame = kTurned;
  frame.y_up = y_up;
  const Path path = any_driven_path();
  const auto parsed = parse_path_csv(path_csv(path, frame), "p.csv", frame);
  RC_ASSERT(error_of(parsed) == "no error");
  RC_ASSERT(*parsed == path);
}

RC_GTEST_PROP(LoadPath, ACsvGivesTheWaypointsBack, ()) {
  const Path path = any_waypoints();
  const auto parsed = parse_path_csv(path_csv(path, kTurned), "p.csv", kTurned);
  RC_ASSERT(error_of(parsed) == "no error");
  RC_ASSERT(*parsed == path);
}

RC_GTEST_PROP(LoadPath, JsonGivesWhatWasPlannedOrSmoothed, (bool smoothed_first)) {
  const Path planned = any_path();
  const Path smoothed = any_waypoints();
  std::string json = json_of(planned);
  const std::string list = "\"path_smoothed\":" + list_of(smoothed);
  if (smoothed_first) {
    json = "{" + list + "," + json.substr(1);
  } else {
    json.back() = ',';
    json += list + "}";
  }
  RC_ASSERT(*parse_path_json(json, "p", kTurned, PathStage::planned) == planned);
  RC_ASSERT(*parse_path_json(json, "p", kTurned, PathStage::smoothed) == smoothed);
}

RC_GTEST_PROP(LoadPath, JsonWithOnePathGivesThatOne, ()) {
  const Path planned = any_path();
  const Path smoothed = any_waypoints();
  const std::string only_smoothed = "{\"path_smoothed\":" + list_of(smoothed) + "}";
  for (const PathStage stage : {PathStage::planned, PathStage::smoothed}) {
    RC_ASSERT(*parse_path_json(json_of(planned), "p", kTurned, stage) == planned);
    RC_ASSERT(*parse_path_json(only_smoothed, "p", kTurned, stage) == smoothed);
  }
}

RC_GTEST_PROP(LoadPath, ACentrelineGivesItsPointsInGridCoordinates, (bool semicolons)) {
  const Path path = any_waypoints();
  const Frame frame{0.05, {-3, 7.5, 0}, true, true};
  const std::string separator = semicolons ? " ; " : ",";
  std::string text = "# made by hand\n# s_m" + separator + "y_m" + separator + "x_m\n";
  for (const MapPoint point : path.points_in_metres(frame)) {
    text += fmt::format("1{0}{2:.17g}{0}{1:.17g}\n", separator, point.x, point.y);
  }
  const auto parsed = parse_path_csv(text, "p.csv", frame);
  RC_ASSERT(error_of(parsed) == "no error");
  RC_ASSERT(parsed->waypoints().size() == path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    RC_ASSERT(distance(parsed->waypoints()[i], path.waypoints()[i]) <
              1e-6 * (1 + distance({}, path.waypoints()[i])));
  }
}

RC_GTEST_PROP(LoadPath, JsonGivesThePosesBack, (bool y_up)) {
  Frame frame = kTurned;
  frame.y_up = y_up;
  const Path path = any_driven_path();
  const auto parsed = parse_path_json(json_of_driven(path, frame), "p.json", frame);
  RC_ASSERT(error_of(parsed) == "no error");
  RC_ASSERT(*parsed == path);
}

RC_GTEST_PROP(LoadPath, JsonGivesTheCellsBack, ()) {
  const Path path = any_path();
  const auto parsed = parse_path_json(json_of(path), "p.json", kTurned);
  RC_ASSERT(error_of(parsed) == "no error");
  RC_ASSERT(*parsed == path);
}

TEST(LoadPath, GoesByTheNameThenByTheContent) {
  const TemporaryFolder folder;
  const Path path({{3, 4}, {4, 4}});
  const std::string csv = path_csv(path, {});
  for (const auto& [name, text] : {std::pair{"p.csv", csv},
                                   {"p.CSV", csv},
                                   {"p.json", json_of(path)},
                                   {"plan", "\n " + json_of(path)},
                                   {"path", csv}}) {
    const auto loaded = load_path(folder.write(name, text), {});
    ASSERT_TRUE(loaded) << error_of(loaded);
    EXPECT_EQ(*loaded, path) << name;
  }
  EXPECT_THAT(error_of(load_path(folder.write("q.csv", json_of(path)), {})),
              AllOf(HasSubstr("q.csv:1: the first line must be "), HasSubstr("not '{\"planner\"")));
  EXPECT_THAT(error_of(load_path(folder.write("q.json", csv), {})),
              HasSubstr("q.json:1: invalid JSON"));
  EXPECT_THAT(error_of(load_path(folder / "missing.csv", {})), HasSubstr("cannot be opened"));
  EXPECT_THAT(error_of(load_path("/dev/zero", {})), HasSubstr("not a regular file"));
}

TEST(LoadPath, RefusesAFileThatIsTooLargeWithoutReadingIt) {
  const TemporaryFolder folder;
  const auto file = folder.write("large.csv", "x,y,x_m,y_m\n");
  std::filesystem::resize_file(file, std::uintmax_t{10} << 30);  // a hole, no disk is used
  EXPECT_THAT(error_of(load_path(file, {})), HasSubstr("too large: 10737418240 bytes"));
}

TEST(LoadPath, SaysWhyThereIsNoPath) {
  const FailedPlan plan{"unreachable", "no path joins start (1,1): and, goal \"8\""};
  const std::string csv = no_path_csv(plan);
  EXPECT_EQ(csv,
            "# no path: unreachable: no path joins start (1,1): and, goal \"8\"\nx,y,x_m,y_m\n");
  const auto from_csv = parse_path_csv(csv, "plan.csv", {});
  EXPECT_EQ(error_of(from_csv), "plan.csv: no path: " + plan.reason);
  EXPECT_EQ(from_csv.error().failed_plan, plan);
  const auto from_json = parse_path_json(
      R"({"status": "unreachable", "reason": "no path joins start (1,1): and, goal \"8\"",
          "path": []})",
      "plan.json", {});
  EXPECT_EQ(error_of(from_json), "plan.json: no path: " + plan.reason);
  EXPECT_EQ(from_json.error().failed_plan, plan);
  EXPECT_EQ(error_of(parse_path_csv("# no path: time_limit", "plan.csv", {})),
            "plan.csv: no path: the plan's status is 'time_limit'");
  EXPECT_EQ(parse_path_csv("x,y\n", "plan.csv", {}).error().failed_plan, std::nullopt);
}

TEST(LoadPath, KeepsTheReasonInOneLine) {
  EXPECT_EQ(no_path_csv({"not_free", "a\r\nb"}), "# no path: not_free: a  b\nx,y,x_m,y_m\n");
  const auto json =
      parse_path_json(R"({"status": "not_free", "reason": "a\n\u00e9"})", "p.json", {});
  EXPECT_EQ(error_of(json), "p.json: no path: a \xC3\xA9");
  const auto csv = parse_path_csv("# no path: x: \x1b[2J", "p.csv", {});
  EXPECT_EQ(error_of(csv), "p.csv: no path: \\x1B[2J");
}

TEST(LoadPath, SkipsAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  const TemporaryFolder folder;
  const Path cells = *load_path(folder.write("cells.csv", mark + "x,y,x_m,y_m\n3,4,3,4\n"), {});
  EXPECT_EQ(cells.cells().front(), (Cell{3, 4}));
  const std::string metres = mark + "# x_m, y_m\n1.5,2\n";
  EXPECT_EQ(load_path(folder.write("line.csv", metres), {})->points().front(), (Point{1.5, 2}));
  for (const char* const name : {"plan.json", "plan"}) {
    const auto plan = load_path(folder.write(name, mark + "{\"path\": [[3,4]]}"), {});
    EXPECT_EQ(error_of(plan), "no error");
  }
}

}  // namespace
}  // namespace wend
