#include "wend/robot/disc_ring.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {
namespace {

BitGrid random_cells(Random& random, int width, int height, double share) {
  BitGrid cells(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) cells.set({x, y}, random.chance(share));
  }
  return cells;
}

/// Is there a point on some ring around a point of the cell that lies in a cell of `centres`? By many samples.
bool sampled(const BitGrid& centres, bool outside, Cell cell, double distance, BasePlace place) {
  constexpr int kAngles = 90;
  constexpr int kPlaces = 5;
  const int places = place == BasePlace::middle ? 1 : kPlaces;
  for (int i = 0; i < places * places; ++i) {
    const double share = places == 1 ? 0.5 : 1.0 / (places - 1);
    const Point base = places == 1
                           ? centre_of(cell)
                           : Point{cell.x + share * (i % places), cell.y + share * (i / places)};
    for (int k = 0; k < kAngles; ++k) {
      const double angle = 2 * kPi * k / kAngles;
      const Cell at{static_cast<int>(std::floor(base.x + distance * std::cos(angle))),
                    static_cast<int>(std::floor(base.y + distance * std::sin(angle)))};
      if (centres.contains(at) ? centres[at] : outside) return true;
    }
  }
  return false;
}

/// No cell is missed, and those that are taken are near one: at most a cell farther than the ring.
TEST(DiscRing, FindsTheCellsFromWhichACentreIsOnTheRing) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const int width = random.between(1, 150);
    const int height = random.between(1, 12);
    const BitGrid centres = random_cells(random, width, height, random.chance(0.5) ? 0.02 : 0.2);
    const bool outside = random.chance(0.5);
    const BasePlace place = random.chance(0.5) ? BasePlace::middle : BasePlace::anywhere;
    const double distance = 9 * random.uniform();
    const DiscRing ring(distance, place);
    BitGrid cells(width, height);
    ring.spread(centres, outside, CellBox::of(cells), cells);
    for (const Cell cell : every_cell(cells)) {
      if (sampled(centres, outside, cell, distance, place)) {
        ASSERT_TRUE(cells[cell]) << seed << ": " << cell.x << ',' << cell.y;
      }
      if (!cells[cell] || outside) continue;
      double gap = width + height;
      for (const Cell other : every_cell(centres)) {
        if (!centres[other]) continue;
        const double away = std::hypot(cell.x - other.x, cell.y - other.y);
        gap = std::min(gap, std::abs(away - distance));
      }
      ASSERT_LE(gap, place == BasePlace::middle ? 0.71 : 1.42)
          << seed << ": " << cell.x << ',' << cell.y;
    }
  }
}

TEST(DiscRing, ChangesOnlyWhatABoxTouches) {
  Random random(7);
  const BitGrid centres = random_cells(random, 200, 20, 0.1);
  const DiscRing ring(4.5, BasePlace::middle);
  BitGrid all(200, 20);
  ring.spread(centres, true, CellBox::of(all), all);
  BitGrid part(200, 20);
  const CellBox box{{70, 5}, {90, 9}};
  ring.spread(centres, true, box, part);
  for (const Cell cell : every_cell(all)) {
    if (box.contains(cell)) {
      EXPECT_EQ(part[cell], all[cell]);
    } else if (cell.y < box.begin.y || cell.y >= box.end.y) {
      EXPECT_FALSE(part[cell]);
    }
  }
}

TEST(DiscRing, TakesEveryCellWhereItIsTooLarge) {
  const DiscRing ring(1e7, BasePlace::anywhere);
  BitGrid cells(70, 3);
  ring.spread(BitGrid(70, 3), false, CellBox::of(cells), cells);
  EXPECT_EQ(cells.count(), 210);
}

}  // namespace
}  // namespace wend
