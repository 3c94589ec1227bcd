// SPDX-License-Identifier: Apache-2.0
#include "wend_ros/occupancy_costs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <vector>

namespace wend_ros {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

OccupancyLayout layout_of(std::uint32_t width, std::uint32_t height) {
  return {.frame_id = "map",
          .width = width,
          .height = height,
          .frame = {.resolution = 0.05, .origin = {1, 2, 0}, .y_up = true, .metric = true}};
}

TEST(OccupancyCosts, ValuesAreCostsOfACostmap) {
  OccupancyCosts map;
  const std::vector<std::int8_t> values{-1, 0, 50, 64, 65, 100, 101, -5};
  ASSERT_TRUE(map.take(layout_of(4, 2), values));
  EXPECT_THAT(map.costs(), ElementsAre(255, 0, 126, 161, 254, 254, 255, 255));
  EXPECT_EQ(map.layout().width, 4);
  EXPECT_EQ(map.layout().height, 2);
  EXPECT_EQ(map.layout().resolution, 0.05);
  EXPECT_EQ(map.layout().origin, (wend::MapPoint{1, 2}));
  EXPECT_EQ(map.layout().frame_id, "map");
}

RC_GTEST_PROP(OccupancyCosts, UpdatesGiveWhatTheWholeMapGives, ()) {
  const auto width = *rc::gen::inRange<std::uint32_t>(1, 8);
  const auto height = *rc::gen::inRange<std::uint32_t>(1, 8);
  const auto cells = static_cast<std::size_t>(width) * height;
  auto values =
      *rc::gen::container<std::vector<std::int8_t>>(cells, rc::gen::inRange<std::int8_t>(-1, 101));
  OccupancyCosts updated(50);
  RC_ASSERT(updated.take(layout_of(width, height), values).has_value());
  const int count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i) {
    const auto x = *rc::gen::inRange<std::uint32_t>(0, width);
    const auto y = *rc::gen::inRange<std::uint32_t>(0, height);
    const auto columns = *rc::gen::inRange<std::uint32_t>(1, width - x + 1);
    const auto rows = *rc::gen::inRange<std::uint32_t>(1, height - y + 1);
    const auto part = *rc::gen::container<std::vector<std::int8_t>>(
        static_cast<std::size_t>(columns) * rows, rc::gen::inRange<std::int8_t>(-1, 101));
    const OccupancyUpdate update{.frame_id = "map",
                                 .x = static_cast<std::int32_t>(x),
                                 .y = static_cast<std::int32_t>(y),
                                 .width = columns,
                                 .height = rows,
                                 .values = part};
    RC_ASSERT(updated.take(update).has_value());
    for (std::uint32_t row = 0; row < rows; ++row) {
      for (std::uint32_t column = 0; column < columns; ++column) {
        values[static_cast<std::size_t>(y + row) * width + x + column] =
            part[static_cast<std::size_t>(row) * columns + column];
      }
    }
  }
  OccupancyCosts whole(50);
  RC_ASSERT(whole.take(layout_of(width, height), values).has_value());
  RC_ASSERT(std::ranges::equal(updated.costs(), whole.costs()));
}

TEST(OccupancyCosts, WhatIsNotAMapIsRefused) {
  OccupancyCosts map;
  const std::vector<std::int8_t> values(6, 0);
  EXPECT_THAT(map.take({.frame_id = "",
                        .x = 0,
                        .y = 0,
                        .width = 1,
                        .height = 1,
                        .values = {values.data(), 1}})
                  .error()
                  .message,
              HasSubstr("before a map"));
  ASSERT_TRUE(map.take(layout_of(3, 2), values));
  EXPECT_FALSE(map.take(
      {.frame_id = "", .x = 2, .y = 0, .width = 2, .height = 1, .values = {values.data(), 2}}));
  EXPECT_FALSE(map.empty());
  EXPECT_FALSE(map.take(layout_of(3, 3), values));
  EXPECT_TRUE(map.empty());
  OccupancyLayout turned = layout_of(3, 2);
  turned.frame.origin.heading = 1;
  const auto refused = map.take(turned, values);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().status, wend::Status::invalid_map);
}

}  // namespace
}  // namespace wend_ros
