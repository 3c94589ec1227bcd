// After edits of a map, boards, jump graph and shortcuts are those that are made of the edited map.

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/jump/jump_sources.hpp"
#include "wend/jump/shortcut_graph.hpp"

namespace wend {
namespace {

/// Noise of any density, or rooms with doors, so that runs and diagonals are long as well as short.
BitGrid map_to_edit(Random& random, int widest, int highest) {
  BitGrid cells(random.between(1, widest), random.between(1, highest));
  const int blocked_in = random.between(2, 60);
  const int room = random.chance(0.5) ? random.between(3, 20) : 1000;
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      const bool wall = (x % room == room - 1 || y % room == room - 1) && !random.chance(0.1);
      cells.set({x, y}, !wall && random.between(1, blocked_in) > 1);
    }
  }
  return cells;
}

/// Toggles cells of a box somewhere: all of a small one, some of a larger one.
CellBox edit(Random& random, BitGrid& cells) {
  const int side = random.chance(0.7) ? 1 : random.between(1, 6);
  const Cell begin{random.between(0, cells.width() - 1), random.between(0, cells.height() - 1)};
  const CellBox box =
      CellBox{begin, {begin.x + side, begin.y + random.between(1, side)}}.clipped_to(cells);
  for (int y = box.begin.y; y < box.end.y; ++y) {
    for (int x = box.begin.x; x < box.end.x; ++x) {
      if (side == 1 || random.chance(0.5)) cells.set({x, y}, !cells[{x, y}]);
    }
  }
  return box;
}

std::vector<CellBox> some_edits(Random& random, BitGrid& cells) {
  std::vector<CellBox> boxes;
  const int count = random.chance(0.7) ? 1 : random.between(1, 4);
  for (int i = 0; i < count; ++i) boxes.push_back(edit(random, cells));
  return boxes;
}

TEST(JumpBoards, RepairedAfterEditsEqualThoseOfTheEditedMap) {
  constexpr std::uint64_t kSeed = 41;
  Random random(kSeed);
  for (int map = 0; map < test::share_of(300); ++map) {
    BitGrid cells = map_to_edit(random, map % 4 == 0 ? 150 : 24, 24);
    JumpBoards boards(cells);
    for (int i = 0; i < 12; ++i) {
      const std::vector<CellBox> boxes = some_edits(random, cells);
      boards.repair(cells, boxes);
      ASSERT_EQ(boards, JumpBoards(cells)) << "seed " << kSeed << ", map " << map << ", edit " << i;
    }
  }
}

/// A shortcut without the numbers of jump points, which depend on the edits.
struct PlainShortcut {
  Cell first;
  unsigned first_arrival;
  Cell last;
  unsigned last_arrival;
  std::uint32_t cost;
  bool dead;
  std::vector<bool> seen;  // some places

  friend bool operator==(const PlainShortcut&, const PlainShortcut&) = default;
};

std::vector<PlainShortcut> shortcuts_from(ShortcutGraph& graph, Cell cell, unsigned arrival,
                                          std::span<const CoarsePlace> places) {
  const JumpGraph& jumps = graph.jumps();
  std::vector<PlainShortcut> found;
  for (const Shortcut& each : graph.shortcuts(Jump(jumps.number_of(cell), arrival))) {
    const Cell last = jumps.cell(each.last().number());
    found.push_back({jumps.cell(each.first().number()),
                     each.first().arrival(),
                     last,
                     each.last().arrival(),
                     each.cost<std::uint32_t>(cell, last),
                     each.dead(),
                     {}});
    for (const CoarsePlace place : places) found.back().seen.push_back(each.may_see(place));
  }
  return found;
}

/// A map that is edited, and what is repaired.
struct Edited {
  explicit Edited(const BitGrid& cells)
      : boards(std::make_shared<JumpBoards>(cells)),
        graph(std::make_shared<JumpGraph>(boards)),
        shortcuts(graph) {}

