// Map messages and updates of them, against a map that is made anew from all values each time.

#include "wend_ros/occupancy_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace wend_ros {
namespace {

using Values = std::vector<std::int8_t>;

OccupancyLayout layout(std::uint32_t width, std::uint32_t height) {
  return {.frame_id = "map",
          .width = width,
          .height = height,
          .frame = {.resolution = 0.5, .origin = {}, .y_up = true, .metric = true}};
}

/// A map of these values that is made anew.
wend::GridMap made_of(const Values& values, const OccupancyLayout& at, const MapReading& reading) {
  return *map_from(at, values, reading);
}

bool same(const wend::GridMap& a, const wend::GridMap& b) {
  return a.occupied() == b.occupied() && a.unknown() == b.unknown() && a.terrain() == b.terrain() &&
         a.frame() == b.frame();
}

class Values8 {
 public:
  explicit Values8(unsigned seed) : random_(seed) {}
  int below(int most) { return std::uniform_int_distribution<int>(0, most - 1)(random_); }
  std::int8_t value() {
    constexpr std::array<std::int8_t, 8> kValues{-1, 0, 0, 1, 50, 65, 99, 100};
    return below(20) == 0 ? static_cast<std::int8_t>(below(256) - 128)
                          : kValues[static_cast<std::size_t>(below(kValues.size()))];
  }
  Values many(std::size_t count) {
    Values values(count);
    for (std::int8_t& each : values) each = value();
    return values;
  }

