#include "wend/io/path/path_csv.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/io/files.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/path/load_path.hpp"

namespace wend {
namespace {

TEST(PathCsv, HasALineForEveryCellWithItsCentreInMetres) {
  const Path path({{1, 1}, {2, 1}, {3, 2}});
  Frame frame;
  frame.resolution = 0.5;
  frame.origin = {-1, 2, 0};
  EXPECT_EQ(path_csv(path, frame),
            "x,y,x_m,y_m\n"
            "1,1,-0.25,2.75\n"
            "2,1,0.25,2.75\n"
            "3,2,0.75,3.25\n");
}

TEST(PathCsv, HasALineForEveryPoseWithItsHeadingAndItsYaw) {
  Frame frame{.resolution = 0.5, .origin = {-1, 2, kPi / 2}, .y_up = true};
  EXPECT_EQ(path_csv(Path::through({{1, 0, 0}, {2, 1, kPi / 2}}), frame),
            "x,y,heading,x_m,y_m,yaw,gear\n"
            "1,0,E,-1,2.5,1.5707963267948966,1\n"
            "2,1,N,-1.5,3,3.141592653589793,1\n");
  frame.origin = {};
  const Path path = Path::through({{1, 0, 0}, {2, 1, kPi / 2}, {1048576, 2.5, 0.25}});
  EXPECT_EQ(path_csv(path, frame),
            "x,y,heading,x_m,y_m,yaw,gear\n"
            "1,0,E,0.5,0,0,1\n"
            "2,1,N,1,0.5,1.5707963267948966,1\n"
            "1048576,2.5,0.25,524288,1.25,0.25,1\n");
  frame.y_up = false;
  EXPECT_EQ(path_csv(Path::through({{2, 1, kPi / 2}}), frame),
            "x,y,heading,x_m,y_m,yaw,gear\n"
            "2,1,S,1,0.5,1.5707963267948966,0\n");
}

TEST(PathCsv, SaysInWhichGearEachPoseIsReached) {
  const Path path = Path::through({{5, 5, 0}, {3, 5, 0}, {3, 5, 1}, {3, 6, 1}, {4, 6, 0}});
  const std::string csv = path_csv(path, {});
  std::vector<std::string> gears;
  for (std::size_t end = csv.find('\n'); end != std::string::npos; end = csv.find('\n', end + 1)) {
    gears.push_back(csv.substr(csv.rfind(',', end) + 1, end - csv.rfind(',', end) - 1));
  }
  EXPECT_EQ(gears, (std::vector<std::string>{"gear", "-1", "-1", "0", "1", "1"}));
  EXPECT_EQ(*parse_path_csv(csv, "p", {}), path);
}

TEST(PathCsv, HasALineForEveryWaypointWithTheHeadingFromThere) {
  Frame frame{.resolution = 0.5, .origin = {-1, 2, 0}, .y_up = true};
  const Path path = Path::along({{1, 0}, {1, 2}, {2.25, 2}});
  EXPECT_EQ(path_csv(path, frame),
            "x_grid,y_grid,x_m,y_m,yaw\n"
            "1,0,-0.5,2,1.5707963267948966\n"
            "1,2,-0.5,3,0\n"
            "2.25,2,0.125,3,0\n");
  frame.origin = {0, 0, kPi / 2};
  EXPECT_EQ(path_csv(Path::along({{0, 0}}), frame),
            "x_grid,y_grid,x_m,y_m,yaw\n"
            "0,0,0,0,1.5707963267948966\n");
}

TEST(PathCsv, AnEmptyPathIsAHeader) { EXPECT_EQ(path_csv({}, {}), "x,y,x_m,y_m\n"); }

TEST(PathCsv, IsSaved) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder / "path.csv", path_csv(Path({{0, 0}}), {})));
  EXPECT_EQ(bytes_of(folder / "path.csv"), "x,y,x_m,y_m\n0,0,0.5,0.5\n");
}

}  // namespace
}  // namespace wend
