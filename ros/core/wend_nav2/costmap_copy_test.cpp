// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/costmap_copy.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wend_nav2/costmaps_test.hpp"

namespace wend_nav2 {
namespace {

using test::Costmap;
using test::costmap_of;
using test::empty_costmap;

void expect_map_of(const wend::Session& session, const Costmap& expected,
                   const wend::CostmapScale& scale) {
  const auto view = session.view();
  RC_ASSERT(view.has_value());
  const wend::GridMap& map = view->space.map();
  RC_ASSERT(map.width() == expected.layout.width);
  RC_ASSERT(map.height() == expected.layout.height);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const wend::CellMeaning meaning = wend::meaning_of_cost(expected.at(x, y), scale);
      RC_ASSERT(map.state({x, y}) == meaning.state);
      if (meaning.state == wend::CellState::free) {
        RC_ASSERT(map.terrain({x, y}) == meaning.terrain.value_or(1));
      }
    }
  }
}

RC_GTEST_PROP(CostmapCopy, TheSessionHasTheCostsThatWereReadLast, ()) {
  const int width = *rc::gen::inRange(1, 12);
  const int height = *rc::gen::inRange(1, 12);
  Costmap map = empty_costmap(width, height);
  wend::Session session;
  CostmapCopy copy;
  wend::CostmapScale scale{.cost_factor = 2};
  for (int n = 0; n < 6; ++n) {
    const int changes = *rc::gen::inRange(0, width * height);
    for (int i = 0; i < changes; ++i) {
      const int x = *rc::gen::inRange(0, width);
      const int y = *rc::gen::inRange(0, height);
      map.at(x, y) = *rc::gen::elementOf(std::vector<std::uint8_t>{0, 1, 100, 252, 253, 254, 255});
    }
    const bool other_scale = *rc::gen::inRange(0, 5) == 0;
    if (other_scale) scale.inscribed_blocked = !scale.inscribed_blocked;
    const bool moves = *rc::gen::inRange(0, 5) == 0;
    if (moves) map.layout.origin.x += 0.1;
    copy.read(map.layout, map.costs);
    const bool read_twice = *rc::gen::arbitrary<bool>();
    if (read_twice) copy.read(map.layout, map.costs);
    RC_ASSERT(copy.bring_to(session, scale).has_value());
    expect_map_of(session, map, scale);
  }
}

TEST(CostmapCopy, GivesAMapOnceAndThenOnlyWhatChanged) {
  Costmap map = empty_costmap(50, 40);
  wend::Session session;
  CostmapCopy copy;
  const auto bring = [&] {
    copy.read(map.layout, map.costs);
    ASSERT_TRUE(copy.bring_to(session, {}));
  };
  bring();
  bring();
  EXPECT_EQ(copy.given().maps, 1U);
  EXPECT_EQ(copy.given().edits, 0U);
  map.at(3, 4) = 254;
  bring();
  EXPECT_EQ(copy.given().maps, 1U);
  EXPECT_EQ(copy.given().edits, 1U);
  map.layout.origin.y = 5;  // a rolling window moved
  bring();
  EXPECT_EQ(copy.given().maps, 2U);
  EXPECT_EQ(session.view()->space.map().frame().origin.y, 5);
}

TEST(CostmapCopy, WithoutCostsThereIsNoMap) {
  wend::Session session;
  CostmapCopy copy;
  EXPECT_FALSE(copy.bring_to(session, {}));
  Costmap map = empty_costmap(4, 4);
  map.costs.pop_back();
  copy.read(map.layout, map.costs);
  const auto brought = copy.bring_to(session, {});
  ASSERT_FALSE(brought);
  EXPECT_EQ(brought.error().message, "the map has 15 values, 4 x 4 expected");
  EXPECT_FALSE(session.view());
  map.costs.push_back(0);
  copy.read(map.layout, map.costs);
  EXPECT_TRUE(copy.bring_to(session, {}));
}

}  // namespace
}  // namespace wend_nav2
