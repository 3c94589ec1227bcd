#include "wend/io/primitives/load_primitives.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "tests/testing/build_paths.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kMprim = R"(resolution_m: 0.1
numberofangles: 8
totalnumberofprimitives: 3
primID: 0
startangle_c: 0
endpose_c: 2 0 0
additionalactioncostmult: 1
intermediateposes: 3
0.0 0.0 0.0
0.1 0.0 0.0
0.2 0.0 0.0
primID: 1
startangle_c: 0
endpose_c: 0 0 -1
additionalactioncostmult: 5
intermediateposes: 2
0.0 0.0 0.0
0.0 0.0 -0.7854
primID: 0
startangle_c: 7
endpose_c: 1 -1 7
additionalactioncostmult: 1
intermediateposes: 2
0.0 0.0 5.4978
0.1 -0.1 5.4978
)";

constexpr std::string_view kJson = R"({"version": 1.0,
"lattice_metadata": {"motion_model": "omni", "grid_resolution": 0.05,
                     "heading_angles": [0.0, 0.4636476090008061, 1.5707963267948966]},
"primitives": [
 {"trajectory_id": 4, "start_angle_index": 0, "end_angle_index": 0, "left_turn": true,
  "poses": [[0.0, 0.05, 0.0], [0.0, 0.1, 0.0], [0.0, 0.15, 0.0]]},
 {"trajectory_id": 2, "start_angle_index": 1, "end_angle_index": 0,
  "poses": [[0, 0, 0.4636476], [0, 0, 0.2318], [0, 0, 0]]}]})";

/// The text with one part replaced by another.
std::string with(std::string_view text, std::string_view part, std::string_view other) {
  std::string changed(text);
  const auto at = changed.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return changed.replace(at, part.size(), other);
}

std::string error_of(const std::string& text) {
  const auto primitives = parse_primitives(text, "robot");
  return primitives ? "no error" : primitives.error().message;
}

TEST(LoadPrimitivesTest, ReadsMprim) {
  const auto set = parse_primitives(kMprim, "robot.mprim");
  ASSERT_TRUE(set.has_value()) << set.error().message;
  EXPECT_EQ(set->resolution(), 0.1);
  EXPECT_EQ(set->headings().size(), 8U);
  ASSERT_EQ(set->all().size(), 3U);
  const MotionPrimitive& ahead = set->leaving(0)[0];
  EXPECT_EQ(ahead.by, (Cell{2, 0}));
  EXPECT_EQ(ahead.poses.size(), 2U) << "one segment";
  const MotionPrimitive& turn = set->leaving(0)[1];
  EXPECT_EQ(turn.number, 1);
  EXPECT_EQ(turn.to, 7) << "-1 is the last heading";
  EXPECT_EQ(turn.cost_factor, 5);
  EXPECT_NEAR(segment_between(turn.poses[0], turn.poses[1]).turn, -kPi / 4, 1e-12) << "exact";
  EXPECT_EQ(set->leaving(7)[0].by, (Cell{1, -1}));
}

TEST(LoadPrimitivesTest, ReadsJson) {
  const auto set = parse_primitives(kJson, "robot.json");
  ASSERT_TRUE(set.has_value()) << set.error().message;
  EXPECT_EQ(set->resolution(), 0.05);
  ASSERT_EQ(set->all().size(), 2U);
  const MotionPrimitive& aside = set->all()[0];
  EXPECT_EQ(aside.number, 4);
  EXPECT_EQ(aside.by, (Cell{0, 3}));
  ASSERT_EQ(aside.poses.size(), 2U);
  EXPECT_NEAR(segment_between(aside.poses[0], aside.poses[1]).course, kPi / 2, 1e-9);
  EXPECT_EQ(set->all()[1].by, (Cell{0, 0}));
}

