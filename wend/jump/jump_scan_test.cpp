// Scans find the jumps that JumpGraph finds on JumpBoards, in the same order, and see what Sight sees.

#include "wend/jump/jump_scan.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/jump/jump_graph.hpp"

namespace wend {
namespace {

/// A map in which runs of all lengths occur: `blocked_in` is how many cells there are to a blocked one.
BitGrid random_cells(Random& random, int widest, int highest) {
  const int width = random.between(1, widest);
  const int height = random.between(1, highest);
  const int blocked_in = random.between(2, 400);
  BitGrid cells(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) cells.set({x, y}, random.between(1, blocked_in) > 1);
  }
  return cells;
}

std::vector<ScannedJump> jumps_of(const JumpGraph& graph, Cell from, DirectionSet directions) {
  std::vector<ScannedJump> jumps;
  graph.visit_jumps(from, directions, [&](Jump jump) {
    jumps.push_back({graph.cell(jump.number()), jump.arrival()});
    return true;
  });
  return jumps;
}

std::vector<ScannedJump> jumps_of(JumpScan& scan, Cell from, DirectionSet directions) {
  std::vector<ScannedJump> jumps;
  scan.visit_jumps(from, directions, [&](const ScannedJump& jump) {
    jumps.push_back(jump);
    return true;
  });
  return jumps;
}

std::string text_of(Cell cell) {
  return "(" + std::to_string(cell.x) + ',' + std::to_string(cell.y) + ")";
}

/// Compares both in all directions from a cell, and how paths leave the jump points that they find.
void expect_equal_jumps(const JumpGraph& graph, JumpScan& scan, Cell from) {
  for (int i = 0; i < kDirections; ++i) {
    const DirectionSet set = set_of(static_cast<Direction>(i));
    const auto expected = jumps_of(graph, from, set);
    ASSERT_EQ(jumps_of(scan, from, set), expected)
        << "from " << text_of(from) << ", direction " << i;
  }
  const auto all = jumps_of(graph, from, 0xFF);
  ASSERT_EQ(jumps_of(scan, from, 0xFF), all) << "from " << text_of(from);
  graph.visit_jumps(from, 0xFF, [&](Jump jump) {
    const ScannedJump scanned{graph.cell(jump.number()), jump.arrival()};
    EXPECT_EQ(scan.directions(scanned), graph.directions(jump)) << "at " << text_of(scanned.cell);
    return true;
  });
}

TEST(JumpScan, FindsTheJumpsOfTheGraphInItsOrder) {
  constexpr std::uint64_t kSeed = 5;
  Random random(kSeed);
  for (int map = 0; map < 60; ++map) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", map " + std::to_string(map));
    const BitGrid cells = random_cells(random, 210, 210);
    const JumpGraph graph(std::make_shared<const JumpBoards>(cells));
    JumpScan scan(cells);
    for (int i = 0; i < 200; ++i) {
      const int x = random.between(0, cells.width() - 1);
      const int y = random.between(0, cells.height() - 1);
      if (!cells[{x, y}]) continue;
      expect_equal_jumps(graph, scan, {x, y});
      if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
  }
}

TEST(JumpScan, FindsTheJumpsOfEveryCellOfSmallMaps) {
  constexpr std::uint64_t kSeed = 6;
  Random random(kSeed);
  for (int map = 0; map < 300; ++map) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", map " + std::to_string(map));
    BitGrid cells = random_cells(random, 70, 9);
    if (map % 2 == 1) cells = random_cells(random, 9, 70);
    const JumpGraph graph(std::make_shared<const JumpBoards>(cells));
    JumpScan scan(cells);
    for (int y = 0; y < cells.height(); ++y) {
      for (int x = 0; x < cells.width(); ++x) {
        if (cells[{x, y}]) expect_equal_jumps(graph, scan, {x, y});
      }
    }
    if (HasFatalFailure() || HasNonfatalFailure()) return;
  }
}

TEST(JumpScan, StopsWhenItsVisitorHasEnough) {
  BitGrid cells(9, 9);
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 9; ++x) cells.set({x, y}, x != 4 || y < 2 || y > 6);
  }
  JumpScan scan(cells);
  const auto all = jumps_of(scan, {0, 4}, 0xFF);
  ASSERT_GE(all.size(), 2U);
  int visited = 0;
  scan.visit_jumps({0, 4}, 0xFF, [&](const ScannedJump& jump) {
    EXPECT_EQ(jump, all.front());
    ++visited;
    return false;
  });
  EXPECT_EQ(visited, 1);
}

TEST(JumpScan, SeesWhatSightSees) {
  constexpr std::uint64_t kSeed = 7;
  Random random(kSeed);
  std::size_t seen = 0;
  for (int map = 0; map < 80; ++map) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", map " + std::to_string(map));
    const BitGrid cells = random_cells(random, 210, 210);
    const JumpBoards boards(cells);
    const Sight& sight = boards.sight();
    JumpScan scan(cells);
    for (int i = 0; i < 300; ++i) {
      const Cell from{random.between(0, cells.width() - 1), random.between(0, cells.height() - 1)};
      const int x = random.between(0, cells.width() - 1);
      const int y = random.between(0, cells.height() - 1);
      if (!cells[from]) continue;
      const bool expected = sight.sees(from, {x, y});
      ASSERT_EQ(scan.sees(from, {x, y}), expected) << text_of(from) << " to " << text_of({x, y});
      if (!expected) continue;
      ++seen;
      ASSERT_EQ(scan.passes_jump(from, {x, y}), boards.passes_jump(from, {x, y}))
          << text_of(from) << " to " << text_of({x, y});
    }
  }
  EXPECT_GT(seen, 1000U) << "or it proves little";
}

TEST(ColumnTiles, HoldTheCellsOfTheGrid) {
  constexpr std::uint64_t kSeed = 8;
  Random random(kSeed);
  for (int map = 0; map < 20; ++map) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", map " + std::to_string(map));
    const BitGrid cells = random_cells(random, 300, 300);
    ColumnTiles columns(cells);
    for (int i = 0; i < 500; ++i) {
      const int x = random.between(0, cells.width() - 1);
      const int y = random.between(0, cells.height() - 1);
      columns.prepare({x, y});
      for (const Cell near : {Cell{x, y}, Cell{x - 1, y + 1}, Cell{x + 1, y - 1}}) {
        const int bit = near.y + 1;
        const bool free = (columns.line(near.x)[bit / 64] >> (bit % 64) & 1U) != 0;
        ASSERT_EQ(free, cells[near]) << text_of(near);
      }
    }
  }
}

}  // namespace
}  // namespace wend
