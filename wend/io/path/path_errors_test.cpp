// What the parsers of path files say about invalid text: where it is and what would be right.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "wend/geometry/angle.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/path/load_path.hpp"

namespace wend {
namespace {

using testing::HasSubstr;

constexpr std::string_view kWrongHeader =
    "the first line must be 'x,y,x_m,y_m', 'x,y,heading,x_m,y_m,yaw,gear' or "
    "'x_grid,y_grid,x_m,y_m,yaw', or name columns x_m and y_m, not ";

struct Malformed {
  std::string text;
  std::string error;
};

TEST(ParsePathCsv, SaysWhatIsWrongWhereAndWhatWouldBeRight) {
  const std::string header = "x,y,x_m,y_m\n";
  const std::vector<Malformed> cases{
      {"", fmt::format("p:1: {}''", kWrongHeader)},
      {"x,y\n1,2\n", fmt::format("p:1: {}'x,y'", kWrongHeader)},
      {"1,1,0.5,0.5\n", "p:1: the first line must be"},
      {header, "p: the path is empty: expected at least one cell"},
      {header + "1,1,0.5,0.5\n2,1\n", "p:3: 2 columns, expected 4: x,y,x_m,y_m"},
      {header + "1,1,0.5,0.5,9\n", "p:2: 5 columns, expected 4"},
      {header + "1;1;0.5;0.5\n", "p:2: 1 columns, expected 4"},
      {header + "\n1,1,0.5,0.5\n", "p:2: 1 columns, expected 4"},
      {header + "-1073741825,1,0.5,0.5\n",
       "p:2: x must be a whole number in -1073741824..1073741823, not '-1073741825'"},
      {header + "1,2147483648,0,0\n",
       "p:2: y must be a whole number in -1073741824..1073741823, not"},
      {header + "1,1073741824,0,0\n",
       "p:2: y must be a whole number in -1073741824..1073741823, not"},
      {header + "1.5,1,0,0\n", "p:2: x must be a whole number"},
      {header + " 1,1,0,0\n", "p:2: x must be a whole number"},
      {header + "1,1,nan,0\n", "p:2: x_m must be a finite number, not 'nan'"},
      {header + "1,1,0,\n", "p:2: y_m must be a finite number, not ''"},
  };
  for (const Malformed& wrong : cases) {
    EXPECT_THAT(error_of(parse_path_csv(wrong.text, "p", {})), testing::StartsWith(wrong.error));
  }
}

TEST(ParsePathCsv, SaysWhatIsWrongWithPoses) {
  const std::string header = "x,y,heading,x_m,y_m,yaw\n";
  const std::string good = "1,0,E,0.05,0,0\n";
  const std::vector<Malformed> cases{
      {header, "p: the path is empty: expected at least one pose"},
      {header + good + "2,1,0.1,0.05,1.5\n", "p:3: 5 columns, expected 6: x,y,heading,x_m,y_m,yaw"},
      {header + "1,1,0.5,0.5\n", "p:2: 4 columns, expected 6"},
      {header + "1,1,E,0,0,0,0\n", "p:2: 7 columns, expected 6"},
      {header + "-1e10,1,E,0,0,0\n",
       "p:2: x must be a number in -1073741824..1073741824, not '-1e10'"},
      {header + "1,1073741824.5,E,0,0,0\n", "p:2: y must be a number in -1073741824.."},
      {header + "nan,1,E,0,0,0\n", "p:2: x must be a number in"},
      {header + "1,1,,0,0,0\n", "p:2: heading must be N, W, E, S or radians, not ''"},
      {header + "1,1,e,0,0,0\n", "p:2: heading must be N, W, E, S or radians, not 'e'"},
      {header + "1,1,NE,0,0,0\n", "p:2: heading must be N, W, E, S or radians, not 'NE'"},
      {header + "1,1,inf,0,0,0\n", "p:2: heading must be N, W, E, S or radians, not 'inf'"},
      {header + good + "1,1,E,x,0,0\n", "p:3: x_m must be a finite number, not 'x'"},
      {header + "1,1,E,0,inf,0\n", "p:2: y_m must be a finite number, not 'inf'"},
      {header + "1,1,E,0,0,nan\n", "p:2: yaw must be a finite number, not 'nan'"},
      {"x,y,x_m,y_m\n" + good, "p:2: 6 columns, expected 4"},
  };
  for (const Malformed& wrong : cases) {
    EXPECT_THAT(error_of(parse_path_csv(wrong.text, "p", {})), testing::StartsWith(wrong.error));
  }
}

TEST(ParsePathCsv, SaysWhatIsWrongWithWaypoints) {
  const std::string header = "x_grid,y_grid,x_m,y_m,yaw\n";
  const std::string good = "1.5,0.25,0.05,0,0\n";
  const std::vector<Malformed> cases{
      {header, "p: the path is empty: expected at least one point"},
      {header + good + "2,1,0.1,0.05\n", "p:3: 4 columns, expected 5: x_grid,y_grid,x_m,y_m,yaw"},
      {header + "-1e10,1,0,0,0\n",
       "p:2: x_grid must be a number in -1073741824..1073741824, not '-1e10'"},
      {header + "1,1073741824.5,0,0,0\n", "p:2: y_grid must be a number in -1073741824.."},
      {header + "1,nan,0,0,0\n", "p:2: y_grid must be a number in"},
      {header + good + "1,1,x,0,0\n", "p:3: x_m must be a finite number, not 'x'"},
      {header + "1,1,0,0,inf\n", "p:2: yaw must be a finite number, not 'inf'"},
  };
  for (const Malformed& wrong : cases) {
    EXPECT_THAT(error_of(parse_path_csv(wrong.text, "p", {})), testing::StartsWith(wrong.error));
  }
}

TEST(ParsePathCsv, ReadsCentrelinesWhoseHeaderNamesMetres) {
  const Path path = Path::along({{1, 2}, {3, 2.5}});
  for (const std::string text :
       {"# x_m, y_m, w_tr_right_m, w_tr_left_m\n1.0, 2.0, 1.1, 1.1\n3, 2.5, 1, 1\n",
        "# 17b4de0d\n# 603fd398\n# s_m; x_m; y_m; psi_rad\n0;1;2;0.5\n1; 3.0 ;2.5;0.5\n",
        "x_m,y_m\n1,2\n3,2.5\n", "# by hand\ny_m;x_m\n2;1\n2.5;3\n",
        "\t#x_m,y_m\r\n1,2\r\n3,2.5\r\n"}) {
    const auto parsed = parse_path_csv(text, "p", {});
    ASSERT_TRUE(parsed) << error_of(parsed) << text;
    EXPECT_EQ(*parsed, path) << text;
  }
}

TEST(ParsePathCsv, SaysWhatIsWrongWithCentrelines) {
  const std::string header = "# x_m, y_m, w\n";
  const std::vector<Malformed> cases{
      {header, "p: the path is empty: expected at least one point"},
      {"# x_m, y_m\n# x, y\n1,2\n", fmt::format("p:1: {}'# x_m", kWrongHeader)},
      {"# x_m, y\n1,2\n", fmt::format("p:1: {}'# x_m", kWrongHeader)},
      {header + "1, 2\n", "p:2: 2 columns, expected 3: x_m, y_m, w"},
      {header + "1, 2, 3\n1;2;3\n", "p:3: 1 columns, expected 3"},
      {header + "1, 2, 3\n\n", "p:3: 1 columns, expected 3"},
      {header + "1, two, 3\n", "p:2: y_m must be a finite number, not 'two'"},
      {header + "1, 2, nan\n", "p:2: w must be a finite number, not 'nan'"},
      {header + "1, 2, 3\n-2e9, 2, 3\n",
       "p:3: x_m -2e+09 and y_m 2 are (-2e+09,2) in grid coordinates, which must be in "
       "-1073741824.."},
      {header + "1, 2e9, 3\n", "p:2: x_m 1 and y_m 2e+09 are (1,2e+09) in grid coordinates"},
  };
  for (const Malformed& wrong : cases) {
    EXPECT_THAT(error_of(parse_path_csv(wrong.text, "p", {})), testing::StartsWith(wrong.error))
        << wrong.text;
  }
}

TEST(ParsePathCsv, TurnsNorthAsTheMapDoes) {
  const std::string text = "x,y,heading,x_m,y_m,yaw\n4,5,N,0,0,0\n4,5,1,0,0,0\n";
  EXPECT_EQ(*parse_path_csv(text, "p", {.y_up = true}),
            Path::through({{4, 5, kPi / 2}, {4, 5, 1}}));
  EXPECT_EQ(*parse_path_csv(text, "p", {.y_up = false}),
            Path::through({{4, 5, -kPi / 2}, {4, 5, 1}}));
}

TEST(ParsePathCsv, TakesWindowsLineEnds) {
  EXPECT_EQ(*parse_path_csv("x,y,x_m,y_m\r\n1,2,0,0\r\n", "p", {}), Path({{1, 2}}));
}

TEST(ParsePathJson, SaysWhatIsWrongAndWhatWouldBeRight) {
  const std::vector<Malformed> cases{
      {"", "p:1: the JSON ends too early"},
      {"{\"path\":\n[[1,2]\n", "p:3: the JSON ends too early"},
      {"{\"path\":\n\n[[1,2] [3,4]]}", "p:3: invalid JSON at "},
      {"{\"path\":[[1,2]]} x", "p:1: "},
      {"{\"path\":[[1,1e999]]}", "p:1: "},
      {"{\"path\":[[1,2]],\"a\":\"\xff\"}", "p:1: "},
      {"7", "p: the top level must be an object with a list 'path'"},
      {"[[1,2]]", "p: the top level must be an object"},
      {"{}", "p: the key 'path' is missing, a list of [x,y]"},
      {R"({"a":{"path":[[1,2]]}})", "p: the key 'path' is missing"},
      {R"({"path":[]})", "p: 'path' is empty, expected at least one [x,y]"},
      {R"({"path":7})", "p: 'path' must be a list of [x,y], not '7'"},
      {R"({"path":null})", "p: 'path' must be a list of [x,y], not 'null'"},
      {R"({"path":{"x":1}})", "p: 'path' must be a list of [x,y], not '{'"},
      {R"({"path":[7]})", "p: path[0] must be [x,y], not '7'"},
      {R"({"path":[[1,2],{"x":1}]})", "p: path[1] must be [x,y], not '{'"},
      {R"({"path":[[1,2],[3]]})", "p: path[1] must be [x,y], not 1 numbers"},
      {R"({"path":[[1,2,3]]})", "p: path[0] must be [x,y], not 3 numbers"},
      {R"({"path":[[1,[2]]]})",
       "p: path[0][1] must be a whole number in -1073741824..1073741823, not '['"},
      {R"({"path":[[1,2.0]]})",
       "p: path[0][1] must be a whole number in -1073741824..1073741823, not '2.0'"},
      {R"({"path":[[-1.5,2]]})", "p: path[0][0] must be a whole number in -10737"},
      {R"({"path":[[1,2147483648]]})", "p: path[0][1] must be a whole number"},
      {R"({"path":[[1,99999999999999999999]]})", "p: path[0][1] must be a whole number"},
      {R"({"path":[["1",2]]})", "p: path[0][0] must be a whole number"},
      {R"({"path":[[true,2]]})", "p: path[0][0] must be a whole number"},
      {R"({"path":[[1,2]],"path":[[1,2]]})", "p: duplicate key 'path'"},
      {R"({"path":[[1,2.5]],"a":[7},"b":1})", "p:1: invalid JSON at "},
      {R"({"path":[[1,-2e10]],"a":[7},"b":1})", "p: path[0][1] must be a whole number"},
  };
  for (const Malformed& wrong : cases) {
    EXPECT_THAT(error_of(parse_path_json(wrong.text, "p", {})), testing::StartsWith(wrong.error))
        << wrong.text;
  }
}

TEST(ParsePathJson, SaysWhatIsWrongWithPoses) {
  const std::vector<Malformed> cases{
      {R"({"path":[[1,2],[2,3]],"headings":["E"]})",
       "p: 'headings' has 1 entries, 'path' has 2 points: expected one for each point"},
      {R"({"headings":["E","S"],"path":[[1,2]]})",
       "p: 'headings' has 2 entries, 'path' has 1 points"},
      {R"({"headings":["E"],"path":[]})", "p: 'headings' has 1 entries, 'path' has 0 points"},
      {R"({"headings":[],"path":[]})", "p: 'path' is empty, expected at least one [x,y]"},
      {R"({"headings":["E"]})", "p: the key 'path' is missing, a list of [x,y]"},
      {R"({"path":[[1,2]],"headings":null})", "p: 'headings' must be a list, not 'null'"},
      {R"({"path":[[1,2]],"headings":"E"})", "p: 'headings' must be a list, not 'E'"},
      {R"({"path":[[1,2]],"headings":7})", "p: 'headings' must be a list, not '7'"},
      {R"({"path":[[1,2]],"headings":{"E":1}})", "p: 'headings' must be a list, not '{'"},
      {R"({"path":[[1,2]],"headings":["e"]})",
       "p: headings[0] must be N, W, E, S or radians, not 'e'"},
      {R"({"path":[[1,2],[2,3]],"headings":["E",["S"]]})",
       "p: headings[1] must be N, W, E, S or radians, not '['"},
      {R"({"path":[[1,2]],"headings":[null]})", "p: headings[0] must be N, W, E, S or radians"},
      {R"({"path":[[1,2]],"headings":["E"],"headings":["E"]})", "p: duplicate key 'headings'"},
      {R"({"path":[[-1e10,2]],"headings":["E"]})",
       "p: path[0][0] must be a number in -1073741824..1073741824, not '-1e10'"},
      {R"({"path":[[1,2]],"headings":[1e7]})",
       "p: headings[0] must be N, W, E, S or radians, not '1e7'"},
      {R"({"headings":["E"],"path":[[1,1073741825]]})", "p: path[0][1] must be a number in -10737"},
      {R"({"headings":["E"],"path":[[1,"2"]]})", "p: path[0][1] must be a number in -1073741824"},
      {R"({"headings":["E"],"path":[[1,2,3]]})", "p: path[0] must be [x,y], not 3 numbers"},
  };
  for (const Malformed& wrong : cases) {
    EXPECT_THAT(error_of(parse_path_json(wrong.text, "p", {})), testing::StartsWith(wrong.error))
        << wrong.text;
  }
}

TEST(ParsePathJson, SaysWhatIsWrongWithSmoothedPaths) {
  const std::vector<Malformed> cases{
      {R"({"path":[[1,2]],"path_smoothed":[]})",
       "p: 'path_smoothed' is empty, expected at least one [x,y]"},
      {R"({"path_smoothed":7})", "p: 'path_smoothed' must be a list of [x,y], not '7'"},
      {R"({"path_smoothed":[[1,2],7]})", "p: path_smoothed[1] must be [x,y], not '7'"},
      {R"({"path_smoothed":[[1]]})", "p: path_smoothed[0] must be [x,y], not 1 numbers"},
      {R"({"path":[[1,2]],"path_smoothed":[[1,-2e10]]})",
       "p: path_smoothed[0][1] must be a number in -1073741824..1073741824, not '-2e10'"},
      {R"({"path_smoothed":[[1,2]],"path_smoothed":[[1,2]]})", "p: duplicate key 'path_smoothed'"},
  };
  for (const Malformed& wrong : cases) {
    EXPECT_THAT(error_of(parse_path_json(wrong.text, "p", {}, PathStage::smoothed)),
                testing::StartsWith(wrong.error))
        << wrong.text;
  }
}

TEST(ParsePathJson, OfAPlanThatFailedSaysSo) {
  for (const std::string text :
       {R"({"planner":"astar","status":"unreachable","reason":"","path":[],"path_m":[]})",
        R"({"path":[[1,2]],"status":"unreachable"})", R"({"status":"unreachable"})"}) {
    EXPECT_EQ(error_of(parse_path_json(text, "p", {})),
              "p: no path: the plan's status is 'unreachable'");
  }
}

TEST(ParsePathJson, IsNotToldByDepth) {
  const std::string deep(1 << 20, '[');
  EXPECT_THAT(error_of(parse_path_json("{\"a\":" + deep, "p", {})), HasSubstr("ends too early"));
  EXPECT_THAT(error_of(parse_path_json("{\"path\":" + deep, "p", {})),
              HasSubstr("path[0][0] must be a whole number"));
}

}  // namespace
}  // namespace wend
