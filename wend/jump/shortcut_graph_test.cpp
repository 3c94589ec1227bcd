#include "wend/jump/shortcut_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {
namespace {

using Cost = std::uint64_t;

BitGrid random_shortcut_map(Random& random) {
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

/// The shortcuts of a map and its single jumps.
class Map {
 public:
  explicit Map(const BitGrid& cells)
      : jumps_(std::make_shared<const JumpGraph>(std::make_shared<const JumpBoards>(cells))),
        shortcuts_(jumps_),
        width_(cells.width()),
        height_(cells.height()) {}

  const JumpGraph& jumps() const { return *jumps_; }
  ShortcutGraph& shortcuts() { return shortcuts_; }

  std::vector<Jump> next(Jump jump) const {
    std::vector<Jump> next;
    jumps_->append_jumps(cell(jump), jumps_->directions(jump), next);
    return next;
  }
  Cell cell(Jump jump) const { return jumps_->cell(jump.number()); }

  /// Calls visit(jump) for each jump that a search could reach.
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

  /// Is a cell in sight of a jump point, in a direction in which a path leaves it?
  bool sees(Jump jump, Cell goal) const {
    const Cell from = cell(jump);
    if (goal == from) return true;
    if (!jumps_->boards().passable(goal) || !jumps_->boards().sight().sees(from, goal))
      return false;
    const int right = (goal.x > from.x) - (goal.x < from.x);
    const int down = (goal.y > from.y) - (goal.y < from.y);
    for (unsigned i = 0; i < kDirections; ++i) {
      if (kDirectionSteps[i] == Cell{right, down}) {
        return (jumps_->directions(jump) & set_of(static_cast<Direction>(i))) != 0;
      }
    }
    return false;
  }

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  std::shared_ptr<const JumpGraph> jumps_;
  ShortcutGraph shortcuts_;
  int width_;
  int height_;
};

/// The jump points of a shortcut, its end included.
std::vector<Jump> chain_of(const ShortcutGraph& shortcuts, const Shortcut& shortcut) {
  std::vector<Jump> chain{shortcut.first()};
  while (chain.back() != shortcut.last()) chain.push_back(shortcuts.only_next(chain.back()));
  return chain;
}

/// A shortcut follows single successors, and costs as much as its jumps.
void expect_chain(Map& map, Jump from, const Shortcut& shortcut) {
  const std::vector<Jump> chain = chain_of(map.shortcuts(), shortcut);
  Cost cost = 0;
  Cell at = map.cell(from);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    cost += octile_cost<Cost>(at, map.cell(chain[i]));
    at = map.cell(chain[i]);
    if (i + 1 == chain.size()) break;
    EXPECT_EQ(map.next(chain[i]), std::vector{chain[i + 1]}) << "there is a choice";
  }
  EXPECT_EQ(shortcut.cost<Cost>(map.cell(from), at), cost);
  EXPECT_TRUE(!shortcut.dead() || map.next(shortcut.last()).empty());
}

/// What is seen from a jump point on the way may be seen by the shortcut, or else is seen from the next
/// one too, and its end goes on.
void expect_seen(Map& map, const Shortcut& shortcut) {
  const std::vector<Jump> chain = chain_of(map.shortcuts(), shortcut);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (shortcut.may_see(map.shortcuts().raster().place({x, y}))) continue;
      for (std::size_t i = 0; i < chain.size(); ++i) {
        const bool last = i + 1 == chain.size();
        if (last && !shortcut.dead()) break;
        EXPECT_TRUE(!map.sees(chain[i], {x, y}) || (!last && map.sees(chain[i + 1], {x, y})))
            << "cell " << x << ',' << y << " from jump point " << i << " of " << chain.size();
      }
    }
  }
}

void expect_right_shortcuts(const BitGrid& cells, int& passed, int& dead) {
  Map map(cells);
  map.for_each_jump([&](Jump from) {
    SCOPED_TRACE("jump point " + std::to_string(from.number()) + ", reached in " +
                 std::to_string(from.arrival()));
    std::vector<Shortcut> shortcuts;  // a copy: the checks below request more shortcuts
    for (const Shortcut& shortcut : map.shortcuts().shortcuts(from)) shortcuts.push_back(shortcut);
    std::vector<Jump> firsts;
    for (const Shortcut& shortcut : shortcuts) {
      firsts.push_back(shortcut.first());
      expect_chain(map, from, shortcut);
      expect_seen(map, shortcut);
      passed += shortcut.first() == shortcut.last() ? 0 : 1;
      dead += shortcut.dead() ? 1 : 0;
    }
    const std::vector<Jump> next = map.next(from);
    EXPECT_TRUE(std::is_permutation(firsts.begin(), firsts.end(), next.begin(), next.end()));
  });
}

TEST(ShortcutGraph, ShortcutsGoWhereThereIsNoChoice) {
  Random random(51);
  int passed = 0;
  int dead = 0;
  for (int map = 0; map < test::share_of(75) && !::testing::Test::HasFailure(); ++map) {
    SCOPED_TRACE("map " + std::to_string(map));
    expect_right_shortcuts(random_shortcut_map(random), passed, dead);
  }
  expect_right_shortcuts(corridors(41, 33), passed, dead);
  EXPECT_GT(passed, test::share_of(1000));
  EXPECT_GT(dead, test::share_of(500));
}

/// Paths around a block in a narrow room are cyclic: every jump point has one successor.
TEST(ShortcutGraph, CirclesEndSomewhere) {
  BitGrid cells(9, 9);
  for (int i = 0; i < 9; ++i) {
    for (const Cell cell : {Cell{i, 0}, Cell{i, 8}, Cell{0, i}, Cell{8, i}}) cells.set(cell, true);
  }
  int passed = 0;
  int dead = 0;
  expect_right_shortcuts(cells, passed, dead);
  EXPECT_GT(passed, 0);
}

/// Longer than a shortcut can count.
TEST(ShortcutGraph, AJumpMaySpanTheWholeMap) {
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
    std::vector<Shortcut> shortcuts;
    for (const Shortcut& shortcut : map.shortcuts().shortcuts(from)) shortcuts.push_back(shortcut);
    for (const Shortcut& shortcut : shortcuts) {
      expect_chain(map, from, shortcut);
      if (map.cell(shortcut.first()).x != map.cell(from).x) ++far;
    }
  });
  EXPECT_GT(far, 0);
}

}  // namespace
}  // namespace wend
