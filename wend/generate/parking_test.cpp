#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/generate/generated_map_test.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/map/random_bits_test.hpp"

namespace wend {
namespace {

using test::all_cells;
using test::drawn;
using test::made;

/// A reference car that shares no code with the library's: it stands on corners that touch no obstacle
/// and makes six moves. It visits every pose that it can reach from the corner (0, 0), facing east.
class Car {
 public:
  explicit Car(const GridMap& map) : map_(map), headings_(map.width() + 1, map.height() + 1) {
    std::vector<State> stack;
    enter({0, 0}, kEast, stack);
    while (!stack.empty()) {
      const auto [at, heading] = stack.back();
      stack.pop_back();
      const Cell ahead = kAhead[heading];
      const Cell behind{-ahead.x, -ahead.y};
      const unsigned to_the_right = (heading + 1) % 4;
      const unsigned to_the_left = (heading + 3) % 4;
      enter(sum(at, ahead), heading, stack);
      enter(sum(at, behind), heading, stack);
      enter(sum(at, ahead, kAhead[to_the_right]), to_the_right, stack);
      enter(sum(at, ahead, kAhead[to_the_left]), to_the_left, stack);
      enter(sum(at, behind, kAhead[to_the_right]), to_the_left, stack);
      enter(sum(at, behind, kAhead[to_the_left]), to_the_right, stack);
    }
  }

  bool can_stand(Cell corner) const {
    if (!headings_.contains(corner)) return false;
    for (const Cell cell : {corner, Cell{corner.x - 1, corner.y}, Cell{corner.x, corner.y - 1},
                            Cell{corner.x - 1, corner.y - 1}}) {
      if (map_.contains(cell) && map_.state(cell) != CellState::free) return false;
    }
    return true;
  }

  bool reached(Cell corner) const { return headings_[corner] != 0; }

 private:
  struct State {
    Cell corner;
    unsigned heading;
  };

  static constexpr std::array<Cell, 4> kAhead{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};  // y down
  static constexpr unsigned kEast = 1;

  static Cell sum(Cell a, Cell b, Cell c = {}) { return {a.x + b.x + c.x, a.y + b.y + c.y}; }

  void enter(Cell corner, unsigned heading, std::vector<State>& stack) {
    if (!can_stand(corner) || (headings_[corner] & 1U << heading) != 0) return;
    headings_[corner] |= 1U << heading;
    stack.push_back({corner, heading});
  }

  GridMap map_;
  Grid<unsigned> headings_;  // by corner: a bit for each heading in which it was reached
};

GridMap parking(int width, int height, std::uint64_t seed, double occupied, double rough = 0) {
  return made("parking", width, height, seed,
              {{"occupied", format_number(occupied)}, {"rough", format_number(rough)}});
}

TEST(ParkingGenerator, LooksTheSameOnEveryPlatform) {
  EXPECT_EQ(drawn(made("parking", 34, 21, 7)),
            "..22.#.##.##.##.##....##.##2#.....\n"
            ".....#.##.##.##.##....##.##.#.....\n"
            ".....#.##.##.##.##....##.##.#.....\n"
            "..........##.##..........##.......\n"
            "..................................\n"
            "..................................\n"
            "..................................\n"
            "..................................\n"
            ".......##.##..........##..........\n"
            "222..#.##.##.##.......##....#.....\n"
            "2222.#.##.##.##.......##....#.....\n"
            "22222#.##2##2##.......##....#.....\n"
            "22.22#...2222...............#.....\n"
            "2..22#..........##.##.##....#.....\n"
            "...22#..........##.##.##....#.....\n"
            "..222#..........##.##.##....#.....\n"
            "..22222...........................\n"
            "...2222...........................\n"
            "......2222........................\n"
            "........222.......................\n"
            ".........2........................\n");
}

TEST(ParkingGenerator, LetsACarOntoEveryCornerThatTouchesNoObstacle) {
  for (std::uint64_t seed = 0; seed < test::share_of(80U); ++seed) {
    Random random(seed);
    const GeneratorInfo& info = *generators().find("parking");
    const int width = info.least_width + (seed % 8 == 0 ? 0 : random.between(0, 120));
    const int height = info.least_height + (seed % 8 == 0 ? 0 : random.between(0, 80));
    const double occupied = std::array{0.0, 0.3, 0.7, 0.7, 0.95, 1.0}[random.below(6)];
    const GridMap map = parking(width, height, seed, occupied);
    SCOPED_TRACE(testing::Message() << "seed " << seed << '\n' << drawn(map));
    const Car car(map);
    ASSERT_TRUE(car.reached({0, 0}));
    ASSERT_TRUE(car.reached({width, height}));
    for (const Cell corner : all_cells(width + 1, height + 1)) {
      ASSERT_EQ(car.reached(corner), car.can_stand(corner)) << corner.x << ',' << corner.y;
    }
  }
}

/// The number of corners at the yard's upper edge that a car reaches: where a road ends, and in the bays.
int reached_at_upper_edge(const GridMap& map) {
  const Car car(map);
  int reached = 0;
  for (int x = 0; x <= map.width(); ++x) reached += car.reached({x, 0}) ? 1 : 0;
  return reached;
}

TEST(ParkingGenerator, HasEmptyBaysToParkIn) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const int without = reached_at_upper_edge(parking(100, 40, seed, 1));
    EXPECT_EQ(without, 4 + 3 + 5) << "at the ends of roads of 4, 4 and 5 cells";
    const int with_some = reached_at_upper_edge(parking(100, 40, seed, 0.7));
    EXPECT_GE(with_some, without + 3);
  }
}

TEST(ParkingGenerator, ParksCarsInTheShareOfBaysThatItIsTold) {
  const auto objects = [](double occupied) {
    const GridMap map = parking(600, 500, 3, occupied);
    return static_cast<double>(ConnectedComponents(map.occupied()).count(Adjacency::edges));
  };
  const double kerbs = objects(0);
  const double bays = objects(1) - kerbs;
  EXPECT_GT(bays, 5000);
  for (const double share : {0.05, 0.3, 0.7, 0.95}) {
    EXPECT_NEAR((objects(share) - kerbs) / bays, share, 0.03);
  }
}

TEST(ParkingGenerator, WearsTheShareOfTheGroundThatItIsTold) {
  for (const double share : {0.0, 0.08, 0.5, 1.0}) {
    const GridMap map = parking(200, 150, 5, 0.7, share);
    int free = 0;
    int rough = 0;
    for (const Cell cell : all_cells(200, 150)) {
      const double cost = map.terrain(cell);
      ASSERT_TRUE(cost == 1 || (cost == 2 && map.state(cell) == CellState::free));
      free += map.state(cell) == CellState::free ? 1 : 0;
      rough += cost == 2 ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(rough) / free, share, 0.03);
    EXPECT_EQ(map.uniform_terrain(), share == 0);
  }
}

TEST(ParkingGenerator, HasAPlainFrame) { EXPECT_EQ(made("parking", 60, 40, 1).frame(), Frame{}); }

}  // namespace
}  // namespace wend
