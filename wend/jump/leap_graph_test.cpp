#include "wend/jump/leap_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {
namespace {

using Cost = std::uint64_t;

BitGrid random_leap_map(Random& random) {
  BitGrid cells(random.between(1, 40), random.between(1, 40));
  const double share = 0.4 + 0.6 * random.uniform();
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) cells.set({x, y}, random.chance(share));
  }
  return cells;
}

/// Straight corridors around blocks, with a way round each.
BitGrid corridors(int width, int height) {
  BitGrid cells(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) cells.set({x, y}, x % 5 == 0 || y % 4 == 0);
  }
  return cells;
}

/// A map's leaps beside its jumps, one by one.
class Map {
 public:
  explicit Map(const BitGrid& cells)
      : jumps_(std::make_shared<const JumpGraph>(std::make_shared<const JumpBoards>(cells))),
        leaps_(jumps_),
        width_(cells.width()),
        height_(cells.height()) {}

  const JumpGraph& jumps() const { return *jumps_; }
  LeapGraph& leaps() { return leaps_; }

  std::vector<Jump> next(Jump jump) const {
    std::vector<Jump> next;
    jumps_->append_jumps(cell(jump), jumps_->directions(jump), next);
    return next;
  }
  Cell cell(Jump jump) const { return jumps_->cell(jump.number()); }

  /// Calls visit(jump) for each that a search could come to.
  template <class Visit>
  void for_each_jump(Visit&& visit) const {
    std::vector<Jump> jumps;
    std::vector<bool> known(kArrivals * jumps_->size());
    const auto add = [&](Jump jump) {
      if (!known[jump.code()]) jumps.push_back(jump);
      known[jump.code()] = true;
    };
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        if (!jumps_->boards().passable({x, y})) continue;
        std::vector<Jump> first;
        jumps_->append_jumps({x, y}, 0xFF, first);
        for (const Jump jump : first) add(jump);
      }
    }
    for (std::size_t i = 0; i < jumps.size(); ++i) {
      visit(jumps[i]);
      for (const Jump jump : next(jumps[i])) add(jump);
    }
  }

  /// Is a cell in sight of a jump point, one of the ways that it is left?
  bool sees(Jump jump, Cell goal) const {
    const Cell from = cell(jump);
    if (goal == from) return true;
    if (!jumps_->boards().passable(goal) || !jumps_->boards().sight().sees(from, goal))
      return false;
    const int right = (goal.x > from.x) - (goal.x < from.x);
    const int down = (goal.y > from.y) - (goal.y < from.y);
    for (unsigned i = 0; i < kDirections; ++i) {
      if (kDrawnSteps[i] == Cell{right, down}) {
        return (jumps_->directions(jump) & set_of(static_cast<Direction>(i))) != 0;
      }
    }
    return false;
  }

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  std::shared_ptr<const JumpGraph> jumps_;
  LeapGraph leaps_;
  int width_;
  int height_;
};

/// The jump points of a leap, its end included.
std::vector<Jump> chain_of(const LeapGraph& leaps, const Leap& leap) {
  std::vector<Jump> chain{leap.first()};
  while (chain.back() != leap.last()) chain.push_back(leaps.only_next(chain.back()));
  return chain;
}

/// A leap goes where there is no choice, and costs what its jumps do.
void expect_chain(Map& map, Jump from, const Leap& leap) {
  const std::vector<Jump> chain = chain_of(map.leaps(), leap);
  Cost cost = 0;
  Cell at = map.cell(from);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    cost += octile_cost<Cost>(at, map.cell(chain[i]));
    at = map.cell(chain[i]);
    if (i + 1 == chain.size()) break;
    EXPECT_EQ(map.next(chain[i]), std::vector{chain[i + 1]}) << "there is a choice";
  }
  EXPECT_EQ(leap.cost<Cost>(map.cell(from), at), cost);
  EXPECT_TRUE(!leap.dead() || map.next(leap.last()).empty());
}

/// What is seen from a jump point on the way may be seen by the leap, or else is seen from the next
/// one too, and its end goes on.
void expect_seen(Map& map, const Leap& leap) {
  const std::vector<Jump> chain = chain_of(map.leaps(), leap);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (leap.may_see(map.leaps().raster().place({x, y}))) continue;
      for (std::size_t i = 0; i < chain.size(); ++i) {
        const bool last = i + 1 == chain.size();
        if (last && !leap.dead()) break;
        EXPECT_TRUE(!map.sees(chain[i], {x, y}) || (!last && map.sees(chain[i + 1], {x, y})))
            << "cell " << x << ',' << y << " from jump point " << i << " of " << chain.size();
      }
    }
  }
}

void expect_right_leaps(const BitGrid& cells, int& passed, int& dead) {
  Map map(cells);
  map.for_each_jump([&](Jump from) {
    SCOPED_TRACE("jump point " + std::to_string(from.number()) + ", reached in " +
                 std::to_string(from.arrival()));
    std::vector<Leap> leaps;  // apart: to look at them asks for more
    for (const Leap& leap : map.leaps().leaps(from)) leaps.push_back(leap);
    std::vector<Jump> firsts;
    for (const Leap& leap : leaps) {
      firsts.push_back(leap.first());
      expect_chain(map, from, leap);
      expect_seen(map, leap);
      passed += leap.first() == leap.last() ? 0 : 1;
      dead += leap.dead() ? 1 : 0;
    }
    const std::vector<Jump> next = map.next(from);
    EXPECT_TRUE(std::is_permutation(firsts.begin(), firsts.end(), next.begin(), next.end()));
  });
}

TEST(LeapGraph, LeapsGoWhereThereIsNoChoice) {
  Random random(51);
  int passed = 0;
  int dead = 0;
  for (int map = 0; map < 75 && !::testing::Test::HasFailure(); ++map) {
    SCOPED_TRACE("map " + std::to_string(map));
    expect_right_leaps(random_leap_map(random), passed, dead);
  }
  expect_right_leaps(corridors(41, 33), passed, dead);
  EXPECT_GT(passed, 1000);
  EXPECT_GT(dead, 500);
}

/// Around a block in a narrow room one goes in circles: every jump point has one that comes next.
TEST(LeapGraph, CirclesEndSomewhere) {
  BitGrid cells(9, 9);
  for (int i = 0; i < 9; ++i) {
    for (const Cell cell : {Cell{i, 0}, Cell{i, 8}, Cell{0, i}, Cell{8, i}}) cells.set(cell, true);
  }
  int passed = 0;
  int dead = 0;
  expect_right_leaps(cells, passed, dead);
  EXPECT_GT(passed, 0);
}

/// Longer than a leap can count.
TEST(LeapGraph, AJumpMaySpanTheWholeMap) {
  constexpr int kWidth = 70000;
  BitGrid cells(kWidth, 3);
  for (int x = 0; x < kWidth; ++x) cells.set({x, 1}, true);
  for (const int x : {0, kWidth - 1}) {
    cells.set({x, 0}, true);
    cells.set({x, 2}, true);
  }
  Map map(cells);
  int far = 0;
  map.for_each_jump([&](Jump from) {
    std::vector<Leap> leaps;
    for (const Leap& leap : map.leaps().leaps(from)) leaps.push_back(leap);
    for (const Leap& leap : leaps) {
      expect_chain(map, from, leap);
      if (map.cell(leap.first()).x != map.cell(from).x) ++far;
    }
  });
  EXPECT_GT(far, 0);
}

}  // namespace
}  // namespace wend
