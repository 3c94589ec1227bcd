#include "wend/map/masked.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "conformance/random_edit.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"

namespace wend {
namespace {

/// A map of up to 20 x 20 cells with all states, and costs in some; `frame` as it is.
GridMap random_cells(Random& random, const Frame& frame) {
  const int width = random.between(1, 20);
  const int height = random.between(1, 20);
  const bool costs = random.chance(0.7);
  Grid<CellState> cells(width, height, CellState::free);
  Grid<double> terrain(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (random.chance(0.2)) cells[{x, y}] = CellState::occupied;
      if (random.chance(0.2)) cells[{x, y}] = CellState::unknown;
      if (costs && random.chance(0.5)) terrain[{x, y}] = 1 + 8 * random.uniform();
    }
  }
  return *make_grid_map(cells, frame, terrain);
}

/// Somewhere near (0, 0), turned or not.
Frame random_frame(Random& random) {
  const double heading = random.chance(0.5) ? 0 : 2 * std::numbers::pi * (random.uniform() - 0.5);
  return {.resolution = 0.03 + 0.2 * random.uniform(),
          .origin = {4 * random.uniform() - 2, 4 * random.uniform() - 2, heading},
          .y_up = true,
          .metric = true};
}

/// Whether the middle of a cell of one map lies in a cell of another one, in coordinates of the plane.
bool middle_lies_in(const Frame& one, Cell cell, const Frame& other, Cell square) {
  const auto turned = [](double x, double y, double angle) {
    return Point{x * std::cos(angle) - y * std::sin(angle),
                 x * std::sin(angle) + y * std::cos(angle)};
  };
  const Point local =
      turned((cell.x + 0.5) * one.resolution, (cell.y + 0.5) * one.resolution, one.origin.heading);
  const Point in_metres{one.origin.x + local.x, one.origin.y + local.y};
  const Point there =
      turned(in_metres.x - other.origin.x, in_metres.y - other.origin.y, -other.origin.heading);
  const double x = there.x / other.resolution - square.x;
  const double y = there.y / other.resolution - square.y;
  return x >= 0 && x < 1 && y >= 0 && y < 1;
}

TEST(Masked, RemembersWhatOnlyAMaskBlocks) {
  Grid<CellState> cells(4, 2, CellState::free);
  cells[{1, 0}] = CellState::occupied;
  cells[{2, 0}] = CellState::unknown;
  Grid<CellState> zone(4, 2, CellState::free);
  for (int x = 0; x < 3; ++x) zone[{x, 0}] = CellState::occupied;
  GridMap mask = *make_grid_map(zone);
  mask.add_zone({"zones.yaml", mask.occupied()});
  Grid<CellState> other(4, 2, CellState::free);
  other[{0, 0}] = other[{3, 1}] = CellState::occupied;
  GridMap map = *masked(*masked(*make_grid_map(cells), mask), *make_grid_map(other));
  ASSERT_EQ(map.zones().size(), 2U);
  EXPECT_EQ(map.zone({0, 0})->name, "zones.yaml");
  EXPECT_EQ(map.zone({1, 0}), nullptr) << "the map is blocked there";
  EXPECT_EQ(map.zone({2, 0}), nullptr) << "the map is not free there";
  EXPECT_EQ(map.zone({3, 1})->name, "");
  EXPECT_EQ(map.zone({3, 0}), nullptr);
  ASSERT_TRUE(map.edit({.cells = {{{0, 0}, CellState::occupied}}}));
  EXPECT_EQ(map.zone({0, 0}), nullptr) << "what an edit says is no mask's word";
  Grid<CellState> box(1, 1, CellState::free);
  ASSERT_TRUE(map.edit({.corner = {3, 1}, .states = box}));
  EXPECT_EQ(map.zone({3, 1}), nullptr);
}

struct MaskedCell {
  CellState state;
  double terrain;
};

/// What a cell is under a mask, by comparing it with each cell of the mask; counts those that touch it.
template <class Touches>
MaskedCell masked_by_hand(const GridMap& map, const GridMap& mask, Cell cell,
                          const Touches& touches, int& touching) {
  MaskedCell result{map.state(cell), map.terrain(cell)};
  double factor = 1;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (!touches(cell, Cell{x, y})) continue;
      ++touching;
      if (mask.state({x, y}) == CellState::occupied) result.state = CellState::occupied;
      if (mask.state({x, y}) == CellState::free) factor = std::fmax(factor, mask.terrain({x, y}));
    }
  }
  result.terrain *= factor;
  return result;
}