TEST(LoadPrimitivesTest, SaysWhatIsWrongWithMprim) {
  EXPECT_EQ(error_of(""), "robot: the file ends, expected 'resolution_m:'");
  EXPECT_EQ(error_of(with(kMprim, "resolution_m: 0.1", "resolution: 0.1")),
            "robot:1: expected 'resolution_m:', not 'resolution: 0.1'");
  EXPECT_EQ(error_of(with(kMprim, "0.1\n", "0\n")),
            "robot:1: the resolution must be above 0, in metres per cell");
  EXPECT_EQ(error_of(with(kMprim, "numberofangles: 8", "numberofangles: 8.5")),
            "robot:2: numberofangles is 8.5, not a whole number up to 1e+06");
  EXPECT_EQ(error_of(with(kMprim, "numberofangles: 8", "numberofangles: 0")),
            "robot:2: 0 angles, expected 1 to 256");
  EXPECT_EQ(error_of(with(kMprim, "primitives: 3", "primitives: 4")),
            "robot:25: 3 primitives, the header says 4");
  EXPECT_EQ(error_of(with(kMprim, "startangle_c: 7", "startangle_c: 8")),
            "robot:19: startangle_c 8 of primitive 0 is not from 0 to 7");
  EXPECT_EQ(error_of(with(kMprim, "2 0 0", "2 0")), "robot:6: 2 numbers, expected 3");
  EXPECT_EQ(error_of(with(kMprim, "0.2 0.0", "nan 0.0")), "robot:11: 'nan' is not a finite number");
  EXPECT_EQ(error_of(with(kMprim, "poses: 3", "poses: 1")),
            "robot:8: 1 intermediate poses, expected 2 to 1024");
  EXPECT_EQ(error_of(with(kMprim, "endpose_c: 2", "endpose_c: 3")),
            "robot: primitive 0: its last pose (2,0) is not at its vertex (3,0), in cells");
  for (std::size_t size = 0; size < kMprim.rfind(" 5.4978"); size += 7) {
    EXPECT_THAT(error_of(std::string(kMprim.substr(0, size))), HasSubstr("robot")) << size;
  }
}

TEST(LoadPrimitivesTest, SaysWhatIsWrongWithJson) {
  EXPECT_EQ(error_of("{"), "robot: the text is not valid JSON");
  EXPECT_EQ(error_of("{}"), "robot: 'lattice_metadata' is missing");
  EXPECT_EQ(error_of(with(kJson, "0.05,", "-1,")),
            "robot: 'grid_resolution' must be above 0, in metres per cell");
  EXPECT_EQ(error_of(with(kJson, "[0.0, 0.4636476090008061, 1.5707963267948966]", "[]")),
            "robot: 'heading_angles' is empty");
  EXPECT_EQ(error_of(with(kJson, "\"start_angle_index\": 1", "\"start_angle_index\": 3")),
            "robot: primitive 1: 'start_angle_index' 3 is not from 0 to 2");
  EXPECT_EQ(error_of(with(kJson, "[0, 0, 0.2318]", "[0, 0]")),
            "robot: primitive 1: a pose is not a list of three numbers");
  EXPECT_EQ(error_of(with(kJson, "[0, 0, 0.2318]", "[0, 0, \"x\"]")),
            "robot: primitive 1: the heading of a pose is not a finite number");
  EXPECT_EQ(error_of(with(kJson, "\"end_angle_index\": 0, \"left_turn\"", "\"x\": 0, \"y\"")),
            "robot: primitive 0: 'end_angle_index' is missing");
  EXPECT_EQ(error_of(with(kJson, "[0.0, 0.15, 0.0]", "[0.0, 99.0, 0.0]")),
            "robot: primitive 0: it leads more than 256 cells away");
}

/// The files that come with SBPL.
TEST(LoadPrimitivesTest, ReadsRealFiles) {
  const std::filesystem::path folder = test::data_folder() / "sbpl";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "WEND_DATA names no data";
  const auto set = load_primitives(folder / "mprim_unicycle_noturninplace.mprim");
  ASSERT_TRUE(set.has_value()) << set.error().message;
  EXPECT_EQ(set->all().size(), 80U);
  EXPECT_EQ(set->resolution(), 0.025);
  const auto pr2 = load_primitives(folder / "mprim_pr2_10cm.mprim");
  ASSERT_TRUE(pr2.has_value()) << pr2.error().message;
  EXPECT_EQ(pr2->all().size(), 256U);
  for (const MotionPrimitive& primitive : pr2->all()) EXPECT_LE(primitive.poses.size(), 10U);
}

}  // namespace
}  // namespace wend