  void repair(const BitGrid& cells, std::span<const CellBox> boxes) {
    boards->repair(cells, boxes);
    graph->repair(boxes);
    JumpSources sources(*graph, 1'000'000);
    ASSERT_TRUE(sources.find(boxes));
    shortcuts.repair(boxes, sources.jumps());
  }

  std::shared_ptr<JumpBoards> boards;
  std::shared_ptr<JumpGraph> graph;
  ShortcutGraph shortcuts;
};

void expect_equal_shortcuts(Edited& edited, const BitGrid& cells, Random& random, double share) {
  ShortcutGraph fresh(std::make_shared<JumpGraph>(std::make_shared<const JumpBoards>(cells)));
  std::vector<CoarsePlace> places;
  for (int i = 0; i < 4; ++i) {
    const int x = random.between(0, cells.width() - 1);
    places.push_back(fresh.raster().place(Cell{x, random.between(0, cells.height() - 1)}));
  }
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      ASSERT_EQ(edited.graph->is_jump_point({x, y}), fresh.jumps().is_jump_point({x, y}));
      if (!fresh.jumps().is_jump_point({x, y})) continue;
      for (unsigned arrival = 0; arrival < kArrivals; ++arrival) {
        if (!random.chance(share)) continue;
        ASSERT_EQ(shortcuts_from(edited.shortcuts, {x, y}, arrival, places),
                  shortcuts_from(fresh, {x, y}, arrival, places))
            << "from (" << x << ',' << y << "), arrival " << arrival;
      }
    }
  }
}

/// Some shortcuts are known before an edit, and some are not.
TEST(ShortcutGraph, RepairedAfterEditsGivesTheShortcutsOfTheEditedMap) {
  constexpr std::uint64_t kSeed = 42;
  Random random(kSeed);
  for (int map = 0; map < test::share_of(240); ++map) {
    BitGrid cells = map_to_edit(random, map % 4 == 0 ? 150 : 30, 30);
    Edited edited(cells);
    const double share = random.chance(0.5) ? 1 : 0.3;
    for (int i = 0; i < 12; ++i) {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", map " + std::to_string(map) + ", edit " +
                   std::to_string(i));
      edited.repair(cells, some_edits(random, cells));
      if (HasFatalFailure()) return;
      expect_equal_shortcuts(edited, cells, random, share);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(ShortcutGraph, KnowsNothingAfterItHasForgotten) {
  Random random(43);
  BitGrid cells = map_to_edit(random, 60, 60);
  Edited edited(cells);
  expect_equal_shortcuts(edited, cells, random, 1);
  edited.shortcuts.forget();
  expect_equal_shortcuts(edited, cells, random, 1);
}

/// A cell that is blocked and freed again and again needs no new numbers.
TEST(JumpGraph, KeepsTheNumbersOfJumpPointsThatComeBack) {
  Random random(44);
  BitGrid cells = map_to_edit(random, 60, 60);
  const Cell cell{cells.width() / 2, cells.height() / 2};
  Edited edited(cells);
  std::size_t size = 0;
  for (int i = 0; i < 20; ++i) {
    cells.set(cell, !cells[cell]);
    edited.repair(cells, std::array{CellBox{cell, {cell.x + 1, cell.y + 1}}});
    if (i == 2) size = edited.graph->size();
  }
  EXPECT_EQ(edited.graph->size(), size);
}

TEST(JumpSources, GivesUpWhereMuchOfTheMapSeesTheEdit) {
  BitGrid cells(1500, 1500);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) cells.set({x, y}, x != 20);
  }
  const JumpGraph graph(std::make_shared<const JumpBoards>(cells));
  constexpr std::size_t kSteps = 100'000;
  JumpSources far(graph, kSteps);
  EXPECT_FALSE(far.find(std::array{CellBox{{700, 700}, {701, 701}}}));
  JumpSources sources(graph, kSteps);
  EXPECT_TRUE(sources.find(std::array{CellBox{{10, 10}, {11, 11}}}));
  EXPECT_TRUE(sources.jumps().empty()) << "the map has no jump point";
}

}  // namespace
}  // namespace wend