template <class Touches>
void expect_masked(const GridMap& map, const GridMap& mask, const Touches& touches) {
  const auto made = masked(map, mask);
  int touching = 0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const MaskedCell expected = masked_by_hand(map, mask, {x, y}, touches, touching);
      if (!made) continue;
      ASSERT_EQ(made->state({x, y}), expected.state) << x << "," << y;
      ASSERT_DOUBLE_EQ(made->terrain({x, y}), expected.terrain) << x << "," << y;
    }
  }
  ASSERT_EQ(made.has_value(), touching > 0) << (made ? "" : made.error().message);
  if (!made) return;
  ASSERT_EQ(made->frame(), map.frame());
}

TEST(Masked, TakesTheWorstOfWhatLiesOnACellWhereverTheGridsLie) {
  for (std::uint64_t seed = 0; seed < test::share_of(600U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const GridMap map = random_cells(random, random_frame(random));
    const GridMap mask = random_cells(random, random_frame(random));
    expect_masked(map, mask, [&](Cell cell, Cell square) {
      return middle_lies_in(map.frame(), cell, mask.frame(), square) ||
             middle_lies_in(mask.frame(), square, map.frame(), cell);
    });
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Masked, OnTheSameGridIsCellByCellInSpiteOfRounding) {
  for (std::uint64_t seed = 0; seed < test::share_of(300U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Frame frame = random_frame(random);
    const GridMap map = random_cells(random, frame);
    const int dx = random.between(-5, 5);
    const int dy = random.between(-5, 5);
    Frame shifted = frame;
    const MapPoint corner =
        frame.to_metres(Point{static_cast<double>(dx), static_cast<double>(dy)});
    shifted.origin = {corner.x, corner.y, frame.origin.heading};
    const GridMap mask = random_cells(random, shifted);
    expect_masked(map, mask, [&](Cell cell, Cell square) {
      return cell.x == square.x + dx && cell.y == square.y + dy;
    });
    if (testing::Test::HasFailure()) return;
  }
}

/// The same with a map that is `width` x `height`.
GridMap cells_of_size(Random& random, int width, int height, const Frame& frame) {
  Grid<CellState> cells(width, height, CellState::free);
  Grid<double> terrain(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (random.chance(0.3)) cells[{x, y}] = CellState::occupied;
      terrain[{x, y}] = 1 + random.between(0, 3);
    }
  }
  return *make_grid_map(cells, frame, terrain);
}

TEST(Masked, WithoutResolutionLiesAsItIsDrawn) {
  const Frame cells_down{};
  const Frame metres_up{.resolution = 0.1, .origin = {3, 4, 1}, .y_up = true, .metric = true};
  const Frame metres_down{.resolution = 0.1, .metric = true};
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const int width = random.between(1, 9);
    const int height = random.between(1, 9);
    for (const auto& [one, other] :
         {std::pair(cells_down, cells_down), std::pair(cells_down, metres_up),
          std::pair(metres_up, cells_down), std::pair(metres_up, metres_down)}) {
      const GridMap map = cells_of_size(random, width, height, one);
      const GridMap mask = cells_of_size(random, width, height, other);
      const bool turned_over = one.y_up != other.y_up;
      expect_masked(map, mask, [&](Cell cell, Cell square) {
        return cell.x == square.x && cell.y == (turned_over ? height - 1 - square.y : square.y);
      });
    }
  }
}

TEST(Masked, IsTheSameInAnyOrder) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const GridMap map = cells_of_size(random, 8, 6, {});
    const GridMap one = cells_of_size(random, 8, 6, {});
    const GridMap other = cells_of_size(random, 8, 6, {});
    const GridMap first = *masked(*masked(map, one), other);
    const GridMap second = *masked(*masked(map, other), one);
    EXPECT_EQ(first.occupied(), second.occupied());
    EXPECT_EQ(first.terrain(), second.terrain()) << "whole numbers, so products are exact";
  }
}

