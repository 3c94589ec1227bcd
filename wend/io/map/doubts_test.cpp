#include "wend/io/map/doubts.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "tests/testing/whole_image.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/save_map.hpp"

namespace wend {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Frame frame_with(double resolution, double yaw) {
  return {.resolution = resolution, .origin = {0, 0, yaw}, .y_up = true, .metric = true};
}

/// Doubts about one row of grey values.
std::vector<std::string> doubts_in(const std::vector<std::uint16_t>& values,
                                   const ImageMeaning& meaning, int maximum = 255) {
  ImageMapRows rows(meaning);
  rows.begin(static_cast<int>(values.size()), 1, maximum);
  rows.add(values, {});
  const GridMap map = *rows.finish({});
  return doubts_about(rows, meaning, map);
}

TEST(Doubts, AYawBeyondAFullTurnCanOnlyBeDegrees) {
  for (const double yaw : {0.0, 1.5707963, -3.14159, 6.28319, -6.2832}) {
    EXPECT_THAT(doubts_about(frame_with(0.05, yaw)), IsEmpty()) << yaw;
  }
  EXPECT_THAT(doubts_about(frame_with(0.05, 90)),
              ElementsAre("the yaw of the origin is read in radians: 90 is more than a full turn; "
                          "90 degrees are 1.5708 radians"));
  EXPECT_THAT(doubts_about(frame_with(0.05, -45)),
              ElementsAre(HasSubstr("-45 degrees are -0.7854")));
  EXPECT_THAT(doubts_about(frame_with(0.05, 270)),
              ElementsAre(HasSubstr("270 degrees are -1.5708")));
}

TEST(Doubts, AResolutionMayBeInAnotherUnit) {
  for (const double metres : {0.001, 0.05, 1.0, 10.0}) {
    EXPECT_THAT(doubts_about(frame_with(metres, 0)), IsEmpty());
  }
  for (const double other : {50.0, 0.0005}) {
    EXPECT_THAT(doubts_about(frame_with(other, 0)), ElementsAre(HasSubstr("metres a cell")));
  }
}

TEST(Doubts, TheUnknownGreyOfMapSaversMayBecomeFreeOrOccupied) {
  const std::vector<std::uint16_t> saved = {0, 205, 254, 205};
  EXPECT_THAT(doubts_in(saved, {}), IsEmpty());
  EXPECT_THAT(
      doubts_in(saved, {.free_threshold = 0.25}),
      ElementsAre("grey 205, which map savers write for unknown, counts as free here (2 cells): "
                  "free_thresh 0.25 is not below its occupancy of 0.1961"));
  EXPECT_THAT(doubts_in(saved, {.occupied_threshold = 0.19, .free_threshold = 0.1}),
              ElementsAre(HasSubstr("counts as occupied here (2 cells): occupied_thresh 0.19")));
  EXPECT_THAT(doubts_in(saved, {.negate = true}), ElementsAre(HasSubstr("with negate: 1")));
  EXPECT_THAT(doubts_in({0, 254}, {.free_threshold = 0.25}), IsEmpty()) << "there is no such grey";
  EXPECT_THAT(doubts_in({0, 205 * 257, 65535}, {.free_threshold = 0.25}, 65535),
              ElementsAre(HasSubstr("(1 cell)")));
  EXPECT_THAT(doubts_in(saved, {.mode = ImageMode::scale, .free_threshold = 0.25}), IsEmpty())
      << "savers write unknown cells of this mode transparent";
}

TEST(Doubts, ValuesOfFewerBitsAreAlmostBlack) {
  EXPECT_THAT(doubts_in({0, 205, 254}, {}, 65535),
              ElementsAre(HasSubstr("the brightest pixel is 254 where white is 65535")));
  EXPECT_THAT(doubts_in({0, 1}, {}),
              ElementsAre(HasSubstr("the brightest pixel is 1 where white is 255")));
  EXPECT_THAT(doubts_in({0, 100, 255}, {.mode = ImageMode::raw}, 65535),
              ElementsAre(HasSubstr("almost black")));
  EXPECT_THAT(doubts_in({0, 1}, {.mode = ImageMode::raw}), IsEmpty()) << "values of cells";
  EXPECT_THAT(doubts_in({0, 0}, {}), IsEmpty()) << "all black is all black";
  EXPECT_THAT(doubts_in({0, 1}, {}, 1), IsEmpty()) << "a bitmap";
}

TEST(Doubts, AStateThatNoCellHas) {
  EXPECT_THAT(doubts_in({0, 254}, {.free_threshold = 0}),
              ElementsAre(HasSubstr(
                  "no cell is free: the occupancies of its pixels are 0.0039 to 1.0000")));
  EXPECT_THAT(doubts_in({100, 254}, {}), ElementsAre(HasSubstr("no cell is occupied")));
  EXPECT_THAT(doubts_in({254, 254}, {}), IsEmpty()) << "an empty room has one grey";
}

TEST(Doubts, WhatWendSavesRaisesNone) {
  const TemporaryFolder folder;
  const auto map = parse_map("..#\n?#.\n", "m.txt");
  for (const char* name : {"m.yaml", "m.png", "m.pgm"}) {
    ASSERT_TRUE(save_map(map->map, folder / name));
    EXPECT_THAT(load_map(folder / name)->notes, IsEmpty()) << name;
  }
}

}  // namespace
}  // namespace wend