 private:
  std::mt19937 random_;
};

/// Applies to a map what OccupancyMap says of a message, as a session does.
void apply(wend::GridMap& map, const wend::MapEdit& edit) {
  if (is_empty(edit)) return;
  const auto changed = map.edit(edit);
  ASSERT_TRUE(changed) << changed.error().message;
}

class AnyReading : public testing::TestWithParam<MapReading> {};

TEST_P(AnyReading, UpdatesAndWholeMapsMakeTheMapOfAllValues) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Values8 draw(seed);
    const int width = 1 + draw.below(20);
    const int height = 1 + draw.below(20);
    const OccupancyLayout at =
        layout(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
    Values now = draw.many(at.size());
    OccupancyMap messages(GetParam());
    auto first = messages.take(at, now);
    ASSERT_TRUE(first && first->whole);
    wend::GridMap map = *std::move(first->whole);
    for (int step = 0; step < 20; ++step) {
      if (draw.below(3) == 0) {
        for (int i = draw.below(6); i > 0; --i) {
          now[static_cast<std::size_t>(draw.below(width * height))] = draw.value();
        }
        const auto change = messages.take(at, now);
        ASSERT_TRUE(change && !change->whole) << "it lies as the one before";
        apply(map, change->edit);
      } else {
        const int x = draw.below(width);
        const int y = draw.below(height);
        const int columns = 1 + draw.below(width - x);
        const int rows = 1 + draw.below(height - y);
        const Values values = draw.many(static_cast<std::size_t>(columns * rows));
        for (int i = 0; i < columns * rows; ++i) {
          now[static_cast<std::size_t>((y + i / columns) * width + x + i % columns)] =
              values[static_cast<std::size_t>(i)];
        }
        const auto edit = messages.take({.frame_id = "map",
                                         .x = x,
                                         .y = y,
                                         .width = static_cast<std::uint32_t>(columns),
                                         .height = static_cast<std::uint32_t>(rows),
                                         .values = values});
        ASSERT_TRUE(edit) << edit.error().message;
        apply(map, *edit);
      }
      const wend::GridMap expected = made_of(now, at, GetParam());
      ASSERT_TRUE(same(map, expected));
      ASSERT_TRUE(same(messages.whole(), expected));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, AnyReading,
                         testing::Values(MapReading{}, MapReading{99, true}, MapReading{50, true}));

OccupancyMap free_map(std::uint32_t width, std::uint32_t height) {
  OccupancyMap map;
  EXPECT_TRUE(map.take(layout(width, height), Values(std::size_t{width} * height, 0)));
  return map;
}

TEST(OccupancyMap, EditsOnlyTheRectangleThatDiffers) {
  OccupancyMap map = free_map(100, 60);
  Values values(6000, 0);
  for (int y = 20; y < 24; ++y) {
    for (int x = 30; x < 35; ++x) values[static_cast<std::size_t>(100 * y + x)] = 100;
  }
  const auto change = map.take(layout(100, 60), values);
  ASSERT_TRUE(change && !change->whole);
  EXPECT_EQ(change->edit.box(), (wend::CellBox{{30, 20}, {35, 24}}));
  EXPECT_TRUE(change->edit.cells.empty());
}

TEST(OccupancyMap, EditsCellsThatLieFarApartOneByOne) {
  OccupancyMap map = free_map(100, 60);
  Values values(6000, 0);
  values.front() = values.back() = 100;
  const auto change = map.take(layout(100, 60), values);
  ASSERT_TRUE(change && !change->whole);
  ASSERT_EQ(change->edit.cells.size(), 2U);
  EXPECT_EQ(change->edit.cells[1].cell, (wend::Cell{99, 59}));
  EXPECT_TRUE(change->edit.box().empty()) << "what lies between is as it was";
}

TEST(OccupancyMap, TheSameValuesAreNoEdit) {
  OccupancyMap map = free_map(10, 10);
  const auto again = map.take(layout(10, 10), Values(100, 0));
  ASSERT_TRUE(again);
  EXPECT_FALSE(again->whole);
  EXPECT_TRUE(is_empty(again->edit));
  const Values two(2, 0);
  EXPECT_TRUE(is_empty(*map.take({.width = 2, .height = 1, .values = two})));
}

TEST(OccupancyMap, AMapThatLiesElsewhereIsAnotherOne) {
  const Values values(100, 0);
  auto moved = layout(10, 10);
  moved.frame.origin.x = 1;
  auto finer = layout(10, 10);
  finer.frame.resolution = 0.25;
  auto renamed = layout(10, 10);
  renamed.frame_id = "odom";
  for (const OccupancyLayout& other : {moved, finer, renamed, layout(5, 20)}) {
    OccupancyMap map = free_map(10, 10);
    EXPECT_TRUE(map.take(other, values)->whole);
    EXPECT_TRUE(map.take(layout(10, 10), values)->whole) << "and so is the first one after it";
  }
}

TEST(OccupancyMap, AnotherReadingChangesTheWholeMap) {
  OccupancyMap map;
  EXPECT_FALSE(map.read_as({.occupied_from = 60})) << "there is no map";
  const Values values{0, 50, 70};
  ASSERT_TRUE(map.take(layout(3, 1), values));
  EXPECT_FALSE(map.read_as({.occupied_from = 60})) << "as before";
  EXPECT_TRUE(map.read_as({.occupied_from = 99, .rough = true}));
  EXPECT_EQ(map.whole().terrain({1, 0}), 3);
  EXPECT_EQ(map.whole().state({2, 0}), wend::CellState::free);
}

/// What an update of so many zeros is refused with, empty if it is not; the map stays in either case.
std::string fault_at(std::int32_t x, std::int32_t y, std::uint32_t width, std::uint32_t height,
                     std::size_t values, const std::string& frame_id = "map") {
  OccupancyMap map;
  EXPECT_TRUE(map.take(layout(10, 5), Values(50, 100)));
  const Values zeros(values, 0);
  const auto edit = map.take({frame_id, x, y, width, height, zeros});
  const wend::GridMap all_occupied = made_of(Values(50, 100), map.layout(), {});
  EXPECT_EQ(same(map.whole(), all_occupied), !edit || is_empty(*edit));
  return edit ? std::string() : edit.error().message;
}

TEST(OccupancyMap, RefusesAnUpdateOutsideOfTheMapWithTheNumbers) {
  const std::string size = ", and the map has 10 x 5 cells: columns 0 to 9, rows 0 to 4";
  EXPECT_EQ(fault_at(0, 0, 10, 5, 50), "");
  EXPECT_EQ(fault_at(9, 4, 1, 1, 1), "");
  EXPECT_EQ(fault_at(8, 0, 4, 2, 8), "it covers columns 8 to 11 and rows 0 to 1" + size);
  EXPECT_EQ(fault_at(0, 4, 1, 2, 2), "it covers columns 0 to 0 and rows 4 to 5" + size);
  EXPECT_EQ(fault_at(-1, -2, 1, 1, 1), "it covers columns -1 to -1 and rows -2 to -2" + size);
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(fault_at(kMost, kMost, 2, 1, 2),
            "it covers columns 2147483647 to 2147483648 and rows 2147483647 to 2147483647" + size);
}

TEST(OccupancyMap, RefusesAnUpdateWithAnotherNumberOfValues) {
  EXPECT_EQ(fault_at(0, 0, 3, 3, 8), "it has 8 values, 3 x 3 = 9 expected");
  EXPECT_EQ(fault_at(0, 0, 0, 3, 1), "it has 1 values, 0 x 3 = 0 expected");
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(fault_at(0, 0, kMost, kMost, 1),
            "it has 1 values, 4294967295 x 4294967295 = 18446744065119617025 expected");
  EXPECT_EQ(fault_at(50, 50, 0, 3, 0), "") << "nothing changes";
}

TEST(OccupancyMap, RefusesAnUpdateInAnotherFrame) {
  EXPECT_EQ(fault_at(0, 0, 1, 1, 1, "odom"), "it is in the frame 'odom', and the map is in 'map'");
  EXPECT_EQ(fault_at(0, 0, 1, 1, 1, ""), "") << "the map's";
}

TEST(OccupancyMap, RefusesAnUpdateWithoutAMap) {
  OccupancyMap map;
  const Values one(1, 0);
  EXPECT_EQ(map.take({.width = 1, .height = 1, .values = one}).error().message,
            "there is no map yet");
  ASSERT_TRUE(map.take(layout(2, 2), Values(4, 0)));
  EXPECT_FALSE(map.take(layout(2, 2), Values(3, 0))) << "this is no map";
  EXPECT_TRUE(map.empty());
  EXPECT_FALSE(map.take({.width = 1, .height = 1, .values = one}));
}

/// Maps and updates of 6 x 5 cells whose values are the numbers of the messages.
class Order : public testing::Test {
 protected:
  void put_map(Stamp stamp, std::int8_t value, const OccupancyLayout& at = layout(6, 5)) {
    const auto change = map_.take(at, Values(at.size(), value), stamp);
    ASSERT_TRUE(change);
    keeps_newer_ = change->keeps_newer;
    if (change->whole) {
      edited_ = *change->whole;
    } else {
      apply(*edited_, change->edit);
    }
  }

  /// False if it is not used.
  bool put(Stamp stamp, int x, int y, std::uint32_t width, std::uint32_t height,
           std::int8_t value) {
    const Values values(std::size_t{width} * height, value);
    const auto edit =
        map_.take({.x = x, .y = y, .width = width, .height = height, .values = values}, stamp);
    if (edit) apply(*edited_, *edit);
    return edit.has_value();
  }

  /// The state of a cell, in the map and in the one that was edited.
  wend::CellState at(int x, int y) {
    EXPECT_TRUE(same(map_.whole(), *edited_));
    return map_.whole().state({x, y});
  }

  OccupancyMap map_;
  std::optional<wend::GridMap> edited_;
  bool keeps_newer_ = false;
};

constexpr auto kFree = wend::CellState::free;
constexpr auto kOccupied = wend::CellState::occupied;

TEST_F(Order, AWholeMapNeverRemovesANewerUpdate) {
  put_map(10, 0);
  ASSERT_TRUE(put(12, 2, 1, 2, 3, 100));
  put_map(11, 0);
  EXPECT_TRUE(keeps_newer_);
  EXPECT_EQ(at(2, 1), kOccupied);
  EXPECT_EQ(at(3, 3), kOccupied);
  EXPECT_EQ(at(4, 3), kFree);
  EXPECT_EQ(map_.stamp(), 12);
  put_map(11, 0);
  EXPECT_EQ(at(2, 1), kOccupied) << "nor does it if it comes again";
  put_map(12, 0);
  EXPECT_FALSE(keeps_newer_);
  EXPECT_EQ(at(2, 1), kFree) << "it is as new: the update is in it";
}

TEST_F(Order, AnOlderMapCountsWhereNoNewerUpdateWas) {
  put_map(10, 0);
  ASSERT_TRUE(put(12, 2, 1, 2, 3, 0));
  put_map(11, 100);
  EXPECT_EQ(at(2, 1), kFree);
  EXPECT_EQ(at(1, 1), kOccupied);
}

TEST_F(Order, AnUpdateThatIsOlderThanTheMapIsNotUsed) {
  put_map(10, 0);
  EXPECT_FALSE(put(9, 2, 1, 2, 3, 100));
  EXPECT_EQ(at(2, 1), kFree);
  EXPECT_EQ(map_.stamp(), 10);
  EXPECT_TRUE(put(10, 2, 1, 2, 3, 100)) << "this is not older";
  EXPECT_EQ(at(2, 1), kOccupied);
  const Values one(1, 0);
  EXPECT_EQ(map_.take({.width = 1, .height = 1, .values = one}, 8).error().message,
            "its stamp is 2e-09 s older than that of the map");
}

TEST_F(Order, UpdatesCountInTheOrderInWhichTheyCome) {
  put_map(10, 0);
  ASSERT_TRUE(put(13, 2, 1, 1, 1, 100));
  ASSERT_TRUE(put(12, 2, 1, 1, 1, 0));
  EXPECT_EQ(at(2, 1), kFree);
  EXPECT_EQ(map_.stamp(), 13);
}

TEST_F(Order, MessagesWithoutAStampCountAsTheyCome) {
  put_map(0, 0);
  ASSERT_TRUE(put(12, 2, 1, 1, 1, 100));
  put_map(0, 0);
  EXPECT_EQ(at(2, 1), kFree);
  put_map(20, 0);
  ASSERT_TRUE(put(0, 2, 1, 1, 1, 100));
  EXPECT_EQ(at(2, 1), kOccupied);
  put_map(19, 0);
  EXPECT_EQ(at(2, 1), kFree);
}

TEST_F(Order, AnOlderMapThatLiesElsewhereKeepsNewerUpdatesToo) {
  put_map(10, 0);
  ASSERT_TRUE(put(12, 2, 1, 1, 1, 100));
  OccupancyLayout grown = layout(10, 9);
  grown.frame.origin.x = -1;  // two cells
  put_map(11, 0, grown);
  EXPECT_EQ(at(4, 1), kOccupied);
  put_map(11, 0);
  EXPECT_EQ(at(2, 1), kOccupied) << "and back";
  OccupancyLayout odom = layout(6, 5);
  odom.frame_id = "odom";
  put_map(11, 0, odom);
  EXPECT_EQ(at(2, 1), kFree) << "nobody knows where that is";
}

/// Random messages in random order, against cells that each remember what came last.
TEST_F(Order, IsThatOfTheNewestMessageOfEachCell) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Values8 draw(seed);
    map_ = OccupancyMap();
    constexpr int kWidth = 6;
    constexpr int kHeight = 5;
    std::array<std::int8_t, kWidth * kHeight> values{};
    std::array<Stamp, kWidth * kHeight> updated{};  // newer than the whole map; else 0
    Stamp whole = 1 + draw.below(5);
    put_map(whole, 0);
    for (int step = 0; step < 30; ++step) {
      const Stamp stamp = 1 + step / 2 + draw.below(6);
      const auto value = static_cast<std::int8_t>(draw.below(2) * 100);
      if (draw.below(4) == 0) {
        whole = stamp;
        put_map(stamp, value);
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (updated[i] > stamp) continue;
          values[i] = value;
          updated[i] = 0;
        }
      } else {
        const int x = draw.below(kWidth);
        const int y = draw.below(kHeight);
        const int columns = 1 + draw.below(kWidth - x);
        const int rows = 1 + draw.below(kHeight - y);
        ASSERT_EQ(put(stamp, x, y, static_cast<std::uint32_t>(columns),
                      static_cast<std::uint32_t>(rows), value),
                  stamp >= whole);
        if (stamp < whole) continue;
        for (int i = 0; i < columns * rows; ++i) {
          const auto cell = static_cast<std::size_t>((y + i / columns) * kWidth + x + i % columns);
          values[cell] = value;
          updated[cell] = stamp;
        }
      }
      for (int i = 0; i < kWidth * kHeight; ++i) {
        const auto expected = values[static_cast<std::size_t>(i)] == 100 ? kOccupied : kFree;
        ASSERT_EQ(at(i % kWidth, i / kWidth), expected) << i;
      }
    }
  }
}

}  // namespace
}  // namespace wend_ros
