#include "wend/map/region_counter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "wend/map/connected_regions.hpp"

namespace wend {
namespace {

RegionCounter counted(const BitGrid& cells) {
  RegionCounter counter(cells.width());
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

TEST(RegionCounter, JoinsRegionsThatMeetLater) {
  const RegionCounter counter = counted(drawn({".#.#.", ".#.##", "...#.", "##.#."}));
  EXPECT_EQ(counter.count(), 3U);
  EXPECT_EQ(counter.largest(), 8U);
}

TEST(RegionCounter, KnowsNoRegionsWhereThereIsNoCell) {
  EXPECT_EQ(counted(BitGrid(5, 3)).count(), 0U);
  EXPECT_EQ(counted(BitGrid(5, 3)).largest(), 0U);
}

RC_GTEST_PROP(RegionCounter, CountsWhatConnectedRegionsLabels, ()) {
  BitGrid cells(*rc::gen::inRange(1, 150), *rc::gen::inRange(1, 30));
  const int share = *rc::gen::inRange(1, 10);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) cells.set({x, y}, *rc::gen::inRange(0, 10) < share);
  }
  const auto sizes = ConnectedRegions(cells).sizes(Adjacency::edges);
  const RegionCounter counter = counted(cells);
  RC_ASSERT(counter.count() == sizes.size());
  RC_ASSERT(counter.largest() == (sizes.empty() ? 0 : sizes.front()));
}

}  // namespace
}  // namespace wend
