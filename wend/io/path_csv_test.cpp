#include "wend/io/path_csv.hpp"

#include <gtest/gtest.h>

#include "wend/io/io_test_support.hpp"

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

TEST(PathCsv, AnEmptyPathIsAHeader) { EXPECT_EQ(path_csv({}, {}), "x,y,x_m,y_m\n"); }

TEST(PathCsv, IsSaved) {
  const TemporaryFolder folder;
  ASSERT_TRUE(save_path_csv(Path({{0, 0}}), {}, folder / "path.csv"));
  EXPECT_EQ(bytes_of(folder / "path.csv"), "x,y,x_m,y_m\n0,0,0.5,0.5\n");
}

}  // namespace
}  // namespace wend