TEST(Masked, HoldsEditsToTheMask) {
  int edits = 0;
  for (std::uint64_t seed = 0; seed < test::share_of(400U); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Frame frame = random_frame(random);
    GridMap map = random_cells(random, frame);
    const GridMap mask = random_cells(random, random_frame(random));
    const auto on_grid = mask_on_grid_of(map, mask);
    if (!on_grid) continue;
    GridMap under = *masked(map, mask);
    for (int i = 0; i < 4; ++i) {
      const MapEdit edit = test::random_edit(random, map, true);
      ASSERT_TRUE(under.edit(masked_edit(edit, *on_grid)));
      ASSERT_TRUE(map.edit(edit));
      const GridMap expected = *masked(map, mask);
      ASSERT_EQ(under.occupied(), expected.occupied());
      ASSERT_EQ(under.terrain(), expected.terrain());
      ++edits;
    }
  }
  EXPECT_GT(edits, test::share_of(100));
}

TEST(Masked, BlocksWhatWasUnknownAndKeepsWhatTheMaskDoesNotKnow) {
  const Grid<CellState> states(3, 1, {CellState::unknown, CellState::occupied, CellState::unknown});
  const Grid<CellState> zones(3, 1, {CellState::occupied, CellState::unknown, CellState::unknown});
  const GridMap made = *masked(*make_grid_map(states), *make_grid_map(zones));
  EXPECT_EQ(made.state({0, 0}), CellState::occupied);
  EXPECT_EQ(made.state({1, 0}), CellState::occupied);
  EXPECT_EQ(made.state({2, 0}), CellState::unknown);
}

TEST(Masked, SaysWhyAMaskDoesNotFit) {
  const auto map_of = [](int width, int height, const Frame& frame, double terrain = 1) {
    return *make_grid_map(Grid<CellState>(width, height, CellState::free), frame,
                          Grid<double>(width, height, terrain));
  };
  const Frame up{.resolution = 0.5, .origin = {1, 2, 0}, .y_up = true, .metric = true};
  const Frame far{.resolution = 0.25, .origin = {100, 2, 0}, .y_up = true, .metric = true};
  const Frame down{.resolution = 0.5, .metric = true};
  const auto message = [](const Expected<GridMap, Error>& made) {
    if (made) return std::string();
    EXPECT_EQ(made.error().status, Status::invalid_map);
    return made.error().message;
  };
  EXPECT_EQ(message(masked(map_of(4, 2, up), map_of(8, 8, far))),
            "the mask does not touch the map: the mask covers x from 100 to 102 and y from 2 to 4 "
            "m, the map x from 1 to 3 and y from 2 to 3 m");
  EXPECT_EQ(message(masked(map_of(4, 2, {}), map_of(4, 3, up))),
            "the mask has 4 x 3 cells, the map 4 x 2 cells, and the map has no resolution: the "
            "same size expected");
  EXPECT_EQ(message(masked(map_of(4, 2, up), map_of(4, 3, {}))),
            "the mask has 4 x 3 cells, the map 4 x 2 cells, and the mask has no resolution: the "
            "same size expected");
  EXPECT_EQ(message(masked(map_of(4, 2, up), map_of(5, 2, down))),
            "the mask has 5 x 2 cells, the map 4 x 2 cells, and one has y up, the other y down: "
            "the same size expected");
  EXPECT_NE(message(masked(map_of(1, 1, {}, 1e200), map_of(1, 1, {}, 1e200))).find("finite"),
            std::string::npos);
}

}  // namespace
}  // namespace wend
