#include "wend/map/component_counter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "wend/map/bit_grid.hpp"
#include "wend/map/connected_components.hpp"

namespace wend {
namespace {

ComponentCounter counted(const BitGrid& cells) {
  ComponentCounter counter(cells.width());
  for (int y = 0; y < cells.height(); ++y) counter.add_row(cells.row_words(y));
  return counter;
}

BitGrid drawn(const std::vector<std::string>& rows) {
  BitGrid cells(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      const auto letter = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      cells.set({x, y}, letter == '.');
    }
  }
  return cells;
}

TEST(ComponentCounter, JoinsRegionsThatMeetLater) {
  const ComponentCounter counter = counted(drawn({".#.#.", ".#.##", "...#.", "##.#."}));
  EXPECT_EQ(counter.count(), 3U);
  EXPECT_EQ(counter.largest(), 8U);
}

TEST(ComponentCounter, KnowsNoRegionsWhereThereIsNoCell) {
  EXPECT_EQ(counted(BitGrid(5, 3)).count(), 0U);
  EXPECT_EQ(counted(BitGrid(5, 3)).largest(), 0U);
}

RC_GTEST_PROP(ComponentCounter, CountsWhatConnectedComponentsLabels, ()) {
  BitGrid cells(*rc::gen::inRange(1, 150), *rc::gen::inRange(1, 30));
  const int share = *rc::gen::inRange(1, 10);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) cells.set({x, y}, *rc::gen::inRange(0, 10) < share);
  }
  const auto sizes = ConnectedComponents(cells).sizes(Adjacency::edges);
  const ComponentCounter counter = counted(cells);
  RC_ASSERT(counter.count() == sizes.size());
  RC_ASSERT(counter.largest() == (sizes.empty() ? 0 : sizes.front()));
}

}  // namespace
}  // namespace wend
